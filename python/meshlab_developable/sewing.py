# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundaries of flat pieces, and which edge of them is sewn to which."""

from __future__ import annotations

import dataclasses
from collections import defaultdict
from collections.abc import Sequence

import numpy as np

from meshlab_developable.mesh_sets import Array, IndexArray


@dataclasses.dataclass(frozen=True)
class Seam:
    """Two boundary curves that are sewn together, edge by edge. They may belong to one piece."""

    pieces: tuple[int, int]
    sides: tuple[IndexArray, IndexArray]  # the vertices along each, in order; the i-th are sewn together
    lengths: tuple[float, float]  # in the plane
    closed: bool  # a ring; its first vertex is its last too

    @property
    def mismatch(self) -> float:
        """How much longer one side is than the other."""
        return abs(self.lengths[0] - self.lengths[1])


def boundary_loops(faces: IndexArray) -> tuple[IndexArray, ...]:
    """The boundaries of a mesh of manifold pieces, as rings of vertices in order.

    faces: m x 3, in which every vertex has one fan of faces. Each ring begins at its least vertex.
    """
    neighbours: dict[int, list[int]] = defaultdict(list)
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    unique, uses = np.unique(edges, axis=0, return_counts=True)
    for start, end in unique[uses == 1].tolist():
        neighbours[start].append(end)
        neighbours[end].append(start)
    loops = []
    unseen = dict.fromkeys(sorted(neighbours))
    while unseen:
        first = next(iter(unseen))
        ring, previous, current = [first], first, neighbours[first][0]
        while current != first:
            ring.append(current)
            one, other = neighbours[current]
            previous, current = current, other if one == previous else one
        for vertex in ring:
            del unseen[vertex]
        loops.append(np.array(ring, dtype=np.int32))
    return tuple(loops)


def signed_area(ring: Array) -> float:
    """The area that a ring of points (k x 2) goes round, positive when it does so to the left."""
    x, y = (ring - ring[0]).T
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) / 2)


def find_seams(
    vertices: Array, loops: Sequence[IndexArray], places: IndexArray, pieces: IndexArray
) -> tuple[Seam, ...]:
    """The seams of flat pieces: between pieces, of a piece with itself, and along cuts.

    vertices: p x 2. loops: as of `boundary_loops`. places: p; equal numbers are sewn together. pieces: p.
    Where three or more edges meet, each is sewn to the first of them.
    """
    return _SeamFinder(vertices, loops, places, pieces).find()


Edge = tuple[int, int]  # two neighbours along a boundary
Pair = tuple[Edge, Edge]  # edges whose i-th vertices are at the same place


class _SeamFinder:
    """Pairs boundary edges whose ends are at the same places, and follows the pairs along the boundaries."""

    def __init__(
        self, vertices: Array, loops: Sequence[IndexArray], places: IndexArray, pieces: IndexArray
    ) -> None:
        self.vertices, self.places, self.pieces = vertices, places.tolist(), pieces
        self.neighbours: dict[int, tuple[int, int]] = {}
        meeting: dict[Edge, list[Edge]] = defaultdict(list)  # edges by their ends' places
        for loop in loops:
            ring = loop.tolist()
            for index, vertex in enumerate(ring):
                after = ring[(index + 1) % len(ring)]
                self.neighbours[vertex] = ring[index - 1], after
                edge = (vertex, after) if self.places[vertex] < self.places[after] else (after, vertex)
                meeting[self.places[edge[0]], self.places[edge[1]]].append(edge)
        self.unseen = dict.fromkeys((first, other) for first, *others in meeting.values() for other in others)

    def find(self) -> tuple[Seam, ...]:
        seams = []
        while self.unseen:
            pair = next(iter(self.unseen))
            del self.unseen[pair]
            (start, end), (other_start, other_end) = pair
            sides = [start, end], [other_start, other_end]
            self._extend(sides)
            for side in sides:
                side.reverse()
            self._extend(sides)
            seams.append(self._seam(sides))
        return tuple(seams)

    def _extend(self, sides: tuple[list[int], list[int]]) -> None:
        """Goes on with the seam beyond its end, as far as the same two boundaries are sewn together."""
        while True:
            ends = [(side[-1], self._beyond(side[-2], side[-1])) for side in sides]
            if not self._take((ends[0], ends[1])):
                return
            for side, (_, vertex) in zip(sides, ends, strict=True):
                side.append(vertex)

    def _beyond(self, before: int, vertex: int) -> int:
        one, other = self.neighbours[vertex]
        return other if one == before else one

    def _take(self, pair: Pair) -> bool:
        """Whether two edges are sewn together and in no seam yet; from now on they are in one."""
        (a, b), (c, d) = pair
        for known in ((a, b), (c, d)), ((b, a), (d, c)), ((c, d), (a, b)), ((d, c), (b, a)):
            if known in self.unseen:
                del self.unseen[known]
                return True
        return False

    def _seam(self, sides: tuple[list[int], list[int]]) -> Seam:
        one, other = (np.array(side, dtype=np.int32) for side in sides)
        lengths = [
            float(np.linalg.norm(np.diff(self.vertices[side], axis=0), axis=1).sum()) for side in (one, other)
        ]
        return Seam(
            pieces=(int(self.pieces[one[0]]), int(self.pieces[other[0]])),
            sides=(one, other),
            lengths=(lengths[0], lengths[1]),
            closed=bool(one[0] == one[-1]) and bool(other[0] == other[-1]),
        )
