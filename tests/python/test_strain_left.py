# SPDX-License-Identifier: GPL-3.0-or-later
"""What a verdict says of the strain that is left in practice is what laying flat measures."""

from __future__ import annotations

import meshlab_developable
import numpy as np
import pytest
from meshlab_developable import Status
from shapes import bump


@pytest.mark.parametrize(
    ("parameters", "status"),
    [
        ({"max_displacement": 0.0285}, Status.NEEDS_CUT),
        ({"max_iterations": 5}, Status.LIMIT_REACHED),
    ],
)
def test_little_curvature_is_told_as_strain(parameters, status):
    vertices, faces = bump()
    result = meshlab_developable.make_developable(vertices, faces, **parameters)
    assert result.report.status is status
    flat = meshlab_developable.flatten(result.vertices, faces)
    lengths = edge_lengths(result.vertices, faces)
    strain = np.abs(edge_lengths(flat.vertices, flat.faces) - lengths) / lengths
    assert strain.max() > 0.005
    assert result.report.edge_strain_left == pytest.approx(100 * strain.max(), rel=1e-6)
    assert flat.report.max_edge_strain == pytest.approx(strain.max(), rel=1e-6)
    left = f"{result.report.edge_strain_left:.4g} %"
    words = f"; laid flat as it is, no edge changes its length by more than {left}"
    assert result.report.reason.endswith(words)


def edge_lengths(points, faces):
    """Of each face's three."""
    corners = points[faces]
    return np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)


def test_much_curvature_is_not():
    vertices, faces = bump()
    report = meshlab_developable.make_developable(vertices, faces, max_displacement=0).report
    assert report.total_absolute_curvature_after > 0.3
    assert report.edge_strain_left == 0
    assert "laid flat" not in report.reason


def test_what_is_nearly_there_says_so_in_words():
    vertices, faces = bump()  # to less than rounding leaves
    impossible = {"curvature_tolerance": 1e-15, "angle_tolerance": 1e-15}
    report = meshlab_developable.make_developable(vertices, faces, **impossible).report
    assert report.status is Status.NEEDS_CUT
    assert 0 < report.edge_strain_left < 1e-9
    assert "but it is nearly there: laid flat as it is" in report.reason
    assert f"no edge changes its length by more than {report.edge_strain_left:.4g} %" in report.reason
