# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials: the plugin's table, and files of one's own in the same form.

`materials.json` is a copy of the plugin's table that `generate_filters.py` writes. A file of one's own has
the same form: a list `materials` of entries with `name`, `stretch` and `compression` in per cent, and
`source`.
"""

from __future__ import annotations

import difflib
import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from meshlab_developable.errors import InvalidParameterError

TABLE = Path(__file__).with_name("materials.json")


def materials(path: str | Path = TABLE) -> dict[str, dict[str, Any]]:
    """The entries of a table by their names.

    Raises InvalidParameterError for a file that is none, and for an entry without a source.
    """
    try:
        content = json.loads(Path(path).read_text(encoding="utf-8"))
        entries = {entry["name"]: entry for entry in content["materials"]}
    except OSError as error:
        raise InvalidParameterError(
            f"the table of materials {path} can't be read: {error.strerror}"
        ) from None
    except (ValueError, KeyError, TypeError):
        raise InvalidParameterError(
            f"{path} is no table of materials: it has to be JSON with a list 'materials' of entries with a "
            "'name', 'stretch' and 'compression' in per cent, and a 'source'"
        ) from None
    for name, entry in entries.items():
        if not entry.get("source"):
            raise InvalidParameterError(f"the material {name!r} in {path} says no 'source' of its numbers")
    return entries


def resolved(parameters: Mapping[str, Any]) -> dict[str, Any]:
    """The parameters, with the bounds of an own file's material in place of its name.

    `material` may be `FILE.json#NAME`, or `FILE.json` where that has one entry only. Bounds that are given
    beside it go before those of the file. Raises InvalidParameterError.
    """
    chosen = parameters.get("material")
    if not isinstance(chosen, str | Path) or ".json" not in str(chosen):
        return dict(parameters)
    path, _, name = str(chosen).partition("#")
    entries = materials(path)
    if not name and len(entries) == 1:
        name = next(iter(entries))
    if name not in entries:
        near = difflib.get_close_matches(name, entries, n=1, cutoff=0.4)
        hint = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(map(repr, entries))}"
        raise InvalidParameterError(f"{path} has no material {name!r}; {hint}")
    values = dict(parameters) | {"material": "Custom"}
    for key in ("stretch", "compression"):
        if values.get(f"allowed_{key}", -1.0) == -1.0:
            values[f"allowed_{key}"] = _bound(entries[name], key, path)
    return values


def greatest_edge_strain(parameters: Mapping[str, Any]) -> float:
    """By how much an edge of a pattern within its bounds may differ from the model's, per cent of that.

    An edge that is shorter on the model by c of its pattern's length is longer in the pattern by c / (1 - c)
    of the model's; one that is stretched by s is shorter by s / (1 + s).
    """
    values = resolved(parameters)
    entry = materials().get(str(values.get("material", "Custom")), {})
    strains = [0.0]
    for key, sign in (("stretch", 1), ("compression", -1)):
        bound = values.get(f"allowed_{key}", -1.0)
        own = entry.get(key, 0.0)
        if bound == -1.0:
            bounds = [*own.values()] if isinstance(own, Mapping) else [own]
        else:
            bounds = [bound] if isinstance(bound, int | float) and math.isfinite(bound) else []
        strains += [100 * bound / (100 + sign * bound) for bound in bounds if 0 < bound < 100 or sign > 0]
    return float(max(strains))


def grain_along(direction: Sequence[float], material: str) -> str:
    """The choice of the filters' `grain` for a direction on the model.

    Only materials whose directions differ look at it. Raises InvalidParameterError for one of those with a
    direction that is no axis.
    """
    along = [axis for axis, part in zip("XYZ", direction, strict=True) if part != 0]
    if len(along) == 1:
        return f"{along[0]} axis"
    entry = materials().get(material, {})
    if any(isinstance(entry.get(key), Mapping) for key in ("stretch", "compression")):
        raise InvalidParameterError(
            f"{material} bears more in one direction than in another, so its grain has to run along x, y or "
            "z, or along the longest seam"
        )
    return "Longest seam"


def _bound(entry: Mapping[str, Any], key: str, path: str) -> float:
    """One bound of an entry, per cent."""
    value = entry.get(key)
    if isinstance(value, Mapping):
        raise InvalidParameterError(
            f"the material {entry['name']!r} in {path} has a {key} for each direction, which only the "
            "plugin's own materials can have: give it one number"
        )
    if isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < math.inf:
        return float(value)
    raise InvalidParameterError(
        f"the {key} of the material {entry['name']!r} in {path} is {value!r}, but must be a number of per "
        "cent, 0 or more"
    )
