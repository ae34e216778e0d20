# SPDX-License-Identifier: GPL-3.0-or-later
"""From a mesh to files that a shop can cut and sew by."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy.typing as npt
import shapely

from meshlab_developable import materials
from meshlab_developable.errors import InvalidParameterError
from meshlab_developable.flattening import FlatteningResult, flatten
from meshlab_developable.mesh_sets import Source
from meshlab_developable.patterns.drawing import Drawing, Motion, Quantity, print_check
from meshlab_developable.patterns.dxf import write_dxf
from meshlab_developable.patterns.ease import ease_notes
from meshlab_developable.patterns.internal_lines import trace_lines
from meshlab_developable.patterns.layout import read_layout
from meshlab_developable.patterns.marks import MarkedSeam, draw_piece, mark_seams
from meshlab_developable.patterns.options import PatternOptions
from meshlab_developable.patterns.outlines import Outlines, exact_outlines, fair_outlines
from meshlab_developable.patterns.overlaps import share_overlaps, wide_overlaps
from meshlab_developable.patterns.packing import Sheet, pack
from meshlab_developable.patterns.pdf import SheetDrawing, write_pdf, write_tiled_pdf
from meshlab_developable.patterns.pieces import Pieces, make_pieces, piece_names
from meshlab_developable.patterns.side_file import write_side_file
from meshlab_developable.patterns.splitting import split_labels, split_options
from meshlab_developable.patterns.strain import require_little_strain, strain_notes
from meshlab_developable.patterns.svg import write_svg
from meshlab_developable.patterns.symmetry import Fold, find_copies, find_fold
from meshlab_developable.writing import written_together

BEYOND_BOUNDS = 0.02  # per cent; strains keep their bounds to 0.01
OPTIONS = tuple(field.name for field in dataclasses.fields(PatternOptions))


@dataclasses.dataclass(frozen=True)
class PatternFiles:
    """What `make_patterns` made."""

    files: tuple[Path, ...]
    piece_names: tuple[str, ...]
    sheets: tuple[tuple[float, float], ...]  # width and height, mm
    seams: tuple[MarkedSeam, ...]
    notes: tuple[str, ...]  # what a user should know
    flattening: FlatteningResult


def make_patterns(
    vertices: Source,
    faces: npt.ArrayLike | None = None,
    *,
    folder: str | os.PathLike[str],
    name: str = "pattern",
    **parameters: Any,
) -> PatternFiles:
    """Lay a mesh flat and write its pieces, at true size, to a folder.

    Vertices, faces and parameters are those of `flatten` and of `PatternOptions`: `unit` (of the mesh: "mm",
    "cm", "dm", "m", "in", "ft", or how many millimetres it is), `seam_allowance`, `notch_spacing` and `gap`
    (mm), `grain` (a direction on the model that runs upright, along which the warp of a directed `material`
    lies), `sheet` (mm x mm, or a paper's name), `turns`
    ("none", "half", "free"), `page` (of the PDF in tiles), `formats`, `piece_names`, `internal_lines` (to
    be drawn, each k x 3, vertices of the mesh along its edges), `outline` ("fair": smooth lines between
    corners, no farther than `outline_tolerance`, mm, from the mesh's vertices; "exact": the mesh's own) and
    `max_strain` (per cent; a piece with an edge whose length changes by more is refused). A mesh does not
    say its unit; without one it is taken for millimetres.

    Writes name.svg (one file a sheet), name.pdf (one page a sheet), name-A4.pdf (tiles for an office
    printer), name.dxf (ASTM D6673) and name.json (what is sewn to what). All of them or, when
    something is wrong, none.

    Raises PatternError, InvalidParameterError, and what `flatten` raises.
    """
    given = {key: parameters.pop(key) for key in OPTIONS if key in parameters}
    borne = materials.greatest_edge_strain(parameters) + BEYOND_BOUNDS
    given.setdefault("max_strain", max(PatternOptions.max_strain, borne))
    options = PatternOptions(**given)
    if options.grain is not None:
        parameters["grain"] = materials.grain_along(options.grain)
    flat = flatten(vertices, faces, **parameters)
    wide = wide_overlaps(flat, options.millimetres)
    if not wide or parameters.get("only_selected") is not None:
        return write_patterns(flat, Path(folder), name, options, borne)
    labels = split_labels(flat, set(wide))
    seams = {key: value for key, value in parameters.items() if key not in ("patches", "texture_coordinates")}
    parts = flatten(vertices, faces, **seams | {"face_labels": labels})
    options, notes = split_options(flat, parts, wide, options)
    made = write_patterns(parts, Path(folder), name, options, borne)
    return dataclasses.replace(made, notes=(*notes, *made.notes))


def write_patterns(
    flat: FlatteningResult,
    folder: Path,
    name: str = "pattern",
    options: PatternOptions | None = None,
    borne: float = 0.0,
) -> PatternFiles:
    """Write pieces that are flat already; see `make_patterns`.

    borne: by how much the material lets edges change, per cent.
    """
    options = options or PatternOptions()
    if not name or name != Path(name).name:
        raise InvalidParameterError(f"name is {name!r}, but must be that of a file, without folders")
    names = piece_names(flat.report.pieces, options.piece_names)
    outlines = _outlines(flat, options, names)
    pieces = make_pieces(flat, outlines, options)
    require_little_strain(flat, [piece.name for piece in pieces.pieces], options.max_strain)
    seams = mark_seams(outlines.seams, pieces, options.notch_spacing)
    lines = trace_lines(flat, options.internal_lines)
    drawings = [
        draw_piece(number, pieces, seams, lines, options.seam_allowance, quantity, fold)
        for number, quantity, fold in _to_draw(pieces, options)
    ]
    sheets, layout_notes = _laid_out(drawings, options)
    files = _write_all(folder, name, options, pieces, seams, drawings, sheets)
    return PatternFiles(
        files=files,
        piece_names=tuple(piece.name for piece in pieces.pieces),
        sheets=tuple(sheet.size for sheet in sheets),
        seams=seams,
        notes=(
            *pieces.notes,
            *layout_notes,
            *strain_notes(flat, options.millimetres, borne),
            *ease_notes(seams, [piece.name for piece in pieces.pieces]),
            *_name_notes(pieces, options),
        ),
        flattening=flat,
    )


def _outlines(flat: FlatteningResult, options: PatternOptions, names: Sequence[str]) -> Outlines:
    unit = options.millimetres
    if options.outline == "exact":
        outlines = exact_outlines(flat, unit)
    else:
        outlines = fair_outlines(flat, unit, options.outline_tolerance, names, options.seam_tolerance)
    return share_overlaps(flat, outlines, names, unit)


def _name_notes(pieces: Pieces, options: PatternOptions) -> list[str]:
    names = [piece.name for piece in pieces.pieces]
    unknown = [name for name in names if name != name.encode("latin-1", "ignore").decode("latin-1")]
    if not unknown or "pdf" not in options.formats:
        return []
    return [f"PDF has no letters for {', '.join(unknown)}; the names are in the other files."]


def _to_draw(pieces: Pieces, options: PatternOptions) -> list[tuple[int, Quantity, Fold | None]]:
    """The numbers of the pieces that are drawn, how many of each are cut, and where they are folded."""
    shapes = [piece.cut for piece in pieces.pieces]
    copies = find_copies(shapes) if options.copies == "once" else [None] * len(shapes)
    drawn = []
    for number, shape in enumerate(shapes):
        if copies[number] is not None:
            continue
        mirrored = [copy[1] for copy in copies if copy is not None and copy[0] == number]
        fold = find_fold(shape) if options.fold else None
        quantity = Quantity(1 + mirrored.count(False), mirrored.count(True), fold is not None)
        if fold is not None:  # it is its own mirror image
            quantity = Quantity(1 + len(mirrored), 0, True)
        drawn.append((number, quantity, fold))
    return drawn


def _laid_out(drawings: Sequence[Drawing], options: PatternOptions) -> tuple[list[Sheet], list[str]]:
    """Sheets with the pieces and, where it fits, the square to check the print; and notes."""
    shapes = {drawing.name: shapely.Polygon(drawing.paths[0].points) for drawing in drawings}
    if options.layout is not None:
        return read_layout(Path(options.layout), shapes)
    square = print_check()
    if options.sheet_size is None or min(options.sheet_size) > 101 + 1.2 * options.gap:
        shapes[square.name] = shapely.Polygon(square.paths[0].points)
    return pack(shapes, options.sheet_size, options.gap, options.turns, upright=[square.name]), []


def _sheet_drawings(name: str, drawings: Sequence[Drawing], sheets: Sequence[Sheet]) -> list[SheetDrawing]:
    drawn = []
    for number, sheet in enumerate(sheets):
        here = [
            drawing.moved(sheet.motions[drawing.name])
            for drawing in (*drawings, print_check())
            if drawing.name in sheet.motions
        ]
        title = name if len(sheets) == 1 else f"{name}, sheet {number + 1} of {len(sheets)}"
        drawn.append(SheetDrawing(title, sheet.size, here))
    return drawn


def _in_a_row(drawings: Sequence[Drawing], sheets: Sequence[Sheet]) -> list[Motion]:
    """Where the drawings go when the sheets lie side by side."""
    motions, left = {}, 0.0
    for sheet in sheets:
        for name, motion in sheet.motions.items():
            motions[name] = Motion(motion.angle, (motion.shift[0] + left, motion.shift[1]))
        left += 1.1 * sheet.size[0]
    return [motions[drawing.name] for drawing in drawings]


def _write_all(
    folder: Path,
    name: str,
    options: PatternOptions,
    pieces: Pieces,
    seams: Sequence[MarkedSeam],
    drawings: Sequence[Drawing],
    sheets: Sequence[Sheet],
) -> tuple[Path, ...]:
    """Everything is written elsewhere first, so that nothing is left half done."""
    with written_together(folder) as path:
        on_sheets = _sheet_drawings(name, drawings, sheets)
        if "svg" in options.formats:
            for number, sheet in enumerate(on_sheets):
                suffix = "" if len(on_sheets) == 1 else f"-{number + 1}"
                write_svg(path / f"{name}{suffix}.svg", sheet.name, sheet.size, sheet.drawings)
        if "pdf" in options.formats:
            write_pdf(path / f"{name}.pdf", name, on_sheets)
            if options.page is not None:
                write_tiled_pdf(path / f"{name}-{options.page}.pdf", name, on_sheets, options.page)
        if "dxf" in options.formats:
            write_dxf(path / f"{name}.dxf", name, drawings, _in_a_row(drawings, sheets))
        write_side_file(path / f"{name}.json", name, pieces, seams, sheets)
        names = sorted(file.name for file in path.iterdir())
    return tuple(folder / file_name for file_name in names)
