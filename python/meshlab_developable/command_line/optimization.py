# SPDX-License-Identifier: GPL-3.0-or-later
"""What `developable global` and `developable local` have in common."""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from meshlab_developable.command_line import shared
from meshlab_developable.command_line.progress import progress_shown
from meshlab_developable.filters import Filter


def optimization_command(applied: Filter, explanation: str) -> click.Command:
    """The command that applies a filter to a file and writes the result to another."""

    def run(mesh: Path, output: Path, as_json: bool, quiet: bool, **options: Any) -> None:
        from meshlab_developable.file_methods import develop_file

        with shared.errors_in_words(as_json), progress_shown(applied.title, quiet or as_json) as shown:
            report = develop_file(mesh, output, applied.name, verbose=shown, **shared.given(options))
        values = dataclasses.asdict(report) | {"status": report.status.name.lower()}
        said = values.pop("reason")
        warnings = values.pop("warnings")
        of_material = values.pop("material_verdict")
        panels = values.pop("panels")
        if as_json:
            for panel in panels:
                panel["status"] = panel["status"].name.lower()
            values["panels"] = panels
        words = {"input": mesh, "output": output, "message": said, "warnings": warnings}
        words["material_verdict"] = of_material
        heading = f"{output}: {said}\n{of_material}" if of_material else f"{output}: {said}"
        shared.print_result(as_json, heading, values, **words)
        for warning in () if as_json else warnings:
            click.echo(f"warning: {warning}", err=True)
        sys.exit(shared.Exit.DONE if report.developable else shared.Exit.NOT_CONVERGED)

    run.__doc__ = explanation
    decorators: list[Callable[[Any], Any]] = [
        click.command(name=applied.name),
        click.argument("mesh", type=shared.MESH),
        shared.output_option("The file to write."),
        shared.filter_options(applied),
        shared.json_option,
        shared.quiet_option,
    ]
    command: Any = run
    for decorate in reversed(decorators):
        command = decorate(command)
    made: click.Command = command
    return made
