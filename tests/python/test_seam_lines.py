# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams that are moved on the model to be smooth: both sides alike, and no farther than asked."""

from __future__ import annotations

import itertools
import types

import numpy as np
import pattern_readers as readers
import pytest
import shapely
from meshlab_developable import InvalidParameterError
from meshlab_developable.patterns import make_patterns
from meshlab_developable.patterns.corners import turning
from meshlab_developable.patterns.seam_lines import smooth_seams
from meshlab_developable.sewing import Seam
from shapes import grid

TOOTH = 4.0  # mm
TURNED = np.array([[0.6, 0.8], [-0.8, 0.6]])


def pieces_beside(line, other, holes=()):
    """A piece left of a line, another right of the line that it is sewn to, and holes in the first."""
    above = np.vstack([line, line[[-1, 0]] + (0, 90)])
    below = np.vstack([other, other[[-1, 0]] - (0, 60)]) @ TURNED + (300, 40)
    rings = [above, below, *holes]
    starts = np.cumsum([0, *map(len, rings)])
    sides = np.arange(len(line), dtype=np.int32), starts[1] + np.arange(len(line), dtype=np.int32)
    lengths = tuple(float(np.linalg.norm(np.diff(side, axis=0), axis=1).sum()) for side in (line, other))
    return types.SimpleNamespace(
        vertices=np.vstack(rings),
        pieces=np.repeat([0, 1] + [0] * len(holes), np.diff(starts)),
        loops=tuple(np.arange(a, b, dtype=np.int32) for a, b in itertools.pairwise(starts)),
        seams=(Seam((0, 1), sides, lengths, closed=False),),
        report=types.SimpleNamespace(pieces=2),
    )


def teeth(count):
    """Up and down, but not at the ends."""
    heights = TOOTH * (np.arange(count + 1) % 2)
    heights[-1] = 0
    return heights


def straight_with_teeth():
    return np.stack([10.0 * np.arange(21), teeth(20)], axis=1)


def moved(flat, tolerance):
    smooth = smooth_seams(flat, flat.vertices, tolerance)
    return smooth, *(smooth[side] for side in flat.seams[0].sides)


def largest_turn(line):
    return np.degrees(abs(turning(line)[1:-1]).max())


def test_a_jagged_seam_becomes_smooth_and_its_sides_still_fit():
    line = straight_with_teeth()
    flat = pieces_beside(line, line)
    smooth, one, other = moved(flat, 5.0)
    assert largest_turn(line) > 40
    assert largest_turn(one) < 6
    np.testing.assert_allclose((other - (300, 40)) @ TURNED.T, one, atol=1e-6)
    moves = np.linalg.norm(smooth - flat.vertices, axis=1)
    assert 1 < moves.max() <= 5
    np.testing.assert_array_equal(moves[[0, 20, 21, 22]], 0)
    areas = [
        sum(shapely.Polygon(points[loop]).area for loop in flat.loops) for points in (flat.vertices, smooth)
    ]
    assert areas[0] == pytest.approx(areas[1], rel=1e-9)  # what one loses the other gains


def test_no_point_moves_farther_than_it_may():
    line = straight_with_teeth()
    flat = pieces_beside(line, line)
    smooth, *_ = moved(flat, 0.5)
    moves = np.linalg.norm(smooth - flat.vertices, axis=1)
    assert 0.1 < moves.max() <= 0.5


def test_sides_that_bend_differently_stay_equally_long():
    angles = 1.2 * (np.arange(21) / 20 - 0.5)
    radius = 150 - teeth(20)
    arc = np.stack([radius * np.sin(angles), -radius * np.cos(angles)], axis=1)
    steps = np.linalg.norm(np.diff(arc, axis=0), axis=1)
    rise = np.diff(teeth(20))
    along = np.append(0.0, np.cumsum(np.sqrt(steps**2 - rise**2)))
    flat = pieces_beside(arc, np.stack([along, teeth(20)], axis=1))
    _, one, other = moved(flat, 5.0)
    assert largest_turn(one) < 10
    lengths = [np.linalg.norm(np.diff(side, axis=0), axis=1).sum() for side in (one, other)]
    assert lengths[0] == pytest.approx(lengths[1], abs=1e-3)
    assert lengths[0] < steps.sum() - 1


