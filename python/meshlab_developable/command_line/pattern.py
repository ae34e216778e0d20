# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable pattern`: files to print, cut and sew by."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from meshlab_developable import mesh_sets
from meshlab_developable.command_line import shared
from meshlab_developable.errors import InvalidParameterError
from meshlab_developable.filters import CUT, FLATTEN
from meshlab_developable.materials import grain_along
from meshlab_developable.mesh_sets import Array, IndexArray
from meshlab_developable.parameters import converted
from meshlab_developable.patterns.options import (
    COPIES,
    FORMATS,
    OUTLINES,
    PAPERS,
    TURNS,
    UNITS,
    PatternOptions,
    Size,
)

# Parameters of the filters that a pattern has no use for, or options of its own.
NO_OPTIONS = ("cut", "colorize", "gap", "grain", "map", "write_texture_coordinates")
OF_FLATTENING = tuple(parameter.name for parameter in FLATTEN.parameters)
OF_CUT = tuple(
    parameter.name for parameter in CUT.parameters if parameter.name not in (*OF_FLATTENING, *NO_OPTIONS)
)


def _numbers(text: str, separator: str, count: int) -> tuple[float, ...] | None:
    try:
        values = tuple(float(part) for part in text.split(separator))
    except ValueError:
        return None
    return values if len(values) == count else None


def _unit(_context: click.Context, _option: click.Parameter, text: str | None) -> str | float | None:
    if text is None or text in UNITS:
        return text
    value = _numbers(text, "x", 1)
    if value is None:
        raise click.BadParameter(f"{text!r} is neither a length in mm nor one of {', '.join(UNITS)}")
    return value[0]


def _sheet(_context: click.Context, _option: click.Parameter, text: str | None) -> str | Size | None:
    if text is None or text in PAPERS:
        return text
    size = _numbers(text.lower(), "x", 2)
    if size is None:
        raise click.BadParameter(f"{text!r} is neither like 1400x2000 nor one of {', '.join(PAPERS)}")
    return size[0], size[1]


def _grain(
    _context: click.Context, _option: click.Parameter, text: str | None
) -> tuple[float, float, float] | None:
    if text is None:
        return None
    axes = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
    found = axes.get(text.lower()) or _numbers(text, ",", 3)
    if found is None:
        raise click.BadParameter(f"{text!r} is neither x, y or z nor like 0,0.5,1")
    return found[0], found[1], found[2]


def _piece_allowances(texts: Sequence[str]) -> dict[str, dict[str, float]]:
    """Widths by piece and class of edge. Raises InvalidParameterError for a text of another form."""
    widths: dict[str, dict[str, float]] = {}
    for text in texts:
        name, colon, rest = text.rpartition(":")
        edge, sign, number = rest.partition("=")
        value = _numbers(number, "x", 1)
        if not (colon and sign and value):
            raise InvalidParameterError(f"{text!r} is not like 'Piece 1:hem=30'")
        widths.setdefault(name.strip(), {})[edge.strip()] = value[0]
    return widths


def _question_of_unit(mesh: Path) -> str:
    """What to say where the unit is missing: how large the model would be in each of the common ones."""
    meshes = mesh_sets.open_mesh(mesh)  # a mesh dies with its set
    box = meshes.current_mesh().bounding_box()
    size = " x ".join(f"{side:.4g}" for side in box.max() - box.min())
    sizes = ", ".join(f"{size} {name}" for name in ("mm", "cm", "m", "inches"))
    return (
        f"a mesh does not say what its unit is, so that {mesh.name} may be {sizes}: say which with --unit, "
        f"one of {', '.join(UNITS)}, or how many mm"
    )


def _developed_panels(mesh: Path, parameters: dict[str, Any]) -> tuple[Array, IndexArray]:
    """Vertices and faces of the mesh's panels, made developable; takes what only the cut needs from the
    parameters, and lets seams, which are new, be smooth."""
    from meshlab_developable.cutting import OF_MATERIAL, developed_panels, seam_tolerance

    known = {parameter.name for parameter in CUT.parameters}
    of_cut = {name: value for name, value in parameters.items() if name in known}
    for name in of_cut.keys() - set(OF_MATERIAL):  # panels are apart now, and none is left out
        del parameters[name]
    if "grain" in of_cut:
        of_cut["grain"] = converted("grain", of_cut["grain"], grain_along)
    vertices, faces, _ = developed_panels(mesh, **of_cut)
    millimetres = PatternOptions(unit=parameters["unit"]).millimetres
    parameters.setdefault("seam_tolerance", millimetres * seam_tolerance(vertices, faces))
    return vertices, faces


