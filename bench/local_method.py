# SPDX-License-Identifier: GPL-3.0-or-later
"""What the options of Local Developability gain and lose, and what its operations cost.

Run by bench/run.sh: local_method.py EXECUTABLE [MESH...]; without a mesh those of `meshes/`.
"""

import math
import sys
from pathlib import Path

import meshlab_developable
import pymeshlab
from common import print_head, print_row, said

MODELS = Path(__file__).resolve().parent.parent / "meshes"
FILTER = "apply_coord_local_developability"
TOLERANCE = 0.01  # rad, the paper's

OPTIONS = {
    "the paper's": {},
    "descent": {"descent": True},
    "smoothing 0.01": {"smoothing": 0.01},
    "descent, seams move together": {"descent": True, "assembling_vertices": "Move together"},
    "no self-intersections": {"avoid_self_intersections": True},
    "descent, no self-intersections": {"descent": True, "avoid_self_intersections": True},
}
SMOOTHINGS = (0.003, 0.01, 0.03, 0.1)
DISPLACEMENTS = (0.125, 0.25, 0.5, 1, 2)  # δ_T, mean edge lengths

QUALITY = ("G/G0", "C", "roughness", "mean move", "distance")  # as Model.quality has them

Report = dict[str, float]


class Model:
    """A mesh, and the filter on it."""

    def __init__(self, path: str) -> None:
        """Read it once to know its mean edge length."""
        self.path = path
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(path)
        self.mean_edge = meshes.apply_filter("get_geometric_measures")["avg_edge_length"]

    def run(self, displacement: float = 1, **parameters: object) -> Report:
        """The filter's report; δ_T in mean edge lengths."""
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(self.path)
        limit = pymeshlab.PureValue(displacement * self.mean_edge)
        return meshes.apply_filter(FILTER, angle_tolerance=TOLERANCE, max_displacement=limit, **parameters)

    def run_down_to(self, detect_function: float, **parameters: object) -> Report:
        """The report of the shortest run whose G ends no higher: G never rises with the operations."""
        too_few, enough = 0, 500_000
        report = self.run(**parameters)
        while enough - too_few > 1:
            middle = (too_few + enough) // 2
            shorter = self.run(max_operations=middle, **parameters)
            if shorter["detect_function_after"] > detect_function:
                too_few = middle
            else:
                enough, report = min(middle, int(shorter["iterations"])), shorter
        return report

    def seconds(self, **parameters: object) -> float:
        """The least of three runs."""
        return min(self.run(**parameters)["seconds"] for _ in range(3))

    def quality(self, report: Report) -> list[str]:
        """The cells of a table that QUALITY names."""
        return [
            f"{report['detect_function_after'] / report['detect_function_before']:.3f}",
            f"{report['total_absolute_curvature_after']:.2f}",
            f"{math.degrees(report['roughness_after']):.2f}",
            f"{report['mean_displacement'] / self.mean_edge:.3f}",
            f"{report['max_distance'] / self.mean_edge:.2f}",
        ]


def print_header(*columns: str) -> None:
    """Of a new table."""
    print()
    print_head(columns)


def print_options(model: Model) -> None:
    """Each option on one mesh, with the time it takes as a multiple of the paper's."""
    print_header("options", *QUALITY, "D", "visits", "aside", "refused", "time")
    paper = model.seconds()
    for name, parameters in OPTIONS.items():
        report = model.run(**parameters)
        counts = (report[key] for key in ("iterations", "set_aside", "refused_moves"))
        times = f"{model.seconds(**parameters) / paper:.1f}"
        print_row(name, *model.quality(report), f"{report['developability_after']:.3f}", *counts, times)


def print_smoothing(model: Model) -> None:
    """Smoothing against none, at the end of the run and at equal G."""
    print_header("smoothing", *QUALITY)
    print_row(0, *model.quality(model.run(descent=True)))
    for smoothing in SMOOTHINGS:
        smooth = model.run(descent=True, smoothing=smoothing)
        plain = model.run_down_to(smooth["detect_function_after"], descent=True)
        print_row(smoothing, *model.quality(smooth))
        print_row(f"0, down to the G of {smoothing}", *model.quality(plain))


def print_seams(model: Model) -> None:
    """Seams that move together against fixed ones, at growing δ_T."""
    print_header("δ_T", "seams", *QUALITY)
    for displacement in DISPLACEMENTS:
        for seams in ("Fixed", "Move together"):
            report = model.run(displacement, descent=True, assembling_vertices=seams)
            print_row(displacement, seams, *model.quality(report))


def print_costs(executable: str) -> None:
    """Nanoseconds an operation at growing sizes."""
    print("\nNanoseconds an operation")
    print_header(
        "vertices", "ns", "operations a second", "ns without self-intersections", "times", "the whole run"
    )
    for row in said(executable).splitlines():
        vertices, plain, avoiding, plain_run, avoiding_run = map(float, row.split())
        a_second, times = f"{1e9 / plain:.2g}", f"{avoiding / plain:.1f}"
        whole = f"{avoiding_run / plain_run:.1f}"
        print_row(f"{vertices:.0f}", f"{plain:.0f}", a_second, f"{avoiding:.0f}", times, whole)


def main() -> None:
    """Print the tables. Lengths are in mean edge lengths, roughness in degrees, C in rad."""
    meshlab_developable.load()
    models = [str(MODELS / f"{name}.obj") for name in ("dented_shell", "shoe_upper", "short_pants")]
    for path in sys.argv[2:] or models:
        model = Model(path)
        start = model.run(max_operations=0)
        print(
            f"\n{Path(path).stem}: D {start['developability_before']:.3f}, "
            f"C {start['total_absolute_curvature_before']:.2f} rad, "
            f"roughness {math.degrees(start['roughness_before']):.2f}° before"
        )
        print_options(model)
        print_smoothing(model)
        if start["assembling_vertices"] > 0:
            print_seams(model)
    print_costs(sys.argv[1])


if __name__ == "__main__":
    main()
