# SPDX-License-Identifier: GPL-3.0-or-later
"""A material of one's own whose directions differ, from its file to the pattern, on every way."""

from __future__ import annotations

import json
import os

import numpy as np
import numpy.typing as npt
import pymeshlab
import pytest
from click.testing import CliRunner
from meshlab_developable import cut_into_panels, flatten, make_developable, materials
from meshlab_developable.command_line import main
from meshlab_developable.errors import FilterError, InvalidParameterError
from shapes import bump

STIFF, SOFT, BIAS = 0.3, 3.0, 1.5  # per cent
BOUNDS = {"warp": STIFF, "weft": SOFT, "bias": BIAS}
TWILL = {"name": "Twill", "stretch": BOUNDS, "compression": BOUNDS, "source": "measured in June"}


@pytest.fixture
def twill(tmp_path):
    path = tmp_path / "ours.json"
    path.write_text(json.dumps({"materials": [TWILL]}), encoding="utf-8")
    return f"{path}#Twill"


@pytest.fixture
def bump_file(tmp_path):
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*bump()))
    meshes.save_current_mesh(str(tmp_path / "bump.ply"))
    return tmp_path / "bump.ply"


def developable(*arguments: object):
    return CliRunner().invoke(main, list(map(str, arguments)), prog_name="developable")


def maps(shaped, flat, faces) -> npt.NDArray[np.float64]:
    """Of each triangle the linear map from the pattern to the model, m x 3 x 2."""
    x, u = shaped[faces], flat[faces]
    edges_x = np.stack([x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]], axis=2)
    edges_u = np.stack([u[:, 1] - u[:, 0], u[:, 2] - u[:, 0]], axis=2)
    return edges_x @ np.linalg.inv(edges_u)


def greatest_strains(shaped, flat, faces, grain) -> tuple[float, float, float]:
    """Along the direction of the pattern that runs most nearly along one on the model, across it, and at
    45 degrees on both sides; per cent."""
    f = maps(shaped, flat, faces)
    slope = (np.asarray(grain) @ f).mean(axis=0)
    warp = np.arctan2(slope[1], slope[0])

    def along(turn: float) -> float:
        lengths = np.linalg.norm(f @ [np.cos(warp + turn), np.sin(warp + turn)], axis=1)
        return float(100 * np.abs(lengths - 1).max())

    return along(0), along(np.pi / 2), max(along(np.pi / 4), along(-np.pi / 4))


@pytest.mark.parametrize("grain", [(1, 0, 0), (0, 1, 0), (1, 2, 0.3)])
def test_each_direction_keeps_its_own_bound(twill, grain):
    vertices, faces = bump()
    values = {"material": twill, "grain": grain}
    moved = make_developable(vertices, faces, **values)
    assert moved.report.developable
    flat = flatten(moved.vertices, faces, **values)
    warp, weft, bias = greatest_strains(moved.vertices, flat.vertices, faces, grain)
    assert warp < STIFF + 0.02
    assert STIFF + 0.1 < weft < SOFT + 0.02  # it uses what it may
    assert bias < BIAS + 0.02
    assert flat.report.max_stretch == pytest.approx(moved.report.max_stretch, abs=0.05)


@pytest.mark.parametrize(
    ("grain", "written", "of_pattern"), [("X axis", "x axis", "x"), ((1.0, 2.0, 0.3), "1,2,0.3", "1,2,0.3")]
)
def test_the_command_line_does_as_python_does(twill, bump_file, tmp_path, grain, written, of_pattern):
    arguments = ("--material", twill, "--grain", written)
    result = developable("global", bump_file, "-o", tmp_path / "moved.ply", *arguments, "--json")
    assert result.exit_code == 0, result.output
    expected = make_developable(bump_file, material=twill, grain=grain)
    printed = json.loads(result.output)
    assert printed["mean_displacement"] == pytest.approx(expected.report.mean_displacement, rel=1e-12)
    assert printed["mean_displacement"] > 0
    pattern = ("--unit", "cm", "--material", twill, "--grain", of_pattern, "--json", "--format", "dxf")
    result = developable("pattern", tmp_path / "moved.ply", "-o", tmp_path / "out", *pattern)
    assert result.exit_code == 0, result.output
    loose = flatten(expected.vertices, expected.faces)
    kept = flatten(expected.vertices, expected.faces, material=twill, grain=grain)
    strain = json.loads(result.output)["max_edge_strain"]
    assert strain == pytest.approx(kept.report.max_edge_strain, rel=1e-4)
    assert strain != pytest.approx(loose.report.max_edge_strain, rel=1e-2)


