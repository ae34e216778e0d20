# SPDX-License-Identifier: GPL-3.0-or-later
"""A page that shows all the meshes of a batch, the worst first."""

from __future__ import annotations

import collections
import importlib.resources
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from urllib.parse import quote

import jinja2

from meshlab_developable.batch.records import Job, Row, State
from meshlab_developable.writing import written_whole


def write_overview(out: Path, jobs: Sequence[Job], rows: Sequence[Row], scratch: Path, total: int) -> None:
    """Write `overview.html` of those of a total that are finished; the pictures stay in files beside it."""
    template = importlib.resources.files(__package__).joinpath("overview.html.j2").read_text("utf-8")
    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True)
    pairs = sorted(zip(jobs, rows, strict=True), key=lambda pair: badness(pair[1]))
    counts = collections.Counter(row.state for row in rows)
    page = environment.from_string(template).render(
        meshes=[
            (
                row,
                *(_address(out, file) for file in (job.before, job.thumbnail, job.target)),
                _pattern(out, job),
            )
            for job, row in pairs
        ],
        counts=[(state, counts[state]) for state in State if counts[state]],
        total=total,
        left=total - len(rows),
        hints=hints(counts),
        method=jobs[0].settings.method,
        parameters=jobs[0].settings.parameters,
    )
    with written_whole(out / "overview.html", scratch) as path:
        path.write_text(page, encoding="utf-8")


def hints(counts: Mapping[State, int]) -> list[str]:
    """How to go on, by what states there are."""
    said = {
        State.NOT_CONVERGED: "those not converged: cut panels where the message says so (developable cut), "
        "or give them more max_iterations, and start the batch again",
        State.BAD_INPUT: "those with bad input: the message says what is wrong; mend the files, start again",
        State.TIMED_OUT: "those timed out: --again timed_out with a larger --time-limit",
        State.CRASHED: "those crashed: --again crashed, with more --memory-limit where memory was short",
    }
    return [text for state, text in said.items() if counts.get(state)]


def badness(row: Row) -> tuple[int, float, str]:
    """What rows are ordered by: by state, then by what curvature is left."""
    left = float(row.numbers.get("total_absolute_curvature_after", 0.0))
    return list(State).index(row.state), -left, row.input


def _pattern(out: Path, job: Job) -> str | None:
    """The sheet to look at, the first where there are several."""
    sheets = sorted(job.pattern.glob("*.svg")) if job.pattern is not None else []
    return _address(out, sheets[0]) if sheets else None


def _address(out: Path, file: Path | None) -> str | None:
    """Relative to the page; None when there is no such file."""
    return quote(os.path.relpath(file, out)) if file is not None and file.is_file() else None
