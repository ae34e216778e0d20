# SPDX-License-Identifier: GPL-3.0-or-later
"""A plywood panel of a dinghy: one side of the fore body of Wigley's hull.

Naval architects use its formula to compare computations: W. C. S. Wigley, "A comparison of experiment and
calculated wave-profiles and wave-resistances for a form having parabolic waterlines", 1934.
"""

from __future__ import annotations

import numpy as np
from shapes import Panels
from triangulation import sample_curve, triangulate

LENGTH, BEAM, DRAUGHT = 400.0, 150.0, 60.0
SPACING = 4.2
AFT, FORE, LOWEST = 0.0, 0.47, 0.8  # shares of the length and of the draught


def hull_side(layout: np.ndarray) -> np.ndarray:
    """Points of the starboard side: x forward, z up from the waterline; half breadths are
    (B/2) (1 - (2x/L)²) (1 - (z/T)²)."""
    x, z = layout[:, 0], layout[:, 1]
    breadth = BEAM / 2 * (1 - (2 * x / LENGTH) ** 2) * (1 - (z / DRAUGHT) ** 2)
    return np.column_stack([x, -breadth, z])


def hull_panel() -> Panels:
    """The panel, with outward normals to starboard."""
    random = np.random.RandomState(5)
    low, high = np.array([AFT * LENGTH, -LOWEST * DRAUGHT]), np.array([FORE * LENGTH, 0.0])
    corners = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])
    sides = []
    for begin, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        side = sample_curve(lambda t, a=begin, b=end: a + t[:, None] * (b - a), hull_side, SPACING, random)
        sides.append(side[:-1])
    layout, triangles = triangulate(np.concatenate(sides), hull_side, SPACING, random)
    return {"panel": (hull_side(layout), triangles)}
