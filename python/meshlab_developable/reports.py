# SPDX-License-Identifier: GPL-3.0-or-later
"""What the filters report, typed. Field names are the keys of the filters' results."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any, Self

from meshlab_developable.description import STRAIN_LEFT, WARNINGS, Reason, Status

__all__ = [
    "LocalReport",
    "Measures",
    "OptimizationReport",
    "PanelReport",
    "PanelStrain",
    "PatternReport",
    "Status",
]


DEVELOPABLE = (Status.CONVERGED, Status.NOTHING_TO_DO)


@dataclasses.dataclass(frozen=True)
class _Report:
    @classmethod
    def from_values(cls, values: Mapping[str, Any]) -> Self:
        """From the dictionary that the filter returned, which must have every key."""
        needed = (field for field in dataclasses.fields(cls) if field.default is dataclasses.MISSING)
        return cls(**{field.name: values[field.name] for field in needed})


@dataclasses.dataclass(frozen=True)
class Measures(_Report):
    """How developable a mesh is."""

    patches: int
    assembling_vertices: int  # places where patches meet
    interior_vertices: int  # vertex copies
    developability: float  # D, Eq. 2: share of the area, 0 to 1
    detect_function: float  # G, Eq. 4, rad²
    max_angle_defect: float  # rad
    total_absolute_curvature: float  # C, rad


# Why a panel that was cut has its longest seam.
SEAM_REASONS = (
    Reason.SEAM_TOO_FAR,
    Reason.SEAM_OVERLAPS,
    Reason.SEAM_NO_SHEET,
    Reason.SEAM_BEYOND_BOUNDS,
    Reason.SEAM_SEWN,
    Reason.SEAM_STILL,
    Reason.SEAM_CRUMPLES,
)


@dataclasses.dataclass(frozen=True)
class PanelStrain:
    """How the material of one panel is strained from its pattern to its shape."""

    max_stretch: float  # per cent, of its faces
    max_compression: float
    beyond_bounds: float  # by how many per cent of strain a face is beyond its bound, at most; 0: none is
    at: tuple[float, float, float]  # where that is, or the greatest strain


@dataclasses.dataclass(frozen=True)
class PanelReport:
    """What an optimisation did to one panel. Lengths are in the mesh's unit."""

    index: int  # from 0, as the face attribute `panel` has it
    faces: int
    status: Status
    reason: str  # why it ended so; of a cut: why it has its longest seam
    curvature_before: float  # C, rad
    curvature_after: float
    max_angle_defect: float  # rad
    mean_displacement: float
    max_displacement: float
    worst_point: tuple[
        float, float, float
    ]  # where the angle defect is largest, or the border overlaps itself most
    nearest_developable: float  # how far the nearest developable shape found moves a vertex, where too far; 0
    border_overlaps: int  # border vertices where it overlaps itself when flat, though the curvature is gone
    strain: PanelStrain | None = None  # None where it was not measured

    @classmethod
    def from_values(cls, values: Mapping[str, Any]) -> Self:
        """From what the attributes of its faces say, by the fields' names; status and reason are numbers."""
        worst = dict(zip(("worst_x", "worst_y", "worst_z"), values["worst_point"], strict=True))
        one = {"patches": 1, "patches_needing_cut": 1}  # in the words of reports of all panels
        words = {"status": Status(values["status"]), "reason": _reason_in_words({**values, **worst, **one})}
        fields = {field.name for field in dataclasses.fields(cls)}
        return cls(**{name: value for name, value in {**values, **words}.items() if name in fields})


