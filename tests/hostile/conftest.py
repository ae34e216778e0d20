# SPDX-License-Identifier: GPL-3.0-or-later
"""What these tests share lies beside them."""

import sys
from pathlib import Path

import pymeshlab
import pytest

sys.path.insert(0, str(Path(__file__).parent))

import hostile_meshes


@pytest.fixture(scope="session")
def source(tmp_path_factory):
    """A folder with a small mesh in a file, and a large one."""
    folder = tmp_path_factory.mktemp("source")
    for name, size in (("small", 5), ("large", 60)):
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(*hostile_meshes.bump(size, size)))
        meshes.save_current_mesh(str(folder / f"{name}.ply"))
    return folder
