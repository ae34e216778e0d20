# SPDX-License-Identifier: GPL-3.0-or-later
"""Irregular triangulations of curved sheets: what `make_models.py` builds its panels from.

A sheet is given by its *layout* (a region of the plane, roughly the sheet unrolled) and by a *lift*, the
function that bends the layout into space. All randomness comes from NumPy's frozen legacy generator, so
that the same input gives the same triangles with every version of NumPy.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

Lift = Callable[[np.ndarray], np.ndarray]  # k x 2 to k x 3


def sample_curve(
    curve: Callable[[np.ndarray], np.ndarray], lift: Lift, spacing: float, random: np.random.RandomState
) -> np.ndarray:
    """Points of a curve in the layout, about `spacing` apart in space, both ends kept.

    `curve` takes parameters from 0 to 1 and returns k x 2. Samples between the ends are
    jittered by a tenth of a step.
    """
    fine = np.linspace(0.0, 1.0, 1000)
    steps = np.linalg.norm(np.diff(lift(curve(fine)), axis=0), axis=1)
    arc = np.concatenate([[0.0], np.cumsum(steps)])
    count = max(1, round(arc[-1] / spacing))
    wanted = np.arange(count + 1.0)
    wanted[1:-1] += random.uniform(-0.1, 0.1, count - 1)
    return curve(np.interp(wanted * arc[-1] / count, arc, fine))


def triangulate(
    outline: np.ndarray, lift: Lift, spacing: float, random: np.random.RandomState
) -> tuple[np.ndarray, np.ndarray]:
    """Fill an outline (k x 2, in order, not closed) with triangles of about `spacing`.

    Returns the layout points (the outline's first, in order) and the triangles, counter-clockwise in the
    layout, Delaunay in space.
    """
    inner = scatter(outline, lift, spacing, random)
    points = np.concatenate([outline, inner])
    triangles = delaunay(points, outline)
    return points, flip_to_delaunay(lift(points), triangles)


def scatter(outline: np.ndarray, lift: Lift, spacing: float, random: np.random.RandomState) -> np.ndarray:
    """Random points inside an outline, no two nearer in space than 0.85 `spacing`, no room for another."""
    low, high = outline.min(axis=0), outline.max(axis=0)
    count = int(40 * np.prod(high - low) / spacing**2)
    candidates = low + random.uniform(size=(count, 2)) * (high - low)
    candidates = candidates[is_inside(candidates, outline)]
    positions, border = lift(candidates), lift(outline)
    free = np.array([np.linalg.norm(border - p, axis=1).min() > 0.7 * spacing for p in positions])
    chosen = []
    while free.any():
        pick = int(np.argmax(free))
        chosen.append(pick)
        free &= np.linalg.norm(positions - positions[pick], axis=1) > 0.85 * spacing
    return candidates[chosen]


def is_inside(points: np.ndarray, outline: np.ndarray) -> np.ndarray:
    """Which points (n x 2) lie inside a closed outline, by the even-odd rule."""
    inside = np.zeros(len(points), dtype=bool)
    x, y = points.T
    for (x0, y0), (x1, y1) in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        if y0 != y1:
            inside ^= ((y0 > y) != (y1 > y)) & (x < x0 + (y - y0) / (y1 - y0) * (x1 - x0))
    return inside


def delaunay(points: np.ndarray, outline: np.ndarray) -> np.ndarray:
    """Delaunay triangles (Bowyer and Watson's insertion) of points in the plane, inside an outline.

    Raises ValueError when an edge of the outline, whose points come first, is not an edge of a triangle.
    """
    count = len(points)
    centre, size = points.mean(axis=0), np.ptp(points, axis=0).max()
    far = centre + 1e3 * size * np.array([[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]])
    everything = np.concatenate([points, far])
    triangles = np.array([[count, count + 1, count + 2]])
    circles = circumcircles(everything, triangles)
    for new in range(count):
        hit = ((circles[:, :2] - points[new]) ** 2).sum(axis=1) < circles[:, 2]
        edges = triangles[hit][:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        directed = {tuple(edge) for edge in edges.tolist()}
        rim = np.array([(a, b) for a, b in edges.tolist() if (b, a) not in directed])
        fan = np.column_stack([rim, np.full(len(rim), new)])
        triangles = np.concatenate([triangles[~hit], fan])
        circles = np.concatenate([circles[~hit], circumcircles(everything, fan)])
    triangles = triangles[(triangles < count).all(axis=1)]
    triangles = triangles[is_inside(points[triangles].mean(axis=1), outline)]
    require_edges(triangles, len(outline))
    return triangles


def circumcircles(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Centre (two columns) and squared radius of each triangle's circumcircle."""
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    ab, ac = b - a, c - a
    twice = 2 * (ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0])
    bb, cc = (ab**2).sum(axis=1), (ac**2).sum(axis=1)
    x = (ac[:, 1] * bb - ab[:, 1] * cc) / twice
    y = (ab[:, 0] * cc - ac[:, 0] * bb) / twice
    return np.column_stack([a[:, 0] + x, a[:, 1] + y, x * x + y * y])


def require_edges(triangles: np.ndarray, count: int) -> None:
    """The outline's edges (i, i + 1) must be boundary edges of the triangles."""
    directed = {(t[i], t[(i + 1) % 3]) for t in triangles.tolist() for i in range(3)}
    rim = {(a, b) for a, b in directed if (b, a) not in directed}
    wanted = {(i, (i + 1) % count) for i in range(count)}
    if rim != wanted:
        raise ValueError(f"{len(wanted - rim)} edges of the outline are not in the triangulation")


def flip_to_delaunay(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Flip edges whose two opposite angles in space add up to more than pi, until none is left."""
    triangles = triangles.tolist()
    changed = True
    while changed:
        changed = False
        sides = {
            (t[i], t[(i + 1) % 3]): (f, t[(i + 2) % 3]) for f, t in enumerate(triangles) for i in range(3)
        }
        touched: set[int] = set()
        for (a, b), (left, c) in list(sides.items()):
            if a > b or (b, a) not in sides:
                continue
            right, d = sides[b, a]
            if left in touched or right in touched or (c, d) in sides or (d, c) in sides:
                continue
            if corner_angle(positions, c, a, b) + corner_angle(positions, d, b, a) > np.pi + 1e-9:
                triangles[left], triangles[right] = [c, a, d], [d, b, c]
                touched |= {left, right}
                changed = True
    return np.array(triangles)


def corner_angle(positions: np.ndarray, apex: int, first: int, second: int) -> float:
    """Angle at `apex` between the directions to two other points, rad."""
    u, v = positions[first] - positions[apex], positions[second] - positions[apex]
    return float(np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v))
