# SPDX-License-Identifier: GPL-3.0-or-later
"""How many faces a file says it has, without reading them: hosts leave out what they do not understand."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import IO

MOST_HEADER_LINES = 1000


def declared_faces(path: Path) -> int | None:
    """The number of faces, polygons counted once; None where the format or the file does not say."""
    count = {".obj": _in_obj, ".off": _in_off, ".ply": _in_ply}.get(path.suffix.lower())
    if count is None:
        return None
    try:
        with path.open("rb") as file:
            return count(file)
    except (OSError, ValueError, IndexError):
        return None


def _in_obj(file: IO[bytes]) -> int:
    return sum(line.lstrip().startswith((b"f ", b"f\t")) for line in file)


def _in_off(file: IO[bytes]) -> int | None:
    words = list(islice(_words(file), 3))
    counts = words if words[0].isdigit() else words[1:]
    return int(counts[1])


def _in_ply(file: IO[bytes]) -> int | None:
    for line in islice(file, MOST_HEADER_LINES):
        words = line.split()
        if words[:2] == [b"element", b"face"]:
            return int(words[2])
        if words == [b"end_header"]:
            break
    return None


def _words(file: IO[bytes]) -> Iterator[bytes]:
    for line in islice(file, MOST_HEADER_LINES):
        yield from line.split(b"#", 1)[0].split()
