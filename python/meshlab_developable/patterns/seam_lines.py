# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams moved along the model, so that they are smooth: what one piece loses the piece beside it gains."""

from __future__ import annotations

import itertools
from collections import Counter

import numpy as np
import numpy.typing as npt
import scipy.sparse
import scipy.sparse.linalg
import shapely

from meshlab_developable.flattening import FlatteningResult
from meshlab_developable.mesh_sets import Array
from meshlab_developable.patterns.corners import SHARP
from meshlab_developable.patterns.fair_curves import most_smoothing, third_differences
from meshlab_developable.sewing import Seam

Complex = npt.NDArray[np.complex128]  # places in a plane, which turn by a product

_ROUNDS = 60  # of holding back what moves too far
_STEPS = 10  # of Newton's method for the lengths
_EQUAL = 1e-4  # mm
_SLIGHT = 0.05  # radians, that do no harm
_LEAST_MOVE = 0.05  # mm, that is worth while
_LEAST_STEP = 1e-3  # of the mean: shorter edges count as so long


def smooth_seams(flat: FlatteningResult, points: Array, tolerance: float) -> Array:
    """The points (p x 2, mm) with those inside seams moved by no more than the tolerance (mm).

    The ends of seams stay, and points where both sides together turn sharply, as at a corner of a box: there
    the pieces meet at curvature, which no other line can take. So do seams of more than two sides, and those
    of pieces that would overlap themselves only then.
    """
    moved = {number: _moved(seam, points, tolerance) for number, seam in enumerate(flat.seams)}
    for number in _branched(flat.seams):
        del moved[number]
    whole = [_simple(flat, points, piece) for piece in range(flat.report.pieces)]
    while True:
        smooth = points.copy()
        for number, lines in moved.items():
            for side, line in zip(flat.seams[number].sides, lines, strict=True):
                smooth[side] = line
        spoilt = {
            piece for piece, was_simple in enumerate(whole) if was_simple and not _simple(flat, smooth, piece)
        }
        kept = {
            number: lines for number, lines in moved.items() if spoilt.isdisjoint(flat.seams[number].pieces)
        }
        if len(kept) == len(moved):
            return smooth
        moved = kept


def _branched(seams: tuple[Seam, ...]) -> list[int]:
    """Seams with a point inside that is in another one, or on both of its own sides."""
    inner = [Counter(int(vertex) for side in seam.sides for vertex in side[1:-1]) for seam in seams]
    uses = sum(inner, Counter())
    return [number for number, own in enumerate(inner) if any(uses[vertex] > 1 for vertex in own)]


def _simple(flat: FlatteningResult, points: Array, piece: int) -> bool:
    """Whether no boundary of a piece crosses itself or another."""
    rings = [shapely.LinearRing(points[loop]) for loop in flat.loops if flat.pieces[loop[0]] == piece]
    lines = shapely.MultiLineString(rings)
    return bool(lines.is_simple)


def _moved(seam: Seam, points: Array, tolerance: float) -> tuple[Array, Array]:
    """Both sides of a seam after the same moves, seen from each."""
    one, other = (points[side] @ np.array([1, 1j]) for side in seam.sides)
    corners = np.flatnonzero(abs(_turns(one) - _turns(other)) > SHARP) + 1
    closed = seam.closed and not len(corners)
    turn = _frames(one, other, closed)
    moves = np.zeros(len(one), dtype=np.complex128)
    stops = [0, *corners.tolist(), len(one) - 1]
    for start, end in itertools.pairwise(stops):
        part = slice(start, end + 1)
        moves[part] = _moves(one[part], other[part], turn[part], tolerance, closed)
    lines = one + moves, other + turn * moves
    return np.stack([lines[0].real, lines[0].imag], axis=1), np.stack([lines[1].real, lines[1].imag], axis=1)


def _turns(line: Complex) -> Array:
    """By how much a line turns at each inner point, to the left, radians."""
    steps = np.diff(line)
    turns: Array = np.angle(steps[1:] * steps[:-1].conj())
    return turns


