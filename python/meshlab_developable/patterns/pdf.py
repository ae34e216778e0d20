# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets as PDF in true size: whole, or in tiles for an office printer."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from pathlib import Path as FilePath

import shapely
from reportlab.pdfgen.canvas import Canvas

from meshlab_developable.errors import PatternError
from meshlab_developable.patterns.drawing import Drawing, Layer, Motion, Path, print_check
from meshlab_developable.patterns.marks import letters
from meshlab_developable.patterns.options import PAPERS, Size
from meshlab_developable.patterns.style import CAPITALS, STROKES, TEXT_COLOUR

POINT = 72 / 25.4  # points of PDF in a millimetre
LARGEST = 14400 / POINT  # side of a page of PDF, mm
MARGIN = 10.0  # that printers leave white, mm
OVERLAP = 15.0  # of neighbouring tiles, mm


@dataclasses.dataclass(frozen=True)
class SheetDrawing:
    """A sheet with its pieces where they go."""

    name: str
    size: Size
    drawings: Sequence[Drawing]


def write_pdf(file: FilePath, title: str, sheets: Sequence[SheetDrawing]) -> None:
    """One page a sheet. Raises PatternError for sheets that are larger than a page can be."""
    largest = max(max(sheet.size) for sheet in sheets)
    if largest > LARGEST:
        raise PatternError(
            f"a sheet is {largest:.0f} mm long, and a page of PDF can't be longer than {LARGEST:.0f} mm: "
            "choose a smaller sheet, or leave out PDF."
        )
    canvas = _canvas(file, title)
    for sheet in sheets:
        canvas.setPageSize([side * POINT for side in sheet.size])
        canvas.scale(POINT, POINT)
        for drawing in sheet.drawings:
            _draw(canvas, drawing)
        canvas.showPage()
    canvas.save()


@dataclasses.dataclass(frozen=True)
class Grid:
    """How a sheet is cut into tiles."""

    page: Size
    columns: int
    rows: int

    @property
    def window(self) -> Size:
        """What a page shows of the sheet, mm."""
        return self.page[0] - 2 * MARGIN, self.page[1] - 2 * MARGIN

    def corner(self, column: int, row: int) -> tuple[float, float]:
        """Where on the sheet a tile's lower left corner is, mm; row 0 is at the bottom."""
        width, height = self.window
        return column * (width - OVERLAP), row * (height - OVERLAP)

    def marks(self) -> list[tuple[float, float, str]]:
        """Crosses on the sheet that two tiles or four show, with the names of two of them."""
        width, height = self.window
        found = []
        for row in range(self.rows):
            for column in range(self.columns):
                x, y = self.corner(column, row)
                if column + 1 < self.columns:
                    for share in (0.25, 0.75):
                        names = f"{self.name(column, row)}|{self.name(column + 1, row)}"
                        found.append((x + width - OVERLAP / 2, y + share * height, names))
                if row + 1 < self.rows:
                    for share in (0.25, 0.75):
                        names = f"{self.name(column, row)}|{self.name(column, row + 1)}"
                        found.append((x + share * width, y + height - OVERLAP / 2, names))
        return found

    def needed(self, sheet: SheetDrawing) -> list[tuple[int, int]]:
        """Column and row of the tiles that show something, from the top left."""
        shapes = [
            shapely.Polygon(path.points)
            for drawing in sheet.drawings
            for path in drawing.paths
            if path.layer == Layer.BOUNDARY
        ]
        width, height = self.window
        found = []
        for row in reversed(range(self.rows)):
            for column in range(self.columns):
                x, y = self.corner(column, row)
                if shapely.intersects(shapely.box(x, y, x + width, y + height), shapes).any():
                    found.append((column, row))
        return found

    def name(self, column: int, row: int) -> str:
        """Letters for the row, from the top, and a number for the column."""
        return f"{letters(self.rows - 1 - row)}{column + 1}"


