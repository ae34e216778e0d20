# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab scripts (.mlx) that run unchanged in meshlabserver 2020.09 and in pymeshlab.

The old server aborts unless a script has every parameter, and enumerations carry their texts.
"""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from typing import Any

from meshlab_developable import materials
from meshlab_developable.filters import Filter
from meshlab_developable.parameters import converted


def script_text(applied: Filter, values: Mapping[str, Any] | None = None) -> str:
    """A script that applies a filter: with these values, the others at their defaults.

    Raises InvalidParameterError for a name or a value that the filter has not.
    """
    chosen = materials.as_numbers(applied.checked(values or {}))
    root = ElementTree.Element("FilterScript")
    element = ElementTree.SubElement(root, "filter", name=applied.title)
    for parameter in applied.parameters:
        value = chosen.get(parameter.name, parameter.default)
        attributes = {"name": parameter.name, "type": parameter.kind.script_type}
        attributes |= converted(parameter.name, value, parameter.kind.script_attributes)
        ElementTree.SubElement(element, "Param", attributes)
    ElementTree.indent(root, " ")
    text = ElementTree.tostring(root, encoding="unicode").replace(" />", "/>")
    return f"<!DOCTYPE FilterScript>\n{text}\n"
