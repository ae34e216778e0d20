# SPDX-License-Identifier: GPL-3.0-or-later
"""Half a piece, to be cut on the fold of the cloth."""

from __future__ import annotations

import dataclasses

import numpy as np
import shapely

from meshlab_developable.patterns.drawing import Layer, Path
from meshlab_developable.patterns.pieces import Piece
from meshlab_developable.patterns.symmetry import Fold


def half_of(piece: Piece, fold: Fold) -> Piece:
    """What is to the right of the fold, which is an edge of it."""
    side = _right_side(piece, fold)
    sewn, cut = (
        shapely.orient_polygons(max(shapely.get_parts(shape.intersection(side)), key=shapely.area))
        for shape in (piece.sewn, piece.cut)
    )
    return dataclasses.replace(piece, sewn=sewn, cut=cut)


def fold_lines(piece: Piece, half: Piece, fold: Fold) -> list[Path]:
    """The half's sew lines, which are open at the fold, and the fold."""
    side = _right_side(piece, fold)
    drawn = []
    for ring in (piece.sewn.exterior, *piece.sewn.interiors):
        inside = shapely.line_merge(ring.intersection(side))
        for line in shapely.get_parts(inside):
            points = shapely.get_coordinates(line)
            closed = bool(np.array_equal(points[0], points[-1]))
            drawn.append(Path(Layer.SEW, points[:-1] if closed else points, closed))
    along = (shapely.get_coordinates(half.cut.exterior) - fold.point) @ fold.direction
    off = abs(
        (shapely.get_coordinates(half.cut.exterior) - fold.point) @ (-fold.direction[1], fold.direction[0])
    )
    ends = along[off < 1e-6]
    line = fold.point + np.outer((ends.min(), ends.max()), fold.direction)
    return [*drawn, Path(Layer.MIRROR, line, closed=False)]


def _right_side(piece: Piece, fold: Fold) -> shapely.Polygon:
    reach = 2 * np.ptp(np.reshape(piece.cut.bounds, (2, 2)), axis=0).sum() + 1.0
    along = reach * fold.direction
    right = np.array((along[1], -along[0]))
    corners = fold.point + np.array([-along, along, along + right, right - along])
    return shapely.Polygon(corners)
