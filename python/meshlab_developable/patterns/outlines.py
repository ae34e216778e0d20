# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines that pieces are sewn along: those of the mesh, or smooth ones, alike on both sides of a seam."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
import shapely

from meshlab_developable.flattening import FlatteningResult
from meshlab_developable.mesh_sets import Array, IndexArray
from meshlab_developable.patterns.boundary_rings import BoundaryRing, Run
from meshlab_developable.patterns.corners import find_teeth
from meshlab_developable.patterns.division import Division
from meshlab_developable.patterns.seam_lines import smooth_seams
from meshlab_developable.sewing import Seam, signed_area

EQUAL = 0.005  # mm, by which the curves of a seam may differ
ROUNDS = 30  # of making them equal
MANY_TEETH = 6  # on one boundary, that are worth a note


@dataclasses.dataclass(frozen=True)
class Outlines:
    """Boundaries and seams of all pieces."""

    points: Array  # p x 2, mm: the vertices of the flattening, then those of smooth lines
    pieces: IndexArray  # p, the number of each point's piece
    loops: tuple[IndexArray, ...]  # as those of the flattening, of points
    seams: tuple[Seam, ...]  # as those of the flattening, of points; lengths in mm
    smooth: bool
    notes: tuple[str, ...] = ()  # what a user should know


def exact_outlines(flat: FlatteningResult, millimetres: float) -> Outlines:
    """The lines of the mesh. millimetres: its unit."""
    points = flat.vertices * millimetres
    seams = tuple(_seam(seam, seam.sides, points) for seam in flat.seams)
    return Outlines(points, flat.pieces, flat.loops, seams, smooth=False)


def fair_outlines(
    flat: FlatteningResult,
    millimetres: float,
    tolerance: float,
    names: Sequence[str],
    seam_tolerance: float = 0.0,
) -> Outlines:
    """Smooth lines between the corners, that pass all vertices of the mesh within the tolerance (mm).

    First seams are moved on the model by up to the seam tolerance (mm), where that makes them smooth.
    Both sides of a seam are equally long, and divided alike. Where no smooth lines are, as on a coarse mesh
    along a seam whose sides bend differently, or where they would cross each other, the mesh's remain.
    """
    points = flat.vertices * millimetres
    if seam_tolerance > 0:
        points = smooth_seams(flat, points, seam_tolerance)
    return _FairOutlines(flat, points, tolerance, names).outlines()


def _seam(seam: Seam, sides: tuple[IndexArray, IndexArray], points: Array) -> Seam:
    one, other = (float(np.linalg.norm(np.diff(points[side], axis=0), axis=1).sum()) for side in sides)
    return dataclasses.replace(seam, sides=sides, lengths=(one, other))


