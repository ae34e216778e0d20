# SPDX-License-Identifier: GPL-3.0-or-later
"""Small pictures of meshes, in milliseconds: faces as dense points, from the farthest to the nearest."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from meshlab_developable.mesh_sets import Array, IndexArray

SIZE = 200, 150  # pixels
MARGIN = 6
BACKGROUND, PLAIN = 255, 200.0
MOST_POINTS = 1_000_000


def write_thumbnail(path: Path, mesh: Any) -> None:
    """Draw a mesh of pymeshlab's with its vertex colours, seen from where it is flattest."""
    vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
    colours = mesh.vertex_color_matrix()[:, :3] * 255 if mesh.has_vertex_color() else None
    Image.fromarray(draw(vertices, faces, colours)).save(path)


def draw(vertices: Array, faces: IndexArray, colours: Array | None = None) -> np.ndarray[Any, Any]:
    """The picture as rows of pixels, red, green and blue from 0 to 255."""
    width, height = SIZE
    picture = np.full((height * width, 3), BACKGROUND, dtype=np.uint8)
    if not len(faces) or not np.isfinite(vertices).all():
        return picture.reshape(height, width, 3)
    corners = _on_pixels(vertices)[faces]
    order = np.argsort(corners[:, :, 2].sum(axis=1), kind="stable")  # the nearest face last, which stays
    points = np.matmul(_weights(_steps(corners)), corners[order, :, :2]).astype(np.int32)
    shown = np.full(height * width, -1)
    shown[(points[:, :, 1] * width + points[:, :, 0]).ravel()] = np.repeat(order, points.shape[1])
    paints = np.full((len(faces), 3), PLAIN) if colours is None else colours[faces].mean(axis=1)
    covered = shown >= 0
    picture[covered] = (paints * _shades(corners)[:, None])[shown[covered]]
    return picture.reshape(height, width, 3)


def _on_pixels(vertices: Array) -> Array:
    """Pixel column, pixel row, and nearness to the eye."""
    centred = vertices - vertices.mean(axis=0)
    axes = np.linalg.eigh(centred.T @ centred)[1][:, ::-1]
    for axis in (0, 1):  # one sign for all that look alike
        if axes[np.abs(axes[:, axis]).argmax(), axis] < 0:
            axes[:, axis] *= -1
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    tilt = np.radians(35)
    turned = centred @ axes
    across, along, up = turned.T
    along, up = along * np.cos(tilt) + up * np.sin(tilt), up * np.cos(tilt) - along * np.sin(tilt)
    box = np.array([np.ptp(across), np.ptp(along)])
    room = np.array(SIZE) - 2 * MARGIN - 1
    scale = float(np.min(room / np.maximum(box, 1e-300)))
    seen = np.stack([across, -along, up], axis=1)
    seen -= (seen.min(axis=0) + seen.max(axis=0)) / 2
    return np.asarray(seen * scale + [SIZE[0] / 2, SIZE[1] / 2, 0], dtype=np.float64)


def _shades(corners: Array) -> Array:
    """Of faces: how much light they throw back, whichever side is seen."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    towards = np.abs(normals @ [-0.35, -0.5, 0.79]) / np.where(lengths > 0, lengths, 1)
    return np.asarray(0.45 + 0.55 * np.minimum(towards, 1), dtype=np.float64)


def _steps(corners: Array) -> int:
    """Into how many parts edges must be cut for points to lie dense; fewer where that gets too many."""
    longest = float(np.ptp(corners[:, :, :2], axis=1).max())
    most = int(np.sqrt(2 * MOST_POINTS / len(corners)))
    return max(1, min(int(np.ceil(longest * 1.2)), most))


def _weights(steps: int) -> Array:
    """Barycentric coordinates of points all over a triangle, one below the other."""
    i, j = np.nonzero(np.add.outer(np.arange(steps + 1), np.arange(steps + 1)) <= steps)
    return np.stack([i, j, steps - i - j], axis=1) / steps
