# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of polygons, files of them, and what a constrained Delaunay triangulation is by its definition."""

from __future__ import annotations

from pathlib import Path

import numpy as np

TRIANGULATE = "meshing_polygons_to_constrained_delaunay"

Loop = tuple[int, ...]
PolygonMesh = tuple[np.ndarray, list[Loop]]


def polygon(*corners: tuple[float, ...]) -> PolygonMesh:
    """One polygon; corners of two coordinates lie in the plane z = 0."""
    points = np.array([(*corner, 0.0)[:3] for corner in corners], dtype=float)
    return points, [tuple(range(len(points)))]


def kite() -> PolygonMesh:
    """A quad that every host splits along the long diagonal, where Delaunay takes the short one."""
    return polygon((-2, 0), (0, -1), (2, 0), (0, 1))


def comb(teeth: int = 5) -> PolygonMesh:
    corners = [(teeth / 2, 0.0), (float(teeth), 1.0)]
    for tooth in range(teeth - 1, -1, -1):
        corners += [(tooth + 0.7, 8.0), (tooth + 0.4, 1.0), (float(tooth), 1.0)]
    return polygon(*corners)


def letter() -> PolygonMesh:
    """An L whose fan from the first corner is not Delaunay."""
    return polygon((3, 0), (6, 0), (6, 1), (4, 1), (4, 4), (3, 4))


def with_midpoints() -> PolygonMesh:
    """A square with corners that lie on its sides."""
    return polygon((0, 0), (1, 0), (2.25, 0), (2.25, 2), (1.25, 2), (0, 2))


def star(corners: int = 100, seed: int = 3) -> PolygonMesh:
    """A jagged round polygon."""
    radii = 0.3 + np.random.default_rng(seed).random(corners)
    angles = 2 * np.pi * np.arange(corners) / corners
    return polygon(*zip((radii * np.cos(angles)).tolist(), (radii * np.sin(angles)).tolist(), strict=True))


def bow_tie() -> PolygonMesh:
    """A quad that crosses itself."""
    return polygon((0, 0), (1, 1), (1, 0), (0, 1))


def kite_and_bow_tie() -> PolygonMesh:
    (points, loops), (more, _) = kite(), bow_tie()
    return np.vstack([points, more + np.array([5, 0, 0])]), [*loops, (4, 5, 6, 7)]


def sheet_of_quads(columns: int = 7, rows: int = 5, seed: int = 1) -> PolygonMesh:
    """A jittered grid of quads, curved, so that no quad is plane."""
    v, u = np.meshgrid(np.arange(rows, dtype=float), np.arange(columns, dtype=float), indexing="ij")
    points = np.stack([u.ravel(), v.ravel(), 0.05 * (u - 2).ravel() * v.ravel()], axis=1)
    points[:, :2] += np.random.default_rng(seed).uniform(-0.3, 0.3, (len(points), 2))
    corners = [row * columns + column for row in range(rows - 1) for column in range(columns - 1)]
    return points, [(a, a + 1, a + 1 + columns, a + columns) for a in corners]


def _in_single_precision(points: np.ndarray) -> list[str]:
    """Numbers that hosts of either precision read as the same."""
    return [" ".join(f"{number:.9g}" for number in point) for point in points.astype(np.float32)]


def write_obj(path: Path, mesh: PolygonMesh, texture: bool = False) -> Path:
    """With texture coordinates each corner of each polygon has its own."""
    points, loops = mesh
    lines = [f"v {numbers}" for numbers in _in_single_precision(points)]
    corners = [(face, vertex) for face, loop in enumerate(loops) for vertex in loop]
    if texture:
        lines += [
            f"vt {texture_of(face, vertex)[0]} {texture_of(face, vertex)[1]}" for face, vertex in corners
        ]
    start = 0
    for loop in loops:
        names = [f"{v + 1}/{start + i + 1}" if texture else f"{v + 1}" for i, v in enumerate(loop)]
        lines.append("f " + " ".join(names))
        start += len(loop)
    path.write_text("\n".join(lines) + "\n")
    return path


