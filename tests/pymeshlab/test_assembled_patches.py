# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects sewn together of patches: seams of every kind, on a textured scan and on small meshes."""

from pathlib import Path

import measures
import numpy as np
import pymeshlab
import pytest
from mesh_sets import GLOBAL, LOCAL, MAPS, mesh_set, optimized, positions_of
from reference_measures import angle_defects, euler_characteristic
from shapes import bump, grid

BUNNY = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / "bunny10k_textured.obj"
TEXTURE = "Texture islands"
SHAPE_KEYS = ("developability", "detect_function", "max_angle_defect", "total_absolute_curvature")


def load(path):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes


def cut(triangles, labels):
    """Triangles with a vertex for each label at a vertex, and the vertex that each of them is a copy of."""
    pairs = np.column_stack([triangles.ravel(), labels.reshape(triangles.size, -1)])
    unique, numbers = np.unique(pairs, axis=0, return_inverse=True)
    return numbers.reshape(triangles.shape), unique[:, 0].astype(int)


def components(triangles):
    """The number of components, joined across edges."""
    parents = np.arange(len(triangles))

    def find(element):
        while parents[element] != element:
            element = parents[element]
        return element

    for faces in measures.edges_of(triangles).values():
        for face in faces[1:]:
            parents[find(face)] = find(faces[0])
    return int(np.sum(parents == np.arange(len(triangles))))


@pytest.fixture(scope="module")
def bunny_panels():
    """Positions and triangles of the scan cut along its texture islands, and the vertices they copy."""
    meshes = load(BUNNY)
    mesh = meshes.current_mesh()
    triangles, vertices = cut(mesh.face_matrix(), mesh.wedge_tex_coord_matrix())
    return mesh.vertex_matrix()[vertices], triangles, vertices


def test_texture_islands_of_a_scan_are_the_patches_that_its_texture_shows(bunny_panels):
    positions, triangles, vertices = bunny_panels
    returned = load(BUNNY).apply_filter(MAPS, patches=TEXTURE)
    expected = measures.shape_measures(positions, triangles)
    assert returned["patches"] == components(triangles) > 100
    assert returned["assembling_vertices"] == np.sum(np.bincount(vertices) > 1) > 1000
    assert {key: returned[key] for key in SHAPE_KEYS} == pytest.approx(
        {key: expected[key] for key in SHAPE_KEYS}
    )
    # Without seams there is more to flatten.
    whole = load(BUNNY).apply_filter(MAPS)
    assert whole["total_absolute_curvature"] > returned["total_absolute_curvature"] + 50


@pytest.mark.parametrize(
    ("name", "values"), [(GLOBAL, {"solver": 1, "max_iterations": 5}), (LOCAL, {"max_operations": 3000})]
)
def test_seams_of_texture_and_of_coincident_vertices_are_the_same(bunny_panels, name, values):
    positions, triangles, vertices = bunny_panels
    scan = load(BUNNY)
    by_texture = scan.apply_filter(name, patches=TEXTURE, **values)
    panels, by_coincidence = optimized((positions, triangles), name, **values)
    for key in by_texture.keys() - {"seconds"}:
        assert by_coincidence[key] == pytest.approx(by_texture[key], rel=1e-6), key
    assert by_texture["detect_function_after"] < by_texture["detect_function_before"]
    moved = positions_of(panels)
    assert np.abs(moved - positions).max() > 1e-4
    # No seam has opened, to the last bit, and both objects are the same.
    first = np.unique(vertices, return_index=True)[1]
    assert np.array_equal(moved, moved[first][np.searchsorted(vertices[first], vertices)])
    assert np.allclose(moved, positions_of(scan)[vertices], rtol=0, atol=1e-9)


def write_two_materials(folder, positions, triangles, first_is_red):
    lines = ["mtllib colours.mtl", *(f"v {x!r} {y!r} {z!r}" for x, y, z in positions.tolist())]
    for material, chosen in (("red", first_is_red), ("blue", ~first_is_red)):
        lines += [f"usemtl {material}", *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles[chosen])]
    (folder / "sheet.obj").write_text("\n".join(lines) + "\n")
    (folder / "colours.mtl").write_text("newmtl red\nKd 1 0 0\n\nnewmtl blue\nKd 0 0 1\n")
    return folder / "sheet.obj"


def halves(positions, triangles):
    """Which triangles lie left of the middle, and the sheet cut there."""
    left = positions[triangles][:, :, 0].mean(axis=1) < 0.5
    cut_triangles, vertices = cut(triangles, left[:, None].repeat(3, axis=1))
    return left, (positions[vertices], cut_triangles)


def expect_halves(returned, positions, triangles):
    _, apart = halves(positions, triangles)
    expected = measures.shape_measures(*apart)
    assert returned["patches"] == 2
    assert returned["assembling_vertices"] == len(apart[0]) - len(positions) > 5
    assert {key: returned[key] for key in SHAPE_KEYS} == pytest.approx(
        {key: expected[key] for key in SHAPE_KEYS}
    )


