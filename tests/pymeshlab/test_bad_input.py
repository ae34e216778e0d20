# SPDX-License-Identifier: GPL-3.0-or-later
"""What can't be worked on is refused in a sentence that says what is wrong, how much of it and what to do;
the mesh stays as it was and the program alive."""

import numpy as np
import pymeshlab
import pytest
from mesh_sets import GLOBAL, LOCAL, MAPS, Length, mesh_set, optimized, state_of
from shapes import bump, octahedron

ALL = pytest.mark.parametrize("name", [GLOBAL, LOCAL, MAPS])
BOTH = pytest.mark.parametrize("name", [GLOBAL, LOCAL])


def refusal(meshes, name, **values):
    """The sentence of a refused call, after making sure that it changed nothing."""
    before = state_of(meshes)
    with pytest.raises(pymeshlab.PyMeshLabException) as caught:
        meshes.apply_filter(name, **values)
    assert state_of(meshes) == before
    text = str(caught.value)
    assert text.startswith(f"Failed to apply filter: {name}\nDetails: ")
    sentence = text.split("Details: ")[1]
    assert sentence.endswith(".")
    return sentence


@ALL
def test_no_mesh(name):
    # pymeshlab 2025.7 says so itself.
    sentence = "There is no mesh: open one first|requires at least one mesh"
    with pytest.raises(pymeshlab.PyMeshLabException, match=sentence):
        pymeshlab.MeshSet().apply_filter(name)


@ALL
def test_no_faces(name):
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(bump()[0]))
    assert "no faces: open a mesh with faces" in refusal(meshes, name)


@ALL
@pytest.mark.parametrize(("value", "count"), [(np.nan, 1), (np.inf, 2)])
def test_coordinates_that_are_no_numbers(name, value, count):
    positions, triangles = bump()
    positions[20 : 20 + count, 1] = value
    sentence = refusal(mesh_set((positions, triangles)), name)
    assert sentence.startswith(f"{count} vert")
    assert "infinite or not a number: remove" in sentence


@ALL
def test_faces_without_area(name):
    positions, triangles = bump()
    positions[triangles[7][0]] = (positions[triangles[7][1]] + positions[triangles[7][2]]) / 2
    sentence = refusal(mesh_set((positions, triangles)), name)
    assert "1 face has no area" in sentence or "2 faces have no area" in sentence
    assert "remove" in sentence


@BOTH
def test_closed_patches(name):
    closed, triangles = octahedron()
    sheet, more = bump()
    both = (np.vstack([closed + 5, sheet]), np.vstack([triangles, more + len(closed)]))
    sentence = refusal(mesh_set(both), name)
    assert "1 of 2 patches" in sentence
    assert "closed" in sentence
    assert "cut it open ('developable cut' on the command line, the filter Cut into Developable" in sentence


@ALL
@pytest.mark.parametrize("value", [-1e-3, float("nan"), float("inf")])
def test_a_number_out_of_range(name, value):
    sentence = refusal(mesh_set(bump()), name, angle_tolerance=value)
    assert "'angle_tolerance' is " in sentence
    assert "choose" in sentence


@pytest.mark.parametrize(
    ("name", "parameter", "value"),
    [
        (GLOBAL, "weld_distance", Length(-1)),
        (LOCAL, "weld_distance", Length(-1)),
        (MAPS, "weld_distance", Length(-1)),
        (GLOBAL, "max_iterations", -1),
        (GLOBAL, "relative_change", -1),
        (LOCAL, "max_operations", -1),
        (LOCAL, "smoothing", -1),
    ],
)
def test_negative_values(name, parameter, value):
    sentence = refusal(mesh_set(bump()), name, **{parameter: value})
    assert sentence == f"The parameter '{parameter}' is -1: choose 0 or more."


POSITIVE = [
    ("curvature_tolerance", 0, "is 0: choose more than 0."),
    ("curvature_tolerance", -1, "is -1: choose more than 0."),
    ("smoothness", 0, "is 0: choose more than 0, and at most 1."),
    ("smoothness", -1, "is -1: choose more than 0, and at most 1."),
    ("smoothness", 1.5, "is 1.5: choose more than 0, and at most 1."),
    ("angle_tolerance", 0, "is 0: choose more than 0 with the solver Constrained Newton."),
]


@pytest.mark.parametrize(("parameter", "value", "words"), POSITIVE)
def test_what_the_solver_would_refuse_is_refused_by_its_name(parameter, value, words):
    assert refusal(mesh_set(bump()), GLOBAL, **{parameter: value}) == f"The parameter '{parameter}' {words}"


def test_conjugate_gradients_take_an_angle_tolerance_of_zero():
    few = {"solver": "Conjugate gradient", "max_iterations": 1}
    assert optimized(bump(), angle_tolerance=0, **few)[1]["iterations"] == 1


