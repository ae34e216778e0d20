# SPDX-License-Identifier: GPL-3.0-or-later
"""Global and Local Developability: what they return and write, against measures computed apart."""

import measures
import numpy as np
import pymeshlab
import pytest
from mesh_sets import (
    GLOBAL,
    LOCAL,
    MAPS,
    Length,
    Percentage,
    attribute_of,
    mesh_set,
    optimized,
    positions_of,
    quality_of,
)
from reference_measures import angle_defects, rim_edges
from shapes import bump, cylinder, two_bumps

BOTH = pytest.mark.parametrize("name", [GLOBAL, LOCAL])
COMMON_KEYS = {
    *(f"{key}_{when}" for when in ("before", "after") for key in measures.shape_measures(*cylinder())),
    "total_absolute_curvature_before_rounding",
    "patches",
    "assembling_vertices",
    "interior_vertices",
    "deformation_energy",
    "max_displacement",
    "max_displacement_per_cent",
    "mean_displacement",
    "max_distance",
    "panels_converged",
    "panels_need_cut",
    "nearest_developable",
    "border_overlaps",
    "edge_strain_left",
    "iterations",
    "converged",
    "status",
    "reason",
    "patches_needing_cut",
    "worst_x",
    "worst_y",
    "worst_z",
    "seconds",
}
GLOBAL_KEYS = {"max_stretch", "max_compression", "max_border_angle", "collapsed_faces"}
LOCAL_KEYS = {"set_aside", "refused_moves", "roughness_before", "roughness_after"}
INTEGERS = {
    "collapsed_faces",
    "patches",
    "border_overlaps",
    "assembling_vertices",
    "interior_vertices",
    "panels_converged",
    "panels_need_cut",
    "iterations",
    "status",
    "reason",
    "patches_needing_cut",
    "set_aside",
    "refused_moves",
}


def boundary_of(triangles):
    return np.unique(rim_edges(triangles))


@BOTH
def test_returns_the_keys_of_the_interface_with_their_types(name):
    _, returned = optimized(bump(), name)
    assert set(returned) == COMMON_KEYS | (LOCAL_KEYS if name == LOCAL else GLOBAL_KEYS)
    for key, value in returned.items():
        expected = bool if key == "converged" else int if key in INTEGERS else float
        assert type(value) is expected, key


@BOTH
def test_returns_what_can_be_measured_on_the_meshes(name):
    original, triangles = bump()
    meshes, returned = optimized((original, triangles), name)
    positions = positions_of(meshes)
    moved = np.linalg.norm(positions - original, axis=1)
    expected = {
        **{f"{key}_before": value for key, value in measures.shape_measures(original, triangles).items()},
        **{f"{key}_after": value for key, value in measures.shape_measures(positions, triangles).items()},
        "patches": 1,
        "assembling_vertices": 0,
        "interior_vertices": len(original) - len(boundary_of(triangles)),
        "deformation_energy": measures.deformation_energy(original, positions, triangles),
        "max_displacement": moved.max(),
        "mean_displacement": moved.mean(),
        "max_distance": measures.distance_to_surface(positions, original, triangles).max(),
    }
    if name == LOCAL:
        expected["roughness_before"] = measures.roughness(original, triangles)
        expected["roughness_after"] = measures.roughness(positions, triangles)
    assert {key: returned[key] for key in expected} == pytest.approx(expected, rel=1e-9, abs=1e-12)


@BOTH
def test_makes_a_bump_more_developable(name):
    _, returned = optimized(bump(), name)
    assert returned["detect_function_after"] < 0.5 * returned["detect_function_before"]
    assert returned["total_absolute_curvature_after"] < returned["total_absolute_curvature_before"]
    assert returned["max_displacement"] > 0


@BOTH
def test_a_developable_sheet_has_nothing_to_do(name):
    original, triangles = cylinder()
    meshes, returned = optimized((original, triangles), name)
    assert np.array_equal(positions_of(meshes), original)
    assert returned["status"] == 5
    assert returned["converged"] is True
    assert returned["iterations"] == 0
    assert returned["max_displacement"] == 0


