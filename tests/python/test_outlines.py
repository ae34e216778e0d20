# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth outlines of patterns: near the mesh, with its corners, and the same along both sides of a seam."""

from __future__ import annotations

import itertools
import json
import types
from pathlib import Path

import numpy as np
import pattern_readers as readers
import pytest
import shapely
from meshlab_developable import InvalidParameterError, make_developable
from meshlab_developable.patterns import PatternOptions, make_patterns, write_patterns
from meshlab_developable.patterns.bezier import bezier_curves
from meshlab_developable.patterns.corners import turning
from meshlab_developable.patterns.outlines import fair_outlines
from meshlab_developable.sewing import Seam
from shapes import grid

PANTS = Path(__file__).parents[2] / "meshes" / "short_pants.ply"
TOLERANCE = 0.3  # mm, the default
EQUAL = 0.05  # mm


def disc(corners, radius=100.0):
    """A flat disc whose border is a polygon of so many corners."""
    turns = 2 * np.pi * np.arange(corners) / corners
    ring = np.stack([radius * np.cos(turns), radius * np.sin(turns), 0 * turns], axis=1)
    faces = [(0, 1 + i, 1 + (i + 1) % corners) for i in range(corners)]
    return np.vstack([np.zeros((1, 3)), ring]), np.array(faces)


def lobed(radii):
    """A flat star-shaped piece with those radii all round."""
    positions, faces = disc(len(radii), 1.0)
    positions[1:] *= np.asarray(radii)[:, None]
    return positions, faces


def flat_polygons(*rings, seams=()):
    """What outlines need of flat pieces, given by their rings (k x 2)."""
    starts = np.cumsum([0, *map(len, rings)])
    return types.SimpleNamespace(
        vertices=np.vstack(rings),
        pieces=np.repeat(np.arange(len(rings)), np.diff(starts)),
        loops=tuple(np.arange(a, b, dtype=np.int32) for a, b in itertools.pairwise(starts)),
        seams=tuple(seams),
        report=types.SimpleNamespace(pieces=len(rings)),
    )


def dxf_line(folder, layer):
    (layers,) = readers.read_dxf_blocks(folder / "pattern.dxf").values()
    (line,) = (geometry for geometry in layers[layer] if geometry.geom_type != "Point")
    return shapely.get_coordinates(line)[:-1]


def largest_turn(ring):
    return np.degrees(abs(turning(ring)).max())


def test_a_coarse_circle_is_cut_round(tmp_path):
    make_patterns(*disc(24), folder=tmp_path, seam_allowance=10)
    sewn, cut = dxf_line(tmp_path, "14"), dxf_line(tmp_path, "1")
    (in_svg,) = readers.read_svg(tmp_path / "pattern.svg")["Piece_1"]["boundary"]
    curve = readers.svg_curve(in_svg)
    for ring, radius in ((sewn, 100), (cut, 110), (curve, 110)):
        centre = (ring.max(axis=0) + ring.min(axis=0)) / 2
        off = abs(np.linalg.norm(ring - centre, axis=1) - radius)
        assert off.max() < 0.05  # where the mesh's lines are off by 0.86
        assert len(ring) > 50
    assert largest_turn(cut) < 6
    (page,) = readers.read_pdf(tmp_path / "pattern.pdf")
    sizes = [np.ptp(line, axis=0) for line in page["lines"]]
    assert any(size == pytest.approx((220, 220), abs=0.1) for size in sizes)


def test_exact_gives_the_lines_of_the_mesh(tmp_path):
    made = make_patterns(*disc(24), folder=tmp_path, outline="exact", formats=["dxf", "svg"])
    assert len(dxf_line(tmp_path, "14")) == 24
    (boundary,) = readers.read_svg(tmp_path / "pattern.svg")["Piece_1"]["sew"]
    assert readers.length(readers.svg_points(boundary)) == pytest.approx(24 * 200 * np.sin(np.pi / 24))
    assert not made.notes


def test_corners_are_kept(tmp_path):
    positions, faces = grid(9, 9, lambda u, v: (100 * u, 60 * v, 0 * u))
    make_patterns(positions, faces, folder=tmp_path, seam_allowance=0, formats=["dxf"])
    assert shapely.Polygon(dxf_line(tmp_path, "14")).area == pytest.approx(6000, abs=1e-3)
    assert shapely.Polygon(dxf_line(tmp_path, "1")).area == pytest.approx(6000, abs=1e-3)


