# SPDX-License-Identifier: GPL-3.0-or-later
"""Cut into Developable Panels in meshlabserver 2020.09, which computes in float: what it promises, the
filters after it keep."""

import re

import mlx_scripts
import numpy as np
import pymeshlab
import pytest
import server


def pear():
    """A closed surface in floats, of 1280 triangles, no two alike."""
    meshes = pymeshlab.MeshSet()
    meshes.create_sphere(radius=1.0, subdiv=3)
    mesh = meshes.current_mesh()
    vertices = np.array(mesh.vertex_matrix()) * [1.1, 1.4, 0.9]
    vertices += np.outer(vertices[:, 1] ** 2, [0.1, 0.2, 0.3])
    return vertices.astype(np.float32).astype(float), np.array(mesh.face_matrix())


def test_what_comes_of_the_panels_is_known_beforehand(tmp_path):
    vertices, faces = pear()
    names = ("cut_into_developable_panels", mlx_scripts.GLOBAL, "flatten_patches")
    run, flat = server.results(
        tmp_path, (vertices, faces), *(mlx_scripts.filter_element(name) for name in names)
    )
    assert flat.current_mesh().face_number() > len(faces)  # seams split some: their points are rounded
    promised, *_, kept = map(float, re.findall(r"\bmean_displacement: (.*)", run.printed))
    assert kept == pytest.approx(promised, rel=1e-6)  # but for the rounding of what has moved
    assert run.number("panels_converged") == run.number("panels") == run.number("pieces")
    assert run.number("overlapping_pieces") == run.number("flipped_faces") == 0