@BOTH
def test_the_limit_is_a_status(name):
    limit = "max_operations" if name == LOCAL else "max_iterations"
    _, returned = optimized(bump(), name, **{limit: 3})
    assert returned["status"] == 2
    assert returned["iterations"] == 3
    assert returned["converged"] is False


@BOTH
def test_writes_map_original_positions_colours_and_normals(name):
    original, triangles = bump()
    meshes, _ = optimized((original, triangles), name, map="Angle defect")
    defects = angle_defects(positions_of(meshes), triangles)
    np.testing.assert_allclose(quality_of(meshes), defects, atol=1e-12)
    np.testing.assert_allclose(attribute_of(meshes, "angle_defect"), defects, atol=1e-12)
    assert np.array_equal(attribute_of(meshes, "original_position"), original)
    mesh = meshes.current_mesh()
    assert mesh.has_vertex_color()
    assert mesh.has_vertex_scalar()
    fresh = mesh_set((positions_of(meshes), triangles))
    fresh.apply_filter(
        "compute_normal_per_vertex"
        if "compute_normal_per_vertex" in pymeshlab.filter_list()
        else "compute_normals_for_point_sets"
    )
    directions = [
        m.vertex_normal_matrix() / np.linalg.norm(m.vertex_normal_matrix(), axis=1)[:, None]
        for m in (mesh, fresh.current_mesh())
    ]
    assert np.sum(directions[0] * directions[1], axis=1).min() > 0.99
    box = mesh.bounding_box()
    assert np.array_equal(box.min(), positions_of(meshes).min(axis=0))
    assert np.array_equal(box.max(), positions_of(meshes).max(axis=0))


@pytest.mark.parametrize(
    ("title", "attribute"),
    [("Distance", "distance"), ("Displacement", "displacement"), ("Gaussian map", "gaussian_map")],
)
def test_each_map_goes_to_quality_and_to_its_attribute(title, attribute):
    original, triangles = bump()
    meshes, _ = optimized((original, triangles), map=title)
    positions = positions_of(meshes)
    expected = {
        "distance": measures.distance_to_surface(positions, original, triangles),
        "displacement": np.linalg.norm(positions - original, axis=1),
        "gaussian_map": angle_defects(positions, triangles) ** 2,
    }[attribute]
    np.testing.assert_allclose(quality_of(meshes), expected, rtol=1e-7, atol=1e-12)
    assert np.array_equal(attribute_of(meshes, attribute), quality_of(meshes))


@pytest.mark.parametrize("name", [GLOBAL, LOCAL, MAPS])
def test_colours_stay_when_colorize_is_off(name):
    meshes = mesh_set(bump())
    before = meshes.current_mesh().vertex_color_matrix()
    meshes.apply_filter(name, colorize=False)
    assert np.array_equal(meshes.current_mesh().vertex_color_matrix(), before)


def test_original_positions_are_those_of_the_last_run():
    meshes, _ = optimized(bump(), GLOBAL, max_iterations=2)
    between = positions_of(meshes)
    meshes.apply_filter(LOCAL)
    assert np.array_equal(attribute_of(meshes, "original_position"), between)


def test_enumerations_take_text_or_index():
    by_text, _ = optimized(bump(), map="Displacement", solver="Conjugate gradient")
    by_index, _ = optimized(bump(), map=6, solver=1)
    assert np.array_equal(quality_of(by_text), quality_of(by_index))


@BOTH
def test_seams_stay_closed_to_the_last_bit(name):
    original, triangles = two_bumps()
    meshes, returned = optimized((original, triangles), name)
    positions = positions_of(meshes)
    half = len(original) // 2
    seam = np.flatnonzero(original[:half, 0] == 0)
    assert returned["patches"] == 2
    assert returned["assembling_vertices"] == len(seam)
    assert np.array_equal(positions[seam], positions[seam + half])
    if name == GLOBAL:
        assert not np.array_equal(positions[seam], original[seam])
    else:
        assert np.array_equal(positions[seam], original[seam])


def test_weld_distance_links_what_is_near():
    mesh = two_bumps(gap=1e-3)
    assert optimized(mesh)[1]["assembling_vertices"] == 0
    meshes, returned = optimized(mesh, weld_distance=Length(2e-3))
    half = len(mesh[0]) // 2
    seam = np.flatnonzero(mesh[0][:half, 0] == 0)
    assert returned["assembling_vertices"] == len(seam)
    assert np.array_equal(positions_of(meshes)[seam], positions_of(meshes)[seam + half])


