# SPDX-License-Identifier: GPL-3.0-or-later
"""The package: loading the plugin that fits, and arrays in, arrays and a report out."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import meshlab_developable
import numpy as np
import pymeshlab
import pytest
import reference_measures as reference
from meshlab_developable import Status, filters, plugin

ROOT = Path(__file__).parents[2]
SHELL = ROOT / "meshes" / "dented_shell.obj"


@pytest.fixture(scope="module")
def shell():
    positions, triangles, _ = reference.read_obj(SHELL)
    return positions, triangles


def test_version_is_the_projects():
    assert meshlab_developable.__version__ == (ROOT / "VERSION").read_text().strip()


def test_load_twice_loads_once(monkeypatch):
    meshlab_developable.load()
    filters = pymeshlab.filter_list()
    assert set(plugin.FILTERS) <= set(filters)
    loaded = []
    monkeypatch.setattr(pymeshlab, "load_plugin", loaded.append)
    meshlab_developable.load()
    assert loaded == []
    assert pymeshlab.filter_list() == filters


def test_load_binds_methods():
    meshlab_developable.load()
    for name in plugin.FILTERS:
        assert callable(getattr(pymeshlab.MeshSet, name))


def fake_builds(folder, *versions):
    for version in versions:
        (folder / f"pymeshlab-{version}").mkdir(parents=True)
        (folder / f"pymeshlab-{version}" / plugin.PLUGIN_FILE).touch()
    return folder


def test_a_build_that_fits_is_found(tmp_path):
    builds = fake_builds(tmp_path, "2022.2", "2025.7")
    assert plugin.find_plugin("2022.2", [builds]).parent.name == "pymeshlab-2022.2"


def test_the_installed_build_goes_before_the_checkouts(tmp_path):
    installed, checkout = (fake_builds(tmp_path / name, "2025.7") for name in ("installed", "checkout"))
    assert plugin.find_plugin("2025.7", [installed, checkout]).is_relative_to(installed)


def test_when_none_fits_the_versions_are_named(tmp_path):
    builds = fake_builds(tmp_path, "2022.2", "2025.7")
    with pytest.raises(meshlab_developable.PluginNotFoundError) as caught:
        plugin.find_plugin("2023.12", [builds])
    for words in ("2023.12", "2022.2, 2025.7", "pip install"):
        assert words in str(caught.value)


def test_when_none_is_built_it_says_how(tmp_path):
    with pytest.raises(meshlab_developable.PluginNotFoundError, match="bash scripts"):
        plugin.find_plugin("2025.7", [tmp_path])


def test_a_build_that_does_not_fit_is_refused_in_words(tmp_path, monkeypatch):
    builds = fake_builds(tmp_path, plugin.pymeshlab_version())
    monkeypatch.setattr(plugin, "is_loaded", lambda: False)
    monkeypatch.setattr(plugin, "plugin_folders", lambda: [builds])
    with pytest.raises(meshlab_developable.PluginNotFoundError, match=plugin.pymeshlab_version()):
        plugin.load()


def test_missing_libraries_of_the_system_are_named(tmp_path):
    reason = "libcom_err.so.2: cannot open shared object file: No such file or directory"
    (tmp_path / "pymeshlab.py").write_text(f"raise ImportError({reason!r})\n")
    command = [
        sys.executable,
        "-c",
        f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import meshlab_developable",
    ]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    last = ran.stderr.splitlines()[-1]
    assert ran.returncode == 1
    assert reason in last
    assert "libcom-err2" in last


def test_measures_agree_with_slow_ones(shell):
    result = meshlab_developable.measure(*shell, angle_tolerance=0.01, map="Angle defect")
    defects = reference.angle_defects(*shell)
    assert result.measures.patches == 1
    assert result.measures.assembling_vertices == 0
    assert result.measures.developability == pytest.approx(reference.developability(*shell, 0.01), rel=1e-9)
    assert result.measures.detect_function == pytest.approx((defects**2).sum(), rel=1e-9)
    assert result.measures.max_angle_defect == pytest.approx(np.abs(defects).max(), rel=1e-9)
    assert result.measures.total_absolute_curvature == pytest.approx(np.abs(defects).sum(), rel=1e-9)
    assert result.quality == pytest.approx(defects, abs=1e-9)


def test_seams_of_the_pants_are_linked():
    positions, triangles, _ = reference.read_obj(ROOT / "meshes" / "short_pants.obj")
    measures = meshlab_developable.measure(positions, triangles).measures
    assert measures.patches == 4
    places = np.unique(positions, axis=0, return_counts=True)[1]
    assert measures.assembling_vertices == (places > 1).sum()


@pytest.mark.parametrize("method", ["global", "local"])
def test_make_developable_removes_curvature(shell, method):
    options = {"solver": "Conjugate gradient"} if method == "global" else {}
    result = meshlab_developable.make_developable(*shell, method=method, angle_tolerance=0.01, **options)
    report = result.report
    before, after = ((reference.angle_defects(p, shell[1]) ** 2).sum() for p in (shell[0], result.vertices))
    assert after < before
    assert report.detect_function_before == pytest.approx(before, rel=1e-9)
    assert report.detect_function_after == pytest.approx(after, rel=1e-6)
    moved = np.linalg.norm(result.vertices - shell[0], axis=1)
    assert report.max_displacement == pytest.approx(moved.max(), rel=1e-9)
    assert report.mean_displacement == pytest.approx(moved.mean(), rel=1e-9)
    assert report.status in Status
    assert report.converged == (report.status is Status.CONVERGED)


def test_the_arrays_given_are_not_changed(shell):
    positions, triangles = (array.copy() for array in shell)
    meshlab_developable.make_developable(positions, triangles, method="local", max_operations=50)
    assert np.array_equal(positions, shell[0])
    assert np.array_equal(triangles, shell[1])


def test_lists_and_read_only_arrays_are_taken(shell):
    positions, triangles = (array.copy() for array in shell)
    positions.flags.writeable = triangles.flags.writeable = False
    from_arrays = meshlab_developable.measure(positions, triangles)
    from_lists = meshlab_developable.measure(positions.tolist(), triangles.tolist())
    assert from_arrays.measures == from_lists.measures


def test_lengths_are_plain_numbers(shell):
    result = meshlab_developable.make_developable(*shell, method="local", max_displacement=0.05)
    assert 0 < result.report.max_displacement <= 0.05 * (1 + 1e-12)


def test_lengths_may_be_shares_of_the_diagonal(shell):
    diagonal = np.linalg.norm(np.ptp(shell[0], axis=0))
    by_share, by_length = (
        meshlab_developable.make_developable(*shell, method="local", max_displacement=limit)
        for limit in ("0.5%", 0.005 * diagonal)
    )
    assert by_share.vertices == pytest.approx(by_length.vertices, abs=1e-9 * diagonal)
    assert by_share.report.max_displacement == pytest.approx(0.005 * diagonal, rel=1e-3)


@pytest.mark.parametrize("length", ["1%", 1.0])
@pytest.mark.parametrize("size", [1e-60, 1e60])
def test_lengths_that_hosts_do_not_keep_are_refused(shell, length, size):
    """They would be taken for nothing, or for infinite."""
    vertices, faces = shell
    given = length if isinstance(length, str) else length * size
    with pytest.raises(
        meshlab_developable.InvalidParameterError, match=r"max_displacement is a length of .*: scale the mesh"
    ):
        meshlab_developable.make_developable(vertices * size, faces, max_displacement=given)


def test_developable_input_is_left_alone():
    positions, triangles, _ = reference.read_obj(ROOT / "meshes" / "sheet_bent.obj")
    result = meshlab_developable.make_developable(positions, triangles, method="local")
    assert result.report.status in (Status.NOTHING_TO_DO, Status.CONVERGED)
    assert np.array_equal(result.vertices, positions)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"method": "sideways"}, ["'sideways'", "'global'", "'local'"]),
        ({"angle_tolerence": 0.1}, ["'angle_tolerence'", "'angle_tolerance'"]),
        ({"angle_tolerance": -1}, ["angle_tolerance", "-1", "0 or more"]),
        ({"angle_tolerance": float("nan")}, ["angle_tolerance", "nan"]),
        ({"max_iterations": 1.5}, ["max_iterations", "1.5", "whole"]),
        ({"weld_distance": "wide"}, ["weld_distance", "'wide'", "0 or more"]),
        ({"weld_distance": "-1%"}, ["weld_distance", "'-1%'", "0 or more"]),
        ({"weld_distance": "nan%"}, ["weld_distance", "'nan%'", "finite"]),
        ({"map": "Temperature"}, ["map", "'Temperature'", "'Gaussian map'"]),
        ({"fix_boundary": 1}, ["fix_boundary", "True or False"]),
        ({"max_operations": 1}, ["Global", "'max_operations'"]),
        ({"max_operations": 500000}, ["Global", "'max_operations'"]),  # its default, but given
        ({"fairness": 2}, ["fairness", "2"]),
        ({"method": "local", "solver": "Constrained Newton"}, ["Local", "'solver'"]),
        ({"smoothness": 0}, ["smoothness", "0", "greater than 0 and at most 1"]),
        ({"smoothness": 2}, ["smoothness", "2", "greater than 0 and at most 1"]),
        ({"curvature_tolerance": 0}, ["curvature_tolerance", "greater than 0"]),
        ({"angle_tolerance": 0}, ["angle_tolerance", "greater than 0", "'Constrained Newton'"]),
    ],
)
def test_bad_parameters_are_named(shell, arguments, words):
    with pytest.raises(meshlab_developable.InvalidParameterError) as caught:
        meshlab_developable.make_developable(*shell, **arguments)
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize(
    ("vertices", "faces", "words"),
    [
        ([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]], "n x 3"),
        ([["a", "b", "c"]], [[0, 0, 0]], "numbers"),
        (np.zeros((0, 3)), np.zeros((0, 3), dtype=int), "0 vertices and 0 faces"),
        (np.eye(3), np.zeros((0, 3), dtype=int), "3 vertices and 0 faces"),
        (np.eye(3), [[0, 1]], "m x 3"),
        (np.eye(3), [[0.0, 1.0, 2.0]], "whole numbers"),
        (np.eye(3), [[0, 1, 3], [0, 1, 2], [-1, 0, 1]], "2 faces"),
    ],
)
def test_bad_arrays_are_refused(vertices, faces, words):
    with pytest.raises(meshlab_developable.InvalidMeshError, match=words):
        meshlab_developable.measure(vertices, faces)


def test_the_filters_refusal_comes_in_its_own_words():
    tetrahedron = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    positions = np.concatenate([np.zeros((1, 3)), np.eye(3)])
    with pytest.raises(meshlab_developable.FilterError) as caught:
        meshlab_developable.make_developable(positions, tetrahedron, method="local")
    assert "closed" in str(caught.value)
    assert "Failed to apply" not in str(caught.value)


def filter_parameters(name):
    """The parameters that pymeshlab itself knows of a filter; it only prints them."""
    script = (
        f"import pymeshlab as p, meshlab_developable as d; d.load(); p.print_filter_parameter_list({name!r})"
    )
    printed = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    ).stdout
    return set(re.findall(r"^\s*(\w+) : ", printed, re.MULTILINE))


@pytest.mark.parametrize("known", filters.FILTERS, ids=lambda known: known.name)
def test_every_parameter_of_the_filters_is_known(known):
    assert filter_parameters(known.function) == {parameter.name for parameter in known.parameters}


def test_every_status_has_words_of_its_own():
    assert len({status.text for status in Status}) == len(Status) == 6


SHOE_PLY = ROOT / "meshes" / "shoe_upper.ply"


def load_direct(path):
    plugin.load()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes


def arrays_of(path):
    meshes = load_direct(path)  # a mesh dies with its set
    mesh = meshes.current_mesh()
    return np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix())


def test_files_and_objects_give_what_arrays_give(tmp_path):
    meshio, trimesh = pytest.importorskip("meshio"), pytest.importorskip("trimesh")
    vertices, faces = arrays_of(SHOE_PLY)
    expected = meshlab_developable.make_developable(vertices, faces)
    in_vtk = tmp_path / "shoe.vtk"  # pymeshlab does not read it
    by_meshio = meshio.Mesh(vertices, [("triangle", faces)])
    by_meshio.write(in_vtk)
    by_trimesh = trimesh.Trimesh(vertices, faces, process=False)
    for source in (SHOE_PLY, str(SHOE_PLY), in_vtk, by_meshio, by_trimesh):
        result = meshlab_developable.make_developable(source)
        assert np.array_equal(result.vertices, expected.vertices)
        assert np.array_equal(result.quality, expected.quality)


@pytest.mark.parametrize("applied", [filters.GLOBAL, filters.LOCAL])
def test_the_result_is_the_filters_to_the_last_bit(applied):
    vertices, faces = arrays_of(SHOE_PLY)
    meshes = load_direct(SHOE_PLY)
    values = meshes.apply_filter(applied.function)
    result = meshlab_developable.make_developable(vertices, faces, method=applied.name)
    assert np.array_equal(result.vertices, meshes.current_mesh().vertex_matrix())
    assert np.array_equal(result.quality, plugin.vertex_quality(meshes.current_mesh()))
    apart = {"seconds", "reason"}
    assert {key: getattr(result.report, key) for key in values if key not in apart} == {
        key: value for key, value in values.items() if key not in apart
    }


def test_fixed_vertices_stay(shell):
    fixed = np.zeros(len(shell[0]), dtype=bool)
    fixed[::7] = True
    result = meshlab_developable.make_developable(*shell, fix_selected=fixed, max_iterations=5)
    assert np.array_equal(result.vertices[fixed], shell[0][fixed])
    assert not np.array_equal(result.vertices, shell[0])


def test_only_patches_with_a_selected_face_are_worked_on():
    positions, triangles, _ = reference.read_obj(ROOT / "meshes" / "short_pants.obj")
    chosen = np.zeros(len(triangles), dtype=bool)
    chosen[0] = True
    result = meshlab_developable.make_developable(
        positions, triangles, method="local", only_selected=chosen, max_operations=2000
    )
    moved = np.flatnonzero((result.vertices != positions).any(axis=1))
    component = {int(v) for v in triangles[0]}
    while (more := component.union(*triangles[np.isin(triangles, list(component)).any(axis=1)])) != component:
        component = more
    assert 0 < len(moved) < len(component) < len(positions)
    assert set(moved) <= component


def in_two_halves(shell):
    """Labels that part the shell in two by the faces' centres, as texts."""
    centres = shell[0][shell[1]].mean(axis=1)
    return np.where(centres[:, 0] < np.median(centres[:, 0]), "left", "right")


