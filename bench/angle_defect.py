# SPDX-License-Identifier: GPL-3.0-or-later
"""Nanoseconds a triangle: our angle defects and gradient beside MeshLab's own developability energy.

MeshLab's "Make mesh developable" (Stein, Grinspun, Crane 2018) does not tell the time of one evaluation: it
is the difference between two runs with fixed steps too small to move anything, over the difference of their
numbers of evaluations; one evaluation of it is an energy with its gradient too.

Run by bench/run.sh: angle_defect.py EXECUTABLE
"""

import sys
import tempfile
import time
from pathlib import Path

import pymeshlab
from common import print_head, print_row, said

SIZES = (10_000, 100_000, 1_000_000)


def meshlab_seconds(path: Path, evaluations: int) -> float:
    """Processor seconds of MeshLab's filter for some evaluations of its energy and gradient."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    start = time.process_time()
    meshes.apply_filter(
        "apply_coord_developability_of_mesh",
        optmethod="[F] Fixed stepsize",
        maxfunevals=evaluations,
        eps=0,
        stepsize=1e-15,
        edgeflips=False,
        edgecollapses=False,
    )
    return time.process_time() - start


def meshlab_nanoseconds(path: Path, triangles: int) -> float:
    """Nanoseconds a triangle of one evaluation in MeshLab, the better of two measurements."""
    few, many = (1, 4) if triangles > 300_000 else (1, 11)
    differences = [meshlab_seconds(path, many) - meshlab_seconds(path, few) for _ in range(2)]
    return min(differences) / (many - few) / triangles * 1e9


def main() -> None:
    """Print the table."""
    columns = [
        "triangles",
        "defects, ns",
        "gradient, ns",
        "both, ns",
        "both without AVX2, ns",
        "MeshLab's energy, ns",
        "times faster",
        "global, bytes",
        "local, bytes",
    ]
    print_head(columns)
    with tempfile.TemporaryDirectory() as folder:
        for size in SIZES:
            mesh = Path(folder) / f"{size}.off"
            numbers = map(float, said(sys.argv[1], size, mesh).split())
            triangles, defects, gradient, narrow, for_global, for_local = numbers
            ours, theirs = defects + gradient, meshlab_nanoseconds(mesh, int(triangles))
            times = (f"{value:.1f}" for value in (defects, gradient, ours, narrow))
            whole = (f"{value:.0f}" for value in (theirs, theirs / ours, for_global, for_local))
            print_row(f"{triangles:.0f}", *times, *whole)


if __name__ == "__main__":
    main()
