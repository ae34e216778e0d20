# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line: what it prints and writes, its exit codes, and that it does what the filter does."""

from __future__ import annotations

import json
import os
import pty
import subprocess
import sys
from pathlib import Path

import meshlab_developable
import numpy as np
import pymeshlab
import pytest
import reference_measures as reference
from click.testing import CliRunner
from meshlab_developable import filters, plugin
from meshlab_developable.command_line import COMMANDS, main

ROOT = Path(__file__).parents[2]
SHOE = ROOT / "meshes" / "shoe_upper.ply"
SHELL = ROOT / "meshes" / "dented_shell.ply"


def developable(*arguments: object):
    return CliRunner().invoke(main, list(map(str, arguments)), prog_name="developable")


def by_the_filter(mesh: Path, filter_name: str, **parameters: object):
    meshlab_developable.load()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(mesh))
    shares = {name: value for name, value in parameters.items() if str(value).endswith("%")}
    parameters |= {name: pymeshlab.PercentageValue(float(text[:-1])) for name, text in shares.items()}
    values = meshes.apply_filter(filter_name, **parameters)
    return meshes, values


def read(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    mesh = meshes.current_mesh()
    return np.array(mesh.vertex_matrix()), plugin.vertex_quality(mesh), np.array(mesh.vertex_color_matrix())


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help_with_examples(name):
    result = developable(name, "--help")
    assert result.exit_code == 0
    assert f"developable {name} " in result.output.split("Examples:")[1]


@pytest.mark.parametrize(
    "command", [["--help"], ["pattern", "--help"], ["measure", str(SHOE)]], ids=lambda words: words[0]
)
def test_what_draws_patterns_is_imported_when_patterns_are_drawn(command):
    code = (
        "import sys\n"
        "from meshlab_developable.command_line import main\n"
        f"main({command!r}, standalone_mode=False)\n"
        "print({'distributed', 'ezdxf', 'reportlab', 'scipy', 'shapely'} & set(sys.modules))\n"
    )
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout.splitlines()[-1] == "set()"


@pytest.mark.parametrize("name", ["global", "local", "cut", "flatten", "pattern", "report", "batch"])
def test_what_is_written_goes_where_output_says(name):
    assert "-o, --output" in developable(name, "--help").output


@pytest.mark.parametrize(
    "note",
    [
        "[rad; 0 or more, greater than 0 with the solver 'Constrained Newton'; default: 0.0001]",
        "[length, or % of the mesh's diagonal; default: -1]",
        "[greater than 0 and at most 1; default: 3e-06]",
        "equal coordinates. [length, or % of the mesh's diagonal; default: 0]",
    ],
)
def test_help_has_units_ranges_and_defaults(note):
    assert note in " ".join(developable("global", "--help").output.split())


def test_measure_prints_the_measures():
    result = developable("measure", SHELL, "--angle-tolerance", "0.01", "--json")
    assert result.exit_code == 0
    measures = json.loads(result.output)
    positions, triangles, _ = reference.read_obj(ROOT / "meshes" / "dented_shell.obj")
    assert measures["developability"] == pytest.approx(reference.developability(positions, triangles, 0.01))
    defects = reference.angle_defects(positions, triangles)
    assert measures["total_absolute_curvature"] == pytest.approx(np.abs(defects).sum())
    assert f"{measures['total_absolute_curvature']:.6g}" in developable("measure", SHELL).output


def test_measure_takes_several_meshes():
    result = developable("measure", SHELL, SHOE, "--json")
    assert [Path(mesh["input"]) for mesh in json.loads(result.output)] == [SHELL, SHOE]


def test_measure_writes_the_map_to_a_reference(tmp_path):
    target = tmp_path / "moved.ply"
    assert developable("global", SHOE, "-o", target).exit_code == 0
    mapped = tmp_path / "distance.ply"
    result = developable("measure", target, "--reference", SHOE, "--map", "displacement", "-o", mapped)
    assert result.exit_code == 0, result.output
    before, after = read(SHOE)[0], read(target)[0]
    assert read(mapped)[1] == pytest.approx(np.linalg.norm(after - before, axis=1), rel=1e-12)


@pytest.mark.parametrize(
    ("command", "applied", "options"),
    [
        ("global", filters.GLOBAL, {"map": "Displacement"}),
        (
            "global",
            filters.GLOBAL,
            {"solver": "Conjugate gradient", "max_iterations": 20, "fix_boundary": True},
        ),
        ("local", filters.LOCAL, {"max_operations": 3000, "descent": True, "smoothing": 0.01}),
        ("local", filters.LOCAL, {"max_displacement": "0.2%"}),
    ],
)
def test_the_result_is_the_filters_to_the_last_bit(command, applied, options, tmp_path):
    target, expected = tmp_path / "out.ply", tmp_path / "expected.ply"
    arguments = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        arguments += [option] if value is True else [option, value]
    result = developable(command, SHOE, "--output", target, "--json", *arguments)
    report = json.loads(result.output)
    meshes, values = by_the_filter(SHOE, applied.function, **options)
    meshes.save_current_mesh(str(expected))
    assert target.read_bytes() == expected.read_bytes()
    apart = {"seconds", "status", "reason"}
    assert {k: report[k] for k in values.keys() - apart} == {
        k: v for k, v in values.items() if k not in apart
    }
    assert result.exit_code == (0 if values["converged"] else 3)


def test_not_converged_is_3_and_the_result_is_there(tmp_path):
    target = tmp_path / "out.ply"
    result = developable("global", SHOE, "-o", target, "--max-iterations", 1)
    assert result.exit_code == 3
    assert "stopped at the limit" in result.output
    assert target.exists()


BAD_HEADER = "ply\nformat ascii 1.0\nelement vertex 3\n"
CLOSED = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
CLOSED += "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
CLOSED += "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"


@pytest.mark.parametrize(
    ("content", "words"), [(BAD_HEADER, "Eof in header"), (CLOSED, "closed"), ("", "cannot be read")]
)
def test_bad_meshes_are_2_in_words(content, words, tmp_path):
    source, target = tmp_path / "bad.ply", tmp_path / "out.ply"
    source.write_text(content)
    result = developable("global", source, "-o", target)
    assert result.exit_code == 2
    assert result.stderr.startswith("error: ")
    assert words in result.stderr
    assert result.stdout == ""
    assert sorted(tmp_path.iterdir()) == [source]
    assert words in json.loads(developable("global", source, "-o", target, "--json").stdout)["error"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["global", "no_such_mesh.ply", "-o", "out.ply"], "no_such_mesh.ply"),
        (["global", SHOE], "--output"),
        (["global", SHOE, "-o", "no_such_folder/out.ply"], "no_such_folder"),
        (["global", SHOE, "-o", "out.nonsense"], "out.nonsense"),
        (["global", SHOE, "-o", "out.ply", "--angle-tolerance", "-1"], "0 or more"),
        (["global", SHOE, "-o", "out.ply", "--solver", "Guess"], "'Conjugate gradient'"),
        (["local", SHOE, "-o", "out.ply", "--max-operations", "1.5"], "whole number"),
        (["local", SHOE, "-o", "out.ply", "--fix-boundary"], "--fix-boundary"),
        (["measure", SHOE, SHELL, "-o", "out.ply"], "one mesh"),
        (["script", "sideways"], "global, local, maps, flatten, cut, restore, triangulate"),
        (["script", "global", "angle_tolerence=1"], "'angle_tolerance'"),
        (["script", "global", "angle_tolerance"], "name=value"),
        (["script", "global", "solver=2"], "'Constrained Newton'"),
        (["script", "local", "max_displacement=2%"], "give a length in its unit"),
        (["global", SHOE, "-o", "out.ply", "--max-displacement", "two%"], "such as 2%"),
    ],
)
def test_bad_requests_are_2_in_words(arguments, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = developable(*arguments)
    assert result.exit_code == 2
    assert words in result.stderr
    assert list(tmp_path.iterdir()) == []


STORED = {
    "global": "global_developability",
    "local": "local_developability",
    "maps": "developability_maps",
    "flatten": "flatten_patches",
    "cut": "cut_into_developable_panels",
    "restore": "restore_original_shape",
    "triangulate": "triangulate_polygons",
}


@pytest.mark.parametrize("name", STORED)
def test_a_script_with_defaults_is_the_stored_one(name):
    assert set(STORED) == {known.name for known in filters.FILTERS}
    stored = (ROOT / "meshes" / "scripts" / f"{STORED[name]}.mlx").read_text()
    assert developable("script", name).output == stored
    assert developable("script", filters.find_filter(name).function).output == stored


def test_values_of_a_script_arrive(tmp_path):
    script = tmp_path / "run.mlx"
    values = ["max_displacement=0.05", "descent=yes", "map=angle defect", "max_operations=200"]
    assert developable("script", "Local Developability", *values, "-o", script).exit_code == 0
    meshlab_developable.load()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(SHOE))
    meshes.load_filter_script(str(script))
    meshes.apply_filter_script()
    direct, _ = by_the_filter(
        SHOE,
        filters.LOCAL.function,
        max_displacement=pymeshlab.PureValue(0.05),
        descent=True,
        map="Angle defect",
        max_operations=200,
    )
    assert np.array_equal(meshes.current_mesh().vertex_matrix(), direct.current_mesh().vertex_matrix())
    assert not np.array_equal(meshes.current_mesh().vertex_matrix(), read(SHOE)[0])
    quality = plugin.vertex_quality(meshes.current_mesh())
    assert np.array_equal(quality, plugin.vertex_quality(direct.current_mesh()))


