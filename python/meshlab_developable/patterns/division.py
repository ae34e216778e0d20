# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth boundaries divided into short lines, both sides of a seam at the same shares of its length."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

import numpy as np

from meshlab_developable.mesh_sets import Array, IndexArray
from meshlab_developable.patterns.boundary_rings import BoundaryRing, Run

LONGEST = 100.0  # mm, a line on what is nearly straight


class Division:
    """Points on boundaries: first the vertices of the flattening, then new ones between them."""

    def __init__(self, rings: Sequence[BoundaryRing], vertices: Array, pieces: IndexArray) -> None:
        """vertices: p x 2, mm; those on boundaries go to their curves. pieces: p."""
        self._rings = rings
        self._vertices, self._pieces = vertices.copy(), pieces
        self._new: list[Array] = []
        self._new_pieces: list[Array] = []
        self._count = len(vertices)
        self._marks: dict[int, dict[float, int]] = {}  # of each ring: points by edge and share of it
        self._parts = {id(ring): ring.parts() for ring in rings}
        self._divided: set[tuple[int, int]] = set()
        for ring in rings:
            self._marks[id(ring)] = {
                float(position): int(ring.loop[position]) for position in ring.corners | ring.fixed
            }
            for indices, curve in ring.curves:
                self._vertices[ring.loop[indices]] = curve.values

    def divide(self, runs: Sequence[Run]) -> tuple[IndexArray, ...]:
        """Points along each of the runs, which have the same number of edges: the i-th of all correspond."""
        stops = [
            k
            for k, positions in enumerate(zip(*(run.vertices() for run in runs), strict=True))
            if k in (0, len(runs[0].edges))
            or any(at in run.ring.corners | run.ring.fixed for at, run in zip(positions, runs, strict=True))
        ]
        found: list[list[int]] = [[] for _ in runs]
        for start, end in itertools.pairwise(stops):
            stretches = [Run(run.ring, run.edges[start:end], run.backwards) for run in runs]
            shares = self._shares(stretches)
            for points, stretch in zip(found, stretches, strict=True):
                points.extend(self._place(stretch, shares)[:-1])
        for points, run in zip(found, runs, strict=True):
            points.append(int(run.ring.loop[run.vertices()[-1]]))
            self._divided |= {(id(run.ring), edge) for edge in run.edges}
        return tuple(np.array(points, dtype=np.int32) for points in found)

    def finish(self) -> tuple[IndexArray, ...]:
        """Divide what has not been yet; the points along each ring."""
        for ring in self._rings:
            for run in self._left(ring):
                self.divide([run])
        return tuple(
            np.array([marks[at] for at in sorted(marks)], dtype=np.int32)
            for marks in (self._marks[id(ring)] for ring in self._rings)
        )

    def points(self) -> Array:
        """All points, mm."""
        return np.vstack([self._vertices, *self._new])

    def pieces(self) -> IndexArray:
        """The piece of each point."""
        return np.concatenate([self._pieces, *self._new_pieces]).astype(np.int32)

    def _left(self, ring: BoundaryRing) -> Iterator[Run]:
        count = len(ring.loop)
        start = min(ring.corners | ring.fixed, default=0)
        run: list[int] = []
        for edge in (*((start + step) % count for step in range(count)), -1):
            if edge >= 0 and (id(ring), edge) not in self._divided:
                run.append(edge)
            elif run:
                yield Run(ring, run, backwards=False)
                run = []

    def _shares(self, runs: Sequence[Run]) -> Array:
        """Shares of the lengths of runs, from 0 to 1, between which all of them are nearly straight."""
        profiles = []
        for run in runs:
            step = -1 if run.backwards else 1
            lengths, density = (values[run.edges][:, ::step].ravel() for values in self._parts[id(run.ring)])
            total = lengths.sum()
            profiles.append((np.cumsum(lengths) / total, np.maximum(density, 1 / LONGEST) * total))
        ends = np.unique(np.concatenate([np.minimum(ends, 1.0) for ends, _ in profiles]))
        starts = np.append(0.0, ends[:-1])
        rates = np.max(
            [
                rate[np.minimum(np.searchsorted(own, (starts + ends) / 2), len(rate) - 1)]
                for own, rate in profiles
            ],
            axis=0,
        )
        counts = np.append(0.0, np.cumsum(rates * (ends - starts)))
        number = max(1, int(np.ceil(counts[-1])))
        shares: Array = np.interp(np.linspace(0, counts[-1], number + 1), counts, np.append(0.0, ends))
        return shares

    def _place(self, run: Run, shares: Array) -> list[int]:
        """The points at those shares of a run's length."""
        ring, lengths = run.ring, run.lengths()
        first, last = (int(ring.loop[run.vertices()[end]]) for end in (0, -1))
        marks = self._marks[id(ring)]
        vertices = run.vertices()
        for end, number in ((0, first), (-1, last)):
            marks[float(vertices[end])] = number
        if len(shares) == 2:
            return [first, last]
        arcs = shares[1:-1] * lengths.sum()
        ends = np.cumsum(lengths)
        along = np.minimum(np.searchsorted(ends, arcs, side="right"), len(ends) - 1)
        inside = np.clip((arcs - (ends[along] - lengths[along])) / lengths[along], 0.0, 1.0)
        edges = np.array(run.edges)[along]
        inside = 1 - inside if run.backwards else inside
        numbers = list(range(self._count, self._count + len(edges)))
        self._count += len(edges)
        self._new.append(ring.sample(edges, inside))
        self._new_pieces.append(np.full(len(edges), self._pieces[ring.loop[0]]))
        marks.update(zip((edges + inside).tolist(), numbers, strict=True))
        return [first, *numbers, last]
