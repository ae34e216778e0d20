# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials: the plugin's table, and files of one's own in the same form.

`materials.json` is a copy of the plugin's table that `generate_filters.py` writes. A file of one's own has
the same form: a list `materials` of entries with `name`, `stretch` and `compression` in per cent, each one
number or a table with `warp`, `weft` and `bias`, and `source`; and, where they are known, `elastic_strain`
(per cent, that the surface bears without a set), `thickness` (mm) and `smoothness`.
"""

from __future__ import annotations

import contextlib
import difflib
import json
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

from meshlab_developable.errors import InvalidParameterError

Entry: TypeAlias = Mapping[str, Any]
Direction: TypeAlias = tuple[float, float, float]

TABLE = Path(__file__).with_name("materials.json")
OF_THE_USER = "DEVELOPABLE_MATERIAL"  # the plugin takes the entry in this variable for `Custom`
GRAIN_OF_THE_USER = "DEVELOPABLE_GRAIN"  # and the direction in this one for `Longest seam`
DIRECTIONS = ("warp", "weft", "bias")
GRAIN_AXES = {"X axis": (1.0, 0.0, 0.0), "Y axis": (0.0, 1.0, 0.0), "Z axis": (0.0, 0.0, 1.0)}
BOUNDS = {"stretch": 1000.0, "compression": 100.0}  # per cent, with the most there can be
OTHER_NUMBERS = {"elastic_strain": 100.0, "thickness": math.inf, "smoothness": 1.0}


def materials(path: str | Path = TABLE) -> dict[str, dict[str, Any]]:
    """The entries of a table by their names.

    Raises InvalidParameterError for a file that is none, and for an entry that is none.
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
    for entry in entries.values():
        require_valid(entry, f" in {path}")
    return entries


def require_valid(entry: Entry, place: str = "") -> None:
    """Raises InvalidParameterError for an entry with a number that can't be, or without a source.

    place: where it is from, for the message.
    """
    name = f"material {entry.get('name')!r}{place}"
    known = ["name", "source", *BOUNDS, *OTHER_NUMBERS]
    for key in entry:
        if key not in known:
            near = difflib.get_close_matches(key, known, n=1)
            hint = f"did you mean {near[0]!r}?" if near else f"it can have {', '.join(known)}"
            raise InvalidParameterError(f"the {name} has an unknown {key!r}; {hint}")
    if not (isinstance(entry.get("name"), str) and entry["name"]):
        raise InvalidParameterError(f"the {name} has to have a 'name'")
    if not (isinstance(entry.get("source"), str) and entry["source"]):
        raise InvalidParameterError(f"the {name} says no 'source' of its numbers")
    for key, most in BOUNDS.items():
        bound = entry.get(key)
        if isinstance(bound, Mapping) and set(bound) != set(DIRECTIONS):
            raise InvalidParameterError(
                f"the {key} of the {name} has {', '.join(bound)}, but must be one number, or have "
                f"{', '.join(DIRECTIONS)}"
            )
        for value in bound.values() if isinstance(bound, Mapping) else [bound]:
            _require_number(value, f"the {key} of the {name}", most)
    for key, most in OTHER_NUMBERS.items():
        if key in entry:
            _require_number(entry[key], f"the {key} of the {name}", most)


def resolved(parameters: Mapping[str, Any]) -> dict[str, Any]:
    """The parameters, with the entry of an own file in place of its name.

    `material` may be `FILE.json#NAME`, or `FILE.json` where that has one entry only, or an entry itself.
    Raises InvalidParameterError.
    """
    chosen = parameters.get("material")
    if isinstance(chosen, Mapping):
        require_valid(chosen)
        return dict(parameters) | {"material": dict(chosen)}
    if not is_own_file(chosen):
        return dict(parameters)
    path, _, name = (str(chosen), "", "") if str(chosen).endswith(".json") else str(chosen).rpartition("#")
    entries = materials(path)
    if not name and len(entries) == 1:
        name = next(iter(entries))
    if name not in entries:
        near = difflib.get_close_matches(name, entries, n=1, cutoff=0.4)
        hint = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(map(repr, entries))}"
        raise InvalidParameterError(f"{path} has no material {name!r}; {hint}")
    return dict(parameters) | {"material": entries[name]}


