# SPDX-License-Identifier: GPL-3.0-or-later
"""Patterns, read back from their files by other libraries than those that wrote them."""

from __future__ import annotations

import itertools
import json
import re
from pathlib import Path

import ezdxf
import numpy as np
import pattern_readers as readers
import pytest
import reference_measures as reference
import shapely
from ezdxf import bbox
from meshlab_developable import FilterError, InvalidParameterError, PatternError, make_developable
from meshlab_developable.patterns import PAPERS, make_patterns
from meshlab_developable.patterns.pdf import tile_grid
from shapes import bump, grid, octahedron, two_bumps

PANTS = Path(__file__).parents[2] / "meshes" / "short_pants.obj"
SHEET = (700.0, 1000.0)
TOLERANCE = 0.05  # mm


def plate(hole=False):
    """A flat square of 100 units, with or without a square hole of 50."""
    positions, triangles = grid(9, 9, lambda u, v: (100 * u, 100 * v, 0 * u))
    middle = abs(positions[triangles].mean(axis=1) - (50, 50, 0)).max(axis=1) < 25
    return positions, triangles[~middle] if hole else triangles


@pytest.fixture(scope="module")
def pants(tmp_path_factory):
    """The pants made developable, in centimetres, as a pattern on sheets."""
    positions, triangles, _ = reference.read_obj(PANTS)
    developed = make_developable(positions, triangles).vertices
    folder = tmp_path_factory.mktemp("pants")
    made = make_patterns(
        developed,
        triangles,
        folder=folder,
        name="pants",
        unit="cm",
        sheet=SHEET,
        page="Letter",
        outline="exact",
    )
    return made, folder


@pytest.fixture(scope="module")
def side_file(pants):
    return json.loads((pants[1] / "pants.json").read_text())


@pytest.fixture(scope="module")
def blocks(pants):
    return readers.read_dxf_blocks(pants[1] / "pants.dxf")


def model_lengths(made):
    """Lengths in mm of the edges along each boundary of the model, in the order of the pieces' rings."""
    flat = made.flattening
    for loop in flat.loops:
        ring = flat.model_vertices[loop]
        yield int(flat.pieces[loop[0]]), 10 * np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1)


def test_files_and_sheets(pants):
    made, folder = pants
    names = {file.name for file in made.files}
    assert {"pants-1.svg", "pants-2.svg", "pants.pdf", "pants-Letter.pdf", "pants.dxf", "pants.json"} <= names
    assert {file.name for file in folder.iterdir()} == names
    assert set(made.sheets) == {SHEET}


def test_dxf_has_a_block_a_piece_with_closed_lines_on_the_standards_layers(pants, blocks):
    assert sorted(blocks) == ["PIECE_1", "PIECE_2", "PIECE_3", "PIECE_4"]
    for layers in blocks.values():
        assert set(layers) == {"1", "2", "3", "4", "7", "14", "15", "84", "87"}
        for layer in ("1", "14"):
            (line,) = (geometry for geometry in layers[layer] if geometry.geom_type != "Point")
            assert shapely.get_coordinates(line)[0] == pytest.approx(shapely.get_coordinates(line)[-1])
            assert shapely.Polygon(shapely.get_coordinates(line)).is_valid
        points = [shapely.get_coordinates(layers["14"])[:-1], cut_ring(layers)]
        marked = shapely.get_coordinates(layers["2"] + layers["3"])
        np.testing.assert_allclose(np.sort(marked, axis=0), np.sort(np.vstack(points), axis=0), atol=1e-5)


def sew_ring(layers):
    return shapely.get_coordinates(layers["14"][0])[:-1]


def cut_ring(layers):
    (line,) = (geometry for geometry in layers["1"] if geometry.geom_type != "Point")
    return shapely.get_coordinates(line)[:-1]


def cut_polygon(layers):
    return shapely.Polygon(cut_ring(layers))


def test_dxf_lengths_are_the_meshs(pants, blocks):
    made, _ = pants
    for number, lengths in model_lengths(made):
        ring = sew_ring(blocks[f"PIECE_{number + 1}"])
        steps = np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1)
        np.testing.assert_allclose(np.sort(steps), np.sort(lengths), atol=TOLERANCE)
        assert steps.sum() == pytest.approx(lengths.sum(), abs=TOLERANCE)


