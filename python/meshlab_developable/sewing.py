# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundaries of flat pieces, and which edge of them is sewn to which."""

from __future__ import annotations

import dataclasses
from collections import defaultdict
from typing import Any

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

    @property
    def ease(self) -> float:
        """The same as a share of the shorter side."""
        return ease_of(self.lengths)


def ease_of(lengths: tuple[float, float]) -> float:
    """By how much one side of a seam is longer than the other, as a share of the shorter."""
    return abs(lengths[0] - lengths[1]) / min(lengths)


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


def read_seams(pattern: Any, flat: Array, pieces: IndexArray, places: IndexArray) -> tuple[Seam, ...]:
    """The seams of flat pieces: between pieces, of a piece with itself, and along cuts.

    pattern: the layer that Flatten Patches made, with its attributes of the faces. flat: p x 2, in the plane.
    pieces, places: p. Where three or more edges meet, each is sewn to the first of them.
    """
    numbers, positions, sewn_to = (
        pattern.face_custom_point_attribute_matrix(name).astype(np.int32).ravel()
        for name in ("seam", "seam_edge", "sewn_to")
    )
    first = np.flatnonzero(numbers)  # as 3 x face + side
    first = first[np.lexsort((positions[first], numbers[first]))]
    faces = pattern.face_matrix()
    ends = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)  # of every side
    starts = np.flatnonzero(np.diff(numbers[first], prepend=0))
    return tuple(
        _seam(ends[sides], ends[sewn_to[sides]], flat, pieces, places)
        for sides in np.split(first, starts[1:])
        if len(sides)
    )


def _seam(edges: IndexArray, others: IndexArray, flat: Array, pieces: IndexArray, places: IndexArray) -> Seam:
    """From the ends (k x 2) of the edges along both sides."""
    one = _chain(edges)
    # Each edge of the other side turned so that its ends are at the places of the edge that it is sewn to.
    turned = places[others[:, 0]] != places[one[:-1]]
    others = np.where(turned[:, None], others[:, ::-1], others)
    other = np.append(others[:, 0], others[-1, 1])
    one_length, other_length = (
        float(np.linalg.norm(np.diff(flat[side], axis=0), axis=1).sum()) for side in (one, other)
    )
    return Seam(
        pieces=(int(pieces[one[0]]), int(pieces[other[0]])),
        sides=(one, other),
        lengths=(one_length, other_length),
        closed=bool(one[0] == one[-1]) and bool(other[0] == other[-1]),
    )


def _chain(edges: IndexArray) -> IndexArray:
    """The vertices along edges (k x 2) in order, each of which may be turned."""
    start, end = edges[0]
    if len(edges) > 1 and end not in edges[1]:
        start, end = end, start
    chain = [start, end]
    for edge in edges[1:]:
        chain.append(edge[1] if edge[0] == chain[-1] else edge[0])
    return np.array(chain, dtype=np.int32)