def test_a_point_where_the_pieces_meet_at_a_corner_stays():
    one = straight_with_teeth()
    other = one.copy()
    other[10:] = one[10] + (one[10:] - one[10]) @ np.array([[0.0, -1.0], [1.0, 0.0]])  # by a right angle
    _, first, second = moved(pieces_beside(one, other), 5.0)
    np.testing.assert_array_equal(first[10], one[10])
    for side in (first, second):
        assert max(largest_turn(side[:11]), largest_turn(side[10:])) < 6


def test_a_seam_whose_piece_would_overlap_itself_stays():
    line = straight_with_teeth()
    hole = np.array([(100, 1), (101.5, 3), (98.5, 3)])  # in a valley, which would be filled
    flat = pieces_beside(line, line, [hole])
    smooth, *_ = moved(flat, 5.0)
    np.testing.assert_array_equal(smooth, flat.vertices)


def jagged_panels():
    """A flat sheet of 600 by 200 mm in two panels that meet along a jagged line."""

    def surface(u, v):
        tooth = 8 * (np.round(40 * u) % 2) * (abs(v - 0.5) < 0.01) * (abs(u - 0.5) < 0.49)
        return 600 * u, 200 * v + tooth, 0 * u

    positions, faces = grid(41, 9, surface)
    upper = np.arange(len(faces)) >= len(faces) // 2
    return np.vstack([positions, positions]), np.where(upper[:, None], faces + len(positions), faces)


def sew_lines(folder):
    blocks = readers.read_dxf_blocks(folder / "pattern.dxf")
    return [shapely.get_coordinates(layers["14"][0])[:-1] for layers in blocks.values()]


def test_jagged_seams_are_said_and_go_when_asked(tmp_path):
    made = make_patterns(*jagged_panels(), folder=tmp_path, formats=["dxf"])
    assert len(made.notes) == 2
    assert all("a seam_tolerance of 8 (mm) smooths them" in note for note in made.notes)
    made = make_patterns(*jagged_panels(), folder=tmp_path, formats=["dxf"], seam_tolerance=8)
    assert not made.notes
    (seam,) = made.seams
    assert seam.lengths[0] == pytest.approx(seam.lengths[1], abs=0.05)
    assert seam.lengths[0] == pytest.approx(600, rel=0.01)
    for ring in sew_lines(tmp_path):
        assert (np.degrees(abs(turning(ring))) > 25).sum() == 4


def test_a_tolerance_below_nothing_is_refused(tmp_path):
    with pytest.raises(InvalidParameterError, match="seam_tolerance"):
        make_patterns(*jagged_panels(), folder=tmp_path / "out", seam_tolerance=-1)
    assert not (tmp_path / "out").exists()


def test_a_ring_becomes_smooth_all_round(tmp_path):
    turns = 2 * np.pi * np.arange(48) / 48
    jagged = 100 + 6 * (np.arange(48) % 2)
    rings = [np.stack([r * np.cos(turns), r * np.sin(turns), 0 * turns], axis=1) for r in (50, jagged, 180)]
    positions = np.vstack([np.zeros((1, 3)), *rings])
    after = np.roll(np.arange(48), -1)
    faces = [(0, 1 + k, 1 + n) for k, n in enumerate(after)]
    for start in (1, 49):
        faces += [(start + k, start + 48 + k, start + 48 + n) for k, n in enumerate(after)]
        faces += [(start + k, start + 48 + n, start + n) for k, n in enumerate(after)]
    labels = np.repeat([0, 1], [48 * 3, 48 * 2])
    made = make_patterns(
        positions, faces, folder=tmp_path, formats=["dxf"], face_labels=labels, seam_tolerance=6
    )
    (seam,) = made.seams
    assert seam.seam.closed
    assert seam.lengths == pytest.approx((2 * np.pi * 103, 2 * np.pi * 103), rel=0.01)
    disc = min(sew_lines(tmp_path), key=lambda ring: np.ptp(ring[:, 0]))
    assert np.degrees(abs(turning(disc)).max()) < 8
