# SPDX-License-Identifier: GPL-3.0-or-later
"""Cut into Developable Panels: the whole way from a closed model, and what becomes of attributes."""

from __future__ import annotations

import re

import meshlab_developable
import numpy as np
import pymeshlab
import pytest
from meshlab_developable import Status

CUT = "meshing_cut_into_developable_panels"


@pytest.fixture(scope="module")
def sphere():
    meshes = pymeshlab.MeshSet()
    meshes.create_sphere(radius=1.0, subdiv=3)
    mesh = meshes.current_mesh()
    return np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix())


@pytest.fixture(scope="module")
def panels(sphere):
    return meshlab_developable.cut_into_panels(*sphere)


def test_a_closed_model_becomes_panels_that_can_be_made_developable(sphere, panels):
    vertices, _ = sphere
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    assert panels.report.status is Status.CONVERGED
    assert np.array_equal(panels.vertices[: len(vertices)], vertices)
    assert len(panels.report.panels) == panels.face_panels.max() + 1
    developed = meshlab_developable.make_developable(panels.vertices, panels.faces)
    assert developed.report.status is Status.CONVERGED
    assert developed.report.patches == len(panels.report.panels)
    assert developed.report.max_displacement == pytest.approx(panels.report.max_displacement, rel=1e-6)
    assert developed.report.max_displacement <= 0.02 * diagonal
    flat = meshlab_developable.flatten(developed.vertices, developed.faces)
    assert flat.report.overlapping_pieces == flat.report.flipped_faces == 0
    assert flat.report.max_edge_strain < 1e-3


def test_panels_in_single_precision_are_the_same_in_every_host(sphere):
    vertices, faces = sphere
    single = (vertices * [1.1, 1.3, 0.9]).astype(np.float32).astype(float)
    cut = meshlab_developable.cut_into_panels(single, faces)
    added = cut.vertices[len(single) :]
    assert len(added) > 0
    assert np.array_equal(added, added.astype(np.float32))
    developed = meshlab_developable.make_developable(cut.vertices, cut.faces)
    assert developed.report.mean_displacement == pytest.approx(cut.report.mean_displacement, rel=1e-12)


def test_each_panel_is_described(panels):
    assert [panel.index for panel in panels.report.panels] == list(range(len(panels.report.panels)))
    for panel in panels.report.panels:
        assert panel.faces == (panels.face_panels == panel.index).sum()
        assert panel.curvature_after <= 1e-4 < panel.curvature_before
        assert panel.mean_displacement <= panel.max_displacement <= panels.report.max_displacement
        assert panel.nearest_developable == 0
    assert panels.report.smallest_panel_area > 0


def test_each_panel_says_why_it_has_its_longest_seam(panels):
    for panel in panels.report.panels:
        assert panel.status is Status.CONVERGED
        assert re.match(
            r"its longest seam, beside panel \d+ at \(.*\), (has to be|was found to help): ", panel.reason
        )


def test_a_turned_and_renumbered_model_gets_the_same_panels():
    meshes = pymeshlab.MeshSet()
    meshes.create_sphere_cap(angle=60, subdiv=3)
    mesh = meshes.current_mesh()
    vertices, faces = np.array(mesh.vertex_matrix()) * [1, 1.2, 0.9], np.array(mesh.face_matrix())
    cut = meshlab_developable.cut_into_panels(vertices, faces)
    random = np.random.default_rng(1)
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    order = random.permutation(len(vertices))
    other = meshlab_developable.cut_into_panels(
        4.7 * vertices[order] @ turn.T, np.argsort(order)[random.permutation(faces)]
    )
    assert len(other.report.panels) == len(cut.report.panels)
    assert other.report.darts == cut.report.darts
    assert other.report.seam_length == pytest.approx(4.7 * cut.report.seam_length, rel=0.01)


def test_left_and_right_alike(sphere):
    vertices, faces = sphere
    pear = vertices * [1.2, 1.5, 1] + np.outer(vertices[:, 1] ** 2, [0, 0.2, 0.3])  # mirrored by one plane
    cut = meshlab_developable.cut_into_panels(pear, faces, symmetric=True)
    assert cut.report.converged
    middles = cut.vertices[cut.faces].mean(axis=1)
    sizes = np.bincount(cut.face_panels)
    for panel in range(len(sizes)):  # most of a panel's mirror image is one panel
        images = middles[cut.face_panels == panel] * [-1, 1, 1]
        nearest = np.linalg.norm(middles[None] - images[:, None], axis=2).argmin(axis=1)
        assert np.bincount(cut.face_panels[nearest]).max() > 0.7 * sizes[panel]


def test_quality_colours_and_other_attributes(meshes_of_a_box):
    meshes = meshes_of_a_box
    before = meshes.current_mesh()
    positions = np.array(before.vertex_matrix())
    before.add_vertex_custom_scalar_attribute(positions[:, 0].copy(), "x")
    before.add_face_custom_scalar_attribute(np.arange(before.face_number(), dtype=float), "number")
    report = meshes.apply_filter(CUT)
    mesh = meshes.current_mesh()
    after = np.array(mesh.vertex_matrix())
    assert report["panels"] >= 1
    assert len(after) > len(positions)
    assert np.allclose(mesh.vertex_custom_scalar_attribute_array("x"), after[:, 0])
    numbers = np.array(mesh.face_custom_scalar_attribute_array("number"))
    assert set(numbers) == set(range(12))
    panel = np.array(mesh.face_custom_scalar_attribute_array("panel"))
    assert np.array_equal(panel, mesh.face_scalar_array())
    places = {tuple(position) for position in after}
    assert len(places) < len(after)  # doubled vertices coincide to the last bit


@pytest.fixture
def meshes_of_a_box():
    meshlab_developable.load()
    meshes = pymeshlab.MeshSet()
    meshes.create_cube(size=1.0)
    return meshes


def test_labels_only(meshes_of_a_box):
    meshes = meshes_of_a_box
    before = np.array(meshes.current_mesh().face_matrix())
    meshes.apply_filter(CUT, cut=False)
    mesh = meshes.current_mesh()
    assert np.array_equal(mesh.face_matrix(), before)
    assert mesh.vertex_number() == 8
    assert mesh.face_scalar_array().min() == 0


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"allowed_stretch": -0.5}, "allowed"),
        ({"allowed_compression": 100.0}, "allowed"),
        ({"allowed_stretch": float("nan")}, "allowed"),
    ],
)
def test_what_can_not_be_says_so_and_changes_nothing(meshes_of_a_box, values, message):
    with pytest.raises(pymeshlab.PyMeshLabException, match=message):
        meshes_of_a_box.apply_filter(CUT, **values)
    assert meshes_of_a_box.current_mesh().vertex_number() == 8


def test_a_panel_that_moves_too_far_says_how_far():
    """A dome that may not be cut."""
    meshes = pymeshlab.MeshSet()
    meshes.create_sphere_cap(angle=40, subdiv=3)
    mesh = meshes.current_mesh()
    vertices, faces = np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix())
    whole = np.ones(len(faces), dtype=bool)
    cut = meshlab_developable.cut_into_panels(
        vertices, faces, keep_selected_whole=whole, max_displacement=1e-6
    )
    (panel,) = cut.report.panels
    assert panel.status is Status.NEEDS_CUT
    assert panel.nearest_developable == panel.max_displacement > 1e-6
    assert "the nearest developable one found moves a vertex by" in panel.reason
