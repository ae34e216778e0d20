# SPDX-License-Identifier: GPL-3.0-or-later
"""A boundary of a flat piece as smooth curves between its corners, measured and sampled by length."""

from __future__ import annotations

import dataclasses
import itertools

import numpy as np

from meshlab_developable.mesh_sets import Array, IndexArray
from meshlab_developable.patterns.corners import find_corners
from meshlab_developable.patterns.fair_curves import FairCurve, fair_curve

CHORD_ERROR = 0.01  # mm, between a curve and the lines that it is sampled to
PARTS = 8  # of an edge, between which its speed changes little


@dataclasses.dataclass
class Run:
    """Edges along a ring, in order, one after the other."""

    ring: BoundaryRing
    edges: list[int]
    backwards: bool  # the order is against the ring's

    def vertices(self) -> list[int]:
        """Positions on the ring of the ends of the edges, in order."""
        step = 1 - self.backwards
        first = self.edges[0] + self.backwards
        return [index % len(self.ring.loop) for index in (first, *(edge + step for edge in self.edges))]

    def lengths(self) -> Array:
        """Lengths of the edges along the curves."""
        return self.ring.edge_lengths[self.edges]


class BoundaryRing:
    """A ring of vertices and the curves that run near them, from corner to corner."""

    def __init__(self, loop: IndexArray, points: Array, fixed: set[int], tolerance: float) -> None:
        """loop: vertices of the flattening. points: k x 2, where they are, mm. fixed: positions of those
        that the curves pass. tolerance: mm, from the points to the lines that curves are sampled to."""
        self.loop, self.points, self.fixed, self.tolerance = loop, points, fixed, tolerance
        self.reach = max(tolerance - 2 * CHORD_ERROR, 0.0)  # of knots from their points
        self.corners = find_corners(points, fixed, tolerance)
        self.curves: list[tuple[list[int], FairCurve]] = []
        self.edge_lengths = np.zeros(len(loop))
        self._made: dict[tuple[bool | int, ...], Array] = {}

    def fit(self) -> None:
        """Make the curves anew."""
        while True:
            self.curves = [(indices, self._curve(indices)) for indices in self._stretches()]
            strays = {
                indices[interval + end]
                for indices, curve in self.curves
                for interval in curve.strays(self.tolerance)
                for end in (0, 1)
            }
            if strays <= self.corners:
                break
            self.corners |= strays
        for indices, curve in self.curves:
            self._measure(indices, curve)

    def _curve(self, indices: list[int]) -> FairCurve:
        closed = not self.corners
        key = (closed, *indices)
        fixed = [k for k, index in enumerate(indices) if index in self.fixed or index in self.corners]
        if key not in self._made:
            curve = fair_curve(self.points[indices], fixed, closed, self.reach / 2)
            self._made[key] = curve.values.copy()
            return curve
        knots = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(self.points[indices], axis=0), axis=1)))
        return FairCurve(self.points[indices], closed, knots, self._made[key].copy())

    def _stretches(self) -> list[list[int]]:
        """Positions of the points along each curve."""
        count = len(self.loop)
        starts = sorted(self.corners) or [min(self.fixed, default=0)]
        return [
            [index % count for index in range(start, end + 1)]
            for start, end in zip(starts, [*starts[1:], starts[0] + count], strict=True)
        ]

    def _measure(self, indices: list[int], curve: FairCurve) -> None:
        self.edge_lengths[indices[:-1]] = curve.lengths()

    def bend(self, run: Run) -> tuple[float, list[tuple[int, Array]]]:
        """How points may move to change the length of a run, and by how much it then gets longer.

        Returns the rate, and for each curve on the run its number and shifts (k x 2) of its knots, that are
        to be multiplied by an amount: outwards in proportion to the curvature, none at fixed points.
        """
        on_run = set(run.edges)
        rate, moves = 0.0, []
        for number, (indices, curve) in enumerate(self.curves):
            inside = [index in on_run for index in indices[:-1]]
            if not any(inside) or len(indices) < 4:
                continue
            lengths = self.edge_lengths[indices[:-1]]
            window = self._window(indices, lengths, inside)
            bends = -curve.curvature(curve.knots) * window
            spacing = (np.append(0.0, lengths) + np.append(lengths, 0.0)) / 2
            rate += float((bends**2 / np.maximum(window, 1e-9) * spacing).sum())
            moves.append((number, bends[:, None] * curve.normals()))
        return rate, moves

    def _window(self, indices: list[int], lengths: Array, inside: list[bool]) -> Array:
        """0 at fixed points and where the run is not, 1 in the middles between them."""
        stops = [
            k
            for k, index in enumerate(indices)
            if k in (0, len(indices) - 1) or index in self.fixed or inside[k - 1] != inside[k]
        ]
        window = np.zeros(len(indices))
        arcs = np.append(0.0, np.cumsum(lengths))
        for start, end in itertools.pairwise(stops):
            if inside[start]:
                share = (arcs[start : end + 1] - arcs[start]) / (arcs[end] - arcs[start])
                window[start : end + 1] = 4 * share * (1 - share)
        return window

    def move(self, moves: list[tuple[int, Array]], amount: float) -> None:
        """Move knots, but none farther than the tolerance from its point."""
        for number, shifts in moves:
            indices, curve = self.curves[number]
            offsets = curve.values + amount * shifts - curve.points
            sizes = np.maximum(np.linalg.norm(offsets, axis=1, keepdims=True), 1e-300)
            curve.values = curve.points + offsets * np.minimum(1.0, self.reach / sizes)
            if curve.closed:
                curve.values[-1] = curve.values[0]
            self._measure(indices, curve)

    def sample(self, edges: IndexArray, shares: Array) -> Array:
        """Points (k x 2), each at a share of an edge's length."""
        points = np.empty((len(edges), 2))
        for indices, curve in self.curves:
            intervals = {edge: interval for interval, edge in enumerate(indices[:-1])}
            here = np.flatnonzero([edge in intervals for edge in edges.tolist()])
            if not len(here):
                continue
            parameters, arcs, _ = _table(curve)
            chosen = [intervals[edge] for edge in edges[here].tolist()]
            at = [
                np.interp(share, arcs[interval], parameters[interval])
                for interval, share in zip(chosen, shares[here], strict=True)
            ]
            points[here] = curve.spline(np.array(at))
        return points

    def parts(self) -> tuple[Array, Array]:
        """Lengths of the parts (n x PARTS) of each edge, and how many lines a unit of length needs there."""
        lengths, density = np.zeros((2, len(self.loop), PARTS))
        for indices, curve in self.curves:
            _, arcs, curvature = _table(curve)
            lengths[indices[:-1]] = np.diff(arcs, axis=1) * self.edge_lengths[indices[:-1], None]
            if len(indices) > 2:
                bend = np.maximum(curvature[:, 1:], curvature[:, :-1])
                density[indices[:-1]] = np.sqrt(bend / (8 * CHORD_ERROR))
        return lengths, density


def _table(curve: FairCurve) -> tuple[Array, Array, Array]:
    """Parameters closely between the knots (k - 1 x parts + 1), shares of length there, and curvature."""
    parts = np.linspace(0, 1, PARTS + 1)
    parameters = curve.knots[:-1, None] + parts * np.diff(curve.knots)[:, None]
    steps = np.linalg.norm(np.diff(curve.spline(parameters), axis=1), axis=2)
    arcs = np.concatenate([np.zeros((len(steps), 1)), np.cumsum(steps, axis=1)], axis=1)
    arcs /= np.maximum(arcs[:, -1:], 1e-300)
    return parameters, arcs, abs(curve.curvature(parameters))
