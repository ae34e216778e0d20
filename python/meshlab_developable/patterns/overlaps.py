# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that overlap themselves when they are laid flat: where, how much, and what can be done about it."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import shapely

from meshlab_developable.errors import PatternError
from meshlab_developable.flattening import FlatteningResult
from meshlab_developable.mesh_sets import Array, IndexArray
from meshlab_developable.patterns.outlines import Outlines, exact_outlines
from meshlab_developable.patterns.winding import cells_by_winding, windings
from meshlab_developable.sewing import signed_area

NARROW = 6.0  # mm; a wider overlap is not shared between the two sides
_GAP = 0.02  # mm, that is left between them
_ROUNDS = 40
_ROUNDING = 1e-9  # mm; what is no wider than that only touches


@dataclasses.dataclass(frozen=True)
class Overlap:
    """The widest place where a piece lies on itself."""

    width: float  # mm
    place: Array  # 3, on the model

    def __str__(self) -> str:
        place = ", ".join(f"{x:.4g}" for x in self.place)
        return f"overlaps itself by {self.width:.3g} mm when it is laid flat, at ({place}) of the model"


def find_overlap(flat: FlatteningResult, number: int, ring: Array, millimetres: float) -> Overlap | None:
    """Where the outline of a piece goes round a place twice, if it does.

    ring: k x 2, mm, in the flattening's frame.
    """
    cells, turns = cells_by_winding(ring)
    cells = cells[abs(turns) > 1]
    if not len(cells):
        return None
    circles = shapely.maximum_inscribed_circle(cells)
    widest = int(shapely.length(circles).argmax())
    if 2 * float(circles[widest].length) < _ROUNDING:
        return None
    centre = shapely.get_coordinates(circles[widest])[0]
    inside = np.flatnonzero(flat.pieces == number)
    nearest = inside[np.linalg.norm(millimetres * flat.vertices[inside] - centre, axis=1).argmin()]
    return Overlap(2 * float(circles[widest].length), flat.model_vertices[nearest])


def wide_overlaps(flat: FlatteningResult, millimetres: float) -> dict[int, Overlap]:
    """The pieces, by number, that overlap themselves too widely for `share_overlaps`."""
    lines = exact_outlines(flat, millimetres)
    found = {}
    for number in range(flat.report.pieces):
        loops = [loop for loop in flat.loops if flat.pieces[loop[0]] == number]
        outline = max(loops, key=lambda loop: abs(signed_area(lines.points[loop])))
        if shapely.Polygon(lines.points[outline]).is_valid:
            continue
        overlap = find_overlap(flat, number, lines.points[outline], millimetres)
        if overlap is not None and (overlap.width > NARROW or _shared(lines, lines.points, outline) is None):
            found[number] = overlap
    return found


def share_overlaps(
    flat: FlatteningResult, outlines: Outlines, names: Sequence[str], millimetres: float
) -> Outlines:
    """The outlines, with the line between the two sides in place of both where they overlap a little.

    Sides of a slit that only touch are parted by next to nothing.
    Raises PatternError for wider overlaps, saying where.
    """
    points, notes = outlines.points.copy(), list(outlines.notes)
    for number, name in enumerate(names):
        loops = [loop for loop in outlines.loops if outlines.pieces[loop[0]] == number]
        outline = max(loops, key=lambda loop: abs(signed_area(points[loop])))
        if shapely.Polygon(points[outline]).is_valid:
            continue
        found = find_overlap(flat, number, points[outline], millimetres)
        if found is None:
            points[outline] = _parted(points[outline], _mates(outlines, outline))
            continue
        shared = _shared(outlines, points, outline) if found.width <= NARROW else None
        if shared is None:
            raise PatternError(
                f"{name} {found}: cut the panel in two there, or give it a dart that begins there, so "
                "that its parts lie side by side."
            )
        points[outline] = shared
        notes.append(f"{name} {found}: it is cut in the middle between the two sides.")
    return dataclasses.replace(outlines, points=points, notes=tuple(notes))


