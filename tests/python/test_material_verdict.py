# SPDX-License-Identifier: GPL-3.0-or-later
"""The verdict in a material's language is the same in the report as in the filter's log, and true."""

from __future__ import annotations

import json
import subprocess
import sys

import meshlab_developable
import numpy as np
import pyarrow.parquet
import pytest
from click.testing import CliRunner
from meshlab_developable import mesh_sets
from meshlab_developable.command_line import main
from meshlab_developable.filters import GLOBAL
from meshlab_developable.panels import panel_reports
from shapes import bump, cylinder


def two_panels():
    """A steep hill and a cylinder beside it."""
    (hill, first), (tube, second) = bump(), cylinder()
    return np.vstack([hill, tube + np.array([5, 0, 0])]), np.vstack([first, second + len(hill)])


def greatest_strains(shape, faces, flat, flat_faces):
    """By Cauchy and Green's tensor: stretch and compression of each face, per cent."""
    x, u = shape[faces], flat[flat_faces][:, :, :2]
    edges_x, edges_u = x[:, 1:] - x[:, :1], u[:, 1:] - u[:, :1]
    maps = np.linalg.solve(edges_u, edges_x)  # rows: the images of the plane's axes
    squares = np.linalg.eigvalsh(maps @ maps.transpose(0, 2, 1))
    return 100 * (np.sqrt(squares[:, 1]) - 1), 100 * (1 - np.sqrt(squares[:, 0]))


PARAMETERS = [
    {"material": "Leather", "allowed_compression": 1.0},
    {"material": "Woven cloth"},
    {"material": "Woven cloth", "allowed_stretch": 1.0},
    {"material": "Woven cloth", "grain": "Z axis"},
    {"material": "Knit"},
    {"allowed_stretch": 0.5, "allowed_compression": 0.5, "max_displacement": 1e-3},
    {"material": "Sheet steel", "thickness": 1e-3, "max_displacement": 1e-3},
    {"material": {"name": "Felt", "stretch": 1.5, "compression": 1, "thickness": 3, "source": "measured"}},
]


LOGGED = """
import json, sys
from meshlab_developable import mesh_sets
from meshlab_developable.filters import GLOBAL
vertices, faces, parameters = json.load(sys.stdin)
meshes = mesh_sets.open_mesh(vertices, faces)
meshes.set_verbosity(True)
mesh_sets.apply_filter(meshes, GLOBAL, GLOBAL.checked(parameters))
"""


@pytest.mark.parametrize("parameters", PARAMETERS)
def test_is_what_the_log_says(parameters):
    vertices, faces = two_panels()
    ran = subprocess.run(  # a process of its own, whose log nothing else has turned elsewhere
        [sys.executable, "-c", LOGGED],
        input=json.dumps([vertices.tolist(), faces.tolist(), parameters]),
        capture_output=True,
        text=True,
        check=True,
    )
    said = meshlab_developable.make_developable(vertices, faces, **parameters).report.material_verdict
    assert said
    assert said in ran.stdout + ran.stderr


@pytest.mark.parametrize("parameters", PARAMETERS[:1] + PARAMETERS[5:6])
def test_strains_are_those_of_the_triangles(parameters):
    vertices, faces = two_panels()
    result = meshlab_developable.make_developable(vertices, faces, **parameters)
    of_pattern = {key: value for key, value in parameters.items() if key != "max_displacement"}
    flat = meshlab_developable.flatten(result.vertices, faces, **of_pattern)
    stretch, compression = greatest_strains(result.vertices, faces, flat.vertices, flat.faces)
    hill = np.arange(len(faces)) < len(bump()[1])
    for panel, chosen in zip(result.report.panels, (hill, ~hill), strict=True):
        assert panel.strain.max_stretch == pytest.approx(max(stretch[chosen].max(), 0), abs=1e-6)
        assert panel.strain.max_compression == pytest.approx(max(compression[chosen].max(), 0), abs=1e-6)
    beyond = [panel.strain.beyond_bounds for panel in result.report.panels]
    if "max_displacement" not in parameters:
        assert beyond == [0, 0]
        assert result.report.material_verdict.startswith("Leather: every panel is within its 2 % stretch")
        return
    assert beyond[0] == pytest.approx(max(stretch[hill].max(), compression[hill].max()) - 0.5, abs=1e-3)
    strains, at = np.maximum(stretch, compression), result.report.panels[0].strain.at
    centres = result.vertices[faces].mean(axis=1)
    told = np.linalg.norm(centres - at, axis=1).argmin()
    assert at == pytest.approx(centres[told])
    assert strains[told] == pytest.approx(strains.max(), abs=1e-9)  # the hill is symmetric: there are two
    assert result.report.material_verdict.startswith("Custom: 1 panel is beyond 0.5 % stretch and 0.5 %")


