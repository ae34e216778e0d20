# SPDX-License-Identifier: GPL-3.0-or-later
"""The studies as one self-contained HTML page and as a short text."""

from __future__ import annotations

import base64
import importlib.resources
import math
import mimetypes
import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from pathlib import Path

import jinja2
import markupsafe

from meshlab_developable.cutting import CutReport
from meshlab_developable.demo.study import Outcome, Pattern, Study
from meshlab_developable.demo.view import view

Row = tuple[str, str, str]  # what, before, after


def size(study: Study) -> str:
    """How large the mesh is."""
    patches = study.measures.patches
    return (
        f"{len(study.vertices)} vertices, {len(study.faces)} faces, "
        f"{patches} {'patch' if patches == 1 else 'patches'}"
    )


def comparison(outcome: Outcome) -> list[Row]:
    """The measures before and after, with units."""
    report = outcome.report
    return [
        (
            "developability D, share of the area",
            f"{100 * report.developability_before:.1f} %",
            f"{100 * report.developability_after:.1f} %",
        ),
        (
            "detect function G",
            f"{report.detect_function_before:.4g} rad²",
            f"{report.detect_function_after:.4g} rad²",
        ),
        (
            "largest angle defect",
            f"{report.max_angle_defect_before:.4g} rad",
            f"{report.max_angle_defect_after:.4g} rad",
        ),
        (
            "total absolute curvature C",
            f"{report.total_absolute_curvature_before:.4g} rad",
            f"{report.total_absolute_curvature_after:.4g} rad",
        ),
    ]


def cost(study: Study, outcome: Outcome) -> list[tuple[str, str]]:
    """What the change cost, with units."""
    report, unit = outcome.report, study.source.unit

    def length(value: float) -> str:
        return f"{value:.4g} {unit} ({100 * value / study.diagonal:.2g} % of the diagonal)"

    return [
        ("largest displacement", length(report.max_displacement)),
        ("mean displacement", length(report.mean_displacement)),
        ("deformation energy E", f"{report.deformation_energy:.4g} {study.source.square_unit}"),
        ("iterations", f"{report.iterations}"),
        ("time", f"{report.seconds:.2g} s"),
    ]


def verdict(study: Study, outcome: Outcome) -> str:
    """Two sentences: how much of the curvature went and what is left, and how much of the area is flat."""
    report = outcome.report
    before, after = report.total_absolute_curvature_before, report.total_absolute_curvature_after
    if before == 0:
        curvature = "There was no curvature to remove."
    elif after > before:
        curvature = f"The total absolute curvature rose from {before:.3g} to {after:.3g} rad."
    else:
        gone = 100 * (1 - after / before)
        share = (
            f"{gone:.0f}" if gone < 99 else f"{math.floor(100 * gone) / 100:.2f}"
        )  # 100 is for nothing left
        curvature = (
            f"{share} % of the total absolute curvature is gone: "
            f"{before:.3g} rad before, {after:.3g} rad after."
        )
    return (
        f"{curvature} {100 * report.developability_after:.1f} % of the area is flat within "
        f"{study.angle_tolerance:g} rad, {100 * report.developability_before:.1f} % before."
    )


def panels(study: Study, outcome: Outcome) -> list[tuple[str, ...]]:
    """Of each panel, with units: its number, status, curvature before and after, largest displacement, and
    where most curvature is left."""
    unit = study.source.unit
    return [
        (
            f"{panel.index}",
            panel.reason,
            f"{panel.curvature_before:.3g} rad",
            f"{panel.curvature_after:.3g} rad",
            f"{panel.max_displacement:.3g} {unit}",
            ", ".join(f"{coordinate:.3g}" for coordinate in panel.worst_point),
        )
        for panel in outcome.report.panels
    ]


def flatness(pattern: Pattern) -> str:
    """A sentence: how well the surface can be laid flat."""
    report = pattern.report
    return (
        f"Laid flat, its edges change their length by {100 * report.max_edge_strain:.2g} % at most and "
        f"{100 * report.mean_edge_strain:.2g} % on average."
    )


def seams(cut: CutReport, unit: str) -> str:
    """A sentence: what a surface was cut into."""
    count, darts = len(cut.panels), cut.darts
    return (
        f"Cut into {count} {'panel' if count == 1 else 'panels'} with {darts} "
        f"{'dart' if darts == 1 else 'darts'}; seams and darts are {cut.seam_length:.4g} {unit} long."
    )


def cutting_sheet(pattern: Pattern) -> markupsafe.Markup | None:
    """The first sheet to cut by, drawn in the page; None where the pieces can't be cut."""
    sheets = sorted(file for file in pattern.to_cut if file.suffix == ".svg")
    if not sheets:
        return None
    ElementTree.register_namespace("", "http://www.w3.org/2000/svg")
    root = ElementTree.parse(sheets[0]).getroot()
    for name in ("width", "height"):  # true millimetres are in the file; here it fits the page
        root.attrib.pop(name)
    return markupsafe.Markup(ElementTree.tostring(root, encoding="unicode"))


def write_html(file: Path, studies: Sequence[Study], histograms: Sequence[Path]) -> None:
    """One page that needs no network, and no other file but to follow its links to the results."""
    template, viewer = (
        importlib.resources.files(__package__).joinpath(name).read_text("utf-8")
        for name in ("report.html.j2", "view.js")
    )
    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True)
    for function in (comparison, cost, cutting_sheet, flatness, panels, seams, size, verdict, embedded, view):
        environment.globals[function.__name__] = function
    chapters = list(zip(studies, histograms, strict=True))
    page = environment.from_string(template).render(chapters=chapters, viewer=viewer)
    file.write_text(page, encoding="utf-8")


def write_text(file: Path, studies: Sequence[Study]) -> None:
    """The numbers and the words, for a terminal."""
    lines = []
    for study in studies:
        lines += [study.source.name, "=" * len(study.source.name), study.source.what, ""]
        lines += [
            f"{size(study)}; a vertex counts as developable when its angle defect is at most "
            f"{study.angle_tolerance:g} rad",
            "",
        ]
        if study.cut:
            lines += [seams(study.cut, study.source.unit), ""]
        for outcome in study.outcomes:
            lines += [f"{outcome.method.title}: {outcome.report.reason}", verdict(study, outcome), ""]
            lines += [f"  {what:38}{before:>16}  ->  {after}" for what, before, after in comparison(outcome)]
            lines += [f"  {what:38}{value}" for what, value in cost(study, outcome)]
            lines += [
                f"  {'panel ' + number:38}{status}; C {before} -> {after}, moved {moved}, worst at ({place})"
                for number, status, before, after, moved, place in panels(study, outcome)
            ]
            lines += [f"  {'result':38}{outcome.file.name}"]
            if outcome.pattern:
                lines += [f"  {'flat pattern':38}{outcome.pattern.file.name}"]
                lines += [f"  {'to print, cut and sew':38}{file.name}" for file in outcome.pattern.to_cut]
                lines += [flatness(outcome.pattern)]
            lines += [""]
    file.write_text("\n".join(lines), encoding="utf-8")


def embedded(file: Path) -> str:
    """The file as a data address."""
    kind = mimetypes.guess_type(file.name)[0]
    return f"data:{kind};base64,{base64.b64encode(file.read_bytes()).decode('ascii')}"
