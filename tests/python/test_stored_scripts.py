# SPDX-License-Identifier: GPL-3.0-or-later
"""There is a script for every filter in `meshes/scripts/`, with the filter's parameters at their defaults."""

from __future__ import annotations

import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from meshlab_developable import plugin

ROOT = Path(__file__).parents[2]
NOT_COMPARED = {"description", "tooltip"}  # what a host adds for its readers


def filter_of(script: Path) -> ElementTree.Element:
    """The last one of a script."""
    return ElementTree.parse(script).getroot().findall("filter")[-1]


STORED = {filter_of(script).get("name"): script for script in (ROOT / "meshes" / "scripts").glob("*.mlx")}


def parameters(element: ElementTree.Element) -> list[dict[str, str]]:
    return [{k: v for k, v in p.attrib.items() if k not in NOT_COMPARED} for p in element]


# In a process of their own, as users run them: pymeshlab's reader of OBJ files does not get on with what
# other tests have loaded into this one.
LOAD = """
import sys, pymeshlab, meshlab_developable
meshlab_developable.load()
meshes = pymeshlab.MeshSet()
meshes.load_new_mesh(sys.argv[1])
"""
# What a filter needs that it can run, by the name of either.
BEFORE = {"apply_coord_restore_original_shape": "apply_coord_global_developability"}
BEFORE["Restore Original Shape"] = BEFORE["apply_coord_restore_original_shape"]
USE = LOAD + "for name in sys.argv[3:]: meshes.apply_filter(name)\nmeshes.save_filter_script(sys.argv[2])\n"
RUN = LOAD + "for name in sys.argv[3:]: meshes.apply_filter(name)\n"
RUN += "meshes.load_filter_script(sys.argv[2])\nmeshes.apply_filter_script()\n"
RUN += "print(meshes.current_mesh().face_number())\n"


def python(script: str, *arguments: object) -> str:
    """What a script prints that works on the dented shell."""
    command = [sys.executable, "-c", script, ROOT / "meshes" / "dented_shell.obj", *arguments]
    ran = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


@pytest.fixture(scope="module")
def used(tmp_path_factory) -> dict[str, ElementTree.Element]:
    """Each filter as pymeshlab writes it down after a run with defaults, by its name in menus."""
    elements = {}
    for python_name in plugin.FILTERS:
        script = tmp_path_factory.mktemp("used") / "used.mlx"
        python(USE, script, *filter(None, [BEFORE.get(python_name)]), python_name)
        element = filter_of(script)
        elements[element.get("name")] = element
    return elements


def test_every_filter_has_a_script(used):
    assert set(STORED) == set(used)


@pytest.mark.parametrize("name", sorted(STORED))
def test_a_script_holds_the_filters_own_defaults(name, used):
    wanted = parameters(used[name])
    stored = parameters(filter_of(STORED[name]))
    assert [p["name"] for p in stored] == [p["name"] for p in wanted]
    for ours, theirs in zip(stored, wanted, strict=True):
        shared = ours.keys() & theirs.keys()
        assert {k: ours[k] for k in shared - {"min", "max"}} == {
            k: theirs[k] for k in shared - {"min", "max"}
        }


@pytest.mark.parametrize("name", sorted(STORED))
def test_a_script_runs_in_pymeshlab(name):
    faces = int(python(RUN, STORED[name], *filter(None, [BEFORE.get(name)])).split()[-1])
    assert faces == 961 or (
        name == "Cut into Developable Panels" and faces > 961
    )  # it splits some along seams
