# SPDX-License-Identifier: GPL-3.0-or-later
"""The models in meshes/: made by their script, and what their names promise."""

from __future__ import annotations

import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest
import reference_measures as reference

MESHES = Path(__file__).parents[2] / "meshes"
CURVED = ["dented_shell", "shoe_upper", "short_pants"]
CLOSED = ["toy", "seat"]
ALL = ["sheet_bent", *CURVED, "hull_panel", *CLOSED]


@pytest.fixture(params=ALL)
def model(request):
    return reference.read_obj(MESHES / f"{request.param}.obj")


def test_the_script_makes_the_committed_bytes(tmp_path):
    subprocess.run([sys.executable, str(MESHES / "make_models.py"), str(tmp_path)], check=True)
    made = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    committed = [*MESHES.glob("*.obj"), *MESHES.glob("*.ply")]
    assert made == {path.name: path.read_bytes() for path in committed}
    assert set(made) == {f"{name}.{ending}" for name in ALL for ending in ("obj", "ply")}


@pytest.mark.parametrize("name", ALL)
def test_ply_is_the_same_mesh(name):
    positions, triangles, _ = reference.read_obj(MESHES / f"{name}.obj")
    lines = (MESHES / f"{name}.ply").read_text().splitlines()
    rows = [line.split() for line in lines[lines.index("end_header") + 1 :]]
    assert np.array_equal(np.array(rows[: len(positions)], dtype=float), positions)
    assert np.array_equal(np.array(rows[len(positions) :], dtype=int)[:, 1:], triangles)


def test_size_is_the_papers(model):
    positions, _, _ = model
    assert 500 <= len(positions) <= 3000


def test_every_vertex_is_used(model):
    positions, triangles, _ = model
    assert np.array_equal(np.unique(triangles), np.arange(len(positions)))


@pytest.mark.parametrize("name", CLOSED)
def test_closed_models_are_spheres_of_decent_triangles(name):
    """Closed, consistently oriented, facing out, without handles."""
    positions, triangles, _ = reference.read_obj(MESHES / f"{name}.obj")
    directed = {(int(t[i]), int(t[(i + 1) % 3])) for t in triangles for i in range(3)}
    assert len(directed) == 3 * len(triangles)
    assert {(b, a) for a, b in directed} == directed
    assert reference.euler_characteristic(triangles) == 2
    a, b, c = (positions[triangles[:, i]] for i in range(3))
    assert (np.cross(a, b) * c).sum() > 0
    assert np.degrees(reference.corner_angles(positions, triangles)).min() > 15


@pytest.mark.parametrize("name", sorted(set(ALL) - set(CLOSED)))
def test_triangles_are_irregular_but_decent(name):
    positions, triangles, _ = reference.read_obj(MESHES / f"{name}.obj")
    assert np.degrees(reference.corner_angles(positions, triangles)).min() > 20
    inside = np.setdiff1d(triangles, [v for edge in reference.rim_edges(triangles) for v in edge])
    valences = np.bincount(triangles.ravel())[inside]
    assert len(np.unique(valences)) >= 4
    assert (valences != 6).mean() > 0.2


@pytest.mark.parametrize("name", sorted(set(ALL) - set(CLOSED)))
def test_panels_are_consistently_oriented_disks(name):
    _, triangles, names = reference.read_obj(MESHES / f"{name}.obj")
    for panel in reference.panels_of(triangles, names).values():
        directed = [(int(t[i]), int(t[(i + 1) % 3])) for t in panel for i in range(3)]
        assert len(set(directed)) == len(directed)
        assert reference.euler_characteristic(panel) == 1
        assert len(reference.rim_loops(panel)) == 1


def test_normals_point_outward():
    inside = {
        "sheet_bent": [0, 9, 0],
        "shoe_upper": [20, 1, 2],
        "short_pants": [0, 0, 13],
        "hull_panel": [100, 0, -10],
    }
    for name, point in inside.items():
        positions, triangles, _ = reference.read_obj(MESHES / f"{name}.obj")
        a, b, c = (positions[triangles[:, i]] for i in range(3))
        outward = (np.cross(b - a, c - a) * ((a + b + c) / 3 - point)).sum(axis=1) > 0
        assert outward.mean() > 0.85, name


