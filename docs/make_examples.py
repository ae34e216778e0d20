# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `examples.md` and its pictures: the paper's methods and the constrained Newton method on the three
models of `meshes/`.

.venv/bin/python docs/make_examples.py
"""

from __future__ import annotations

import dataclasses
import math
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
import pymeshlab
from meshlab_developable import LocalReport, load, make_developable
from meshlab_developable.demo.__main__ import ANGLE_TOLERANCE, METHODS
from meshlab_developable.demo.study import MAPS, Figure, Input, MapKind, Method, Outcome, Study, study
from meshlab_developable.rendering import View
from PIL import Image

DOCS = Path(__file__).resolve().parent
MESHES = DOCS.parent / "meshes"
SHAPE_WIDTH = 330  # pixels, of one shape in a picture

MODELS = (
    Input(MESHES / "dented_shell.obj", "I: a bent sheet, dented", "cm", View((0.9, -1.6, 1.3))),
    Input(MESHES / "shoe_upper.obj", "II: the upper of a shoe", "cm", View((1.0, -1.6, 0.8))),
    Input(MESHES / "short_pants.obj", "III: short pants of four panels", "cm", View((0.8, -2.0, 0.5))),
)

ANGLE_MAP, GAUSSIAN_MAP = (
    next(kind for kind in MAPS if kind.title == title) for title in ("Angle defect", "Gaussian map")
)
DISTANCE = MapKind("Distance", "distance to the original surface, {unit}", False, "", before_too=False)
MINIMUM = MapKind("Minimum curvature", "|κ_min|, 1/{unit}", False, "")
MAXIMUM = MapKind("Maximum curvature", "|κ_max|, 1/{unit}", False, "")

LOCAL = METHODS[-1]
MEAN_EDGES = (0.5, 1.0, 2.0)  # δ_T of the local method
VARIATIONS = np.linspace(0.99, 1.01, 21)  # factors of δ_T: where the local method ends hangs on its last bits

# Which of its methods reached a fully developable surface in the paper (Section 6).
REACHED_IN_THE_PAPER = {"dented_shell": {"global", "local"}, "shoe_upper": set(), "short_pants": {"local"}}
CALLED = {"newton": "constrained Newton", "global": "global (the paper's)", "local": "local (the paper's)"}

HEADER = f"""# The paper's three examples

Made by `docs/make_examples.py`, text and pictures: the paper's two methods, with its settings, and the
constrained Newton method, on models in the manner of its examples (Section 6). The models are ours, and so
are the numbers.

- Constrained Newton: as the filter has it by default.
- Global: conjugate gradients, η = 0.01 %, at most 200 steps.
- Local: ε = 1e-4 rad² on g², at most 500 000 operations, δ_T the mean edge length where nothing else is said.
- Angle tolerance, of D and of both of the paper's methods: {ANGLE_TOLERANCE:g} rad.

D is the share of the area whose angle defects are within the tolerance (Eq. 2), G the sum of g² (Eq. 4), C
the sum of |g|, and roughness the root mean square angle between neighbouring triangles.

"""

SENSITIVITY = """
The plain local method takes every move as it is, and where it ends hangs on the last bits of its input. So
the tables of δ_T below are of 21 runs each whose δ_T differ by at most 1 %: medians, with the range in
brackets; the pictures are of the median run.
"""

COLUMNS = [
    *("model", "vertices", "triangles", "method", "D before", "D after", "G before (rad²)", "G after (rad²)"),
    *("C before (rad)", "C after (rad)", "largest distance (cm)", "steps or operations", "seconds"),
    "what stopped it",
]
TOLERANCE_COLUMNS = [
    *(
        "δ_T (mean edge lengths)",
        "D",
        "G after / before",
        "C (rad)",
        "roughness (°)",
        "largest distance (cm)",
    ),
    *("operations", "converged"),
]


def line(cells: Iterable[object]) -> str:
    """One line of a table."""
    return f"| {' | '.join(map(str, cells))} |\n"


def table(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """A table in Markdown."""
    return line(columns) + f"|{'---|' * len(columns)}\n" + "".join(map(line, rows))


def row(result: Study, outcome: Outcome) -> list[object]:
    """A line of the table in place of the paper's Table 1."""
    report = outcome.report
    return [
        *(result.source.name, len(result.vertices), len(result.faces), CALLED[outcome.method.name]),
        f"{report.developability_before:.3f}",
        f"{report.developability_after:.3f}",
        f"{report.detect_function_before:.3g}",
        f"{report.detect_function_after:.3g}",
        f"{report.total_absolute_curvature_before:.2f}",
        f"{report.total_absolute_curvature_after:.3g}",
        f"{report.max_distance:.2f}",
        report.iterations,
        f"{report.seconds:.2g}",
        report.status.text.split(":")[0],
    ]