def test_a_largest_displacement_that_is_no_number():
    assert "'max_displacement' is nan" in refusal(
        mesh_set(bump()), LOCAL, max_displacement=Length(float("nan"))
    )


@ALL
@pytest.mark.parametrize("value", ["no such map", -1, 99])
def test_an_unknown_map(name, value):
    meshes = mesh_set(bump())
    before = state_of(meshes)
    with pytest.raises(pymeshlab.InvalidEnumException):  # the host's own check
        meshes.apply_filter(name, map=value)
    assert state_of(meshes) == before


def test_the_map_of_flattening_a_closed_surface():
    assert "closed" in refusal(mesh_set(octahedron()), MAPS, map="Elastic energy")


@BOTH
def test_nothing_selected(name):
    assert "No face is selected" in refusal(mesh_set(bump()), name, only_selected=True)


@BOTH
def test_everything_held(name):
    meshes = mesh_set(bump())
    meshes.apply_filter("set_selection_all")
    sentence = refusal(meshes, name, fix_selected=True)
    assert "held still" in sentence or "hold" in sentence.lower()


@pytest.mark.parametrize(
    ("patches", "lacks"),
    [
        ("Face colour", "face colours"),
        ("Texture islands", "texture coordinates"),
        ("Face quality", "face quality"),
    ],
)
@ALL
def test_patches_by_something_that_the_mesh_lacks(name, patches, lacks, tmp_path):
    # A file brings a mesh without attributes; pymeshlab gives them to meshes made of arrays.
    mesh_set(bump()).save_current_mesh(
        str(tmp_path / "plain.ply"), save_face_color=False, save_face_quality=False, save_wedge_texcoord=False
    )
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(tmp_path / "plain.ply"))
    assert lacks in refusal(meshes, name, patches=patches)


@ALL
def test_patches_by_a_face_quality_that_is_no_number(name):
    quality = np.zeros(len(bump()[1]))
    quality[[3, 8]] = np.nan
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*bump(), f_scalar_array=quality))
    sentence = refusal(meshes, name, patches="Face quality")
    assert sentence.startswith("2 faces have a quality that is not a number: compute it anew")
    assert sentence.endswith(f" See face {np.flatnonzero(np.isnan(quality))[0]}.")


@ALL
def test_patches_by_texture_coordinates_that_are_no_numbers(name, tmp_path):
    positions, triangles = bump()
    corners = np.zeros((len(triangles), 6))
    corners[[4, 13, 13], [3, 0, 5]] = np.nan
    faces = np.flatnonzero(np.isnan(corners).any(axis=1))
    (tmp_path / "textured.ply").write_text(
        f"ply\nformat ascii 1.0\nelement vertex {len(positions)}\n"
        + "".join(f"property float {axis}\n" for axis in "xyz")
        + f"element face {len(triangles)}\nproperty list uchar int vertex_indices\n"
        + "property list uchar float texcoord\nend_header\n"
        + "".join(f"{' '.join(map(str, row))}\n" for row in positions)
        + "".join(
            f"3 {' '.join(map(str, row))} 6 {' '.join(map(str, texture))}\n"
            for row, texture in zip(triangles, corners, strict=True)
        )
    )
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(tmp_path / "textured.ply"))
    sentence = refusal(meshes, name, patches="Texture islands")
    assert sentence.startswith(f"{len(faces)} faces have texture coordinates that are not numbers: param")
    assert sentence.endswith(f" See face {faces[0]}.")


@pytest.mark.parametrize("title", ["Distance", "Displacement"])
def test_maps_of_change_before_any_change(title):
    sentence = refusal(mesh_set(bump()), MAPS, map=title)
    assert "'original_position'" in sentence
    assert "run Global or Local Developability first" in sentence


def test_a_reference_of_another_size_has_no_displacement():
    sentence = refusal(mesh_set(bump(), bump(5, 5)), MAPS, map="Displacement", reference=1)
    assert "as many vertices" in sentence


def test_a_reference_without_faces():
    meshes = mesh_set(bump())
    meshes.add_mesh(pymeshlab.Mesh(bump()[0]), set_as_current=False)
    assert "no faces" in refusal(meshes, MAPS, reference=1)


def test_a_reference_that_is_not_there():
    meshes = mesh_set(bump())
    with pytest.raises(pymeshlab.PyMeshLabException):
        meshes.apply_filter(MAPS, reference=12)


def test_a_weld_distance_that_swallows_faces():
    # Neighbours are 1/12 to 1/10 apart.
    assert "weld" in refusal(mesh_set(bump()), GLOBAL, weld_distance=Length(0.09))


def test_the_program_goes_on_after_a_refusal():
    meshes = mesh_set(octahedron(), bump())
    refusal(meshes, GLOBAL)
    meshes.set_current_mesh(1)
    assert (
        meshes.apply_filter(GLOBAL)["detect_function_after"] == optimized(bump())[1]["detect_function_after"]
    )