def test_materials_of_an_obj_are_face_colours_and_make_patches(tmp_path):
    positions, triangles = bump()
    left, _ = halves(positions, triangles)
    meshes = load(write_two_materials(tmp_path, positions, triangles, left))
    assert meshes.apply_filter(MAPS)["patches"] == 1
    expect_halves(meshes.apply_filter(MAPS, patches="Face colour"), positions, triangles)


def test_face_quality_makes_patches():
    positions, triangles = bump()
    left, _ = halves(positions, triangles)
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(positions, triangles, f_scalar_array=left.astype(float)))
    expect_halves(meshes.apply_filter(MAPS, patches="Face quality"), positions, triangles)


def dented_sheet_with_a_strap():
    """A bent sheet, dented in one vertex inside it, to which the end of a strap is sewn (Fig. 4)."""
    positions, triangles = grid(9, 9, lambda u, v: (np.sin(u), v, np.cos(u)))
    dent = 40
    positions[dent] *= (1.05, 1, 1.05)
    strap = positions[dent] + np.array([(0, 0, 0), (0.3, 0, 0.3), (0, 0.3, 0.3)])
    return (np.vstack([positions, strap]), np.vstack([triangles, [(81, 82, 83)]])), dent, triangles


def test_local_holds_what_is_sewn_inside_a_patch_and_flattens_it_through_its_neighbours():
    mesh, dent, sheet = dented_sheet_with_a_strap()
    meshes, returned = optimized(mesh, LOCAL)
    assert returned["assembling_vertices"] == 1
    after = positions_of(meshes)
    assert np.array_equal(after[[dent, 81]], mesh[0][[dent, 81]])
    before_defects, after_defects = (angle_defects(points[:81], sheet) for points in (mesh[0], after))
    assert before_defects[dent] > 0.3
    assert abs(after_defects[dent]) < 0.3 * before_defects[dent]
    assert returned["detect_function_after"] < 0.1 * returned["detect_function_before"]


def test_global_moves_what_is_sewn_inside_a_patch_as_one():
    mesh, dent, _ = dented_sheet_with_a_strap()
    meshes, returned = optimized(mesh, GLOBAL)
    after = positions_of(meshes)
    assert np.array_equal(after[81], after[dent])
    assert np.linalg.norm(after[dent] - mesh[0][dent]) > 1e-3
    assert returned["detect_function_after"] < 0.1 * returned["detect_function_before"]


def test_three_patches_on_one_edge_stay_joined_along_it():
    positions, triangles = bump()
    rim = np.flatnonzero(positions[:, 0] == 0)
    leaves = []
    for angle in (0.0, 2.1, 4.2):
        turn = np.array([[np.cos(angle), 0, -np.sin(angle)], [0, 1, 0], [np.sin(angle), 0, np.cos(angle)]])
        leaf = positions @ turn.T
        leaf[rim] = positions[rim]  # the hinge, to the last bit
        leaves.append(leaf)
    count = len(positions)
    mesh = np.vstack(leaves), np.vstack([triangles + i * count for i in range(3)])
    meshes, returned = optimized(mesh, GLOBAL)
    after = positions_of(meshes).reshape(3, count, 3)
    assert (returned["patches"], returned["assembling_vertices"]) == (3, len(rim))
    assert returned["detect_function_after"] < 0.1 * returned["detect_function_before"]
    assert np.array_equal(after[0, rim], after[1, rim])
    assert np.array_equal(after[0, rim], after[2, rim])


def test_patches_of_opposite_orientation_give_the_same_result():
    positions, triangles = bump()
    beside = positions * (-1, 1, 1)  # a mirror image, which meets it at x = 0
    both = np.vstack([positions, beside])
    results = []
    for second in (triangles[:, ::-1], triangles):
        meshes = mesh_set((both, np.vstack([triangles, second + len(positions)])))
        returned = meshes.apply_filter(GLOBAL, solver="Conjugate gradient", max_iterations=5)
        returned.pop("seconds")
        results.append((returned, positions_of(meshes)))
    assert results[0][0] == pytest.approx(results[1][0], rel=1e-7)
    assert results[0][0]["assembling_vertices"] == 11
    assert np.allclose(results[0][1], results[1][1], rtol=0, atol=1e-9)
    assert np.abs(results[0][1] - both).max() > 1e-3


def test_a_sleeve_is_sewn_to_itself():
    turns = np.linspace(0, 2 * np.pi, 21)
    heights = np.linspace(0, 1, 8)
    angle, height = (grid.ravel() for grid in np.meshgrid(turns, heights))
    radius = 1 + height * (1 - height)
    positions = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), height])
    positions[20::21] = positions[0::21]
    a = (np.arange(7)[:, None] * 21 + np.arange(20)).ravel()
    triangles = np.vstack([np.column_stack([a, a + 1, a + 22]), np.column_stack([a, a + 22, a + 21])])
    assert euler_characteristic(triangles) == 1
    meshes, returned = optimized((positions, triangles), GLOBAL, max_iterations=20)
    assert (returned["patches"], returned["assembling_vertices"]) == (1, 8)
    after = positions_of(meshes)
    assert np.array_equal(after[20::21], after[0::21])
    assert np.abs(after - positions).max() > 1e-3
