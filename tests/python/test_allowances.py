# SPDX-License-Identifier: GPL-3.0-or-later
"""Allowances by class of edge and by piece, hems that fold back, symmetric pieces, and which way is up."""

from __future__ import annotations

import json

import ezdxf
import numpy as np
import pattern_readers as readers
import pytest
import shapely
from meshlab_developable import InvalidParameterError, PatternError
from meshlab_developable.patterns import make_patterns
from shapes import grid


def trapezium(lean=0.0, left=None):
    """A flat piece of 200 by 100, its sides leaning in by so much at the top."""
    left = lean if left is None else left
    return grid(9, 5, lambda u, v: (200 * u + v * (left * (1 - u) - lean * u), 100 * v, 0 * u))


def two_plates():
    """Two flat plates of 100 by 100 at a right angle, sewn together along an edge."""
    one, faces = grid(5, 5, lambda u, v: (100 * u, 100 * v, 0 * u))
    other, _ = grid(5, 5, lambda u, v: (0 * u, 100 * v, -100 * u))
    return np.vstack([one, other]), np.vstack([faces, faces[:, ::-1] + len(one)])


def shapes_of(folder, block=None):
    """Cut and sewn polygons of a piece."""
    blocks = readers.read_dxf_blocks(folder / "pattern.dxf")
    layers = blocks[block] if block else next(iter(blocks.values()))
    return tuple(
        shapely.Polygon(shapely.get_coordinates(next(g for g in layers[layer] if g.geom_type != "Point")))
        for layer in ("1", "14")
    )


def test_seams_and_hems_have_widths_of_their_own(tmp_path):
    make_patterns(*two_plates(), folder=tmp_path, seam_allowance=10, hem_allowance=30, formats=["dxf"])
    for block in ("PIECE_1", "PIECE_2"):
        cut, sewn = shapes_of(tmp_path, block)
        assert sewn.area == pytest.approx(100**2)
        sides = sorted(np.array([cut.bounds[k] - sewn.bounds[k] for k in range(4)]) * (-1, -1, 1, 1))
        assert sides == pytest.approx([10, 30, 30, 30])
        assert cut.area == pytest.approx(140 * 160)


def test_a_piece_has_an_allowance_of_its_own(tmp_path):
    options = {"piece_allowances": {"left": {"seam": 0, "hem": 0}}, "piece_names": ["left", "right"]}
    make_patterns(*two_plates(), folder=tmp_path, formats=["dxf"], **options)
    assert shapes_of(tmp_path, "LEFT")[0].area == pytest.approx(100**2)
    assert shapes_of(tmp_path, "RIGHT")[0].area == pytest.approx(120**2)


@pytest.mark.parametrize("lean", [30, -30])
def test_a_hem_folded_back_lies_on_the_piece(tmp_path, lean):
    """Where sides lean, the hem of a plain offset would stick out, or not reach the seam allowance."""
    positions, faces = trapezium(lean)
    other = positions * (-1, 1, 1) + (0.02 * lean, 0, 0) * positions[:, [1]]  # sewn to it along its left side
    mesh = np.vstack([positions, other]), np.vstack([faces, faces[:, ::-1] + len(positions)])
    make_patterns(
        *mesh, folder=tmp_path, seam_allowance=10, hem_allowance=25, formats=["dxf"], grain=(0, 1, 0)
    )
    cut, sewn = shapes_of(tmp_path, "PIECE_1")
    low, high = sewn.bounds[1], sewn.bounds[3]
    (x0, x1) = (cut.bounds[0] - 1, cut.bounds[2] + 1)
    for level, inside in ((low, 1), (high, -1)):
        hem = cut.intersection(
            shapely.box(x0, min(level, level - 25 * inside), x1, max(level, level - 25 * inside))
        )
        folded = shapely.transform(hem, lambda points, level=level: points * (1, -1) + (0, 2 * level))
        assert folded.area > 24 * 150
        assert (
            folded.difference(cut.buffer(1e-3)).area < 26 * 25
        )  # but at the outer side, a hem like any other


