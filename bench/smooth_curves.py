# SPDX-License-Identifier: GPL-3.0-or-later
"""How smooth seams are: their lengths beside those of smooth curves fitted to them.

The curve is the least-squares cubic spline with the fewest equal intervals that stays within a tolerance of
the seam. A seam with saw-teeth is longer than it, one that is itself smooth is not.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from meshlab_developable.flattening import FlatteningResult
from scipy.interpolate import make_lsq_spline

SHORTEST = 3.0  # seams shorter than so many edges have no shape of their own
MOST_INTERVALS = 60


def steps(points: Any) -> Any:
    """The lengths between points (k x 3) in order, k - 1."""
    return np.linalg.norm(np.diff(points, axis=0), axis=1)


def fitted_length(points: Any, tolerance: float) -> float:
    """The length of the curve that is fitted to a polyline (k x 3) and ends where it ends."""
    along = np.append(0, np.cumsum(steps(points)))
    samples = np.linspace(0, along[-1], max(40, int(5 * along[-1] / tolerance)))
    on_line = np.column_stack([np.interp(samples, along, axis) for axis in points.T])
    weights = np.ones(len(samples))
    weights[[0, -1]] = 1e3
    for intervals in range(1, MOST_INTERVALS):
        inner = np.linspace(0, along[-1], intervals + 1)[1:-1]
        knots = np.concatenate([np.zeros(4), inner, np.full(4, along[-1])])
        curve = make_lsq_spline(samples, on_line, knots, 3, w=weights)(samples)
        if np.linalg.norm(curve - on_line, axis=1).max() <= tolerance:
            break
    return float(steps(curve).sum())


def seams_beside_smooth_curves(flat: FlatteningResult, edge: float) -> tuple[float, float]:
    """All seams together beside the curves fitted within half an edge, and the one that is longest beside
    its own.

    flat: the cut mesh, as it is. edge: the mean length of the edges before it was cut.
    """
    lengths = []
    for seam in flat.seams:
        points = flat.model_vertices[seam.sides[0]]
        length = float(steps(points).sum())
        if length > SHORTEST * edge:
            lengths.append((length, fitted_length(points, edge / 2)))
    if not lengths:
        return 1.0, 1.0
    seams, curves = np.array(lengths).T
    return float(seams.sum() / curves.sum()), float((seams / curves).max())
