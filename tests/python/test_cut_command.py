# SPDX-License-Identifier: GPL-3.0-or-later
"""From a closed model to sheets by one command."""

from __future__ import annotations

import json

import pymeshlab
import pytest
from meshlab_developable.command_line import main


def test_from_a_scan_to_patterns_by_one_command(tmp_path, capsys):
    meshes = pymeshlab.MeshSet()
    meshes.create_sphere(radius=1.0, subdiv=3)
    scan = tmp_path / "scan.ply"
    meshes.save_current_mesh(str(scan))
    with pytest.raises(SystemExit) as ended:
        main.main(
            ["pattern", str(scan), "--cut", "-o", str(tmp_path / "out"), "--unit", "cm", "--json"],
            standalone_mode=True,
        )
    assert ended.value.code in (0, None)
    said = json.loads(capsys.readouterr().out)
    assert said["pieces"] > 1
    assert said["max_edge_strain"] < 1e-3
    assert (tmp_path / "out" / "scan.dxf").stat().st_size > 0
