# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn on a piece besides its lines: notches and letters along seams, its name, its grain line."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from meshlab_developable.mesh_sets import Array
from meshlab_developable.patterns.allowances import MITRE_LIMIT
from meshlab_developable.patterns.bezier import bezier_curves
from meshlab_developable.patterns.drawing import Drawing, Layer, Notch, Path, Quantity, Text
from meshlab_developable.patterns.folding import fold_lines, half_of
from meshlab_developable.patterns.pieces import Piece, Pieces
from meshlab_developable.patterns.symmetry import Fold
from meshlab_developable.sewing import Seam, ease_of

LETTER_HEIGHT, NAME_HEIGHT = 5.0, 8.0  # mm, on pieces that are large enough
LEAST_HEIGHT = 2.0  # mm, of letters beside a short seam
NOTCH_DEPTH = 4.0  # mm, unless the allowance is narrower
LAST_GAP = 0.6  # from the last notch to the seam's end, of the distance between notches


@dataclasses.dataclass(frozen=True)
class MarkedSeam:
    """A seam with its letter, and where along it notches are."""

    letter: str
    seam: Seam
    lengths: tuple[float, float]  # of both sides, mm
    notches: tuple[tuple[int, float], ...]  # number of the edge along the seam, and share of that edge

    @property
    def ease(self) -> float:
        """By how much one side is longer than the other, as a share of the shorter."""
        return ease_of(self.lengths)


def mark_seams(seams: Sequence[Seam], pieces: Pieces, notch_spacing: float) -> tuple[MarkedSeam, ...]:
    """Letters for seams, and notches where the same point of the model is on both sides.

    Notches are as far apart as the spacing (mm) or a little less, and nearer to one end of the seam, so that
    it fits only one way round. Where the sides differ in length, their mean counts.
    """
    marked = []
    for index, seam in enumerate(seams):
        steps = [np.linalg.norm(np.diff(pieces.positions[side], axis=0), axis=1) for side in seam.sides]
        lengths = float(steps[0].sum()), float(steps[1].sum())
        mean = (steps[0] + steps[1]) / 2
        marked.append(MarkedSeam(letters(index), seam, lengths, tuple(_notches(mean, notch_spacing, seam))))
    return tuple(marked)


def letters(number: int) -> str:
    """A, B, ..., Z, AA, AB, ... for 0, 1, ..."""
    text = ""
    number += 1
    while number:
        number, digit = divmod(number - 1, 26)
        text = chr(ord("A") + digit) + text
    return text


def _notches(steps: Array, spacing: float, seam: Seam) -> Iterator[tuple[int, float]]:
    ends = np.cumsum(steps)
    total = float(ends[-1])
    if spacing == 0 or total < spacing / 5:
        return
    count = max(1, math.ceil(total / spacing - LAST_GAP))
    for distance in np.arange(0 if seam.closed else 1, count + 1) * total / (count + LAST_GAP):
        edge = min(int(np.searchsorted(ends, distance, side="right")), len(steps) - 1)
        yield edge, float((distance - (ends[edge] - steps[edge])) / steps[edge])