@pytest.mark.parametrize("grain", ["X axis", [1.0, 2.0, 0.3]])
def test_a_batch_takes_it_for_the_shape_and_for_the_pattern(twill, bump_file, tmp_path, grain):
    (tmp_path / "in").mkdir()
    bump_file.rename(tmp_path / "in" / "bump.ply")
    settings = tmp_path / "settings.toml"
    settings.write_text(
        f'[parameters]\nmaterial = "{twill}"\ngrain = {json.dumps(grain)}\n'
        '[patterns]\nunit = "cm"\nformats = ["dxf"]\n'
    )
    arguments = ("--out", tmp_path / "out", "--parameters", settings, "--workers", 1)
    result = developable("batch", tmp_path / "in", *arguments)
    assert result.exit_code == 0, result.output
    moved = tmp_path / "out" / "meshes" / "bump.ply"
    written = json.loads((tmp_path / "out" / "patterns" / "bump" / "bump.json").read_text())
    ring = np.array(written["pieces"][0]["sew_lines"][0])
    kept, loose = (flatten(moved, **values) for values in ({"material": twill, "grain": grain}, {}))
    length = np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1).sum()
    kept_length, loose_length = (boundary_length(flat) for flat in (kept, loose))
    assert abs(length - 10 * kept_length) < 0.1 * abs(length - 10 * loose_length)


def boundary_length(flat) -> float:
    ring = flat.vertices[flat.loops[0]]
    return float(np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1).sum())


def test_a_cut_takes_it(twill):
    vertices, faces = bump()
    stiff = cut_into_panels(vertices, faces, max_displacement=1e-3)
    soft = cut_into_panels(
        vertices, faces, max_displacement=1e-3, material=TWILL | {"stretch": 40, "compression": 40}
    )
    assert len(soft.report.panels) + soft.report.darts < len(stiff.report.panels) + stiff.report.darts


def test_nothing_of_it_is_left_behind(twill, monkeypatch):
    vertices, faces = bump(7, 7)
    make_developable(vertices, faces, material=twill)
    assert materials.OF_THE_USER not in os.environ
    monkeypatch.setenv(materials.OF_THE_USER, json.dumps(TWILL | {"stretch": 50, "compression": 50}))
    moved = make_developable(vertices, faces, material=TWILL)
    assert moved.report.max_displacement > 0
    assert json.loads(os.environ[materials.OF_THE_USER])["stretch"] == 50
    assert make_developable(vertices, faces).report.max_displacement == 0  # so it stands for Custom


def test_a_direction_of_ones_own_is_not_left_behind_and_gives_way_to_a_choice(monkeypatch):
    vertices, faces = bump()
    along = {
        grain: make_developable(vertices, faces, material=TWILL, grain=grain).vertices
        for grain in ("Longest seam", "X axis", (1, 2, 0.3))
    }
    assert materials.GRAIN_OF_THE_USER not in os.environ
    assert not np.allclose(along["X axis"], along[1, 2, 0.3], atol=1e-4)
    monkeypatch.setenv(materials.GRAIN_OF_THE_USER, "[2, 4, 0.6]")  # stands for the longest seam
    for grain, expected in (("Longest seam", along[1, 2, 0.3]), ("X axis", along["X axis"])):
        moved = make_developable(vertices, faces, material=TWILL, grain=grain)
        assert moved.vertices == pytest.approx(expected, abs=1e-9)
    for text in ("no json", "[1, 2]", "[0, 0, 0]", '["x", 0, 0]'):
        monkeypatch.setenv(materials.GRAIN_OF_THE_USER, text)
        with pytest.raises(FilterError, match="direction of the grain must be three numbers"):
            make_developable(vertices, faces, material=TWILL)


def test_what_the_variable_holds_is_refused_where_it_is_no_material(monkeypatch):
    vertices, faces = bump(7, 7)
    for text in ("no json", '{"name": "A", "stretch": "2", "compression": 0}', '{"name": "A"}'):
        monkeypatch.setenv(materials.OF_THE_USER, text)
        with pytest.raises(FilterError, match="no number for 'stretch'"):
            make_developable(vertices, faces)
    monkeypatch.setenv(materials.OF_THE_USER, '{"name": "A", "stretch": -1, "compression": 0}')
    with pytest.raises(FilterError, match="stretch must be from 0"):
        make_developable(vertices, faces)


def test_an_entry_is_checked_as_a_file_is():
    vertices, faces = bump(7, 7)
    with pytest.raises(InvalidParameterError, match="says no 'source'"):
        make_developable(vertices, faces, material={"name": "A", "stretch": 1, "compression": 1})
