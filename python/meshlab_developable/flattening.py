# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels laid flat, and which edge of which piece is sewn to which."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from meshlab_developable import mesh_sets, plugin
from meshlab_developable.filters import FLATTEN
from meshlab_developable.mesh_sets import Array, IndexArray, Source
from meshlab_developable.methods import array_parameters, opened
from meshlab_developable.reports import PatternReport
from meshlab_developable.sewing import Seam, boundary_loops, read_seams


@dataclasses.dataclass(frozen=True)
class FlatteningResult:
    """What `flatten` returns: pieces in the plane, at the mesh's own scale, their outside up."""

    vertices: Array  # p x 2; vertices on seams and cuts are doubled
    faces: IndexArray  # m x 3; face i is face i of the mesh, or of its chosen faces
    pieces: IndexArray  # p, the number of each vertex's piece, from 0
    places: IndexArray  # p; vertices of the same place are sewn together
    model_vertices: Array  # p x 3, where each vertex is on the mesh; linked vertices at their mean
    loops: tuple[IndexArray, ...]  # the boundaries of all pieces, as rings of vertices
    seams: tuple[Seam, ...]
    quality: Array  # p, the chosen map
    edge_strain: Array  # p, the greatest of the edges at each vertex
    report: PatternReport


def flatten(
    vertices: Source,
    faces: npt.ArrayLike | None = None,
    *,
    only_selected: npt.ArrayLike | None = None,
    face_labels: npt.ArrayLike | None = None,
    texture_coordinates: npt.ArrayLike | None = None,
    **parameters: Any,
) -> FlatteningResult:
    """Lay every patch flat at the mesh's own scale, with edges as long as they are on the mesh, or nearly.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Or, in place of the two, a file that
    pymeshlab, trimesh or meshio reads, or an object of trimesh or meshio. Connected components are the
    patches, unless there are labels or texture coordinates, or `patches` says otherwise.

    only_selected: m of bool; only the patches with such a face are laid flat. face_labels: m of any kind;
    patches meet where labels differ. texture_coordinates: n x 2, or m x 3 x 2 at the faces' corners; patches
    are the texture islands. Other parameters are those of the filter Flatten Patches; lengths are plain
    numbers in the mesh's unit.

    Raises InvalidMeshError, InvalidParameterError, FilterError (for closed patches, patches with handles,
    faces without area) and what `load` raises.
    """
    values = FLATTEN.checked(array_parameters(parameters, FLATTEN, face_labels, texture_coordinates))
    meshes = opened(vertices, faces, face_labels, texture_coordinates)
    if only_selected is not None:
        mesh_sets.select_faces(meshes, only_selected)
        values["only_selected"] = True
    return flattened_layer(meshes, values)


def flattened_layer(meshes: Any, values: Mapping[str, Any]) -> FlatteningResult:
    """Lay the current layer of a set flat; the pattern is the current layer afterwards.

    values: parameters of the filter, checked. Raises FilterError.
    """
    report = PatternReport.from_values(mesh_sets.apply_filter(meshes, FLATTEN, values))
    pattern = meshes.current_mesh()
    # Copies: what pymeshlab hands out dies with its set.
    flat = np.array(pattern.vertex_matrix())[:, :2].copy()
    triangles = np.array(pattern.face_matrix(), dtype=np.int32)
    places, pieces = (
        pattern.vertex_custom_scalar_attribute_array(name).astype(np.int32) for name in ("place", "piece")
    )
    return FlatteningResult(
        vertices=flat,
        faces=triangles,
        pieces=pieces,
        places=places,
        model_vertices=np.array(pattern.vertex_custom_point_attribute_matrix("model_position")),
        loops=boundary_loops(triangles),
        seams=read_seams(pattern, flat, pieces, places),
        quality=plugin.vertex_quality(pattern),
        edge_strain=np.array(pattern.vertex_custom_scalar_attribute_array("edge_strain")),
        report=report,
    )
