# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab scripts (.mlx), made from those in meshes/scripts/ with some values changed."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

SCRIPTS = Path(__file__).resolve().parents[2] / "meshes" / "scripts"
GLOBAL, LOCAL, MAPS = "global_developability", "local_developability", "developability_maps"


def filter_element(name: str, **values: Any) -> ElementTree.Element:
    """A filter of ours as it stands in its script, with these values; enumerations take their text too."""
    element = ElementTree.parse(SCRIPTS / f"{name}.mlx").getroot().find("filter")
    parameters = {parameter.get("name"): parameter for parameter in element}
    for key, value in values.items():
        parameters[key].set("value", _as_text(parameters[key], value))
    return element


def host_filter(name: str, *parameters: tuple[str, str, str]) -> ElementTree.Element:
    """A filter of the host's own: its parameters are name, type and value."""
    element = ElementTree.Element("filter", name=name)
    for key, kind, value in parameters:
        ElementTree.SubElement(element, "Param", name=key, type=kind, value=value)
    return element


def spoiled_vertex(vertex: int) -> ElementTree.Element:
    """A filter that makes a coordinate no number: the server drops such vertices when it loads them."""
    return host_filter(
        "Per Vertex Geometric Function",
        ("x", "RichString", f"(vi == {vertex}) ? sqrt(-1) : x"),
        ("y", "RichString", "y"),
        ("z", "RichString", "z"),
        ("onselected", "RichBool", "false"),
    )


def write_script(path: Path, *filters: ElementTree.Element) -> Path:
    """A script that runs the filters one after the other."""
    root = ElementTree.Element("FilterScript")
    root.extend(filters)
    path.write_text("<!DOCTYPE FilterScript>\n" + ElementTree.tostring(root, encoding="unicode"))
    return path


def _as_text(parameter: ElementTree.Element, value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if parameter.get("type") == "RichEnum" and isinstance(value, str):
        choices = [parameter.get(f"enum_val{i}") for i in range(int(parameter.get("enum_cardinality")))]
        return str(choices.index(value))
    return repr(value)