def test_labels_part_a_mesh_into_patches(shell):
    labels = in_two_halves(shell)
    whole, halves = (
        meshlab_developable.measure(*shell, **options).measures for options in ({}, {"face_labels": labels})
    )
    assert (whole.patches, halves.patches) == (1, 2)
    assert halves.interior_vertices < whole.interior_vertices
    assert halves.assembling_vertices > 0


def test_texture_islands_part_a_mesh_into_patches(shell):
    corners = shell[0][shell[1]][:, :, :2].copy()
    corners[in_two_halves(shell) == "left"] += 100
    by_corner = meshlab_developable.measure(*shell, texture_coordinates=corners).measures
    assert by_corner.patches == 2
    by_vertex = meshlab_developable.measure(*shell, texture_coordinates=shell[0][:, :2]).measures
    assert by_vertex.patches == 1


def test_maps_to_a_reference(shell):
    moved = shell[0] + [0.25, 0, 0]
    result = meshlab_developable.measure(moved, shell[1], map="Displacement", reference=shell)
    assert result.quality == pytest.approx(np.full(len(moved), 0.25))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"only_selected": [True]}, ["only_selected", "961 faces"]),
        ({"fix_selected": np.zeros(524)}, ["fix_selected", "524 vertices", "float64"]),
        ({"face_labels": [1, 2]}, ["face_labels", "961"]),
        ({"face_labels": [np.nan, 2.0] * 480 + [np.nan]}, ["481 of the 961 face_labels", "face 0"]),
        ({"texture_coordinates": np.zeros((3, 2))}, ["524 x 2", "961 x 3 x 2"]),
    ],
)
def test_bad_masks_and_labels_are_named(shell, arguments, words):
    with pytest.raises(meshlab_developable.InvalidMeshError) as caught:
        meshlab_developable.make_developable(*shell, **arguments)
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize("source", ["no_such_mesh.ply", 7, np.eye(3)])
def test_a_source_that_is_no_mesh_is_refused(source):
    with pytest.raises(meshlab_developable.InvalidMeshError):
        meshlab_developable.measure(source)
