# SPDX-License-Identifier: GPL-3.0-or-later
"""What people read in the log: the verdict first, warnings of results far from their input; and where flat
pieces lie."""

from __future__ import annotations

import re
import subprocess
import sys

import numpy as np
import pymeshlab
import pytest
from meshlab_developable import make_developable, mesh_sets
from meshlab_developable.departure import departure
from shapes import bump, cylinder

LEFT = r"[\d.e-]+ of [\d.]+ rad of curvature left, moved by at most [\d.]+ units of the mesh"
FILTERS = {
    "apply_coord_global_developability": rf"Global Developability: converged; {LEFT}",
    "apply_coord_local_developability": rf"Local Developability: .*; {LEFT}",
    "compute_scalar_by_developability_per_vertex": r"Developability Maps: [\d.]+ rad of total absolute c",
    "generate_flat_patches": r"Flatten Patches: 1 piece laid flat; edges change by at most [\d.]+ %",
    "meshing_polygons_to_constrained_delaunay": r"Triangulate Polygons \(Constrained Delaunay\): 0 poly",
    "apply_coord_restore_original_shape": r"Restore Original Shape: \d+ vertices moved .* at most [\d.]+",
}


AFTER = {"apply_coord_restore_original_shape": ["apply_coord_global_developability"]}


def logged(file, name):
    script = f"""
import pymeshlab, meshlab_developable
meshlab_developable.load()
meshes = pymeshlab.MeshSet(verbose=True)
meshes.load_new_mesh({str(file)!r})
for first in {AFTER.get(name, [])!r}:
    meshes.apply_filter(first)
print("begin", flush=True)
meshes.apply_filter({name!r})
"""
    command = [sys.executable, "-u", "-c", script]
    ran = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=True)
    lines = ran.stdout.split("begin\n", 1)[1].splitlines()
    return [re.sub(r"^LOG: \d+ ", "", line) for line in lines]


@pytest.fixture(scope="module")
def hill(tmp_path_factory):
    file = tmp_path_factory.mktemp("log") / "hill.ply"
    mesh_sets.save(mesh_sets.open_mesh(*bump()), file)
    return file


@pytest.mark.parametrize("name", FILTERS)
def test_the_verdict_is_the_first_line(name, hill):
    lines = logged(hill, name)
    keys = [number for number, line in enumerate(lines) if re.match(r"\w+: ", line)]
    verdict = next(number for number, line in enumerate(lines) if re.match(FILTERS[name], line))
    assert verdict < keys[0]
    sentences = [
        line for number, line in enumerate(lines) if number not in keys and line[:1] != "{"
    ]  # the host's
    for number in re.findall(r"[\d.]+", " ".join(sentences)):
        assert len(number.replace(".", "").strip("0")) <= 4, sentences


def test_the_way_back_is_said(hill):
    lines = logged(hill, "apply_coord_global_developability")
    assert any(re.match(r"way back: .*filter Restore Original Shape", line) for line in lines)


def capped_tube():
    """A tube with a closed end: what is developable near it is far from it."""
    sphere = pymeshlab.MeshSet()
    sphere.create_sphere(subdiv=3)
    mesh = sphere.current_mesh()
    vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
    return vertices, faces[vertices[faces].mean(axis=1)[:, 2] < 0.3]


def test_a_result_far_from_its_input_is_warned_of_in_numbers_that_are_true():
    vertices, faces = capped_tube()
    result = make_developable(vertices, faces)
    used = np.unique(faces)
    moved = np.linalg.norm(result.vertices[used] - vertices[used], axis=1).max()
    share = 100 * moved / np.linalg.norm(np.ptp(vertices[used], axis=0))
    assert share > 5
    (warning,) = (text for text in result.report.warnings if text.startswith("far from its input"))
    assert f"{result.report.max_displacement:.4g} units" in warning
    assert f"{share:.4g} % of its part's diagonal" in warning


def test_a_small_part_far_from_its_input_is_warned_of_beside_a_large_one():
    vertices, faces = capped_tube()
    sheet, more = cylinder()
    alone = make_developable(vertices, faces).report
    both = np.vstack([100 * sheet, vertices]), np.vstack([more, faces + len(sheet)])
    report = make_developable(*both).report
    assert alone.max_displacement_per_cent > 5
    assert report.max_displacement_per_cent == alone.max_displacement_per_cent
    assert report.warnings == alone.warnings


def test_a_result_near_its_input_is_not_warned_of():
    result = make_developable(*cylinder())
    assert not result.report.warnings


@pytest.mark.parametrize("shift", [(0, 0, 0), (300, -20, 7)])
def test_flat_pieces_lie_beside_the_model(shift):
    vertices, faces = bump()
    meshes = mesh_sets.open_mesh(vertices + np.array(shift, dtype=float), faces)
    meshes.set_current_mesh(0)
    model = meshes.current_mesh().vertex_matrix()
    meshes.apply_filter("generate_flat_patches")
    flat = meshes.current_mesh().vertex_matrix()
    assert flat[:, 0].min() > model[:, 0].max()
    assert flat[:, 0].min() < model[:, 0].max() + 0.5 * np.ptp(flat[:, 0])
    assert not flat[:, 2].any()


def test_the_log_has_the_same_warnings(tmp_path):
    mesh_sets.save(mesh_sets.open_mesh(*capped_tube()), tmp_path / "cap.ply")
    lines = logged(tmp_path / "cap.ply", "apply_coord_global_developability")
    said = [line.removeprefix("warning: ") for line in lines if line.startswith("warning: ")]
    assert said == list(make_developable(tmp_path / "cap.ply").report.warnings)
    assert said


def test_folds_and_parts_that_vanished_are_counted():
    positions, faces = cylinder()
    moved = np.vstack([positions, positions + 10])
    both = np.vstack([faces, faces + len(positions)])
    shrunk = moved.copy()
    shrunk[len(positions) :] = 10 + 0.1 * positions
    assert departure(moved, shrunk, both)["shrunken_patches"] == 1
    flat = np.array([(0.0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
    folded = np.array([(0.0, 0, 0), (1, 0, 0), (1, 1, 0), (0.9, 0.2, 0)])
    two = np.array([(0, 1, 2), (0, 2, 3)])
    assert departure(flat, folded, two)["folded_faces"] == 2
    assert departure(flat, flat, two)["folded_faces"] == 0