class _FairOutlines:
    def __init__(self, flat: FlatteningResult, points: Array, tolerance: float, names: Sequence[str]) -> None:
        self.flat, self.points, self.names = flat, points, names
        self.place = {
            vertex: (number, position)
            for number, loop in enumerate(flat.loops)
            for position, vertex in enumerate(loop.tolist())
        }
        fixed: list[set[int]] = [set() for _ in flat.loops]
        for seam in flat.seams:
            for vertex in (seam.sides[side][end] for side in (0, 1) for end in (0, -1)):
                number, position = self.place[int(vertex)]
                fixed[number].add(position)
        self.rings = [
            BoundaryRing(loop, points[loop], fixed[number], tolerance)
            for number, loop in enumerate(flat.loops)
        ]
        self.notes = list(self._teeth())
        self.sides = [(self._run(seam.sides[0]), self._run(seam.sides[1])) for seam in flat.seams]
        self.excess = [0.0] * len(self.sides)  # of the first side's length over the second's that is sought
        self._keep_lines_of_triple_seams()

    def outlines(self) -> Outlines:
        """Fit until all seams are equal and no piece crosses itself."""
        while True:
            for ring in self.rings:
                ring.fit()
            if self._equalize() and self._divided():
                return self.made

    def _teeth(self) -> list[str]:
        sewn = {int(vertex) for seam in self.flat.seams for side in seam.sides for vertex in side}
        notes = []
        for ring in self.rings:
            teeth = find_teeth(ring.points, ring.corners, ring.fixed)
            if len(teeth) >= MANY_TEETH:
                name = self.names[int(self.flat.pieces[ring.loop[0]])]
                highest = int(np.ceil(np.quantile(list(teeth.values()), 0.9) - 0.1))
                of_seams = {int(ring.loop[position]) in sewn for position in teeth}
                options = [word for word, on in (("a seam", True), ("an outline", False)) if on in of_seams]
                advice = " and ".join(f"{option}_tolerance of {highest} (mm)" for option in options)
                smooth = "smooths" if len(options) == 1 else "smooth"
                notes.append(
                    f"{name} has a jagged edge, {len(teeth)} teeth about {highest} mm high: {advice} "
                    f"{smooth} them."
                )
        return notes

    def _run(self, side: IndexArray) -> Run:
        places = [self.place[vertex] for vertex in side.tolist()]
        ring = self.rings[places[0][0]]
        positions = [position for _, position in places]
        backwards = (positions[0] - positions[1]) % len(ring.loop) == 1
        return Run(ring, positions[1:] if backwards else positions[:-1], backwards)

    def _keep_lines_of_triple_seams(self) -> None:
        """Edges that are sewn to more than one other keep their lines, whose ends all of them have."""
        seen: set[tuple[int, int]] = set()
        for sides in self.sides:
            edges = {(id(run.ring), edge) for run in sides for edge in run.edges}
            if len(edges) < sum(len(run.edges) for run in sides) or edges & seen:
                for run in sides:
                    run.ring.corners.update(run.vertices())
            seen |= edges

    def _equalize(self) -> bool:
        """Make the sides of seams as long as each other; whether that went without giving up curves."""
        for _ in range(ROUNDS):
            wrong = self._unequal()
            if not wrong:
                return True
            for number in wrong:
                one, other = self.sides[number]
                excess = float(one.lengths().sum() - other.lengths().sum()) - self.excess[number]
                (rate, moves), (other_rate, other_moves) = one.ring.bend(one), other.ring.bend(other)
                if rate + other_rate > 0:
                    one.ring.move(moves, -excess / (rate + other_rate))
                    other.ring.move(other_moves, excess / (rate + other_rate))
        for number in self._unequal():
            self._give_up(number)
        return False

    def _unequal(self) -> list[int]:
        return [
            number
            for number, (one, other) in enumerate(self.sides)
            if not self._has_lines(number)
            and abs(one.lengths().sum() - other.lengths().sum() - self.excess[number]) > EQUAL
        ]

    def _has_lines(self, number: int) -> bool:
        return all(run.ring.corners.issuperset(run.vertices()) for run in self.sides[number])

    def _give_up(self, number: int) -> None:
        """Seek the difference in length that the mesh has; where that was sought already, keep its lines."""
        one, other = (self.points[side] for side in self.flat.seams[number].sides)
        steps = (float(np.linalg.norm(np.diff(side, axis=0), axis=1).sum()) for side in (one, other))
        excess = next(steps) - next(steps)
        if abs(excess) > EQUAL and self.excess[number] == 0:
            self.excess[number] = excess
            return
        for run in self.sides[number]:
            run.ring.corners.update(run.vertices())

    def _divided(self) -> bool:
        """Divide the curves into lines; whether no piece then crosses itself that did not before."""
        division = Division(self.rings, self.points, self.flat.pieces)
        sides = [division.divide(pair) for pair in self.sides]
        loops = division.finish()
        points, pieces = division.points(), division.pieces()
        bad = [
            number
            for number in range(self.flat.report.pieces)
            if not _simple(loops, pieces, points, number)
            and _simple(self.flat.loops, self.flat.pieces, self.points, number)
        ]
        for ring in self.rings:
            if self.flat.pieces[ring.loop[0]] in bad:
                ring.corners.update(range(len(ring.loop)))
        seams = tuple(
            _seam(seam, (one, other), points)
            for seam, (one, other) in zip(self.flat.seams, sides, strict=True)
        )
        self.made = Outlines(points, pieces, loops, seams, smooth=True, notes=tuple(self.notes))
        return not bad


def _simple(loops: Sequence[IndexArray], pieces: IndexArray, points: Array, number: int) -> bool:
    """Whether the boundaries of a piece cross neither themselves nor each other."""
    rings = [points[loop] for loop in loops if pieces[loop[0]] == number]
    outline = max(range(len(rings)), key=lambda index: abs(signed_area(rings[index])))
    return bool(shapely.Polygon(rings.pop(outline), rings).is_valid)
