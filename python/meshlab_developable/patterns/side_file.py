# SPDX-License-Identifier: GPL-3.0-or-later
"""What no drawing format can say: which edge of which piece is sewn to which. As JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path as FilePath
from typing import Any

import numpy as np

from meshlab_developable.mesh_sets import Array, IndexArray
from meshlab_developable.patterns.dxf import block_names
from meshlab_developable.patterns.marks import MarkedSeam
from meshlab_developable.patterns.packing import Sheet
from meshlab_developable.patterns.pieces import Piece, Pieces


def write_side_file(
    file: FilePath,
    title: str,
    pieces: Pieces,
    seams: Sequence[MarkedSeam],
    sheets: Sequence[Sheet],
) -> None:
    """Write pieces with their points, and seams as pairs of lists of their edges.

    Boundary 0 of a piece is its outline, others are its holes; edge i goes from point i to the next, and the
    last back to point 0. Lengths and coordinates are in millimetres, in the frame of the piece's DXF block.
    """
    names = [piece.name for piece in pieces.pieces]
    content = {
        "title": title,
        "unit": "mm",
        "sheets": [list(sheet.size) for sheet in sheets],
        "pieces": [
            _piece(piece, block, pieces.positions, sheets)
            for piece, block in zip(pieces.pieces, block_names(names), strict=True)
        ],
        "seams": [_seam(marked, pieces, names) for marked in seams],
        "notes": list(pieces.notes),
    }
    file.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def _piece(piece: Piece, block: str, positions: Array, sheets: Sequence[Sheet]) -> dict[str, Any]:
    place = next(
        (
            {"sheet": number + 1, "turned_degrees": motion.angle, "shifted": list(motion.shift)}
            for number, sheet in enumerate(sheets)
            if (motion := sheet.motions.get(piece.name)) is not None
        ),
        {"sheet": None},  # drawn once with another
    )
    return {
        "name": piece.name,
        "dxf_block": block,
        **place,
        "sew_lines": [_points(positions[ring]) for ring in piece.rings],
        "cut_lines": [
            _points(np.array(ring.coords)[:-1]) for ring in (piece.cut.exterior, *piece.cut.interiors)
        ],
    }


def _seam(marked: MarkedSeam, pieces: Pieces, names: Sequence[str]) -> dict[str, Any]:
    sides = []
    for side in (0, 1):
        piece = pieces.pieces[marked.seam.pieces[side]]
        vertices = marked.seam.sides[side]
        steps = np.linalg.norm(np.diff(pieces.positions[vertices], axis=0), axis=1)
        starts = np.cumsum(steps) - steps
        boundary, edges, backwards = _edges(piece, vertices)
        sides.append(
            {
                "piece": piece.name,
                "boundary": boundary,
                "edges": edges,
                "backwards": backwards,
                "length": round(marked.lengths[side], 6),
                "notches_at": [
                    round(float(starts[edge] + share * steps[edge]), 6) for edge, share in marked.notches
                ],
            }
        )
    ease = round(100 * marked.ease, 6)
    return {"letter": marked.letter, "closed": marked.seam.closed, "ease_percent": ease, "sides": sides}


def _edges(piece: Piece, vertices: IndexArray) -> tuple[int, list[int], bool]:
    """On which boundary a side is, its edges in the order of the seam, and whether that is against theirs."""
    for boundary, ring in enumerate(piece.rings):
        index = {vertex: i for i, vertex in enumerate(ring.tolist())}
        if int(vertices[0]) not in index:
            continue
        steps = [index[vertex] for vertex in vertices.tolist()]
        backwards = (steps[0] - steps[1]) % len(ring) == 1
        return boundary, steps[1:] if backwards else steps[:-1], backwards
    raise AssertionError("a seam runs along a boundary of its piece")


def _points(ring: Array) -> list[list[float]]:
    return [[round(x, 6), round(y, 6)] for x, y in ring.tolist()]
