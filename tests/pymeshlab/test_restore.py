# SPDX-License-Identifier: GPL-3.0-or-later
"""Restore Original Shape: the way back from an optimisation."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from mesh_sets import GLOBAL, LOCAL, attribute_of, mesh_set, optimized, positions_of, state_of
from shapes import bump, two_bumps

RESTORE = "apply_coord_restore_original_shape"


@pytest.mark.parametrize("name", [GLOBAL, LOCAL])
def test_the_shape_is_again_what_it_was_to_the_last_bit(name):
    original, _ = bump()
    meshes, report = optimized(bump(), name)
    normals = meshes.current_mesh().vertex_normal_matrix()
    changed = positions_of(meshes)
    result = meshes.apply_filter(RESTORE)
    assert np.array_equal(positions_of(meshes), original)
    moved = np.linalg.norm(changed - original, axis=1)
    assert result["moved_vertices"] == np.count_nonzero(moved) > 0
    assert result["max_displacement"] == pytest.approx(moved.max(), rel=1e-12)
    assert result["max_displacement"] == pytest.approx(report["max_displacement"], rel=1e-12)
    assert not np.array_equal(meshes.current_mesh().vertex_normal_matrix(), normals)


def test_once_is_as_good_as_twice():
    meshes, _ = optimized(bump())
    meshes.apply_filter(RESTORE)
    again = meshes.apply_filter(RESTORE)
    assert again["moved_vertices"] == again["max_displacement"] == 0
    assert np.array_equal(positions_of(meshes), bump()[0])


def test_an_optimisation_after_it_gives_what_the_first_one_gave():
    meshes, first = optimized(bump())
    developed = positions_of(meshes)
    meshes.apply_filter(RESTORE)
    second = meshes.apply_filter(GLOBAL)
    assert np.array_equal(positions_of(meshes), developed)
    assert second["total_absolute_curvature_before"] == first["total_absolute_curvature_before"]


def test_what_other_runs_left_alone_goes_back_too():
    """Each of two panels is optimised by itself; both go back."""
    original, triangles = two_bumps()
    meshes = mesh_set((original, triangles))
    half = len(triangles) // 2
    for condition in (f"fi < {half}", f"fi >= {half}"):
        meshes.compute_selection_by_condition_per_face(condselect=condition)
        meshes.apply_filter(GLOBAL, only_selected=True)
    meshes.apply_filter(RESTORE)
    assert np.array_equal(positions_of(meshes), original)


def test_only_places_go_back():
    meshes, _ = optimized(bump())
    quality, attribute = meshes.current_mesh().vertex_scalar_array(), attribute_of(meshes, "displacement")
    meshes.apply_filter(RESTORE)
    assert np.array_equal(meshes.current_mesh().vertex_scalar_array(), quality)
    assert np.array_equal(attribute_of(meshes, "displacement"), attribute)


def test_a_layer_that_was_never_optimised_is_refused_and_untouched():
    meshes = mesh_set(bump())
    before = state_of(meshes)
    with pytest.raises(pymeshlab.PyMeshLabException, match="'original_position'"):
        meshes.apply_filter(RESTORE)
    assert state_of(meshes) == before
