# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces laid out on sheets by spyrrow: outlines nested into each other, which boxes can't be."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np
import shapely
import spyrrow

from meshlab_developable.errors import PatternError
from meshlab_developable.patterns.drawing import Motion
from meshlab_developable.patterns.options import Size

SECONDS = 1  # that the search for a better layout takes, and as much again for every ten pieces
Angles = Mapping[str, Sequence[float] | None]  # degrees; None: any
_TURNS: dict[str, list[float] | None] = {"none": [0.0], "half": [0.0, 180.0], "free": None}
TRIALS = 3  # to fill a sheet
FILLED = 0.85  # of a sheet, at most, is tried to be covered
_ROOM = 1e-3  # mm; spyrrow reckons in single precision


@dataclasses.dataclass(frozen=True)
class Sheet:
    """A sheet and where the pieces on it go."""

    size: Size
    motions: Mapping[str, Motion]  # by the pieces' names


def pack(
    shapes: Mapping[str, shapely.Polygon],
    size: Size | None,
    gap: float,
    turns: str,
    upright: Collection[str] = (),
) -> list[Sheet]:
    """Sheets with all the shapes on them, at least a gap (mm) apart and half a gap from the edges.

    size: of the sheets, mm; None: one sheet, as large as needed. turns: "none", "half" (a half turn keeps the
    grain) or "free", but for shapes that stay upright. Raises PatternError, naming the shapes, when some are
    larger than a sheet.
    """
    if not shapes:
        return []
    padded = {name: _padded(shape, gap) for name, shape in shapes.items()}
    angles = {name: [0.0] if name in upright else _TURNS[turns] for name in shapes}
    if size is None:
        return [_right_way_up(_only_sheet(padded, angles, turns), padded, upright)]
    _require_room(shapes, padded, size, turns)
    sheets = []
    while padded:
        here = _fill_sheet(padded, angles, size)
        if not here:
            name = next(iter(padded))
            here = {name: _alone(padded[name], size, turns)}
        sheets.append(_right_way_up(Sheet(size, here), padded, upright))
        padded = {name: shape for name, shape in padded.items() if name not in here}
    return sheets


def _right_way_up(sheet: Sheet, padded: Mapping[str, shapely.Polygon], upright: Collection[str]) -> Sheet:
    """The sheet turned round where more of what is on it, by area, would stand upright so.

    Shapes that stay upright must look the same after a half turn; else the sheet stays.
    """
    pieces = {name: motion for name, motion in sheet.motions.items() if name not in upright}
    up = sum(padded[name].area * math.cos(math.radians(motion.angle)) for name, motion in pieces.items())
    kept = {name: padded[name] for name in sheet.motions if name in upright}
    if up >= 0 or not all(_same_after_half_turn(shape) for shape in kept.values()):
        return sheet
    width, height = sheet.size
    motions = {}
    for name, motion in sheet.motions.items():
        shift = (width - motion.shift[0], height - motion.shift[1])
        motions[name] = Motion((motion.angle + 180) % 360, shift)
        if name in kept:
            left, low, right, high = kept[name].bounds
            motions[name] = Motion(0.0, (shift[0] - left - right, shift[1] - low - high))
    return Sheet(sheet.size, motions)


def _same_after_half_turn(shape: shapely.Polygon) -> bool:
    left, low, right, high = shape.bounds
    turned = shapely.transform(shape, Motion(180.0, (left + right, low + high)))
    return bool(shape.symmetric_difference(turned).area < 1e-6 * shape.area)


def _fill_sheet(padded: Mapping[str, shapely.Polygon], angles: Angles, size: Size) -> dict[str, Motion]:
    """A sheet with as many of the shapes as find room; none when the search was out of luck."""
    best: dict[str, Motion] = {}
    left = dict(padded)
    for _ in range(TRIALS):
        chosen = _about_a_sheet(left, size)
        motions = _strip(chosen, angles, size[1])
        here = {
            name: motion
            for name, motion in motions.items()
            if shapely.transform(chosen[name], motion).bounds[2] <= size[0] + _ROOM
        }
        if _area(padded, here) > _area(padded, best):
            best = here
        if len(here) == len(chosen) or not here:
            break
        # Smaller ones in place of those that stuck out.
        left = {name: shape for name, shape in left.items() if name in here or name not in chosen}
    return best


