# SPDX-License-Identifier: GPL-3.0-or-later
"""Flatten Patches: the patterns it adds and what it returns, against lengths measured apart."""

import itertools
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import mlx_scripts
import numpy as np
import pymeshlab
import pytest
from mesh_sets import GLOBAL, Length, attribute_of, mesh_set, positions_of, quality_of, state_of
from shapes import bump, cylinder, grid, octahedron, two_bumps

FLATTEN = "generate_flat_patches"
MODELS = Path(__file__).parents[2] / "meshes"


def flattened(*meshes, **values):
    """The mesh set after the filter ran on its first mesh, and what it returned."""
    result = mesh_set(*meshes)
    return result, result.apply_filter(FLATTEN, **values)


def half_edge_lengths(positions, triangles):
    corners = positions[triangles]
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)


def strains(mesh, meshes):
    """Strain of every half edge, face by face, of the patterns that are the current layer."""
    pattern = meshes.current_mesh()
    lengths = half_edge_lengths(*mesh)
    return abs(half_edge_lengths(pattern.vertex_matrix(), pattern.face_matrix()) - lengths) / lengths


def tube(columns=16, rows=5):
    """A tube that is open at both ends, two units long."""
    positions, triangles = grid(
        columns + 1, rows, lambda u, v: (np.cos(2 * np.pi * u), np.sin(2 * np.pi * u), 2 * v)
    )
    row, column = np.divmod(triangles, columns + 1)
    kept = np.arange(len(positions)) % (columns + 1) < columns
    return positions[kept], row * columns + column % columns


def signed_areas(positions, triangles):
    a, b, c = (positions[triangles[:, i], :2] for i in range(3))
    return ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2


def test_a_developable_panel_comes_out_isometric_in_the_plane():
    mesh = cylinder()
    meshes, returned = flattened(mesh)
    pattern = meshes.current_mesh()
    assert meshes.current_mesh_id() == 1
    assert np.array_equal(pattern.face_matrix(), mesh[1])
    assert not pattern.vertex_matrix()[:, 2].any()
    assert strains(mesh, meshes).max() < 1e-12
    assert returned.pop("seconds") > 0
    assert returned == pytest.approx(
        {
            "pieces": 1,
            "max_edge_strain": 0,
            "mean_edge_strain": 0,
            "elastic_energy": 0,
            "max_seam_mismatch": 0,
            "overlapping_pieces": 0,
            "flipped_faces": 0,
            "max_stretch": 0,
            "max_compression": 0,
        },
        abs=1e-9,
    )


def test_what_it_returns_is_what_can_be_measured():
    mesh = bump()
    meshes, returned = flattened(mesh)
    lengths = half_edge_lengths(*mesh)
    changes = strains(mesh, meshes) * lengths
    first = {}  # of the half edges of an edge
    for face, corner in np.ndindex(mesh[1].shape):
        edge = tuple(sorted((mesh[1][face, corner], mesh[1][face, (corner + 1) % 3])))
        first.setdefault(edge, (face, corner))
    edges = tuple(np.array(list(first.values())).T)
    assert returned["max_edge_strain"] == pytest.approx(strains(mesh, meshes).max(), rel=1e-9)
    assert returned["mean_edge_strain"] == pytest.approx(strains(mesh, meshes)[edges].mean(), rel=1e-9)
    assert returned["elastic_energy"] == pytest.approx((changes[edges] ** 2).sum(), rel=1e-9)
    assert 0.001 < returned["mean_edge_strain"] < 0.05
    pattern = meshes.current_mesh()
    assert (signed_areas(pattern.vertex_matrix(), pattern.face_matrix()) > 0).all()


def test_global_developability_takes_the_strain_away():
    meshes = mesh_set(bump())
    assert meshes.apply_filter(GLOBAL)["converged"]
    assert meshes.apply_filter(FLATTEN)["max_edge_strain"] < 1e-4


def test_the_papers_first_figure():
    """The undented shell has no elastic energy, the dented has much; once developable it has none again."""
    energies = {}
    for name in ("sheet_bent", "dented_shell"):
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(str(MODELS / f"{name}.ply"))
        energies[name] = meshes.apply_filter(FLATTEN, map="Elastic energy")["elastic_energy"]
    meshes.set_current_mesh(0)
    on_model, positions = quality_of(meshes), positions_of(meshes)
    assert on_model.sum() == pytest.approx(energies["dented_shell"])
    undented = pymeshlab.MeshSet()
    undented.load_new_mesh(str(MODELS / "sheet_bent.ply"))
    dent = np.linalg.norm(positions - positions_of(undented), axis=1)
    inside = dent > 0.1 * dent.max()
    assert on_model[inside].mean() > 3 * on_model[~inside].mean()
    assert meshes.apply_filter(GLOBAL)["converged"]
    energies["developable"] = meshes.apply_filter(FLATTEN)["elastic_energy"]
    assert energies["sheet_bent"] < 1e-12 * energies["dented_shell"]
    assert energies["developable"] < 1e-8 * energies["dented_shell"]
    assert energies["dented_shell"] > 0.1


