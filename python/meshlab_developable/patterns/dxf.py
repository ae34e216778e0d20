# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces as DXF for garment CAD, as ASTM D6673 and AAMA have it: one block a piece, layers by number.

Written by ezdxf's exporter for that standard: DXF R12 whose blocks are the pieces and nothing else.
"""

from __future__ import annotations

import datetime
from collections.abc import Sequence
from pathlib import Path as FilePath
from typing import Any

import numpy as np
from ezdxf.addons import gerber_D6673
from ezdxf.document import Drawing as Document
from ezdxf.enums import TextEntityAlignment

from meshlab_developable.mesh_sets import Array
from meshlab_developable.patterns.drawing import Drawing, Layer, Motion

# Each polyline on one of these layers is there once more, to validate what a program makes of its points:
# ASTM D6673 demands it, of straight lines too.
CHECKS = {
    Layer.BOUNDARY: Layer.BOUNDARY_CHECK,
    Layer.INTERNAL: Layer.INTERNAL_CHECK,
    Layer.CUTOUT: Layer.CUTOUT_CHECK,
    Layer.SEW: Layer.SEW_CHECK,
}
TURN = np.radians(20)  # a line that bends more at a point turns there, else it curves


def write_dxf(file: FilePath, title: str, drawings: Sequence[Drawing], motions: Sequence[Motion]) -> None:
    """Write each drawing as a block in its own frame, inserted by its motion. Millimetres."""
    document = Document.new("R12")
    for layer in Layer:
        document.layers.add(str(layer.value))
    space = document.modelspace()
    names = block_names([drawing.name for drawing in drawings])
    for name, drawing, motion in zip(names, drawings, motions, strict=True):
        block = document.blocks.new(name)
        _fill(block, drawing)
        attributes = {"layer": str(Layer.BOUNDARY.value), "rotation": motion.angle}
        space.add_blockref(name, motion.shift, dxfattribs=attributes)
    now = datetime.datetime.now(tz=datetime.UTC)
    _system_texts(
        space,
        (
            "ASTM/D13Proposal 1 Version: D6673-10",
            f"Creation Date: {now:%d-%m-%Y}",
            f"Creation Time: {now:%H:%M}",
            f"Style Name: {title}",
            "Sample Size: 1",
            "Grading Rule Table: NONE",
            "Units: METRIC",
        ),
        np.zeros(2),
        4.0,
    )
    gerber_D6673.export_file(document, str(file))


def block_names(pieces: Sequence[str]) -> list[str]:
    """The pieces' names as DXF R12 allows them: capitals, digits, - and _, at most 31, each but once."""
    names: list[str] = []
    for number, piece in enumerate(pieces):
        letters = "".join(
            letter if letter.isascii() and (letter.isalnum() or letter == "-") else "_"
            for letter in piece.upper()
        )
        names.append(
            letters if len(letters) <= 31 and letters not in names else f"{letters[:20]}_{number + 1}"
        )
    return names


def _fill(block: Any, drawing: Drawing) -> None:
    name, quantity = drawing.texts[:2]
    _system_texts(
        block,
        (
            f"Piece Name: {drawing.name}",
            "Size: 1",
            f"Quantity: {drawing.quantity.like},{drawing.quantity.mirrored}",
        ),
        np.array([name.centre[0] - 1.5 * name.height, quantity.centre[1] - quantity.height / 2]),
        name.height / 3,
    )
    for path in drawing.paths:
        layer = {"layer": str(path.layer.value)}
        if path.layer in (Layer.GRAIN, Layer.MIRROR):  # one line, without its arrowhead
            block.add_line(*path.points[:2].tolist(), dxfattribs=layer)
            continue
        block.add_polyline2d(path.points.tolist(), close=path.closed, dxfattribs=layer)
        if path.layer in CHECKS:
            check = {"layer": str(CHECKS[path.layer].value)}
            block.add_polyline2d(path.points.tolist(), close=path.closed, dxfattribs=check)
        for point, turns in zip(path.points, _turns(path.points, path.closed), strict=True):
            kind = Layer.TURN_POINTS if turns else Layer.CURVE_POINTS
            block.add_point(point.tolist(), dxfattribs={"layer": str(kind.value)})
    for notch in drawing.notches:
        attributes = {"layer": str(Layer.NOTCH.value), "thickness": notch.depth, "angle": notch.angle}
        block.add_point(notch.on_boundary.tolist(), dxfattribs=attributes)
    for text in drawing.texts:
        _add_text(block, text.content, text.centre, text.height, Layer.TEXT)


def _turns(ring: Array, closed: bool) -> Array:
    """Whether a line turns at its points rather than curves; an open one does at its ends."""
    incoming, outgoing = ring - np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0) - ring
    cross = incoming[:, 0] * outgoing[:, 1] - incoming[:, 1] * outgoing[:, 0]
    angles = np.arctan2(cross, np.einsum("ij,ij->i", incoming, outgoing))
    turns: Array = abs(angles) > TURN
    if not closed:
        turns[[0, -1]] = True
    return turns


def _system_texts(block: Any, lines: Sequence[str], at: Array, height: float) -> None:
    """What programs read, one below the other."""
    for row, line in enumerate(lines):
        place = at - (0.0, 2 * height * (row + 1))
        _add_text(block, line, place, height, Layer.BOUNDARY, centred=False)


def _add_text(block: Any, content: str, at: Array, height: float, layer: Layer, centred: bool = True) -> None:
    text = block.add_text(content, height=height, dxfattribs={"layer": str(layer.value)})
    text.set_placement(
        at.tolist(), align=TextEntityAlignment.MIDDLE_CENTER if centred else TextEntityAlignment.LEFT
    )
