# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable flatten` and `developable pattern`."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from click.testing import CliRunner
from meshlab_developable import flatten
from meshlab_developable.command_line import main
from shapes import octahedron

MESHES = Path(__file__).parents[2] / "meshes"
SHEET, PANTS = MESHES / "sheet_bent.ply", MESHES / "short_pants.ply"


def developable(*arguments: object):
    return CliRunner().invoke(main, list(map(str, arguments)), prog_name="developable")


def read(path: Path) -> pymeshlab.MeshSet:
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes


def test_flatten_writes_the_pieces_and_says_how_well_they_keep_their_lengths(tmp_path):
    result = developable("flatten", PANTS, "-o", tmp_path / "flat.ply", "--json")
    assert result.exit_code == 0, result.output
    printed = json.loads(result.output)
    expected = flatten(PANTS)
    assert printed["pieces"] == 4
    assert printed["seams"] == 7
    assert printed["mean_edge_strain"] == pytest.approx(expected.report.mean_edge_strain, rel=1e-12)
    written = read(tmp_path / "flat.ply")
    np.testing.assert_allclose(written.current_mesh().vertex_matrix()[:, :2], expected.vertices, atol=1e-12)


def test_flatten_writes_texture_coordinates_when_asked(tmp_path):
    result = developable("flatten", SHEET, "-o", tmp_path / "flat.ply", "--textured", tmp_path / "model.obj")
    assert result.exit_code == 0, result.output
    model, flat = read(tmp_path / "model.obj"), read(tmp_path / "flat.ply")
    corners = flat.current_mesh().vertex_matrix()[flat.current_mesh().face_matrix()].reshape(-1, 3)[:, :2]
    texture = model.current_mesh().wedge_tex_coord_matrix()
    size = np.ptp(corners, axis=0).max()
    np.testing.assert_allclose(texture * size, corners - corners.min(axis=0), atol=1e-5 * size)


def test_flatten_ends_with_3_when_a_piece_overlaps_itself(tmp_path):
    turns = np.linspace(0, 9, 60)
    inner, outer = (np.stack([r * np.cos(turns), r * np.sin(turns), turns / 50], axis=1) for r in (1, 2))
    faces = [(i, i + 60, i + 1) for i in range(59)] + [(i + 1, i + 60, i + 61) for i in range(59)]
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(np.vstack([inner, outer]), np.array(faces)))
    meshes.save_current_mesh(str(tmp_path / "ramp.ply"))
    result = developable("flatten", tmp_path / "ramp.ply", "-o", tmp_path / "flat.ply", "--json")
    assert result.exit_code == 3, result.output
    assert json.loads(result.output)["overlapping_pieces"] == 1
    assert (tmp_path / "flat.ply").exists()
    result = developable("pattern", tmp_path / "ramp.ply", "-o", tmp_path / "out", "--unit", "cm")
    assert result.exit_code == 0, result.output
    assert "overlaps itself" in result.output
    assert "split with a seam into Piece 1, Piece 2" in result.output


def test_pattern_writes_what_it_names(tmp_path):
    arguments = "--json --unit cm --sheet 1400x900 --grain z --turns none --format dxf --piece-name sheet"
    result = developable("pattern", SHEET, "-o", tmp_path / "out", *arguments.split(" "))
    assert result.exit_code == 0, result.output
    printed = json.loads(result.output)
    names = ["sheet_bent.dxf", "sheet_bent.json"]
    assert [Path(file).name for file in printed["files"]] == names
    assert sorted(file.name for file in (tmp_path / "out").iterdir()) == names
    assert printed["sheet_sizes_mm"] == [[1400, 900]]
    assert printed["max_edge_strain"] < 1e-4
    (piece,) = json.loads((tmp_path / "out" / "sheet_bent.json").read_text())["pieces"]
    assert piece["name"] == "sheet"


