# SPDX-License-Identifier: GPL-3.0-or-later
"""Fine polylines as cubic Bézier curves, for formats that have them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from meshlab_developable.mesh_sets import Array
from meshlab_developable.patterns.corners import turning

CORNER = np.radians(20)  # what bends more at a point is no curve
TOLERANCE = 0.02  # mm, from the points
_SAME = 1e-6  # mm; points that are nearer are one
_CORRECTIONS = 3  # of the points' parameters


def bezier_curves(points: Array) -> list[Array]:
    """Curves (4 x 2: ends and the control points between them) along a ring, one from where the other ends.

    points: k x 2; the first is not repeated. Curves meet at corners, and elsewhere smoothly; also at
    the extremes of x and y, so that their ends tell the box.
    """
    points = points[np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1) > _SAME]
    count = len(points)
    corners = set(np.flatnonzero(abs(turning(points)) > CORNER).tolist())
    starts = sorted({*corners, *points.argmin(axis=0).tolist(), *points.argmax(axis=0).tolist()})
    curves: list[Array] = []
    for start, end in zip(starts, [*starts[1:], starts[0] + count], strict=True):
        line = points[np.arange(start, end + 1) % count]
        first, last = (_unit(points[(at + 1) % count] - points[(at - 1) % count]) for at in (start, end))
        if start in corners:
            first = _end_tangent(line)
        if end % count in corners:
            last = -_end_tangent(line[::-1])
        curves += _fitted(line, first, last)
    return curves


def _unit(vector: Array) -> Array:
    unit: Array = vector / max(float(np.linalg.norm(vector)), 1e-300)
    return unit


def _end_tangent(line: Array) -> Array:
    """The direction at the first point, of the parabola through the first three."""
    if len(line) < 3:
        return _unit(line[1] - line[0])
    one, two = np.linalg.norm(line[1] - line[0]), np.linalg.norm(line[2] - line[1])
    slopes = (line[1] - line[0]) / one, (line[2] - line[1]) / two
    return _unit(slopes[0] - (slopes[1] - slopes[0]) * one / (one + two))


def _fitted(line: Array, first: Array, last: Array) -> Iterator[Array]:
    """Curves along a line with those directions at its ends, as few as halving at the worst point gives."""
    chord = float(np.linalg.norm(line[-1] - line[0]))
    if len(line) == 2:
        yield _with_arms(line, first, last, (chord / 3, chord / 3))
        return
    parameters = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1)))
    parameters /= parameters[-1]
    for _ in range(_CORRECTIONS):
        curve = _with_arms(line, first, last, _arms(line, parameters, first, last))
        offsets = _basis(parameters) @ curve - line
        errors = np.linalg.norm(offsets, axis=1)
        if errors.max() <= TOLERANCE:
            yield curve
            return
        parameters = _corrected(curve, parameters, offsets)
    worst = int(np.clip(errors.argmax(), 1, len(line) - 2))
    middle = _unit(line[worst + 1] - line[worst - 1])
    yield from _fitted(line[: worst + 1], first, middle)
    yield from _fitted(line[worst:], middle, last)


def _with_arms(line: Array, first: Array, last: Array, arms: tuple[float, float]) -> Array:
    return np.array([line[0], line[0] + arms[0] * first, line[-1] - arms[1] * last, line[-1]])


def _basis(t: Array) -> Array:
    """Bernstein's polynomials of degree 3 (k x 4)."""
    return np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3], axis=1)


def _arms(line: Array, t: Array, first: Array, last: Array) -> tuple[float, float]:
    """Distances of the control points from the ends that fit a line best, in the sense of least squares."""
    basis = _basis(t)
    fixed = basis[:, :2].sum(axis=1)[:, None] * line[0] + basis[:, 2:].sum(axis=1)[:, None] * line[-1]
    system = np.stack([np.outer(basis[:, 1], first).ravel(), -np.outer(basis[:, 2], last).ravel()], axis=1)
    one, other = np.linalg.lstsq(system, (line - fixed).ravel())[0]
    chord = float(np.linalg.norm(line[-1] - line[0]))
    if min(one, other) < 1e-3 * chord or max(one, other) > chord:  # beyond its chord it may turn back
        return chord / 3, chord / 3
    return float(one), float(other)


def _corrected(curve: Array, t: Array, offsets: Array) -> Array:
    """Parameters nearer to those of the nearest points: a step of Newton's method each."""
    velocity = 3 * np.diff(curve, axis=0)
    acceleration = 2 * np.diff(velocity, axis=0)
    first = np.stack([(1 - t) ** 2, 2 * t * (1 - t), t**2], axis=1) @ velocity
    second = np.stack([1 - t, t], axis=1) @ acceleration
    slope = np.einsum("ij,ij->i", first, first) + np.einsum("ij,ij->i", offsets, second)
    step = np.einsum("ij,ij->i", offsets, first) / np.where(abs(slope) > 1e-12, slope, np.inf)
    corrected = np.maximum.accumulate(np.clip(t - step, 0, 1))
    corrected[[0, -1]] = 0, 1
    return corrected