def test_noise_within_the_tolerance_goes_and_the_curve_stays(tmp_path):
    turns = 2 * np.pi * np.arange(160) / 160
    noisy = 100 + 10 * np.cos(2 * turns) + 0.12 * (-1.0) ** np.arange(160)
    positions, faces = lobed(noisy)
    make_patterns(positions, faces, folder=tmp_path, formats=["dxf"])
    sewn = dxf_line(tmp_path, "14")
    make_patterns(positions, faces, folder=tmp_path, formats=["dxf"], outline="exact")
    exact = dxf_line(tmp_path, "14")
    assert largest_turn(exact) > 9
    assert largest_turn(sewn) < 3
    one, other = (
        shapely.LinearRing(ring - (ring.max(axis=0) + ring.min(axis=0)) / 2) for ring in (exact, sewn)
    )
    assert shapely.hausdorff_distance(one, other) < TOLERANCE


def jagged_strip():
    """A flat strip of 600 by 200 mm whose two long borders have teeth of 8 mm."""

    def surface(u, v):
        column = np.round(40 * u)
        return 600 * u, 200 * v + 8 * (column % 2) * np.where(v > 0.99, 1, np.where(v < 0.01, -1, 0)), 0 * u

    return grid(41, 9, surface)


def test_saw_teeth_are_said_and_go_when_asked(tmp_path):
    made = make_patterns(*jagged_strip(), folder=tmp_path, formats=["dxf"])
    (note,) = made.notes
    assert "Piece 1 has a jagged edge" in note
    assert "outline_tolerance of 8 (mm)" in note
    assert largest_turn(dxf_line(tmp_path, "14")) > 40
    made = make_patterns(*jagged_strip(), folder=tmp_path, formats=["dxf"], outline_tolerance=10)
    assert not made.notes
    turns = np.degrees(abs(turning(dxf_line(tmp_path, "14"))))
    assert (turns > 25).sum() == 4
    assert np.ptp(dxf_line(tmp_path, "14"), axis=0).min() < 212


@pytest.fixture(scope="module")
def pants(tmp_path_factory):
    developed = make_developable(PANTS)
    folder = tmp_path_factory.mktemp("fair")
    made = make_patterns(
        developed.vertices, developed.faces, folder=folder, name="pattern", unit="cm", formats=["dxf"]
    )
    return (
        made,
        readers.read_dxf_blocks(folder / "pattern.dxf"),
        json.loads((folder / "pattern.json").read_text()),
    )


def test_sew_lines_are_near_every_vertex_of_the_mesh(pants, tmp_path):
    made, blocks, _ = pants
    write_patterns(
        made.flattening, tmp_path, "exact", PatternOptions(unit="cm", outline="exact", formats=["dxf"])
    )
    exact = readers.read_dxf_blocks(tmp_path / "exact.dxf")
    assert sorted(blocks) == sorted(exact)
    for name, layers in blocks.items():
        mesh, line = (shapely.get_coordinates(found["14"][0])[:-1] for found in (exact[name], layers))
        # Each in its own frame.
        inside, drawn = (np.array(shapely.Polygon(ring).centroid.coords[0]) for ring in (mesh, line))
        border = shapely.LinearRing(line)
        assert shapely.distance(shapely.points(mesh - inside + drawn), border).max() < TOLERANCE + 0.05
        assert border.length == pytest.approx(shapely.LinearRing(mesh).length, rel=1e-3)


def test_both_sides_of_a_seam_are_alike(pants):
    _, blocks, side_file = pants
    block_of = {piece["name"]: piece["dxf_block"] for piece in side_file["pieces"]}
    assert len(side_file["seams"]) == 7
    for seam in side_file["seams"]:
        steps = []
        for side in seam["sides"]:
            ring = shapely.get_coordinates(blocks[block_of[side["piece"]]]["14"][0])[:-1]
            steps.append(np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1)[side["edges"]])
        assert len(steps[0]) == len(steps[1])
        assert steps[0].sum() == pytest.approx(steps[1].sum(), abs=EQUAL)
        assert abs(np.cumsum(steps[0]) - np.cumsum(steps[1])).max() < 2 * EQUAL
        np.testing.assert_allclose(*(side["notches_at"] for side in seam["sides"]), atol=EQUAL)


def arc_and_line(radius, turn, edges):
    """Two pieces sewn together, the one along an arc, the other along a straight side of as many edges."""
    angles = turn * (0.5 - np.arange(edges + 1) / edges)
    arc = np.stack([radius * np.sin(angles), radius * np.cos(angles)], axis=1)[::-1]
    length = edges * 2 * radius * np.sin(turn / edges / 2)
    line = np.stack([length * np.arange(edges + 1) / edges, np.zeros(edges + 1)], axis=1)
    one = np.vstack([arc, [(arc[-1, 0], 0), (arc[0, 0], 0)]])
    other = np.vstack([line, [(length, 80), (0, 80)]])
    sides = np.arange(edges + 1, dtype=np.int32), np.arange(len(one), len(one) + edges + 1, dtype=np.int32)
    return flat_polygons(one, other, seams=[Seam((0, 1), sides, (length, length), closed=False)])


