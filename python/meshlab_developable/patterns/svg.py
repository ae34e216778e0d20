# SPDX-License-Identifier: GPL-3.0-or-later
"""A sheet as SVG in true millimetres: one group a piece, one path a line."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from pathlib import Path as FilePath

from meshlab_developable.mesh_sets import Array
from meshlab_developable.patterns.drawing import Drawing, Layer, Path
from meshlab_developable.patterns.options import Size
from meshlab_developable.patterns.style import CAPITALS, STROKES, TEXT_COLOUR


def write_svg(file: FilePath, title: str, size: Size, drawings: Sequence[Drawing]) -> None:
    """Write a sheet of that size, mm."""
    width, height = size
    ElementTree.register_namespace("", "http://www.w3.org/2000/svg")
    root = ElementTree.Element(
        "{http://www.w3.org/2000/svg}svg",
        {
            "width": f"{width:.4f}mm",
            "height": f"{height:.4f}mm",
            "viewBox": f"0 0 {width:.4f} {height:.4f}",
            "version": "1.1",
        },
    )
    ElementTree.SubElement(root, "title").text = title
    for drawing in drawings:
        _add_drawing(root, drawing, height)
    ElementTree.indent(root)
    ElementTree.ElementTree(root).write(file, encoding="utf-8", xml_declaration=True)


def _add_drawing(root: ElementTree.Element, drawing: Drawing, height: float) -> None:
    group = ElementTree.SubElement(root, "g", {"id": drawing.name.replace(" ", "_"), "fill": "none"})
    ElementTree.SubElement(group, "title").text = drawing.name
    for path in drawing.paths:
        _add_path(group, path, height)
    for notch in drawing.notches:
        line = ElementTree.SubElement(group, "path", _stroke(Layer.NOTCH))
        start, end = (_point(point, height) for point in (notch.on_boundary, notch.end))
        line.set("d", f"M {start} L {end}")
    for text in drawing.texts:
        x, y = text.centre
        element = ElementTree.SubElement(
            group,
            "text",
            {
                "class": Layer.TEXT.name.lower(),
                "x": f"{x:.3f}",
                "y": f"{height - y + text.height / 2:.3f}",
                "font-size": f"{text.height / CAPITALS:.3f}",
                "font-family": "Helvetica, Arial, sans-serif",
                "text-anchor": "middle",
                "fill": TEXT_COLOUR,
            },
        )
        element.text = text.content


def _add_path(group: ElementTree.Element, path: Path, height: float) -> None:
    start, *others = (_point(point, height) for point in path.points)
    element = ElementTree.SubElement(group, "path", _stroke(path.layer))
    end = " Z" if path.closed else ""
    if not path.curves:
        element.set("d", f"M {start} L {' '.join(others)}{end}")
        return
    start = _point(path.curves[0][0], height)
    steps = " ".join("C " + " ".join(_point(point, height) for point in curve[1:]) for curve in path.curves)
    element.set("d", f"M {start} {steps}{end}")


def _stroke(layer: Layer) -> dict[str, str]:
    stroke = STROKES[layer]
    attributes = {
        "class": layer.name.lower().replace("_", "-"),
        "stroke": stroke.colour,
        "stroke-width": f"{stroke.width:g}",
        "stroke-linejoin": "round",
    }
    if stroke.dashes:
        attributes["stroke-dasharray"] = " ".join(f"{dash:g}" for dash in stroke.dashes)
    return attributes


def _point(point: Array, height: float) -> str:
    return f"{point[0]:.4f},{height - point[1]:.4f}"
