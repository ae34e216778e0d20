# SPDX-License-Identifier: GPL-3.0-or-later
"""What filters report of a change of shape, computed again in NumPy, slowly and from the definitions.

`positions` are n x 3, `triangles` m x 3. Measures of one shape are in reference_measures.
"""

from __future__ import annotations

from collections import defaultdict

import numpy as np
from reference_measures import angle_defects, developability, triangle_areas


def shape_measures(positions: np.ndarray, triangles: np.ndarray, tolerance: float = 1e-4) -> dict[str, float]:
    """The four measures of a shape whose patches share no vertex, by the filters' names."""
    defects = angle_defects(positions, triangles)
    return {
        "developability": developability(positions, triangles, tolerance),
        "detect_function": float(np.sum(defects**2)),
        "max_angle_defect": float(np.abs(defects).max()),
        "total_absolute_curvature": float(np.abs(defects).sum()),
    }


def gaussian_curvatures(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Angle defect over a third of the area round each vertex (Eq. 1)."""
    areas = np.zeros(len(positions))
    np.add.at(areas, triangles, (triangle_areas(positions, triangles) / 3)[:, None].repeat(3, axis=1))
    return angle_defects(positions, triangles) / areas


def edges_of(triangles: np.ndarray) -> dict[tuple[int, int], list[int]]:
    """The triangles at each undirected edge."""
    at_edge = defaultdict(list)
    for number, triangle in enumerate(triangles):
        for i in range(3):
            a, b = sorted((int(triangle[i]), int(triangle[(i + 1) % 3])))
            at_edge[a, b].append(number)
    return at_edge


def edge_lengths(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Length of every edge."""
    ends = np.array(list(edges_of(triangles)))
    return np.linalg.norm(positions[ends[:, 0]] - positions[ends[:, 1]], axis=1)


def deformation_energy(original: np.ndarray, positions: np.ndarray, triangles: np.ndarray) -> float:
    """Sum of squared changes of edge lengths (Eq. 7)."""
    return float(np.sum((edge_lengths(positions, triangles) - edge_lengths(original, triangles)) ** 2))


def roughness(positions: np.ndarray, triangles: np.ndarray) -> float:
    """Root mean square angle between neighbouring faces of a mesh that is consistently oriented, rad."""
    a, b, c = (positions[triangles[:, i]] for i in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    pairs = np.array([faces for faces in edges_of(triangles).values() if len(faces) == 2])
    chords = np.linalg.norm(normals[pairs[:, 0]] - normals[pairs[:, 1]], axis=1)
    return float(np.sqrt(np.mean((2 * np.arcsin(chords / 2)) ** 2)))


def distance_to_surface(points: np.ndarray, vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Distance of each point to the nearest point of a surface, every triangle tried: its three edges, and
    its inside where the point lies above it."""
    corners = vertices[triangles]
    least = np.full(len(points), np.inf)
    for number, point in enumerate(points):
        squares = [_squared_to_segments(point, corners[:, i], corners[:, (i + 1) % 3]) for i in range(3)]
        squares.append(_squared_to_insides(point, corners))
        least[number] = np.sqrt(np.min(squares))
    return least


def _squared_to_segments(point: np.ndarray, starts: np.ndarray, ends: np.ndarray) -> np.ndarray:
    along = ends - starts
    share = np.clip(np.sum((point - starts) * along, axis=1) / np.sum(along**2, axis=1), 0, 1)
    return np.sum((starts + share[:, None] * along - point) ** 2, axis=1)


def _squared_to_insides(point: np.ndarray, corners: np.ndarray) -> np.ndarray:
    u, v, w = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0], point - corners[:, 0]
    uu, uv, vv, uw, vw = (np.sum(p * q, axis=1) for p, q in ((u, u), (u, v), (v, v), (u, w), (v, w)))
    s, t = (np.array([vv * uw - uv * vw, uu * vw - uv * uw])) / (uu * vv - uv**2)
    inside = (s >= 0) & (t >= 0) & (s + t <= 1)
    return np.where(inside, np.sum((s[:, None] * u + t[:, None] * v - w) ** 2, axis=1), np.inf)
