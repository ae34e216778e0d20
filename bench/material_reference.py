# SPDX-License-Identifier: GPL-3.0-or-later
"""How near a shape within strain bounds could be: bounded strain beside a slow, general optimiser.

`bash bench/run.sh material_reference [COLUMNS [ours]]`: six surfaces on a grid (15) at three bounds.
IPOPT (Wächter and Biegler 2006), with exact second derivatives by CasADi, looks for the least Σ m |d|² / A
under the same bounds, shape and pattern being its unknowns too: with a triangle's map F from pattern to
shape, (1 + s)² I − FᵀF and FᵀF − (1 − c)² I must be positive semidefinite. It begins once at our result and
once at the original with its pattern of least squares; the better end counts. With `ours`, for large grids,
it only begins at our result, which takes a fraction of the time. Ours has a smoothness of 1e-9, so that
bending counts for nothing there either.
"""

from __future__ import annotations

import sys

import casadi
import numpy as np
from common import print_head, print_row
from meshlab_developable import flatten, make_developable
from models import grid

SHAPES = {
    "bump": lambda u, v: 0.2 * np.exp(-12 * ((u - 0.5) ** 2 + (v - 0.5) ** 2)),
    "saddle": lambda u, v: 0.8 * (u - 0.5) * (v - 0.5) + 0.2 * (u - 0.5) ** 2,
    "dome": lambda u, v: -0.5 * ((u - 0.5) ** 2 + (v - 0.5) ** 2),
    "waves": lambda u, v: 0.06 * np.sin(7 * u) * np.cos(5 * v),
    "cap": lambda u, v: np.sqrt(1 - (u - 0.5) ** 2 - (v - 0.5) ** 2),
    "hill": lambda u, v: 0.15 * np.exp(-20 * ((u - 0.3) ** 2 + (v - 0.6) ** 2)) - 0.1 * u * v,
}
BOUNDS = (0.5, 1.0, 2.0)  # per cent, of both signs
GOOD = ("Solve_Succeeded", "Solved_To_Acceptable_Level")


def masses(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Per vertex, its share of the area."""
    x = vertices[faces]
    areas = np.linalg.norm(np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]), axis=1) / 2
    return np.bincount(faces.ravel(), np.repeat(areas / 3, 3), len(vertices)) / areas.sum()


def strain_constraints(x: casadi.SX, u: casadi.SX, faces: np.ndarray, bound: float) -> casadi.SX:
    """Five numbers a triangle that must not be negative; the last is the area of the pattern's triangle."""
    rows = []
    low, high = (1 - bound) ** 2, (1 + bound) ** 2
    for a, b, c in faces.tolist():
        edges = casadi.horzcat(u[:, b] - u[:, a], u[:, c] - u[:, a])
        area = edges[0, 0] * edges[1, 1] - edges[0, 1] * edges[1, 0]
        inverse = casadi.vertcat(
            casadi.horzcat(edges[1, 1], -edges[0, 1]), casadi.horzcat(-edges[1, 0], edges[0, 0])
        )
        f = casadi.horzcat(x[:, b] - x[:, a], x[:, c] - x[:, a]) @ inverse / area
        g = f.T @ f
        trace, determinant = g[0, 0] + g[1, 1], g[0, 0] * g[1, 1] - g[0, 1] ** 2
        rows += [
            high * high - high * trace + determinant,
            2 * high - trace,
            low * low - low * trace + determinant,
            trace - 2 * low,
            area * len(faces),
        ]
    return casadi.vertcat(*rows)


def nearest(
    vertices: np.ndarray, faces: np.ndarray, bound: float, starts: list[tuple[np.ndarray, np.ndarray]]
) -> float:
    """The least root mean squared move that IPOPT ends with; not a number where it finds none."""
    count = len(vertices)
    x, u = casadi.SX.sym("x", 3, count), casadi.SX.sym("u", 2, count)
    weight = casadi.DM(masses(vertices, faces))
    cost = casadi.sum1(casadi.sum1((x - vertices.T) ** 2).T * weight)
    limits = strain_constraints(x, u, faces, bound)
    problem = {"x": casadi.vertcat(casadi.vec(x), casadi.vec(u)), "f": 100 * cost, "g": limits}
    options = {"ipopt.print_level": 0, "print_time": False, "ipopt.max_iter": 500, "ipopt.tol": 1e-8}
    solver = casadi.nlpsol("nearest", "ipopt", problem, options)
    best = np.nan
    for shape, pattern in starts:
        result = solver(x0=np.concatenate([shape.ravel(), pattern[:, :2].ravel()]), lbg=0, ubg=np.inf)
        if solver.stats()["return_status"] in GOOD:
            best = np.fmin(best, np.sqrt(float(result["f"]) / 100))
    return best


def main() -> None:
    """Print a row for each shape and bound."""
    columns = int(sys.argv[1]) if len(sys.argv) > 1 else 15
    only_ours = sys.argv[2:] == ["ours"]
    print_head(("shape", "vertices", "allowed, %", "moved: ours", "IPOPT", "ratio"))
    for name, shape in SHAPES.items():
        vertices, faces = grid(columns, shape, alternating=True)
        for bound in BOUNDS:
            values = {"allowed_stretch": bound, "allowed_compression": bound}
            moved = make_developable(vertices, faces, method="global", smoothness=1e-9, **values)
            flat = flatten(moved.vertices, faces, **values)
            ours = np.sqrt((masses(vertices, faces) * ((moved.vertices - vertices) ** 2).sum(axis=1)).sum())
            starts = [(moved.vertices, flat.vertices), (vertices, flatten(vertices, faces).vertices)]
            theirs = nearest(vertices, faces, bound / 100, starts[:1] if only_ours else starts)
            print_row(
                name, len(vertices), f"{bound:g}", f"{ours:.5f}", f"{theirs:.5f}", f"{ours / theirs:.3f}"
            )


if __name__ == "__main__":
    main()
