# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pieces as what a shop cuts: turned to their grain, in millimetres, with an allowance round them."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Sequence

import numpy as np
import shapely

from meshlab_developable.errors import PatternError
from meshlab_developable.flattening import FlatteningResult
from meshlab_developable.mesh_sets import Array, IndexArray
from meshlab_developable.patterns.allowances import Width, widened
from meshlab_developable.patterns.options import EDGES, PatternOptions
from meshlab_developable.patterns.outlines import Outlines
from meshlab_developable.sewing import Seam, signed_area


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
    grain = options.grain or model_up(flat.model_vertices)
    across = _grain_upright(flat, outlines, positions, np.array(grain, dtype=np.float64))
    if options.grain is not None:
        notes += [
            f"{names[number]} lies across the grain direction that was asked for: its longest seam "
            "is upright."
            for number in across
        ]
    unknown = sorted(set(options.piece_allowances) - set(names))
    if unknown:
        raise PatternError(
            f"there is no piece {', '.join(unknown)} to have an allowance; there are {', '.join(names)}."
        )
    sewn_edges = _sewn_edges(outlines.seams)
    pieces = []
    for number, name in enumerate(names):
        rings = _oriented([loop for loop in outlines.loops if outlines.pieces[loop[0]] == number], positions)
        sewn = shapely.Polygon(positions[rings[0]], [positions[ring] for ring in rings[1:]])
        _require_simple(sewn, name)
        cut, open_holes = widened(sewn, [_widths(name, ring, sewn_edges, options) for ring in rings])
        if not open_holes:
            notes.append(f"{name} has a hole that its seam allowance fills: only its sew line is drawn.")
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


def _widths(
    name: str, ring: IndexArray, sewn: dict[tuple[int, int], bool], options: PatternOptions
) -> list[Width]:
    """The allowance along each edge of a ring. Hems fold back to fit where they have a width of their own."""
    seam, hem = (options.allowance(name, edge) for edge in EDGES)
    after = np.roll(ring, -1).tolist()
    return [
        Width(seam)
        if seam == hem
        else Width(seam, dart=sewn[pair])
        if (pair := (min(edge), max(edge))) in sewn
        else Width(hem, folded_back=True)
        for edge in zip(ring.tolist(), after, strict=True)
    ]


def _sewn_edges(seams: Sequence[Seam]) -> dict[tuple[int, int], bool]:
    """The edges of all seams, and whether each is of a dart, whose legs meet at its tip."""
    return {
        (min(edge), max(edge)): any(seam.sides[0][end] == seam.sides[1][end] for end in (0, -1))
        for seam in seams
        for side in seam.sides
        for edge in itertools.pairwise(side.tolist())
    }


def model_up(places: Array) -> tuple[float, float, float]:
    """What is up on a model (p x 3), which does not say so: the longer of its y and z; files use both."""
    _, tall, deep = np.ptp(places, axis=0)
    return (0.0, 1.0, 0.0) if tall > deep else (0.0, 0.0, 1.0)


def _grain_upright(flat: FlatteningResult, outlines: Outlines, positions: Array, grain: Array) -> list[int]:
    """Turn each piece so that a direction on the model runs upright; those that lie across it are not."""
    corners, model = flat.vertices[flat.faces], flat.model_vertices[flat.faces]
    edges = np.stack([model[:, 1] - model[:, 0], model[:, 2] - model[:, 0]], axis=2)  # m x 3 x 2
    laid = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)  # m x 2 x 2
    # The flattening's derivative takes the direction's part in the surface to the plane.
    directions = np.einsum("mij,mjk,k->mi", laid, np.linalg.pinv(edges), grain / np.linalg.norm(grain))
    areas = abs(np.linalg.det(laid)) / 2
    across = []
    for number in range(flat.report.pieces):
        chosen = flat.pieces[flat.faces[:, 0]] == number
        x, y = areas[chosen] @ directions[chosen] / areas[chosen].sum() / _scale(laid, edges)
        size = np.hypot(x, y)
        if size < 0.1:
            across.append(number)
            continue
        rotation = np.array([[y, -x], [x, y]]) / size  # takes (x, y) to (0, size)
        inside = outlines.pieces == number
        positions[inside] = outlines.points[inside] @ rotation.T
    return across


def _scale(laid: Array, edges: Array) -> float:
    return float(np.linalg.norm(laid) / np.linalg.norm(edges))
