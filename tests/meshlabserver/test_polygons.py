# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangulate Polygons in meshlabserver 2020.09, on polygons that it loads from PLY."""

import mlx_scripts
import numpy as np
import polygons
import pytest
import server

FILTER = mlx_scripts.host_filter("Triangulate Polygons (Constrained Delaunay)")  # it has no parameters
KINDS = {
    "kite": polygons.kite(),
    "comb": polygons.comb(),
    "star": polygons.star(),
    "sheet_of_quads": polygons.sheet_of_quads(),
}


@pytest.fixture
def triangulated(tmp_path):
    """Runs the filter on polygons; returns the run and what it saved, points and triangles."""

    def run(mesh):
        source, target = polygons.write_ply(tmp_path / "in.ply", mesh), tmp_path / "out.ply"
        outcome = server.run(mlx_scripts.write_script(tmp_path / "run.mlx", FILTER), source, target)
        assert outcome.exit_code == 0, outcome.printed
        saved = server.load(target)  # the mesh lives no longer than its mesh set
        return outcome.values, saved.current_mesh().vertex_matrix(), saved.current_mesh().face_matrix()

    return run


@pytest.mark.parametrize("kind", KINDS)
def test_polygons_become_constrained_delaunay(triangulated, kind):
    points, loops = KINDS[kind]
    values, saved_points, triangles = triangulated(KINDS[kind])
    assert values["polygons"] == str(len(loops))
    assert int(values["edges_changed"]) > 0
    assert values["skipped"] == "0"
    assert np.array_equal(saved_points, points.astype(np.float32))
    for loop in loops:
        polygons.expect_constrained_delaunay(saved_points, loop, polygons.triangles_in(triangles, loop))


def test_hosts_agree(triangulated, tmp_path):
    _, _, triangles = triangulated(polygons.sheet_of_quads(12, 9))
    meshes = server.load(tmp_path / "in.ply")
    meshes.apply_filter(polygons.TRIANGULATE)
    assert np.array_equal(meshes.current_mesh().face_matrix(), triangles)


def test_a_polygon_that_crosses_itself_is_left_alone_and_counted(triangulated):
    values, _, triangles = triangulated(polygons.kite_and_bow_tie())
    assert (values["polygons"], values["edges_changed"], values["skipped"]) == ("2", "1", "1")
    assert sorted(map(sorted, triangles[2:].tolist())) == [[4, 5, 6], [4, 6, 7]]


def test_a_coordinate_that_is_no_number_is_said_in_the_log(tmp_path):
    script = mlx_scripts.write_script(tmp_path / "run.mlx", mlx_scripts.spoiled_vertex(2), FILTER)
    outcome = server.run(
        script, polygons.write_ply(tmp_path / "in.ply", polygons.kite()), tmp_path / "out.ply"
    )
    assert outcome.exit_code == 255, outcome.printed
    assert "1 vertex has a coordinate that is infinite or not a number: remove it." in outcome.printed
    assert not (tmp_path / "out.ply").exists()
