# SPDX-License-Identifier: GPL-3.0-or-later
"""How many faces a file says it has, without reading them: hosts leave out what they do not understand."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import IO

from meshlab_developable.errors import InvalidMeshError

MOST_HEADER_LINES = 1000
_VERTEX_ZERO = re.compile(rb"[ \t]0+(?=[\s/]|$)")


def declared_faces(path: Path) -> int | None:
    """The number of faces, polygons counted once; None where the format or the file does not say.

    Raises InvalidMeshError for vertices numbered 0 in an OBJ, with which the host overwrites its own memory.
    """
    count = {".obj": _in_obj, ".off": _in_off, ".ply": _in_ply}.get(path.suffix.lower())
    if count is None:
        return None
    try:
        with path.open("rb") as file:
            return count(file)
    except InvalidMeshError:
        raise
    except (OSError, ValueError, IndexError):
        return None


def _in_obj(file: IO[bytes]) -> int:
    faces = wrong = 0
    for line in file:
        if line.startswith((b"f ", b"f\t")):
            faces += 1
            # The search of bytes is quick, and seldom finds anything.
            wrong += (b" 0" in line or b"\t0" in line) and _VERTEX_ZERO.search(line) is not None
    if wrong:
        raise InvalidMeshError(f"{wrong} faces name vertex 0, but an OBJ counts from 1; write it anew")
    return faces


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
