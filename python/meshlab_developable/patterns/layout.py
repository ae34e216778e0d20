# SPDX-License-Identifier: GPL-3.0-or-later
"""Where pieces lie on their sheets, as a file says: the side file of a pattern, maybe edited by hand."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path as FilePath
from typing import Any

import shapely

from meshlab_developable.errors import PatternError
from meshlab_developable.patterns.drawing import Motion
from meshlab_developable.patterns.options import Size
from meshlab_developable.patterns.packing import Sheet

_ROUNDING = 0.01  # mm, that pieces may lie over each other


def read_layout(file: FilePath, shapes: Mapping[str, shapely.Polygon]) -> tuple[list[Sheet], list[str]]:
    """Sheets with the shapes on them where the file says, and notes on those that lie badly.

    The file has "sheets", a list of width and height in mm, and "pieces", a list of objects with "name",
    "sheet" (from 1), "turned_degrees" (about the origin of the piece, to the left) and then "shifted" (mm).
    Raises PatternError where it does not say so of every shape, or names others.
    """
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
        sizes = [(_number(width), _number(height)) for width, height in content["sheets"]]
        places = {
            piece["name"]: (int(piece["sheet"]) - 1, _motion(piece))
            for piece in content["pieces"]
            if piece["sheet"] is not None
        }
    except (ValueError, KeyError, TypeError) as error:
        reason = f"{error} is missing" if isinstance(error, KeyError) else error
        raise PatternError(f"{file} is no layout: {reason}; begin with the .json of a pattern.") from None
    missing, unknown = set(shapes) - set(places), set(places) - set(shapes)
    if missing or unknown:
        says = [f"nothing of {name}" for name in sorted(missing)] + [f"of {name}" for name in sorted(unknown)]
        raise PatternError(f"{file} says {', '.join(says)}, but the pieces are {', '.join(shapes)}.")
    wrong = [name for name, (sheet, _) in places.items() if not 0 <= sheet < len(sizes)]
    if wrong:
        raise PatternError(f"{file} puts {', '.join(wrong)} on a sheet that it has not; it has {len(sizes)}.")
    sheets = [
        Sheet(size, {name: motion for name, (sheet, motion) in places.items() if sheet == number})
        for number, size in enumerate(sizes)
    ]
    return sheets, [note for sheet in sheets for note in _notes(sheet, shapes)]


def _motion(piece: Mapping[str, Any]) -> Motion:
    x, y = piece["shifted"]
    return Motion(_number(piece["turned_degrees"]), (_number(x), _number(y)))


def _number(value: Any) -> float:
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{value!r} is no length")
    return number


def _notes(sheet: Sheet, shapes: Mapping[str, shapely.Polygon]) -> list[str]:
    size: Size = sheet.size
    room = shapely.box(-_ROUNDING, -_ROUNDING, size[0] + _ROUNDING, size[1] + _ROUNDING)
    placed = {name: shapely.transform(shapes[name], motion) for name, motion in sheet.motions.items()}
    notes = [f"{name} sticks out of its sheet." for name, shape in placed.items() if not room.covers(shape)]
    names = list(placed)
    for number, one in enumerate(names):
        for other in names[:number]:
            if placed[one].buffer(-_ROUNDING).intersects(placed[other].buffer(-_ROUNDING)):
                notes.append(f"{other} and {one} lie on each other.")
    return notes
