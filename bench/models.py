# SPDX-License-Identifier: GPL-3.0-or-later
"""Models as arrays, and what is measured of them: shared by several benchmarks."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pymeshlab
from meshlab_developable import measure

FOLDER = Path(__file__).parents[1] / "meshes"
SHEETS = tuple(FOLDER / f"{name}.ply" for name in ("shoe_upper", "short_pants", "dented_shell", "hull_panel"))

Array = npt.NDArray[np.float64]
Faces = npt.NDArray[np.int32]


def grid(
    columns: int, height: Callable[[Array, Array], Array], alternating: bool = False
) -> tuple[Array, Faces]:
    """A height field over the unit square, of so many vertices along each side.

    Diagonals run from the least u and v of each square, or alternate.
    """
    u, v = np.meshgrid(np.linspace(0, 1, columns), np.linspace(0, 1, columns))
    index = np.arange(columns**2, dtype=np.int32).reshape(columns, columns)
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    turned = alternating & (np.indices(a.shape).sum(axis=0) % 2 == 1)[..., None]
    first = np.where(turned, np.stack([a, b, d], -1), np.stack([a, b, c], -1))
    second = np.where(turned, np.stack([b, c, d], -1), np.stack([a, c, d], -1))
    return np.stack([u, v, height(u, v)], -1).reshape(-1, 3), np.concatenate([first, second]).reshape(-1, 3)


def load(path: Path) -> tuple[Array, Faces]:
    """The vertices and faces of a file, as pymeshlab reads it."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix().copy(), mesh.face_matrix().copy()


def bending_radii(vertices: Array, faces: Faces) -> tuple[Array, Array]:
    """Of every vertex the bending radius, and the share of the area: a third of each triangle round it."""
    radii = measure(vertices, faces, map="Bending radius").quality
    x = vertices[faces]
    areas = np.linalg.norm(np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]), axis=1)
    shares = np.bincount(faces.ravel(), np.repeat(areas, 3), len(vertices))
    return radii, shares / shares.sum()