def is_own_file(material: Any) -> bool:
    """Whether this says a file of one's own, and maybe a name in it."""
    return isinstance(material, str | Path) and ".json" in str(material)


@contextlib.contextmanager
def handed_over(values: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Resolved parameters as filters take them: with `Custom` for an entry of one's own, which that is
    meanwhile, and `Longest seam` for a direction of one's own alike.
    """
    taken, variables = dict(values), {}
    if isinstance(taken.get("material"), Mapping):
        variables[OF_THE_USER] = json.dumps(taken["material"])
        taken["material"] = "Custom"
    if _own_direction(values):
        variables[GRAIN_OF_THE_USER] = json.dumps(taken["grain"])
        taken["grain"] = "Longest seam"
    before = {name: os.environ.get(name) for name in variables}
    os.environ.update(variables)
    try:
        yield taken
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def as_numbers(values: Mapping[str, Any]) -> dict[str, Any]:
    """Resolved parameters with the bounds of an own entry as numbers, as a stored script can hold them.

    Bounds that are given beside it go before its own. Raises InvalidParameterError where they differ with the
    direction, and for a grain that is a direction of one's own.
    """
    if _own_direction(values):
        raise InvalidParameterError(
            f"a script can't hold the grain {values['grain']}, which is none of the filters' choices: apply "
            "the filter from Python or the command line"
        )
    entry = values.get("material")
    if not isinstance(entry, Mapping):
        return dict(values)
    if any(isinstance(entry[key], Mapping) for key in BOUNDS):
        raise InvalidParameterError(
            f"a script can't hold the bounds of {entry['name']!r}, which differ with the direction: apply "
            "the filter from Python or the command line"
        )
    numbers = dict(values) | {"material": "Custom"}
    for key in BOUNDS:
        if values.get(f"allowed_{key}", -1.0) == -1.0:
            numbers[f"allowed_{key}"] = float(entry[key])
    return numbers


def chosen_entry(material: Any) -> Entry:
    """Of a preset, or of one's own; without a material, or with one that there is not, empty."""
    chosen = resolved({"material": material})["material"]
    return chosen if isinstance(chosen, Mapping) else materials().get(str(chosen), {})


def greatest_edge_strain(parameters: Mapping[str, Any]) -> float:
    """By how much an edge of a pattern within its bounds may differ from the model's, per cent of that.

    An edge that is as long on the model as in the pattern times λ differs by |1 / λ − 1| of the model's. λ is
    between the singular values of its triangle's map. Where a sign's bounds differ they may be beyond all
    three: where warp and weft are stretched and compressed, what the bias bears comes on top of that.
    """
    entry = chosen_entry(parameters.get("material"))
    limits = []
    for key, sign in (("compression", -1), ("stretch", 1)):
        bound = parameters.get(f"allowed_{key}", -1.0)
        own = entry.get(key, 0.0) if bound == -1.0 else bound
        of_directions = [own[name] for name in DIRECTIONS] if isinstance(own, Mapping) else [own] * 3
        if not all(isinstance(value, int | float) and 0 <= value <= BOUNDS[key] for value in of_directions):
            return 0.0  # which the filter refuses
        limits.append([(1 + sign * value / 100) ** 2 for value in of_directions])
    least, greatest = _extreme_squares(*limits)
    longer = 1 / math.sqrt(least) - 1 if least > 0 else 0.0
    return 100 * max(longer, 1 - 1 / math.sqrt(greatest))


def _extreme_squares(lows: Sequence[float], highs: Sequence[float]) -> tuple[float, float]:
    """The least and the greatest square of a singular value of F, from the limits of |F v|² along warp, weft
    and both biases. Limits that are alike for these hold in every direction."""
    if len(set(lows)) == len(set(highs)) == 1:
        return lows[0], highs[0]
    if len(set(lows)) == 1:
        return lows[0], lows[0] + _farthest([high - lows[0] for high in highs])
    if len(set(highs)) == 1:
        return highs[0] - _farthest([highs[0] - low for low in lows]), highs[0]
    return _extreme_squares_of_directions(lows, highs)


def _farthest(distances: Sequence[float]) -> float:
    """By how much the square of one singular value may differ from the other's, which is at its limit, where
    squares along warp, weft and bias may differ by so much from that.

    Where its direction is at the angle φ to the warp, the share of the difference is cos² φ along the warp,
    sin² φ along the weft and (1 + sin 2φ) / 2 along a bias. It is greatest at an end or where two limits
    meet.
    """
    warp, weft, bias = (math.sqrt(distance) for distance in (distances[0], distances[1], 2 * distances[2]))
    meeting = [(1.0, 0.0), (0.0, 1.0), (warp, weft), (warp, bias - warp), (bias - weft, weft)]
    greatest = 0.0
    for cosine, sine in meeting:
        length = math.hypot(cosine, sine)
        if length == 0 or min(cosine, sine) < 0:
            continue
        shares = (cosine**2, sine**2, (cosine + sine) ** 2 / 2)
        allowed = [d * length**2 / share for d, share in zip(distances, shares, strict=True) if share > 0]
        greatest = max(greatest, min(allowed))
    return greatest


def _extreme_squares_of_directions(lows: Sequence[float], highs: Sequence[float]) -> tuple[float, float]:
    """The same where limits hold along warp, weft and both biases alone.

    With a = |F warp|², b = |F weft|² and c = warp · FᵀF weft it is (a + b) / 2 ± √((a − b)² / 4 + c²), and
    the biases' are (a + b) / 2 ± c. So the extremes are at corners of what a, b and c may be.
    """
    least, greatest = min(lows), max(highs)
    (low_a, low_b, low), (high_a, high_b, high) = lows, highs
    corners = [(a, b) for a in (low_a, high_a) for b in (low_b, high_b)]
    corners += [(a, low + high - a) for a in (low_a, high_a)]  # where c may be largest
    corners += [(low + high - b, b) for b in (low_b, high_b)]
    for a, b in corners:
        shear = min(high - (a + b) / 2, (a + b) / 2 - low)
        if shear >= 0 and low_a <= a <= high_a and low_b <= b <= high_b:
            radius = math.hypot((a - b) / 2, shear)
            least = min(least, (a + b) / 2 - radius)
            greatest = max(greatest, (a + b) / 2 + radius)
    return least, greatest


def grain_along(direction: Sequence[float]) -> str | Direction:
    """The value of `grain` for a direction on the model: the filters' choice for an axis, else itself.

    Which way along it is no matter. Raises ValueError for what is no direction.
    """
    if len(direction) != 3 or not all(map(math.isfinite, direction)) or not any(direction):
        raise ValueError("a direction must be three finite numbers, and not all of them 0")
    along = [axis for axis, part in zip(GRAIN_AXES, direction, strict=True) if part != 0]
    return along[0] if len(along) == 1 else (float(direction[0]), float(direction[1]), float(direction[2]))


def grain_direction(values: Mapping[str, Any]) -> Direction | None:
    """The direction on the model that checked parameters have for the grain; None along seams."""
    own = _own_direction(values)
    return own if own else GRAIN_AXES.get(values.get("grain", ""))


def _own_direction(values: Mapping[str, Any]) -> Direction | None:
    """That of `grain` where it is none of the filters' choices."""
    grain = values.get("grain", "")
    return None if isinstance(grain, str) else (grain[0], grain[1], grain[2])


def _require_number(value: Any, what: str, most: float) -> None:
    number = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
    if number and 0 <= value <= most:
        return
    limit = f" and at most {most:g}" if most < math.inf else ""
    raise InvalidParameterError(f"{what} is {value!r}, but must be a number, 0 or more{limit}")
