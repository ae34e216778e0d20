# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable flatten`: lays panels flat."""

from __future__ import annotations

import dataclasses
import sys
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
from meshlab_developable.filters import FLATTEN


@click.command(name="flatten")
@click.argument("mesh", type=MESH)
@click.option(
    "-o", "--output", required=True, type=click.Path(path_type=Path), help="The file for the flat pieces."
)
@click.option(
    "--textured",
    type=click.Path(path_type=Path),
    help="Also write the mesh, with the flat pieces as its texture coordinates.",
)
@filter_options(FLATTEN, without=["write_texture_coordinates"])
@json_option
@click.option("-q", "--quiet", is_flag=True, help="No progress bar.")
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

    with errors_in_words(as_json), progress_shown(FLATTEN.title, quiet or as_json) as shown:
        flat = flatten_file(mesh, output, textured, verbose=shown, **given(options))
    values = dataclasses.asdict(flat.report) | {"seams": len(flat.seams)}
    if as_json:
        print_json({"input": str(mesh), "output": str(output)} | values)
    else:
        print_table(str(output), values)
    sound = flat.report.overlapping_pieces == flat.report.flipped_faces == 0
    sys.exit(Exit.DONE if sound else Exit.NOT_CONVERGED)
