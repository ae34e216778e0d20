# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the stock meshlabserver 2020.09 with the plugin; DEVELOPABLE_MESHLABSERVER names another command."""

from __future__ import annotations

import dataclasses
import os
import shlex
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import mlx_scripts
import numpy as np
import pymeshlab

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "meshlabserver.sh"
COMMAND = shlex.split(os.environ.get("DEVELOPABLE_MESHLABSERVER", f"bash {shlex.quote(str(SCRIPT))}"))


@dataclasses.dataclass(frozen=True)
class Run:
    """How a run of meshlabserver ended, and what it printed."""

    exit_code: int
    printed: str

    @property
    def values(self) -> dict[str, str]:
        """What the log says a key, the last one where it says several."""
        return dict(line.split(": ", 1) for line in self.printed.splitlines() if ": " in line)

    def number(self, key: str) -> float:
        return float(self.values[key])


def run(script: Path, source: Path | None = None, target: Path | None = None) -> Run:
    """Applies a script to a mesh file, saving positions, quality and colours."""
    command = [*COMMAND]
    if source is not None:
        command += ["-i", str(source)]
    if target is not None:
        command += ["-o", str(target), "-m", "vq", "vc"]
    command += ["-s", str(script)]
    result = subprocess.run(command, capture_output=True, timeout=300, check=False)
    return Run(result.returncode, result.stdout.decode(errors="replace"))


def run_filters(folder: Path, mesh: tuple[np.ndarray, np.ndarray], *filters: ElementTree.Element) -> Run:
    """Applies filters to a mesh, from in.ply in the folder to out.ply."""
    source = save_mesh(folder / "in.ply", *mesh)
    return run(mlx_scripts.write_script(folder / "run.mlx", *filters), source, folder / "out.ply")


def results(
    folder: Path, mesh: tuple[np.ndarray, np.ndarray], *filters: ElementTree.Element
) -> tuple[Run, pymeshlab.MeshSet]:
    """The run of filters on a mesh, which must end well, and the mesh saved."""
    ended = run_filters(folder, mesh, *filters)
    assert ended.exit_code == 0, ended.printed
    return ended, load(folder / "out.ply")


def save_mesh(path: Path, positions: np.ndarray, triangles: np.ndarray | None = None) -> Path:
    """A PLY file with positions and faces only. (2020.09 as Debian has it aborts on every OBJ file.)"""
    count = 0 if triangles is None else len(triangles)
    lines = ["ply", "format ascii 1.0", f"element vertex {len(positions)}"]
    lines += [f"property double {axis}" for axis in "xyz"]
    lines += [f"element face {count}", "property list uchar int vertex_indices", "end_header"]
    lines += [" ".join(repr(float(value)) for value in position) for position in positions]
    lines += [f"3 {a} {b} {c}" for a, b, c in (() if triangles is None else triangles)]
    path.write_text("\n".join(lines) + "\n")
    return path


def load(path: Path) -> pymeshlab.MeshSet:
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes
