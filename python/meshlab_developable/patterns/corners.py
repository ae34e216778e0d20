# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a boundary given by points has true corners, and where it only seems to because it is coarse."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
import shapely

from meshlab_developable.mesh_sets import Array, IndexArray

SHARP = np.radians(50)  # a turn as sharp as this is a corner whatever is beside it
NOTABLE = np.radians(15)  # a lesser turn is none
OUTSTANDING = 1.7  # a turn between the two is a corner when it is so many times those beside it


def find_corners(ring: Array, fixed: Collection[int], tolerance: float) -> set[int]:
    """The points of a closed ring (k x 2) where a smooth line within the tolerance would not do.

    fixed: points that any line passes, such as the ends of seams. A bend of a coarse line has a turn at every
    point, each like those beside it; a corner stands out. Teeth, which turn to one side and the other, are
    corners where they are higher than the tolerance.
    """
    kept = _simplified(ring, fixed, tolerance)
    turns = turning(ring[kept])
    found = set()
    for index, (turn, *others) in enumerate(zip(turns, np.roll(turns, 1), np.roll(turns, -1), strict=True)):
        beside = max(0.0, *(float(np.sign(turn) * other) for other in others))
        if abs(turn) > SHARP or (abs(turn) > NOTABLE and abs(turn) > OUTSTANDING * beside):
            found.add(int(kept[index]))
    return found


def find_teeth(ring: Array, corners: Collection[int], fixed: Collection[int]) -> dict[int, float]:
    """Saw-teeth, and how high they are: corners between two others that turn the other way, each as sharp.

    fixed: points that any line passes; no tolerance takes such a tooth away.
    """
    order = np.array(sorted(corners), dtype=np.int64)
    if len(order) < 4:
        return {}
    points = ring[order]
    turns = turning(points)
    before, after = np.roll(turns, 1), np.roll(turns, -1)
    sharp = np.minimum(abs(turns), np.minimum(abs(before), abs(after))) > 2 * NOTABLE
    teeth = sharp & (turns * before < 0) & (turns * after < 0) & ~np.isin(order, list(fixed))
    chords = np.roll(points, -1, axis=0) - np.roll(points, 1, axis=0)
    offsets = points - np.roll(points, 1, axis=0)
    heights = abs(_cross(chords, offsets)) / np.maximum(np.linalg.norm(chords, axis=1), 1e-300)
    return dict(zip(order[teeth].tolist(), heights[teeth].tolist(), strict=True))


def turning(ring: Array) -> Array:
    """By how much a closed ring turns at each of its points, to the left, radians."""
    incoming, outgoing = ring - np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0) - ring
    turns: Array = np.arctan2(_cross(incoming, outgoing), np.einsum("ij,ij->i", incoming, outgoing))
    return turns


def _cross(one: Array, other: Array) -> Array:
    product: Array = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    return product


def _simplified(ring: Array, fixed: Collection[int], tolerance: float) -> IndexArray:
    """Indices of points, in order, whose lines are within the tolerance of all; the fixed are among them."""
    starts = sorted(fixed)
    if len(starts) < 2:  # the two that are farthest from the middle and from each other
        first = starts[0] if starts else int(np.linalg.norm(ring - ring.mean(axis=0), axis=1).argmax())
        starts = sorted({first, int(np.linalg.norm(ring - ring[first], axis=1).argmax())})
    kept: list[int] = []
    for start, end in zip(starts, [*starts[1:], starts[0] + len(ring)], strict=True):
        indices = np.arange(start, end + 1) % len(ring)
        line = shapely.LineString(ring[indices])
        chosen = shapely.get_coordinates(shapely.simplify(line, tolerance, preserve_topology=False))
        position = 0
        for point in chosen[:-1]:
            while not np.array_equal(ring[indices[position]], point):
                position += 1
            kept.append(int(indices[position]))
    return np.unique(np.array(kept, dtype=np.int32))
