# SPDX-License-Identifier: GPL-3.0-or-later
"""The stock MeshLab in its own window: filters are found, their dialogs take values, results show.

Screenshots are kept in build/screenshots.
"""

import os
from pathlib import Path

import numpy as np
import pytest
from desktop import Desktop, MeshLab, keep, stage, wait_for

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("DEVELOPABLE_BUILD", ROOT / "build"))
SCREENSHOTS = BUILD / "screenshots"
SHELL = ROOT / "meshes" / "dented_shell.ply"

# What is chosen as `map`, and how many parameters lie below it in the dialog.
FILTERS = {
    "Global Developability": ("Displacement", 1),
    "Local Developability": ("Angle defect", 1),
    "Developability Maps": ("Gaussian curvature", 2),
    "Flatten Patches": ("Elastic energy", 2),
}
REPORTED = {
    "Global Developability": ["status: converged", "total_absolute_curvature_after: "],
    "Local Developability": ["status: ", "total_absolute_curvature_after: "],
    "Developability Maps": ["total_absolute_curvature: 2.97"],
    "Flatten Patches": ["pieces: 1", "flipped_faces: 0"],
}


@pytest.fixture(scope="module")
def program():
    return stage(ROOT)


@pytest.fixture
def meshlab(tmp_path, program):
    with Desktop(tmp_path) as desktop:
        yield lambda mesh: MeshLab(desktop, program, mesh)


def choose(dialog, text, parameters_below):
    """From Apply, which has the focus, back over Close and Help to the choice; it takes a text."""
    dialog.keys(*["shift+Tab"] * (3 + parameters_below))
    dialog.write(text)  # the space in it opens the list
    dialog.desktop.xdotool("key", "Return")


def redness(view):
    return view[:, :, 0] - view[:, :, 2]


@pytest.mark.parametrize("name", FILTERS)
def test_a_filter_is_found_takes_a_value_and_colours_the_model(name, meshlab):
    host = meshlab(SHELL)
    before = host.view()
    dialog = host.open(name)
    text, below = FILTERS[name]
    choose(dialog, text, below)
    keep(dialog.picture(), SCREENSHOTS / f"{name} dialog.png")
    dialog.click(0.75, 20)
    host.wait_for_log(f"Applied filter {name}")
    log = host.log()
    assert [line for line in log if line.startswith(f"vertex quality: {text} [")]
    assert [line for line in log if line.startswith("vertex colours: ")]
    for beginning in REPORTED[name]:
        assert [line for line in log if line.startswith(beginning)], log
    dialog.click(0.25, 20)
    after = host.view()
    keep(host.desktop.screen(), SCREENSHOTS / f"{name}.png")
    assert (redness(before) > 40).mean() < 0.001
    assert (redness(after) > 40).mean() > 0.005
    assert (np.abs(after - before).max(axis=2) > 20).mean() > 0.05


def test_polygons_are_triangulated_without_a_dialog(meshlab, tmp_path):
    host = meshlab(quadrangles(tmp_path / "quadrangles.ply"))
    host.find("Triangulate Polygons")
    host.wait_for_log("Applied filter Triangulate Polygons (Constrained Delaunay)")
    assert [line for line in host.log() if line == "polygons: 16"]
    keep(host.desktop.still(), SCREENSHOTS / "Triangulate Polygons.png")


def test_the_way_back_shows_the_model_as_it_was_without_a_dialog(meshlab):
    host = meshlab(SHELL)
    dialog = host.open("Global Developability")
    dialog.click(0.75, 20)
    host.wait_for_log("Applied filter Global Developability")
    dialog.click(0.25, 20)
    [moved] = [line.split(": ")[1] for line in host.log() if line.startswith("max_displacement: ")]
    host.find("Restore Original Shape")
    host.wait_for_log("Applied filter Restore Original Shape")
    log = host.log()
    assert [line for line in log if line.startswith("max_displacement: ")][-1] == f"max_displacement: {moved}"
    keep(host.desktop.still(), SCREENSHOTS / "Restore Original Shape.png")


def quadrangles(file):
    """A bent sheet of 4 x 4 quadrangles."""
    lines = ["ply", "format ascii 1.0", "element vertex 25"]
    lines += [f"property float {axis}" for axis in "xyz"]
    lines += ["element face 16", "property list uchar int vertex_indices", "end_header"]
    lines += [f"{i} {j} {0.1 * i * i}" for i in range(5) for j in range(5)]
    lines += [
        f"4 {5 * i + j} {5 * i + j + 5} {5 * i + j + 6} {5 * i + j + 1}" for i in range(4) for j in range(4)
    ]
    file.write_text("\n".join(lines) + "\n")
    return file


def test_closing_a_dialog_leaves_everything_as_it_was(meshlab):
    host = meshlab(SHELL)
    before = host.view()
    log = host.log()
    dialog = host.open("Global Developability")
    choose(dialog, *FILTERS["Global Developability"])
    dialog.click(0.25, 20)
    wait_for("the dialog to close", lambda: not host.desktop.windows("Global Developability"))
    wait_for("the view as it was", lambda: np.array_equal(host.view(), before))
    assert host.log() == log


def test_an_error_is_shown_in_words(meshlab, tmp_path):
    corners = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
    lines = ["ply", "format ascii 1.0", "element vertex 4", *(f"property float {axis}" for axis in "xyz")]
    lines += ["element face 4", "property list uchar int vertex_indices", "end_header"]
    lines += [" ".join(map(str, corner)) for corner in corners]
    lines += ["3 0 1 2", "3 0 3 1", "3 0 2 3", "3 1 3 2"]
    file = tmp_path / "closed.ply"
    file.write_text("\n".join(lines) + "\n")
    host = meshlab(file)
    dialog = host.open("Global Developability")
    dialog.click(0.75, 20)
    failure = host.desktop.window("Filter Failure")
    keep(failure.picture(), SCREENSHOTS / "failure.png")
    assert "1 of 1 patch is closed and can't be laid flat" in host.log()[-1]
