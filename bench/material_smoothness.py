# SPDX-License-Identifier: GPL-3.0-or-later
"""Which smoothness suits a material: bash bench/run.sh material_smoothness [MATERIAL]...

Each model with each material at a row of smoothnesses: the mean move in per cent of the diagonal, and the
radius, in per cent of the diagonal, that 99, 95 and 50 % of the area are bent less tightly than.
"""

from __future__ import annotations

import sys

import numpy as np
from common import print_head, print_row
from meshlab_developable import make_developable
from models import SHEETS, bending_radii, load

SMOOTHNESSES = (3e-7, 3.001e-6, 3e-5, 3e-4, 3e-3)  # at 3e-6, the default, it would be the material's own
SHARES = (0.01, 0.05, 0.5)


def radii_beyond(vertices, faces) -> list[float]:
    """The radii that so many shares of the area are below."""
    radii, shares = bending_radii(vertices, faces)
    order = np.argsort(radii)
    cumulated = np.cumsum(shares[order])
    return [float(radii[order][np.searchsorted(cumulated, share)]) for share in SHARES]


def main() -> None:
    """Print the table."""
    print_head(
        ("material", "mesh", "smoothness", "mean move, %", "radius of 99 %", "95 %", "50 % of the area")
    )
    for material in sys.argv[1:] or ["Sheet steel", "Plywood", "Leather", "Paper"]:
        for path in SHEETS:
            vertices, faces = load(path)
            diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
            before = radii_beyond(vertices, faces)
            print_row(
                material,
                path.stem,
                "the original",
                "0",
                *(f"{100 * radius / diagonal:.2f}" for radius in before),
            )
            for smoothness in SMOOTHNESSES:
                moved = make_developable(vertices, faces, material=material, smoothness=smoothness)
                move = np.linalg.norm(moved.vertices - vertices, axis=1).mean()
                radii = radii_beyond(moved.vertices, faces)
                print_row(
                    material,
                    path.stem,
                    f"{smoothness:g}",
                    f"{100 * move / diagonal:.3f}",
                    *(f"{100 * radius / diagonal:.2f}" for radius in radii),
                )


if __name__ == "__main__":
    main()
