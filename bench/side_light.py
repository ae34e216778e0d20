# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes before and after Global Developability in strong side light, where ruffles and kinked borders show.
The verdict is the title of the second.

`bash bench/run.sh side_light FOLDER MESH...` writes FOLDER/MESH.png for each.
"""

from __future__ import annotations

import sys
from pathlib import Path

import meshlab_developable
import numpy as np
import pymeshlab
from meshlab_developable.rendering import Array, IndexArray, Picture, View, render

ELEVATION = np.radians(20)  # of the light above the mean plane
DARKEST = 0.08


def shades(vertices: Array, faces: IndexArray, light: Array) -> Array:
    """Grey of each face, m x 3: Lambert's law, lit from both sides."""
    corners = vertices[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    grey = DARKEST + (1 - DARKEST) * np.abs(normals @ light)
    return np.repeat(grey[:, None], 3, axis=1)


def side_view(vertices: Array) -> tuple[View, Array]:
    """Across the longest axis, from above the mean plane; the light runs along that axis, low."""
    longest, second, least = np.linalg.svd(vertices - vertices.mean(axis=0), full_matrices=False)[2]
    least = least if least[np.abs(least).argmax()] > 0 else -least
    eye = 1.6 * least - second
    light = np.cos(ELEVATION) * longest + np.sin(ELEVATION) * least
    return View(eye=(eye[0], eye[1], eye[2]), up=(least[0], least[1], least[2])), light


def picture_of(source: Path, target: Path) -> None:
    """Render a mesh before and after."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(source))
    before = meshes.current_mesh().vertex_matrix()
    faces = meshes.current_mesh().face_matrix()
    developed = meshlab_developable.make_developable(before, faces)
    verdict = developed.report.status.name.lower().replace("_", " ")
    view, light = side_view(before)
    render(
        target,
        [
            Picture(title, vertices, faces, shades(vertices, faces, light))
            for title, vertices in (("before", before), (verdict, developed.vertices))
        ],
        None,
        view,
    )


def main() -> None:
    """Write all pictures."""
    if len(sys.argv) < 3:
        sys.exit("usage: bash bench/run.sh side_light FOLDER MESH...")
    meshlab_developable.load()
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[2:]:
        picture_of(Path(name), folder / f"{Path(name).stem}.png")


if __name__ == "__main__":
    main()
