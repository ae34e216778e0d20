# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters' parameters as this package takes them: plain Python values, checked before the filter runs."""

from __future__ import annotations

import difflib
import math
import numbers
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pymeshlab

from meshlab_developable.errors import InvalidParameterError

Kind = Callable[[Any], Any]  # a user's value to pymeshlab's; ValueError says what would do

# A length given as a plain number; pymeshlab 2022.2 has it under the second name.
_PlainLength = getattr(pymeshlab, "PureValue", None) or pymeshlab.AbsoluteValue


def boolean(value: Any) -> bool:
    """True or False."""
    if not isinstance(value, (bool, np.bool_)):
        raise ValueError("must be True or False")
    return bool(value)


def whole(value: Any) -> int:
    """A whole number, 0 or more."""
    if not _is_integer(value) or value < 0:
        raise ValueError("must be a whole number, 0 or more")
    return int(value)


def number(value: Any) -> float:
    """A finite number, 0 or more."""
    if not _is_finite(value) or value < 0:
        raise ValueError("must be a finite number, 0 or more")
    return float(value)


def length(value: Any) -> Any:
    """A length in the mesh's unit, 0 or more."""
    return _PlainLength(number(value))


def optional_length(value: Any) -> Any:
    """A length in the mesh's unit, 0 or more, or -1 for the one that suits the mesh."""
    if not _is_finite(value) or (value < 0 and value != -1):
        raise ValueError("must be a finite length, 0 or more, or -1 for the filter's own choice")
    return _PlainLength(float(value))


def choice(*texts: str) -> Kind:
    """One of a list of texts, or its index."""

    def convert(value: Any) -> str:
        if isinstance(value, str) and value in texts:
            return value
        if _is_integer(value) and 0 <= value < len(texts):
            return texts[int(value)]
        raise ValueError(f"must be one of {', '.join(map(repr, texts))}")

    return convert


def _is_integer(value: Any) -> bool:
    return isinstance(value, numbers.Integral) and not isinstance(value, bool)


def _is_finite(value: Any) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, bool) and math.isfinite(value)


MAPS = (
    "Gaussian map",
    "Angle defect",
    "Gaussian curvature",
    "Minimum curvature",
    "Maximum curvature",
    "Distance",
    "Displacement",
)

# Seams other than these two need what arrays do not carry: colours, texture coordinates or quality of faces.
_SHARED: dict[str, Kind] = {"patches": choice("Connected components"), "weld_distance": length}

GLOBAL: dict[str, Kind] = {
    "solver": choice("Constrained Newton", "Conjugate gradient"),
    **_SHARED,
    "fix_boundary": boolean,
    "angle_tolerance": number,
    "curvature_tolerance": number,
    "max_iterations": whole,
    "relative_change": number,
    "smoothness": number,
    "map": choice(*MAPS),
}

LOCAL: dict[str, Kind] = {
    **_SHARED,
    "angle_tolerance": number,
    "max_displacement": optional_length,
    "max_operations": whole,
    "descent": boolean,
    "smoothing": number,
    "assembling_vertices": choice("Fixed", "Move together"),
    "avoid_self_intersections": boolean,
    "map": choice(*MAPS),
}

MEASURE: dict[str, Kind] = {**_SHARED, "angle_tolerance": number, "map": choice(*MAPS)}


def convert(parameters: Mapping[str, Any], kinds: Mapping[str, Kind], method: str) -> dict[str, Any]:
    """The parameters as pymeshlab's filters take them.

    Raises InvalidParameterError for a name that the method has not, naming the nearest, and for a value that
    it does not take, saying what would do.
    """
    converted = {}
    for name, value in parameters.items():
        if name not in kinds:
            near = difflib.get_close_matches(name, kinds, n=1)
            hint = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(kinds)}."
            raise InvalidParameterError(f"{method} has no parameter {name!r}; {hint}")
        try:
            converted[name] = kinds[name](value)
        except ValueError as error:
            raise InvalidParameterError(f"{name} is {value!r}, but {error}") from None
    return converted
