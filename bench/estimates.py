# SPDX-License-Identifier: GPL-3.0-or-later
"""How good the estimate of the time left is: what the constrained Newton method is said to take as a whole,
beside what it takes, after a quarter, half and three quarters of a run, on each mesh in a folder.

Run by bench/run.sh: estimates.py EXECUTABLE FOLDER. Times are the processor's, on one thread.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import pymeshlab
from common import files_below, print_head, print_row, said
from solvers import convert

COLUMNS = ("mesh", "seconds", "said / taken after a quarter", "half", "three quarters")


def main() -> None:
    """Print the table."""
    if len(sys.argv) != 3 or not Path(sys.argv[2]).is_dir():
        sys.exit("usage: bash bench/run.sh estimates FOLDER")
    # Absolute: pymeshlab changes the current folder when a file can't be read.
    executable, meshes = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
    print_head(COLUMNS)
    with tempfile.TemporaryDirectory() as name:
        for path in files_below(meshes):
            try:
                words = said(executable, "estimates", convert(path, Path(name))).split()
            except (pymeshlab.PyMeshLabException, subprocess.CalledProcessError):
                continue
            print_row(path.relative_to(meshes), *(f"{float(word):.3g}" for word in words))


if __name__ == "__main__":
    main()
