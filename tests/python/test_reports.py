# SPDX-License-Identifier: GPL-3.0-or-later
"""Why a run ended is said in the words that the filter itself logs."""

from __future__ import annotations

import ast
import json
import re
import subprocess
import sys

import meshlab_developable
import numpy as np
import pymeshlab
import pytest
from click.testing import CliRunner
from meshlab_developable import Status, mesh_sets
from meshlab_developable.command_line import main
from shapes import bump, cylinder


def jar_and_hill():
    """A sphere with a small hole, which needs a cut, and beside it a hill, which needs none."""
    sphere = pymeshlab.MeshSet()
    sphere.create_sphere(subdiv=3)
    jar = sphere.current_mesh()
    hill, faces = bump()
    vertices = np.vstack([jar.vertex_matrix(), hill + np.array([5, 0, 0])])
    return vertices, np.vstack([jar.face_matrix()[:-4], faces + jar.vertex_number()])


LONG = {"angle_tolerance": 1e-9}
STILL = {"max_displacement": 0.0}
RUNS = [
    (
        "global",
        jar_and_hill(),
        {},
        Status.NEEDS_CUT,
        r"no developable shape near this one: it needs a cut in 1 of 2 patches, ",
    ),
    ("global", bump(), {}, Status.CONVERGED, "converged"),
    (
        "global",
        bump(),
        {"max_iterations": 1},
        Status.LIMIT_REACHED,
        "stopped at the limit of iterations or operations",
    ),
    ("global", cylinder(), {}, Status.NOTHING_TO_DO, "nothing to do: developable from the start"),
    ("local", bump(), STILL, Status.STALLED, "stalled: within the tolerance nothing can move any more"),
    (
        "local",
        bump(),
        LONG,
        Status.STALLED,
        "stalled: the last 20 operations a movable vertex have not lowered G",
    ),
]


@pytest.fixture
def saved(tmp_path):
    """Writes a mesh to a file."""

    def save(mesh):
        mesh_sets.save(mesh_sets.open_mesh(*mesh), tmp_path / "mesh.ply")
        return tmp_path / "mesh.ply"

    return save


def printed_report(source, target, method, parameters):
    """The report, and all else that a run in a process of its own prints."""
    script = f"""
from pathlib import Path
from meshlab_developable import file_methods
source, target = Path({str(source)!r}), Path({str(target)!r})
report = file_methods.develop_file(source, target, {method!r}, verbose=True, **{parameters!r})
print("report", [report.reason, int(report.status), report.patches_needing_cut])
"""
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    [report] = re.findall(r"^report (.*)$", ran.stdout, re.MULTILINE)
    return ast.literal_eval(report), ran.stdout + ran.stderr


@pytest.mark.parametrize(("method", "mesh", "parameters", "status", "words"), RUNS)
def test_the_reason_is_what_the_log_says(method, mesh, parameters, status, words, saved, tmp_path):
    (reason, number, cuts), printed = printed_report(saved(mesh), tmp_path / "out.ply", method, parameters)
    [logged] = re.findall(r"status: (.*?); D: ", printed)
    assert reason == logged
    assert reason.startswith(words)
    assert number == status
    assert (cuts > 0) == (status is Status.NEEDS_CUT)


def test_a_cut_is_needed_where_the_numbers_say():
    result = meshlab_developable.make_developable(*jar_and_hill())
    report = result.report
    assert (report.patches_needing_cut, report.patches) == (1, 2)
    worst = report.worst_x, report.worst_y, report.worst_z
    assert np.linalg.norm(result.vertices - worst, axis=1).min() < 1e-12
    assert report.worst_x < 2.5  # on the jar


def test_the_command_line_says_it_too(saved, tmp_path):
    arguments = ["global", str(saved(jar_and_hill())), "-o", str(tmp_path / "out.ply")]
    said = json.loads(CliRunner().invoke(main, [*arguments, "--json"]).stdout)
    assert "it needs a cut in 1 of 2 patches, first of all at (" in said["message"]
    assert said["status"] == "needs_cut"
    assert said["message"] in CliRunner().invoke(main, arguments).stdout