@pytest.mark.parametrize("chosen", ["Edge strain", "Elastic energy"])
def test_maps_are_on_the_model_and_on_the_patterns(chosen):
    meshes, returned = flattened(two_bumps(), map=chosen)
    for _layer in (1, 0):
        shown = {"Edge strain": "edge_strain", "Elastic energy": "elastic_energy"}[chosen]
        assert np.array_equal(quality_of(meshes), attribute_of(meshes, shown))
        assert attribute_of(meshes, "edge_strain").max() == pytest.approx(returned["max_edge_strain"])
        assert len(np.unique(meshes.current_mesh().vertex_color_matrix(), axis=0)) > 10
        if meshes.current_mesh_id() == 1:
            total = attribute_of(meshes, "elastic_energy").sum()
            assert total == pytest.approx(returned["elastic_energy"])
        meshes.set_current_mesh(0)


def test_colours_stay_when_asked():
    meshes, _ = flattened(bump(), colorize=False)
    for layer in (0, 1):
        meshes.set_current_mesh(layer)
        assert len(np.unique(meshes.current_mesh().vertex_color_matrix(), axis=0)) == 1


def test_a_tube_is_cut_once():
    mesh = tube()
    meshes, returned = flattened(mesh)
    assert returned["max_edge_strain"] < 1e-12
    assert returned["max_seam_mismatch"] < 1e-12
    assert meshes.current_mesh().vertex_number() == len(mesh[0]) + 5
    size = np.ptp(positions_of(meshes), axis=0)
    assert size[1] == pytest.approx(2)  # the cut stands upright
    assert size[0] == pytest.approx(16 * 2 * np.sin(np.pi / 16))


def test_two_panels_lie_apart_by_the_gap_with_their_seam_upright():
    meshes, returned = flattened(two_bumps(), gap=Length(0.25))
    assert returned["pieces"] == 2
    positions = positions_of(meshes)
    half = len(positions) // 2
    left, right = sorted((positions[:half], positions[half:]), key=lambda piece: piece[:, 0].min())
    assert right[:, 0].min() - left[:, 0].max() == pytest.approx(0.25)
    assert returned["max_seam_mismatch"] < 1e-9  # they mirror each other


def test_vertices_say_their_piece_and_what_they_are_sewn_to():
    gap = 0.01
    mesh = two_bumps(gap)
    meshes, _ = flattened(mesh, weld_distance=Length(2 * gap))
    places, pieces = attribute_of(meshes, "place"), attribute_of(meshes, "piece")
    half = len(mesh[1]) // 2
    for piece, faces in enumerate((slice(0, half), slice(half, None))):
        assert (pieces[meshes.current_mesh().face_matrix()[faces]] == piece).all()
    of_corner = places[meshes.current_mesh().face_matrix()]
    on_model = meshes.current_mesh().vertex_custom_point_attribute_matrix("model_position")
    where = {}
    for place, vertex in zip(of_corner.flat, mesh[1].flat, strict=True):
        where.setdefault(place, set()).add(vertex)
    assert sorted(where) == list(range(len(mesh[0]) - 11))  # the seam has eleven vertices on either side
    for vertex, place in enumerate(places):
        linked = mesh[0][list(where[place])]
        assert np.linalg.norm(linked - linked[0], axis=1).max() <= 2 * gap
        np.testing.assert_allclose(on_model[vertex], linked.mean(axis=0), atol=1e-12)


def test_faces_say_what_their_sides_are_sewn_to():
    meshes, _ = flattened(two_bumps())
    pattern = meshes.current_mesh()
    seam, edge, sewn_to = (
        pattern.face_custom_point_attribute_matrix(name).astype(int).ravel()
        for name in ("seam", "seam_edge", "sewn_to")
    )
    (sides,) = seam.nonzero()
    assert set(seam[sides]) == {1}
    assert sorted(edge[sides]) == list(range(10))
    sides = sides[np.argsort(edge[sides])]
    corners = pattern.face_matrix()
    ends = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2)
    places, pieces = attribute_of(meshes, "place"), attribute_of(meshes, "piece")
    assert (np.sort(places[ends[sides]], axis=1) == np.sort(places[ends[sewn_to[sides]]], axis=1)).all()
    assert set(pieces[ends[sides]].flat) == {0}
    assert set(pieces[ends[sewn_to[sides]]].flat) == {1}
    assert all(np.intersect1d(one, next_).size == 1 for one, next_ in itertools.pairwise(ends[sides]))