@pytest.mark.parametrize("name", CURVED)
def test_curved_models_are_far_from_developable(name):
    positions, triangles, _ = reference.read_obj(MESHES / f"{name}.obj")
    assert reference.developability(positions, triangles, 0.01) < 0.8


def test_bent_sheet_is_developable_and_the_shell_is_that_sheet_dented():
    sheet, triangles, _ = reference.read_obj(MESHES / "sheet_bent.obj")
    shell, shell_triangles, _ = reference.read_obj(MESHES / "dented_shell.obj")
    assert np.abs(reference.angle_defects(sheet, triangles)).sum() < 1e-8
    assert np.ptp(sheet[:, 2]) > 4
    assert np.array_equal(triangles, shell_triangles)
    moved = np.linalg.norm(shell - sheet, axis=1)
    assert moved.max() > 3.5
    assert moved[[v for edge in reference.rim_edges(triangles) for v in edge]].max() < 1e-6


def test_shoe_is_strongly_doubly_curved_at_the_toe():
    positions, triangles, names = reference.read_obj(MESHES / "shoe_upper.obj")
    assert set(names) == {"upper"}
    defects = reference.angle_defects(positions, triangles)
    toe = positions[:, 0] > positions[:, 0].max() - 6
    assert defects[toe].sum() > 2
    assert defects[toe].sum() > 0.5 * np.abs(defects).sum() / 2


def test_shoe_is_not_linked_to_itself():
    positions, _, _ = reference.read_obj(MESHES / "shoe_upper.obj")
    assert len(np.unique(positions, axis=0)) == len(positions)


def test_hull_panel_lies_on_wigleys_hull_and_is_curved_though_no_angle_defect_is_large():
    positions, triangles, names = reference.read_obj(MESHES / "hull_panel.obj")
    assert set(names) == {"panel"}
    x, y, z = positions.T
    np.testing.assert_allclose(-y, 75 * (1 - (x / 200) ** 2) * (1 - (z / 60) ** 2), atol=1e-7)
    assert np.ptp(x) == pytest.approx(188)
    assert reference.developability(positions, triangles, 0.01) == 1
    assert np.abs(reference.angle_defects(positions, triangles)).sum() > 0.4


@pytest.fixture
def pants():
    positions, triangles, names = reference.read_obj(MESHES / "short_pants.obj")
    return positions, reference.panels_of(triangles, names)


def panels_at_places(positions, panels):
    """For each place: the panels with a vertex there."""
    places = defaultdict(set)
    for name, triangles in panels.items():
        for vertex in np.unique(triangles):
            places[tuple(positions[vertex])].add(name)
    return places


def test_pants_have_four_panels_of_their_own_vertices(pants):
    _, panels = pants
    assert set(panels) == {"right_front", "right_back", "left_front", "left_back"}
    owners = np.concatenate([np.unique(triangles) for triangles in panels.values()])
    assert len(np.unique(owners)) == len(owners)


def test_only_waist_and_hems_are_left_open(pants):
    positions, panels = pants
    rims = defaultdict(int)
    for triangles in panels.values():
        for a, b in reference.rim_edges(triangles):
            rims[frozenset((tuple(positions[a]), tuple(positions[b])))] += 1
    assert max(rims.values()) == 2
    heights = {z for edge, count in rims.items() if count == 1 for (_, _, z) in edge}
    assert heights == {-20.0, 26.0}


def test_one_t_junction_and_one_crotch(pants):
    places = panels_at_places(*pants)
    meetings = {place: names for place, names in places.items() if len(names) > 2}
    assert sorted(len(names) for names in meetings.values()) == [3, 4]
    t_junction = next(names for names in meetings.values() if len(names) == 3)
    assert t_junction == {"right_front", "right_back", "left_back"}
    crotch = next(place for place, names in meetings.items() if len(names) == 4)
    assert crotch == (0.0, 0.0, 0.0)


def test_places_on_a_seam_are_equal_or_far_apart(pants):
    positions, panels = pants
    places = np.array(list(panels_at_places(positions, panels)))
    gaps = np.linalg.norm(places[:, None] - places[None], axis=2)
    gaps[np.diag_indices(len(places))] = np.inf
    assert gaps.min() > 0.1
