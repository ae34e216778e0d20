# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a thickness keeps a sheet above its smallest radius: bash bench/run.sh material_bending

Each model of a sheet that bears 0.12 and 1 % of strain, at thicknesses whose radius is 5, 8 and 12 % of the
diagonal: the share of the area that is bent more tightly on the original, without and with the thickness, the
mean moves, the greatest strain of the pattern, and how many times the processor time it takes.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
from common import print_head, print_row
from meshlab_developable import make_developable
from models import SHEETS, bending_radii, load

STRAINS = (0.12, 1.0)  # per cent
RADII = (0.05, 0.08, 0.12)  # of the diagonal


def share_below(vertices, faces, radius: float) -> float:
    """The share of the area, a third of each triangle to its corners, that is bent more tightly."""
    radii, shares = bending_radii(vertices, faces)
    return float(shares[radii < radius].sum())


def moved(vertices, faces, strain: float, radius: float) -> tuple[Any, float]:
    """The result for a sheet of that least radius, and processor seconds; of any radius where that is 0."""
    sheet = {"name": "Sheet", "stretch": strain, "compression": strain, "source": "this table"}
    sheet |= {"elastic_strain": strain}
    begin = time.process_time()
    result = make_developable(vertices, faces, material=sheet, thickness=2 * strain / 100 * radius)
    return result, time.process_time() - begin


def main() -> None:
    """Print the table."""
    print_head(
        (
            "mesh", "strain, %", "radius, %", "below: original, %", "without, %", "with, %",
            "mean move: without, %", "with, %", "strain, %", "times",
        )
    )  # fmt: skip
    for path in SHEETS:
        vertices, faces = load(path)
        diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
        for strain in STRAINS:
            free, free_seconds = moved(vertices, faces, strain, 0)
            for share in RADII:
                bent, seconds = moved(vertices, faces, strain, share * diagonal)
                shapes = (vertices, free.vertices, bent.vertices)
                below = [100 * share_below(shape, faces, share * diagonal) for shape in shapes]
                moves = [100 * np.linalg.norm(s - vertices, axis=1).mean() / diagonal for s in shapes[1:]]
                strains = max(bent.report.max_stretch, bent.report.max_compression)
                numbers = [f"{value:.2f}" for value in below] + [f"{value:.3f}" for value in moves]
                times = f"{seconds / free_seconds:.1f}"
                print_row(path.stem, f"{strain:g}", f"{100 * share:g}", *numbers, f"{strains:.4f}", times)


if __name__ == "__main__":
    main()
