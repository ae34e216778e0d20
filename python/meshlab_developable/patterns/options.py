# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be asked of patterns, checked. Lengths are in millimetres, whatever the mesh's unit."""

from __future__ import annotations

import dataclasses
import math
import os
from collections.abc import Iterator, Mapping, Sequence

import numpy.typing as npt

from meshlab_developable.errors import InvalidParameterError

Size = tuple[float, float]  # width and height, mm

UNITS = {"mm": 1.0, "cm": 10.0, "dm": 100.0, "m": 1000.0, "in": 25.4, "ft": 304.8}  # mm
PAPERS: dict[str, Size] = {
    "A0": (841, 1189),
    "A1": (594, 841),
    "A2": (420, 594),
    "A3": (297, 420),
    "A4": (210, 297),
    "Letter": (215.9, 279.4),
    "Tabloid": (279.4, 431.8),
}
FORMATS = ("svg", "pdf", "dxf")
TURNS = ("none", "half", "free")
OUTLINES = ("fair", "exact")
EDGES = ("seam", "hem")
COPIES = ("all", "once")


@dataclasses.dataclass(frozen=True)
class PatternOptions:
    """How pieces are marked, laid out and written.

    Raises InvalidParameterError for a value that makes no sense, saying what would do.
    """

    unit: str | float = "mm"  # of the mesh: a name of UNITS, or how many millimetres it is
    seam_allowance: float = 10.0  # width of the margin outside the sew line, mm
    hem_allowance: float | None = None  # mm, along edges that are in no seam; None: the seam allowance
    piece_allowances: Mapping[str, Mapping[str, float]] = dataclasses.field(
        default_factory=dict
    )  # "seam", "hem"
    copies: str = "all"  # "once": of pieces that are alike, or mirror images, only the first is drawn
    fold: bool = False  # of a piece that is its own mirror image, one half is drawn, to be cut on the fold
    notch_spacing: float = 100.0  # along seams, mm, at most; 0: no notches
    grain: tuple[float, float, float] | None = None  # runs upright; None: what is up on the model does
    sheet: str | Size | None = None  # what the pieces are cut from; None: one sheet, as large as needed
    layout: str | os.PathLike[str] | None = None  # a file that says where pieces lie, as name.json does
    gap: float = 5.0  # between the pieces, mm
    turns: str = "half"  # how pieces may be turned on a sheet: "none", "half" or "free"
    page: str | None = "A4"  # for the PDF in tiles, a name of PAPERS; None: no such file
    formats: Sequence[str] = FORMATS
    piece_names: Sequence[str] | None = None
    internal_lines: Sequence[npt.ArrayLike] = ()  # k x 3 each: vertices of the model, along its edges
    outline: str = "fair"  # smooth lines between corners; "exact": the mesh's own
    outline_tolerance: float = 0.3  # mm, from the mesh's vertices to smooth lines
    seam_tolerance: float = 0.0  # mm, that seams may move on the model, both sides alike, to be smooth
    max_strain: float = 5.0  # per cent, that an edge's length may change by; infinite: any

    def __post_init__(self) -> None:
        _require(self.millimetres > 0, "unit", self.unit, f"one of {_names(UNITS)}, or millimetres above 0")
        _require(self.outline in OUTLINES, "outline", self.outline, f"one of {_names(OUTLINES)}")
        for name in ("seam_allowance", "notch_spacing", "gap", "outline_tolerance", "seam_tolerance"):
            value = getattr(self, name)
            _require(_finite(value) and value >= 0, name, value, "a finite length in mm, 0 or more")
        for name, value in self._special_allowances():
            _require(_finite(value) and value >= 0, name, value, "a finite length in mm, 0 or more")
        for piece, widths in self.piece_allowances.items():
            _require(
                set(widths) <= set(EDGES),
                f"piece_allowances of {piece}",
                dict(widths),
                f"for {_names(EDGES)}",
            )
        _require(self.copies in COPIES, "copies", self.copies, f"one of {_names(COPIES)}")
        _require(
            self.grain is None
            or (len(self.grain) == 3 and all(map(_finite, self.grain)) and any(self.grain)),
            "grain",
            self.grain,
            "a direction on the model: three numbers, not all 0",
        )
        size = self.sheet_size
        _require(
            size is None or (all(map(_finite, size)) and min(size) > 0),
            "sheet",
            self.sheet,
            f"width and height in mm, both above 0, or one of {_names(PAPERS)}",
        )
        _require(self.turns in TURNS, "turns", self.turns, f"one of {_names(TURNS)}")
        _require(self.page is None or self.page in PAPERS, "page", self.page, f"one of {_names(PAPERS)}")
        unknown = [format_ for format_ in self.formats if format_ not in FORMATS]
        _require(not unknown, "formats", list(self.formats), f"of {_names(FORMATS)}")

        strain = self.max_strain
        _require(
            strain == math.inf or (_finite(strain) and strain >= 0),
            "max_strain",
            strain,
            "a number of per cent, 0 or more",
        )

    def allowance(self, piece: str, edge: str) -> float:
        """How wide the allowance is along edges of a class, on a piece, mm."""
        given = self.piece_allowances.get(piece, {})
        hem = self.seam_allowance if self.hem_allowance is None else self.hem_allowance
        return float(given.get(edge, hem if edge == "hem" else self.seam_allowance))

    def _special_allowances(self) -> Iterator[tuple[str, float]]:
        if self.hem_allowance is not None:
            yield "hem_allowance", self.hem_allowance
        for piece, widths in self.piece_allowances.items():
            for edge, width in widths.items():
                yield f"piece_allowances of {piece}, {edge},", width

    @property
    def millimetres(self) -> float:
        """How long the mesh's unit is; not a number when it can't be told."""
        value = UNITS.get(self.unit, math.nan) if isinstance(self.unit, str) else self.unit
        return float(value) if _finite(value) else math.nan

    @property
    def sheet_size(self) -> Size | None:
        """The sheet in mm; not numbers when it can't be told."""
        if isinstance(self.sheet, str):
            return PAPERS.get(self.sheet, (math.nan, math.nan))
        if self.sheet is None or len(self.sheet) == 2:
            return self.sheet
        return (math.nan, math.nan)


def _finite(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def _require(good: bool, name: str, value: object, wanted: str) -> None:
    if not good:
        raise InvalidParameterError(f"{name} is {value!r}, but must be {wanted}")


def _names(known: Sequence[str] | dict[str, float] | dict[str, Size]) -> str:
    return ", ".join(map(repr, known))
