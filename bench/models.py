# SPDX-License-Identifier: GPL-3.0-or-later
"""Models as arrays, and what is measured of them: shared by the benchmarks of materials."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt
import pymeshlab
from meshlab_developable import measure

FOLDER = Path(__file__).parents[1] / "meshes"
SHEETS = tuple(FOLDER / f"{name}.ply" for name in ("shoe_upper", "short_pants", "dented_shell", "hull_panel"))


def load(path: Path) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int32]]:
    """The vertices and faces of a file, as pymeshlab reads it."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix().copy(), mesh.face_matrix().copy()


def bending_radii(vertices, faces) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Of every vertex the bending radius, and the share of the area: a third of each triangle round it."""
    radii = measure(vertices, faces, map="Bending radius").quality
    x = vertices[faces]
    areas = np.linalg.norm(np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]), axis=1)
    shares = np.bincount(faces.ravel(), np.repeat(areas, 3), len(vertices))
    return radii, shares / shares.sum()
