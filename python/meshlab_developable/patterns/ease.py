# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams whose sides differ in length: how much of the longer one is to be eased into the shorter."""

from __future__ import annotations

from collections.abc import Sequence

from meshlab_developable.patterns.marks import MarkedSeam
from meshlab_developable.patterns.strain import in_per_cent

NOTABLE_EASE = 1e-3  # of the shorter side
MOST_SEAMS = 12  # that a note names


def ease_notes(seams: Sequence[MarkedSeam], names: Sequence[str]) -> list[str]:
    """Which seams need ease: the letter, both lengths, and per cent of the shorter. names: of the pieces."""
    eased = sorted((seam for seam in seams if seam.ease > NOTABLE_EASE), key=lambda seam: -seam.ease)
    if not eased:
        return []
    said = "; ".join(_in_words(seam, names) for seam in eased[:MOST_SEAMS])
    more = len(eased) - MOST_SEAMS
    others = f"; and {more} more with less" if more > 0 else ""
    return [f"Ease the longer side of these seams in evenly: {said}{others}."]


def _in_words(marked: MarkedSeam, names: Sequence[str]) -> str:
    """Such as "A 0.42 % (312.3 mm of Front to 311.0 mm of Back)"."""
    longer = 0 if marked.lengths[0] > marked.lengths[1] else 1
    sides = (
        f"{marked.lengths[side]:.1f} mm of {names[marked.seam.pieces[side]]}" for side in (longer, 1 - longer)
    )
    return f"{marked.letter} {in_per_cent(marked.ease)} ({' to '.join(sides)})"