def test_the_hem_of_a_leaning_seam_is_its_mirror_image(tmp_path):
    test_a_hem_folded_back_lies_on_the_piece(tmp_path, 30)
    cut, sewn = shapes_of(tmp_path, "PIECE_1")
    low = sewn.bounds[1]
    # The seam's side: its cut line is 10 mm outside; below the fold it leans the other way.
    at = [
        [
            np.array(cut.intersection(shapely.LineString([(-999, y), (999, y)])).bounds)[[0, 2]]
            for y in (low + d, low - d)
        ]
        for d in (2, 12, 22)
    ]
    differences = np.array([[above[end] - below[end] for end in (0, 1)] for above, below in at])
    assert np.abs(differences).min(axis=1).max() < 0.05


def test_a_hem_runs_across_the_mouth_of_a_dart(tmp_path):
    """Where it would fold back at each leg, scraps would be cut out of it."""
    mesh = slit_cone()
    options = {"folder": tmp_path, "weld_distance": 1e-6, "formats": ["dxf"]}
    make_patterns(*mesh, **options, seam_allowance=10, hem_allowance=30)
    layers = next(iter(readers.read_dxf_blocks(tmp_path / "pattern.dxf").values()))
    cut, sewn = shapes_of(tmp_path)
    assert "11" not in layers
    assert cut.is_valid
    assert cut.contains(sewn)
    assert cut.buffer(0.5).contains(sewn.buffer(10, join_style="mitre", mitre_limit=3))
    assert cut.area < sewn.buffer(30.5, join_style="mitre").area


def slit_cone():
    """A cone whose flat piece has a dart from its border to its tip."""
    turns = np.linspace(0, 2 * np.pi, 61)
    ring = np.stack([150 * np.cos(turns), 150 * np.sin(turns), 0 * turns], axis=1)
    return np.vstack([[(0, 0, 30.0)], ring]), np.array([(0, 1 + i, 2 + i) for i in range(60)])


def test_mirrored_pieces_are_drawn_once_with_their_number(tmp_path):
    positions, faces = grid(9, 9, lambda u, v: (100 * u + 30 * v, 100 * v + 40 * u * v, 0 * u))
    pair = np.vstack([positions, positions * (-1, 1, 1) - (300, 0, 0)])
    mesh = pair, np.vstack([faces, faces[:, ::-1] + len(positions)])
    make_patterns(*mesh, folder=tmp_path, formats=["dxf", "svg"], copies="once")
    assert list(readers.read_dxf_blocks(tmp_path / "pattern.dxf")) == ["PIECE_1"]
    texts = readers.read_dxf_texts(tmp_path / "pattern.dxf")
    assert "Quantity: 1,1" in texts["1"]
    assert "cut 1 + 1 mirrored" in texts["15"]
    pieces = json.loads((tmp_path / "pattern.json").read_text())["pieces"]
    assert [piece["sheet"] for piece in pieces] == [1, None]
    make_patterns(*mesh, folder=tmp_path / "all", formats=["dxf"])
    assert len(readers.read_dxf_blocks(tmp_path / "all" / "pattern.dxf")) == 2


def test_copies_that_are_not_mirrored_are_told_apart(tmp_path):
    positions, faces = grid(9, 9, lambda u, v: (100 * u + 30 * v, 100 * v + 40 * u * v, 0 * u))
    mesh = np.vstack([positions, positions - (300, 0, 0)]), np.vstack([faces, faces + len(positions)])
    make_patterns(*mesh, folder=tmp_path, formats=["dxf"], copies="once")
    assert "Quantity: 2,0" in readers.read_dxf_texts(tmp_path / "pattern.dxf")["1"]


def test_a_symmetric_piece_is_cut_on_the_fold(tmp_path):
    make_patterns(*trapezium(30), folder=tmp_path, formats=["dxf", "pdf", "svg"], fold=True)
    layers = next(iter(readers.read_dxf_blocks(tmp_path / "pattern.dxf").values()))
    (fold,) = layers["6"]
    (x0, y0), (x1, y1) = shapely.get_coordinates(fold)
    assert x0 == pytest.approx(x1, abs=1e-3)
    assert abs(y1 - y0) == pytest.approx(120, abs=0.1)  # the piece and its allowances
    (boundary,) = (line for line in layers["1"] if line.geom_type != "Point")
    half = shapely.Polygon(shapely.get_coordinates(boundary))
    make_patterns(*trapezium(30), folder=tmp_path / "whole", formats=["dxf"])
    whole, _ = shapes_of(tmp_path / "whole")
    assert half.area == pytest.approx(whole.area / 2, rel=1e-3)
    assert abs(fold.distance(half.exterior)) < 1e-6
    assert "cut 1 on fold" in readers.read_dxf_texts(tmp_path / "pattern.dxf")["15"]


