# SPDX-License-Identifier: GPL-3.0-or-later
"""What all models share: the type of a model and a smooth curve through given values."""

from __future__ import annotations

import numpy as np

Panels = dict[str, tuple[np.ndarray, np.ndarray]]  # positions n x 3 and triangles m x 3 by name


def ease(x: np.ndarray, knots: list[float], values: list[float]) -> np.ndarray:
    """A curve with two continuous derivatives through the values, level at each knot and outside."""
    x = np.asarray(x, dtype=float)
    result = np.full_like(x, values[0])
    for k in range(len(knots) - 1):
        t = np.clip((x - knots[k]) / (knots[k + 1] - knots[k]), 0.0, 1.0)
        result += (values[k + 1] - values[k]) * t**3 * (10 - 15 * t + 6 * t * t)
    return result
