# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor seconds of a million distances to a surface, on one core, its search tree built each time.

Run by bench/run.sh: surface_distance.py EXECUTABLE
"""

import sys

from common import print_head, print_row, said

SIZES = (1_000, 10_000, 100_000)
COLUMNS = (
    *("triangles", "on the surface, s", "0.1 % of its size away, s", "10 % away, s"),
    "10 % away in random order, s",
)


def main() -> None:
    """Print the table."""
    print_head(COLUMNS)
    for size in SIZES:
        print_row(*said(sys.argv[1], size).split())


if __name__ == "__main__":
    main()
