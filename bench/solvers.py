# SPDX-License-Identifier: GPL-3.0-or-later
"""What each solver makes of the same meshes: how far from developable and from the original, what damage.

Side by side: constrained Newton, the paper's conjugate gradients, the local method, the least-norm step of
Wang 2008, and MeshLab's own "Make mesh developable" (Stein, Grinspun, Crane 2018), each with its defaults.

Run by bench/run.sh: solvers.py EXECUTABLE [quick|grids|models|panels|sizes|FILE]...
quick: grids of 31 x 31, models and panels; grids: 31, 101 and 201 columns, MeshLab's filter on 31 only.
sizes: the bumped cylinder with 1, 10, 100 and 1000 thousand vertices, beside the paper's method with both
tolerances 0. Panels are those of pymeshlab and of the package libcgal-demo. Without arguments: quick.
"""

import math
import subprocess
import sys
import tarfile
import tempfile
import time
from pathlib import Path

import pymeshlab
from common import print_head, print_row, said, write_off

METHODS = ("constrained_newton", "conjugate_gradient", "local", "least_norm", "meshlab")
SHAPES = ("cap", "saddle", "bump", "wave", "vamp", "steep_bump", "holes")
NOISE = 0.02  # edge lengths
DEMO = Path("/usr/share/doc/libcgal-dev/data.tar.gz")
DEMO_MESHES = ("nefertiti", "patch-01", "mushroom", "three_peaks")
COLUMNS = (
    "mesh",
    "method",
    "vertices",
    "seconds",
    "MB",
    "C before",
    "C",
    "G/G0",
    "greatest g",
    "mean displacement",
    "greatest",
    "mean distance",
    "greatest",
    "wrinkling",
    "smallest angle before",
    "after",
    "flipped",
    "strain when flat",
    "status",
)


def load(path: Path) -> pymeshlab.MeshSet:
    """Read any mesh file that MeshLab reads."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes


def convert(source: Path, folder: Path) -> Path:
    """Turn a mesh file into OFF."""
    meshes = load(source)  # which has to outlive its mesh
    mesh = meshes.current_mesh()
    target = folder / f"{source.stem}.off"
    write_off(target, mesh.vertex_matrix(), mesh.face_matrix())
    return target


def grids(executable: str, folder: Path, sizes: tuple[int, ...]) -> list[Path]:
    """Make the shapes over a grid, each also with noise."""
    paths = []
    for size in sizes:
        for name in SHAPES:
            for noise in (0.0, NOISE):
                path = folder / f"{name}_{size}{'_noise' if noise else ''}.off"
                said(executable, "shape", name, size, noise, path)
                paths.append(path)
    return paths


def panels(folder: Path) -> list[Path]:
    """Panels of other people."""
    bunny = Path(pymeshlab.__file__).parent / "tests/sample_meshes/bunny10k_textured.obj"
    paths = [convert(bunny, folder)] if bunny.exists() else []
    if not DEMO.exists():
        print("SKIPPED: the panels of libcgal-demo, which is not installed", file=sys.stderr)
        return paths
    with tarfile.open(DEMO) as archive:
        for name in DEMO_MESHES:
            target = folder / "demo" / f"{name}.off"
            target.parent.mkdir(exist_ok=True)
            target.write_bytes(archive.extractfile(f"data/meshes/{name}.off").read())
            paths.append(convert(target, folder))
    return paths


def models(folder: Path) -> list[Path]:
    """The models of this project."""
    return [convert(path, folder) for path in sorted(Path("meshes").glob("*.obj"))]


def run_meshlab(before: Path, after: Path) -> str:
    """Run MeshLab's own filter, its faces left as they are."""
    meshes = load(before)
    start = time.perf_counter()
    meshes.apply_filter("apply_coord_developability_of_mesh", edgeflips=False, edgecollapses=False)
    seconds = time.perf_counter() - start
    mesh = meshes.current_mesh()
    write_off(after, mesh.vertex_matrix(), mesh.face_matrix())
    return f"{seconds} {peak_megabytes()} done"


def peak_megabytes() -> float:
    """Peak memory of this process."""
    status = Path("/proc/self/status").read_text(encoding="ascii")
    return float(status.split("VmHWM:")[1].split()[0]) / 1024


def row(executable: str, method: str, before: Path, after: Path) -> str:
    """Run one method on one mesh and describe the outcome as a row of the table."""
    command = [executable, "run", method] if method != "meshlab" else [sys.executable, __file__, "--meshlab"]
    done = subprocess.run([*command, before, after], capture_output=True, text=True, check=False)
    head = f"| {before.stem} | {method.replace('_', ' ')} "
    if done.returncode != 0:
        return f"{head}{'|' * 16} {done.stderr.strip()} |"
    seconds, megabytes, status = done.stdout.strip().split(" ", 2)
    vertices, *numbers = said(executable, "measure", before, after).split()
    values = [f"{float(number):.3g}" for number in numbers]
    cells = [vertices, f"{float(seconds):.2f}", f"{float(megabytes):.0f}", *values, status]
    return f"{head}| {' | '.join(cells)} |"


def sizes(executable: str) -> None:
    """Print how time and memory grow with the number of vertices."""
    head = ("seconds: constrained Newton", "power of n", "MB", "C", "paper's 200 steps", "C")
    print_head(("vertices", *head))
    with tempfile.TemporaryDirectory() as name:
        before, after = Path(name) / "before.off", Path(name) / "after.off"
        last = (0, 0.0)
        for columns in (32, 101, 317, 1001):
            said(executable, "shape", "bump", columns, 0, before)
            cells = []
            for method in ("constrained_newton", "conjugate_gradient_200"):
                words = said(executable, "run", method, before, after).split()
                measured = said(executable, "measure", before, after).split()
                cells.append((float(words[0]), float(words[1]), float(measured[2])))
            (ours, megabytes, left), (paper, _, left_by_paper) = cells
            power = math.log(ours / last[1]) / math.log(columns**2 / last[0]) if last[0] else math.nan
            last = columns**2, ours
            texts = (f"{ours:.2f}", f"{power:.2f}", f"{megabytes:.0f}", f"{left:.1e}")
            print_row(columns**2, *texts, f"{paper:.2f}", f"{left_by_paper:.2g}")


def main() -> None:
    """Print the table."""
    if sys.argv[1] == "--meshlab":
        print(run_meshlab(Path(sys.argv[2]), Path(sys.argv[3])))
        return
    executable, wanted = sys.argv[1], sys.argv[2:] or ["quick"]
    if wanted == ["sizes"]:
        sizes(executable)
        return
    print_head(COLUMNS)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        choices = {
            "quick": lambda: [*grids(executable, folder, (31,)), *models(folder), *panels(folder)],
            "grids": lambda: grids(executable, folder, (31, 101, 201)),
            "models": lambda: models(folder),
            "panels": lambda: panels(folder),
        }
        for word in wanted:
            meshes = choices[word]() if word in choices else [convert(Path(word), folder)]
            for mesh in meshes:
                for method in METHODS if mesh.stat().st_size < 1e6 else METHODS[:-1]:
                    print(row(executable, method, mesh, folder / "after.off"), flush=True)


if __name__ == "__main__":
    main()
