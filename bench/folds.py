# SPDX-License-Identifier: GPL-3.0-or-later
"""What folds inside cost: constrained Newton beside IPOPT, borders turning by no more than 4.8° in both.

Run by bench/run.sh: folds.py EXECUTABLE MESH...
IPOPT looks for the least ‖d‖_W with the hinge metric of reference.py under g = 0 and these limits, for a row
of smoothnesses: the less a surface may fold, the farther it moves. A row says by how much the worst inner
edge and 99.9 % of them fold more than before, and the mean move. Minutes for a thousand vertices.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import casadi
import numpy as np
from common import print_head, print_row, said, write_off
from fairness import bends
from models import Array, Faces, load
from reference import nearest, read_off

SMOOTHNESSES = (3e-6, 1e-5, 3e-5)
BORDER_TURN = np.radians(4.8)


def border_joints(faces: Faces) -> list[tuple[int, int, int]]:
    """Each border vertex between the one before and the one after it."""
    half = {(a, b) for t in faces.tolist() for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
    after = {a: b for a, b in half if (b, a) not in half}
    return [(a, b, after[b]) for a, b in after.items() if b in after]


def border_limits(x: casadi.SX, points: Array, faces: Faces) -> casadi.SX:
    """Numbers that are negative where a border turns by more than it may."""
    rows = []
    for before, at, after in border_joints(faces):
        u, v = points[at] - points[before], points[after] - points[at]
        lengths = np.linalg.norm(u) * np.linalg.norm(v)
        most = min(np.arccos(np.clip(u @ v / lengths, -1, 1)) + BORDER_TURN, np.pi)
        a, b = x[:, at] - x[:, before], x[:, after] - x[:, at]
        rows.append((casadi.dot(a, b) - np.cos(most) * casadi.norm_2(a) * casadi.norm_2(b)) / lengths)
    return casadi.vertcat(*rows)


def show(path: Path, method: str, shape: Array, points: Array, faces: Faces) -> None:
    """A row."""
    one_panel = np.zeros(len(faces), np.int64)
    gained = bends(shape, faces, one_panel) - bends(points, faces, one_panel)
    moved = np.linalg.norm(shape - points, axis=1).mean() / np.linalg.norm(np.ptp(points, axis=0))
    worst = f"{gained.max():.1f}", f"{np.quantile(gained, 0.999):.1f}"
    print_row(path.stem, method, *worst, f"{100 * moved:.3f}")


def main(executable: str, paths: list[str]) -> None:
    """Rows for each mesh."""
    print_head(("mesh", "by", "worst fold gained, degrees", "99.9 % below", "mean move, % of the diagonal"))
    with tempfile.TemporaryDirectory() as name:
        before, after = Path(name) / "before.off", Path(name) / "after.off"
        for path in map(Path, paths):
            points, faces = load(path)
            write_off(before, points, faces)
            said(executable, "run", "constrained_newton", before, after)
            shape = read_off(after)[0]
            show(path, "constrained Newton", shape, points, faces)
            for smoothness in SMOOTHNESSES:
                shape, status = nearest(points, faces, smoothness, shape, border_limits)
                show(path, f"IPOPT, {smoothness:g}, {status}", shape, points, faces)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