def test_the_allowance_is_as_wide_as_asked(blocks):
    for layers in blocks.values():
        sewn, cut = shapely.Polygon(sew_ring(layers)), cut_polygon(layers)
        assert cut.contains(sewn)
        distances = shapely.distance(shapely.points(shapely.get_coordinates(cut)), sewn)
        assert distances.min() == pytest.approx(10, abs=0.01)
        assert shapely.distance(sewn.exterior, cut.exterior) == pytest.approx(10, abs=0.01)


def test_seams_pair_edges_of_equal_length(side_file, blocks):
    assert len(side_file["seams"]) == 7
    assert sorted(seam["letter"] for seam in side_file["seams"]) == list("ABCDEFG")
    block_of = {piece["name"]: piece["dxf_block"] for piece in side_file["pieces"]}
    for seam in side_file["seams"]:
        lengths = []
        for side in seam["sides"]:
            ring = sew_ring(blocks[block_of[side["piece"]]])
            steps = np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1)
            lengths.append(steps[side["edges"]])
            assert lengths[-1].sum() == pytest.approx(side["length"], abs=1e-3)
        np.testing.assert_allclose(*lengths, atol=TOLERANCE)
        assert lengths[0].sum() == pytest.approx(lengths[1].sum(), abs=TOLERANCE)


def test_notches_are_at_equal_arc_lengths(side_file, blocks):
    """Every notch of the DXF is looked up on its sew line; along a seam both sides have them alike."""
    block_of = {piece["name"]: piece["dxf_block"] for piece in side_file["pieces"]}
    found = 0
    for seam in side_file["seams"]:
        arcs = []
        for side in seam["sides"]:
            layers = blocks[block_of[side["piece"]]]
            ring = sew_ring(layers)
            after = [(edge + 1) % len(ring) for edge in side["edges"]]
            order = [*side["edges"], after[-1]] if not side["backwards"] else [after[0], *side["edges"]]
            line = shapely.LineString(ring[order])
            near = [notch for notch in layers["4"] if shapely.distance(notch, line) < 10.001]
            on_seam = [n for n in near if shapely.distance(n, shapely.LinearRing(ring)) > 9.99]
            arcs.append(np.sort([shapely.line_locate_point(line, notch) for notch in on_seam]))
            arcs[-1] = arcs[-1][(arcs[-1] > 1) & (arcs[-1] < line.length - 1)]
            np.testing.assert_allclose(arcs[-1], np.sort(side["notches_at"]), atol=TOLERANCE)
        np.testing.assert_allclose(*arcs, atol=TOLERANCE)
        found += len(arcs[0])
        assert abs(arcs[0].mean() - line.length / 2) > 5  # fits one way round only
    assert found >= 12
    assert 2 * found == sum(len(layers["4"]) for layers in blocks.values())


def test_both_sides_of_a_seam_have_its_letter(side_file, pants):
    texts = readers.read_dxf_texts(pants[1] / "pants.dxf")
    for seam in side_file["seams"]:
        assert texts["15"].count(seam["letter"]) == 2
    for piece in side_file["pieces"]:
        assert texts["15"].count(piece["name"]) == 1
        assert f"Piece Name: {piece['name']}" in texts["1"]
    assert "Units: METRIC" in texts["1"]


def require_texts_apart(file):
    for block in ezdxf.readfile(file).blocks:
        boxes = [bbox.extents([text]) for text in block.query("TEXT")]
        drawn = [shapely.box(*box.extmin.vec2, *box.extmax.vec2) for box in boxes]
        assert not any(one.intersects(other) for one, other in itertools.combinations(drawn, 2))


def test_texts_that_programs_read_lie_below_those_for_people(pants):
    require_texts_apart(pants[1] / "pants.dxf")


def test_letters_of_short_darts_lie_apart(tmp_path):
    positions, faces = grid(31, 31, lambda u, v: (240 * u, 240 * v, 0 * u))
    middles = positions[faces].mean(axis=1)
    for column in (14, 15, 16):  # a slit of one edge, 8 mm, from the border
        right = (faces == column) & (middles[:, :1] > positions[column, 0])
        faces = np.where(right, len(positions), faces)
        positions = np.vstack([positions, positions[column]])
    made = make_patterns(positions, faces, folder=tmp_path, formats=["dxf"])
    assert len(made.seams) == 3
    require_texts_apart(tmp_path / "pattern.dxf")