@BOTH
def test_only_selected_leaves_the_other_patch_alone(name):
    original, triangles = two_bumps(gap=1)
    half = len(original) // 2
    meshes = mesh_set((original, triangles))
    meshes.apply_filter("compute_scalar_by_function_per_vertex", q="7")
    select = "compute_selection_by_condition_per_face"
    meshes.apply_filter(select, condselect="x0 > 0.4 && x0 < 0.5")
    selected = meshes.current_mesh().selected_face_number()
    returned = meshes.apply_filter(name, only_selected=True)
    assert 0 < selected < len(triangles) / 4
    assert returned["patches"] == 1
    assert meshes.current_mesh().selected_face_number() == selected
    moved = np.any(positions_of(meshes) != original, axis=1)
    assert moved[:half].any()
    assert not moved[half:].any()
    assert np.all(quality_of(meshes)[half:] == 7)
    assert np.array_equal(attribute_of(meshes, "original_position"), original)
    assert np.all(attribute_of(meshes, "displacement")[half:] == 0)


def test_fixed_vertices_stay():
    original, triangles = bump()
    boundary = boundary_of(triangles)
    meshes, _ = optimized((original, triangles), fix_boundary=True)
    moved = np.any(positions_of(meshes) != original, axis=1)
    assert moved.any()
    assert not moved[boundary].any()
    for name in (GLOBAL, LOCAL):
        meshes = mesh_set((original, triangles))
        meshes.apply_filter("compute_selection_by_condition_per_vertex", condselect="x > 0.5")
        held = meshes.current_mesh().vertex_selection_array()
        meshes.apply_filter(name, fix_selected=True)
        moved = np.any(positions_of(meshes) != original, axis=1)
        assert moved.any()
        assert not moved[held].any()


def test_local_holds_the_boundary_and_the_largest_displacement():
    original, triangles = bump()
    meshes, returned = optimized((original, triangles), LOCAL, max_displacement=Length(0.01))
    moved = np.linalg.norm(positions_of(meshes) - original, axis=1)
    assert 0 < moved.max() <= 0.01 * (1 + 1e-12)
    assert returned["max_displacement"] == pytest.approx(moved.max())
    assert not moved[boundary_of(triangles)].any()


def test_minus_one_means_the_mean_edge_length():
    original, triangles = bump()
    mean = float(measures.edge_lengths(original, triangles).mean())
    automatic, _ = optimized((original, triangles), LOCAL)
    moved = np.linalg.norm(positions_of(automatic) - original, axis=1)
    assert 0.99 * mean < moved.max() <= mean * (1 + 1e-12)
    for value in (-1.0, -7.5):
        given, _ = optimized((original, triangles), LOCAL, max_displacement=Length(value))
        assert np.array_equal(positions_of(given), positions_of(automatic))


def test_a_percentage_is_of_the_diagonal():
    original, triangles = bump()
    diagonal = np.linalg.norm(original.max(axis=0) - original.min(axis=0))
    # Few operations: the paper's iteration soon turns the host's rounding of a length into another shape.
    few = {"max_operations": 200}
    by_percentage, _ = optimized((original, triangles), LOCAL, max_displacement=Percentage(0.2), **few)
    by_length, _ = optimized((original, triangles), LOCAL, max_displacement=Length(0.002 * diagonal), **few)
    moved = np.linalg.norm(positions_of(by_length) - original, axis=1)
    assert moved.max() == pytest.approx(0.002 * diagonal)
    np.testing.assert_allclose(positions_of(by_percentage), positions_of(by_length), atol=1e-6)


def test_largest_displacement_of_zero_moves_nothing():
    original, triangles = bump()
    meshes, returned = optimized((original, triangles), LOCAL, max_displacement=Length(0))
    assert np.array_equal(positions_of(meshes), original)
    assert returned["status"] == 1


@BOTH
def test_runs_repeat_to_the_last_bit(name):
    first, _ = optimized(bump(), name)
    second, _ = optimized(bump(), name)
    assert np.array_equal(positions_of(first), positions_of(second))
