# SPDX-License-Identifier: GPL-3.0-or-later
"""Filters and their parameters: what each takes, from Python or as text, and how a script writes it.

Values are plain Python values (lengths are numbers in the mesh's unit) and checked before a filter runs.
What filters and parameters there are is in description.py.
"""

from __future__ import annotations

import abc
import dataclasses
import difflib
import math
import numbers
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from meshlab_developable import materials
from meshlab_developable.errors import InvalidParameterError

LARGEST_INTEGER = 2**31 - 1  # that hosts take
TRUE, FALSE = ("true", "yes", "on", "1"), ("false", "no", "off", "0")


class Kind(abc.ABC):
    """What a parameter takes. The methods raise ValueError, whose text says what would do."""

    script_type: str  # in .mlx scripts

    @abc.abstractmethod
    def check(self, value: Any) -> Any:
        """The value as a plain Python value."""

    def parse(self, text: str) -> Any:
        """The value that a text stands for."""
        return self.check(text)

    def script_attributes(self, value: Any) -> dict[str, str]:
        """What an .mlx script says of the parameter when it has this value, besides name and type."""
        return {"value": f"{value:.15g}"}


@dataclasses.dataclass(frozen=True)
class Boolean(Kind):
    """True or False."""

    script_type = "RichBool"

    def check(self, value: Any) -> bool:
        """Any kind of bool."""
        if not isinstance(value, (bool, np.bool_)):
            raise ValueError("must be True or False")
        return bool(value)

    def parse(self, text: str) -> bool:
        """True and false, yes and no, on and off, 1 and 0."""
        if text.lower() in TRUE + FALSE:
            return text.lower() in TRUE
        raise ValueError("must be true or false")

    def script_attributes(self, value: Any) -> dict[str, str]:
        """In lower case."""
        return {"value": str(value).lower()}


@dataclasses.dataclass(frozen=True)
class Whole(Kind):
    """A whole number, 0 or more."""

    script_type = "RichInt"

    def check(self, value: Any) -> int:
        """Any kind of integer."""
        if not _is_integer(value) or not 0 <= value <= LARGEST_INTEGER:
            raise ValueError(f"must be a whole number, 0 or more and at most {LARGEST_INTEGER}")
        return int(value)

    def parse(self, text: str) -> int:
        """Decimal digits."""
        return self.check(int(text) if text.strip().isdecimal() else text)


@dataclasses.dataclass(frozen=True)
class Number(Kind):
    """A finite number within a range."""

    minimum: float = 0.0
    minimum_excluded: bool = False
    maximum: float = math.inf
    positive_for_solver: str = ""  # the choice of `solver` that excludes the minimum too
    script_type = "RichFloat"

    def check(self, value: Any) -> float:
        """Any kind of real number."""
        if not _is_finite(value) or not self._has(value):
            raise ValueError(f"must be a finite number, {self.range_in_words}")
        return float(value)

    @property
    def range_in_words(self) -> str:
        """What would do."""
        least = f"greater than {self.minimum:g}" if self.minimum_excluded else f"{self.minimum:g} or more"
        most = f" and at most {self.maximum:g}" if math.isfinite(self.maximum) else ""
        solver = self.positive_for_solver
        exception = f", greater than {self.minimum:g} with the solver {solver!r}" if solver else ""
        return least + most + exception

    def _has(self, value: float) -> bool:
        above = value > self.minimum if self.minimum_excluded else value >= self.minimum
        return above and value <= self.maximum

    def parse(self, text: str) -> float:
        """As Python writes numbers."""
        return self.check(_as_number(text))


@dataclasses.dataclass(frozen=True)
class Length(Kind):
    """A length in the mesh's unit, 0 or more; or a text like "2%", of the diagonal of the mesh's box.

    Or -1 for the length that suits the mesh, where there is one.
    """

    automatic: bool = False
    script_type = "RichAbsPerc"

    def check(self, value: Any) -> float | str:
        """Any kind of real number, or a share as a text."""
        if isinstance(value, str) and _is_finite(per_cent(value)) and per_cent(value) >= 0:
            return value
        if not _is_finite(value) or (value < 0 and not (self.automatic and value == -1)):
            own_choice = ", or -1 for the filter's own choice" if self.automatic else ""
            raise ValueError(
                f"must be a finite length, 0 or more, or a share of the diagonal such as 2%{own_choice}"
            )
        return float(value)

    def parse(self, text: str) -> float | str:
        """As Python writes numbers, or such a number and %."""
        return self.check(_as_number(text))

    def script_attributes(self, value: Any) -> dict[str, str]:
        """With the range that MeshLab asks for and does not use."""
        if isinstance(value, str):
            raise ValueError("a script does not know the mesh: give a length in its unit")
        return {"value": f"{value:.15g}", "min": "0", "max": f"{max(1.0, value):.15g}"}


