# SPDX-License-Identifier: GPL-3.0-or-later
"""A page that shows all the meshes of a batch, the worst first."""

from __future__ import annotations

import collections
import importlib.resources
import os
from collections.abc import Sequence
from pathlib import Path
from urllib.parse import quote

import jinja2

from meshlab_developable.batch.records import Job, Row, State
from meshlab_developable.writing import written_whole


def write_overview(out: Path, jobs: Sequence[Job], rows: Sequence[Row], scratch: Path) -> None:
    """Write `overview.html`; the pictures stay in their files, beside it."""
    template = importlib.resources.files(__package__).joinpath("overview.html.j2").read_text("utf-8")
    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True)
    pairs = sorted(zip(jobs, rows, strict=True), key=lambda pair: badness(pair[1]))
    counts = collections.Counter(row.state for row in rows)
    page = environment.from_string(template).render(
        meshes=[(row, _address(out, job.thumbnail), _address(out, job.target)) for job, row in pairs],
        counts=[(state.replace("_", " "), counts[state]) for state in State if counts[state]],
        total=len(rows),
        method=jobs[0].settings.method,
        parameters=jobs[0].settings.parameters,
    )
    with written_whole(out / "overview.html", scratch) as path:
        path.write_text(page, encoding="utf-8")


def badness(row: Row) -> tuple[int, float, str]:
    """What rows are ordered by: by state, then by what curvature is left."""
    left = float(row.numbers.get("total_absolute_curvature_after", 0.0))
    return list(State).index(row.state), -left, row.input


def _address(out: Path, file: Path) -> str | None:
    """Relative to the page; None when there is no such file."""
    return quote(os.path.relpath(file, out)) if file.is_file() else None
