# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor seconds of a million distances to a surface, on one core, its search tree built each time.

Run by bench/run.sh: surface_distance.py EXECUTABLE
"""

import subprocess
import sys

SIZES = (1_000, 10_000, 100_000)
COLUMNS = (
    *("triangles", "on the surface, s", "0.1 % of its size away, s", "10 % away, s"),
    "10 % away in random order, s",
)


def main() -> None:
    """Print the table."""
    print(f"| {' | '.join(COLUMNS)} |\n{'|---' * len(COLUMNS)}|")
    for size in SIZES:
        command = [sys.argv[1], str(size)]
        line = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        print(f"| {' | '.join(line.split())} |", flush=True)


if __name__ == "__main__":
    main()
