# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of Local Developability that go beyond the paper, each against the paper's method."""

import numpy as np
import pytest
from mesh_sets import LOCAL, mesh_set, optimized, positions_of
from shapes import bump, crumpled_above_flat, two_bumps


def self_intersecting_faces(meshes) -> int:
    """What pymeshlab itself finds."""
    meshes.apply_filter("compute_selection_by_self_intersections_per_face")
    return meshes.current_mesh().selected_face_number()


def test_no_move_makes_the_surface_cut_itself_when_that_is_asked_for():
    mesh = crumpled_above_flat()
    assert self_intersecting_faces(mesh_set(mesh)) == 0
    through, _ = optimized(mesh, LOCAL)
    assert self_intersecting_faces(through) > 0
    clear, returned = optimized(mesh, LOCAL, avoid_self_intersections=True)
    assert self_intersecting_faces(clear) == 0
    assert returned["refused_moves"] > 0
    assert returned["detect_function_after"] < returned["detect_function_before"]


def test_descent_gets_farther_on_a_bump():
    _, plain = optimized(bump(), LOCAL)
    _, descent = optimized(bump(), LOCAL, descent=True)
    assert descent["detect_function_after"] < plain["detect_function_before"]
    assert descent["set_aside"] > 0
    assert descent["iterations"] < 500_000


@pytest.mark.parametrize("move", [False, True])
def test_seams_move_only_when_they_may(move):
    positions, triangles = two_bumps()
    choice = "Move together" if move else "Fixed"
    meshes, _ = optimized((positions, triangles), LOCAL, descent=True, assembling_vertices=choice)
    seam = np.isclose(positions[:, 0], 0)
    moved = np.linalg.norm(positions_of(meshes) - positions, axis=1)[seam]
    assert (moved.max() > 1e-6) == move
    # Both sides of the seam are where they were together before: equal to the last bit.
    half = len(positions) // 2
    after = positions_of(meshes)
    assert np.array_equal(after[:half][seam[:half]], after[half:][seam[half:]])
