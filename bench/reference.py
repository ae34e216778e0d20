# SPDX-License-Identifier: GPL-3.0-or-later
"""How near a developable shape could be: constrained Newton beside a slow, general optimiser.

IPOPT (Wächter and Biegler 2006), with exact second derivatives by CasADi, finds a local minimum of the same
length of displacements ‖d‖_W under g = 0, for a row of smoothnesses: a curve of displacement against
wrinkling, from which the displacement at the wrinkling of constrained Newton is read. Needs casadi and scipy.

Run by bench/run.sh reference [COLUMNS [SHAPE...]]: shapes of solvers.py, all by default, on a grid (31),
with and without noise.
"""

import math
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import casadi
import numpy as np
import scipy.sparse as sparse
from common import print_head, print_row, said, write_off

SHAPES = ("cap", "saddle", "bump", "wave", "vamp", "steep_bump", "holes")
SMOOTHNESSES = (3e-5, 1e-5, 3e-6, 1e-6)


def read_off(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and triangles."""
    words = path.read_text().split()
    vertices, triangles = int(words[1]), int(words[2])
    split = 4 + 3 * vertices
    points = np.array(words[4:split], float).reshape(-1, 3)
    return points, np.array(words[split:], int).reshape(triangles, 4)[:, 1:]


def inner_edges(triangles: np.ndarray) -> np.ndarray:
    """A row an inner edge: its tail and head, and the corners opposite to it at its left and right."""
    found: dict[tuple[int, int], tuple[int, int, int]] = {}
    rows = []
    for a, b, c in triangles:
        for i, j, k in ((a, b, c), (b, c, a), (c, a, b)):
            if (j, i) in found:
                rows.append((j, i, found.pop((j, i))[2], k))
            else:
                found[i, j] = (i, j, k)
    return np.array(rows)


def boundary_vertices(triangles: np.ndarray) -> set[int]:
    """Ends of the edges with one triangle."""
    half = {(a, b) for t in triangles for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
    return {vertex for a, b in half if (b, a) not in half for vertex in (a, b)}


def metric(points: np.ndarray, triangles: np.ndarray, smoothness: float) -> sparse.csc_matrix:
    """W of docs/constrained_newton.md for one patch."""
    corners = points[triangles]
    doubled = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    area, total = doubled / 2, doubled.sum() / 2
    masses = np.bincount(triangles.ravel(), np.repeat(area / 3, 3), len(points)) / total
    area_of = {frozenset(t): a for t, a in zip(triangles.tolist(), area, strict=True)}

    def cotangent(at: int, one: int, other: int) -> float:
        u, v = points[one] - points[at], points[other] - points[at]
        return float(u @ v / np.linalg.norm(np.cross(u, v)))

    rows, columns, values = [], [], []
    for row, (tail, head, left, right) in enumerate(inner_edges(triangles)):
        at_tail = cotangent(tail, head, left), cotangent(tail, head, right)
        at_head = cotangent(head, tail, left), cotangent(head, tail, right)
        both = area_of[frozenset((tail, head, left))] + area_of[frozenset((tail, head, right))]
        slope = np.array([sum(at_head), sum(at_tail), -at_tail[0] - at_head[0], -at_tail[1] - at_head[1]])
        values += list(slope * np.sqrt(smoothness * total / both))
        rows += [row] * 4
        columns += [tail, head, left, right]
    hinges = sparse.csc_matrix((values, (rows, columns)), (max(rows) + 1, len(points)))
    return sparse.csc_matrix(sparse.diags(masses) + hinges.T @ hinges)


def defects(x: casadi.SX, triangles: np.ndarray) -> casadi.SX:
    """Angle defects at the inner vertices, x being 3 x vertices."""
    boundary = boundary_vertices(triangles)
    angles: dict[int, list[casadi.SX]] = {}
    for a, b, c in triangles.tolist():
        for at, one, other in ((a, b, c), (b, c, a), (c, a, b)):
            u, v = x[:, one] - x[:, at], x[:, other] - x[:, at]
            angles.setdefault(at, []).append(
                casadi.atan2(casadi.norm_2(casadi.cross(u, v)), casadi.dot(u, v))
            )
    return casadi.vertcat(*(2 * np.pi - sum(angles[v]) for v in sorted(angles) if v not in boundary))


Limits = Callable[[casadi.SX, np.ndarray, np.ndarray], casadi.SX]


def nearest(
    points: np.ndarray,
    triangles: np.ndarray,
    smoothness: float,
    start: np.ndarray,
    limits: Limits = lambda x, points, triangles: casadi.SX(0, 1),
) -> tuple[np.ndarray, str]:
    """Where IPOPT ends from a start, and what it says of it.

    limits: of positions (3 x vertices), original points and triangles: numbers that may not be negative.
    """
    x = casadi.SX.sym("x", 3, len(points))
    weight = metric(points, triangles, smoothness).tocoo()
    w = casadi.DM.triplet(weight.row.tolist(), weight.col.tolist(), weight.data.tolist(), *weight.shape)
    d = x - points.T
    curvature, others = defects(x, triangles), limits(x, points, triangles)
    most = np.concatenate([np.zeros(curvature.shape[0]), np.full(others.shape[0], np.inf)])
    problem = {"x": casadi.vec(x), "f": casadi.trace(d @ w @ d.T) / 2, "g": casadi.vertcat(curvature, others)}
    options = {"ipopt.print_level": 0, "print_time": False, "ipopt.max_iter": 500, "ipopt.tol": 1e-7}
    solver = casadi.nlpsol("nearest", "ipopt", problem, options)
    result = solver(x0=start.ravel(), lbg=0, ubg=most)
    return np.array(result["x"]).reshape(-1, 3), solver.stats()["return_status"]


def displacement_at(wrinkling: float, curve: list[tuple[float, float, float, float, str]]) -> float:
    """Read off the curve of solved problems; not a number beyond its ends."""
    good = ("Solve_Succeeded", "Solved_To_Acceptable_Level")
    solved = sorted((wrinkles, moved) for moved, wrinkles, _, _, status in curve if status in good)
    if not solved:
        return math.nan
    wrinkles, moved = zip(*solved, strict=True)
    return float(np.interp(wrinkling, wrinkles, moved, left=math.nan, right=math.nan))


def main() -> None:
    """Print a row for each shape."""
    executable, columns = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "31"

    def measured(before: Path, after: Path) -> tuple[float, float, float]:
        """Mean displacement in % of the diagonal, wrinkling in degrees, smallest angle in degrees."""
        numbers = [float(word) for word in said(executable, "measure", before, after).split()]
        return numbers[5], numbers[9], numbers[11]

    titles = ("mesh", "moved: ours", "at the same wrinkling: IPOPT", "ratio", "wrinkling: ours")
    print_head((*titles, "IPOPT's curve: smoothness: moved, wrinkling"))
    with tempfile.TemporaryDirectory() as name:
        before, ours, other = (Path(name) / f"{part}.off" for part in ("before", "ours", "other"))
        for shape in sys.argv[3:] or SHAPES:
            for noise in ("0", "0.02"):
                said(executable, "shape", shape, columns, noise, before)
                said(executable, "run", "constrained_newton", before, ours)
                moved, wrinkling, _ = measured(before, ours)
                points, triangles = read_off(before)
                start = read_off(ours)[0]
                curve = []
                for smoothness in SMOOTHNESSES:
                    start, status = nearest(points, triangles, smoothness, start)
                    write_off(other, start, triangles)
                    curve.append((*measured(before, other), smoothness, status))
                at_same = displacement_at(wrinkling, curve)
                text = "; ".join(f"{c[3]:.0e}: {c[0]:.3g}, {c[1]:.3g} ({c[4]})" for c in curve)
                mesh = f"{shape} {columns}{' noise' if noise != '0' else ''}"
                numbers = f"{moved:.3g}", f"{at_same:.3g}", f"{moved / at_same:.2f}", f"{wrinkling:.3g}"
                print_row(mesh, *numbers, text)


if __name__ == "__main__":
    main()