def test_the_grain_line_stands_upright(blocks):
    for layers in blocks.values():
        (line,) = layers["7"]
        (x0, y0), (x1, y1) = shapely.get_coordinates(line)
        assert x0 == pytest.approx(x1)
        assert y1 - y0 > 20
        assert shapely.Polygon(sew_ring(layers)).contains(line)


def placed_on_sheets(side_file):
    """The cut pieces where they lie, by their sheet's number."""
    placed = {1: [], 2: []}
    for piece in side_file["pieces"]:
        ring = np.array(piece["cut_lines"][0])
        angle = np.radians(piece["turned_degrees"])
        turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
        placed[piece["sheet"]].append(shapely.Polygon(ring @ turn + piece["shifted"]))
    return placed


def test_pieces_lie_apart_on_their_sheets(side_file, blocks):
    for piece in side_file["pieces"]:
        assert piece["turned_degrees"] in (0, 180)
        ring = shapely.Polygon(piece["cut_lines"][0])
        assert ring.equals_exact(cut_polygon(blocks[piece["dxf_block"]]), 1e-3)
    for shapes in placed_on_sheets(side_file).values():
        assert shapes
        for index, shape in enumerate(shapes):
            assert shapely.box(0, 0, *SHEET).contains(shape)
            assert all(shape.distance(other) >= 5 for other in shapes[:index])


def test_inserts_put_the_blocks_apart(pants, blocks):
    inserts = readers.read_dxf_inserts(pants[1] / "pants.dxf")
    assert sorted(inserts) == sorted(blocks)
    shapes = [
        shapely.affinity.translate(
            shapely.affinity.rotate(cut_polygon(blocks[name]), angle, origin=(0, 0)), point.x, point.y
        )
        for name, (point, angle) in inserts.items()
    ]
    assert all(one.distance(other) >= 5 for i, one in enumerate(shapes) for other in shapes[:i])


def test_svg_is_in_millimetres(pants):
    made, folder = pants
    pieces = {}
    for sheet in (1, 2):
        pieces |= readers.read_svg(folder / f"pants-{sheet}.svg")
    checked = 0
    for number, lengths in model_lengths(made):
        paths = pieces[f"Piece_{number + 1}"]
        (boundary,), (sewn,) = paths["boundary"], paths["sew"]
        points = readers.svg_points(sewn)
        assert np.allclose(points[0], points[-1])
        assert readers.length(points) == pytest.approx(lengths.sum(), abs=TOLERANCE)
        assert shapely.Polygon(readers.svg_points(boundary)).contains(shapely.Polygon(points))
        assert len(paths["notch"]) >= 4
        checked += 1
    assert checked == 4


def test_the_pieces_show_their_outside_in_every_format(pants, blocks):
    """y goes down in SVG: a piece that is drawn the right way round there goes round the other way."""
    _, folder = pants
    svg = readers.read_svg(folder / "pants-1.svg")
    for name, paths in svg.items():
        if not name.startswith("Piece"):
            continue
        in_svg = readers.svg_points(paths["sew"][0])[:-1] * (1, -1)
        in_dxf = sew_ring(blocks[name.upper()])
        in_svg, in_dxf = (points - points.mean(axis=0) for points in (in_svg, in_dxf))
        turned = [np.abs(in_svg * sign - in_dxf).max() for sign in (1, -1)]
        assert min(turned) < 1e-3


def test_pdf_is_in_true_size(pants):
    made, folder = pants
    pages = readers.read_pdf(folder / "pants.pdf")
    assert len(pages) == len(made.sheets)
    dashed = [
        readers.length(line)
        for page in pages
        for line, dashes in zip(page["lines"], page["dashed"], strict=True)
        if dashes
    ]
    expected = [lengths.sum() for _, lengths in model_lengths(made)]
    # The closing line goes back to the first point without naming it.
    closings = [lengths.max() for _, lengths in model_lengths(made)]
    for found, whole, edge in zip(sorted(dashed), sorted(expected), closings, strict=True):
        assert whole - edge - 10 < found <= whole + TOLERANCE
    for page in pages:
        assert page["size"] == pytest.approx(SHEET, abs=0.01)


