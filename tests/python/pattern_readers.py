# SPDX-License-Identifier: GPL-3.0-or-later
"""Pattern files read by libraries that did not write them: GDAL, svgelements, pdfplumber."""

from __future__ import annotations

import contextlib
from collections import defaultdict
from pathlib import Path

import numpy as np
import pdfplumber
import pyogrio
import shapely
import svgelements

POINT = 72 / 25.4  # points of PDF in a millimetre

Blocks = dict[str, dict[str, list]]  # geometries by the block's name and the layer's number


@contextlib.contextmanager
def _gdal(**options: str):
    pyogrio.set_gdal_config_options(options)
    try:
        yield
    finally:
        pyogrio.set_gdal_config_options(dict.fromkeys(options))


def read_dxf_blocks(path: Path) -> Blocks:
    """What is in the blocks, each in its own frame."""
    with _gdal(DXF_INLINE_BLOCKS="FALSE", DXF_MERGE_BLOCK_GEOMETRIES="FALSE"):
        blocks: Blocks = defaultdict(lambda: defaultdict(list))
        for row, geometry in _rows(path, "blocks"):
            blocks[row["Block"]][row["Layer"]].append(geometry)
    return blocks


def read_dxf_texts(path: Path) -> dict[str, list[str]]:
    """All texts by their layer's number, inserted or not."""
    texts = defaultdict(list)
    for row, _ in _rows(path, "entities"):
        if row["Text"]:
            texts[row["Layer"]].append(row["Text"])
    return texts


def read_dxf_inserts(path: Path) -> dict[str, tuple[shapely.Point, float]]:
    """Where each block is inserted, and how far it is turned, degrees."""
    with _gdal(DXF_INLINE_BLOCKS="FALSE"):
        return {
            row["BlockName"]: (geometry, row["BlockAngle"])
            for row, geometry in _rows(path, "entities")
            if row["BlockName"]
        }


def _rows(path: Path, layer: str):
    meta, _, shapes, columns = pyogrio.raw.read(path, layer=layer)
    for index, geometry in enumerate(shapely.from_wkb(shapes)):
        yield {name: column[index] for name, column in zip(meta["fields"], columns, strict=True)}, geometry


def read_svg(path: Path) -> dict[str, dict[str, list[svgelements.Path]]]:
    """Paths in millimetres, by the group's title and the class of line."""
    document = svgelements.SVG.parse(path, ppi=25.4, reify=True)
    groups = defaultdict(lambda: defaultdict(list))
    for group in document.select(lambda element: isinstance(element, svgelements.Group)):
        for path_ in group.select(lambda element: isinstance(element, svgelements.Path)):
            groups[group.id][path_.values["class"]].append(path_)
    return groups


def svg_points(path: svgelements.Path) -> np.ndarray:
    """The points of a polyline; a closed one comes back to the first."""
    return np.array([(segment.end.x, segment.end.y) for segment in path])


def svg_curve(path: svgelements.Path, parts: int = 8) -> np.ndarray:
    """Points closely along a line of curves, which comes back to the first."""
    shares = np.linspace(0, 1, parts + 1)[1:]
    drawn = [segment for segment in path if not isinstance(segment, svgelements.Move)]
    return np.vstack([segment.npoint(shares) for segment in drawn])


def read_pdf(path: Path) -> list[dict]:
    """Pages: their size in mm, their text, and the points of their lines in mm."""
    pages = []
    with pdfplumber.open(path) as document:
        for page in document.pages:
            drawn = [*page.curves, *page.lines, *page.rects]
            pages.append(
                {
                    "size": (float(page.width) / POINT, float(page.height) / POINT),
                    "text": page.extract_text(),
                    "lines": [np.array(line["pts"], dtype=float) / POINT for line in drawn],
                    "crosses": [np.array(line["pts"], dtype=float) / POINT for line in page.lines],
                    "dashed": [bool(line["dash"] and line["dash"][0]) for line in drawn],
                }
            )
    return pages


def length(points: np.ndarray, closed: bool = False) -> float:
    ring = np.vstack([points, points[:1]]) if closed else points
    return float(np.linalg.norm(np.diff(ring, axis=0), axis=1).sum())
