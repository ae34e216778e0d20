# SPDX-License-Identifier: GPL-3.0-or-later
"""What a batch costs besides its method: bash bench/run.sh batch [COUNT], 1000 panels of 1024 vertices.

Runs once with a method that does no step, so that what is left is overhead, and once as users run it. Costs
are processor time of all the processes together, which others on the machine change little.
"""

import contextlib
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import psutil
import pyarrow.parquet
from models import Array, grid

SIDE = 32  # vertices along an edge of a panel
NO_STEP = 'solver = "Conjugate gradient"\nmax_iterations = 0'


def write_panel(path: Path, seed: int) -> None:
    """A bent sheet with bumps, no two alike."""
    random = np.random.default_rng(seed)

    def sheet(u: Array, v: Array) -> Array:
        height = 0.3 * np.sin(2 * u)
        for _ in range(3):
            middle_u, middle_v = random.uniform(0.2, 0.8, 2)
            bump = np.exp(-((u - middle_u) ** 2 + (v - middle_v) ** 2) / 0.02)
            height += random.uniform(-0.03, 0.03) * bump
        return height

    vertices, faces = grid(SIDE, sheet)
    header = f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\n"
    header += "".join(f"property double {axis}\n" for axis in "xyz")
    header += f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    with path.open("w") as file:
        file.write(header)
        np.savetxt(file, vertices, "%.17g")
        np.savetxt(file, faces, "3 %d %d %d")


def processor_seconds() -> float:
    """Of all the processes that this one has started and seen end, and theirs."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def runnable_seconds(process: psutil.Process) -> dict[int, float]:
    """How long each child that works on meshes has run or waited for a core, which others may hold."""
    seconds = {}
    with contextlib.suppress(psutil.Error, OSError):
        for child in process.children(recursive=True):
            if "meshlab_developable.batch.child" in child.cmdline():
                ran, waited = Path(f"/proc/{child.pid}/schedstat").read_text().split()[:2]
                seconds[child.pid] = (int(ran) + int(waited)) / 1e9
    return seconds


def run(panels: Path, out: Path, parameters: str) -> tuple[float, float, float, list[dict[str, float]]]:
    """Processor seconds, seconds, seconds in which children had work in hand, and the rows."""
    settings = out.with_suffix(".toml")
    settings.write_text(f"[parameters]\n{parameters}\n")
    command = [sys.executable, "-m", "meshlab_developable.command_line", "batch", str(panels), "--quiet"]
    command += ["--out", str(out), "--parameters", str(settings)]
    before, began, busy = processor_seconds(), time.monotonic(), {}
    with subprocess.Popen(command) as batch:
        process = psutil.Process(batch.pid)
        while batch.poll() is None:
            busy |= runnable_seconds(process)
            time.sleep(0.2)
    spent = processor_seconds() - before, time.monotonic() - began, sum(busy.values())
    return *spent, pyarrow.parquet.read_table(out / "results.parquet").to_pylist()


def main() -> None:
    """Prints a table."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    with tempfile.TemporaryDirectory() as folder:
        panels = Path(folder, "panels")
        panels.mkdir()
        for number in range(count):
            write_panel(panels / f"panel{number:05}.ply", number)
        empty, _, _, rows = run(panels, Path(folder, "empty"), NO_STEP)
        print(f"{count} panels of {SIDE * SIDE} vertices, {os.cpu_count()} cores")
        print(f"no step: {1000 * empty / count:.1f} ms of processor time a panel in all, of which")
        print(f"  {1000 * sum(row['seconds'] for row in rows) / count:.1f} ms in the filter (by the clock)")
        spent, took, busy, rows = run(panels, Path(folder, "full"), "")
        done = sum(row["state"] == "done" for row in rows)
        print(f"as it comes: {1000 * spent / count:.1f} ms of processor time a panel in all, {done} done")
        share = busy / took / (os.cpu_count() or 1)
        print(
            f"  {took:.0f} s by the clock, start and end included; children had work in {100 * share:.1f} %"
        )


if __name__ == "__main__":
    main()