def _frames(one: Complex, other: Complex, closed: bool) -> Complex:
    """What turns directions at the points of the one side to the same ones, on the model, at the other."""
    along = [np.gradient(line) for line in (one, other)]
    if closed:
        for line, directions in zip((one, other), along, strict=True):
            directions[[0, -1]] = line[1] - line[-2]
    frames: Complex = np.exp(1j * np.angle(along[1] * along[0].conj()))
    return frames


def _moves(one: Complex, other: Complex, turn: Complex, tolerance: float, closed: bool) -> Complex:
    """Moves (k) of the points of the one side that make both sides smooth, and let them differ in length as
    before; none at the ends, and none at all where there are no such moves.

    closed: the last point is the first again, and moves with it.
    """
    none = np.zeros(len(one), dtype=np.complex128)
    if len(one) < 4 + closed or tolerance < _LEAST_MOVE:
        return none
    system, force = _smoothing(one, other, turn, tolerance, closed)
    excess = _excess(one, other)
    weights = np.ones(len(force))
    for _ in range(_ROUNDS):
        solve = scipy.sparse.linalg.factorized((system + scipy.sparse.diags_array(weights)).tocsc())
        free = solve(force)
        for _ in range(_STEPS):
            moves = np.append(free, free[:1]) if closed else np.pad(free, 1)
            gradient = _gradient_of_excess(one + moves, other + turn * moves, turn, closed)
            answer = solve(gradient)
            rate = float(np.vdot(gradient, answer).real)
            change = excess - _excess(one + moves, other + turn * moves)
            if abs(change) < _EQUAL or rate == 0:
                break
            free = free + change / rate * answer
        beyond = abs(free) / tolerance
        if beyond.max() <= 1:
            break
        weights *= np.maximum(1.0, 1.2 * beyond**1.5)
    lines = (one, one + moves), (other, other + turn * moves)
    if beyond.max() <= 1 and abs(change) < _EQUAL and all(_is_fairer(line, old) for old, line in lines):
        return moves
    return _moves(one, other, turn, tolerance / 2, closed)


def _smoothing(
    one: Complex, other: Complex, turn: Complex, tolerance: float, closed: bool
) -> tuple[scipy.sparse.csr_array, Complex]:
    """The system that moves of free points solve, but for their own weights, and its right side."""
    steps = (abs(np.diff(one)) + abs(np.diff(other))) / 2
    steps = np.maximum(steps, _LEAST_STEP * steps.mean())
    differences = third_differences(np.append(0.0, np.cumsum(steps)), closed)
    roughness = 10.0 ** most_smoothing(float(steps.mean()), tolerance) * (differences.T @ differences)
    if closed:
        one, other, turn = one[:-1], other[:-1], turn[:-1]
    frames = scipy.sparse.diags_array(turn)
    system = scipy.sparse.csr_array(roughness + frames.conj() @ roughness @ frames)
    force: Complex = -(roughness @ one + turn.conj() * (roughness @ other))
    return (system, force) if closed else (system[1:-1, 1:-1], force[1:-1])


def _excess(one: Complex, other: Complex) -> float:
    """How much longer the one side is."""
    return float(abs(np.diff(one)).sum() - abs(np.diff(other)).sum())


def _gradient_of_excess(one: Complex, other: Complex, turn: Complex, closed: bool) -> Complex:
    """By how much it grows with moves of the points that are free."""
    rates = []
    for line in (one, other):
        steps = np.diff(line)
        units = steps / np.maximum(abs(steps), 1e-300)
        rates.append(np.roll(units, 1) - units if closed else -np.diff(units))
    gradient: Complex = rates[0] - (turn[:-1] if closed else turn[1:-1]).conj() * rates[1]
    return gradient


def _is_fairer(line: Complex, old: Complex) -> bool:
    """Whether no part of a line has turned round, and it turns less in all than the old one."""
    ahead = (np.diff(line) * np.diff(old).conj()).real
    return bool((ahead >= 0).all() and abs(_turns(line)).sum() <= abs(_turns(old)).sum() + _SLIGHT)
