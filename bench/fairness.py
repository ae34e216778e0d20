# SPDX-License-Identifier: GPL-3.0-or-later
"""How fair the panels of a model become: bash bench/run.sh fairness MESH PANELS [RESULT]

PANELS: a file with the panel of each face, one a line; panels are sewn together. RESULT: somebody's result
of the same faces, which may be turned, shifted and scaled.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import numpy.typing as npt
from common import print_head, print_row
from meshlab_developable import make_developable, measure
from models import Array, Faces, load

Panels = npt.NDArray[np.int64]

FAIRNESS = (0.1, 0.17, 0.18, 0.19, 0.2, 0.25)
HEADS = ("", "mean bend, degrees", "99 % below", "mean distance, %", "greatest", "C, rad")


def bends(vertices: Array, faces: Faces, panels: Panels) -> Array:
    """Of all edges within panels, degrees."""
    normals = np.cross(*(vertices[faces[:, k]] - vertices[faces[:, 0]] for k in (1, 2)))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    order = np.lexsort(edges.T)
    first, second = order[:-1], order[1:]
    inner = (edges[first] == edges[second]).all(axis=1) & (panels[first // 3] == panels[second // 3])
    a, b = normals[first[inner] // 3], normals[second[inner] // 3]
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(axis=1)))


def onto(vertices: Array, original: Array) -> Array:
    """Turned, shifted and scaled such that it is as near to the original as can be."""
    middle, goal = vertices.mean(axis=0), original.mean(axis=0)
    u, sizes, v = np.linalg.svd((vertices - middle).T @ (original - goal))
    scale = sizes.sum() / ((vertices - middle) ** 2).sum()
    return scale * (vertices - middle) @ u @ v + goal


def main(path: Path, panels_path: Path, result: Path | None = None) -> None:
    """The original, the result of somebody else, ours."""
    original, faces = load(path)
    panels = np.loadtxt(panels_path, dtype=np.int64)
    diagonal = np.linalg.norm(np.ptp(original, axis=0))

    def show(name: str, vertices: Array) -> None:
        angles = bends(vertices, faces, panels)
        measured = measure(vertices, faces, face_labels=panels, map="Distance", reference=(original, faces))
        distances = 100 * measured.quality / diagonal
        bent = f"{angles.mean():.2f}", f"{np.quantile(angles, 0.99):.1f}"
        far = f"{distances.mean():.3f}", f"{distances.max():.2f}"
        print_row(name, *bent, *far, f"{measured.measures.total_absolute_curvature:.2g}")

    print_head(HEADS)
    show("the original", original)
    if result is not None:
        show(result.stem, onto(load(result)[0], original))
    for fairness in FAIRNESS:
        ours = make_developable(original, faces, face_labels=panels, fairness=fairness)
        show(f"fairness {fairness}, {ours.report.status.name.lower()}", ours.vertices)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
