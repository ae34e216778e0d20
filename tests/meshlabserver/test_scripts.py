# SPDX-License-Identifier: GPL-3.0-or-later
"""One .mlx file runs unchanged in meshlabserver 2020.09 and in pymeshlab. What the server saves is read back
and compared with its log, with measures computed apart, and with pymeshlab's result to a float's last bit."""

import measures
import mlx_scripts
import numpy as np
import pytest
import server
from mesh_sets import positions_of, quality_of
from reference_measures import angle_defects
from shapes import bump, octahedron, two_bumps

OPTIMIZERS = pytest.mark.parametrize("name", [mlx_scripts.GLOBAL, mlx_scripts.LOCAL])
ALL = pytest.mark.parametrize("name", [mlx_scripts.GLOBAL, mlx_scripts.LOCAL, mlx_scripts.MAPS])


def in_floats(mesh):
    """The mesh as a host that computes in float reads it, so that every host starts from the same shape."""
    positions, triangles = mesh
    return positions.astype(np.float32).astype(np.float64), triangles


def by_pymeshlab(tmp_path):
    """The same script on the same file."""
    meshes = server.load(tmp_path / "in.ply")
    meshes.load_filter_script(str(tmp_path / "run.mlx"))
    meshes.apply_filter_script()
    return meshes


@ALL
def test_the_stored_script_runs_as_it_is(name, tmp_path):
    source = server.save_mesh(tmp_path / "in.ply", *bump())
    run = server.run(mlx_scripts.SCRIPTS / f"{name}.mlx", source, tmp_path / "out.ply")
    assert run.exit_code == 0, run.printed
    assert (tmp_path / "out.ply").exists()


@OPTIMIZERS
@pytest.mark.parametrize("make", [bump, two_bumps])
def test_the_log_says_what_the_saved_mesh_shows(name, make, tmp_path):
    original, triangles = in_floats(make())
    run, saved = server.results(tmp_path, (original, triangles), mlx_scripts.filter_element(name))
    positions = positions_of(saved)
    moved = np.linalg.norm(positions - original, axis=1)
    expected = {
        **{f"{key}_before": value for key, value in measures.shape_measures(original, triangles).items()},
        **{f"{key}_after": value for key, value in measures.shape_measures(positions, triangles).items()},
        "patches": 2 if make is two_bumps else 1,
        "deformation_energy": measures.deformation_energy(original, positions, triangles),
        "max_displacement": moved.max(),
        "max_distance": measures.distance_to_surface(positions, original, triangles).max(),
    }
    assert {key: run.number(key) for key in expected} == pytest.approx(expected, rel=1e-7, abs=1e-9)
    assert run.number("detect_function_after") < 0.5 * run.number("detect_function_before")
    np.testing.assert_allclose(quality_of(saved), moved, rtol=1e-5, atol=1e-6)
    assert saved.current_mesh().has_vertex_color()


@OPTIMIZERS
def test_rounding_is_told_apart(name, tmp_path):
    run, _ = server.results(tmp_path, in_floats(bump()), mlx_scripts.filter_element(name))
    before, after = (run.number(f"total_absolute_curvature_{key}") for key in ("before_rounding", "after"))
    assert before != after
    assert before == pytest.approx(after, abs=1e-3)


@OPTIMIZERS
@pytest.mark.parametrize("make", [bump, two_bumps])
def test_hosts_agree_to_the_last_bit_of_a_float(name, make, tmp_path):
    _, saved = server.results(tmp_path, in_floats(make()), mlx_scripts.filter_element(name))
    exact = by_pymeshlab(tmp_path)
    assert np.array_equal(positions_of(saved), positions_of(exact).astype(np.float32))
    assert not np.array_equal(positions_of(exact), positions_of(saved))