def test_the_square_measures_ten_centimetres(pants):
    _, folder = pants
    squares = [
        np.ptp(line, axis=0)
        for page in readers.read_pdf(folder / "pants.pdf")
        for line in page["lines"]
        if len(line) in (4, 5) and np.ptp(line, axis=0) == pytest.approx((100, 100), abs=TOLERANCE)
    ]
    assert len(squares) == 1
    (cover, *_) = readers.read_pdf(folder / "pants-Letter.pdf")
    assert any(np.ptp(line, axis=0) == pytest.approx((100, 100), abs=TOLERANCE) for line in cover["lines"])


def test_tiles_are_pages_of_the_paper_that_cover_the_pieces(pants, side_file):
    _, folder = pants
    cover, *tiles = readers.read_pdf(folder / "pants-Letter.pdf")
    assert cover["size"] == pytest.approx((215.9, 279.4), abs=0.01)
    assert all(sorted(tile["size"]) == pytest.approx((215.9, 279.4), abs=0.01) for tile in tiles)
    width, height = (side - 20 for side in tiles[0]["size"])
    columns, rows = (
        next(n for n in range(1, 99) if n * (window - 15) + 15 >= side)
        for window, side in zip((width, height), SHEET, strict=True)
    )
    shown = [re.search(r"(?:sheet (\d) of 2), tile (\w)(\d)", tile["text"]).groups() for tile in tiles]
    assert len(set(shown)) == len(tiles) <= 2 * columns * rows
    windows = {"1": [], "2": []}
    for sheet, row, column in shown:
        x, y = (int(column) - 1) * (width - 15), (rows - 1 - "ABCDEFGH".index(row)) * (height - 15)
        windows[sheet].append(shapely.box(x, y, x + width, y + height))
    for sheet, shapes in placed_on_sheets(side_file).items():
        assert shapely.union_all(windows[str(sheet)]).buffer(1e-6).contains(shapely.union_all(shapes))
    # Laid on top of each other by the overlap, neighbours have crosses at the same points.
    left = next(i for i in range(len(shown)) if shown[i + 1] == (*shown[i][:2], str(int(shown[i][2]) + 1)))
    marks = [
        np.array(
            [line.mean(axis=0) for line in tile["crosses"] if abs(np.ptp(line, axis=0).max() - 8) < 0.01]
        )
        for tile in tiles[left : left + 2]
    ]
    apart = np.linalg.norm(marks[0][:, None] - (marks[1] + (width - 15, 0)), axis=2)
    assert (apart.min(axis=1) < 0.01).sum() == 4  # two crosses of two lines


def test_rows_of_tiles_beyond_the_26th_have_names_of_their_own():
    grid = tile_grid((250, 5000), PAPERS["A4"])
    names = [grid.name(0, row) for row in reversed(range(grid.rows))]
    assert len(names) > 27
    assert names[:1] + names[25:28] == ["A1", "Z1", "AA1", "AB1"]
    assert len(set(names)) == len(names)


def test_corners_of_the_allowance_are_those_of_parallels(tmp_path):
    make_patterns(*plate(), folder=tmp_path, seam_allowance=10, formats=["dxf"])
    (layers,) = readers.read_dxf_blocks(tmp_path / "pattern.dxf").values()
    assert cut_polygon(layers).area == pytest.approx(120**2)
    assert shapely.Polygon(sew_ring(layers)).area == pytest.approx(100**2)


def test_a_hole_is_a_cutout_and_has_its_allowance_inside(tmp_path):
    make_patterns(*plate(hole=True), folder=tmp_path, seam_allowance=10, formats=["dxf"])
    (layers,) = readers.read_dxf_blocks(tmp_path / "pattern.dxf").values()
    (cutout,) = layers["11"]
    assert shapely.Polygon(shapely.get_coordinates(cutout)).area == pytest.approx(30**2)
    areas = sorted(shapely.Polygon(shapely.get_coordinates(line)).area for line in layers["14"])
    assert areas == pytest.approx([50**2, 100**2])


