# SPDX-License-Identifier: GPL-3.0-or-later
"""Developability Maps: what it returns and writes, against measures computed apart."""

import measures
import numpy as np
import pymeshlab
import pytest
from mesh_sets import GLOBAL, MAPS, attribute_of, has_attribute, mesh_set, optimized, positions_of, quality_of
from meshlab_developable.colours import colour_range, map_colours
from reference_measures import angle_defects
from shapes import bump, cylinder, octahedron, two_bumps


def bytes_of_colours(meshes):
    """Red, green and blue of every vertex."""
    return np.rint(meshes.current_mesh().vertex_color_matrix()[:, :3] * 255).astype(int)


def mapped(*meshes, **values):
    """The mesh set after the filter ran on its first mesh, and what it returned."""
    result = mesh_set(*meshes)
    return result, result.apply_filter(MAPS, **values)


def test_returns_what_can_be_measured():
    positions, triangles = bump()
    _, returned = mapped((positions, triangles))
    expected = {
        **measures.shape_measures(positions, triangles),
        "patches": 1,
        "assembling_vertices": 0,
        "interior_vertices": 11 * 9,
    }
    assert returned == pytest.approx(expected, rel=1e-9, abs=1e-12)
    assert {key: type(value) for key, value in returned.items()} == {
        key: int if key in ("patches", "assembling_vertices", "interior_vertices") else float
        for key in expected
    }


@pytest.mark.parametrize("tolerance", [0, 0.01, 0.05, 10])
def test_developability_counts_by_the_tolerance(tolerance):
    positions, triangles = bump()
    _, returned = mapped((positions, triangles), angle_tolerance=tolerance)
    expected = measures.shape_measures(positions, triangles, tolerance)["developability"]
    assert returned["developability"] == pytest.approx(expected, rel=1e-9)


def test_writes_every_map_of_the_shape_and_shows_the_chosen_one():
    positions, triangles = bump()
    meshes, _ = mapped((positions, triangles), map="Gaussian curvature")
    defects = angle_defects(positions, triangles)
    curvatures = measures.gaussian_curvatures(positions, triangles)
    np.testing.assert_allclose(attribute_of(meshes, "angle_defect"), defects, atol=1e-12)
    np.testing.assert_allclose(attribute_of(meshes, "gaussian_map"), defects**2, atol=1e-12)
    np.testing.assert_allclose(attribute_of(meshes, "gaussian_curvature"), curvatures, rtol=1e-9, atol=1e-9)
    assert np.array_equal(quality_of(meshes), attribute_of(meshes, "gaussian_curvature"))
    assert not has_attribute(meshes, "distance")
    assert not has_attribute(meshes, "displacement")
    assert np.array_equal(positions_of(meshes), positions)


def test_principal_curvatures_of_a_cylinder_are_zero_and_one_over_its_radius():
    positions, triangles = cylinder(25, 21)
    meshes, _ = mapped((positions, triangles), map="Maximum curvature")
    radius = np.hypot(positions[:, 0], positions[:, 1]).mean()
    np.testing.assert_allclose(attribute_of(meshes, "kappa_max"), 1 / radius, rtol=0.02)
    assert np.abs(attribute_of(meshes, "kappa_min")).max() < 0.02 / radius
    assert np.array_equal(quality_of(meshes), attribute_of(meshes, "kappa_max"))


def test_elastic_energy_shows_what_can_not_be_laid_flat():
    meshes, _ = mapped(cylinder(), map="Elastic energy")
    assert np.abs(attribute_of(meshes, "elastic_energy")).max() < 1e-20
    meshes, _ = mapped(bump(), map="Elastic energy")
    assert attribute_of(meshes, "elastic_energy").max() > 1e-6


def test_elastic_energy_waits_until_it_is_chosen():
    meshes, _ = mapped(bump())
    assert not has_attribute(meshes, "elastic_energy")


@pytest.mark.parametrize(
    ("title", "signed"), [("Gaussian map", False), ("Angle defect", True), ("Gaussian curvature", True)]
)
def test_colours_are_those_that_the_package_draws_with(title, signed):
    meshes, _ = mapped(bump(), map=title)
    values = quality_of(meshes)
    high = colour_range(values)
    assert np.count_nonzero(np.abs(values) > high) > 0
    assert np.abs(bytes_of_colours(meshes) - map_colours(values / high, signed)).max() <= 1


def test_a_map_of_zeros_is_coloured_as_zero():
    for title, signed in (("Gaussian map", False), ("Angle defect", True)):
        flat, triangles = bump()
        meshes, returned = mapped((flat * (1, 1, 0), triangles), map=title)
        assert 0 < returned["detect_function"] < 1e-24
        assert np.abs(bytes_of_colours(meshes) - map_colours([0], signed)).max() <= 1


def test_a_developable_shape_shows_no_noise():
    meshes = mesh_set(bump())
    assert meshes.apply_filter(GLOBAL)["converged"]
    for title, signed in (("Gaussian map", False), ("Angle defect", True)):
        meshes.apply_filter(MAPS, map=title, colorize=True)
        assert quality_of(meshes).any()
        colours, zero = bytes_of_colours(meshes), map_colours([0], signed).astype(int)
        assert np.abs(colours - zero).max() < np.abs(map_colours([0.5], signed) - zero).max()


def test_colours_are_the_same_at_any_size():
    positions, triangles = bump()
    for title in ("Angle defect", "Gaussian curvature", "Maximum curvature", "Elastic energy"):
        colours = [
            bytes_of_colours(mapped((size * positions, triangles), map=title)[0]) for size in (1e-3, 1, 1e3)
        ]
        assert np.abs(np.diff(colours, axis=0)).max() <= 1
        assert np.ptp(colours[0], axis=0).max() > 100


