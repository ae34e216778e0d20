# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in, arrays and a report out."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from meshlab_developable import mesh_sets, plugin
from meshlab_developable.departure import departure_of
from meshlab_developable.errors import InvalidParameterError
from meshlab_developable.filters import GLOBAL, LOCAL, MAPS, Filter
from meshlab_developable.material_verdict import judged
from meshlab_developable.mesh_sets import Array, IndexArray, Source
from meshlab_developable.panels import panel_reports
from meshlab_developable.reports import GlobalReport, LocalReport, Measures, OptimizationReport

METHODS: dict[str, tuple[Filter, type[OptimizationReport]]] = {
    "global": (GLOBAL, GlobalReport),
    "local": (LOCAL, LocalReport),
}


@dataclasses.dataclass(frozen=True)
class Measured:
    """What `measure` returns."""

    measures: Measures
    quality: Array  # n, the chosen map


@dataclasses.dataclass(frozen=True)
class Developed:
    """What `make_developable` returns."""

    vertices: Array  # n x 3, in the order given
    faces: IndexArray  # m x 3, in the order given
    quality: Array  # n, the chosen map
    report: OptimizationReport  # a GlobalReport or a LocalReport


def measure(
    vertices: Source,
    faces: npt.ArrayLike | None = None,
    *,
    face_labels: npt.ArrayLike | None = None,
    texture_coordinates: npt.ArrayLike | None = None,
    reference: Source | tuple[npt.ArrayLike, npt.ArrayLike] | None = None,
    **parameters: Any,
) -> Measured:
    """How developable a mesh is.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Or, in place of the two, a file that
    pymeshlab, trimesh or meshio reads, or an object of trimesh or meshio. Connected components are the
    patches, unless there are labels or texture coordinates, or `patches` says otherwise; vertices that
    coincide are linked.

    face_labels: m of any kind; patches meet where labels differ. texture_coordinates: n x 2, or m x 3 x 2 at
    the faces' corners; patches are the texture islands. reference: the mesh, as a source or as a pair of
    vertices and faces, that the maps Distance and Displacement are measured to. Other parameters are those of
    the filter Developability Maps; lengths are plain numbers in the mesh's unit.

    Raises InvalidMeshError, InvalidParameterError, FilterError and what `load` raises.
    """
    values = MAPS.checked(array_parameters(parameters, MAPS, face_labels, texture_coordinates))
    meshes = opened(vertices, faces, face_labels, texture_coordinates)
    if reference is not None:
        pair = reference if isinstance(reference, tuple) else (reference,)
        values["reference"] = mesh_sets.add_layer(meshes, *pair)
    result = mesh_sets.apply_filter(meshes, MAPS, values)
    return Measured(Measures.from_values(result), plugin.vertex_quality(meshes.current_mesh()))


def make_developable(
    vertices: Source,
    faces: npt.ArrayLike | None = None,
    method: Literal["global", "local"] = "global",
    *,
    only_selected: npt.ArrayLike = False,
    fix_selected: npt.ArrayLike = False,
    face_labels: npt.ArrayLike | None = None,
    texture_coordinates: npt.ArrayLike | None = None,
    **parameters: Any,
) -> Developed:
    """Move the vertices so that each patch becomes developable, or nearer to it, and little else changes.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Or, in place of the two, a file that
    pymeshlab, trimesh or meshio reads, or an object of trimesh or meshio. Connected components are the
    patches, unless there are labels or texture coordinates, or `patches` says otherwise; vertices that
    coincide are linked and stay together. The arrays given are not changed.

    method: "global" (Wang and Tang 2004, Section 4, or constrained Newton) or "local" (Section 5).
    only_selected: m of bool; only the patches with such a face are worked on, the others hold still.
    fix_selected: n of bool; these vertices stay. (True alone means the selection that a file brings.)
    face_labels: m of any kind; patches meet where labels differ. texture_coordinates: n x 2, or m x 3 x 2
    at the faces' corners; patches are the texture islands. Other parameters are those of the filters Global
    and Local Developability; lengths are plain numbers in the mesh's unit.

    Not converging is no error: see `report.status`. Raises InvalidMeshError, InvalidParameterError,
    FilterError and what `load` raises.
    """
    if method not in METHODS:
        raise InvalidParameterError(
            f"method is {method!r}, but must be one of {', '.join(map(repr, METHODS))}"
        )
    applied, report_type = METHODS[method]
    values = applied.checked(array_parameters(parameters, applied, face_labels, texture_coordinates))
    meshes = opened(vertices, faces, face_labels, texture_coordinates)
    values["only_selected"] = _selected(meshes, only_selected, mesh_sets.select_faces)
    values["fix_selected"] = _selected(meshes, fix_selected, mesh_sets.select_vertices)
    result = mesh_sets.apply_filter(meshes, applied, values)
    mesh = meshes.current_mesh()
    # Copies: what pymeshlab hands out dies with its set.
    positions = np.array(mesh.vertex_matrix())
    faces = np.array(mesh.face_matrix())
    report = report_type.from_values(result, panel_reports(mesh)).compared(departure_of(mesh))
    report = judged(report, values)
    return Developed(positions, faces, plugin.vertex_quality(mesh), report)


def opened(
    vertices: Source,
    faces: npt.ArrayLike | None,
    face_labels: npt.ArrayLike | None,
    texture_coordinates: npt.ArrayLike | None,
) -> Any:
    """A set with the mesh as its current layer, with labels and texture coordinates in it."""
    meshes = mesh_sets.open_mesh(vertices, faces)
    if face_labels is None and texture_coordinates is None:
        return meshes
    return mesh_sets.rebuilt(meshes, face_labels, texture_coordinates)


def _selected(meshes: Any, chosen: npt.ArrayLike, select: Callable[[Any, npt.ArrayLike], None]) -> bool:
    """Selects by a mask; whether the filter is to look at the selection."""
    if isinstance(chosen, bool):
        return chosen
    select(meshes, chosen)
    return True


def array_parameters(
    parameters: dict[str, Any],
    applied: Filter,
    face_labels: npt.ArrayLike | None,
    texture_coordinates: npt.ArrayLike | None,
) -> dict[str, Any]:
    """The parameters, with the seams that the arrays given are there for.

    Raises InvalidParameterError for a parameter that the filter has not.
    """
    for name in parameters:
        applied.parameter(name)
    seams = {"Face quality": face_labels, "Texture islands": texture_coordinates}
    given = [kind for kind, array in seams.items() if array is not None]
    if len(given) > 1 and "patches" not in parameters:
        raise InvalidParameterError("give face_labels or texture_coordinates, or say which one with patches")
    return {"patches": given[0], **parameters} if given else parameters
