# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable batch`: every mesh of a folder or of a list."""

from __future__ import annotations

import collections
import dataclasses
import sys
from pathlib import Path
from typing import Any

import click

from meshlab_developable.command_line import shared
from meshlab_developable.errors import InvalidParameterError
from meshlab_developable.names import printable

STATES = ["not_converged", "bad_input", "crashed", "timed_out"]


def _unit(text: str) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text


@click.command(name="batch")
@click.argument("source", metavar="FOLDER|LIST", type=click.Path(exists=True, path_type=Path))
@click.option(
    "-o",
    "--output",
    "--out",
    "out",
    required=True,
    type=click.Path(file_okay=False, path_type=Path),
    help="The folder to write to.",
)
@click.option(
    "--parameters",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="A TOML file: method, time_limit, memory_limit, and a table [parameters].",
)
@click.option("--method", type=click.Choice(["global", "local"]), help="The method  [default: global]")
@click.option("--time-limit", type=float, help="Seconds a mesh may take  [default: 3600]")
@click.option("--memory-limit", type=float, help="Megabytes a mesh may take  [default: 4096]")
@click.option("--scheduler", metavar="ADDRESS", help="A Dask scheduler to use, as tcp://host:8786.")
@click.option("--workers", type=click.IntRange(min=1), help="How many meshes at once  [default: all cores]")
@click.option(
    "--again", multiple=True, type=click.Choice(STATES), help="Work again on meshes that ended so before."
)
@click.option(
    "--patterns", "with_patterns", is_flag=True, help="Write each mesh's pattern too; needs --unit."
)
@click.option("--unit", help="What a unit of the meshes is: mm, cm, dm, m, in, ft, or how many mm.")
@shared.json_option
@shared.quiet_option
def command(
    source: Path,
    out: Path,
    parameters: Path | None,
    scheduler: str | None,
    workers: int | None,
    again: tuple[str, ...],
    with_patterns: bool,
    unit: str | None,
    as_json: bool,
    quiet: bool,
    **changes: Any,
) -> None:
    """Make every mesh of FOLDER, or of LIST with a path a line, more developable.

    Writes results.parquet, results.csv, overview.html, and the meshes. Each mesh ends as done, not_converged,
    bad_input, crashed or timed_out, and costs no other mesh anything. A run that was stopped goes on where it
    was when it is started again. Ends with 0 when all meshes are done, and with 4 when some are not.

    \b
    A file of parameters:
      method = "global"
      time_limit = 600        # seconds a mesh
      memory_limit = 2000     # MB a mesh
      [parameters]            # of the method, as `developable global --help` has them
      fix_boundary = true

    \b
    Examples:
      developable batch panels --out results
      developable batch panels --out results --patterns --unit cm
      developable batch list.txt --out results --parameters settings.toml --time-limit 60
      developable batch panels --out results --scheduler tcp://10.0.0.5:8786
      developable batch panels --out results --again timed_out --time-limit 7200
    """
    from meshlab_developable.batch.inputs import find_inputs
    from meshlab_developable.batch.overview import hints
    from meshlab_developable.batch.records import Row, State
    from meshlab_developable.batch.run import run
    from meshlab_developable.batch.settings import Settings, read_settings

    with shared.errors_in_words(as_json):
        settings = read_settings(parameters) if parameters else Settings()
        settings = dataclasses.replace(settings, **{k: v for k, v in changes.items() if v is not None})
        if with_patterns:
            options = dict(settings.patterns or {})
            options |= {} if unit is None else {"unit": _unit(unit)}
            if "unit" not in options:
                raise InvalidParameterError(
                    "meshes do not say their unit: give it with --unit, such as --unit cm"
                )
            settings = dataclasses.replace(settings, patterns=options)
        inputs = find_inputs(source, out)
        shown = not quiet and not as_json
        hidden = not shown or not sys.stderr.isatty()
        counts: collections.Counter[State] = collections.Counter()
        with click.progressbar(
            length=len(inputs), label=f"{len(inputs)} meshes", file=sys.stderr, hidden=hidden, show_pos=True
        ) as bar:

            def finished(row: Row) -> None:
                counts[row.state] += 1
                bar.update(1)
                if shown and hidden:
                    said = f"{sum(counts.values())}/{len(inputs)} {row.input}: {row.state}: {row.message}"
                    click.echo(printable(said), err=True)

            run(
                inputs,
                out,
                settings,
                scheduler=scheduler,
                workers=workers,
                again=[State(state) for state in again],
                finished=finished,
            )
    states = {str(state): counts[state] for state in reversed(State)}
    if as_json:
        shared.print_json({"out": str(out), "meshes": len(inputs), **states})
    else:
        said = ", ".join(f"{count} {state}" for state, count in states.items() if count)
        click.echo(f"{len(inputs)} meshes: {said}. See {out / 'overview.html'} and {out / 'results.csv'}")
        for hint in hints(counts):
            click.echo(f"  {hint}")
    sys.exit(shared.Exit.DONE if counts[State.DONE] == len(inputs) else shared.Exit.SOME_NOT_DONE)
