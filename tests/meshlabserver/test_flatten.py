# SPDX-License-Identifier: GPL-3.0-or-later
"""Flatten Patches in meshlabserver 2020.09, which computes in float: what it saves against what it logs."""

import mlx_scripts
import numpy as np
import pytest
import server
from mesh_sets import positions_of, quality_of
from shapes import bump, cylinder, octahedron, two_bumps

FLATTEN = "flatten_patches"


def flattened(tmp_path, mesh, **values):
    """The run, and the patterns that the server saved."""
    return server.results(tmp_path, mesh, mlx_scripts.filter_element(FLATTEN, **values))


def edge_strains(mesh, pattern):
    """Strain of every half edge; corners of the patterns are those of the mesh."""
    corners, flat = mesh[0][mesh[1]], pattern.vertex_matrix()[pattern.face_matrix()]
    lengths, flat_lengths = (np.linalg.norm(np.roll(c, -1, axis=1) - c, axis=2) for c in (corners, flat))
    return abs(flat_lengths - lengths) / lengths


@pytest.mark.parametrize("make", [bump, cylinder, two_bumps])
def test_the_log_says_what_the_saved_patterns_show(make, tmp_path):
    positions, triangles = make()
    mesh = positions.astype(np.float32).astype(float), triangles
    run, saved = flattened(tmp_path, mesh)
    strains = edge_strains(mesh, saved.current_mesh())
    assert run.number("max_edge_strain") == pytest.approx(strains.max(), rel=1e-6)
    assert (strains.max() < 1e-5) == (make is cylinder)
    assert run.number("pieces") == (2 if make is two_bumps else 1)
    assert run.number("flipped_faces") == run.number("overlapping_pieces") == 0
    assert quality_of(saved).max() == pytest.approx(strains.max(), rel=1e-5)
    assert not positions_of(saved)[:, 2].any()
    assert saved.current_mesh().has_vertex_color()


def test_both_sides_of_a_seam_are_in_the_log(tmp_path):
    run, _ = flattened(tmp_path, two_bumps(), map="Elastic energy")
    assert run.values["seam 1"].startswith("piece 1 with 2, lengths 1.01")
    assert "Elastic energy" in run.values["vertex quality"]


def test_a_closed_surface_is_refused_with_a_sentence(tmp_path):
    source = server.save_mesh(tmp_path / "in.ply", *octahedron())
    run = server.run(mlx_scripts.SCRIPTS / f"{FLATTEN}.mlx", source)
    assert run.exit_code == 255
    assert "1 of 1 patch is closed and can't be laid flat" in run.printed
