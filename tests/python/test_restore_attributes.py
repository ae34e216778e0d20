# SPDX-License-Identifier: GPL-3.0-or-later
"""Restore Original Shape on attributes that others have made. Here, as pymeshlab 2022.2 spoils its memory
when it makes any."""

from __future__ import annotations

import meshlab_developable
import numpy as np
import pymeshlab
import pytest
from mesh_sets import mesh_set, positions_of
from shapes import bump

RESTORE = "apply_coord_restore_original_shape"


def test_places_that_are_no_numbers_are_refused_and_counted():
    meshlab_developable.load()
    positions, triangles = bump()
    meshes = mesh_set((positions, triangles))
    spoilt = positions.copy()
    spoilt[[3, 7], 1] = [np.nan, np.inf]
    meshes.current_mesh().add_vertex_custom_point_attribute(spoilt, "original_position")
    with pytest.raises(pymeshlab.PyMeshLabException, match=" 2 vertices have an 'original_position'"):
        meshes.apply_filter(RESTORE)
    assert np.array_equal(positions_of(meshes), positions)
