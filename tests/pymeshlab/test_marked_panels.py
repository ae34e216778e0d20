# SPDX-License-Identifier: GPL-3.0-or-later
"""What the page for garments says of marking panels in MeshLab: selected faces are moved to layers."""

from __future__ import annotations

import meshlab_developable
import pymeshlab
from meshlab_developable import mesh_sets
from shapes import bump


def test_faces_moved_to_a_layer_and_flattened_are_panels_that_stay_sewn_together(tmp_path):
    mesh_sets.save(mesh_sets.open_mesh(*bump()), tmp_path / "hill.ply")
    meshlab_developable.load()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(tmp_path / "hill.ply"))
    middle = meshes.current_mesh().vertex_matrix()[:, 0].mean()
    faces = meshes.current_mesh().face_number()
    meshes.compute_selection_by_condition_per_face(condselect=f"x0 < {middle}")
    meshes.generate_from_selected_faces()
    meshes.generate_by_merging_visible_meshes(mergevisible=True, mergevertices=False)
    assert meshes.current_mesh().face_number() == faces
    report = meshes.apply_filter("compute_scalar_by_developability_per_vertex")
    assert report["patches"] == 2
    assert report["assembling_vertices"] > 5
