# SPDX-License-Identifier: GPL-3.0-or-later
"""How lines look in print."""

from __future__ import annotations

import dataclasses

from meshlab_developable.patterns.drawing import Layer

CAPITALS = 0.717  # height of Helvetica's capitals, of its font size
TEXT_COLOUR = "#333333"


@dataclasses.dataclass(frozen=True)
class Stroke:
    """A line's colour, its width and its dashes, mm."""

    colour: str
    width: float
    dashes: tuple[float, ...] = ()


STROKES = {
    Layer.BOUNDARY: Stroke("#000000", 0.4),
    Layer.CUTOUT: Stroke("#000000", 0.4),
    Layer.NOTCH: Stroke("#000000", 0.4),
    Layer.SEW: Stroke("#0072b2", 0.25, (3, 1.5)),
    Layer.INTERNAL: Stroke("#009e73", 0.25),
    Layer.GRAIN: Stroke("#333333", 0.25),
    Layer.MIRROR: Stroke("#000000", 0.4, (8, 1.5, 1, 1.5)),
    Layer.TEXT: Stroke("#333333", 0.25),
}