@click.command(name="pattern")
@click.argument("mesh", type=shared.MESH)
@shared.output_option("The folder for the files.", folder=True)
@click.option("--name", help="What the files are called.  [default: as the mesh's file]")
@click.option(
    "--unit",
    callback=_unit,
    help=f"What a unit of the mesh is: {', '.join(UNITS)}, or how many mm.  [required]",
)
@click.option("--seam-allowance", type=float, help="Width outside the sew line, mm.  [default: 10]")
@click.option(
    "--hem-allowance",
    type=float,
    help="Width outside edges that are in no seam, mm; hems fold back to fit.  [default: as seams]",
)
@click.option(
    "--piece-allowance",
    "piece_allowances",
    multiple=True,
    help="Of one piece, like 'Piece 1:hem=30' (mm) or 'Piece 1:seam=0'; may be repeated.",
)
@click.option(
    "--copies",
    type=click.Choice(COPIES),
    help="Draw all pieces, or those that are alike or mirrored once, with their number.  [default: all]",
)
@click.option(
    "--fold/--no-fold",
    default=None,
    help="Draw half of each symmetric piece, to be cut on the fold.  [default: off]",
)
@click.option("--notch-spacing", type=float, help="Distance of notches, mm; 0: none.  [default: 100]")
@click.option(
    "--grain",
    callback=_grain,
    help="What runs upright: x, y, z or a direction like 0,0.5,1.  [default: the longer of y and z]",
)
@click.option(
    "--sheet",
    callback=_sheet,
    help=f"Its size, like 1400x2000 (mm), or {', '.join(PAPERS)}.  [default: as large as needed]",
)
@click.option(
    "--layout",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="Where pieces lie on sheets: the .json of an earlier pattern, edited.  [default: packed]",
)
@click.option("--gap", type=float, help="Distance of the pieces, mm.  [default: 5]")
@click.option(
    "--turns", type=click.Choice(TURNS), help="How pieces may be turned on a sheet.  [default: half]"
)
@click.option(
    "--page", type=click.Choice([*PAPERS, "none"]), help="Paper for the PDF in tiles.  [default: A4]"
)
@click.option(
    "--format",
    "formats",
    multiple=True,
    type=click.Choice(FORMATS),
    help="Only these files; may be repeated.",
)
@click.option(
    "--piece-name", "piece_names", multiple=True, help="Of the pieces in their order; repeat for each."
)
@click.option(
    "--outline",
    type=click.Choice(OUTLINES),
    help="Smooth lines between corners, or the mesh's own.  [default: fair]",
)
@click.option(
    "--outline-tolerance",
    type=float,
    help="How far smooth lines may be from the mesh's vertices, mm.  [default: 0.3]",
)
@click.option(
    "--seam-tolerance",
    type=float,
    help="How far seams may move on the model, both sides alike, to be smooth, mm.  [default: 0, and with "
    "--cut half as long as the mesh's edges are on average]",
)
@click.option(
    "--max-strain",
    type=float,
    help="Pieces with an edge whose length changes by more, in per cent, are refused.  [default: 5]",
)
@click.option(
    "--cut",
    is_flag=True,
    help="First cut the mesh into panels, and make these developable, or as nearly so as the material needs.",
)
@shared.filter_options(CUT, without=[*OF_FLATTENING, *NO_OPTIONS])
@shared.filter_options(FLATTEN, without=NO_OPTIONS)
@shared.json_option
def command(mesh: Path, output: Path, name: str | None, as_json: bool, cut: bool, **options: Any) -> None:
    """Write panels, laid flat at true size, as patterns to print, cut and sew.

    SVG, PDF (whole sheets, and tiles for an office printer), DXF for garment CAD (ASTM D6673, AAMA), and JSON
    that says which edge is sewn to which. Pieces have a seam allowance, notches and letters that match along
    seams, a name and a grain line. Make the panels developable first (`developable global`, with the same
    material): what can't be laid flat is stretched here and there, and refused beyond 5 %, or what its
    material bears. Nothing is written when something is wrong.

    \b
    Examples:
      developable pattern shoe.ply --output patterns --unit cm
      developable pattern scan.ply --cut --output patterns --unit mm
      developable pattern pants.obj -o patterns --unit cm --sheet 1400x2000 --grain z --turns none
      developable pattern boat.ply -o patterns --unit m --seam-allowance 0 --format dxf --json
    """
    from meshlab_developable.patterns import make_patterns

    with shared.errors_in_words(as_json):
        parameters = {key: value for key, value in shared.given(options).items() if value != ()}
        if parameters.get("page") == "none":
            parameters["page"] = None
        if "piece_allowances" in parameters:
            parameters["piece_allowances"] = _piece_allowances(parameters["piece_allowances"])
        if not output.parent.exists():
            raise InvalidParameterError(f"there is no folder {output.parent} to make {output.name} in")
        if "unit" not in parameters:
            raise InvalidParameterError(_question_of_unit(mesh))
        source: Any = (mesh,)
        if cut:
            source = _developed_panels(mesh, parameters)
        elif of_cut := ", ".join(name for name in parameters if name in OF_CUT):
            raise InvalidParameterError(f"{of_cut} only count when the mesh is cut: give --cut too")
        made = make_patterns(*source, folder=output, name=name or mesh.stem, **parameters)
    values = {
        "pieces": len(made.piece_names),
        "sheets": len(made.sheets),
        "sheet_sizes_mm": [[round(side, 3) for side in size] for size in made.sheets],
        "seams": len(made.seams),
        "max_seam_mismatch_mm": max(
            (abs(a - b) for a, b in (seam.lengths for seam in made.seams)), default=0.0
        ),
        "max_edge_strain": made.flattening.report.max_edge_strain,
        "mean_edge_strain": made.flattening.report.mean_edge_strain,
    }
    ease = {seam.letter: round(100 * seam.ease, 6) for seam in made.seams}
    words = {"input": mesh, "files": made.files, "notes": made.notes, "seam_ease_percent": ease}
    shared.print_result(as_json, str(output), values, **words)
    if not as_json:
        for line in (*map(str, made.files), *made.notes):
            click.echo(f"  {line}")
