# SPDX-License-Identifier: GPL-3.0-or-later
"""Each panel gets a verdict of its own, measured here again from what comes out."""

from __future__ import annotations

import json

import meshlab_developable
import numpy as np
import pymeshlab
import pytest
from click.testing import CliRunner
from meshlab_developable import Status, mesh_sets, panel_reports
from meshlab_developable.command_line import main
from reference_measures import angle_defects
from shapes import bump, cylinder


def three_panels():
    """A sphere with a small hole, a hill and a cylinder, beside each other: one needs a cut."""
    sphere = pymeshlab.MeshSet()
    sphere.create_sphere(subdiv=3)
    jar = sphere.current_mesh().vertex_matrix(), sphere.current_mesh().face_matrix()[:-4]
    parts = [jar, bump(), cylinder()]
    vertices, faces, count = [], [], 0
    for i, (positions, triangles) in enumerate(parts):
        vertices.append(positions + np.array([5 * i, 0, 0]))
        faces.append(triangles + count)
        count += len(positions)
    return np.vstack(vertices), np.vstack(faces), [len(triangles) for _, triangles in parts]


@pytest.mark.parametrize(
    ("method", "parameters", "statuses"),
    [
        ("global", {}, [Status.NEEDS_CUT, Status.CONVERGED, Status.NOTHING_TO_DO]),
        (
            "global",
            {"solver": "Conjugate gradient", "max_iterations": 3},
            [Status.LIMIT_REACHED, Status.LIMIT_REACHED, None],
        ),
        ("local", {"max_operations": 500}, [Status.LIMIT_REACHED, None, None]),
    ],
)
def test_panels_are_what_one_measures(method, parameters, statuses):
    vertices, faces, counts = three_panels()
    result = meshlab_developable.make_developable(vertices, faces, method=method, **parameters)
    assert [panel.index for panel in result.report.panels] == [0, 1, 2]
    assert [panel.faces for panel in result.report.panels] == counts
    start = 0
    for panel, status, count in zip(result.report.panels, statuses, counts, strict=True):
        triangles = faces[start : start + count]
        used = np.unique(triangles)
        before = np.abs(angle_defects(vertices, triangles)[used])
        after = np.abs(angle_defects(result.vertices, triangles)[used])
        moved = np.linalg.norm(result.vertices - vertices, axis=1)[used]
        assert status is None or panel.status is status
        assert panel.curvature_before == pytest.approx(before.sum(), abs=1e-9)
        assert panel.curvature_after == pytest.approx(after.sum(), abs=1e-9)
        assert panel.max_angle_defect == pytest.approx(after.max(), abs=1e-9)
        assert panel.max_displacement == pytest.approx(moved.max(), abs=1e-12)
        assert panel.mean_displacement == pytest.approx(moved.mean(), abs=1e-12)
        assert panel.reason
        at = np.linalg.norm(result.vertices[used] - panel.worst_point, axis=1).argmin()
        assert after[at] == pytest.approx(after.max(), abs=1e-9)
        start += count


def test_strangers_cost_each_other_nothing():
    vertices, faces, _ = three_panels()
    together = meshlab_developable.make_developable(vertices, faces)
    hill, triangles = bump()
    alone = meshlab_developable.make_developable(hill + np.array([5, 0, 0]), triangles)
    first = vertices.shape[0] - len(cylinder()[0]) - len(hill)
    assert np.array_equal(together.vertices[first : first + len(hill)], alone.vertices)


def test_the_filter_leaves_it_on_the_faces():
    vertices, faces, counts = three_panels()
    meshes = mesh_sets.open_mesh(vertices, faces)
    meshlab_developable.load()
    returned = meshes.apply_filter("apply_coord_global_developability")
    assert (returned["panels_converged"], returned["panels_need_cut"]) == (2, 1)
    mesh = meshes.current_mesh()
    assert np.array_equal(mesh.face_custom_scalar_attribute_array("panel"), np.repeat([0, 1, 2], counts))
    assert np.array_equal(
        mesh.face_custom_scalar_attribute_array("panel_status"), np.repeat([3, 0, 5], counts)
    )
    left = mesh.face_custom_scalar_attribute_array("panel_curvature")
    assert left.max() == pytest.approx(returned["total_absolute_curvature_after"], rel=1e-3)
    assert panel_reports(meshes.current_mesh())[1].status is Status.CONVERGED
    untouched = mesh_sets.open_mesh(vertices, faces)
    assert panel_reports(untouched.current_mesh()) == []


def test_faces_that_are_not_worked_on_have_no_panel():
    vertices, faces, counts = three_panels()
    chosen = np.repeat([False, True, False], counts)
    result = meshlab_developable.make_developable(vertices, faces, only_selected=chosen)
    [panel] = result.report.panels
    assert (panel.index, panel.faces, panel.status) == (0, counts[1], Status.CONVERGED)


def test_the_command_line_has_them_in_json(tmp_path):
    vertices, faces, _ = three_panels()
    mesh_sets.save(mesh_sets.open_mesh(vertices, faces), tmp_path / "mesh.ply")
    arguments = ["global", str(tmp_path / "mesh.ply"), "-o", str(tmp_path / "out.ply"), "--json"]
    said = json.loads(CliRunner().invoke(main, arguments).stdout)
    assert [panel["status"] for panel in said["panels"]] == ["needs_cut", "converged", "nothing_to_do"]
    assert len(said["panels"][0]["worst_point"]) == 3


@pytest.mark.parametrize("share", [0.0, 0.001, 0.01, 0.02])
def test_no_vertex_goes_farther_than_it_may(share):
    vertices, faces = bump(31, 31)
    bound = share * float(np.linalg.norm(np.ptp(vertices, axis=0)))
    result = meshlab_developable.make_developable(vertices, faces, max_displacement=bound)
    assert np.linalg.norm(result.vertices - vertices, axis=1).max() <= bound
    report = result.report
    if not report.developable:
        assert report.status is Status.NEEDS_CUT
        assert report.nearest_developable > bound
        assert f"moves a vertex by {report.nearest_developable:.4g}" in report.reason
