# SPDX-License-Identifier: GPL-3.0-or-later
"""pymeshlab by the names that it has in both versions, and states of a mesh that can be compared."""

from __future__ import annotations

import numpy as np
import pymeshlab

GLOBAL = "apply_coord_global_developability"
LOCAL = "apply_coord_local_developability"
MAPS = "compute_scalar_by_developability_per_vertex"

ATTRIBUTES = (
    "original_position",
    "gaussian_map",
    "angle_defect",
    "gaussian_curvature",
    "distance",
    "displacement",
)

Length = getattr(pymeshlab, "PureValue", None) or pymeshlab.AbsoluteValue
Percentage = getattr(pymeshlab, "PercentageValue", None) or pymeshlab.Percentage


def mesh_set(*meshes: tuple[np.ndarray, np.ndarray]) -> pymeshlab.MeshSet:
    """A document with a layer for each mesh; the first one is current."""
    result = pymeshlab.MeshSet()
    for positions, triangles in meshes:
        result.add_mesh(pymeshlab.Mesh(positions, triangles))
    if meshes:
        result.set_current_mesh(0)
    return result


def optimized(mesh, name: str = GLOBAL, **values):
    """The mesh set after a filter, and what the filter returned."""
    meshes = mesh_set(mesh)
    return meshes, meshes.apply_filter(name, **values)


def positions_of(meshes: pymeshlab.MeshSet) -> np.ndarray:
    return meshes.current_mesh().vertex_matrix()


def quality_of(meshes: pymeshlab.MeshSet) -> np.ndarray:
    return meshes.current_mesh().vertex_scalar_array()


def attribute_of(meshes: pymeshlab.MeshSet, name: str) -> np.ndarray:
    """A custom attribute a vertex, of scalars or of points."""
    mesh = meshes.current_mesh()
    if name == "original_position":
        return mesh.vertex_custom_point_attribute_matrix(name)
    return mesh.vertex_custom_scalar_attribute_array(name)


def has_attribute(meshes: pymeshlab.MeshSet, name: str) -> bool:
    try:
        attribute_of(meshes, name)
    except pymeshlab.PyMeshLabException:
        return False
    return True


def state_of(meshes: pymeshlab.MeshSet) -> tuple:
    """All that a filter could have changed, to compare with ==."""
    mesh = meshes.current_mesh()
    names = [name for name in ATTRIBUTES if has_attribute(meshes, name)]
    arrays = [mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_normal_matrix()]
    arrays += [mesh.vertex_color_matrix(), mesh.vertex_scalar_array()]
    arrays += [mesh.vertex_selection_array(), mesh.face_selection_array()]
    arrays += [attribute_of(meshes, name) for name in names]
    count_layers = getattr(meshes, "mesh_number", None) or meshes.number_meshes
    flags = mesh.has_vertex_color(), mesh.has_vertex_scalar(), count_layers()
    return flags, names, [array.tobytes() for array in arrays]