def tile_grid(size: Size, paper: Size) -> Grid:
    """The grid of fewer pages, of the paper upright or lying."""
    grids = []
    for page in (paper, (paper[1], paper[0])):
        columns, rows = (
            max(1, math.ceil((side - OVERLAP) / (length - 2 * MARGIN - OVERLAP)))
            for side, length in zip(size, page, strict=True)
        )
        grids.append(Grid(page, columns, rows))
    return min(grids, key=lambda grid: grid.columns * grid.rows)


def write_tiled_pdf(file: FilePath, title: str, sheets: Sequence[SheetDrawing], paper: str) -> None:
    """A cover with a square to check the print, then the sheets in tiles that overlap, without empty ones."""
    canvas = _canvas(file, title)
    # The cover has the square whole, which the edges of tiles would cut.
    square = print_check().name
    sheets = [
        dataclasses.replace(sheet, drawings=[drawing for drawing in sheet.drawings if drawing.name != square])
        for sheet in sheets
    ]
    grids = [tile_grid(sheet.size, PAPERS[paper]) for sheet in sheets]
    _cover(canvas, title, PAPERS[paper], sheets, grids)
    for sheet, grid in zip(sheets, grids, strict=True):
        for column, row in grid.needed(sheet):
            _tile(canvas, sheet, grid, column, row)
    canvas.save()


def _canvas(file: FilePath, title: str) -> Canvas:
    canvas = Canvas(str(file), invariant=True)
    canvas.setTitle(title)
    return canvas


def _tile(canvas: Canvas, sheet: SheetDrawing, grid: Grid, column: int, row: int) -> None:
    canvas.setPageSize([side * POINT for side in grid.page])
    canvas.scale(POINT, POINT)
    width, height = grid.window
    label = f"{sheet.name}, tile {grid.name(column, row)}: {grid.columns} across, {grid.rows} down"
    _write(canvas, label, MARGIN, grid.page[1] - MARGIN + 2, 3, centred=False)
    canvas.saveState()
    canvas.translate(MARGIN, MARGIN)
    clip = canvas.beginPath()
    clip.rect(0, 0, width, height)
    canvas.clipPath(clip, stroke=0, fill=0)
    x, y = grid.corner(column, row)
    canvas.translate(-x, -y)
    for drawing in sheet.drawings:
        _draw(canvas, drawing)
    _draw_marks(canvas, grid, (x, y))
    canvas.restoreState()
    _frame(canvas, grid, column, row)
    canvas.showPage()


def _draw_marks(canvas: Canvas, grid: Grid, corner: tuple[float, float]) -> None:
    """Crosses in the overlaps: laid on top of each other they put the tiles where they belong."""
    width, height = grid.window
    canvas.setStrokeColor("#d55e00")
    canvas.setLineWidth(0.2)
    for x, y, names in grid.marks():
        if -5 <= x - corner[0] <= width + 5 and -5 <= y - corner[1] <= height + 5:
            canvas.line(x - 4, y, x + 4, y)
            canvas.line(x, y - 4, x, y + 4)
            canvas.circle(x, y, 2)
            _write(canvas, names, x, y + 4.5, 1.8)


def _frame(canvas: Canvas, grid: Grid, column: int, row: int) -> None:
    """The edge of what a tile shows, and where its neighbours begin."""
    width, height = grid.window
    canvas.setStrokeColor("#999999")
    canvas.setLineWidth(0.15)
    canvas.rect(MARGIN, MARGIN, width, height)
    canvas.setDash([1, 1])
    left, right, low, high = MARGIN, MARGIN + width, MARGIN, MARGIN + height
    if column > 0:
        canvas.line(left + OVERLAP, low, left + OVERLAP, high)
    if column + 1 < grid.columns:
        canvas.line(right - OVERLAP, low, right - OVERLAP, high)
    if row > 0:
        canvas.line(left, low + OVERLAP, right, low + OVERLAP)
    if row + 1 < grid.rows:
        canvas.line(left, high - OVERLAP, right, high - OVERLAP)
    canvas.setDash([])


