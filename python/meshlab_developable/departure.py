# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a result is from what it began as, in the numbers that the filters' warnings are about."""

from __future__ import annotations

from typing import Any

import numpy as np
import pymeshlab

from meshlab_developable.mesh_sets import Array, IndexArray

FOLDED = -0.5  # cosine of the angle between the normals of neighbours that lie on each other


def departure_of(mesh: Any) -> dict[str, float]:
    """Numbers by the keys of the warnings, of a mesh of pymeshlab's that a filter has made developable.

    Faces at edges whose normals made less than 90 degrees and make more than 120; connected components with
    less than half of their area.
    """
    after, faces = mesh.vertex_matrix(), mesh.face_matrix()
    try:
        before = mesh.vertex_custom_point_attribute_matrix("original_position")
    except pymeshlab.PyMeshLabException:  # the user stopped it: nothing was changed
        before = after
    return departure(np.asarray(before), np.asarray(after), np.asarray(faces))


def departure(before: Array, after: Array, faces: IndexArray) -> dict[str, float]:
    """See `departure_of`. before, after: n x 3. faces: m x 3."""
    one, other = _neighbours(faces)
    was, is_ = _normals(before, faces), _normals(after, faces)
    sizes = np.linalg.norm(is_, axis=1)
    folded = (np.einsum("ij,ij->i", was[one], was[other]) > 0) & (
        np.einsum("ij,ij->i", is_[one], is_[other]) < FOLDED * sizes[one] * sizes[other]
    )
    count, parts = _components(faces, len(before))
    areas = (np.bincount(parts, np.linalg.norm(normals, axis=1), count) for normals in (was, is_))
    area_before, area_after = areas
    return {
        "folded_faces": len(np.unique([one[folded], other[folded]])),
        "shrunken_patches": int((area_after < 0.5 * area_before).sum()),
    }


def _normals(vertices: Array, faces: IndexArray) -> Array:
    """Of faces, as long as twice their areas."""
    corners = vertices[faces]
    normals: Array = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return normals


def _neighbours(faces: IndexArray) -> tuple[IndexArray, IndexArray]:
    """Pairs of faces that share an edge, and run along it in opposite directions."""
    sides = faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    order = np.lexsort(np.sort(sides, axis=1).T)
    same = (sides[order[:-1]] == sides[order[1:], ::-1]).all(axis=1)
    return (order[:-1][same] // 3).astype(np.int32), (order[1:][same] // 3).astype(np.int32)


def _components(faces: IndexArray, vertices: int) -> tuple[int, IndexArray]:
    """How many connected components there are, and the one of each face."""
    import scipy.sparse.csgraph  # takes as long as all that a command without results needs

    starts, ends = faces[:, [0, 1]].T.ravel(), faces[:, [1, 2]].T.ravel()
    graph = scipy.sparse.coo_array((np.ones(len(starts)), (starts, ends)), shape=(vertices, vertices))
    count, of_vertices = scipy.sparse.csgraph.connected_components(graph, directed=False)
    return int(count), of_vertices[faces[:, 0]].astype(np.int32)