def ring_with_a_slit(inner):
    """A flat ring of 100 mm width, cut open by a slit that its seam allowance fills."""

    def surface(u, v):
        radius, turn = inner + 100 * v, 0.999 * 2 * np.pi * u
        return radius * np.cos(turn), radius * np.sin(turn), 0 * u

    return grid(97, 9, surface)


def test_the_opening_of_a_ring_with_a_slit_stays_open(tmp_path):
    make_patterns(*ring_with_a_slit(60), folder=tmp_path, seam_allowance=10, formats=["dxf", "svg"])
    (layers,) = readers.read_dxf_blocks(tmp_path / "pattern.dxf").values()
    (cutout,) = layers["11"]
    assert shapely.Polygon(shapely.get_coordinates(cutout)).area == pytest.approx(np.pi * 50**2, rel=0.02)
    assert cut_polygon(layers).area == pytest.approx(np.pi * 170**2, rel=0.01)
    (drawn,) = readers.read_svg(tmp_path / "pattern.svg")["Piece_1"]["cutout"]
    assert np.ptp(readers.svg_points(drawn), axis=0) == pytest.approx((100, 100), abs=1)


def test_an_opening_too_narrow_to_cut_is_none(tmp_path):
    make_patterns(*ring_with_a_slit(10.3), folder=tmp_path, seam_allowance=10, formats=["dxf"])
    (layers,) = readers.read_dxf_blocks(tmp_path / "pattern.dxf").values()
    assert "11" not in layers


def test_without_an_allowance_both_lines_are_one(tmp_path, caplog):
    made = make_patterns(*two_bumps(), folder=tmp_path, unit=300, seam_allowance=0, formats=["dxf"])
    for layers in readers.read_dxf_blocks(tmp_path / "pattern.dxf").values():
        assert cut_polygon(layers).equals_exact(shapely.Polygon(sew_ring(layers)), 1e-6)
        notches = shapely.points(np.array([notch.coords[0][:2] for notch in layers["4"]]))
        assert len(notches) == len(made.seams[0].notches)
        assert shapely.distance(notches, cut_polygon(layers).exterior).max() < 1e-6
    assert not caplog.records  # the libraries have nothing to complain of


def test_names_that_dxf_can_not_have_give_blocks_of_their_own(tmp_path):
    names = ("袖", "背")
    made = make_patterns(*two_bumps(), folder=tmp_path, unit=300, piece_names=names)
    blocks = readers.read_dxf_blocks(tmp_path / "pattern.dxf")
    pieces = json.loads((tmp_path / "pattern.json").read_text(encoding="utf-8"))["pieces"]
    assert [piece["name"] for piece in pieces] == list(names)
    assert {piece["dxf_block"] for piece in pieces} == set(blocks)
    assert len(blocks) == 2
    assert set(names) < set(readers.read_svg(tmp_path / "pattern.svg"))
    assert any("PDF has no letters for 袖, 背" in note for note in made.notes)


def test_lines_of_the_model_are_on_the_pieces_that_they_run_over(tmp_path):
    """A line across the seam of two sheets, along a row of their grids."""
    positions, triangles = two_bumps()
    row = positions[5 * 13 : 6 * 13]  # of the one, from the seam on
    line = np.vstack([(row * (-1, 1, 1))[::-1], row[1:]])
    make_patterns(
        positions, triangles, folder=tmp_path, unit=300, internal_lines=[line], formats=["dxf", "svg"]
    )
    for layers in readers.read_dxf_blocks(tmp_path / "pattern.dxf").values():
        (drawn,) = layers["8"]
        steps = np.linalg.norm(np.diff(row, axis=0), axis=1)
        assert drawn.length == pytest.approx(300 * steps.sum(), rel=0.03)
        assert len(drawn.coords) == 13
        assert cut_polygon(layers).contains(drawn)
    paths = readers.read_svg(tmp_path / "pattern.svg")
    assert len(paths["Piece_1"]["internal"]) == len(paths["Piece_2"]["internal"]) == 1


