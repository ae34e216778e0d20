# SPDX-License-Identifier: GPL-3.0-or-later
"""What can't be worked on: the sentence reaches the log, which is all that meshlabserver prints, and the
program ends in its own way (255) rather than by abort (134)."""

import mlx_scripts
import numpy as np
import pytest
import server
from shapes import bump, octahedron

GLOBAL, LOCAL, MAPS = mlx_scripts.GLOBAL, mlx_scripts.LOCAL, mlx_scripts.MAPS
ALL = pytest.mark.parametrize("name", [GLOBAL, LOCAL, MAPS])
BOTH = pytest.mark.parametrize("name", [GLOBAL, LOCAL])


def refusal(tmp_path, mesh, *filters):
    """The last line of the log of a run that was refused: the server goes on with "Problem with filter"."""
    run = server.run_filters(tmp_path, mesh, *filters)
    assert run.exit_code == 255, run.printed
    assert not (tmp_path / "out.ply").exists()
    log, _, _ = run.printed.partition("Problem with filter")
    return log.splitlines()[-1]


@BOTH
def test_no_mesh(name, tmp_path):
    script = mlx_scripts.write_script(tmp_path / "run.mlx", mlx_scripts.filter_element(name))
    run = server.run(script)
    assert run.exit_code == 255, run.printed
    assert "There is no mesh: open one first." in run.printed


@ALL
def test_no_faces(name, tmp_path):
    sentence = refusal(tmp_path, (bump()[0], None), mlx_scripts.filter_element(name))
    assert "no faces: open a mesh with faces" in sentence


@ALL
def test_a_coordinate_that_is_no_number(name, tmp_path):
    spoil, ours = mlx_scripts.spoiled_vertex(20), mlx_scripts.filter_element(name)
    sentence = refusal(tmp_path, bump(), spoil, ours)
    assert sentence == "1 vertex has a coordinate that is infinite or not a number: remove it. See vertex 20."


@ALL
def test_a_face_without_area(name, tmp_path):
    positions, triangles = bump()
    positions[triangles[7][0]] = (positions[triangles[7][1]] + positions[triangles[7][2]]) / 2
    assert "no area: remove" in refusal(tmp_path, (positions, triangles), mlx_scripts.filter_element(name))


@BOTH
def test_a_closed_patch(name, tmp_path):
    sentence = refusal(tmp_path, octahedron(), mlx_scripts.filter_element(name))
    assert "1 of 1 patch is closed" in sentence
    assert "cut it open ('developable cut' on the command line, the filter Cut into Developable" in sentence


@pytest.mark.parametrize(
    ("name", "parameter", "value"),
    [
        (GLOBAL, "solver", 5),
        (GLOBAL, "patches", -1),
        (GLOBAL, "weld_distance", -2.0),
        (GLOBAL, "angle_tolerance", float("nan")),
        (GLOBAL, "curvature_tolerance", -1.0),
        (GLOBAL, "max_iterations", -5),
        (GLOBAL, "relative_change", float("inf")),
        (GLOBAL, "smoothness", -1.0),
        (GLOBAL, "map", 7),
        (LOCAL, "angle_tolerance", -1.0),
        (LOCAL, "max_displacement", float("nan")),
        (LOCAL, "max_operations", -1),
        (LOCAL, "smoothing", -1.0),
        (LOCAL, "assembling_vertices", 2),
        (MAPS, "map", 99),
        (MAPS, "angle_tolerance", -1.0),
    ],
)
def test_a_parameter_out_of_range(name, parameter, value, tmp_path):
    sentence = refusal(tmp_path, bump(), mlx_scripts.filter_element(name, **{parameter: value}))
    assert sentence.startswith(f"The parameter '{parameter}' is ")
    assert ": choose " in sentence


def test_the_map_of_flattening_a_closed_surface(tmp_path):
    element = mlx_scripts.filter_element(MAPS, map="Elastic energy")
    assert "closed" in refusal(tmp_path, octahedron(), element)


@BOTH
def test_nothing_selected(name, tmp_path):
    element = mlx_scripts.filter_element(name, only_selected=True)
    assert "No face is selected" in refusal(tmp_path, bump(), element)


def test_a_map_of_change_before_any_change(tmp_path):
    element = mlx_scripts.filter_element(MAPS, map="Displacement")
    assert "'original_position'" in refusal(tmp_path, bump(), element)


def test_infinite_coordinates(tmp_path):
    positions, triangles = bump()
    positions[5] = np.inf
    run_positions = (positions, triangles)
    assert "infinite" in refusal(tmp_path, run_positions, mlx_scripts.filter_element(GLOBAL))


def test_the_original_shape_is_lost_in_a_file(tmp_path):
    server.results(tmp_path, bump(), mlx_scripts.filter_element(GLOBAL))
    script = mlx_scripts.write_script(tmp_path / "maps.mlx", mlx_scripts.filter_element(MAPS, map="Distance"))
    run = server.run(script, tmp_path / "out.ply", tmp_path / "maps.ply")
    assert run.exit_code == 255
    assert "load the original too and choose it as 'reference'" in run.printed
