# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable measure`: how developable meshes are."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import click

from meshlab_developable.command_line import shared
from meshlab_developable.errors import InvalidParameterError
from meshlab_developable.filters import MAPS


@click.command(name="measure")
@click.argument("meshes", nargs=-1, required=True, type=shared.MESH)
@shared.output_option("Write the mesh with the map in it.", required=False)
@shared.filter_options(MAPS, without=["reference"])
@click.option(
    "--reference", type=shared.MESH, help="The mesh that Distance and Displacement are measured to."
)
@shared.json_option
def command(
    meshes: tuple[Path, ...], output: Path | None, reference: Path | None, as_json: bool, **options: Any
) -> None:
    """Say how developable each mesh is.

    D is the share of the area that is developable within the angle tolerance, G the sum of squared angle
    defects, C the total absolute curvature, the sum of their absolute values. Judge a fine mesh by C.

    \b
    Examples:
      developable measure panel.ply
      developable measure *.obj --angle-tolerance 0.01 --json
      developable measure panel.ply --map "Angle defect" --output coloured.ply
    """
    from meshlab_developable.file_methods import measure_file

    with shared.errors_in_words(as_json):
        if output and len(meshes) > 1:
            raise InvalidParameterError("--output takes one mesh at a time")
        results = []
        for path in meshes:
            measures = measure_file(path, output, reference, **shared.given(options))
            results.append({"input": str(path), **dataclasses.asdict(measures)})
            if not as_json:
                shared.print_table(str(path), dataclasses.asdict(measures))
    if as_json:
        shared.print_json(results[0] if len(results) == 1 else results)
