# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable report`: the methods compared on meshes, as a page with pictures."""

from __future__ import annotations

import importlib.util
import shlex
import sys
from pathlib import Path

import click

from meshlab_developable.command_line import shared
from meshlab_developable.errors import DevelopableError


def _installation() -> str:
    """How the extra is installed: from the clone that this runs from, or from the registry."""
    folder = Path(__file__).resolve().parents[2]
    source = f"{folder}[render]" if (folder / "pyproject.toml").is_file() else "meshlab-developable[render]"
    return f"{shlex.quote(sys.executable)} -m pip install {shlex.quote(source)}"


@click.command(name="report")
@click.argument("meshes", nargs=-1, required=True, type=shared.MESH)
@click.option(
    "-o",
    "--output",
    "--out",
    "out",
    type=click.Path(file_okay=False, path_type=Path),
    default=Path("report"),
    show_default=True,
    help="The folder to write to.",
)
@click.option("--unit", default="model units", show_default=True, help="What a mesh unit is called.")
def command(meshes: tuple[Path, ...], out: Path, unit: str) -> None:
    """Try each method on each mesh and write a page with numbers and pictures, OUT/report.html.

    Needs the extra `render`: pip install 'meshlab-developable[render]'.

    \b
    Examples:
      developable report panel.ply
      developable report front.obj back.obj --out out/report --unit cm
    """
    with shared.errors_in_words():
        for name in ("matplotlib", "pyvista"):
            if importlib.util.find_spec(name) is None:
                raise DevelopableError(f"{name} is missing; install it: {_installation()}")
        import pymeshlab

        from meshlab_developable.demo.__main__ import METHODS, run
        from meshlab_developable.demo.study import Input

        try:
            run([Input(path, f"The mesh {path.name}.", unit) for path in meshes], METHODS, out)
        except pymeshlab.PyMeshLabException as error:
            raise DevelopableError(str(error)) from None
    click.echo(f"Report: {out / 'report.html'} (short: {out / 'report.txt'})")
