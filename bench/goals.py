# SPDX-License-Identifier: GPL-3.0-or-later
"""How long things take, each beside what is wanted of it.

Run by bench/run.sh: goals.py EXECUTABLE [quick]
quick: without what has a million vertices.

What is wanted are seconds of a machine on which the paper's 200 steps take 1.7 s at 10 201 vertices; here
they are scaled by what those take. Runs come one after the other; say so where the machine was not idle.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from common import print_head, print_row, said, write_off
from meshlab_developable import flatten, make_developable, measure
from models import SHEETS, Array, Faces, grid, load
from scipy.spatial import cKDTree

PAPER_SECONDS = 1.7
GROUPS = ((101, 0.3), (317, 3), (1001, 60))  # columns of the bumped cylinder, wanted seconds
HARD = 100_000  # vertices
EDGE_NOISE = 0.02  # edge lengths


def run(executable: str, method: str, mesh: Path, threads: int = 0) -> tuple[float, float, float]:
    """Seconds, megabytes and the curvature that is left, rad; 0 threads: as many as there are."""
    if threads:
        os.environ["OMP_NUM_THREADS"] = str(threads)
    after = mesh.with_name("after.off")
    try:
        seconds, megabytes, _ = said(executable, "run", method, mesh, after).split(" ", 2)
    finally:
        os.environ.pop("OMP_NUM_THREADS", None)
    return float(seconds), float(megabytes), measure(after).measures.total_absolute_curvature


def quartered(vertices: Array, faces: Faces) -> tuple[Array, Faces]:
    """Each triangle in four, along its edges."""
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    ends, middle = np.unique(edges, axis=0, return_inverse=True)
    ab, bc, ca = (len(vertices) + middle.reshape(3, -1)).astype(np.int32)
    a, b, c = faces.T
    corners = ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
    return (
        np.concatenate([vertices, vertices[ends].mean(axis=1)]),
        np.concatenate([np.stack(triangle, -1) for triangle in corners]),
    )


def hard_shapes(folder: Path) -> Iterator[Path]:
    """Models of `meshes`, refined to HARD vertices or a little more, smooth and with noise."""
    random = np.random.default_rng(1)
    for path in SHEETS[:3]:
        vertices, faces = load(path)
        while len(vertices) < HARD:
            vertices, faces = quartered(vertices, faces)
        nearest = cKDTree(vertices).query(vertices, 2)[0][:, 1]
        for noise in (0.0, EDGE_NOISE):
            target = folder / f"{path.stem}{' with noise' if noise else ''}.off"
            write_off(
                target, vertices + noise * nearest[:, None] * random.uniform(-1, 1, vertices.shape), faces
            )
            yield target


def bumped_sheet(columns: int) -> tuple[Array, Faces]:
    """A bent sheet with a bump, of so many vertices along each side."""
    flat, faces = grid(columns, lambda u, v: np.exp(-((u - 0.5) ** 2 + (v - 0.5) ** 2) / 0.04))
    u, v, bump = flat.T
    radius = 1 + 0.04 * bump
    return np.stack([radius * np.sin(1.2 * u), v, radius * np.cos(1.2 * u)], -1), faces


def seconds_of(work: Callable[[], object]) -> float:
    """Of one call."""
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def cylinders(executable: str, folder: Path, quick: bool) -> float:
    """The bumped cylinder in its sizes. Returns how slow this machine is."""
    slowness, last = 1.0, (0, 0.0)
    for columns, wanted in GROUPS[: 2 if quick else 3]:
        mesh = folder / f"{columns}.off"
        said(executable, "shape", "bump", columns, 0, mesh)
        paper = run(executable, "conjugate_gradient_200", mesh)[0]
        if not last[0]:
            slowness = paper / PAPER_SECONDS
        seconds, megabytes, left = run(executable, "constrained_newton", mesh)
        single = run(executable, "constrained_newton", mesh, threads=1)[0]
        name = f"bumped cylinder, {columns**2} vertices"
        print_row(f"{name}, C = {left:.1e}", f"{seconds:.2f} s", f"{wanted * slowness:.2f} s")
        print_row(f"{name}, beside the paper's 200 steps ({paper:.1f} s)", f"{seconds / paper:.2f}", "0.25")
        if last[0]:
            power = np.log(seconds / last[1]) / np.log(columns**2 / last[0])
            print_row(f"{name}, growth from the last", f"n^{power:.2f}", "n^1.15")
        if columns == GROUPS[2][0]:
            print_row(f"{name}, memory", f"{megabytes:.0f} MB", "3000 MB")
            print_row(f"{name}, one thread over all", f"{single / seconds:.2f}", "1.5")
            print_row(f"{name}, the paper's 200 steps", f"{paper:.0f} s", f"{300 * slowness:.0f} s")
        last = columns**2, seconds
    return slowness


def main() -> None:
    """Print the table."""
    executable, quick = sys.argv[1], sys.argv[2:] == ["quick"]
    print_head(("what", "measured", "wanted, at most (of threads: at least)"))
    with tempfile.TemporaryDirectory() as name:
        slowness = cylinders(executable, Path(name), quick)
        for mesh in hard_shapes(Path(name)):
            paper = run(executable, "conjugate_gradient_200", mesh)[0]
            seconds, _, left = run(executable, "constrained_newton", mesh)
            what = f"{mesh.stem}, refined beyond {HARD} vertices"
            print_row(f"{what}, C = {left:.1e}", f"{seconds:.1f} s", f"{20 * slowness:.1f} s")
            print_row(
                f"{what}, beside the paper's 200 steps ({paper:.1f} s)", f"{seconds / paper:.2f}", "0.25"
            )
    panel = bumped_sheet(32)
    make_developable(*panel)
    alone = min(seconds_of(lambda: make_developable(*panel)) for _ in range(10))
    print_row("a panel of 1024 vertices, through Python", f"{1000 * alone:.0f} ms", f"{40 * slowness:.0f} ms")
    count = 1000
    many = (
        np.concatenate([panel[0] + [3 * i, 0, 0] for i in range(count)]),
        np.concatenate([panel[1] + i * len(panel[0]) for i in range(count)]),
    )
    together = seconds_of(lambda: make_developable(*many))
    cores = len(os.sched_getaffinity(0))
    print_row(
        f"{count} of them in one layer, over as many alone", f"{together * cores / count / alone:.2f}", "1.10"
    )
    sheet = bumped_sheet(317)
    print_row(
        "laying flat 200 000 triangles",
        f"{seconds_of(lambda: flatten(*sheet)):.1f} s",
        f"{4 * slowness:.1f} s",
    )
    plugin = Path("build/pymeshlab-2025.7/libfilter_developable.so").stat().st_size / 1e6
    print_row("the plugin", f"{plugin:.1f} MB", "10 MB")


if __name__ == "__main__":
    main()