def _shared(outlines: Outlines, points: Array, outline: IndexArray) -> Array | None:
    """The points of an outline, moved to the middle where it overlaps; none when that does not help."""
    ring = points[outline].copy()
    mates = _mates(outlines, outline)
    way = 0.5  # to the middle; later all that is left of it, where only one side has a point
    for _ in range(_ROUNDS):
        if shapely.Polygon(ring).is_valid:
            return ring
        over = _lying_over(ring) | _beside_crossings(ring)
        over = over | ((mates >= 0) & over[mates])  # seams stay equally long when both sides move
        if not over.any():
            return None
        moved = ring.copy()
        for index in np.flatnonzero(over):
            other = ring[mates[index]] if mates[index] >= 0 else _opposite(ring, over, int(index))
            if other is None:
                continue
            gap = other - ring[index]
            size = float(np.linalg.norm(gap))
            moved[index] += gap * (way + _GAP / 2 / size if size > _GAP else 1.0)
        ring, way = moved, 1.0
    return None


def _parted(ring: Array, mates: IndexArray) -> Array:
    """The points of an outline, moved inwards where they lie on those that they are sewn to."""
    touching = (mates >= 0) & (np.linalg.norm(ring[mates] - ring, axis=1) < _GAP)
    inward = _inward(ring)
    sizes = np.linalg.norm(inward, axis=1, keepdims=True)
    parted: Array = np.where(touching[:, None], ring + _GAP / 2 * inward / np.maximum(sizes, 1e-9), ring)
    return parted


def _inward(ring: Array) -> Array:
    """At each point of a ring twice the mean of its edges' normals to its inside."""
    after, before = np.roll(ring, -1, axis=0) - ring, ring - np.roll(ring, 1, axis=0)
    along = after / np.linalg.norm(after, axis=1)[:, None] + before / np.linalg.norm(before, axis=1)[:, None]
    inward: Array = np.sign(signed_area(ring)) * np.stack([-along[:, 1], along[:, 0]], axis=1)
    return inward


def _mates(outlines: Outlines, outline: IndexArray) -> IndexArray:
    """For each point of an outline the one of it that it is sewn to, or -1."""
    position = {point: index for index, point in enumerate(outline.tolist())}
    mates = np.full(len(outline), -1, dtype=np.int32)
    for seam in outlines.seams:
        for one, other in zip(seam.sides[0].tolist(), seam.sides[1].tolist(), strict=True):
            if one in position and other in position and one != other:
                mates[position[one]], mates[position[other]] = position[other], position[one]
    return mates


def _lying_over(ring: Array) -> npt.NDArray[np.bool_]:
    """Which points of a ring lie on what it goes round elsewhere."""
    inward = _inward(ring)
    sizes = np.linalg.norm(inward, axis=1, keepdims=True)
    doubled = np.sign(signed_area(ring)) * windings(ring, ring + 1e-3 * inward / np.maximum(sizes, 1e-9)) > 1
    # The tip of a slit has no inside to look at.
    over: npt.NDArray[np.bool_] = doubled & (sizes[:, 0] > 0.3)
    return over


def _beside_crossings(ring: Array) -> npt.NDArray[np.bool_]:
    """Which points end a line near where it crosses another, such as a corner that is just outside."""
    count = len(ring)
    lines = shapely.linestrings(np.stack([ring, np.roll(ring, -1, axis=0)], axis=1))
    one, other = shapely.STRtree(lines).query(lines, predicate="crosses")
    beside = np.zeros(count, dtype=np.bool_)
    crossings = shapely.get_coordinates(shapely.centroid(shapely.intersection(lines[one], lines[other])))
    for crossing, line in zip(crossings, one.tolist(), strict=True):
        ends = np.array((line, (line + 1) % count))
        distances = np.linalg.norm(ring[ends] - crossing, axis=1)
        beside[ends[distances.argmin()]] |= bool(distances.min() < NARROW)
    return beside


def _opposite(ring: Array, over: npt.NDArray[np.bool_], index: int) -> Array | None:
    """The nearest point of the lines that lie over the ring elsewhere than at a point of it."""
    count = len(ring)
    near = {index}
    for step in (-1, 1):
        at = index
        while over[at] and len(near) <= count:
            near.add(at)
            at = (at + step) % count
        near.add(at)
    others = [k for k in range(count) if k not in near]
    edges = [k for k in others if over[k]] or others
    if not edges:
        return None
    lines = shapely.linestrings([[ring[k - 1], ring[k], ring[(k + 1) % count]] for k in edges])
    point = shapely.Point(ring[index])
    closest = lines[shapely.distance(lines, point).argmin()]
    nearest: Array = shapely.get_coordinates(shapely.shortest_line(closest, point))[0]
    return nearest
