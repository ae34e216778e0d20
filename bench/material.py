# SPDX-License-Identifier: GPL-3.0-or-later
"""How far surfaces move when some strain is allowed: bash bench/run.sh material [MESH...]

Each model, and each mesh that is named, at 0, 0.5, 1, 2 and 5 % of stretch and compression: the mean and the
largest move in per cent of the diagonal, the greatest principal strain as this program computes it from the
triangles of shape and pattern, the seconds of processor time (the least of three runs) and how many times
those of zero strain, and the mean move of the nearest point on the line from the original to the shape of
zero strain whose pattern keeps the bound.
The last line has the median, over the meshes, of how much less than that point they move at 1 %.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
from common import print_head, print_row
from meshlab_developable import flatten, make_developable
from models import load

MODELS = [
    Path(__file__).parents[1] / f"meshes/{name}.ply"
    for name in ("shoe_upper", "short_pants", "dented_shell", "hull_panel")
]
BOUNDS = (0.0, 0.5, 1.0, 2.0, 5.0)  # per cent
TOLERANCE = 1e-4
RUNS = 3


def greatest_strain(shaped, flat, shaped_faces, flat_faces) -> float:
    """max(σ1 − 1, 1 − σ2) over the triangles of both meshes, face by face."""
    x, u = shaped[shaped_faces], flat[flat_faces]
    edges_x = np.stack([x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]], axis=2)
    edges_u = np.stack([u[:, 1] - u[:, 0], u[:, 2] - u[:, 0]], axis=2)
    values = np.linalg.svd(edges_x @ np.linalg.inv(edges_u), compute_uv=False)
    return float(np.maximum(values[:, 0] - 1, 1 - values[:, 1]).max())


def pattern_strain(vertices, faces, bound: float) -> float:
    """The same of a shape's pattern within a bound, per cent."""
    flat = flatten(vertices, faces, allowed_stretch=bound, allowed_compression=bound)
    return greatest_strain(vertices, flat.vertices, faces, flat.faces)


def nearest_on_line(original, target, faces, bound: float) -> float:
    """How far along the straight line to a shape one has to go until its pattern keeps the bound, 0 to 1."""
    low, high = 0.0, 1.0
    if pattern_strain(original, faces, bound) <= bound / 100 + TOLERANCE:
        return 0.0
    for _ in range(7):
        middle = (low + high) / 2
        kept = (
            pattern_strain(original + middle * (target - original), faces, bound) <= bound / 100 + TOLERANCE
        )
        low, high = (low, middle) if kept else (middle, high)
    return high


def moved(vertices, faces, bound: float) -> tuple[Any, float]:
    """The result within a bound, and the processor seconds of the fastest of three runs."""
    seconds = float("inf")
    for _ in range(RUNS):
        begin = time.process_time()
        result = make_developable(
            vertices, faces, method="global", allowed_stretch=bound, allowed_compression=bound
        )
        seconds = min(seconds, time.process_time() - begin)
    return result, seconds


def rows_of(path: Path) -> float:
    """Print the rows of one mesh and return its move at 1 % as a share of that on the line."""
    vertices, faces = load(path)
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    target, zero_seconds, share = vertices, 0.0, float("nan")
    for bound in BOUNDS:
        result, seconds = moved(vertices, faces, bound)
        moves = 100 * np.linalg.norm(result.vertices - vertices, axis=1) / diagonal
        strain = pattern_strain(result.vertices, faces, bound)
        line = 1.0
        if bound == 0:
            target, zero_seconds = result.vertices, seconds
        else:
            line = nearest_on_line(vertices, target, faces, bound)
        line_move = 100 * line * np.linalg.norm(target - vertices, axis=1).mean() / diagonal
        if bound == 1 and line_move > 0:
            share = moves.mean() / line_move
        numbers = (f"{moves.mean():.3f}", f"{line_move:.3f}", f"{moves.max():.2f}", f"{100 * strain:.4f}")
        status = result.report.status.name.lower()
        times = f"{seconds / zero_seconds:.1f}"
        print_row(path.stem, f"{bound:g}", status, *numbers, f"{seconds:.2f}", times)
    return share


def main() -> None:
    """Print the table."""
    print_head(
        (
            "mesh", "allowed, %", "status", "mean move, %", "on the line, %", "largest move, %", "strain, %",
            "processor seconds", "times zero strain",
        )
    )  # fmt: skip
    shares = [rows_of(path) for path in [*MODELS, *map(Path, sys.argv[1:])]]
    print(f"less than on the line at 1 %, median: {100 * (1 - np.nanmedian(shares)):.0f} %")


if __name__ == "__main__":
    main()