def _cover(
    canvas: Canvas, title: str, page: Size, sheets: Sequence[SheetDrawing], grids: Sequence[Grid]
) -> None:
    canvas.setPageSize([side * POINT for side in page])
    canvas.scale(POINT, POINT)
    top = page[1] - MARGIN
    tiles = sum(len(grid.needed(sheet)) for sheet, grid in zip(sheets, grids, strict=True))
    lines = (
        title,
        f"{len(sheets)} {'sheet' if len(sheets) == 1 else 'sheets'} in {tiles} tiles. Print at 100 %.",
        "Trim each tile at its frame, lay the crosses in the overlaps on top of each other, tape.",
    )
    for index, line in enumerate(lines):
        _write(canvas, line, MARGIN, top - 8 - 8 * index, 5 if index == 0 else 3, centred=False)
    _draw(canvas, print_check().moved(Motion(0, (MARGIN + 5, top - 140))))
    _overview(canvas, sheets, grids, (MARGIN, MARGIN, page[0] - 2 * MARGIN, top - 170))
    canvas.showPage()


def _overview(
    canvas: Canvas, sheets: Sequence[SheetDrawing], grids: Sequence[Grid], box: tuple[float, ...]
) -> None:
    """Small pictures of the sheets with the names of their tiles, side by side in a box."""
    left, low, width, height = box
    extents = [grid.corner(grid.columns, grid.rows) for grid in grids]  # and one overlap more
    total = sum(1.1 * (extent[0] + OVERLAP) for extent in extents)
    scale = min(width / total, height / (max(extent[1] for extent in extents) + OVERLAP))
    for sheet, grid, extent in zip(sheets, grids, extents, strict=True):
        canvas.saveState()
        canvas.translate(left, low)
        canvas.scale(scale, scale)
        for drawing in sheet.drawings:
            _draw(canvas, Drawing(drawing.name, [p for p in drawing.paths if p.layer == Layer.BOUNDARY]))
        canvas.setStrokeColor("#999999")
        canvas.setLineWidth(0.2 / scale)
        for column, row in grid.needed(sheet):
            x, y = grid.corner(column, row)
            canvas.rect(x, y, grid.window[0], grid.window[1])
            centre = x + grid.window[0] / 2, y + grid.window[1] / 2
            _write(canvas, grid.name(column, row), *centre, min(0.2 * grid.window[0], 4 / scale))
        canvas.restoreState()
        left += 1.1 * scale * (extent[0] + OVERLAP)


def _draw(canvas: Canvas, drawing: Drawing) -> None:
    for path in drawing.paths:
        _set_stroke(canvas, path.layer)
        _line(canvas, path)
    _set_stroke(canvas, Layer.NOTCH)
    for notch in drawing.notches:
        canvas.line(*notch.on_boundary, *notch.end)
    canvas.setDash([])
    for text in drawing.texts:
        x, y = text.centre
        _write(canvas, text.content, x, y - text.height / 2, text.height)


def _set_stroke(canvas: Canvas, layer: Layer) -> None:
    stroke = STROKES[layer]
    canvas.setStrokeColor(stroke.colour)
    canvas.setLineWidth(stroke.width)
    canvas.setDash(list(stroke.dashes))


def _line(canvas: Canvas, path: Path) -> None:
    drawn = canvas.beginPath()
    if path.curves:
        drawn.moveTo(*path.curves[0][0])
        for curve in path.curves:
            drawn.curveTo(*curve[1:].ravel())
    else:
        drawn.moveTo(*path.points[0])
        for point in path.points[1:]:
            drawn.lineTo(*point)
    if path.closed:
        drawn.close()
    canvas.drawPath(drawn)


def _write(canvas: Canvas, text: str, x: float, y: float, height: float, centred: bool = True) -> None:
    """Text whose capitals stand on y and have that height, mm."""
    canvas.setFillColor(TEXT_COLOUR)
    canvas.setFont("Helvetica", height / CAPITALS)
    (canvas.drawCentredString if centred else canvas.drawString)(x, y, text)