def test_the_hosts_own_quality_mapper_takes_the_written_quality():
    meshes, _ = mapped(bump(), map="Angle defect", colorize=False)
    values = quality_of(meshes)
    meshes.apply_filter("compute_color_from_scalar_per_vertex")
    colours = bytes_of_colours(meshes)
    assert not np.array_equal(colours[values.argmin()], colours[values.argmax()])
    assert len(np.unique(colours, axis=0)) > 10


def test_closed_surfaces_are_accepted():
    _, returned = mapped(octahedron())
    assert returned["total_absolute_curvature"] == pytest.approx(4 * np.pi)
    assert returned["max_angle_defect"] == pytest.approx(2 * np.pi / 3)
    assert returned["interior_vertices"] == 6
    assert returned["developability"] == 0


def test_patches_that_share_places_are_counted():
    _, returned = mapped(two_bumps())
    assert returned["patches"] == 2
    assert returned["assembling_vertices"] == 11


def test_a_place_with_several_copies_shows_the_largest():
    # Two cones whose tips coincide: one with a defect, the other with more than a full turn.
    angles = np.linspace(0, 2 * np.pi, 7)[:-1]
    wavy = np.stack([np.cos(angles), np.sin(angles), np.tile((1.0, -1.0), 3)], axis=1)
    steep = np.stack([np.cos(angles), np.sin(angles), np.full(6, -0.3)], axis=1)
    rim = np.arange(6)
    fan = np.stack([np.full(6, 6), rim, (rim + 1) % 6], axis=1)
    positions = np.vstack([wavy, [(0, 0, 0)], steep, [(0, 0, 0)]])
    triangles = np.vstack([fan, fan + 7])
    meshes, returned = mapped((positions, triangles), map="Angle defect")
    defects = angle_defects(positions, triangles)
    assert defects[6] < -0.5
    assert 0.1 < defects[13] < 0.5
    assert returned["patches"] == 2
    assert quality_of(meshes)[[6, 13]] == pytest.approx([defects[6], defects[6]])
    assert returned["total_absolute_curvature"] == pytest.approx(abs(defects[6]) + abs(defects[13]))


def test_after_an_optimisation_the_current_layer_is_its_own_reference():
    original, triangles = bump()
    meshes, returned = optimized((original, triangles), GLOBAL)
    positions = positions_of(meshes)
    meshes.apply_filter(MAPS, map="Distance")
    expected = measures.distance_to_surface(positions, original, triangles)
    np.testing.assert_allclose(quality_of(meshes), expected, atol=1e-12)
    assert quality_of(meshes).max() == pytest.approx(returned["max_distance"])
    np.testing.assert_allclose(
        attribute_of(meshes, "displacement"), np.linalg.norm(positions - original, axis=1), atol=1e-12
    )


def test_the_original_shape_is_lost_in_a_file_and_the_message_says_what_to_do(tmp_path):
    original, triangles = bump()
    meshes, _ = optimized((original, triangles), GLOBAL, map="Distance")
    expected = quality_of(meshes)
    meshes.save_current_mesh(str(tmp_path / "optimised.ply"))
    loaded = mesh_set((original, triangles))
    loaded.load_new_mesh(str(tmp_path / "optimised.ply"))
    assert not has_attribute(loaded, "original_position")  # if hosts learn to keep it, the message is wrong
    with pytest.raises(pymeshlab.PyMeshLabException, match="load the original too and choose it as 'ref"):
        loaded.apply_filter(MAPS, map="Distance")
    loaded.apply_filter(MAPS, map="Distance", reference=0)
    np.testing.assert_allclose(quality_of(loaded), expected, atol=1e-6)


def test_another_layer_as_reference():
    flat, triangles = bump()
    sheet = flat * (1, 1, 0)
    meshes, _ = mapped((flat, triangles), (sheet, triangles), map="Displacement", reference=1)
    np.testing.assert_allclose(quality_of(meshes), flat[:, 2], atol=1e-12)
    coarse = cylinder(5, 4)
    meshes, _ = mapped((flat, triangles), coarse, map="Distance", reference=1)
    np.testing.assert_allclose(quality_of(meshes), measures.distance_to_surface(flat, *coarse), atol=1e-12)
    assert not has_attribute(meshes, "displacement")


def test_layers_are_compared_where_their_matrices_put_them():
    positions, triangles = bump()
    meshes = mesh_set((positions, triangles), (positions, triangles))
    meshes.set_current_mesh(1)
    meshes.apply_filter(
        "compute_matrix_from_translation",
        axisz=2.0,
        traslmethod="XYZ translation",
        freeze=False,
        alllayers=False,
    )
    meshes.set_current_mesh(0)
    meshes.apply_filter(MAPS, map="Displacement", reference=1)
    np.testing.assert_allclose(quality_of(meshes), 2, atol=1e-6)


def test_maps_run_again_and_again():
    meshes = mesh_set(bump())
    first = meshes.apply_filter(MAPS)
    assert meshes.apply_filter(MAPS) == first


def test_deleted_and_unreferenced_vertices_are_no_obstacle():
    positions, triangles = bump()
    meshes = mesh_set((np.vstack([positions, [(5, 5, 5)]]), triangles))
    returned = meshes.apply_filter(MAPS)
    expected = measures.shape_measures(positions, triangles)
    assert {key: returned[key] for key in expected} == pytest.approx(expected)
    assert quality_of(meshes)[-1] == 0
