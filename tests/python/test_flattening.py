# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays laid flat, and which edge is sewn to which."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import meshlab_developable
import numpy as np
import pytest
import reference_measures as reference
from meshlab_developable import FilterError, flatten
from shapes import bump, cylinder, grid, octahedron, two_bumps

PANTS = Path(__file__).parents[2] / "meshes" / "short_pants.obj"


@pytest.fixture(scope="module")
def pants():
    positions, triangles, _ = reference.read_obj(PANTS)
    return flatten(positions, triangles), positions, triangles


def half_edge_lengths(positions, triangles):
    corners = positions[triangles]
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)


def boundary_edges(triangles):
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return {edge for edge, uses in Counter(map(tuple, edges.tolist())).items() if uses == 1}


def test_a_developable_panel_keeps_its_lengths():
    positions, triangles = cylinder()
    result = flatten(positions, triangles)
    assert result.vertices.shape == (len(positions), 2)
    assert np.array_equal(result.faces, triangles)
    np.testing.assert_allclose(
        half_edge_lengths(result.vertices, result.faces), half_edge_lengths(positions, triangles), rtol=1e-12
    )
    np.testing.assert_allclose(result.model_vertices[result.faces], positions[triangles], atol=1e-15)
    assert result.report.max_edge_strain < 1e-12
    assert result.seams == ()


def test_loops_go_once_along_every_boundary(pants):
    result, _, _ = pants
    along = set()
    for loop in result.loops:
        pairs = zip(loop.tolist(), np.roll(loop, -1).tolist(), strict=True)
        edges = [tuple(sorted(pair)) for pair in pairs]
        assert len(set(edges)) == len(edges)
        along.update(edges)
    assert along == boundary_edges(result.faces)


def test_seams_are_the_edges_that_coincide_on_the_model(pants):
    result, positions, triangles = pants
    numbers = {tuple(place): number for number, place in enumerate(np.unique(positions, axis=0).tolist())}
    place = np.array([numbers[tuple(position)] for position in positions.tolist()])
    uses = Counter(tuple(sorted(place[list(edge)].tolist())) for edge in boundary_edges(triangles))
    sewn = sum(len(seam.sides[0]) - 1 for seam in result.seams)
    assert sewn == sum(count == 2 for count in uses.values())
    assert len(result.seams) == 7
    for seam in result.seams:
        one, other = (result.model_vertices[side] for side in seam.sides)
        np.testing.assert_array_equal(one, other)
        for side, piece, expected in zip(seam.sides, seam.pieces, seam.lengths, strict=True):
            assert set(result.pieces[side]) == {piece}
            steps = np.linalg.norm(np.diff(result.vertices[side], axis=0), axis=1)
            assert steps.sum() == pytest.approx(expected)
            edges = {tuple(sorted(edge)) for edge in zip(side[:-1].tolist(), side[1:].tolist(), strict=True)}
            assert edges <= boundary_edges(result.faces)
    assert max(seam.mismatch for seam in result.seams) == pytest.approx(result.report.max_seam_mismatch)


def test_sides_apart_by_less_than_the_weld_distance_are_sewn():
    positions, triangles = two_bumps(gap=0.01)
    assert flatten(positions, triangles).seams == ()
    (seam,) = flatten(positions, triangles, weld_distance=0.02).seams
    assert seam.pieces == (0, 1)
    assert len(seam.sides[0]) == 11


def test_labels_of_faces_make_seams():
    positions, triangles = bump()
    left = positions[triangles].mean(axis=1)[:, 0] < 0.5
    result = flatten(positions, triangles, face_labels=left)
    assert result.report.pieces == 2
    (seam,) = result.seams
    assert seam.pieces == (0, 1)
    assert seam.lengths[0] == pytest.approx(seam.lengths[1], rel=0.05)


def test_only_the_chosen_patches_are_laid_flat():
    positions, triangles = two_bumps(gap=1.0)
    chosen = np.zeros(len(triangles), dtype=bool)
    chosen[-1] = True
    result = flatten(positions, triangles, only_selected=chosen)
    assert len(result.faces) == len(triangles) // 2
    np.testing.assert_array_equal(
        result.model_vertices[result.faces], positions[triangles[len(triangles) // 2 :]]
    )


def test_the_cut_of_a_tube_is_a_seam_of_the_piece_with_itself():
    positions, triangles = grid(13, 5, lambda u, v: (np.cos(2 * np.pi * u), np.sin(2 * np.pi * u), 2 * v))
    result = flatten(positions, triangles, weld_distance=1e-9)
    (seam,) = result.seams
    assert seam.pieces == (0, 0)
    assert seam.lengths == pytest.approx((2, 2))
    assert not seam.closed


def test_a_ring_sewn_into_a_hole_is_a_closed_seam():
    rows, columns = 9, 9
    positions, triangles = grid(columns, rows, lambda u, v: (u, v, 0 * u))
    middle = abs(positions[triangles].mean(axis=1) - (0.5, 0.5, 0)).max(axis=1) < 0.25
    result = flatten(positions, triangles, face_labels=middle)
    (seam,) = result.seams
    assert seam.closed
    assert seam.lengths == pytest.approx((2, 2))
    assert len(seam.sides[0]) == 17


@pytest.mark.parametrize("sheets", [3, 4])
def test_where_several_edges_meet_each_is_sewn_to_the_first(sheets):
    """Sheets round one edge, like the pages of a book, whose triangles come in any order."""
    pages = []
    for number in range(sheets):
        angle = 2 * np.pi * number / sheets
        pages.append(grid(5, 9, lambda u, v, a=angle: (u * np.cos(a), u * np.sin(a), v)))
    positions = np.vstack([page for page, _ in pages])
    triangles = np.vstack([page + 5 * 9 * number for number, (_, page) in enumerate(pages)])
    shuffled = np.random.default_rng(3).permutation(len(triangles))
    result = flatten(positions, np.roll(triangles[shuffled], 1, axis=1))
    assert [set(seam.pieces) for seam in result.seams] == [{0, other} for other in range(1, sheets)]
    for seam in result.seams:
        assert len(seam.sides[0]) == 9
        assert seam.lengths == pytest.approx((1, 1))
        np.testing.assert_array_equal(*(result.places[side] for side in seam.sides))


def test_the_order_of_the_faces_changes_no_seam(pants):
    result, positions, triangles = pants
    again = flatten(positions, triangles[np.random.default_rng(7).permutation(len(triangles))])
    assert {sides_on_model(seam, result) for seam in result.seams} == {
        sides_on_model(seam, again) for seam in again.seams
    }


def sides_on_model(seam, result):
    """The points along a seam, in order."""
    return tuple(map(tuple, result.model_vertices[seam.sides[0]].tolist()))


def test_what_can_not_be_flat_is_refused_in_words():
    with pytest.raises(FilterError, match="closed and can't be laid flat"):
        flatten(*octahedron())
    with pytest.raises(FilterError, match="no area"):
        flatten(np.zeros((3, 3)), [[0, 1, 2]])
    with pytest.raises(meshlab_developable.InvalidParameterError, match="weld_distance"):
        flatten(*bump(), weld_distances=1)