def test_report_makes_a_page(tmp_path):
    pytest.importorskip("pyvista")
    out = tmp_path / "report"
    result = developable("report", ROOT / "meshes" / "sheet_bent.ply", "--out", out, "--unit", "cm")
    assert result.exit_code == 0, result.output
    assert "Global Developability" in (out / "report.html").read_text("utf-8")
    assert str(out / "report.html") in result.stdout


def test_report_of_a_bad_mesh_is_2_in_words(tmp_path):
    pytest.importorskip("pyvista")
    (tmp_path / "bad.ply").write_text(CLOSED)
    result = developable("report", tmp_path / "bad.ply", "--out", tmp_path / "report")
    assert result.exit_code == 2
    assert "closed" in result.stderr


def test_report_without_the_extra_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    result = developable("report", SHOE, "--out", tmp_path / "report")
    assert result.exit_code == 2
    assert "[render]" in result.stderr
    clone = Path(meshlab_developable.__file__).parents[1]
    assert (str(clone) in result.stderr) == (clone / "pyproject.toml").is_file()


def test_the_installed_command_has_the_version():
    command = Path(sys.executable).with_name("developable")
    printed = subprocess.run([command, "--version"], capture_output=True, text=True, check=True).stdout
    assert meshlab_developable.__version__ in printed


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_scripts_name_the_command(shell):
    assert "_DEVELOPABLE_COMPLETE" in developable("completion", shell).output