@OPTIMIZERS
def test_values_of_a_script_arrive(name, tmp_path):
    limit = "max_operations" if name == mlx_scripts.LOCAL else "max_iterations"
    values = {limit: 7, "angle_tolerance": 0.002, "map": "Displacement", "colorize": False}
    original, triangles = in_floats(bump())
    run, saved = server.results(tmp_path, (original, triangles), mlx_scripts.filter_element(name, **values))
    positions = positions_of(saved)
    assert run.number("iterations") == 7
    assert run.values["status"].startswith("stopped at the limit")
    expected = measures.shape_measures(positions, triangles, 0.002)["developability"]
    assert run.number("developability_after") == pytest.approx(expected, rel=1e-7)
    moved = np.linalg.norm(positions - original, axis=1)
    np.testing.assert_allclose(quality_of(saved), moved, rtol=1e-5, atol=1e-9)
    assert "vertex colours" not in run.values


@pytest.mark.parametrize("length", [-1.0, 0.01])
def test_lengths_arrive(length, tmp_path):
    original, triangles = in_floats(bump())
    element = mlx_scripts.filter_element(mlx_scripts.LOCAL, max_displacement=length)
    run, saved = server.results(tmp_path, (original, triangles), element)
    largest = length if length > 0 else measures.edge_lengths(original, triangles).mean()
    moved = np.linalg.norm(positions_of(saved) - original, axis=1)
    assert 0.9 * largest < moved.max() <= largest * (1 + 1e-6)
    assert run.number("max_displacement") == pytest.approx(moved.max(), rel=1e-7)


def test_status_says_d_and_c_in_words(tmp_path):
    run, _ = server.results(tmp_path, bump(), mlx_scripts.filter_element(mlx_scripts.GLOBAL))
    assert " D: " in run.values["status"]
    assert " C: " in run.values["status"]
    assert "rad of total absolute curvature" in run.values["status"]


@pytest.mark.parametrize("title", ["Gaussian map", "Angle defect", "Gaussian curvature"])
def test_maps_of_a_shape(title, tmp_path):
    positions, triangles = in_floats(bump())
    run, saved = server.results(
        tmp_path, (positions, triangles), mlx_scripts.filter_element(mlx_scripts.MAPS, map=title)
    )
    expected = measures.shape_measures(positions, triangles)
    assert {key: run.number(key) for key in expected} == pytest.approx(expected, rel=1e-7)
    defects = angle_defects(positions, triangles)
    values = {
        "Gaussian map": defects**2,
        "Angle defect": defects,
        "Gaussian curvature": measures.gaussian_curvatures(positions, triangles),
    }[title]
    np.testing.assert_allclose(quality_of(saved), values, rtol=1e-5, atol=1e-6)
    assert np.array_equal(positions_of(saved), positions)


@pytest.mark.parametrize("title", ["Distance", "Displacement"])
def test_maps_of_change_after_an_optimisation(title, tmp_path):
    original, triangles = in_floats(bump())
    _, saved = server.results(
        tmp_path,
        (original, triangles),
        mlx_scripts.filter_element(mlx_scripts.GLOBAL),
        mlx_scripts.filter_element(mlx_scripts.MAPS, map=title),
    )
    positions = positions_of(saved)
    expected = {
        "Distance": measures.distance_to_surface(positions, original, triangles),
        "Displacement": np.linalg.norm(positions - original, axis=1),
    }[title]
    np.testing.assert_allclose(quality_of(saved), expected, rtol=1e-5, atol=1e-7)


def test_maps_accept_closed_surfaces(tmp_path):
    run, _ = server.results(tmp_path, octahedron(), mlx_scripts.filter_element(mlx_scripts.MAPS))
    assert run.number("total_absolute_curvature") == pytest.approx(4 * np.pi, rel=1e-7)


@OPTIMIZERS
def test_the_way_back_gives_the_file_that_was_read(name, tmp_path):
    original, triangles = in_floats(bump())
    back = mlx_scripts.filter_element("restore_original_shape")
    run, saved = server.results(tmp_path, (original, triangles), mlx_scripts.filter_element(name), back)
    assert np.array_equal(positions_of(saved), original)
    assert run.number("moved_vertices") > 0
