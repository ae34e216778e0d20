# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed surfaces of soft shapes: tapered limbs that grow into each other, and their even triangulation.

A shape is a *field*, a function of points (n x 3) that is negative inside and nearly a distance close to the
surface. The surface is found on a grid (surface nets: one vertex in every cell that the surface crosses;
Gibson 1998), then its vertices are spread evenly over it.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from triangulation import flip_to_delaunay

Field = Callable[[np.ndarray], np.ndarray]


def limb(begin: list[float], end: list[float], radius: float, end_radius: float | None = None) -> Field:
    """Round a segment, with a radius that changes evenly from one end to the other."""
    start, along = np.array(begin), np.array(end) - np.array(begin)
    growth = (radius if end_radius is None else end_radius) - radius

    def field(points: np.ndarray) -> np.ndarray:
        share = np.clip((points - start) @ along / max(along @ along, 1e-12), 0.0, 1.0)
        return np.linalg.norm(points - start - share[:, None] * along, axis=1) - radius - growth * share

    return field


def cushion(centre: list[float], halves: list[float], tilt: float, rounding: float) -> Field:
    """A box with round edges. Tilt: about the y axis, rad, positive leans the top back to -x."""
    cosine, sine = np.cos(tilt), np.sin(tilt)
    to_own = np.array([[cosine, 0.0, -sine], [0.0, 1.0, 0.0], [sine, 0.0, cosine]])
    inner = np.array(halves) - rounding

    def field(points: np.ndarray) -> np.ndarray:
        beyond = np.abs((points - np.array(centre)) @ to_own) - inner
        outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
        return outside + np.minimum(beyond.max(axis=1), 0.0) - rounding

    return field


def grown_together(fields: list[Field], width: float) -> Field:
    """The union, with fillets of about a width (length) where shapes meet."""

    def field(points: np.ndarray) -> np.ndarray:
        values = np.stack([one(points) for one in fields])
        least = values.min(axis=0)
        return least - width * np.log(np.exp((least - values) / width).sum(axis=0))

    return field


def surface(
    field: Field, low: list[float], high: list[float], spacing: float
) -> tuple[np.ndarray, np.ndarray]:
    """Vertices n x 3 and triangles m x 3, facing out, with edges of about a spacing; the box holds it all."""
    points, quads = surface_nets(field, np.array(low), np.array(high), spacing)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    for _ in range(3):
        points = spread_evenly(field, points, triangles, spacing)
        triangles = flip_to_delaunay(points, triangles)
    return points, triangles


def surface_nets(
    field: Field, low: np.ndarray, high: np.ndarray, spacing: float
) -> tuple[np.ndarray, np.ndarray]:
    """A point in every cell of a grid whose corners lie on both sides, and a quad round every such edge."""
    counts = np.ceil((high - low) / spacing).astype(int) + 1
    corners = np.stack(np.meshgrid(*(np.arange(count) for count in counts), indexing="ij"), axis=-1)
    values = field((low + spacing * corners).reshape(-1, 3)).reshape(counts)
    sums, hits = np.zeros((*counts, 3)), np.zeros(counts)
    edges = []  # lower end, axis, and whether the lower end is inside
    for axis in range(3):
        begin = [slice(None)] * 3
        end = [slice(None)] * 3
        begin[axis], end[axis] = slice(0, -1), slice(1, None)
        first, second = values[tuple(begin)], values[tuple(end)]
        for at in np.argwhere((first < 0) != (second < 0)):
            share = first[tuple(at)] / (first[tuple(at)] - second[tuple(at)])
            crossing = at + share * np.eye(3)[axis]
            for cell in cells_round(at, axis):
                sums[cell] += crossing
                hits[cell] += 1
            edges.append((at, axis, first[tuple(at)] < 0))
    numbers = np.cumsum((hits > 0).ravel()).reshape(counts) - 1
    quads = []
    for at, axis, inside in edges:
        quad = [numbers[cell] for cell in cells_round(at, axis)]
        quads.append(quad if inside else quad[::-1])
    points = low + spacing * sums[hits > 0] / hits[hits > 0][:, None]
    return points, np.array(quads)


def cells_round(at: np.ndarray, axis: int) -> list[tuple[int, ...]]:
    """The four cells that share an edge of the grid, counter-clockwise seen against the axis."""
    u, v = np.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3]]
    return [tuple(int(i) for i in cell) for cell in (at - u - v, at - v, at, at - u)]


def spread_evenly(
    field: Field, points: np.ndarray, triangles: np.ndarray, spacing: float, rounds: int = 25
) -> np.ndarray:
    """Vertices go half the way to the mean of their neighbours, and back to the surface, again and again."""
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    valences = np.bincount(ends[:, 0], minlength=len(points))[:, None]
    for _ in range(rounds):
        sums = np.zeros_like(points)
        np.add.at(sums, ends[:, 0], points[ends[:, 1]])
        points = onto_surface(field, (points + sums / valences) / 2, spacing)
    return points


def onto_surface(field: Field, points: np.ndarray, spacing: float) -> np.ndarray:
    """Newton's method along the gradient, by central differences."""
    step = 1e-4 * spacing
    for _ in range(3):
        gradient = np.column_stack(
            [field(points + step * axis) - field(points - step * axis) for axis in np.eye(3)]
        ) / (2 * step)
        points = points - gradient * (field(points) / (gradient**2).sum(axis=1))[:, None]
    return points