def draw_piece(
    number: int,
    pieces: Pieces,
    seams: Sequence[MarkedSeam],
    lines: Sequence[tuple[int, list[int]]],
    seam_allowance: float,
    quantity: Quantity = Quantity(),  # noqa: B008 - never changed
    fold: Fold | None = None,
) -> Drawing:
    """A piece with all its lines and marks, in its own frame; with a fold, the half to the right of it."""
    whole = pieces.pieces[number]
    piece = whole if fold is None else half_of(whole, fold)
    paths = [_ring(Layer.BOUNDARY, piece.cut.exterior, pieces.smooth)]
    paths += [_ring(Layer.CUTOUT, ring, pieces.smooth) for ring in piece.cut.interiors]
    if fold is None:
        rings = (piece.sewn.exterior, *piece.sewn.interiors)
        paths += [_ring(Layer.SEW, ring, pieces.smooth) for ring in rings]
    else:
        paths += fold_lines(whole, piece, fold)
    paths += [
        Path(Layer.INTERNAL, pieces.positions[line], False) for piece_, line in lines if piece_ == number
    ]
    room = shapely.maximum_inscribed_circle(piece.sewn, tolerance=_size(piece) / 200)
    centre, radius = np.array(room.coords[0]), room.length
    paths.append(_grain_line(piece, centre, radius))
    name = _name(piece, centre, radius)
    texts = [name, Text(str(quantity), name.centre - (0, 1.6 * name.height), 0.6 * name.height)]
    notches: list[Notch] = []
    shapely.prepare(whole.sewn)
    height = min(LETTER_HEIGHT, 0.3 * radius)
    for marked in seams:
        for side in (0, 1):
            if marked.seam.pieces[side] != number:
                continue
            along = pieces.positions[marked.seam.sides[side]]
            letter = _letter(marked, whole, along, side, height)
            depth = min(NOTCH_DEPTH, 0.2 * radius, seam_allowance or np.inf)
            on_side = [
                _notch(whole, along, edge, share, depth, seam_allowance) for edge, share in marked.notches
            ]
            texts += [letter] if fold is None or piece.cut.covers(shapely.Point(letter.centre)) else []
            notches += [
                n for n in on_side if fold is None or piece.cut.distance(shapely.Point(n.on_seam)) < 1e-6
            ]
    return Drawing(piece.name, paths, notches, texts, quantity)


def _ring(layer: Layer, ring: shapely.LinearRing, smooth: bool) -> Path:
    points = np.array(ring.coords)[:-1]
    return Path(layer, points, curves=bezier_curves(points) if smooth else ())


def _size(piece: Piece) -> float:
    left, low, right, high = piece.sewn.bounds
    return float(max(right - left, high - low))


def _name(piece: Piece, centre: Array, radius: float) -> Text:
    height = min(NAME_HEIGHT, 1.8 * radius / max(len(piece.name), 3))
    return Text(piece.name, centre, height)


def _grain_line(piece: Piece, centre: Array, radius: float) -> Path:
    """An upright line through the widest part, beside the name, with an arrowhead at its top."""
    x = centre[0] - 0.75 * radius
    low, high = centre[1] - 0.6 * radius, centre[1] + 0.6 * radius
    head = min(4.0, 0.2 * radius)
    points = [
        (x, low),
        (x, high),
        (x - head / 3, high - head),
        (x, high),
        (x + head / 3, high - head),
    ]
    return Path(Layer.GRAIN, np.array(points), closed=False)


def _outward(piece: Piece, along: Array, edge: int) -> Array:
    """The unit normal of an edge of the sew line that points out of the piece."""
    x, y = along[edge + 1] - along[edge]
    normal: Array = np.array((y, -x)) / np.hypot(x, y)
    middle = (along[edge] + along[edge + 1]) / 2
    inside = shapely.contains_xy(piece.sewn, *(middle + 1e-6 * np.hypot(x, y) * normal))
    return -normal if inside else normal


def _letter(marked: MarkedSeam, piece: Piece, along: Array, side: int, height: float) -> Text:
    steps = np.linalg.norm(np.diff(along, axis=0), axis=1)
    edge = int(np.searchsorted(np.cumsum(steps), steps.sum() / 2))
    middle = (along[edge] + along[edge + 1]) / 2
    # Beside a short dart, not on the letter of the next, but legible.
    height = min(height, max(LEAST_HEIGHT, 0.3 * float(steps.sum())))
    return Text(marked.letter, middle - 1.1 * height * _outward(piece, along, edge), height)


def _notch(piece: Piece, along: Array, edge: int, share: float, depth: float, allowance: float) -> Notch:
    """A notch in the cut line; on the sew line where the cut line is elsewhere, as inside a narrow dart."""
    on_seam = (1 - share) * along[edge] + share * along[edge + 1]
    outward = _outward(piece, along, edge)
    on_boundary = on_seam
    reach = shapely.LineString([on_seam, on_seam + outward * MITRE_LIMIT * allowance])
    crossing = reach.intersection(piece.cut.boundary)
    if allowance > 0 and not crossing.is_empty:
        on_boundary = np.array(shapely.shortest_line(shapely.Point(on_seam), crossing).coords[-1])
    return Notch(on_boundary, on_seam, on_boundary - outward * depth)
