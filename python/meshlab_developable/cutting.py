# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces cut into panels that can be made developable."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from meshlab_developable import mesh_sets
from meshlab_developable.description import Status
from meshlab_developable.errors import FilterError
from meshlab_developable.filters import CUT
from meshlab_developable.mesh_sets import Array, IndexArray, Source
from meshlab_developable.methods import array_parameters, make_developable, opened
from meshlab_developable.panels import panel_reports
from meshlab_developable.reports import PanelReport

# Parameters that say what panels are made of, which cutting, moving and laying flat share.
OF_MATERIAL = ("material", "allowed_stretch", "allowed_compression", "grain")


@dataclasses.dataclass(frozen=True)
class CutReport:
    """What a cut did. Lengths are in the mesh's unit."""

    panels: list[PanelReport]
    darts: int
    seam_length: float  # each seam and dart once, original borders not
    smallest_panel_area: float
    mean_displacement: float  # that Global Developability with these panels will give
    max_displacement: float
    converged: bool
    status: Status
    seconds: float

    @classmethod
    def from_values(cls, values: Mapping[str, Any], panels: list[PanelReport]) -> CutReport:
        """From the dictionary that the filter returned, and what the mesh's faces say of panels."""
        words = {"panels": panels, "status": Status(values["status"])}
        return cls(**{field.name: {**values, **words}[field.name] for field in dataclasses.fields(cls)})

    @property
    def developable(self) -> bool:
        """Whether every panel can be made developable within the largest displacement."""
        return self.status in (Status.CONVERGED, Status.NOTHING_TO_DO)


@dataclasses.dataclass(frozen=True)
class CutPanels:
    """What `cut_into_panels` returns."""

    vertices: Array  # the n given, then those that were doubled or lie on edges; doubled ones coincide
    faces: IndexArray  # the m given with other vertices, then those that were split off
    face_panels: IndexArray  # per face its panel, from 0; -1 where it was not worked on
    report: CutReport


def cut_into_panels(
    vertices: Source,
    faces: npt.ArrayLike | None = None,
    *,
    only_selected: npt.ArrayLike | None = None,
    keep_selected_whole: npt.ArrayLike | None = None,
    face_labels: npt.ArrayLike | None = None,
    texture_coordinates: npt.ArrayLike | None = None,
    **parameters: Any,
) -> CutPanels:
    """Cut a surface, open or closed, into few panels that can be made developable, with short seams.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Or, in place of the two, a file that
    pymeshlab, trimesh or meshio reads, or an object of trimesh or meshio. Nothing is moved. Vertices along
    seams are doubled and coincide, so that `make_developable` and `flatten` take the result as it is.

    only_selected: m of bool; only the patches with such a face are cut. keep_selected_whole: m of bool; no
    seam crosses these faces. face_labels: m of any kind; patches meet where labels differ, and are only cut
    further. texture_coordinates: n x 2, or m x 3 x 2 at the faces' corners; patches are the texture islands.
    Other parameters are those of the filter Cut into Developable Panels; lengths are plain numbers in the
    mesh's unit.

    Raises InvalidMeshError, InvalidParameterError, FilterError and what `load` raises.
    """
    if only_selected is not None and keep_selected_whole is not None:
        parameters |= {"only_selected": True, "keep_selected_whole": True}
        selected = np.asarray(only_selected) | np.asarray(keep_selected_whole)
    else:
        chosen = {"only_selected": only_selected, "keep_selected_whole": keep_selected_whole}
        given = {name: mask for name, mask in chosen.items() if mask is not None}
        parameters |= dict.fromkeys(given, True)
        selected = next(iter(given.values()), None)
    values = CUT.checked(array_parameters(parameters, CUT, face_labels, texture_coordinates))
    meshes = opened(vertices, faces, face_labels, texture_coordinates)
    if selected is not None:
        mesh_sets.select_faces(meshes, selected)
    report = cut_layer(meshes, values)
    mesh = meshes.current_mesh()
    return CutPanels(
        vertices=np.array(mesh.vertex_matrix()),
        faces=np.array(mesh.face_matrix(), dtype=np.int32),
        face_panels=np.array(mesh.face_custom_scalar_attribute_array("panel"), dtype=np.int32),
        report=report,
    )


def cut_layer(meshes: Any, values: Mapping[str, Any]) -> CutReport:
    """Cut the current layer of a set. values: parameters of the filter, checked. Raises FilterError."""
    result = mesh_sets.apply_filter(meshes, CUT, values)
    if result["status"] == Status.STOPPED:
        return CutReport.from_values(result, [])
    return CutReport.from_values(result, panel_reports(meshes.current_mesh()))


def developed_panels(source: Source, **parameters: Any) -> tuple[Array, IndexArray, CutReport]:
    """Cut a surface into panels and make these developable: vertices, faces, and what the cut did.

    Parameters are those of `cut_into_panels`; both steps take the same material. Raises FilterError too when
    a panel can't be made developable.
    """
    cut = cut_into_panels(source, **parameters)
    if not cut.report.developable:
        worst = max(cut.report.panels, key=lambda panel: panel.curvature_after)
        raise FilterError(
            f"{sum(panel.status == Status.NEEDS_CUT for panel in cut.report.panels)} of "
            f"{len(cut.report.panels)} panels can't be made developable within the largest displacement, "
            f"first of all at {worst.worst_point}: allow a larger one with --max-displacement"
        )
    of_material = {name: parameters[name] for name in OF_MATERIAL if name in parameters}
    developed = make_developable(cut.vertices, cut.faces, **of_material)
    return developed.vertices, developed.faces, cut.report


def seam_tolerance(vertices: Array, faces: IndexArray) -> float:
    """How far the seams of a cut may be moved to be smooth: half as far as edges are long, on average.

    vertices: n x 3, or n x 2 where they are flat already. faces: m x 3.
    """
    corners = vertices[faces]
    return float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean()) / 2


def cut_file(source: Path, target: Path, verbose: bool = False, **parameters: Any) -> CutReport:
    """Cut a file's mesh into panels and write it.

    Parameters are those of the filter Cut into Developable Panels. When verbose, the filter prints what it
    does. Raises as `cut_into_panels` does, and WriteError; the target is written whole or not at all.
    """
    from meshlab_developable.file_methods import save_whole

    values = CUT.checked(parameters)
    meshes = mesh_sets.open_mesh(source, verbose=verbose)
    report = cut_layer(meshes, values)
    meshes.set_verbosity(False)
    save_whole(meshes, target)
    return report
