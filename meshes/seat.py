# SPDX-License-Identifier: GPL-3.0-or-later
"""A car seat as upholsterers meet it: cushion, back with bolsters, and a head rest, one closed surface."""

from __future__ import annotations

from rounded_shapes import cushion, grown_together, limb, surface
from shapes import Panels

SPACING = 3.6
TILT = 0.3  # of the back, rad


def seat() -> Panels:
    """One looks to +x from it; the plane y = 0 is its plane of symmetry. Some 115 cm high."""
    parts = [
        cushion([0, 0, 0], [27, 25, 9], 0.0, 6),
        cushion([-31, 0, 35], [9, 24, 38], TILT, 6),
        cushion([-45, 0, 84], [6.5, 13, 11], TILT, 5),
        limb([-40.5, 0, 66], [-42.6, 0, 74], 6.5),
    ]
    for side in (1, -1):
        parts.append(limb([18, side * 24, 5], [-20, side * 24, 4], 7.5))
        parts.append(limb([-20, side * 23, 22], [-30, side * 21, 56], 7.5, 6))
    shape = grown_together(parts, width=1.6)
    return {"seat": surface(shape, [-75, -45, -24], [45, 45, 110], SPACING)}
