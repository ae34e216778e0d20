# SPDX-License-Identifier: GPL-3.0-or-later
"""Allowed strain, materials and grain in the filters."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from mesh_sets import Length, mesh_set, state_of

GLOBAL, FLATTEN = "apply_coord_global_developability", "generate_flat_patches"


def bump(columns=13, height=0.12):
    """A bump on a square, its diagonals alternating."""
    u, v = np.meshgrid(np.linspace(0, 1, columns), np.linspace(0, 1, columns))
    z = height * np.exp(-12 * ((u - 0.5) ** 2 + (v - 0.5) ** 2))
    index = np.arange(columns * columns).reshape(columns, columns)
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    odd = np.indices(a.shape).sum(axis=0) % 2 == 1
    first = np.where(odd[..., None], np.stack([a, b, d], -1), np.stack([a, b, c], -1))
    second = np.where(odd[..., None], np.stack([b, c, d], -1), np.stack([a, c, d], -1))
    return np.stack([u, v, z], -1).reshape(-1, 3), np.concatenate([first, second]).reshape(-1, 3)


def strains(shaped, flat, faces):
    """Both singular values of every triangle's map from the pattern to the shape."""
    x, u = shaped[faces], flat[faces]
    edges_x = np.stack([x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]], axis=2)
    edges_u = np.stack([u[:, 1] - u[:, 0], u[:, 2] - u[:, 0]], axis=2)
    return np.linalg.svd(edges_x @ np.linalg.inv(edges_u), compute_uv=False)


def moved_and_flat(values):
    """The shape after Global, its pattern after Flatten, and what both returned."""
    vertices, faces = bump()
    meshes = mesh_set((vertices, faces))
    report = meshes.apply_filter(GLOBAL, **values)
    shape = meshes.current_mesh().vertex_matrix().copy()
    meshes = mesh_set((shape, faces))  # as saved and loaded again: nothing is left of the first run
    pattern = meshes.apply_filter(FLATTEN, **values)
    return report, pattern, shape, meshes.current_mesh().vertex_matrix()[:, :2].copy(), faces


def test_the_pattern_of_the_result_keeps_both_bounds():
    values = {"allowed_stretch": 1.5, "allowed_compression": 1.0}
    report, pattern, shape, flat, faces = moved_and_flat(values)
    assert report["converged"]
    found = strains(shape, flat, faces)
    assert found[:, 0].max() - 1 < 0.015 + 1e-4
    assert 1 - found[:, 1].min() < 0.010 + 1e-4
    for returned in (report, pattern):
        assert returned["max_stretch"] == pytest.approx(100 * (found[:, 0].max() - 1), abs=1e-3)
        assert returned["max_compression"] == pytest.approx(100 * (1 - found[:, 1].min()), abs=1e-3)


def test_with_nothing_allowed_all_is_as_without_a_material():
    results = []
    for values in ({}, {"material": "Paper"}, {"allowed_stretch": 0.0, "allowed_compression": 0.0}):
        _, _, shape, flat, _ = moved_and_flat(values)
        results.append((shape, flat))
    for shape, flat in results[1:]:
        assert np.array_equal(shape, results[0][0])
        assert np.array_equal(flat, results[0][1])


def test_a_material_brings_its_smoothness_unless_another_is_asked_for():
    shapes = {}
    for name, values in {
        "as the material": {},
        "the same": {"smoothness": 3e-5},
        "asked for": {"smoothness": 1e-3},
    }.items():
        meshes = mesh_set(bump())
        meshes.apply_filter(GLOBAL, material="Sheet steel", **values)
        shapes[name] = meshes.current_mesh().vertex_matrix().copy()
    assert np.array_equal(shapes["as the material"], shapes["the same"])
    assert not np.array_equal(shapes["as the material"], shapes["asked for"])


def test_the_more_is_allowed_the_less_it_moves_and_what_fits_stays():
    moves = []
    for bound in (0.0, 0.5, 1.5, 20.0):
        values = {"allowed_stretch": bound, "allowed_compression": bound}
        report = mesh_set(bump()).apply_filter(GLOBAL, **values)
        moves.append(report["mean_displacement"])
    assert moves[0] > moves[1] > moves[2] > moves[3] == 0


def test_a_directed_material_has_its_grain_along_an_axis():
    vertices, faces = bump(height=0.2)
    energies = {}
    for grain in ("X axis", "Y axis"):
        meshes = mesh_set((vertices * [1.0, 0.6, 1.0], faces))
        energies[grain] = meshes.apply_filter(FLATTEN, material="Knit", grain=grain)["elastic_energy"]
        assert (
            strains(vertices * [1.0, 0.6, 1.0], meshes.current_mesh().vertex_matrix()[:, :2], faces)[
                :, 1
            ].min()
            < 1
        )
    assert energies["X axis"] != energies["Y axis"]