def test_the_grain_that_is_asked_for_stands_upright(tmp_path):
    positions, triangles = plate()
    grain = np.array((3.0, 4.0, 0.0))
    make_patterns(
        positions, triangles, folder=tmp_path, grain=tuple(grain), formats=["dxf"], seam_allowance=0
    )
    (layers,) = readers.read_dxf_blocks(tmp_path / "pattern.dxf").values()
    ring = sew_ring(layers)
    corners = ring[np.argsort(((ring - ring.mean(axis=0)) ** 2).sum(axis=1))[-4:]]
    # The square's edges make the angles with the upright that they made with the grain.
    sides = corners - corners[np.argmin(corners[:, 1])]
    steepest = max(abs(y) / np.hypot(x, y) for x, y in sides if 99 < np.hypot(x, y) < 101)
    assert steepest == pytest.approx(4 / 5, abs=1e-9)


def test_notches_of_a_narrow_dart_are_at_the_dart(tmp_path):
    """Where the allowances of a dart's legs meet there is no cut line near: the sew line has the notch."""

    def cone(u, v):
        radius, turn = 20 + 180 * v, 2 * np.pi * u
        return radius * np.cos(turn), radius * np.sin(turn), radius * np.sqrt((36 / 35) ** 2 - 1)

    make_patterns(*grid(49, 10, cone), folder=tmp_path, weld_distance=1e-6, notch_spacing=30, formats=["dxf"])
    (layers,) = readers.read_dxf_blocks(tmp_path / "pattern.dxf").values()
    (seam,) = json.loads((tmp_path / "pattern.json").read_text())["seams"]
    ring = sew_ring(layers)
    on_seam = []
    for side in seam["sides"]:
        first, last = (side["edges"][index] for index in (0, -1))
        starts = ring[first + side["backwards"] - len(ring)], ring[last + 1 - side["backwards"] - len(ring)]
        line = shapely.LineString(starts)  # the legs are straight
        on_seam += [line.interpolate(distance) for distance in side["notches_at"]]
    assert len(on_seam) == len(layers["4"]) >= 10
    for notch in layers["4"]:
        assert min(shapely.distance(notch, point) for point in on_seam) < 30
    sewn = shapely.LinearRing(ring)
    assert 2 <= sum(shapely.distance(notch, sewn) < 1e-6 for notch in layers["4"]) < len(on_seam)


@pytest.mark.parametrize(
    ("mesh", "options", "error", "words"),
    [
        (octahedron(), {}, FilterError, "closed"),
        ((np.zeros((3, 3)), [[0, 1, 2]]), {}, FilterError, "no area"),
        (bump(), {"unit": 0}, InvalidParameterError, "unit is 0"),
        (bump(), {"unit": "yard"}, InvalidParameterError, "'mm', 'cm'"),
        (bump(), {"unit": float("inf")}, InvalidParameterError, "unit"),
        (plate(), {"sheet": (110, 110)}, PatternError, "Piece 1 is larger than a sheet of 110 x 110 mm"),
        (plate(), {"sheet": (0, 110)}, InvalidParameterError, "sheet"),
        (plate(), {"seam_allowance": -1}, InvalidParameterError, "seam_allowance"),
        (plate(), {"page": "A9"}, InvalidParameterError, "page"),
        (plate(), {"formats": ["doc"]}, InvalidParameterError, "formats"),
        (plate(), {"grain": (0, 0, 0)}, InvalidParameterError, "grain"),
        (plate(), {"piece_names": ["a", "b"]}, PatternError, "2 names were given for 1 piece"),
        (plate(), {"name": "../up"}, InvalidParameterError, "name"),
        (plate(), {"internal_lines": [[(0, 0, 0), (1, 1, 0)]]}, PatternError, "point 2 is no vertex"),
        (plate(), {"internal_lines": [[(0, 0, 0), (50, 50, 0)]]}, PatternError, "no edge from its point 1"),
        (plate(), {"internal_lines": [[(0, 0, 0)]]}, PatternError, "at least two"),
        (plate(), {"unit": "m"}, PatternError, "a page of PDF"),
    ],
)
def test_bad_input_leaves_nothing_behind(tmp_path, mesh, options, error, words):
    with pytest.raises(error, match=words):
        make_patterns(*mesh, folder=tmp_path / "out", **options)
    assert not list(tmp_path.rglob("*.*"))