def test_a_piece_that_is_not_symmetric_is_not_folded(tmp_path):
    make_patterns(*trapezium(30, 10), folder=tmp_path, formats=["dxf"], fold=True)
    layers = next(iter(readers.read_dxf_blocks(tmp_path / "pattern.dxf").values()))
    assert "6" not in layers


@pytest.mark.parametrize("turn", [1, -1])
@pytest.mark.parametrize("axis", [1, 2])
def test_pieces_are_as_the_model_stands(tmp_path, turn, axis):
    """A trapezium that is narrower at its top, in a model that stands along y or z, or on its head."""
    positions, faces = trapezium(60)
    standing = np.zeros_like(positions)
    standing[:, 0], standing[:, axis] = positions[:, 0], turn * positions[:, 1]
    make_patterns(standing, faces, folder=tmp_path, formats=["dxf"])
    _, sewn = shapes_of(tmp_path)
    left, low, right, high = sewn.bounds
    widths = [
        sewn.intersection(shapely.LineString([(left - 1, y), (right + 1, y)])).length
        for y in (low + 5, high - 5)
    ]
    assert (widths[0] > widths[1]) == (turn > 0)
    assert abs(widths[0] - widths[1]) == pytest.approx(108, abs=1)


@pytest.mark.parametrize("outline", ["fair", "exact"])
def test_each_line_is_there_once_more_for_validation_and_each_of_its_points_is_marked(tmp_path, outline):
    positions, faces = grid(9, 9, lambda u, v: (100 * u, 100 * v + 15 * np.sin(np.pi * u), 0 * u))
    middle = abs(positions[faces].mean(axis=1)[:, :2] - (50, 61)).max(axis=1) < 12
    line = [row * 9 + 1 for row in range(2, 5)]
    make_patterns(
        positions,
        faces[~middle],
        folder=tmp_path,
        formats=["dxf"],
        outline=outline,
        internal_lines=[positions[line]],
    )
    document = ezdxf.readfile(tmp_path / "pattern.dxf")
    (block,) = (block for block in document.blocks if block.name == "PIECE_1")
    marked = {
        tuple(np.round(point.dxf.location, 6)) for point in block.query('POINT[layer=="2" | layer=="3"]')
    }

    def lines(layer):
        found = block.query(f'POLYLINE[layer=="{layer}"]')
        return [[tuple(np.round(point.dxf.location, 6)) for point in one.vertices] for one in found]

    for layer, check in (("1", "84"), ("8", "85"), ("11", "86"), ("14", "87")):
        assert lines(layer), layer
        assert lines(layer) == lines(check)
        assert {point for line in lines(layer) for point in line} <= marked


def test_no_tile_cuts_the_square(tmp_path):
    positions, faces = grid(9, 9, lambda u, v: (500 * u, 400 * v, 0 * u))
    make_patterns(positions, faces, folder=tmp_path, formats=["pdf"])
    pages = readers.read_pdf(tmp_path / "pattern-A4.pdf")
    squares = [
        number
        for number, page in enumerate(pages)
        for line in page["lines"]
        if np.ptp(line, axis=0) == pytest.approx((100, 100), abs=0.05)
    ]
    assert squares == [0]
    assert not any("must measure" in page["text"] for page in pages[1:])


@pytest.mark.parametrize(
    ("options", "error", "words"),
    [
        ({"hem_allowance": -1}, InvalidParameterError, "hem_allowance is -1"),
        ({"piece_allowances": {"Piece 1": {"seam": float("nan")}}}, InvalidParameterError, "Piece 1, seam"),
        ({"piece_allowances": {"Piece 1": {"zip": 3}}}, InvalidParameterError, "zip"),
        ({"piece_allowances": {"sleeve": {"seam": 3}}}, PatternError, "no piece sleeve"),
        ({"copies": "twice"}, InvalidParameterError, "copies"),
    ],
)
def test_bad_options_are_refused(tmp_path, options, error, words):
    with pytest.raises(error, match=words):
        make_patterns(*trapezium(), folder=tmp_path / "out", **options)
    assert not (tmp_path / "out").exists()