@pytest.mark.parametrize("chosen", ["Stretch", "Compression"])
def test_maps_of_strain_are_of_the_triangles_at_each_vertex(chosen):
    vertices, faces = bump()
    meshes = mesh_set((vertices, faces))
    returned = meshes.apply_filter(FLATTEN, map=chosen)
    quality = meshes.current_mesh().vertex_scalar_array()
    found = strains(vertices, meshes.current_mesh().vertex_matrix()[:, :2], faces)
    values = np.maximum(found[:, 0] - 1 if chosen == "Stretch" else 1 - found[:, 1], 0)
    expected = np.zeros(len(vertices))
    np.maximum.at(expected, faces.ravel(), np.repeat(values, 3))
    assert quality == pytest.approx(expected, abs=1e-9)
    assert 100 * quality.max() == pytest.approx(returned[f"max_{chosen.lower()}"])


def test_bending_radius_of_a_cylinder():
    u, v = np.meshgrid(np.linspace(0, 1.5, 25), np.linspace(0, 1, 15))
    _, faces = bump(2)
    index = np.arange(25 * 15).reshape(15, 25)
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    faces = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    vertices = np.stack([3 * np.cos(u), 3 * np.sin(u), 3 * v], -1).reshape(-1, 3)
    meshes = mesh_set((vertices, faces))
    meshes.apply_filter("compute_scalar_by_developability_per_vertex", map="Bending radius")
    assert np.median(meshes.current_mesh().vertex_scalar_array()) == pytest.approx(3, rel=0.02)


def test_a_thickness_keeps_a_sheet_above_its_radius_where_it_can():
    vertices, faces = bump(height=0.2)
    shares = []
    for thickness in (0.0, 1.5e-3):  # steel of that thickness bears a radius of 0.625
        meshes = mesh_set((vertices, faces))
        values = meshes.apply_filter(GLOBAL, material="Sheet steel", thickness=Length(thickness))
        assert values["converged"]
        assert max(values["max_stretch"], values["max_compression"]) < 0.13 + 1e-9
        shape = meshes.current_mesh().vertex_matrix().copy()
        meshes = mesh_set((shape, faces))
        meshes.apply_filter("compute_scalar_by_developability_per_vertex", map="Bending radius")
        shares.append((meshes.current_mesh().vertex_scalar_array() < 1.5e-3 / (2 * 0.0012)).mean())
    assert shares[0] > 0.1
    assert shares[1] == 0


@pytest.mark.parametrize("filter_name", [GLOBAL, FLATTEN])
@pytest.mark.parametrize(
    "values",
    [
        {"allowed_stretch": -0.5},
        {"allowed_stretch": -2.0},
        {"allowed_stretch": 2000.0},
        {"allowed_stretch": float("nan")},
        {"allowed_compression": 100.0},
        {"allowed_compression": -0.1},
        {"allowed_compression": float("inf")},
    ],
)
def test_bad_bounds_are_refused_and_change_nothing(filter_name, values):
    meshes = mesh_set(bump(5))
    before = state_of(meshes)
    with pytest.raises(pymeshlab.PyMeshLabException, match="allowed"):
        meshes.apply_filter(filter_name, **values)
    assert state_of(meshes) == before


def test_no_vertex_goes_farther_than_it_may_and_bounds_hold_where_they_can():
    vertices, faces = bump()
    values = {"allowed_stretch": 1.0, "allowed_compression": 1.0}
    free = mesh_set((vertices, faces)).apply_filter(GLOBAL, **values)
    allowed = 0.9 * free["max_displacement"]
    near = mesh_set((vertices, faces)).apply_filter(GLOBAL, max_displacement=Length(allowed), **values)
    assert near["max_displacement"] <= allowed
    if near["converged"]:
        assert max(near["max_stretch"], near["max_compression"]) < 1.01
    too_near = 0.1 * free["max_displacement"]
    beyond = mesh_set((vertices, faces)).apply_filter(GLOBAL, max_displacement=Length(too_near), **values)
    assert beyond["max_displacement"] <= too_near
    assert not beyond["converged"]
    assert beyond["nearest_developable"] == pytest.approx(free["max_displacement"], rel=0.02)
    assert max(beyond["max_stretch"], beyond["max_compression"]) > 1.01
