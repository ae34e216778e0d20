# SPDX-License-Identifier: GPL-3.0-or-later
"""Small meshes that tests of the filters work on: positions n x 3 and triangles m x 3."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

Mesh = tuple[np.ndarray, np.ndarray]


def grid(columns: int, rows: int, surface: Callable[[np.ndarray, np.ndarray], tuple]) -> Mesh:
    """A grid of columns x rows vertices over the unit square, its diagonals in turn, mapped by a surface."""
    v, u = np.meshgrid(np.linspace(0, 1, rows), np.linspace(0, 1, columns), indexing="ij")
    positions = np.stack(np.broadcast_arrays(*surface(u.ravel(), v.ravel())), axis=1).astype(float)
    triangles = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            a, b, c, d = (row * columns + column + step for step in (0, 1, columns + 1, columns))
            triangles += [(a, b, d), (b, c, d)] if (row + column) % 2 else [(a, b, c), (a, c, d)]
    return positions, np.array(triangles)


def bump(columns: int = 13, rows: int = 11) -> Mesh:
    """A flat sheet with a hill: positive curvature on top, negative round it."""
    return grid(
        columns, rows, lambda u, v: (u, v, 0.15 * np.exp(-12 * ((u - 0.45) ** 2 + (v - 0.5) ** 2)) + 0.05 * u)
    )


def cylinder(columns: int = 9, rows: int = 7) -> Mesh:
    """A bent sheet, developable as it is."""
    return grid(columns, rows, lambda u, v: (np.cos(2 * u), np.sin(2 * u), v))


def two_bumps(gap: float = 0.0) -> Mesh:
    """Two sheets, each with a hill, side by side along an edge; their seam vertices are apart by the gap."""
    positions, triangles = bump()
    beside = positions * (-1, 1, 1) - (gap, 0, 0)
    return np.vstack([positions, beside]), np.vstack([triangles, triangles[:, ::-1] + len(positions)])


def crumpled_above_flat() -> Mesh:
    """A crumpled sheet just above a flat one, in one mesh."""
    random = np.random.default_rng(5)
    crumpled, upper = grid(13, 13, lambda u, v: (u, v, 0.005 + 0.05 * random.random(np.shape(u))))
    flat, lower = grid(12, 12, lambda u, v: (u, v, 0 * u))
    return np.vstack([crumpled, flat]), np.vstack([upper, lower + len(crumpled)])


def octahedron() -> Mesh:
    """A closed surface."""
    positions = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], dtype=float)
    triangles = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    return positions, np.array(triangles)
