# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable script`: a MeshLab script that applies a filter."""

from __future__ import annotations

from pathlib import Path

import click

from meshlab_developable.command_line import shared
from meshlab_developable.filters import FILTERS, find_filter

NAMES = [known.name for known in FILTERS]


def complete_filter(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """For the shell: the filters."""
    return [name for name in NAMES if name.startswith(incomplete)]


def complete_parameter(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """For the shell: the parameters of the filter named before."""
    name = ctx.params.get("filter_name")
    if name not in NAMES:
        return []
    texts = [f"{parameter.name}=" for parameter in find_filter(name).parameters]
    return [text for text in texts if text.startswith(incomplete)]


@click.command(name="script")
@click.argument("filter_name", metavar="FILTER", shell_complete=complete_filter)
@click.argument("values", metavar="[NAME=VALUE]...", nargs=-1, shell_complete=complete_parameter)
@shared.output_option("The file to write, not the terminal.", required=False)
def command(filter_name: str, values: tuple[str, ...], output: Path | None) -> None:
    """Write a MeshLab script (.mlx) that applies FILTER.

    FILTER is global, local, maps, flatten, cut, restore or triangulate.

    The script has every parameter, those not named at their defaults, and runs in meshlabserver 2020.09, in
    later MeshLabs and in pymeshlab.

    \b
    Examples:
      developable script global --output global.mlx
      developable script local angle_tolerance=0.01 descent=true map="Angle defect" -o local.mlx
      meshlabserver -i panel.ply -o out.ply -m vq vc -s global.mlx
    """
    from meshlab_developable.scripts import script_text
    from meshlab_developable.writing import written_whole

    with shared.errors_in_words():
        applied = find_filter(filter_name)
        text = script_text(applied, applied.parsed(shared.assignments(values)))
        if output is None:
            click.echo(text, nl=False)
            return
        with written_whole(output) as path:
            path.write_text(text, encoding="utf-8")
