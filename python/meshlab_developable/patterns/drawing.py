# SPDX-License-Identifier: GPL-3.0-or-later
"""A piece as lines, notches and texts, on the layers of ASTM D6673. In millimetres, y upwards."""

from __future__ import annotations

import dataclasses
import enum
from collections.abc import Sequence

import numpy as np

from meshlab_developable.mesh_sets import Array


class Layer(enum.IntEnum):
    """What a line is for; the number is that of ASTM D6673 and AAMA."""

    BOUNDARY = 1  # to be cut
    TURN_POINTS = 2
    CURVE_POINTS = 3
    NOTCH = 4
    MIRROR = 6  # where cloth is folded
    GRAIN = 7
    INTERNAL = 8
    CUTOUT = 11
    SEW = 14
    TEXT = 15
    BOUNDARY_CHECK = 84  # and the next: the true lines, to validate what programs make of the points
    INTERNAL_CHECK = 85
    CUTOUT_CHECK = 86
    SEW_CHECK = 87


@dataclasses.dataclass(frozen=True)
class Path:
    """A polyline, or a ring; where its points are on smooth curves, those too."""

    layer: Layer
    points: Array  # k x 2; a ring does not repeat its first point
    closed: bool = True
    curves: Sequence[Array] = ()  # Bézier curves, 4 x 2 each, one from where the other ends


@dataclasses.dataclass(frozen=True)
class Notch:
    """A short cut into the boundary, that meets its like when the seam is sewn."""

    on_boundary: Array  # 2
    on_seam: Array  # 2, the point that is sewn to the other notch's
    end: Array  # 2, how far the cut goes

    @property
    def depth(self) -> float:
        """Length of the cut."""
        return float(np.linalg.norm(self.end - self.on_boundary))

    @property
    def angle(self) -> float:
        """Direction of the cut, degrees."""
        x, y = self.end - self.on_boundary
        return float(np.degrees(np.arctan2(y, x)))


@dataclasses.dataclass(frozen=True)
class Text:
    """A line of text, centred on a point."""

    content: str
    centre: Array  # 2
    height: float  # of a capital letter


@dataclasses.dataclass(frozen=True)
class Quantity:
    """How many of a piece are cut."""

    like: int = 1
    mirrored: int = 0
    on_fold: bool = False

    def __str__(self) -> str:
        mirrored = f" + {self.mirrored} mirrored" if self.mirrored else ""
        return f"cut {self.like}{mirrored}{' on fold' if self.on_fold else ''}"


@dataclasses.dataclass(frozen=True)
class Motion:
    """A turn about the origin, then a shift."""

    angle: float = 0.0  # degrees
    shift: tuple[float, float] = (0.0, 0.0)

    def __call__(self, points: Array) -> Array:
        """Where points (2, or k x 2) go."""
        angle = np.radians(self.angle)
        cosine, sine = np.cos(angle), np.sin(angle)
        if self.angle % 180 == 0:  # without rounding
            cosine, sine = (1.0, 0.0) if self.angle % 360 == 0 else (-1.0, 0.0)
        moved: Array = points @ np.array([[cosine, sine], [-sine, cosine]]) + np.array(self.shift)
        return moved


@dataclasses.dataclass(frozen=True)
class Drawing:
    """A piece, or a sheet of them."""

    name: str
    paths: Sequence[Path] = ()
    notches: Sequence[Notch] = ()
    texts: Sequence[Text] = ()
    quantity: Quantity = Quantity()

    def moved(self, motion: Motion) -> Drawing:
        """Turned and shifted; its texts stay upright."""
        return Drawing(
            self.name,
            [
                dataclasses.replace(
                    path, points=motion(path.points), curves=[motion(curve) for curve in path.curves]
                )
                for path in self.paths
            ],
            [Notch(motion(n.on_boundary), motion(n.on_seam), motion(n.end)) for n in self.notches],
            [dataclasses.replace(text, centre=motion(text.centre)) for text in self.texts],
            self.quantity,
        )


def print_check() -> Drawing:
    """A square of 10 cm, to check with a ruler that a print has its true size. Its corner is the origin."""
    height = 4.0
    corners = np.array([(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)])
    lines = ("This square must measure", "10 cm x 10 cm.", "If not, print at 100 %.")
    texts = [
        Text(line, np.array((50.0, 50.0 + 2 * height * (1 - row))), height) for row, line in enumerate(lines)
    ]
    return Drawing("print check", [Path(Layer.TEXT, corners)], [], texts)
