# SPDX-License-Identifier: GPL-3.0-or-later
"""The demonstration: what it writes can be read back and says what was measured."""

from __future__ import annotations

import html.parser
import os
import re
import subprocess
import sys
from urllib.parse import unquote

import numpy as np
import pymeshlab
import pytest
import reference_measures as reference
from demonstrated import PANTS
from meshlab_developable.demo.__main__ import ANGLE_TOLERANCE, METHODS, demo_inputs, run
from meshlab_developable.demo.document import flatness, verdict
from meshlab_developable.demo.studies import studies
from meshlab_developable.demo.study import MAPS, Input
from meshlab_developable.demo.study import study as study_of
from meshlab_developable.plugin import load
from pattern_readers import read_dxf_blocks

NOISE_OF_ANGLES = 1e-4
"""Radians. The colours of a developable shape do not show what is left below it."""


@pytest.fixture
def folder(demonstration):
    return demonstration[0]


@pytest.fixture
def study(demonstration):
    return demonstration[1]


@pytest.fixture
def page(folder, study):
    return (folder / "report.html").read_text(encoding="utf-8")


def read_back(file):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(file))
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_scalar_array(), mesh.vertex_color_matrix()


def test_inputs_of_the_demo_exist():
    names = [source.name for source in demo_inputs()]
    assert names == ["dented_shell", "bunny10k_textured", "short_pants", "toy"]
    assert all(source.path.is_file() for source in demo_inputs())


def written_bump(file, height):
    """A small sheet with a bump."""
    x, y = np.meshgrid(np.linspace(0, 1, 7), np.linspace(0, 1, 7))
    points = np.column_stack([x.ravel(), y.ravel(), height * (np.sin(3 * x) * np.sin(3 * y)).ravel()])
    corner = (7 * np.arange(6)[:, None] + np.arange(6)).ravel()
    faces = [[a, a + 1, a + 8] for a in corner] + [[a, a + 8, a + 7] for a in corner]
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(points, np.array(faces)))
    meshes.save_current_mesh(str(file))
    return Input(file, "A bump.")


def test_inputs_side_by_side_come_out_as_one_by_one_and_in_order(tmp_path):
    inputs = [written_bump(tmp_path / f"bump_{i}.ply", 0.1 + 0.1 * i) for i in range(2)]
    [newton] = [method for method in METHODS if method.flatten]
    together = list(studies(inputs, [newton], ANGLE_TOLERANCE, tmp_path))
    assert [found.source for found in together] == inputs
    load()
    for source, found in zip(inputs, together, strict=True):
        alone = study_of(source, [newton], ANGLE_TOLERANCE, tmp_path)
        assert np.array_equal(found.outcomes[0].vertices, alone.outcomes[0].vertices)
        assert found.outcomes[0].report.reason == alone.outcomes[0].report.reason
        assert [figure.title for figure in found.figures] == [figure.title for figure in alone.figures]


def test_what_cannot_be_read_is_said_from_beside_others_too(tmp_path):
    inputs = [written_bump(tmp_path / "bump.ply", 0.2), Input(tmp_path / "none.ply", "Not there.")]
    with pytest.raises(pymeshlab.PyMeshLabException):
        list(studies(inputs, [], ANGLE_TOLERANCE, tmp_path))


def test_result_meshes_carry_positions_map_and_colours(study, folder):
    for outcome in study.outcomes:
        positions, triangles, quality, colours = read_back(outcome.file)
        assert outcome.file.parent == folder
        assert positions == pytest.approx(outcome.vertices, abs=1e-5)
        assert np.array_equal(triangles, study.faces)
        assert quality == pytest.approx(outcome.maps["Angle defect"], abs=1e-6)
        spread, largest = np.ptp(colours, axis=0).max(), np.abs(quality).max() / NOISE_OF_ANGLES
        assert spread > 0.3 if largest > 1 else spread <= largest + 0.01


def test_reported_curvature_is_that_of_the_result(study):
    for outcome in study.outcomes:
        defects = reference.angle_defects(outcome.vertices, study.faces)
        assert outcome.report.total_absolute_curvature_after == pytest.approx(np.abs(defects).sum(), rel=1e-6)
        assert outcome.report.detect_function_after < outcome.report.detect_function_before


