# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangulate Polygons on quads and larger polygons, as pymeshlab loads them from OBJ and PLY."""

import numpy as np
import polygons
import pymeshlab
import pytest
from mesh_sets import mesh_set
from polygons import TRIANGULATE

KINDS = {
    "kite": polygons.kite(),
    "letter": polygons.letter(),
    "comb": polygons.comb(),
    "with_midpoints": polygons.with_midpoints(),
    "star": polygons.star(),
    "sheet_of_quads": polygons.sheet_of_quads(),
}
WRITERS = {"obj": polygons.write_obj, "ply": polygons.write_ply}


def load(path):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes


def loops_of(meshes):
    return sorted(polygons.from_smallest(loop) for loop in meshes.current_mesh().polygonal_face_list())


def faces_of(meshes):
    return meshes.current_mesh().face_matrix()


@pytest.fixture(params=WRITERS)
def load_kind(request, tmp_path):
    """Loads a mesh of polygons from a file of either kind."""
    return lambda mesh: load(WRITERS[request.param](tmp_path / f"polygons.{request.param}", mesh))


@pytest.mark.parametrize("kind", KINDS)
def test_polygons_become_constrained_delaunay_and_stay_polygons(load_kind, kind):
    _, loops = KINDS[kind]
    meshes = load_kind(KINDS[kind])
    points, before = meshes.current_mesh().vertex_matrix(), faces_of(meshes)
    assert loops_of(meshes) == sorted(map(polygons.from_smallest, loops))
    returned = meshes.apply_filter(TRIANGULATE)
    assert returned["polygons"] == len(loops)
    assert returned["edges_changed"] > 0
    assert returned["skipped"] == 0
    assert {type(value) for value in returned.values()} == {int}
    after = faces_of(meshes)
    assert np.array_equal(meshes.current_mesh().vertex_matrix(), points)
    assert after.shape == before.shape
    assert loops_of(meshes) == sorted(map(polygons.from_smallest, loops))
    for loop in loops:
        polygons.expect_constrained_delaunay(points, loop, polygons.triangles_in(after, loop))


def test_edges_changed_counts_the_new_diagonals(load_kind):
    meshes = load_kind(polygons.sheet_of_quads())

    def edges():
        return {
            frozenset(edge)
            for face in faces_of(meshes).tolist()
            for edge in zip(face, np.roll(face, 1), strict=True)
        }

    before = edges()
    returned = meshes.apply_filter(TRIANGULATE)
    assert returned["edges_changed"] == len(edges() - before) > 3


def test_a_second_run_changes_nothing(load_kind):
    meshes = load_kind(polygons.star())
    meshes.apply_filter(TRIANGULATE)
    before = faces_of(meshes)
    assert meshes.apply_filter(TRIANGULATE) == {"polygons": 1, "edges_changed": 0, "skipped": 0}
    assert np.array_equal(faces_of(meshes), before)


def test_a_polygon_that_crosses_itself_is_left_alone_and_counted(load_kind):
    meshes = load_kind(polygons.kite_and_bow_tie())
    before = faces_of(meshes)
    assert meshes.apply_filter(TRIANGULATE) == {"polygons": 2, "edges_changed": 1, "skipped": 1}
    after = faces_of(meshes)
    assert np.array_equal(after[2:], before[2:])
    assert not np.array_equal(after[:2], before[:2])


def test_corners_keep_their_texture_coordinates(tmp_path):
    points, loops = polygons.sheet_of_quads()
    meshes = load(polygons.write_obj(tmp_path / "sheet.obj", (points, loops), texture=True))
    assert meshes.apply_filter(TRIANGULATE)["edges_changed"] > 3
    triangles = faces_of(meshes)
    texture = meshes.current_mesh().wedge_tex_coord_matrix().reshape(-1, 3, 2)
    for triangle, coordinates in zip(triangles, texture, strict=True):
        polygon = next(i for i, loop in enumerate(loops) if set(triangle) <= set(loop))
        expected = [polygons.texture_of(polygon, vertex) for vertex in triangle]
        assert np.allclose(coordinates, expected, rtol=0, atol=1e-6)


def test_vertices_and_faces_keep_what_they_carry(tmp_path):
    points, loops = polygons.sheet_of_quads()
    meshes = load(polygons.write_ply(tmp_path / "sheet.ply", (points, loops)))
    mesh = meshes.current_mesh()
    mesh.add_vertex_custom_scalar_attribute(np.arange(len(points)) / 3, "thirds")
    mesh.add_face_custom_scalar_attribute(np.arange(mesh.face_number()) // 2 / 7, "polygon")
    assert meshes.apply_filter(TRIANGULATE)["edges_changed"] > 3
    polygon = [next(i for i, loop in enumerate(loops) if set(face) <= set(loop)) for face in faces_of(meshes)]
    assert np.array_equal(mesh.vertex_scalar_array(), np.arange(len(points)))
    assert np.array_equal(mesh.vertex_custom_scalar_attribute_array("thirds"), np.arange(len(points)) / 3)
    assert np.array_equal(mesh.face_custom_scalar_attribute_array("polygon"), np.array(polygon) / 7)
    assert np.array_equal(np.round(mesh.face_color_matrix()[:, 0] * 255), polygon)


def test_normals_and_topology_fit_the_new_faces(tmp_path):
    meshes = load(polygons.write_ply(tmp_path / "sheet.ply", polygons.sheet_of_quads()))
    meshes.apply_filter("compute_selection_by_non_manifold_edges_per_face")  # has the adjacency computed
    meshes.apply_filter(TRIANGULATE)
    mesh = meshes.current_mesh()
    corners = mesh.vertex_matrix()[mesh.face_matrix()]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    assert np.allclose(mesh.face_normal_matrix(), normals, rtol=0, atol=1e-6)
    assert (normals[:, 2] > 0.5).all()
    meshes.apply_filter("compute_selection_by_non_manifold_edges_per_face")
    assert mesh.selected_face_number() == 0
    assert meshes.get_topological_measures()["boundary_edges"] == 2 * (6 + 4)


def test_the_result_is_saved_as_polygons(tmp_path):
    meshes = load(polygons.write_obj(tmp_path / "sheet.obj", polygons.sheet_of_quads()))
    meshes.apply_filter(TRIANGULATE)
    loops = loops_of(meshes)
    meshes.save_current_mesh(str(tmp_path / "saved.obj"), save_polygonal=True)
    assert loops_of(load(tmp_path / "saved.obj")) == loops


def test_a_mesh_of_triangles_has_nothing_to_do():
    meshes = mesh_set((np.eye(3), np.array([(0, 1, 2)])))
    assert meshes.apply_filter(TRIANGULATE) == {"polygons": 0, "edges_changed": 0, "skipped": 0}


@pytest.mark.parametrize(
    ("points", "triangles", "sentence"),
    [
        (np.eye(3), np.empty((0, 3)), "no faces"),
        (np.array([(0, 0, 0), (1, 0, 0), (0, np.nan, 0)]), np.array([(0, 1, 2)]), "1 vertex has"),
    ],
)
def test_bad_input_is_refused_in_a_sentence(points, triangles, sentence):
    meshes = mesh_set((points, triangles))
    with pytest.raises(pymeshlab.PyMeshLabException, match=sentence):
        meshes.apply_filter(TRIANGULATE)
    assert np.array_equal(meshes.current_mesh().vertex_matrix(), points, equal_nan=True)


def test_without_a_mesh_it_says_so():
    with pytest.raises(pymeshlab.PyMeshLabException):
        pymeshlab.MeshSet().apply_filter(TRIANGULATE)
