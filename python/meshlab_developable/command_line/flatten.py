# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable flatten`: lays panels flat."""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path
from typing import Any

import click

from meshlab_developable.command_line import shared
from meshlab_developable.command_line.progress import progress_shown
from meshlab_developable.filters import FLATTEN


@click.command(name="flatten")
@click.argument("mesh", type=shared.MESH)
@shared.output_option("The file for the flat pieces.")
@click.option(
    "--textured",
    type=click.Path(path_type=Path),
    help="Also write the mesh, with the flat pieces as its texture coordinates.",
)
@shared.filter_options(FLATTEN, without=["write_texture_coordinates"])
@shared.json_option
@shared.quiet_option
def command(
    mesh: Path, output: Path, textured: Path | None, as_json: bool, quiet: bool, **options: Any
) -> None:
    """Lay every panel flat, at true scale, with edges as long as they are on the mesh or nearly.

    The pieces are one mesh in the plane z = 0, their faces in the order of the mesh's. For files to print and
    cut, see `developable pattern`. Ends with 3 when a piece overlaps itself or another, or has flipped faces;
    it is written all the same.

    \b
    Examples:
      developable flatten panel.ply --output flat.ply
      developable flatten scan.obj -o flat.ply --patches "Texture islands" --json
      developable flatten panel.obj -o flat.obj --textured textured.obj
    """
    from meshlab_developable.file_methods import flatten_file

    with shared.errors_in_words(as_json), progress_shown(FLATTEN.title, quiet or as_json) as shown:
        flat = flatten_file(mesh, output, textured, verbose=shown, **shared.given(options))
    values = dataclasses.asdict(flat.report) | {"seams": len(flat.seams)}
    shared.print_result(as_json, str(output), values, input=mesh, output=output)
    sound = flat.report.overlapping_pieces == flat.report.flipped_faces == 0
    sys.exit(shared.Exit.DONE if sound else shared.Exit.NOT_CONVERGED)
