# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `examples.md` and its pictures: the paper's two methods on the three models of `meshes/`.

.venv/bin/python docs/make_examples.py
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

from meshlab_developable import load
from meshlab_developable.demo.__main__ import ANGLE_TOLERANCE, METHODS
from meshlab_developable.demo.study import Input, Outcome, Study, study
from meshlab_developable.rendering import View
from PIL import Image

DOCS = Path(__file__).resolve().parent
MESHES = DOCS.parent / "meshes"
PICTURE_WIDTH = 1200  # pixels

MODELS = (
    Input(MESHES / "dented_shell.obj", "I: a bent sheet, dented", "cm", View((0.9, -1.6, 1.3))),
    Input(MESHES / "shoe_upper.obj", "II: the upper of a shoe", "cm", View((1.0, -1.6, 0.8))),
    Input(MESHES / "short_pants.obj", "III: short pants of four panels", "cm", View((0.8, -2.0, 0.5))),
)

# Which methods reached a fully developable surface in the paper (Section 6).
REACHED_IN_THE_PAPER = {"dented_shell": {"global", "local"}, "shoe_upper": set(), "short_pants": {"local"}}

HEADER = f"""# The paper's three examples

Made by `docs/make_examples.py`: the paper's two methods, with its settings, on models in the manner of its
examples (Section 6). The models are ours, so numbers are not the paper's.

- Global: conjugate gradients, η = 0.01 %, at most 200 steps.
- Local: ε = 1e-4 rad² on g², at most 500 000 operations, δ_T the mean edge length.
- Angle tolerance: {ANGLE_TOLERANCE:g} rad.

"""

COLUMNS = [
    *("model", "vertices", "triangles", "method", "D before", "D after", "C before (rad)", "C after (rad)"),
    *("G after / before", "largest distance (cm)", "steps or operations", "seconds", "what ended it"),
]


def row(result: Study, outcome: Outcome) -> str:
    """One line of the table."""
    report = outcome.report
    cells = [
        result.source.name,
        len(result.vertices),
        len(result.faces),
        outcome.method.name,
        f"{report.developability_before:.3f}",
        f"{report.developability_after:.3f}",
        f"{report.total_absolute_curvature_before:.2f}",
        f"{report.total_absolute_curvature_after:.2f}",
        f"{report.detect_function_after / report.detect_function_before:.3f}",
        f"{report.max_distance:.2f}",
        report.iterations,
        f"{report.seconds:.2g}",
        report.status.text,
    ]
    return f"| {' | '.join(map(str, cells))} |\n"


def keep_picture(source: Path, name: str) -> str:
    """A smaller copy among the documentation's pictures; returns its address from there."""
    with Image.open(source) as image:
        height = round(image.height * PICTURE_WIDTH / image.width)
        small = image.convert("RGB").resize((PICTURE_WIDTH, height), Image.Resampling.LANCZOS)
        small.save(DOCS / "pictures" / name, optimize=True)
    return f"pictures/{name}"


def comparison(result: Study) -> str:
    """Whether each method reached a developable surface, beside what the paper says."""
    here = {outcome.method.name for outcome in result.outcomes if outcome.report.converged}
    paper = REACHED_IN_THE_PAPER[result.source.name]

    def words(names: set[str]) -> str:
        return " and ".join(sorted(names)) or "neither"

    return f"Reached within the tolerance: {words(here)}; in the paper: {words(paper)}.\n"


def page(studies: Sequence[Study]) -> str:
    """The whole page."""
    table = f"| {' | '.join(COLUMNS)} |\n|{'---|' * len(COLUMNS)}\n"
    table += "".join(row(result, outcome) for result in studies for outcome in result.outcomes)
    sections = []
    for result in studies:
        figure = result.figures[0]
        address = keep_picture(figure.file, f"{result.source.name}.png")
        heading = f"\n## {result.source.what}\n\n"
        sections.append(f"{heading}{comparison(result)}\n![{figure.title}]({address})\n")
    return HEADER + table + "".join(sections)


def main() -> None:
    """Run the methods and write the page."""
    load()
    (DOCS / "pictures").mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        studies = [study(model, METHODS, ANGLE_TOLERANCE, Path(folder)) for model in MODELS]
        (DOCS / "examples.md").write_text(page(studies), encoding="utf-8")


if __name__ == "__main__":
    main()
