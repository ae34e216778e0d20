# SPDX-License-Identifier: GPL-3.0-or-later
"""What each constant of the constrained Newton method is good for: its effect when four times less and more.

Run by bench/run.sh: ablation.py EXECUTABLE [CONSTANT|FILE]...
Constants are those of NewtonTuning, all of them when none is named; files of meshes take the place of the
usual ones, which are the grids of 31 x 31 and 61 x 61 and the models. A row has how many meshes become
developable, how far these move and how long all take, each beside the same with the usual value. Times are
of this run, a mesh after the other.
"""

import math
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

from common import print_head, print_row, said
from solvers import convert, grids, models

FACTORS = (0.25, 4.0)


class Outcome(NamedTuple):
    """Of one mesh."""

    converged: bool
    displacement: float  # mean, % of the diagonal
    seconds: float


def outcome(executable: str, mesh: Path, after: Path, *change: object) -> Outcome:
    """Run the method on a mesh, with a constant changed or none."""
    seconds, _, status = said(executable, "run", "constrained_newton", mesh, after, *change).split(" ", 2)
    displacement = float(said(executable, "measure", mesh, after).split()[5])
    return Outcome(status.strip() in ("converged", "nothing to do"), displacement, float(seconds))


def mean_ratio(pairs: list[tuple[float, float]]) -> float:
    """Geometric mean of a / b; not a number when there is none."""
    logarithms = [math.log(a / b) for a, b in pairs if a > 0 and b > 0]
    return math.exp(sum(logarithms) / len(logarithms)) if logarithms else math.nan


def print_rows(executable: str, names: list[str], meshes: list[Path], after: Path) -> None:
    """A row for each constant, and for each of its values but the usual one."""
    usual = [outcome(executable, mesh, after) for mesh in meshes]
    print_row("none", "", sum(one.converged for one in usual), "1", "1")
    for line in said(executable, "constants").splitlines():
        name, value = line.split()
        if names and name not in names:
            continue
        for factor in FACTORS:
            found = [outcome(executable, mesh, after, name, factor) for mesh in meshes]
            both = [
                pair for pair in zip(found, usual, strict=True) if pair[0].converged and pair[1].converged
            ]
            moved = mean_ratio([(new.displacement, old.displacement) for new, old in both])
            taken = sum(one.seconds for one in found) / sum(one.seconds for one in usual)
            new_value = f"{float(value) * factor:g}"
            print_row(name, new_value, sum(one.converged for one in found), f"{moved:.3f}", f"{taken:.2f}")


def main() -> None:
    """Print the table."""
    executable, words = sys.argv[1], sys.argv[2:]
    files = [Path(word) for word in words if Path(word).is_file()]
    names = [word for word in words if not Path(word).is_file()]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        meshes = [convert(path, folder) for path in files]
        if not meshes:
            meshes = [*grids(executable, folder, (31, 61)), *models(folder)]
        print_head(("constant", "value", f"converged of {len(meshes)}", "mean move, ratio", "time, ratio"))
        print_rows(executable, names, meshes, folder / "after.off")


if __name__ == "__main__":
    main()
