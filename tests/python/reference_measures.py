# SPDX-License-Identifier: GPL-3.0-or-later
"""Slow, obvious measures in NumPy, written apart from the plugin, that tests compare with."""

from __future__ import annotations

from collections import Counter, defaultdict
from pathlib import Path

import numpy as np


def read_obj(path: Path) -> tuple[np.ndarray, np.ndarray, list[str]]:
    """Positions (n x 3), triangles (m x 3) and, for each triangle, the name of the object that it is in."""
    positions, triangles, names, name = [], [], [], ""
    for line in path.read_text().splitlines():
        key, *rest = line.split()
        if key == "o":
            name = rest[0]
        elif key == "v":
            positions.append([float(x) for x in rest[:3]])
        elif key == "f":
            triangles.append([int(x.split("/")[0]) - 1 for x in rest])
            names.append(name)
    return np.array(positions), np.array(triangles), names


def rim_edges(triangles: np.ndarray) -> list[tuple[int, int]]:
    """Directed edges whose other side has no triangle."""
    edges = {(int(t[i]), int(t[(i + 1) % 3])) for t in triangles for i in range(3)}
    return [(a, b) for a, b in edges if (b, a) not in edges]


def rim_loops(triangles: np.ndarray) -> list[list[int]]:
    """The boundary as closed loops of vertices; every boundary vertex must have one way on."""
    onward = dict(rim_edges(triangles))
    loops = []
    while onward:
        first, vertex = onward.popitem()
        loop = [first]
        while vertex != first:
            loop.append(vertex)
            vertex = onward.pop(vertex)
        loops.append(loop)
    return loops


def corner_angles(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Angle of each corner (m x 3), rad, by the law of cosines."""
    corners = positions[triangles]
    a, b, c = (np.linalg.norm(corners[:, (i + 1) % 3] - corners[:, (i + 2) % 3], axis=1) for i in range(3))
    cosines = [(y * y + z * z - x * x) / (2 * y * z) for x, y, z in ((a, b, c), (b, c, a), (c, a, b))]
    return np.arccos(np.clip(cosines, -1, 1)).T


def triangle_areas(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Area of each triangle."""
    a, b, c = (positions[triangles[:, i]] for i in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def angle_defects(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """2 pi minus the corner angles at each vertex, 0 on the boundary (Eq. 5)."""
    sums = np.zeros(len(positions))
    np.add.at(sums, triangles, corner_angles(positions, triangles))
    defects = 2 * np.pi - sums
    defects[[vertex for edge in rim_edges(triangles) for vertex in edge]] = 0
    return defects


def developability(positions: np.ndarray, triangles: np.ndarray, tolerance: float) -> float:
    """Share of the area that developable points hold (Eq. 2)."""
    held = np.zeros(len(positions))
    np.add.at(held, triangles, (triangle_areas(positions, triangles) / 3)[:, None].repeat(3, axis=1))
    flat = np.abs(angle_defects(positions, triangles)) <= tolerance
    return float(held[flat].sum() / held.sum())


def panels_of(triangles: np.ndarray, names: list[str]) -> dict[str, np.ndarray]:
    """Triangles by the name of their object."""
    groups = defaultdict(list)
    for triangle, name in zip(triangles, names, strict=True):
        groups[name].append(triangle)
    return {name: np.array(group) for name, group in groups.items()}


def euler_characteristic(triangles: np.ndarray) -> int:
    """Vertices minus edges plus faces."""
    edges = Counter(tuple(sorted((int(t[i]), int(t[(i + 1) % 3])))) for t in triangles for i in range(3))
    return len(np.unique(triangles)) - len(edges) + len(triangles)
