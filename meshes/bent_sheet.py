# SPDX-License-Identifier: GPL-3.0-or-later
"""A developable bent sheet and, vertex by vertex the same, the shell it becomes when dented."""

from __future__ import annotations

import numpy as np
from shapes import Panels
from triangulation import delaunay

SHEET_RADIUS, SHEET_ARC, SHEET_LENGTH = 9.0, 18.0, 18.0
SHEET_COLUMNS, SHEET_ROWS = 22, 23
DENT_RADIUS, DENT_DEPTH = 9.0, 3.9


def sheet_layout() -> tuple[np.ndarray, np.ndarray]:
    """The sheet before bending. Every vertex lies on one of a set of rulings and no triangle crosses one,
    so that bending along the rulings leaves the mesh itself, not only the smooth surface, developable."""
    random = np.random.RandomState(1)
    step = SHEET_ARC / (SHEET_COLUMNS - 1)
    across = np.linspace(0.0, SHEET_ARC, SHEET_COLUMNS)
    across[1:-1] += step * random.uniform(-0.12, 0.12, SHEET_COLUMNS - 2)
    columns = []
    for x in across:
        along = np.arange(SHEET_ROWS + random.randint(-2, 3) + 1.0)
        along[1:-1] += random.uniform(-0.15, 0.15, len(along) - 2)
        along *= SHEET_LENGTH / along[-1]
        columns.append(np.column_stack([np.full(len(along), x), along]))
    near, far = [c[:1] for c in columns], [c[-1:] for c in reversed(columns)]
    outline = np.concatenate([*near, columns[-1][1:-1], *far, columns[0][-2:0:-1]])
    points = np.concatenate([outline, *(c[1:-1] for c in columns[1:-1])])
    return points, delaunay(points, outline)


def bend(layout: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The sheet on a cylinder, positions and outward normals."""
    angle = (layout[:, 0] - SHEET_ARC / 2) / SHEET_RADIUS
    normals = np.column_stack([np.sin(angle), np.zeros_like(angle), np.cos(angle)])
    axis = np.column_stack([0 * angle, layout[:, 1], 0 * angle])
    return axis + SHEET_RADIUS * normals, normals


def sheet_bent() -> Panels:
    """The sheet before it is dented: every angle defect is 0."""
    layout, triangles = sheet_layout()
    return {"sheet": (bend(layout)[0], triangles)}


def dented_shell() -> Panels:
    """Example I: each vertex pushed inward along the cylinder's normal by a bump with two derivatives."""
    layout, triangles = sheet_layout()
    positions, normals = bend(layout)
    offset = (layout - [SHEET_ARC / 2, SHEET_LENGTH / 2]) / DENT_RADIUS
    depth = DENT_DEPTH * np.maximum(1 - (offset**2).sum(axis=1), 0.0) ** 3
    return {"shell": (positions - depth[:, None] * normals, triangles)}
