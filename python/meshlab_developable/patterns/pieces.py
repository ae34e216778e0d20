# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pieces as what a shop cuts: turned to their grain, in millimetres, with an allowance round them."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
import shapely

from meshlab_developable.errors import PatternError
from meshlab_developable.flattening import FlatteningResult
from meshlab_developable.mesh_sets import Array, IndexArray
from meshlab_developable.patterns.options import PatternOptions
from meshlab_developable.patterns.outlines import Outlines
from meshlab_developable.sewing import signed_area

MITRE_LIMIT = 3.0  # of the allowance: sharper corners are cut off at that distance
NARROWEST_OPENING = 1.0  # mm, between allowances, that is cut


@dataclasses.dataclass(frozen=True)
class Piece:
    """One piece. Its box's lower left corner is the origin; the grain runs upright."""

    name: str
    rings: tuple[IndexArray, ...]  # vertices along the outline, to the left, then along holes, to the right
    sewn: shapely.Polygon  # of the sew lines; points in the order of the rings
    cut: shapely.Polygon  # with the allowance


@dataclasses.dataclass(frozen=True)
class Pieces:
    """All pieces, and where the vertices of the flattening are in them."""

    pieces: tuple[Piece, ...]
    positions: Array  # p x 2, mm, of the outlines' points, each in the frame of its own piece
    smooth: bool  # the lines are curves between corners
    notes: tuple[str, ...]  # what a user should know


def make_pieces(flat: FlatteningResult, outlines: Outlines, options: PatternOptions) -> Pieces:
    """Turn and widen the pieces.

    Raises PatternError when one overlaps itself, or is no larger than nothing.
    """
    names = piece_names(flat.report.pieces, options.piece_names)
    positions = outlines.points.copy()
    notes = list(outlines.notes)
    if options.grain is not None:
        positions = _grain_upright(flat, outlines, np.array(options.grain, dtype=np.float64), names, notes)
    pieces = []
    for number, name in enumerate(names):
        rings = _oriented([loop for loop in outlines.loops if outlines.pieces[loop[0]] == number], positions)
        sewn = shapely.Polygon(positions[rings[0]], [positions[ring] for ring in rings[1:]])
        _require_simple(sewn, name)
        cut = _widened(sewn, options.seam_allowance, name, notes)
        corner = np.array(cut.bounds[:2])
        positions[outlines.pieces == number] -= corner
        moved = shapely.transform(shapely.MultiPolygon([sewn, cut]), lambda points, at=corner: points - at)
        pieces.append(Piece(name, rings, *moved.geoms))
    return Pieces(tuple(pieces), positions, outlines.smooth, tuple(notes))


def piece_names(count: int, given: Sequence[str] | None) -> list[str]:
    """The names that are given, or numbers. Raises PatternError when there are not as many as pieces."""
    if given is None:
        return [f"Piece {number + 1}" for number in range(count)]
    if len(given) != count or len(set(given)) != count or not all(given):
        raise PatternError(
            f"{len(given)} names were given for {count} pieces: give each piece a name of its own."
        )
    return list(given)


def _oriented(loops: list[IndexArray], positions: Array) -> tuple[IndexArray, ...]:
    """The outline, which goes to the left, then the holes, which go to the right."""
    areas = [signed_area(positions[loop]) for loop in loops]
    outline = max(range(len(loops)), key=lambda index: abs(areas[index]))
    rings = [loop if (areas[i] > 0) == (i == outline) else loop[::-1] for i, loop in enumerate(loops)]
    return (rings.pop(outline), *rings)


def _require_simple(sewn: shapely.Polygon, name: str) -> None:
    if sewn.area == 0:
        raise PatternError(f"{name} has no area.")
    if not sewn.is_valid:
        raise PatternError(
            f"{name} overlaps itself when it is laid flat, so that it can't be cut from one sheet: make it "
            "developable first, give it seams, or cut it in two."
        )


def _widened(sewn: shapely.Polygon, width: float, name: str, notes: list[str]) -> shapely.Polygon:
    """With the allowance outside, its corners as the edges' parallels meet."""
    if width == 0:
        return sewn
    wide = sewn.buffer(width, join_style="mitre", mitre_limit=MITRE_LIMIT)
    openings = [shapely.Polygon(ring) for ring in wide.interiors]
    # Where allowances meet again, as at the mouth of a notch, they may leave an opening that is no hole of
    # the piece, and slivers that no knife could follow.
    kept = [opening for opening in openings if not opening.buffer(-NARROWEST_OPENING / 2).is_empty]
    cut = shapely.Polygon(wide.exterior, [opening.exterior for opening in kept])
    holes = [shapely.Polygon(ring) for ring in sewn.interiors]
    if not all(any(hole.intersects(opening) for opening in kept) for hole in holes):
        notes.append(f"{name} has a hole that its seam allowance fills: only its sew line is drawn.")
    return cut


def _grain_upright(
    flat: FlatteningResult, outlines: Outlines, grain: Array, names: Sequence[str], notes: list[str]
) -> Array:
    """The points, each piece turned so that the direction on the model runs upright."""
    positions = outlines.points
    corners, model = flat.vertices[flat.faces], flat.model_vertices[flat.faces]
    edges = np.stack([model[:, 1] - model[:, 0], model[:, 2] - model[:, 0]], axis=2)  # m x 3 x 2
    laid = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)  # m x 2 x 2
    # The flattening's derivative takes the direction's part in the surface to the plane.
    directions = np.einsum("mij,mjk,k->mi", laid, np.linalg.pinv(edges), grain / np.linalg.norm(grain))
    areas = abs(np.linalg.det(laid)) / 2
    turned = np.empty_like(positions)
    for number, name in enumerate(names):
        chosen = flat.pieces[flat.faces[:, 0]] == number
        x, y = areas[chosen] @ directions[chosen] / areas[chosen].sum() / _scale(laid, edges)
        size = np.hypot(x, y)
        if size < 0.1:
            notes.append(
                f"{name} lies across the grain direction that was asked for: its longest seam is upright."
            )
            x, y, size = 0.0, 1.0, 1.0
        rotation = np.array([[y, -x], [x, y]]) / size  # takes (x, y) to (0, size)
        inside = outlines.pieces == number
        turned[inside] = positions[inside] @ rotation.T
    return turned


def _scale(laid: Array, edges: Array) -> float:
    return float(np.linalg.norm(laid) / np.linalg.norm(edges))
