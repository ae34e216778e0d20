# SPDX-License-Identifier: GPL-3.0-or-later
"""From a closed model to sheets by one command."""

from __future__ import annotations

import contextlib
import io
import json

import pattern_readers as readers
import pymeshlab
import pytest
import shapely
from meshlab_developable.command_line import main
from meshlab_developable.patterns.corners import SHARP, turning


@pytest.fixture(scope="module")
def scan(tmp_path_factory):
    """A closed surface, long enough that seams do more than darts."""
    path = tmp_path_factory.mktemp("cut") / "scan.ply"
    meshes = pymeshlab.MeshSet()
    meshes.create_sphere(radius=1.0, subdiv=2)
    sphere = meshes.current_mesh()
    meshes.add_mesh(pymeshlab.Mesh(sphere.vertex_matrix() * (1, 1, 3), sphere.face_matrix()))
    meshes.save_current_mesh(str(path))
    return path


@pytest.fixture(scope="module")
def rigid(scan):
    """What is said of patterns without any strain."""
    return patterns_of(scan)


def patterns_of(scan, *options):
    """What the command says of the patterns that it has made."""
    folder = scan.with_name("out")
    arguments = ["pattern", str(scan), "--cut", "-o", str(folder), "--unit", "cm", "--json", *options]
    with contextlib.redirect_stdout(io.StringIO()) as said, pytest.raises(SystemExit) as ended:
        main.main(arguments, standalone_mode=True)
    assert ended.value.code in (0, None)
    assert (folder / "scan.dxf").stat().st_size > 0
    return json.loads(said.getvalue())


def test_from_a_scan_to_patterns_by_one_command(rigid):
    assert rigid["pieces"] > 1
    assert rigid["max_edge_strain"] < 1e-3


def test_cut_and_patterns_share_the_material(scan, rigid):
    bounds = ("--allowed-stretch", "5", "--allowed-compression", "5")
    said = patterns_of(scan, *bounds)
    assert said["pieces"] < rigid["pieces"]
    assert 0.01 < said["max_edge_strain"] < 0.0528


def test_the_seams_of_a_cut_are_smooth(scan):
    """Outlines turn sharply where a side of a seam ends, and nowhere else; along the mesh's edges they do."""
    turns, corners = [], []
    for options in ([], ["--seam-tolerance", "0"]):
        patterns_of(scan, "--unit", "m", "--format", "dxf", *options)
        blocks = readers.read_dxf_blocks(scan.with_name("out") / "scan.dxf")
        rings = [shapely.get_coordinates(layers["14"][0])[:-1] for layers in blocks.values()]
        turns.append(sum(int((abs(turning(ring)) > SHARP).sum()) for ring in rings))
        seams = json.loads((scan.with_name("out") / "scan.json").read_text())["seams"]
        corners.append(sum(len(seam["sides"]) for seam in seams))
    assert turns[0] <= corners[0]
    assert turns[1] > corners[1]