def test_pattern_warns_of_panels_that_are_not_developable(tmp_path):
    options = "--unit cm --format dxf --json --max-strain 20"
    result = developable("pattern", PANTS, "-o", tmp_path / "out", *options.split(" "))
    assert result.exit_code == 0, result.output
    printed = json.loads(result.output)
    strain, mismatch, ease = printed["notes"]
    assert re.match(r"Laid flat, edges change by up to 1\d %, 1\.\d %", strain)
    assert "make the panels developable first" in strain
    assert re.fullmatch(r"The sides of a seam differ by up to \d+(\.\d)? mm\.", mismatch)
    said = re.findall(r"([A-G]) (\S+) % \((\S+) mm of (.+?) to (\S+) mm of (.+?)\)", ease)
    assert len(said) > 2
    for letter, per_cent, longer, _, shorter, _ in said:
        assert float(per_cent) == pytest.approx(printed["seam_ease_percent"][letter], rel=0.06)
        assert float(per_cent) == pytest.approx(
            100 * (float(longer) / float(shorter) - 1), rel=0.06, abs=0.05
        )


def test_pattern_refuses_panels_that_are_strained_too_much_and_says_where(tmp_path):
    names = [option for name in "abcd" for option in ("--piece-name", name)]
    result = developable("pattern", PANTS, "-o", tmp_path / "out", "--unit", "cm", *names)
    assert result.exit_code == 2
    assert not (tmp_path / "out").exists()
    flat = flatten(PANTS)
    worst = flat.edge_strain.argmax()
    number, strain = flat.pieces[worst] + 1, 100 * flat.report.max_edge_strain
    place = ", ".join(f"{x:.4g}" for x in flat.model_vertices[worst])
    assert f"Piece {number} ({'abcd'[number - 1]}) can't be laid flat" in result.output
    assert f"an edge at ({place}) of the model by {strain:.0f} % of its length" in result.output
    assert "4 of 4 pieces are above the limit of 5 %" in result.output


def test_pattern_asks_for_the_unit_and_says_how_large_the_model_would_be(tmp_path):
    result = developable("pattern", SHEET, "-o", tmp_path / "out")
    assert result.exit_code == 2
    assert not (tmp_path / "out").exists()
    box = read(SHEET).current_mesh().bounding_box()
    size = " x ".join(f"{side:.4g}" for side in box.max() - box.min())
    for unit in ("mm", "cm", "m", "inches"):
        assert f"{size} {unit}" in result.output
    assert "--unit" in result.output


def test_pattern_says_in_words_what_it_wrote(tmp_path):
    options = ["--unit", "cm", "--page", "none", "--name", "a sheet"]
    result = developable("pattern", SHEET, "-o", tmp_path / "out", *options)
    assert result.exit_code == 0, result.output
    assert "a sheet.svg" in result.output
    assert sorted(file.suffix for file in (tmp_path / "out").iterdir()) == [".dxf", ".json", ".pdf", ".svg"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("--unit parsec", "'parsec' is neither a length"),
        ("--unit 0", "unit is 0"),
        ("--sheet 10", "like 1400x2000"),
        ("--unit mm --sheet 12x14", "larger than a sheet of 12 x 14 mm"),
        ("--grain w", "neither x, y or z"),
        ("--unit cm --seam-allowance -3", "seam_allowance is -3"),
        ("--unit cm --max-strain -1", "max_strain is -1"),
        ("--unit cm --weld-distance -3", "finite length"),
    ],
)
def test_bad_options_end_with_2_and_leave_nothing(tmp_path, options, words):
    result = developable("pattern", SHEET, "-o", tmp_path / "out", *options.split())
    assert result.exit_code == 2
    assert words in result.output
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("command", ["flatten", "pattern"])
def test_a_closed_surface_ends_with_2(tmp_path, command):
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*octahedron()))
    meshes.save_current_mesh(str(tmp_path / "closed.ply"))
    unit = ["--unit", "cm"] if command == "pattern" else []
    result = developable(command, tmp_path / "closed.ply", "-o", tmp_path / "out.ply", "--json", *unit)
    assert result.exit_code == 2
    assert "closed" in result.output
    assert not (tmp_path / "out.ply").exists()