def test_a_bent_side_is_as_long_as_the_straight_one_that_it_is_sewn_to():
    flat = arc_and_line(150, 1.2, 14)  # smooth, the arc would be 0.06 mm longer
    made = fair_outlines(flat, 1.0, TOLERANCE, ["a", "b"])
    (seam,) = made.seams
    one, other = (np.linalg.norm(np.diff(made.points[side], axis=0), axis=1) for side in seam.sides)
    assert one.sum() == pytest.approx(other.sum(), abs=EQUAL / 2)
    np.testing.assert_allclose(one, other, atol=EQUAL / 2)
    assert len(one) > 14
    line = shapely.LineString(made.points[seam.sides[0]])
    assert shapely.distance(shapely.points(flat.vertices[:15]), line).max() <= TOLERANCE
    inner = turning(made.points[seam.sides[0]])[1:-1]
    assert np.degrees(abs(inner).max()) < 3


def test_where_no_smooth_lines_are_equally_long_the_meshs_remain():
    flat = arc_and_line(40, 2.4, 5)  # smooth, the arc is 1 mm longer
    made = fair_outlines(flat, 1.0, TOLERANCE, ["a", "b"])
    (seam,) = made.seams
    assert seam.lengths[0] == pytest.approx(seam.lengths[1], abs=1e-9)
    np.testing.assert_allclose(made.points[seam.sides[0]], flat.vertices[:6])


def test_outlines_move_with_the_piece():
    flat = arc_and_line(150, 1.2, 14)
    made = fair_outlines(flat, 1.0, TOLERANCE, ["a", "b"])
    turn = np.array([[0.6, 0.8], [-0.8, 0.6]])
    flat.vertices = flat.vertices @ turn + (7, -3)
    moved = fair_outlines(flat, 1.0, TOLERANCE, ["a", "b"])
    np.testing.assert_allclose(moved.points, made.points @ turn + (7, -3), atol=1e-5)


def test_curves_follow_their_points():
    turns = np.linspace(0, 2 * np.pi, 301)[:-1]
    radius = 80 + 15 * np.cos(5 * turns)
    ring = np.stack([radius * np.cos(turns), radius * np.sin(turns)], axis=1)
    curves = bezier_curves(ring)
    assert len(curves) < 60
    for one, other in zip(curves, [*curves[1:], curves[0]], strict=True):
        np.testing.assert_array_equal(one[3], other[0])
        leaving, arriving = other[1] - other[0], one[3] - one[2]
        cross = leaving[0] * arriving[1] - leaving[1] * arriving[0]
        assert abs(cross) < 1e-9 * np.linalg.norm(leaving) * np.linalg.norm(arriving)
    share = np.linspace(0, 1, 30)[:, None]
    drawn = shapely.LinearRing(
        np.vstack(
            [
                (1 - share) ** 3 * a
                + 3 * share * (1 - share) ** 2 * b
                + 3 * share**2 * (1 - share) * c
                + share**3 * d
                for a, b, c, d in curves
            ]
        )
    )
    assert shapely.distance(shapely.points(ring), drawn).max() < 0.025


@pytest.mark.parametrize(
    ("across", "up"),
    [
        ([0, 44.4, 85, 100], [0, 0, -0.01, 0]),
        ([0, 27.8, 75.4, 88.2, 100], [0, 0.1, 0.54, 0.3, 0]),
        ([0, 19.4, 57.8, 73.3, 92.4, 100], [0, -0.13, -0.52, -0.49, 0.55, 0]),
    ],
)
def test_curves_through_few_points_never_turn_back(across, up):
    ring = np.vstack([np.stack([across, up], axis=1), [(100, 60), (0, 60)]])
    for curve in bezier_curves(ring):
        straight = curve[3] - curve[0]
        for share in np.linspace(0, 1, 40):
            basis = np.array([(1 - share) ** 2, 2 * share * (1 - share), share**2])
            assert basis @ np.diff(curve, axis=0) @ straight > 0


def test_curves_pass_a_point_given_twice():
    ring = np.array([(0, 0), (50, 0), (50, 0), (50, 40), (1e-9, 40), (0, 40), (0, 1e-9)], dtype=float)
    ends = np.array([curve[[0, 3]] for curve in bezier_curves(ring)])
    assert np.isfinite(ends).all()
    np.testing.assert_allclose(sorted(ends[:, 0].tolist()), [(0, 0), (0, 40), (50, 0), (50, 40)], atol=1e-8)


@pytest.mark.parametrize("options", [{"outline": "round"}, {"outline_tolerance": -1}])
def test_bad_options_are_refused(tmp_path, options):
    with pytest.raises(InvalidParameterError, match=next(iter(options))):
        make_patterns(*disc(12), folder=tmp_path / "out", **options)
    assert not (tmp_path / "out").exists()
