# SPDX-License-Identifier: GPL-3.0-or-later
"""How each mesh of a batch ended: one file a mesh, written whole as soon as the mesh is finished."""

from __future__ import annotations

import dataclasses
import enum
import hashlib
import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import meshlab_developable
from meshlab_developable.batch.settings import Settings
from meshlab_developable.names import printable


class State(enum.StrEnum):
    """The states that a mesh can end in, the worst first."""

    CRASHED = "crashed"
    TIMED_OUT = "timed_out"
    BAD_INPUT = "bad_input"
    NOT_CONVERGED = "not_converged"
    DONE = "done"


@dataclasses.dataclass(frozen=True)
class Row:
    """What is known of a mesh in the end."""

    input: str
    state: State
    message: str
    numbers: Mapping[str, Any] = dataclasses.field(default_factory=dict)  # as the filter returns them
    panels: Sequence[Mapping[str, Any]] = ()  # the fields of PanelReport

    def __post_init__(self) -> None:
        object.__setattr__(self, "message", printable(self.message))


@dataclasses.dataclass(frozen=True)
class Job:
    """A mesh to work on and where everything about it goes."""

    name: str
    source: Path
    target: Path
    thumbnail: Path
    record: Path
    scratch: Path  # a folder on the same file system, for what is not finished
    settings: Settings
    before: Path | None = None  # the picture of the input
    pattern: Path | None = None  # a folder

    def fingerprint(self) -> str:
        """Tells whether a record is about this mesh as it is now, and about this method."""
        try:
            status = self.source.stat()
            file = [status.st_size, status.st_mtime_ns]
        except OSError:
            file = []
        what = [str(self.source), file, self.settings.method, sorted(self.settings.parameters.items())]
        if self.settings.patterns is not None:
            what.append(sorted(self.settings.patterns.items()))
        text = json.dumps([meshlab_developable.__version__, *what])
        return hashlib.sha256(text.encode()).hexdigest()


def write_record(job: Job, row: Row, fingerprint: str) -> None:
    """Put the row where `read_record` finds it, whole or not at all."""
    content = {"fingerprint": fingerprint, **dataclasses.asdict(row)}
    job.record.parent.mkdir(parents=True, exist_ok=True)
    unfinished = job.scratch / f"{os.getpid()}-{hashlib.sha256(job.name.encode()).hexdigest()[:16]}.json"
    unfinished.write_text(json.dumps(content), encoding="utf-8")
    os.replace(unfinished, job.record)


def read_record(job: Job) -> Row | None:
    """How the mesh ended in an earlier run; None when it did not, or when it or the method has changed."""
    try:
        content = json.loads(job.record.read_text("utf-8"))
        if content.pop("fingerprint") != job.fingerprint():
            return None
        row = Row(
            content["input"],
            State(content["state"]),
            content["message"],
            content["numbers"],
            content["panels"],
        )
    except (OSError, ValueError, KeyError):
        return None
    written = row.state in (State.DONE, State.NOT_CONVERGED)
    return row if job.target.is_file() or not written else None