@dataclasses.dataclass(frozen=True)
class Choice(Kind):
    """One of a list of texts, or its index."""

    texts: tuple[str, ...]
    script_type = "RichEnum"

    def check(self, value: Any) -> str:
        """A text, or its index from 0."""
        if isinstance(value, str) and value in self.texts:
            return value
        if _is_integer(value) and 0 <= value < len(self.texts):
            return self.texts[int(value)]
        near = difflib.get_close_matches(str(value).title(), self.texts, n=1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise ValueError(f"must be one of {', '.join(map(repr, self.texts))}{hint}")

    def parse(self, text: str) -> str:
        """In any case; or the index."""
        for known in self.texts:
            if known.lower() == text.strip().lower():
                return known
        return self.check(int(text) if text.strip().isdecimal() else text)

    def script_attributes(self, value: Any) -> dict[str, str]:
        """The index, and all the texts."""
        return {
            "value": str(self.texts.index(value)),
            "enum_cardinality": str(len(self.texts)),
            **{f"enum_val{index}": text for index, text in enumerate(self.texts)},
        }


@dataclasses.dataclass(frozen=True)
class Material(Choice):
    """One of the plugin's materials, or of one's own: `FILE.json#NAME`, or an entry as such a file has it."""

    def check(self, value: Any) -> Any:
        """A name, its index, or a file's path or an entry as they are."""
        if isinstance(value, Mapping):
            return value
        return str(value) if materials.is_own_file(value) else super().check(value)

    def parse(self, text: str) -> str:
        """A name in any case, the index, or a path."""
        return text if materials.is_own_file(text) else super().parse(text)


@dataclasses.dataclass(frozen=True)
class Grain(Choice):
    """One of the plugin's choices, or a direction on the model: three numbers."""

    def check(self, value: Any) -> Any:
        """A choice, its index, or a direction; that of an axis is the choice of this axis."""
        if isinstance(value, str) or np.ndim(value) == 0:
            return super().check(value)
        if not all(_is_number(part) for part in value):
            raise ValueError("must be one of the filter's choices or three numbers")
        return materials.grain_along(value)

    def parse(self, text: str) -> Any:
        """A choice in any case, the index, or a direction like 0,0.5,1."""
        parts = [_as_number(part) for part in text.split(",")]
        return super().parse(text) if len(parts) == 1 else self.check(parts)


@dataclasses.dataclass(frozen=True)
class Layer(Kind):
    """A layer, by its number from 0."""

    script_type = "RichMesh"

    def check(self, value: Any) -> int:
        """Any kind of integer."""
        if not _is_integer(value) or not 0 <= value <= LARGEST_INTEGER:
            raise ValueError("must be the number of a layer, 0 or more")
        return int(value)

    def parse(self, text: str) -> int:
        """Decimal digits."""
        return self.check(int(text) if text.strip().isdecimal() else text)


@dataclasses.dataclass(frozen=True)
class Parameter:
    """A parameter of a filter."""

    name: str
    kind: Kind
    default: Any
    unit: str  # "length" for the mesh's; empty where there is none
    help: str  # a sentence


@dataclasses.dataclass(frozen=True)
class Filter:
    """A filter of the plugin."""

    name: str  # on the command line
    title: str  # in menus and .mlx scripts
    function: str  # in pymeshlab
    parameters: tuple[Parameter, ...]

    def parameter(self, name: str) -> Parameter:
        """The parameter of that name. Raises InvalidParameterError, with the nearest name."""
        for parameter in self.parameters:
            if parameter.name == name:
                return parameter
        names = [parameter.name for parameter in self.parameters]
        near = difflib.get_close_matches(name, names, n=1)
        hint = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(names) or 'none'}."
        raise InvalidParameterError(f"{self.title} has no parameter {name!r}; {hint}")

    def checked(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """The values as plain Python values.

        Raises InvalidParameterError for a name that the filter has not, naming the nearest, and for a value
        that it does not take, saying what would do.
        """
        plain = {
            name: converted(name, value, self.parameter(name).kind.check) for name, value in values.items()
        }
        if "material" in plain:
            plain = materials.resolved(plain)
        self._check_for_solver(plain)
        return plain

    def parsed(self, texts: Mapping[str, str]) -> dict[str, Any]:
        """The values that texts stand for. Raises as `checked` does."""
        return {name: converted(name, text, self.parameter(name).kind.parse) for name, text in texts.items()}

    def _check_for_solver(self, values: Mapping[str, Any]) -> None:
        solver = values.get("solver") or next(
            (p.default for p in self.parameters if p.name == "solver"), None
        )
        for name, value in values.items():
            kind = self.parameter(name).kind
            if isinstance(kind, Number) and kind.positive_for_solver == solver and value == kind.minimum:
                raise InvalidParameterError(
                    f"{name} is {value!r}, but must be a finite number, {kind.range_in_words}"
                )


def converted(name: str, value: Any, conversion: Callable[[Any], Any]) -> Any:
    """What the conversion makes of the value. Raises InvalidParameterError where it raises ValueError."""
    try:
        return conversion(value)
    except ValueError as error:
        raise InvalidParameterError(f"{name} is {value!r}, but {error}") from None


def per_cent(text: str) -> float:
    """The number before the % at the end of a text; NaN where there is none."""
    number = _as_number(text.strip().removesuffix("%"))
    return number if isinstance(number, float) and text.strip().endswith("%") else math.nan


def _is_integer(value: Any) -> bool:
    return isinstance(value, numbers.Integral) and not isinstance(value, bool)


def _is_number(value: Any) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, bool)


def _is_finite(value: Any) -> bool:
    return _is_number(value) and math.isfinite(value)


def _as_number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text
