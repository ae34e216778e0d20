# SPDX-License-Identifier: GPL-3.0-or-later
"""What the options of Local Developability gain and lose, and what its operations cost.

Run by bench/run.sh: local_method.py EXECUTABLE [MESH...]; without a mesh those of `meshes/`.
"""

import math
import subprocess
import sys
from pathlib import Path

import meshlab_developable
import pymeshlab

MODELS = Path(__file__).resolve().parent.parent / "meshes"
FILTER = "apply_coord_local_developability"
TOLERANCE = 0.01  # rad, the paper's

OPTIONS = {
    "the paper's": {},
    "descent": {"descent": True},
    "smoothing 0.01": {"smoothing": 0.01},
    "descent, smoothing 0.1": {"descent": True, "smoothing": 0.1},
    "descent, seams move together": {"descent": True, "assembling_vertices": "Move together"},
    "no self-intersections": {"avoid_self_intersections": True},
}

Report = dict[str, float]


def run(mesh: str, **parameters: object) -> Report:
    """The filter's report on a mesh."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(mesh)
    return meshes.apply_filter(FILTER, angle_tolerance=TOLERANCE, **parameters)


def run_down_to(mesh: str, detect_function: float, **parameters: object) -> Report:
    """The report of the shortest run whose G ends no higher: G never rises with the number of operations."""
    too_few, enough = 0, 500_000
    report = run(mesh, **parameters)
    while enough - too_few > 1:
        middle = (too_few + enough) // 2
        shorter = run(mesh, max_operations=middle, **parameters)
        if shorter["detect_function_after"] > detect_function:
            too_few = middle
        else:
            enough, report = min(middle, int(shorter["iterations"])), shorter
    return report


def line(name: str, report: Report) -> str:
    """One line of a table."""
    return (
        f"| {name} | {report['detect_function_after'] / report['detect_function_before']:.3f} "
        f"| {report['developability_after']:.3f} | {report['total_absolute_curvature_after']:.2f} "
        f"| {math.degrees(report['roughness_after']):.2f} | {report['mean_displacement']:.4f} "
        f"| {report['max_displacement']:.3f} | {report['iterations']} | {report['set_aside']} "
        f"| {report['refused_moves']} | {report['seconds']:.2f} |"
    )


def print_options(mesh: str) -> None:
    """Each option on one mesh; then smoothing against none at equal G."""
    start = run(mesh, max_operations=0)
    print(
        f"\n{Path(mesh).stem}: D {start['developability_before']:.3f}, "
        f"C {start['total_absolute_curvature_before']:.2f} rad, "
        f"roughness {math.degrees(start['roughness_before']):.2f}° before\n"
    )
    print(
        "| options | G/G0 | D | C, rad | roughness, ° | mean move | largest | visits | aside | refused | s |"
    )
    print("|---" * 11 + "|")
    for name, parameters in OPTIONS.items():
        print(line(name, run(mesh, **parameters)), flush=True)
    for smoothing in (0.01, 0.1):
        smooth = run(mesh, descent=True, smoothing=smoothing)
        plain = run_down_to(mesh, smooth["detect_function_after"], descent=True)
        print(line(f"descent, no smoothing, as far as with {smoothing}", plain), flush=True)


def print_costs(executable: str) -> None:
    """Nanoseconds an operation at growing sizes."""
    print("| vertices | ns an operation | operations a second | ns without self-intersections | times |")
    print("|---|---|---|---|---|")
    output = subprocess.run([executable], check=True, capture_output=True, text=True).stdout
    for vertices, plain, avoiding in (map(float, row.split()) for row in output.splitlines()):
        print(
            f"| {vertices:.0f} | {plain:.0f} | {1e9 / plain:.2g} | {avoiding:.0f} | {avoiding / plain:.1f} |"
        )


def main() -> None:
    """Print the tables."""
    meshlab_developable.load()
    models = [str(MODELS / f"{name}.obj") for name in ("dented_shell", "shoe_upper", "short_pants")]
    for mesh in sys.argv[2:] or models:
        print_options(mesh)
    print()
    print_costs(sys.argv[1])


if __name__ == "__main__":
    main()
