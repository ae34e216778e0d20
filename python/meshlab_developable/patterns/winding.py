# SPDX-License-Identifier: GPL-3.0-or-later
"""How often a line that crosses itself goes round what it encloses."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import shapely

from meshlab_developable.mesh_sets import Array, IndexArray


def cells_by_winding(ring: Array) -> tuple[npt.NDArray[np.object_], IndexArray]:
    """The cells (polygons) that a ring (k x 2) divides the plane into, and how often it goes round each."""
    nodes = shapely.node(shapely.LinearRing(ring))
    cells = shapely.get_parts(shapely.polygonize(shapely.get_parts(nodes)))
    return cells, windings(ring, shapely.get_coordinates(shapely.point_on_surface(cells)))


def windings(ring: Array, places: Array) -> IndexArray:
    """How often a ring goes round each of the places (k x 2), to the left."""
    x, y = np.moveaxis(ring - places[:, None], 2, 0)
    next_x, next_y = np.roll(x, -1, axis=1), np.roll(y, -1, axis=1)
    turns = np.arctan2(x * next_y - y * next_x, x * next_x + y * next_y).sum(axis=1)
    counts: IndexArray = np.rint(turns / (2 * np.pi)).astype(np.int32)
    return counts