def test_maps_of_displacement_are_how_far_vertices_moved(study):
    for outcome in study.outcomes:
        moved = np.linalg.norm(outcome.vertices - study.vertices, axis=1)
        assert outcome.maps["Displacement"] == pytest.approx(moved, abs=1e-9)
        assert moved.max() > 0


def test_a_developable_result_is_laid_flat_without_strain(study):
    newton, *others = study.outcomes
    assert newton.report.converged
    assert [outcome.pattern for outcome in others] == [None, None]
    positions, triangles, _, _ = read_back(newton.pattern.file)
    assert not positions[:, 2].any()
    assert triangles.shape == study.faces.shape
    flat, bent = (
        np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
        for corners in (positions[triangles], newton.vertices[study.faces])
    )
    assert flat == pytest.approx(bent, rel=1e-3, abs=1e-4)
    assert newton.pattern.report.max_edge_strain < 1e-4 < study.pattern.report.max_edge_strain


def energies_of_laying_flat(vertices, faces, pattern):
    """Σ (flattened length − length)² over the edges at a vertex, half of each; the largest of a place."""
    sides = [[0, 1], [1, 2], [2, 0]]
    flat_edges, first = np.unique(
        np.sort(pattern.faces[:, sides].reshape(-1, 2), axis=1), axis=0, return_index=True
    )
    ends = vertices[faces[:, sides].reshape(-1, 2)[first]]
    flat_ends = pattern.vertices[flat_edges]
    changes = np.linalg.norm(np.diff(flat_ends, axis=1), axis=2) - np.linalg.norm(
        np.diff(ends, axis=1), axis=2
    )
    energies = np.bincount(flat_edges.ravel(), np.repeat(changes**2 / 2, 2))
    places = np.unique(vertices, axis=0, return_inverse=True)[1].ravel()
    largest = np.zeros(places.max() + 1)
    np.maximum.at(largest, places[faces.ravel()], energies[pattern.faces.ravel()])
    return largest[places]


def test_the_map_of_elastic_energy_is_of_laying_flat_where_there_is_a_pattern(study):
    newton, *others = study.outcomes
    for shape in (study, newton):
        energies = energies_of_laying_flat(shape.vertices, study.faces, shape.pattern)
        assert shape.maps["Elastic energy"] == pytest.approx(energies, rel=1e-6, abs=1e-14)
    assert newton.maps["Elastic energy"].max() < 1e-6 * study.maps["Elastic energy"].max()
    assert not any("Elastic energy" in outcome.maps for outcome in others)


def test_without_a_flat_pattern_there_is_no_map_of_elastic_energy(tmp_path):
    [local] = [method for method in METHODS if not method.flatten][1:]
    kinds = [kind for kind in MAPS if kind.title in ("Displacement", "Elastic energy")]
    result = study_of(Input(PANTS, "Short pants.", "cm"), [local], ANGLE_TOLERANCE, tmp_path, kinds)
    assert result.pattern is None
    assert [figure.title for figure in result.figures] == ["Displacement"]


def test_the_flat_result_is_there_to_print_and_cut(study, folder):
    files = study.outcomes[0].pattern.to_cut
    assert {file.suffix for file in files} == {".svg", ".pdf", ".dxf", ".json"}
    assert all(file.parent == folder for file in files)
    assert len(read_dxf_blocks(next(file for file in files if file.suffix == ".dxf"))) == 4
    text = (folder / "report.txt").read_text(encoding="utf-8")
    assert all(file.name in text for file in files)


def test_histogram_counts_interior_vertices(study):
    interior = len(study.vertices) - len(reference.rim_edges(study.faces))
    assert {name: len(values) for name, values in study.angle_defects.items()} == dict.fromkeys(
        ["before", *(f"after: {method.title}" for method in METHODS)], interior
    )


def test_text_report_has_the_numbers(study, folder):
    text = (folder / "report.txt").read_text(encoding="utf-8")
    assert f"{len(study.vertices)} vertices, {len(study.faces)} faces, 4 patches" in text
    for outcome in study.outcomes:
        assert f"{outcome.method.title}: {outcome.report.reason}" in text
        assert verdict(study, outcome) in text
        assert f"{outcome.report.total_absolute_curvature_after:.4g} rad" in text
        assert f"{outcome.report.max_displacement:.4g} cm" in text
    assert flatness(study.outcomes[0].pattern) in text


