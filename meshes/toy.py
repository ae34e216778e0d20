# SPDX-License-Identifier: GPL-3.0-or-later
"""A stuffed bear that sits: body, head, muzzle, ears, arms, legs and a tail, all in one closed surface."""

from __future__ import annotations

from rounded_shapes import Field, grown_together, limb, surface
from shapes import Panels

SPACING = 1.25


def both_sides(begin: list[float], end: list[float], radius: float, end_radius: float) -> list[Field]:
    """A limb on the left, and its mirror image on the right."""
    return [
        limb([begin[0], side * begin[1], begin[2]], [end[0], side * end[1], end[2]], radius, end_radius)
        for side in (1, -1)
    ]


def toy() -> Panels:
    """The bear looks to +x; the plane y = 0 is its plane of symmetry. Some 27 cm high."""
    shape = grown_together(
        [
            limb([0, 0, 5.5], [0, 0, 11], 6.2, 4.2),
            limb([0.6, 0, 19.4], [0.9, 0, 19.8], 4.8),
            limb([4.2, 0, 18.6], [5.8, 0, 18.4], 2.4, 1.9),
            limb([-5.6, 0, 3.2], [-6.6, 0, 3.4], 1.6),
            *both_sides([0.4, 3.6, 23.2], [0.4, 4.2, 24.2], 1.9, 1.7),
            *both_sides([0.8, 4.2, 13.2], [3.4, 10.6, 10.8], 2.1, 1.8),
            *both_sides([3.0, 4.2, 2.4], [11.0, 6.4, 2.6], 2.7, 2.4),
        ],
        width=0.8,
    )
    return {"toy": surface(shape, [-11, -14, -4], [17, 14, 30], SPACING)}
