# SPDX-License-Identifier: GPL-3.0-or-later
"""`python -m meshlab_developable.demo`: tries the methods on meshes and writes a report."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

import pymeshlab

from meshlab_developable.demo.chart import write_histogram
from meshlab_developable.demo.document import flatness, seams, verdict, write_html, write_text
from meshlab_developable.demo.studies import studies
from meshlab_developable.demo.study import Input, Method, Study
from meshlab_developable.errors import DevelopableError
from meshlab_developable.rendering import View

ANGLE_TOLERANCE = 0.01  # rad, the paper's

METHODS = (
    Method(
        "newton",
        "Global Developability",
        "All vertices move together, by constrained Newton steps to the nearest developable shape: "
        "the default of the filter.",
        "apply_coord_global_developability",
        {"solver": "Constrained Newton"},
        flatten=True,
    ),
    Method(
        "global",
        "Global, conjugate gradient",
        "The same filter with the paper's own solver: conjugate gradients on a penalty function (Section 4).",
        "apply_coord_global_developability",
        {"solver": "Conjugate gradient"},
    ),
    Method(
        "local",
        "Local Developability",
        "One vertex moves at a time, along its normal, the worst one first (the paper's Section 5).",
        "apply_coord_local_developability",
        {},
    ),
)


def demo_inputs() -> list[Input]:
    """A scan that comes with pymeshlab and, in a source checkout, our dented shell, a garment and a toy."""
    samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"
    inputs = [
        Input(
            samples / "bunny10k_textured.obj",
            "A scan of a figurine, open underneath, that comes with pymeshlab.",
            view=View((0.25, 0.35, 1.0), (0.0, 1.0, 0.0)),
        )
    ]
    shell = Path(__file__).resolve().parents[3] / "meshes" / "dented_shell.obj"
    if shell.exists():
        what = "A bent sheet, dented by a smooth bump, in the manner of the paper's Fig. 1."
        inputs.insert(0, Input(shell, what, "cm", View((0.9, -1.6, 1.3))))
    pants = shell.with_name("short_pants.obj")
    if pants.exists():
        inputs.append(Input(pants, "Short pants of four panels, to be cut and sewn.", "cm"))
    toy = shell.with_name("toy.obj")
    if toy.exists():
        what = "A stuffed bear in one closed surface, cut into panels with darts, to be cut out and sewn."
        inputs.append(Input(toy, what, "cm", View((1.6, -1.0, 0.5)), cut=True))
    return inputs


def run(inputs: Sequence[Input], methods: Sequence[Method], folder: Path) -> list[Study]:
    """Study each input and write everything into the folder. Raises what the filters raise."""
    folder.mkdir(parents=True, exist_ok=True)
    all_studies, histograms = [], []
    for result in studies(inputs, methods, ANGLE_TOLERANCE, folder):
        source = result.source
        print(f"{source.name}: {source.what}", flush=True)
        if result.cut:
            print(f"  {seams(result.cut, source.unit)}")
        for outcome in result.outcomes:
            print(f"  {outcome.method.title}: {outcome.report.reason}")
            print(f"    {verdict(result, outcome)}", flush=True)
            if outcome.pattern:
                print(f"    {flatness(outcome.pattern)}", flush=True)
        histograms.append(folder / f"{source.name}_histogram.svg")
        write_histogram(histograms[-1], result.angle_defects, ANGLE_TOLERANCE)
        all_studies.append(result)
    write_html(folder / "report.html", all_studies, histograms)
    write_text(folder / "report.txt", all_studies)
    return all_studies


def main() -> int:
    """The command line. Returns 0, or 2 when a mesh cannot be worked on."""
    parser = argparse.ArgumentParser(prog="python -m meshlab_developable.demo", description=__doc__)
    parser.add_argument(
        "meshes", nargs="*", type=Path, help="meshes of your own instead of those of the demo"
    )
    parser.add_argument(
        "--out", type=Path, default=Path("out/demo"), help="folder for the results (%(default)s)"
    )
    arguments = parser.parse_args()
    inputs = [Input(path, f"The mesh {path.name}.") for path in arguments.meshes] or demo_inputs()
    try:
        run(inputs, METHODS, arguments.out)
    except (DevelopableError, pymeshlab.PyMeshLabException) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print(f"Report: {arguments.out / 'report.html'} (short: {arguments.out / 'report.txt'})")
    return 0


if __name__ == "__main__":
    sys.exit(main())
