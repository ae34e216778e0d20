# SPDX-License-Identifier: GPL-3.0-or-later
"""What benchmarks share: programs that say their numbers, files of meshes, rows of tables."""

import subprocess
from collections.abc import Sequence
from pathlib import Path


def said(*command: object) -> str:
    """What a program prints. Raises subprocess.CalledProcessError when it fails."""
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout


def files_below(folder: Path) -> list[Path]:
    """The files of a folder and of those in it, in order of their paths."""
    return sorted(path for path in folder.rglob("*") if path.is_file())


def print_head(columns: Sequence[str]) -> None:
    """The first two lines of a table."""
    print(f"| {' | '.join(columns)} |\n{'|---' * len(columns)}|")


def print_row(*cells: object) -> None:
    """A line of a table, at once."""
    print(f"| {' | '.join(map(str, cells))} |", flush=True)


def write_off(path: Path, vertices: Sequence[Sequence[float]], triangles: Sequence[Sequence[int]]) -> None:
    """An OFF file with every digit of the coordinates."""
    lines = ["OFF", f"{len(vertices)} {len(triangles)} 0"]
    lines += [" ".join(repr(float(coordinate)) for coordinate in vertex) for vertex in vertices]
    lines += [f"3 {a} {b} {c}" for a, b, c in triangles]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
