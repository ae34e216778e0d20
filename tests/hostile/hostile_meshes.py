# SPDX-License-Identifier: GPL-3.0-or-later
"""Structured meshes of every kind that filters meet, small: vertices n x 3 and triangles m x 3."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from shapes import Mesh, bump, crumpled_above_flat, cylinder, grid, octahedron, two_bumps


def saddle(columns: int = 11, rows: int = 9) -> Mesh:
    return grid(columns, rows, lambda u, v: (u, v, 0.6 * (u - 0.5) * (v - 0.5)))


def tunnel(columns: int = 11, rows: int = 9) -> Mesh:
    """The instep of a shoe."""
    return grid(
        columns,
        rows,
        lambda u, v: (
            (0.4 + 0.25 * v**2) * np.sin(3 * (u - 0.5)),
            1.2 * v,
            (0.35 + 0.5 * v**2) * np.cos(3 * (u - 0.5)),
        ),
    )


def rough(columns: int = 9, rows: int = 9) -> Mesh:
    """A sheet with noise."""
    positions, triangles = bump(columns, rows)
    return positions + np.random.default_rng(3).normal(0, 0.01, positions.shape), triangles


def band(half_turns: int, around: int = 20, across: int = 3) -> Mesh:
    """Closed round: a tube with a bulge, a Möbius band, a band with a full twist."""
    positions = []
    for row in range(across + 1):
        for column in range(around):
            turn = 2 * np.pi * column / around
            offset = 0.6 * (row / across - 0.5)
            tilt = half_turns * turn / 2
            radius = 1 + offset * np.sin(tilt) + (0.1 * np.cos(4 * offset) if half_turns == 0 else 0)
            positions.append((radius * np.cos(turn), radius * np.sin(turn), offset * np.cos(tilt)))
    triangles = []

    def vertex(column: int, row: int) -> int:
        over = column == around and half_turns % 2 == 1
        return (across - row if over else row) * around + column % around

    for row in range(across):
        for column in range(around):
            a, b = vertex(column, row), vertex(column + 1, row)
            c, d = vertex(column + 1, row + 1), vertex(column, row + 1)
            triangles += [(a, b, c), (a, c, d)]
    return np.array(positions), np.array(triangles)


def annulus() -> Mesh:
    """A sheet with a hill and a hole beside it."""
    positions, triangles = bump(13, 13)
    middle = positions[triangles].mean(axis=1)[:, :2]
    kept, corners = np.unique(
        triangles[np.linalg.norm(middle - (0.7, 0.7), axis=1) > 0.15], return_inverse=True
    )
    return positions[kept], corners.reshape(-1, 3)


def slit() -> Mesh:
    """A cone with a slit, whose sides are sewn by coincidence."""
    spokes, rings = 16, 4
    positions = [(0.0, 0.0, 0.5)]
    for ring in range(1, rings + 1):
        for spoke in range(spokes + 1):
            turn = 2 * np.pi * (spoke % spokes) / spokes
            positions.append(
                (ring * np.cos(turn) / rings, ring * np.sin(turn) / rings, 0.5 - 0.5 * (ring / rings) ** 2)
            )
    triangles = []
    for spoke in range(spokes):
        triangles.append((0, 1 + spoke, 2 + spoke))
        for ring in range(rings - 1):
            a = 1 + ring * (spokes + 1) + spoke
            b = a + spokes + 1
            triangles += [(a, b, b + 1), (a, b + 1, a + 1)]
    return np.array(positions), np.array(triangles)


def book() -> Mesh:
    """Three leaves at one edge."""
    leaf, triangles = grid(5, 5, lambda u, v: (u, v, 0.2 * u * (v - 0.5)))
    leaves = []
    for turn in (0.0, 2.0, 4.0):
        rotation = np.array([[np.cos(turn), 0, -np.sin(turn)], [0, 1, 0], [np.sin(turn), 0, np.cos(turn)]])
        leaves.append(leaf @ rotation.T)
    leaves[1][::5] = leaves[2][::5] = leaves[0][::5]
    return np.vstack(leaves), np.vstack([triangles + 25 * number for number in range(3)])


def hub(spokes: int = 200) -> Mesh:
    """One vertex with many spokes."""
    turns = 2 * np.pi * np.arange(spokes) / spokes
    rim = np.stack([np.cos(turns), np.sin(turns), 0.1 * np.cos(3 * turns)], axis=1)
    around = np.arange(spokes)
    triangles = np.stack([0 * around, 1 + around, 1 + (around + 1) % spokes], axis=1)
    return np.vstack([[(0, 0, 0.3)], rim]), triangles


def thin() -> Mesh:
    """Triangles with angles of half a degree."""
    positions, triangles = saddle(21, 5)
    return positions * (0.05, 2, 1), triangles


def mixed_sides() -> Mesh:
    """Every third face the other way round."""
    positions, triangles = bump()
    triangles[::3] = triangles[::3, ::-1]
    return positions, triangles


def handle() -> Mesh:
    """A torus with a hole."""
    around, across = 12, 8
    positions, triangles = [], []
    for row in range(across):
        for column in range(around):
            u, v = 2 * np.pi * column / around, 2 * np.pi * row / across
            radius = 2 + np.cos(v)
            positions.append((radius * np.cos(u), radius * np.sin(u), np.sin(v)))
            a, b = row * around + column, row * around + (column + 1) % around
            c = (row + 1) % across * around + (column + 1) % around
            triangles += [(a, b, c), (a, c, (row + 1) % across * around + column)]
    return np.array(positions), np.array(triangles[:-2])


def one_triangle() -> Mesh:
    return np.array([(0.0, 0, 0), (1, 0, 0), (0, 1, 0.2)]), np.array([(0, 1, 2)])


def bow_tie() -> Mesh:
    """Two hills that share one vertex."""
    positions, triangles = bump(7, 7)
    beside = positions + np.array([1, 1, positions[-1, 2] - positions[0, 2]])
    joined = triangles + len(positions)
    joined[joined == len(positions)] = len(positions) - 1
    return np.vstack([positions, beside]), np.vstack([triangles, joined])


def leaf_above(mesh: Mesh) -> Mesh:
    """The mesh as one layer of two, the other one flat and some way above it."""
    positions, triangles = mesh
    flat, others = grid(4, 4, lambda u, v: (u, v, 0 * u + positions[:, 2].max() + 1))
    return np.vstack([positions, flat]), np.vstack([triangles, others + len(positions)])


KINDS: dict[str, Callable[[], Mesh]] = {
    "hill": bump,
    "cylinder": cylinder,
    "saddle": saddle,
    "tunnel": tunnel,
    "rough": rough,
    "two hills": two_bumps,
    "tube": lambda: band(0),
    "Möbius band": lambda: band(1),
    "twisted band": lambda: band(2),
    "annulus": annulus,
    "slit cone": slit,
    "book": book,
    "hub": hub,
    "thin": thin,
    "mixed sides": mixed_sides,
    "handle": handle,
    "octahedron": octahedron,
    "one triangle": one_triangle,
    "bow tie": bow_tie,
    "crumpled": crumpled_above_flat,
}
"""Each on its own; `leaf_above` has each below another one."""

# Of these every mesh vertex is one copy, so that angle defects by vertex are those by copy.
SIMPLE = {"hill", "cylinder", "saddle", "tunnel", "rough", "tube", "twisted band", "annulus", "hub", "thin"}