@dataclasses.dataclass(frozen=True)
class OptimizationReport(_Report):
    """What an optimisation did. Lengths are in the mesh's unit."""

    patches: int
    assembling_vertices: int  # places where patches meet
    interior_vertices: int  # vertex copies
    developability_before: float  # D, Eq. 2: share of the area, 0 to 1
    developability_after: float
    detect_function_before: float  # G, Eq. 4, rad²
    detect_function_after: float
    max_angle_defect_before: float  # rad
    max_angle_defect_after: float
    total_absolute_curvature_before: float  # C, rad
    total_absolute_curvature_after: float
    total_absolute_curvature_before_rounding: float
    deformation_energy: float  # E, Eq. 7, length²
    max_displacement: float
    max_displacement_per_cent: float  # of the diagonal of its part: what shares vertices or is sewn together
    mean_displacement: float
    max_distance: float  # to the original surface
    panels_converged: int
    panels_need_cut: int
    iterations: int  # of the local method: operations attempted
    converged: bool
    status: Status
    reason: str  # why the run ended, a sentence, in the words of the filter's log
    patches_needing_cut: int
    worst_x: float  # where a cut is needed first of all; 0, 0, 0 where none is
    worst_y: float
    worst_z: float
    nearest_developable: float  # how far the nearest developable shape found moves a vertex, where too far; 0
    border_overlaps: int  # border vertices where it overlaps itself when flat, though the curvature is gone
    edge_strain_left: (
        float  # per cent, of what is nearly developable, laid flat as it is; 0 where not measured
    )
    seconds: float
    panels: Sequence[PanelReport] = dataclasses.field(kw_only=True)
    warnings: tuple[str, ...] = dataclasses.field(default=(), kw_only=True)  # of a result far from its input
    # Whether every panel is within what the material bears, or which is beyond it, where and by how much;
    # empty where nothing is allowed.
    material_verdict: str = dataclasses.field(default="", kw_only=True)

    @classmethod
    def from_values(cls, values: Mapping[str, Any], panels: Sequence[PanelReport] = ()) -> Self:
        """From the dictionary that the filter returned, which must have every key, and what
        `panel_reports` reads from the mesh."""
        words = {"status": Status(values["status"]), "reason": _reason_in_words(values)}
        return super().from_values({**values, **words, "panels": list(panels)})

    @property
    def developable(self) -> bool:
        """Whether the result is, by the method's own tolerances."""
        return self.status in DEVELOPABLE

    def compared(self, departure: Mapping[str, float]) -> Self:
        """With warnings of what is above its limit, in the words of the filter's log. See `departure`."""
        values = {**dataclasses.asdict(self), **departure}
        found = (_filled_in(text, values) for key, limit, text in WARNINGS if values.get(key, 0) > limit)
        return dataclasses.replace(self, warnings=tuple(found))


def _reason_in_words(values: Mapping[str, Any]) -> str:
    """What the reason says, or the status where it has nothing to add."""
    reason = Reason(values["reason"])
    text = reason.text or Status(values["status"]).text
    # Where the curvature is gone there is no strain but rounding.
    said = reason in (Reason.NEARLY_THERE, Reason.BORDER_OVERLAPS)
    if values.get("edge_strain_left", 0) > 0 and not said:
        text += STRAIN_LEFT
    return _filled_in(text, values)


def _filled_in(text: str, values: Mapping[str, Any]) -> str:
    """The text with the numbers put in as the plugin does it."""
    shown = {
        name: f"{value:.4g}" if isinstance(value, float) else str(value) for name, value in values.items()
    }
    return text.format_map(shown)


@dataclasses.dataclass(frozen=True)
class GlobalReport(OptimizationReport):
    """What the global methods add."""

    max_border_angle: float  # what a panel's angles add up to at a border vertex, at most; rad
    max_stretch: float  # of the result's pattern, per cent; -1 where it can't be laid flat
    max_compression: float
    collapsed_faces: int  # of the pattern, thinner than a tenth: their stretch counts as 900 %


@dataclasses.dataclass(frozen=True)
class LocalReport(OptimizationReport):
    """What the local method adds."""

    set_aside: int  # vertices that nothing could be done for
    refused_moves: int
    roughness_before: float  # root mean square angle between neighbouring faces, rad
    roughness_after: float


@dataclasses.dataclass(frozen=True)
class PatternReport(_Report):
    """What laying patches flat costs. Lengths are in the unit of the mesh; strain has none."""

    pieces: int
    max_edge_strain: float
    mean_edge_strain: float
    elastic_energy: float  # Eq. 7, length²
    max_seam_mismatch: float  # length
    overlapping_pieces: int  # with themselves or another
    flipped_faces: int
    max_stretch: float  # per cent
    max_compression: float
    seconds: float
