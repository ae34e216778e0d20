# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that are mirror images of each other or of themselves, so that cloth can be cut folded."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
import shapely

from meshlab_developable.mesh_sets import Array

ALIKE = 0.5  # mm, by which outlines of the same shape may differ
_SAMPLES = 400  # of an outline


@dataclasses.dataclass(frozen=True)
class Fold:
    """A line that a piece is its own mirror image across."""

    point: Array  # 2
    direction: Array  # 2, of length 1


def find_fold(shape: shapely.Polygon) -> Fold | None:
    """The line of symmetry that is nearest to upright, if there is one."""
    centre, axes = _frame(shape)
    upright = np.array((0.0, 1.0))
    candidates = sorted(
        (*axes, upright, axes[0] + axes[1]), key=lambda axis: -abs(axis[1]) / np.linalg.norm(axis)
    )
    for axis in candidates:
        direction = axis / np.linalg.norm(axis) * (1 if axis[1] >= 0 else -1)
        reflection = 2 * np.outer(direction, direction) - np.eye(2)
        if _alike(shape, _mapped(shape, centre, reflection, centre)):
            return Fold(centre, direction)
    return None


def find_copies(shapes: Sequence[shapely.Polygon]) -> list[tuple[int, bool] | None]:
    """For each shape the first before it that it is a copy of, and whether mirrored; None for the others."""
    found: list[tuple[int, bool] | None] = []
    for number, shape in enumerate(shapes):
        originals = [k for k in range(number) if found[k] is None]
        found.append(
            next((copy for k in originals if (copy := _copy(k, shapes[k], shape)) is not None), None)
        )
    return found


def _copy(number: int, original: shapely.Polygon, shape: shapely.Polygon) -> tuple[int, bool] | None:
    if abs(original.area - shape.area) > ALIKE * original.length:
        return None
    centre, axes = _frame(shape)
    target, own = _frame(original)
    for turn in (axes, (-axes[0], -axes[1]), (axes[0], -axes[1]), (-axes[0], axes[1])):
        turned = np.stack(own, axis=1) @ np.stack(turn, axis=1).T
        if _alike(original, _mapped(shape, centre, turned, target)):
            return number, bool(np.linalg.det(turned) < 0)
    return None


def _frame(shape: shapely.Polygon) -> tuple[Array, tuple[Array, Array]]:
    """The middle of a shape's outline and its main directions."""
    line = shapely.get_coordinates(shape.exterior)
    steps, middles = np.diff(line, axis=0), (line[1:] + line[:-1]) / 2
    weights = np.linalg.norm(steps, axis=1)
    centre = weights @ middles / weights.sum()
    offsets = middles - centre
    spread = (weights[:, None] * offsets).T @ offsets + np.einsum("i,ij,ik->jk", weights, steps, steps) / 12
    _, vectors = np.linalg.eigh(spread)
    return centre, (vectors[:, 0], vectors[:, 1])


def _mapped(shape: shapely.Polygon, centre: Array, matrix: Array, target: Array) -> shapely.Polygon:
    return shapely.transform(shape, lambda points: (points - centre) @ matrix.T + target)


def _alike(one: shapely.Polygon, other: shapely.Polygon) -> bool:
    shares = np.linspace(0, 1, _SAMPLES)
    return all(
        shapely.distance(shapely.line_interpolate_point(line, shares, normalized=True), border).max() <= ALIKE
        for line, border in ((one.exterior, other.boundary), (other.exterior, one.boundary))
    ) and len(one.interiors) == len(other.interiors)
