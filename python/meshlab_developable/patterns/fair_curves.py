# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth curves near points: cubic splines whose knots have left the points by less than a tolerance."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
import scipy.interpolate
import scipy.sparse
import scipy.sparse.linalg

from meshlab_developable.mesh_sets import Array

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(5)
_STEPS = 14  # of the bisection for the smoothness, each halves its exponent's range
_RIPPLE, _RIPPLE_SHARE = 20.0, 10.0  # mm; waves as long as this, and so many deviations more, may go


@dataclasses.dataclass
class FairCurve:
    """A cubic spline; the k-th knot stands for the k-th of the points that it was made from."""

    points: Array  # k x 2
    closed: bool  # the last knot is the first again, as the last point is
    knots: Array  # k, the parameter: lengths along the points
    values: Array  # k x 2, where the curve is at the knots

    @property
    def spline(self) -> scipy.interpolate.CubicSpline:
        """The curve as a function of the parameter."""
        if len(self.knots) == 2:
            return scipy.interpolate.CubicSpline(self.knots, self.values, bc_type="natural")
        ends = "periodic" if self.closed else "not-a-knot"
        return scipy.interpolate.CubicSpline(self.knots, self.values, bc_type=ends)

    @property
    def deviation(self) -> float:
        """How far a knot is from its point, at most."""
        return float(np.linalg.norm(self.values - self.points, axis=1).max())

    def lengths(self) -> Array:
        """Lengths (k - 1) of the curve between its knots."""
        parameters, weights = self._quadrature()
        speeds = np.linalg.norm(self.spline(parameters, 1), axis=-1)
        lengths: Array = (speeds * weights).sum(axis=1)
        return lengths

    def curvature(self, parameters: Array) -> Array:
        """Signed curvature, positive where the curve bends to the left."""
        spline = self.spline
        first, second = spline(parameters, 1), spline(parameters, 2)
        speed = np.maximum(np.linalg.norm(first, axis=-1), 1e-300)
        curvature: Array = (first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]) / speed**3
        return curvature

    def normals(self) -> Array:
        """Unit normals (k x 2) to the left at the knots."""
        tangents = self.spline(self.knots, 1)
        tangents /= np.maximum(np.linalg.norm(tangents, axis=1, keepdims=True), 1e-300)
        return np.stack([-tangents[:, 1], tangents[:, 0]], axis=1)

    def strays(self, slack: float) -> list[int]:
        """Intervals in which the curve bulges more from its chord than a bend would, and than the slack."""
        parameters, _ = self._quadrature()
        start, chord = self.values[:-1, None], np.diff(self.values, axis=0)[:, None]
        length = np.maximum(np.linalg.norm(chord, axis=-1), 1e-300)
        offset = self.spline(parameters) - start
        bulge = abs(offset[..., 0] * chord[..., 1] - offset[..., 1] * chord[..., 0]) / length
        return np.flatnonzero(bulge.max(axis=1) > slack + 0.2 * length[:, 0]).tolist()

    def _quadrature(self) -> tuple[Array, Array]:
        """Parameters and weights (k - 1 x 5) for integrals between the knots."""
        steps = np.diff(self.knots)[:, None]
        return self.knots[:-1, None] + (_NODES + 1) / 2 * steps, _WEIGHTS / 2 * steps


def fair_curve(points: Array, fixed: Sequence[int], closed: bool, deviation: float) -> FairCurve:
    """The smoothest of curves whose knots are no farther than the deviation from points in order (k x 2).

    fixed: points that it passes; its ends are among them; where it is closed, the last is the first again.
    Smooth is what changes its curvature little: third differences are small, so that circles stay circles.
    No more is smoothed than what may be ripples.
    """
    knots = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    curve = FairCurve(points, closed, knots, points.copy())
    count = len(points) - closed
    if count < 5:
        return curve
    roughness = third_differences(knots, closed)
    weights = np.ones(count)
    weights[[index % count for index in fixed]] = 1e9

    def smoothed(exponent: float) -> Array:
        data = scipy.sparse.diags_array(weights)
        system = data + 10.0**exponent * (roughness.T @ roughness)
        solved = scipy.sparse.linalg.spsolve(system.tocsc(), data @ points[:count])
        return np.vstack([solved, solved[:1]]) if closed else solved

    low, high = -8.0, most_smoothing(float(np.diff(knots).mean()), deviation)
    for _ in range(_STEPS):
        middle = (low + high) / 2
        values = smoothed(middle)
        if np.linalg.norm(values - points, axis=1).max() <= deviation:
            curve.values, low = values, middle
        else:
            high = middle
    for index in fixed:  # to the last bit
        curve.values[index] = points[index]
    return curve


def most_smoothing(step: float, deviation: float) -> float:
    """The exponent of the weight at which ripples are halved; longer waves are bends and stay."""
    ripple = max(_RIPPLE + _RIPPLE_SHARE * deviation, 2 * np.pi * step)
    return float(6 * np.log10(ripple / (2 * np.pi * step)))


def third_differences(knots: Array, closed: bool) -> scipy.sparse.csr_array:
    """Third divided differences, times the mean step to the third, so that they are lengths."""
    steps = np.diff(knots)
    count = len(steps) if closed else len(knots)
    rows = count if closed else count - 3
    columns = (np.arange(rows)[:, None] + np.arange(4)) % count
    along = np.zeros((rows, 4))
    for position in range(1, 4):
        along[:, position] = along[:, position - 1] + steps[(np.arange(rows) + position - 1) % len(steps)]
    apart = along[:, :, None] - along[:, None, :] + np.eye(4)
    values = 6 * steps.mean() ** 3 / apart.prod(axis=2)
    place = (np.repeat(np.arange(rows), 4), columns.ravel())
    return scipy.sparse.csr_array((values.ravel(), place), shape=(rows, count))