def test_only_selected_patches_are_laid_flat():
    positions, triangles = two_bumps(gap=1.0)
    meshes = mesh_set((positions, triangles))
    last = len(triangles) - 1
    meshes.apply_filter("compute_selection_by_condition_per_face", condselect=f"fi == {last}")
    assert meshes.apply_filter(FLATTEN, only_selected=True)["pieces"] == 1
    assert meshes.current_mesh().face_number() == len(triangles) // 2
    selected = (positions, triangles[len(triangles) // 2 :])
    assert strains(selected, meshes).max() < 0.1


def test_texture_coordinates_are_the_patterns_scaled():
    mesh = two_bumps()
    meshes, returned = flattened(mesh, write_texture_coordinates=True)
    pattern = positions_of(meshes)[meshes.current_mesh().face_matrix()].reshape(-1, 3)[:, :2]
    meshes.set_current_mesh(0)
    texture = meshes.current_mesh().wedge_tex_coord_matrix()
    assert texture.min() >= 0
    assert texture.max() == pytest.approx(1)
    np.testing.assert_allclose(
        texture * np.ptp(pattern, axis=0).max(), pattern - pattern.min(axis=0), atol=1e-6
    )
    again = meshes.apply_filter(FLATTEN, patches="Texture islands")
    assert again["pieces"] == returned["pieces"] == 2


@pytest.mark.parametrize(
    ("file", "name"), [("panel.ply", "panel pattern"), ("sleeve v1.2.obj", "sleeve v1_2 pattern")]
)
def test_the_layer_is_named_after_the_mesh_and_nothing_follows_a_dot_which_windows_leave_out(
    file, name, tmp_path
):
    mesh_set(bump()).save_current_mesh(str(tmp_path / file))
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(tmp_path / file))
    meshes.apply_filter(FLATTEN)
    assert meshes.current_mesh().label() == name


def with_handle():
    """A torus that lacks a face."""

    def torus(u, v):
        radius = 2 + np.cos(2 * np.pi * v)
        return radius * np.cos(2 * np.pi * u), radius * np.sin(2 * np.pi * u), np.sin(2 * np.pi * v)

    positions, triangles = grid(9, 7, torus)
    row, column = np.divmod(triangles, 9)
    return positions, ((row % 6) * 9 + column % 8)[1:]


@pytest.mark.parametrize(
    ("mesh", "message"),
    [
        (octahedron(), "1 of 1 patch is closed and can't be laid flat"),
        (with_handle(), "1 patch has a handle"),
        ((np.zeros((3, 3)), np.array([[0, 1, 2]])), "1 face has no area"),
        ((np.eye(3), np.zeros((0, 3), int)), "The mesh has no faces"),
    ],
)
def test_refuses_with_a_sentence_and_changes_nothing(mesh, message):
    meshes = mesh_set(mesh)
    before = state_of(meshes)
    with pytest.raises(pymeshlab.PyMeshLabException, match=message):
        meshes.apply_filter(FLATTEN)
    assert state_of(meshes) == before


def test_parameters_are_those_of_the_interface(tmp_path):
    meshes = mesh_set(bump())
    meshes.apply_filter(FLATTEN)
    meshes.save_filter_script(str(tmp_path / "used.mlx"))
    used = ElementTree.parse(tmp_path / "used.mlx").getroot().find("filter")
    ours = mlx_scripts.filter_element("flatten_patches")
    assert used.get("name") == ours.get("name") == "Flatten Patches"
    for parameters in (used, ours):
        assert [(p.get("name"), p.get("type"), p.get("value")) for p in parameters] == [
            ("patches", "RichEnum", "0"),
            ("weld_distance", "RichAbsPerc", "0"),
            ("only_selected", "RichBool", "false"),
            ("material", "RichEnum", "0"),
            ("allowed_stretch", "RichFloat", "-1"),
            ("allowed_compression", "RichFloat", "-1"),
            ("grain", "RichEnum", "0"),
            ("gap", "RichAbsPerc", "-1"),
            ("map", "RichEnum", "0"),
            ("write_texture_coordinates", "RichBool", "false"),
            ("colorize", "RichBool", "true"),
        ]
