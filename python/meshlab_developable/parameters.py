# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters' parameters: what each takes, from Python values and from text, and how a script writes it.

Values are plain Python values (lengths are numbers in the mesh's unit) and checked before a filter runs.
"""

from __future__ import annotations

import abc
import dataclasses
import math
import numbers
from typing import Any

import numpy as np

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
        if not _is_integer(value) or value < 0:
            raise ValueError("must be a whole number, 0 or more")
        return int(value)

    def parse(self, text: str) -> int:
        """Decimal digits."""
        return self.check(int(text) if text.strip().isdecimal() else text)


@dataclasses.dataclass(frozen=True)
class Number(Kind):
    """A finite number, 0 or more."""

    script_type = "RichFloat"

    def check(self, value: Any) -> float:
        """Any kind of real number."""
        if not _is_finite(value) or value < 0:
            raise ValueError("must be a finite number, 0 or more")
        return float(value)

    def parse(self, text: str) -> float:
        """As Python writes numbers."""
        return self.check(_as_number(text))


@dataclasses.dataclass(frozen=True)
class Length(Kind):
    """A length in the mesh's unit, 0 or more; or -1 for the one that suits the mesh, where there is one."""

    automatic: bool = False
    script_type = "RichAbsPerc"

    def check(self, value: Any) -> float:
        """Any kind of real number."""
        if not _is_finite(value) or (value < 0 and not (self.automatic and value == -1)):
            own_choice = ", or -1 for the filter's own choice" if self.automatic else ""
            raise ValueError(f"must be a finite length, 0 or more{own_choice}")
        return float(value)

    def parse(self, text: str) -> float:
        """As Python writes numbers."""
        return self.check(_as_number(text))

    def script_attributes(self, value: Any) -> dict[str, str]:
        """With the range that MeshLab asks for and does not use."""
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
        raise ValueError(f"must be one of {', '.join(map(repr, self.texts))}")

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
class Layer(Kind):
    """A layer, by its number from 0."""

    script_type = "RichMesh"

    def check(self, value: Any) -> int:
        """Any kind of integer."""
        if not _is_integer(value) or value < 0:
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
    help: str  # a sentence


def _is_integer(value: Any) -> bool:
    return isinstance(value, numbers.Integral) and not isinstance(value, bool)


def _is_finite(value: Any) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, bool) and math.isfinite(value)


def _as_number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text
