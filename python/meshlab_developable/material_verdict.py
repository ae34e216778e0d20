# SPDX-License-Identifier: GPL-3.0-or-later
"""What a material would say of a shape, in the words of the log of Global Developability."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any, TypeVar

from meshlab_developable.materials import BOUNDS, DIRECTIONS, Entry, chosen_entry
from meshlab_developable.reports import OptimizationReport, PanelReport, PanelStrain

_Report = TypeVar("_Report", bound=OptimizationReport)
_MOST_PANELS = 5  # that a verdict names
_TOLERANCE = 0.01  # per cent, by which a strain beyond its bound counts as within it


def judged(report: _Report, parameters: Mapping[str, Any]) -> _Report:
    """The report with what the material of the parameters, checked ones of the filter, would say."""
    return dataclasses.replace(report, material_verdict=material_verdict(parameters, report.panels))


def material_verdict(parameters: Mapping[str, Any], panels: Sequence[PanelReport]) -> str:
    """Whether every panel is within its bounds, or which is beyond them, where and by how much.

    parameters: checked ones of the filter. Empty where nothing is allowed, or no strains were measured.
    """
    bounds = _bounds(parameters)
    strains = {panel.index: panel.strain for panel in panels if panel.strain is not None}
    if not strains or not any(any(values) for values in bounds.values()):
        return ""
    allowed = " and ".join(f"{_in_words(values)} {name}" for name, values in bounds.items())
    beyond = sorted(
        (index for index, strain in strains.items() if strain.beyond_bounds > 0),
        key=lambda index: -strains[index].beyond_bounds,
    )
    if beyond:
        count = "1 panel is" if len(beyond) == 1 else f"{len(beyond)} panels are"
        named = ", ".join(
            f"panel {index} by {strains[index].beyond_bounds:.3g} % at {_point(strains[index])}"
            for index in beyond[:_MOST_PANELS]
        )
        others = ", and others by less" if len(beyond) > _MOST_PANELS else ""
        said = f"{count} beyond {allowed}: {named}{others}"
    else:
        said = f"every panel is within its {allowed}"
    return f"{_material(parameters)}: {said}; largest {_largest(bounds, list(strains.values()))}"


def _bounds(parameters: Mapping[str, Any]) -> dict[str, list[float]]:
    """Per cent, of each sign: one number, or those of warp, weft and bias."""
    entry = chosen_entry(parameters.get("material"))
    asked = {key: float(parameters.get(f"allowed_{key}", -1.0)) for key in BOUNDS}
    bounds = {}
    for key, value in asked.items():
        own = entry.get(key, 0.0) if value < 0 else value
        of_directions = [own[name] for name in DIRECTIONS] if isinstance(own, Mapping) else [own] * 3
        bounds[key] = of_directions if len(set(of_directions)) > 1 else of_directions[:1]
    return bounds


def _in_words(values: Sequence[float]) -> str:
    if len(values) == 1:
        return f"{values[0]:.3g} %"
    return ", ".join(f"{value:.3g} % ({name})" for value, name in zip(values, DIRECTIONS, strict=True))


def _material(parameters: Mapping[str, Any]) -> str:
    """By the thickness that was asked for, in the mesh's unit, or that of the table."""
    entry: Entry = chosen_entry(parameters.get("material"))
    name = str(entry.get("name", "Custom"))
    asked = parameters.get("thickness", 0)
    if isinstance(asked, str):
        return f"{name}, {asked} of the diagonal thick"
    if asked > 0:
        return f"{name}, {asked:.3g} thick"
    thickness = entry.get("thickness", 0)
    return f"{name}, {thickness:.3g} mm" if thickness > 0 else name


def _largest(bounds: Mapping[str, Sequence[float]], strains: Sequence[PanelStrain]) -> str:
    """Bounds that differ with the direction say nothing of others than these."""
    largest = max(strains, key=_greatest)
    sign = "compression" if largest.max_stretch < largest.max_compression else "stretch"
    between = largest.beyond_bounds == 0 and _greatest(largest) > max(bounds[sign]) + _TOLERANCE
    where = "between its directions at" if between else "at"
    return f"{_greatest(largest):.3g} % {where} {_point(largest)}"


def _greatest(strain: PanelStrain) -> float:
    return max(strain.max_stretch, strain.max_compression)


def _point(strain: PanelStrain) -> str:
    return "({:.4g}, {:.4g}, {:.4g})".format(*strain.at)
