# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable cut`: cuts a surface into panels."""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path
from typing import Any

import click

from meshlab_developable.command_line import shared
from meshlab_developable.command_line.progress import progress_shown
from meshlab_developable.filters import CUT


@click.command(name="cut")
@click.argument("mesh", type=shared.MESH)
@shared.output_option("The file to write.")
@shared.filter_options(CUT)
@shared.json_option
@shared.quiet_option
def command(mesh: Path, output: Path, as_json: bool, quiet: bool, **options: Any) -> None:
    """Cut a surface, open or closed, into few panels that can be made developable.

    Nothing is moved: vertices along seams and darts are doubled, and faces coloured by panel. Go on with
    `developable global`, and `developable pattern`; or do all of it with `developable pattern --cut`. Ends
    with 3 when a panel can't be made developable within the largest displacement; it is written all the same.

    \b
    Examples:
      developable cut scan.ply --output panels.ply
      developable cut toy.obj -o panels.ply --max-displacement 1% --no-darts
      developable cut seat.ply -o panels.ply --max-panels 6 --json
    """
    from meshlab_developable.cutting import cut_file

    with shared.errors_in_words(as_json), progress_shown(CUT.title, quiet or as_json) as shown:
        report = cut_file(mesh, output, verbose=shown, **shared.given(options))
    values = dataclasses.asdict(report) | {"status": report.status.name.lower()}
    panels = values.pop("panels")
    values = {"panels": len(panels)} | values
    words = {"input": mesh, "output": output, "message": report.status.text}
    if as_json:
        words["per_panel"] = [panel | {"status": panel["status"].name.lower()} for panel in panels]
    shared.print_result(as_json, f"{output}: {report.status.text}", values, **words)
    if not as_json:
        for panel in panels:
            click.echo(f"  panel {panel['index']}: {panel['reason']}")
    sys.exit(shared.Exit.DONE if report.developable else shared.Exit.NOT_CONVERGED)
