# SPDX-License-Identifier: GPL-3.0-or-later
"""What a batch does with each mesh, as a TOML file says it; every key is checked."""

from __future__ import annotations

import dataclasses
import difflib
import math
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from meshlab_developable.errors import InvalidParameterError
from meshlab_developable.methods import METHODS


@dataclasses.dataclass(frozen=True)
class Settings:
    """One method and one set of parameters for all meshes, and what each mesh may cost."""

    method: str = "global"
    parameters: Mapping[str, Any] = dataclasses.field(default_factory=dict)  # of the method's filter
    time_limit: float = 3600.0  # seconds a mesh
    memory_limit: float = 4096.0  # MB a mesh
    patterns: Mapping[str, Any] | None = None  # options of `make_patterns`, which is to write each mesh's

    def __post_init__(self) -> None:
        if self.method not in METHODS:
            raise InvalidParameterError(
                f"method is {self.method!r}, but must be one of {', '.join(map(repr, METHODS))}"
            )
        if not isinstance(self.parameters, Mapping):
            raise InvalidParameterError("parameters must be a table of names and values")
        object.__setattr__(self, "parameters", METHODS[self.method][0].checked(self.parameters))
        if self.patterns is not None:
            _require_patterns(self.patterns)
        for name in ("time_limit", "memory_limit"):
            value = getattr(self, name)
            number = isinstance(value, (int, float)) and not isinstance(value, bool)
            if not number or not math.isfinite(value) or value <= 0:
                raise InvalidParameterError(f"{name} is {value!r}, but must be a finite number above 0")

    @classmethod
    def from_values(cls, values: Mapping[str, Any]) -> Settings:
        """From a table of keys. Raises InvalidParameterError for an unknown key or a wrong value."""
        known = [field.name for field in dataclasses.fields(cls)]
        for name in values:
            if name not in known:
                near = difflib.get_close_matches(name, known, n=1)
                hint = f"did you mean {near[0]!r}?" if near else f"there are {', '.join(known)}."
                raise InvalidParameterError(f"there is no key {name!r}; {hint}")
        return cls(**values)


def _require_patterns(options: Any) -> None:
    from meshlab_developable.patterns import PatternOptions

    if not isinstance(options, Mapping) or "unit" not in options:
        raise InvalidParameterError(
            "patterns must be a table with the unit of the meshes, such as unit = 'cm'"
        )
    known = [field.name for field in dataclasses.fields(PatternOptions)]
    unknown = sorted(set(options) - set(known))
    if unknown:
        raise InvalidParameterError(f"patterns has {', '.join(unknown)}; there are {', '.join(known)}")
    PatternOptions(**options)


def read_settings(path: Path) -> Settings:
    """From a TOML file. Raises InvalidParameterError, which names the file."""
    try:
        return Settings.from_values(tomllib.loads(path.read_text("utf-8")))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError, InvalidParameterError) as error:
        raise InvalidParameterError(f"{path}: {error}") from None
