# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels that overlap themselves widely when they are laid flat, split so that their parts do not."""

from __future__ import annotations

import dataclasses
import heapq
from collections.abc import Mapping

import numpy as np
import shapely

from meshlab_developable.flattening import FlatteningResult
from meshlab_developable.mesh_sets import Array, IndexArray
from meshlab_developable.patterns.options import PatternOptions
from meshlab_developable.patterns.overlaps import Overlap

Neighbours = list[list[tuple[int, float]]]


def split_labels(flat: FlatteningResult, pieces: set[int]) -> IndexArray:
    """A label for each face (m), such that faces of the same label do not lie on each other.

    pieces: the numbers of those to be split; a face of another has the label of its piece. A piece is split
    half-way on the surface between two faces that lie on each other, those that are farthest apart on it, and
    its parts again while that is needed. All labels are new but the first part's.
    """
    labels: IndexArray = flat.pieces[flat.faces[:, 0]].astype(np.int32)
    triangles = shapely.polygons(flat.vertices[flat.faces])
    neighbours = _neighbours(flat)
    next_label = int(labels.max()) + 1
    waiting = sorted(pieces)
    while waiting:
        label = waiting.pop()
        faces = np.flatnonzero(labels == label).astype(np.int32)
        seeds = _overlapping_pair(triangles, neighbours, faces)
        if seeds is None:
            continue
        one, other = (_distances(neighbours, faces, seed) for seed in seeds)
        labels[faces[other[faces] < one[faces]]] = next_label
        waiting += [label, next_label]
        next_label += 1
    return labels


def split_options(
    flat: FlatteningResult, parts: FlatteningResult, split: Mapping[int, Overlap], options: PatternOptions
) -> tuple[PatternOptions, list[str]]:
    """The options with names for the parts, and what a user should know of them.

    flat, parts: before and after, with the same faces. split: why, by the piece's number before.
    """
    before, after = (result.pieces[result.faces[:, 0]] for result in (flat, parts))
    given_names = options.piece_names or ()
    named = len(given_names) == flat.report.pieces
    names, notes = [""] * parts.report.pieces, []
    for number in range(flat.report.pieces):
        own = np.unique(after[before == number]).tolist()
        given = given_names[number] if named else None
        for count, part in enumerate(own):
            names[part] = f"{given} {count + 1}" if len(own) > 1 else str(given)
        if number in split:
            name = given or f"Piece {number + 1}"
            made = ", ".join(names[part] if given else f"Piece {part + 1}" for part in own)
            notes.append(f"{name} {split[number]}: it is split with a seam into {made}.")
    if named:
        options = dataclasses.replace(options, piece_names=names)
    return options, notes


def _neighbours(flat: FlatteningResult) -> Neighbours:
    """For each face those across its edges, with the distance between their centres."""
    centres = flat.model_vertices[flat.faces].mean(axis=1)
    sides: dict[tuple[int, int], int] = {}
    found: Neighbours = [[] for _ in flat.faces]
    for face, corners in enumerate(flat.faces.tolist()):
        for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
            other = sides.pop((end, start), None)
            if other is None:
                sides[start, end] = face
                continue
            distance = float(np.linalg.norm(centres[face] - centres[other]))
            found[face].append((other, distance))
            found[other].append((face, distance))
    return found


def _overlapping_pair(triangles: Array, neighbours: Neighbours, faces: IndexArray) -> tuple[int, int] | None:
    """Two faces that lie on each other in the plane, far from each other on the surface."""
    shrunk = triangles[faces]
    tree = shapely.STRtree(shrunk)
    one, other = tree.query(shrunk, predicate="overlaps")
    contained, containing = tree.query(shrunk, predicate="within")
    one, other = np.append(one, contained), np.append(other, containing)
    chosen = one < other
    one, other = one[chosen], other[chosen]
    areas = shapely.area(shapely.intersection(shrunk[one], shrunk[other]))
    real = areas > 1e-3 * np.minimum(shapely.area(shrunk[one]), shapely.area(shrunk[other]))
    if not real.any():
        return None
    pairs = np.stack([faces[one[real]], faces[other[real]]], axis=1)
    # From any face that is overlapped, the farthest of those on it, then from that one again.
    first = int(pairs[0, 0])
    for _ in range(2):
        distances = _distances(neighbours, faces, first)
        first = int(pairs.ravel()[distances[pairs.ravel()].argmax()])
    partners = np.append(pairs[pairs[:, 0] == first, 1], pairs[pairs[:, 1] == first, 0])
    distances = _distances(neighbours, faces, first)
    return first, int(partners[distances[partners].argmax()])


def _distances(neighbours: Neighbours, faces: IndexArray, start: int) -> Array:
    """Lengths of the shortest ways over the faces from one of them; infinite for others."""
    inside = set(faces.tolist())
    distances = np.full(len(neighbours), np.inf)
    distances[start] = 0.0
    waiting = [(0.0, start)]
    while waiting:
        distance, face = heapq.heappop(waiting)
        if distance > distances[face]:
            continue
        for other, step in neighbours[face]:
            if other in inside and distance + step < distances[other]:
                distances[other] = distance + step
                heapq.heappush(waiting, (distance + step, other))
    return distances
