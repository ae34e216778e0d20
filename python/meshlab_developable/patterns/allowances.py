# SPDX-License-Identifier: GPL-3.0-or-later
"""Seam allowances: one width all round, or one for each class of edge, with hems that fold back to fit."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
import shapely

from meshlab_developable.mesh_sets import Array
from meshlab_developable.patterns.winding import cells_by_winding

MITRE_LIMIT = 3.0  # of the allowance: sharper corners are cut off at that distance
NARROWEST_OPENING = 1.0  # mm, between allowances, that is cut
_SAME = 1e-6  # mm; lines that are nearer are one
_SPIKE = 3.0  # mm; what is narrower is no allowance
_STEADY = np.radians(20)  # where a boundary turns less, a change of width is a step
_STEEP = 0.35  # the sine of the least angle between a hem and the side beside it


@dataclasses.dataclass(frozen=True)
class Width:
    """An allowance along edges; a hem's ends are such that it fits the piece when it is folded back."""

    width: float  # mm
    folded_back: bool = False
    dart: bool = False  # of a dart's leg, where hems do not end but run across


def widened(sewn: shapely.Polygon, widths: Sequence[Sequence[Width]]) -> tuple[shapely.Polygon, bool]:
    """A piece with its allowance outside, and whether each hole is still open.

    sewn: of the sew lines, the outline to the left and holes to the right. widths: for each ring those of its
    edges; edge i goes from point i to the next. Corners are as the edges' parallels meet.
    """
    used = {width for ring in widths for width in ring}
    if len(used) == 1:
        (only,) = used
        if only.width == 0:
            return sewn, True
        wide = sewn.buffer(only.width, join_style="mitre", mitre_limit=MITRE_LIMIT)
    else:
        rings = [np.array(ring.coords)[:-1] for ring in (sewn.exterior, *sewn.interiors)]
        outer, *inner = [_moved(ring, of_ring) for ring, of_ring in zip(rings, widths, strict=True)]
        wide = shapely.union(outer, sewn).difference(shapely.union_all(inner)) if inner else outer
        # Where widths differ at a sharp corner a spike may be left.
        blunt = wide.buffer(-_SPIKE / 2).buffer(_SPIKE / 2, join_style="mitre", mitre_limit=5)
        wide = shapely.union(shapely.intersection(blunt, wide), sewn)
        wide = max(shapely.get_parts(wide), key=shapely.area)
    openings = [shapely.Polygon(ring) for ring in wide.interiors]
    # Where allowances meet again, as at the mouth of a notch, they may leave an opening that is no hole of
    # the piece, and slivers that no knife could follow.
    kept = [opening for opening in openings if not opening.buffer(-NARROWEST_OPENING / 2).is_empty]
    if len(used) > 1:  # a wide hem across a dart's mouth leaves none in the dart
        least = sewn.buffer(min(width.width for width in used), join_style="mitre", mitre_limit=MITRE_LIMIT)
        real = [shapely.Polygon(ring) for ring in (*least.interiors, *sewn.interiors)]
        kept = [opening for opening in kept if any(other.intersects(opening) for other in real)]
    cut = shapely.Polygon(wide.exterior, [opening.exterior for opening in kept])
    holes = [shapely.Polygon(ring) for ring in sewn.interiors]
    return cut, all(any(hole.intersects(opening) for opening in kept) for hole in holes)


def _moved(ring: Array, widths: Sequence[Width]) -> shapely.Polygon:
    """What a ring goes round when its edges are moved to its right."""
    along = np.roll(ring, -1, axis=0) - ring
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-300)
    normals = np.stack([along[:, 1], -along[:, 0]], axis=1)
    points: list[Array] = []
    for corner in range(len(ring)):
        points += _join(ring[corner], corner, along, normals, widths)
    line = np.array(points)
    cells, windings = cells_by_winding(line)
    outline = shapely.Polygon(ring)
    positive = windings > 0 if outline.exterior.is_ccw else windings < 0
    # Parallels that should meet leave slivers by rounding, which blunting would widen into slits.
    slivers = shapely.area(cells) < _SAME * shapely.length(cells)
    return shapely.union_all(cells[positive | slivers])


def _join(corner: Array, index: int, along: Array, normals: Array, widths: Sequence[Width]) -> list[Array]:
    """Points of the moved line where one edge ends and the next begins."""
    before, after = widths[index - 1], widths[index]
    (one, other), (out, out_after) = (along[index - 1], along[index]), (normals[index - 1], normals[index])
    ends = corner + before.width * out, corner + after.width * out_after
    sine, cosine = one[0] * other[1] - one[1] * other[0], float(one @ other)
    if before == after and cosine > 0:
        return [corner + before.width * (out + out_after) / (1 + cosine)]
    if abs(np.arctan2(sine, cosine)) < _STEADY:
        return list(ends)
    if before.folded_back != after.folded_back and not (before.dart or after.dart):
        hem = before if before.folded_back else after
        hem_along, side_along = (one, -other) if before.folded_back else (-other, one)
        hem_out, side_end = (out, ends[1]) if before.folded_back else (out_after, ends[0])
        folded = _folded_end(corner, hem.width, hem_along, hem_out, side_along, side_end)
        if folded is not None:
            return folded if not before.folded_back else folded[::-1]
    meeting = ends[0] + one * float(_cross(ends[1] - ends[0], other) / sine)
    reach = MITRE_LIMIT * max(before.width, after.width)
    if np.linalg.norm(meeting - corner) <= reach or sine < 0:
        return [meeting] if np.linalg.norm(meeting - corner) <= 10 * reach else list(ends)
    return [ends[0] + one * before.width, ends[1] - other * after.width]


def _folded_end(
    corner: Array, width: float, hem_along: Array, hem_out: Array, side_along: Array, side_end: Array
) -> list[Array] | None:
    """Where the side's cut line meets the line that the hem is folded at, and where it goes from there.

    The hem's end lies on the side's when it is folded back. side_along: towards the hem; side_end: a point of
    the side's cut line. None where the side runs along the hem.
    """
    rise = float(side_along @ hem_out)
    if rise < _STEEP:
        return None
    start = side_end + side_along * float((corner - side_end) @ hem_out) / rise
    mirrored = side_along - 2 * float(side_along @ hem_along) * hem_along
    return [start, start + mirrored * width / rise]


def _cross(one: Array, other: Array) -> float:
    return float(one[0] * other[1] - one[1] * other[0])