@dataclasses.dataclass(frozen=True)
class Spread:
    """Runs of the local method that differ in δ_T by at most 1 %."""

    mean_edges: float  # the δ_T in the middle
    displacements: Sequence[float]  # δ_T, length
    reports: Sequence[LocalReport]

    @property
    def median_run(self) -> int:
        """The one whose G is the median."""
        return int(np.argsort([r.detect_function_after for r in self.reports])[len(self.reports) // 2])

    @property
    def converged(self) -> int:
        """How many runs came within the tolerance."""
        return sum(report.converged for report in self.reports)

    @property
    def roughness(self) -> float:
        """The median, degrees."""
        return math.degrees(float(np.median([r.roughness_after for r in self.reports])))

    @property
    def detect_function(self) -> float:
        """The median of G, rad²."""
        return float(np.median([r.detect_function_after for r in self.reports]))

    def row(self) -> list[object]:
        """A line of the table: medians, with the range where runs differ."""

        def cell(values: Iterable[float], digits: int) -> str:
            low, middle, high = (f"{v:.{digits}f}" for v in np.quantile(list(values), [0, 0.5, 1]))
            return middle if low == high else f"{middle} ({low} to {high})"

        reports = self.reports
        return [
            f"{self.mean_edges:g}",
            cell((r.developability_after for r in reports), 3),
            cell((r.detect_function_after / r.detect_function_before for r in reports), 3),
            cell((r.total_absolute_curvature_after for r in reports), 2),
            cell((math.degrees(r.roughness_after) for r in reports), 1),
            cell((r.max_distance for r in reports), 2),
            cell((r.iterations for r in reports), 0),
            f"{self.converged} of {len(reports)}",
        ]


def spread(path: Path, mean_edges: float) -> Spread:
    """Run the local method with δ_T round a multiple of the mean edge length."""
    vertices, faces = read(path)
    edges = np.unique(np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    # Every patch has vertices of its own, so an edge between two patches counts in each.
    length = float(np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1).mean())
    displacements = [float(factor * mean_edges * length) for factor in VARIATIONS]
    reports = []
    for displacement in displacements:
        developed = make_developable(
            vertices, faces, "local", angle_tolerance=ANGLE_TOLERANCE, max_displacement=displacement
        )
        assert isinstance(developed.report, LocalReport)
        reports.append(developed.report)
    return Spread(mean_edges, displacements, reports)


def read(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and triangles."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def median_method(runs: Spread) -> Method:
    """The local method with the δ_T of the median run."""
    limit = pymeshlab.PureValue(runs.displacements[runs.median_run])
    title = f"δ_T = {runs.mean_edges:g} mean edges"
    return Method(f"local_{runs.mean_edges:g}", title, LOCAL.what, LOCAL.filter, {"max_displacement": limit})


def keep_picture(source: Path, name: str, shapes: int) -> str:
    """A smaller copy among the documentation's pictures; returns its address from there."""
    with Image.open(source) as image:
        width = SHAPE_WIDTH * shapes
        height = round(image.height * width / image.width)
        small = image.convert("RGB").resize((width, height), Image.Resampling.LANCZOS)
        palette = small.quantize(256)  # Pillow dithers to a given palette only
        few = small.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG)
        few.save(DOCS / "pictures" / name, optimize=True)
    return f"pictures/{name}"


def shown(result: Study, title: str, name: str, caption: str) -> str:
    """A picture of a study with what it shows."""
    figure: Figure = next(figure for figure in result.figures if figure.title == title)
    laid_flat = [outcome for outcome in result.outcomes if outcome.pattern]
    shapes = len(laid_flat if title == "Flat pattern" else result.outcomes) + (title != "Distance")
    return f"![{caption}]({keep_picture(figure.file, name, shapes)})\n\n*{caption}*\n\n"


def comparison(result: Study, at_mean_edge: Spread) -> str:
    """Whether each method reached a developable surface, beside what the paper says."""
    here = {outcome.method.name for outcome in result.outcomes if outcome.report.converged}
    paper = REACHED_IN_THE_PAPER[result.source.name]
    agreed = [name for name in ("global", "local") if (name in here) == (name in paper)]
    verdicts = {0: "We find otherwise for both.", 2: "We agree on both methods."}
    agreement = verdicts.get(len(agreed)) or f"We agree on the {agreed[0]} method and not on the other."

    def words(names: set[str]) -> str:
        return " and ".join(sorted(names)) or "neither"

    newton = "does" if "newton" in here else "does not"
    return (
        f"Of the paper's two methods {words(paper)} reached a developable surface **in the paper**; **here** "
        f"{words(here - {'newton'})} came within {ANGLE_TOLERANCE:g} rad at every vertex. {agreement} "
        f"The local method did so in {at_mean_edge.converged} of {len(at_mean_edge.reports)} runs with δ_T "
        f"within 1 % of the mean edge length. Constrained Newton {newton} reach a developable shape, with C "
        "of every patch below 1e-4 rad.\n\n"
    )


def trend(spreads: Sequence[Spread]) -> str:
    """What a larger δ_T does, beside what the paper says of it (Section 6, Fig. 9 and 10)."""
    g = [runs.detect_function for runs in spreads]
    rough = [runs.roughness for runs in spreads]
    before = math.degrees(spreads[0].reports[0].roughness_before)
    gives = {True: "gives", False: "does not always give"}
    return (
        "The paper finds that a larger δ_T gives more developability and more wrinkles. In the median a "
        f"larger δ_T here {gives[g == sorted(g, reverse=True)]} more developability (less G) and "
        f"{gives[rough == sorted(rough)]} more wrinkles (roughness {before:.1f}° before).\n\n"
    )


def section(methods: Study, tolerances: Study, spreads: Sequence[Spread]) -> str:
    """All about one model."""
    name = methods.source.name
    scale = "The scale is that of the surface before; what lies beyond takes the last colour."
    return (
        f"\n## {methods.source.what}\n\n"
        + comparison(methods, spreads[MEAN_EDGES.index(1.0)])
        + f"![Angle defects](pictures/{name}.png)\n\n*Angle defect g (Eq. 5). {scale}*\n\n"
        + shown(methods, "Gaussian map", f"{name}_gaussian.png", f"Gaussian map g² (Fig. 5 to 7). {scale}")
        + shown(methods, "Distance", f"{name}_distance.png", "Distance to the original surface (Fig. 8).")
        + shown(methods, "Flat pattern", f"{name}_pattern.png", methods.figures[-1].caption)
        + f"### {name}: the difference tolerance of the local method\n\n"
        + table(TOLERANCE_COLUMNS, [runs.row() for runs in spreads])
        + "\n"
        + trend(spreads)
        + shown(tolerances, "Gaussian map", f"{name}_tolerances_gaussian.png", "Gaussian map (Fig. 9).")
        + shown(tolerances, "Distance", f"{name}_tolerances_distance.png", "Distance map (Fig. 9).")
        + shown(tolerances, "Minimum curvature", f"{name}_tolerances_minimum.png", "abs(κ_min) (Fig. 10).")
        + shown(tolerances, "Maximum curvature", f"{name}_tolerances_maximum.png", "abs(κ_max) (Fig. 10).")
    ).rstrip() + "\n"


def page(studies: Sequence[tuple[Study, Study, Sequence[Spread]]]) -> str:
    """The whole page."""
    rows = [row(result, outcome) for result, _, _ in studies for outcome in result.outcomes]
    return HEADER + table(COLUMNS, rows) + SENSITIVITY + "".join(section(*parts) for parts in studies)


def main() -> None:
    """Run the methods and write the page."""
    load()
    (DOCS / "pictures").mkdir(exist_ok=True)
    kinds = [GAUSSIAN_MAP, DISTANCE, MINIMUM, MAXIMUM]
    studies = []
    with tempfile.TemporaryDirectory() as parent:
        for model in MODELS:
            folder = Path(parent)
            methods = study(model, METHODS, ANGLE_TOLERANCE, folder, [ANGLE_MAP, *kinds[:2]])
            keep_picture(folder / f"{model.name}_angle_defect.png", f"{model.name}.png", len(METHODS) + 1)
            spreads = [spread(model.path, mean_edges) for mean_edges in MEAN_EDGES]
            folder = Path(parent) / "tolerances"
            folder.mkdir(exist_ok=True)
            limits = [median_method(runs) for runs in spreads]
            studies.append((methods, study(model, limits, ANGLE_TOLERANCE, folder, kinds), spreads))
        (DOCS / "examples.md").write_text(page(studies), encoding="utf-8")


if __name__ == "__main__":
    main()