@pytest.mark.parametrize(
    ("words", "completed"),
    [
        (["m"], {"measure"}),
        (["script", "tri"], {"triangulate"}),
        (["script", "local", "max_"], {"max_displacement=", "max_operations="}),
        (["global", "--solver", "conj"], {"Conjugate gradient"}),
        (["global", "--fix-"], {"--fix-boundary", "--fix-selected"}),
    ],
)
def test_a_shell_completes(words, completed):
    environment = {
        "_DEVELOPABLE_COMPLETE": "bash_complete",
        "COMP_WORDS": " ".join(["developable", *words]),
        "COMP_CWORD": str(len(words)),
    }
    result = CliRunner().invoke(main, env=environment, prog_name="developable")
    assert {line.split(",", 1)[1] for line in result.output.splitlines()} == completed


def test_a_terminal_sees_progress_and_standard_output_only_the_result(tmp_path):
    """The bar is drawn where standard error is a terminal, and what the host prints stays out of the way."""
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "meshlab_developable.command_line"]
    command += ["global", SHOE, "-o", tmp_path / "out.ply"]
    ran = subprocess.run(command, stdout=subprocess.PIPE, stderr=theirs, text=True, check=True)
    os.close(theirs)
    shown = os.read(ours, 1 << 16).decode()
    os.close(ours)
    assert "100%" in shown
    assert "LOG" not in shown
    assert ran.stdout.startswith(f"{tmp_path / 'out.ply'}: converged")
