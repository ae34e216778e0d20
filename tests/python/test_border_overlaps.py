# SPDX-License-Identifier: GPL-3.0-or-later
"""What is said of panels that would overlap themselves at their borders, and of patterns that collapse."""

from __future__ import annotations

import meshlab_developable
import numpy as np
import pytest
from meshlab_developable import Status


def corkscrew(angle: float, triangles: int = 8):
    """A fan round its first vertex, where the angles add up to a little more than `angle`, rad."""
    at = np.linspace(0, angle, triangles + 1)
    rim = np.column_stack([np.cos(at), np.sin(at), 0.05 * np.arange(triangles + 1)])
    faces = [(0, 1 + i, 2 + i) for i in range(triangles)]
    return np.vstack([np.zeros(3), rim]), np.array(faces)


def test_a_border_that_exceeds_a_full_turn_is_named():
    vertices, faces = corkscrew(6.6)
    held = np.ones(len(vertices), dtype=bool)
    held[4] = False
    report = meshlab_developable.make_developable(vertices, faces, fix_selected=held).report
    assert report.status is Status.STALLED
    assert report.total_absolute_curvature_after == 0
    assert report.max_border_angle > 2 * np.pi
    assert report.border_overlaps == 1
    assert "the curvature is gone, but" in report.reason
    assert (
        "more than a full turn at border vertices (1 in number), first of all at (0, 0, 0)" in report.reason
    )
    [panel] = report.panels
    assert panel.border_overlaps == 1
    assert panel.reason == report.reason
    assert panel.worst_point == (0, 0, 0)


def test_a_border_that_may_move_comes_back_to_a_full_turn():
    vertices, faces = corkscrew(6.6)
    report = meshlab_developable.make_developable(vertices, faces, max_displacement=10).report
    assert report.developable
    assert report.border_overlaps == 0
    assert report.max_border_angle <= 2 * np.pi + 1e-4


def test_strains_of_a_pattern_that_collapses_stay_readable():
    # A long stocking, closed at its toe, has no pattern: laid flat its faces shrink to next to nothing.
    rings, round_about = 30, 12
    around = np.linspace(0, 2 * np.pi, round_about, endpoint=False)
    vertices = [(np.cos(a), np.sin(a), 0.5 * ring) for ring in range(rings) for a in around] + [(0, 0, -0.3)]
    faces = []
    for ring in range(rings - 1):
        for i in range(round_about):
            a, b = ring * round_about + i, ring * round_about + (i + 1) % round_about
            faces += [(a, b, b + round_about), (a, b + round_about, a + round_about)]
    faces += [(rings * round_about, (i + 1) % round_about, i) for i in range(round_about)]
    result = meshlab_developable.make_developable(np.array(vertices), np.array(faces), max_displacement=0)
    report = result.report
    assert not report.developable
    assert report.collapsed_faces > 0
    assert report.max_stretch == pytest.approx(900)
    assert 0 <= report.max_compression <= 100
    [warning] = [text for text in report.warnings if "collapse" in text]
    assert warning.startswith(f"laid flat as it is, {report.collapsed_faces} faces collapse")
    flat = meshlab_developable.flatten(result.vertices, np.array(faces)).report
    assert flat.max_stretch == pytest.approx(900)
