# SPDX-License-Identifier: GPL-3.0-or-later
"""What `developable global` and `developable local` have in common."""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from meshlab_developable.command_line.progress import progress_shown
from meshlab_developable.command_line.shared import (
    MESH,
    Exit,
    errors_in_words,
    filter_options,
    given,
    json_option,
    print_json,
    print_table,
)
from meshlab_developable.filters import Filter


def optimization_command(applied: Filter, explanation: str) -> click.Command:
    """The command that applies a filter to a file and writes the result to another."""

    def run(mesh: Path, output: Path, as_json: bool, quiet: bool, **options: Any) -> None:
        from meshlab_developable.file_methods import develop_file

        with errors_in_words(as_json), progress_shown(applied.title, quiet or as_json) as shown:
            report = develop_file(mesh, output, applied.name, verbose=shown, **given(options))
        values = dataclasses.asdict(report) | {"status": report.status.name.lower()}
        if as_json:
            words = {"input": str(mesh), "output": str(output), "message": report.status.text}
            print_json(words | values)
        else:
            print_table(f"{output}: {report.status.text}", values)
        sys.exit(Exit.DONE if report.developable else Exit.NOT_CONVERGED)

    run.__doc__ = explanation
    decorators: list[Callable[[Any], Any]] = [
        click.command(name=applied.name),
        click.argument("mesh", type=MESH),
        click.option(
            "-o", "--output", required=True, type=click.Path(path_type=Path), help="The file to write."
        ),
        filter_options(applied),
        json_option,
        click.option("-q", "--quiet", is_flag=True, help="No progress bar."),
    ]
    command: Any = run
    for decorate in reversed(decorators):
        command = decorate(command)
    made: click.Command = command
    return made