class Page(html.parser.HTMLParser):
    """Collects what the page refers to and its text."""

    def __init__(self):
        super().__init__()
        self.addresses, self.alternatives, self.text = [], [], ""

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.addresses += [attributes[key] for key in ("src", "href") if key in attributes]
        if tag == "img":
            self.alternatives.append(attributes["alt"])

    def handle_data(self, data):
        self.text += data


def test_page_has_the_numbers_and_needs_nothing_else_but_for_its_links(study, page, folder):
    parser = Page()
    parser.feed(page)
    words = re.sub(r"\s+", " ", parser.text)
    assert "Short pants <of four panels>." in words
    for outcome in study.outcomes:
        assert verdict(study, outcome) in words
        assert outcome.report.reason in words
        assert f"{outcome.report.detect_function_after:.4g} rad²" in words
    assert len(parser.alternatives) == len(study.figures) + 1
    assert all(parser.alternatives)
    links = [address for address in parser.addresses if not address.startswith(("data:", "#"))]
    assert all((folder / unquote(link)).is_file() for link in links)
    pattern = study.outcomes[0].pattern
    files = {outcome.file.name for outcome in study.outcomes} | {file.name for file in pattern.to_cut}
    assert files | {pattern.file.name} == {unquote(link) for link in links}
    assert "url(" not in page


def test_the_verdict_comes_first_and_the_cutting_sheet_is_shown(study, page):
    assert page.index('class="card converged"') < page.index("<table>") < page.index("<svg")
    card = page[page.index('class="card') : page.index("</a>")]
    assert "It can be laid flat: converged." in card
    assert flatness(study.outcomes[0].pattern) in card
    sheet = page[page.index("<svg") : page.index("</svg>")]
    assert sheet.count('class="boundary"') == 4


@pytest.fixture(scope="module")
def barrel_folder(tmp_path_factory):
    return tmp_path_factory.mktemp("barrel")


@pytest.fixture(scope="module")
def barrel(barrel_folder):
    """A closed surface, which has to be cut."""
    meshes = pymeshlab.MeshSet()
    meshes.create_cone(r0=2, r1=1, h=3, subdiv=24)
    meshes.save_current_mesh(str(barrel_folder / "barrel.ply"))
    [result] = run(
        [Input(barrel_folder / "barrel.ply", "A barrel.", "cm", cut=True)], METHODS, barrel_folder / "out"
    )
    return result


def test_a_closed_surface_is_cut_sewn_and_laid_flat(barrel, barrel_folder):
    [outcome] = barrel.outcomes  # of the method that goes all the way
    assert outcome.report.developable
    assert len(barrel.cut.panels) == barrel.measures.patches == len(outcome.report.panels) > 1
    assert np.ptp(barrel.vertices, axis=0).max() == pytest.approx(4, rel=0.01)
    assert len(np.unique(outcome.vertices.round(9), axis=0)) < len(outcome.vertices)  # seams are closed
    file = next(file for file in outcome.pattern.to_cut if file.suffix == ".dxf")
    assert len(read_dxf_blocks(file)) == len(barrel.cut.panels)
    assert [figure.title for figure in barrel.figures] == [
        "Panels",
        "Angle defect",
        "Displacement",
        "Flat pattern",
    ]
    words = f"Cut into {len(barrel.cut.panels)} panels with {barrel.cut.darts} dart"
    out = barrel_folder / "out"
    assert words in (out / "report.txt").read_text("utf-8")
    page = (out / "report.html").read_text("utf-8")
    assert words in page[page.index('class="card') : page.index("</a>")]


def test_every_figure_is_a_picture(study):
    titles = [figure.title for figure in study.figures]
    assert titles == [*(kind.title for kind in MAPS), "Flat pattern"]
    assert len(titles) == 9
    for figure in study.figures:
        assert figure.file.read_bytes().startswith(b"\x89PNG")


def command_line(*arguments):
    command = [sys.executable, "-m", "meshlab_developable.demo", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, env=os.environ)


def test_a_mesh_that_is_not_there_is_an_error_in_words(tmp_path):
    result = command_line("--out", tmp_path, "no_such_mesh.obj")
    assert result.returncode == 2
    assert "no_such_mesh.obj" in result.stderr
    assert "Traceback" not in result.stderr
