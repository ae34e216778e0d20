# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines on the model, along its edges, as lines on the pieces: style lines, folds, where a pocket goes."""

from __future__ import annotations

import itertools
from collections import defaultdict
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from meshlab_developable.errors import PatternError
from meshlab_developable.flattening import FlatteningResult

NEAR = 1e-6  # of the model's size: points this near are a vertex

Edges = dict[tuple[int, int], list[tuple[int, int]]]  # of the pieces, by the places of their ends


def trace_lines(flat: FlatteningResult, lines: Sequence[npt.ArrayLike]) -> list[tuple[int, list[int]]]:
    """Where lines of the model run on the pieces: a piece's number and vertices in order, for every stretch.

    lines: k x 3 each, vertices of the mesh from one to its neighbour. Raises PatternError where they are not.
    """
    edges = _edges_by_places(flat) if len(lines) else {}
    found = []
    for number, line in enumerate(lines):
        places = _places(flat, line, number + 1)
        stretches: dict[int, list[int]] = {}  # the one that each piece is at
        for step, ends in enumerate(itertools.pairwise(places)):
            if ends not in edges:
                raise PatternError(
                    f"Internal line {number + 1}: there is no edge from its point {step + 1} to the next."
                )
            before, stretches = stretches, {}
            for start, end in edges[ends]:
                piece = int(flat.pieces[start])
                stretch = before.get(piece, [])
                if not stretch or stretch[-1] != start:
                    stretch = [start]
                    found.append((piece, stretch))
                stretch.append(end)
                stretches[piece] = stretch
    return found


def _edges_by_places(flat: FlatteningResult) -> Edges:
    edges: Edges = defaultdict(list)
    sides = np.unique(np.sort(flat.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    for start, end in sides.tolist():
        places = int(flat.places[start]), int(flat.places[end])
        edges[places].append((start, end))
        edges[places[::-1]].append((end, start))
    return edges


def _places(flat: FlatteningResult, line: npt.ArrayLike, number: int) -> list[int]:
    points = np.asarray(line, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < 2:
        raise PatternError(f"Internal line {number} must be points, k x 3, at least two of them.")
    size = np.linalg.norm(np.ptp(flat.model_vertices, axis=0))
    places = []
    for index, point in enumerate(points):
        distances = np.linalg.norm(flat.model_vertices - point, axis=1)
        nearest = int(distances.argmin())
        if not distances[nearest] <= NEAR * size:
            raise PatternError(f"Internal line {number}: its point {index + 1} is no vertex of the mesh.")
        places.append(int(flat.places[nearest]))
    return places
