# SPDX-License-Identifier: GPL-3.0-or-later
"""What an optimisation did to each panel, read from the attributes that it leaves on the faces."""

from __future__ import annotations

from typing import Any

import numpy as np

from meshlab_developable.reports import SEAM_REASONS, PanelReport, PanelStrain

_ATTRIBUTES = {  # of the faces, by the report's field
    "status": "panel_status",
    "reason": "panel_reason",
    "curvature_before": "panel_curvature_before",
    "curvature_after": "panel_curvature",
    "max_angle_defect": "panel_max_angle_defect",
    "mean_displacement": "panel_mean_displacement",
    "max_displacement": "panel_max_displacement",
    "nearest_developable": "panel_nearest_developable",
    "border_overlaps": "panel_border_overlaps",
}
_OF_A_CUT = "panel_neighbour", "panel_seam_point"  # what a reason to be cut there speaks of


def panel_reports(mesh: Any) -> list[PanelReport]:
    """Of each panel of a mesh of pymeshlab's that Global or Local Developability has worked on, or that was
    cut, in order; none of other meshes, or when the run was stopped."""
    try:
        panel_of_face = mesh.face_custom_scalar_attribute_array("panel")
    except Exception:  # pymeshlab's own, where there is no such attribute
        return []
    panels, first, counts = np.unique(panel_of_face, return_index=True, return_counts=True)
    columns = {
        field: mesh.face_custom_scalar_attribute_array(name)[first] for field, name in _ATTRIBUTES.items()
    }
    worst = mesh.face_custom_point_attribute_matrix("panel_worst_point")[first]
    reports = []
    for row in np.flatnonzero(panels >= 0):
        numbers: dict[str, Any] = {field: float(column[row]) for field, column in columns.items()}
        numbers |= {field: int(numbers[field]) for field in ("status", "reason", "border_overlaps")}
        numbers |= _seam_of(mesh, int(first[row])) if numbers["reason"] in SEAM_REASONS else {}
        place = tuple(map(float, worst[row]))
        index, faces = int(panels[row]), int(counts[row])
        more = {"index": index, "faces": faces, "worst_point": place}
        strain = _strain(mesh, int(first[row]))
        reports.append(PanelReport.from_values(numbers | more | {"strain": strain}))
    return reports


def _strain(mesh: Any, face: int) -> PanelStrain | None:
    """Of the panel of a face, where it was measured."""
    try:
        stretch = float(mesh.face_custom_scalar_attribute_array("panel_stretch")[face])
    except Exception:  # pymeshlab's own: the mesh is of an older version
        return None
    if stretch < 0:
        return None
    compression, beyond = (
        float(mesh.face_custom_scalar_attribute_array(f"panel_{name}")[face])
        for name in ("compression", "beyond_bounds")
    )
    x, y, z = map(float, mesh.face_custom_point_attribute_matrix("panel_strain_point")[face])
    return PanelStrain(stretch, compression, beyond, (x, y, z))


def _seam_of(mesh: Any, face: int) -> dict[str, Any]:
    """What the words of a reason to be cut somewhere take."""
    neighbour, point = _OF_A_CUT
    place = mesh.face_custom_point_attribute_matrix(point)[face]
    return {
        "neighbour": int(mesh.face_custom_scalar_attribute_array(neighbour)[face]),
        **dict(zip(("seam_x", "seam_y", "seam_z"), map(float, place), strict=True)),
    }