def _area(shapes: Mapping[str, shapely.Polygon], names: Iterable[str]) -> float:
    return float(sum(shapes[name].area for name in names))


def _about_a_sheet(padded: Mapping[str, shapely.Polygon], size: Size) -> dict[str, shapely.Polygon]:
    """Shapes, the largest first, as many as may find room on a sheet together."""
    room = FILLED * size[0] * size[1]
    chosen: dict[str, shapely.Polygon] = {}
    for name, shape in sorted(padded.items(), key=lambda item: -item[1].area):
        if shape.area <= room or not chosen:
            chosen[name] = shape
            room -= shape.area
    return chosen


def _padded(shape: shapely.Polygon, gap: float) -> shapely.Polygon:
    """A simpler outline round the shape, half a gap away."""
    slack = max(gap / 20, 0.02)
    return shape.buffer(gap / 2 + slack, join_style="mitre", mitre_limit=2).simplify(slack / 2)


def _only_sheet(padded: Mapping[str, shapely.Polygon], angles: Angles, turns: str) -> Sheet:
    area = _area(padded, padded)
    height = max(1.01 * _tallest(padded.values(), turns), math.sqrt(1.2 * area))
    motions = _strip(padded, angles, height)
    boxes = np.array([shapely.transform(padded[name], motion).bounds for name, motion in motions.items()])
    (left, low), (right, high) = boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
    shifted = {
        name: Motion(motion.angle, (motion.shift[0] - left, motion.shift[1] - low))
        for name, motion in motions.items()
    }
    return Sheet((float(right - left), float(high - low)), shifted)


def _tallest(shapes: Iterable[shapely.Polygon], turns: str) -> float:
    heights = []
    for shape in shapes:
        left, low, right, high = shape.bounds
        heights.append(math.hypot(right - left, high - low) if turns == "free" else high - low)
    return float(max(heights))


def _require_room(
    shapes: Mapping[str, shapely.Polygon],
    padded: Mapping[str, shapely.Polygon],
    size: Size,
    turns: str,
) -> None:
    too_large = [name for name, shape in padded.items() if _fitting_angle(shape, size, turns) is None]
    if not too_large:
        return
    left, low, right, high = shapes[too_large[0]].bounds
    verb, more = ("is", "") if len(too_large) == 1 else ("are", f" and {len(too_large) - 1} more")
    raise PatternError(
        f"{too_large[0]}{more} {verb} larger than a sheet of {size[0]:g} x {size[1]:g} mm: "
        f"{'it' if not more else 'the first'} needs {right - left:.0f} x {high - low:.0f} mm and half the "
        "gap round it. Choose a larger sheet, a smaller allowance, or cut the panel in two."
    )


def _fitting_angle(shape: shapely.Polygon, size: Size, turns: str) -> float | None:
    """A turn, degrees, with which the shape is no larger than a sheet."""
    for angle in range(0, 180, 5) if turns == "free" else [0]:
        left, low, right, high = shapely.transform(shape, Motion(angle)).bounds
        if right - left <= size[0] and high - low <= size[1]:
            return angle
    return None


def _alone(shape: shapely.Polygon, size: Size, turns: str) -> Motion:
    """In the corner of a sheet that it fits."""
    angle = _fitting_angle(shape, size, turns) or 0
    left, low, _, _ = shapely.transform(shape, Motion(angle)).bounds
    return Motion(angle, (-left, -low))


def _strip(padded: Mapping[str, shapely.Polygon], angles: Angles, height: float) -> dict[str, Motion]:
    """Where the shapes go on a strip of that height that is as short as can be."""
    name, shape = next(iter(padded.items()))
    if len(padded) == 1 and angles[name] is not None:
        left, low, _, _ = shape.bounds
        return {name: Motion(0.0, (-left, -low))}
    items = [
        spyrrow.Item(name, shape.exterior.coords[:-1], 1, angles[name]) for name, shape in padded.items()
    ]
    settings = spyrrow.StripPackingConfig(
        early_termination=True, total_computation_time=SECONDS * (1 + len(items) // 10), num_workers=1, seed=1
    )
    found = spyrrow.StripPackingInstance("pattern", height + _ROOM, items).solve(settings)
    placed = {item.id: Motion(item.rotation % 360, item.translation) for item in found.placed_items}
    return {name: placed[name] for name in padded}
