# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that lie on themselves when they are flat: a little, and the cut is shared; else they are split."""

from __future__ import annotations

import json
import re

import numpy as np
import pattern_readers as readers
import pytest
import shapely
from meshlab_developable import PatternError, flatten
from meshlab_developable.patterns import make_patterns, write_patterns
from meshlab_developable.patterns.overlaps import find_overlap
from shapes import grid


def open_cone(excess):
    """A cone that is a little more than a full turn when it is flat, slit from its border towards its tip.

    Its radii are 20 to 200, its height none on average: the slit's sides coincide.
    """
    turn = 2 * np.pi + excess

    def surface(u, v):
        # Waves give a ring the length that a wider cone has.
        radius = 20 + 180 * v
        wave = np.sqrt(turn**2 / (4 * np.pi**2) - 1)
        angle = 2 * np.pi * u
        height = radius * wave * np.sqrt(2) / 4 * np.sin(4 * angle)
        return radius * np.cos(angle), radius * np.sin(angle), height

    return grid(241, 19, surface)


def ramp(turns=9.0):
    """A flat ramp that winds more than once round its axis."""
    return grid(80, 4, lambda u, v: ((1 + v) * np.cos(turns * u), (1 + v) * np.sin(turns * u), 0.05 * u))


def spiral(width):
    """A ring round a square hole, whose end lies on its beginning by so much."""
    outer = np.array([(10, 0), (10, 10), (-10, 10), (-10, -10), (10, -10), (10, width)])
    inner = np.array([(5, width), (5, -5), (-5, -5), (-5, 5), (5, 5), (5, 0)])
    return np.concatenate([outer, inner])


def cut_polygons(folder):
    for layers in readers.read_dxf_blocks(folder / "pattern.dxf").values():
        (line,) = (geometry for geometry in layers["1"] if geometry.geom_type != "Point")
        yield shapely.Polygon(shapely.get_coordinates(line))


def test_what_lies_on_itself_by_rounding_only_touches():
    flat = flatten(*grid(3, 3, lambda u, v: (u, v, 0 * u)))
    assert find_overlap(flat, 0, spiral(1e-12), 1.0) is None
    found = find_overlap(flat, 0, spiral(0.5), 1.0)
    assert found is not None
    assert found.width == pytest.approx(0.5, rel=0.02)


@pytest.mark.parametrize("outline", ["fair", "exact"])
def test_a_small_overlap_is_cut_in_the_middle(tmp_path, outline):
    mesh = open_cone(0.02)
    flat = flatten(*mesh)
    assert flat.report.overlapping_pieces == 1
    made = make_patterns(
        *mesh,
        folder=tmp_path,
        formats=["dxf"],
        outline=outline,
        weld_distance=1e-6,
        seam_allowance=0,
        notch_spacing=0,
    )
    (note,) = made.notes
    width, *place = map(float, re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", note.removeprefix("Piece 1"))[:4])
    assert "cut in the middle between the two sides" in note
    assert 1 < width < 6
    # The place is at the slit, on the positive x axis of the model.
    assert place[0] > 150
    assert abs(place[1]) < 20
    (polygon,) = cut_polygons(tmp_path)
    assert polygon.is_valid
    exact = shapely.unary_union(shapely.polygons(flat.vertices[flat.faces]))
    assert polygon.area == pytest.approx(exact.area, rel=2e-3)
    (seam,) = json.loads((tmp_path / "pattern.json").read_text())["seams"]
    assert seam["sides"][0]["length"] == pytest.approx(seam["sides"][1]["length"], abs=0.05)


def test_sides_that_are_not_sewn_together_never_end_on_each_other(tmp_path):
    made = make_patterns(
        *open_cone(0.02), folder=tmp_path, formats=["dxf"], outline="exact", seam_allowance=0
    )
    assert "overlaps itself by 3.53 mm" in made.notes[0]
    assert all(polygon.is_valid for polygon in cut_polygons(tmp_path))


@pytest.mark.parametrize("outline", ["fair", "exact"])
def test_a_slit_whose_sides_touch_stays_a_slit(tmp_path, outline):
    positions, faces = grid(21, 21, lambda u, v: (200 * u, 200 * v, 0 * u))
    slit = [10 + 21 * row for row in range(6)]  # from the border up to 60 mm
    middles = positions[faces].mean(axis=1)
    copies = np.arange(len(positions))
    copies[slit] = len(positions) + np.arange(6)
    faces = np.where(middles[:, :1] > 100, copies[faces], faces)
    positions = np.vstack([positions, positions[slit]])
    made = make_patterns(
        positions, faces, folder=tmp_path, formats=["dxf"], outline=outline, seam_allowance=0
    )
    assert made.notes == ()
    (polygon,) = cut_polygons(tmp_path)
    assert polygon.area == pytest.approx(200 * 200, rel=1e-4)
    assert polygon.length == pytest.approx(800 + 2 * 60, abs=0.1)
    (seam,) = made.seams
    assert seam.lengths == pytest.approx((60, 60), abs=0.05)


def test_a_wide_overlap_splits_the_piece_with_a_seam(tmp_path):
    made = make_patterns(*ramp(), folder=tmp_path, unit=100, formats=["dxf"])
    (note,) = made.notes
    assert re.match(r"Piece 1 overlaps itself by \d+(\.\d)? mm when it is laid flat, at \(", note)
    assert note.endswith("of the model: it is split with a seam into Piece 1, Piece 2.")
    polygons = list(cut_polygons(tmp_path))
    assert len(polygons) == 2
    assert all(polygon.is_valid for polygon in polygons)
    (seam,) = json.loads((tmp_path / "pattern.json").read_text())["seams"]
    assert {side["piece"] for side in seam["sides"]} == {"Piece 1", "Piece 2"}
    assert seam["sides"][0]["length"] == pytest.approx(seam["sides"][1]["length"], abs=0.05)
    assert seam["sides"][0]["length"] < 150  # across, and not along


def test_a_piece_that_winds_three_times_is_split_until_no_part_overlaps(tmp_path):
    made = make_patterns(*ramp(18.0), folder=tmp_path, unit=100, formats=["dxf"], piece_names=["stair"])
    assert made.piece_names[0] == "stair 1"
    assert len(made.piece_names) >= 3
    areas = [polygon.area for polygon in cut_polygons(tmp_path)]
    assert len(areas) == len(made.piece_names)


def test_flat_pieces_that_overlap_widely_are_refused_with_the_place_and_a_way_round(tmp_path):
    """Where there is no mesh any more to be split."""
    with pytest.raises(
        PatternError, match=r"Piece 1 overlaps itself by .* at \(.*cut the panel in two there"
    ):
        write_patterns(flatten(*ramp()), tmp_path)
    assert not list(tmp_path.iterdir())