def texture_of(face: int, vertex: int) -> tuple[float, float]:
    return face / 64, vertex / 256


def write_ply(path: Path, mesh: PolygonMesh) -> Path:
    """Polygons in colours that say their number."""
    points, loops = mesh
    header = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
    header += [f"property float {axis}" for axis in "xyz"]
    header += [
        "property float quality",
        f"element face {len(loops)}",
        "property list uchar int vertex_indices",
    ]
    header += [f"property uchar {colour}" for colour in ("red", "green", "blue", "alpha")]
    lines = [f"{numbers} {i}" for i, numbers in enumerate(_in_single_precision(points))]
    lines += [f"{len(loop)} {' '.join(map(str, loop))} {face} 0 7 255" for face, loop in enumerate(loops)]
    path.write_text("\n".join([*header, "end_header", *lines]) + "\n")
    return path


def from_smallest(loop) -> Loop:
    """The same loop from its smallest number on."""
    numbers = [int(number) for number in loop]
    start = numbers.index(min(numbers))
    return tuple(numbers[start:] + numbers[:start])


def triangles_in(triangles: np.ndarray, loop: Loop) -> np.ndarray:
    """The triangles whose corners all belong to a polygon that shares at most two corners with any other."""
    return triangles[np.isin(triangles, loop).all(axis=1)]


def expect_constrained_delaunay(points: np.ndarray, loop: Loop, triangles: np.ndarray) -> None:
    """The triangles fill the polygon, and no corner in the circumcircle of one is seen from within it."""
    flat = _in_least_squares_plane(points[list(loop)])
    place = {vertex: i for i, vertex in enumerate(loop)}
    local = [[place[int(vertex)] for vertex in triangle] for triangle in triangles]
    assert len(local) == len(loop) - 2
    assert all(_area(*flat[t]) > 0 for t in local)
    assert np.isclose(sum(_area(*flat[t]) for t in local), _polygon_area(flat), rtol=1e-9)
    for triangle in local:
        for corner in set(range(len(flat))) - set(triangle):
            if _in_circumcircle(flat[triangle], flat[corner]):
                for weights in ((1, 1, 1), (8, 1, 1), (1, 8, 1), (1, 1, 8)):
                    within = np.average(flat[triangle], axis=0, weights=weights)
                    assert not _sees(flat, within, corner), (triangle, corner)


def _in_least_squares_plane(contour: np.ndarray) -> np.ndarray:
    centred = contour - contour.mean(axis=0)
    flat = centred @ np.linalg.svd(centred)[2][:2].T
    return flat if _polygon_area(flat) > 0 else flat * (1, -1)


def _cross(a: np.ndarray, b: np.ndarray) -> float:
    return a[0] * b[1] - a[1] * b[0]


def _area(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> float:
    return _cross(b - a, c - a) / 2


def _polygon_area(flat: np.ndarray) -> float:
    return sum(_cross(a, b) for a, b in zip(flat, np.roll(flat, -1, axis=0), strict=True)) / 2


def _in_circumcircle(triangle: np.ndarray, point: np.ndarray) -> bool:
    offsets = triangle - point
    rows = np.column_stack([offsets, (offsets**2).sum(axis=1)])
    return np.linalg.det(rows) > 1e-6 * np.abs(rows).max() ** 2


def _sees(flat: np.ndarray, start: np.ndarray, corner: int) -> bool:
    end = flat[corner]
    for i in range(len(flat)):
        a, b = flat[i], flat[(i + 1) % len(flat)]
        if corner in (i, (i + 1) % len(flat)):
            continue
        if _area(start, end, a) * _area(start, end, b) <= 0 and _area(a, b, start) * _area(a, b, end) <= 0:
            return False
    return True
