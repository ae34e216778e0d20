# SPDX-License-Identifier: GPL-3.0-or-later
"""What the constrained Newton method says of each mesh in a folder, and how long it takes, beside the paper's
200 steps on the same mesh.

Run by bench/run.sh: verdicts.py EXECUTABLE FOLDER. The folder's files and those in folders below it, in
every format that pymeshlab reads; others are left out. Seconds are the clock's: leave the machine alone.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import pymeshlab
from common import files_below, print_head, print_row, said
from solvers import convert

COLUMNS = (
    "mesh",
    "vertices",
    "verdict",
    "seconds",
    "paper's 200 steps, seconds",
    "ratio",
    "C before",
    "C",
    "C of the paper's",
    "moved, % of the diagonal: mean",
    "greatest",
    "strain when flat",
)


def run(executable: str, method: str, before: Path, after: Path) -> tuple[float, str, list[float]]:
    """Seconds, verdict, and what `measure` says of the outcome. Raises CalledProcessError for a refusal."""
    seconds, _, verdict = said(executable, "run", method, before, after).strip().split(" ", 2)
    return float(seconds), verdict, list(map(float, said(executable, "measure", before, after).split()))


def row(executable: str, source: Path, name: Path, folder: Path) -> bool:
    """Print a mesh's row; False when it is none that can be read."""
    try:
        before, after = convert(source, folder), folder / "after.off"
    except pymeshlab.PyMeshLabException:
        return False
    try:
        ours, verdict, measures = run(executable, "constrained_newton", before, after)
        paper, _, of_paper = run(executable, "conjugate_gradient_200", before, after)
    except subprocess.CalledProcessError as error:
        print_row(name, "", error.stderr.strip(), *[""] * (len(COLUMNS) - 3))
        return True
    numbers = (
        ours,
        paper,
        ours / paper,
        measures[1],
        measures[2],
        of_paper[2],
        measures[5],
        measures[6],
        measures[13],
    )
    print_row(name, int(measures[0]), verdict, *(f"{number:.3g}" for number in numbers))
    return True


def main() -> None:
    """Print the table."""
    if len(sys.argv) != 3 or not Path(sys.argv[2]).is_dir():
        sys.exit("usage: bash bench/run.sh verdicts FOLDER")
    # Absolute: pymeshlab changes the current folder when a file can't be read.
    executable, meshes = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
    print_head(COLUMNS)
    with tempfile.TemporaryDirectory() as name:
        rows = (row(executable, path, path.relative_to(meshes), Path(name)) for path in files_below(meshes))
        if not sum(rows):
            sys.exit(f"{meshes} has no mesh that pymeshlab reads")


if __name__ == "__main__":
    main()