def test_what_is_alike_for_warp_weft_and_bias_is_borne_in_every_direction():
    report = meshlab_developable.make_developable(*bump(), material="Knit").report
    assert "(bias) stretch and 0 % compression" in report.material_verdict
    assert report.max_compression < 0.01  # which holds for the principal strain


def test_says_where_strains_between_the_directions_are_beyond_those_along_them():
    stretch = {"warp": 1, "weft": 1, "bias": 1.5}
    net = {"name": "Net", "stretch": stretch, "compression": 1, "source": "none"}
    report = meshlab_developable.make_developable(*bump(), material=net).report
    assert report.max_stretch > 1.51
    assert f"largest {report.max_stretch:.3g} % between its directions at " in report.material_verdict


def test_is_empty_where_nothing_is_allowed_and_strains_are_told_all_the_same():
    result = meshlab_developable.make_developable(*two_panels())
    assert result.report.material_verdict == ""
    assert all(panel.strain.max_stretch < 0.01 for panel in result.report.panels)
    local = meshlab_developable.make_developable(*two_panels(), method="local", max_operations=3)
    assert [panel.strain for panel in local.report.panels] == [None, None]


def test_strains_of_an_earlier_run_are_gone_after_one_that_measures_none(tmp_path):
    meshes = mesh_sets.open_mesh(*two_panels())
    mesh_sets.apply_filter(meshes, GLOBAL, {"material": "Leather"})
    assert panel_reports(meshes.current_mesh())[0].strain is not None
    meshes.apply_filter("apply_coord_local_developability", max_operations=3)
    assert panel_reports(meshes.current_mesh())[0].strain is None


def test_command_says_it(tmp_path):
    source, target = tmp_path / "hill.ply", tmp_path / "out.ply"
    mesh_sets.open_mesh(*bump()).save_current_mesh(str(source))
    arguments = ["global", str(source), "-o", str(target), "--material", "Leather", "--quiet"]
    words = CliRunner().invoke(main, arguments).output
    answer = json.loads(CliRunner().invoke(main, [*arguments, "--json"]).output)
    assert answer["material_verdict"].startswith("Leather: ")
    assert answer["material_verdict"] in words.splitlines()
    assert set(answer["panels"][0]["strain"]) == {"max_stretch", "max_compression", "beyond_bounds", "at"}


def test_batch_has_it_in_its_message_and_the_strains_with_the_panels(tmp_path):
    folder, out, settings = tmp_path / "in", tmp_path / "out", tmp_path / "settings.toml"
    folder.mkdir()
    mesh_sets.open_mesh(*bump()).save_current_mesh(str(folder / "hill.ply"))
    settings.write_text('method = "global"\n[parameters]\nmaterial = "Leather"\n', encoding="utf-8")
    arguments = ["batch", str(folder), "--out", str(out), "--parameters", str(settings), "--quiet"]
    assert CliRunner().invoke(main, arguments).exit_code == 0
    (row,) = pyarrow.parquet.read_table(out / "results.parquet").to_pylist()
    report = meshlab_developable.make_developable(folder / "hill.ply", material="Leather").report
    assert report.material_verdict in row["message"]
    assert report.material_verdict in (out / "overview.html").read_text(encoding="utf-8")
    strain = json.loads(row["panels"])[0]["strain"]
    assert strain["max_stretch"] == row["max_stretch"] == report.panels[0].strain.max_stretch
