# SPDX-License-Identifier: GPL-3.0-or-later
"""The folders of vcg_ext depend on each other as CONTRIBUTING.md draws it, and only by their front doors."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LIBRARY = ROOT / "vcg_ext/developable"
SUFFIXES = (".h", ".cpp")
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
VCGLIB = re.compile(r"^\s*#\s*include\s+<(?:vcg|wrap)/", re.MULTILINE)
DRAWN = re.compile(r"^(\w+)/(\w+\.h)(?: +-> (.+))?$", re.MULTILINE)
# Vcglib is the mesh of the hosts; besides its readers, one file has a piece of work done by it.
WITH_VCGLIB = {
    "vcg_mesh/vcg_mesh.h",
    "polygons/polygon_triangulation.h",
    "geometry/triangle_intersection.cpp",
}


def drawing() -> dict[str, tuple[str, tuple[str, ...]]]:
    """Folders, from the lowest up: the front door of each, and the folders that it uses."""
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    return {
        folder: (f"developable/{folder}/{door}", tuple(uses.split(", ")) if uses else ())
        for folder, door, uses in DRAWN.findall(text)
    }


def sources(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.suffix in SUFFIXES)


def own_folder(path: Path) -> str | None:
    """The folder of vcg_ext that a file is part of, or, of a test, the one that it mirrors."""
    for base in (LIBRARY, ROOT / "tests/vcg_ext"):
        if path.is_relative_to(base) and len(path.relative_to(base).parts) > 1:
            return path.relative_to(base).parts[0]
    return None


def offences(path: Path, text: str) -> list[str]:
    """What a file includes and should not."""
    folders = drawing()
    doors = {door: folder for folder, (door, _) in folders.items()}
    own = own_folder(path)
    inside = path.is_relative_to(LIBRARY)
    found = []
    for name in INCLUDE.findall(text):
        if not name.startswith("developable/"):
            if inside and ("/" in name or not (path.parent / name).is_file()):
                found.append(f'"{name}" is no file beside it')
            continue
        folder = name.split("/")[1]
        if folder == own:
            if inside:
                found.append(f'"{name}" lies beside it: name it without its folder')
        elif name not in doors:
            found.append(f'"{name}" is behind the door of {folder}/')
        elif inside and own is not None and folder not in folders[own][1]:
            found.append(f'{own}/ may not use {folder}/ ("{name}")')
    return found


def test_the_drawing_has_every_folder_and_leads_one_way():
    folders = drawing()
    assert set(folders) == {path.name for path in LIBRARY.iterdir()}
    seen: set[str] = set()
    for folder, (door, uses) in folders.items():
        assert (ROOT / "vcg_ext" / door).is_file()
        assert set(uses) <= seen, f"{folder}/ uses what is drawn below it"
        seen.add(folder)


def test_the_drawing_has_no_arrow_that_is_not_used():
    for folder, (_, uses) in drawing().items():
        text = "".join(path.read_text(encoding="utf-8") for path in sources(LIBRARY / folder))
        used = {name.split("/")[1] for name in INCLUDE.findall(text) if name.startswith("developable/")}
        assert used == set(uses), folder


@pytest.mark.parametrize("folder", ["vcg_ext", "filter_developable", "tests", "bench"])
def test_what_is_behind_a_door_is_included_by_its_own_folder_only(folder):
    files = sources(ROOT / folder)
    assert files
    found = {path: offences(path, path.read_text(encoding="utf-8")) for path in files}
    assert not {str(path.relative_to(ROOT)): wrong for path, wrong in found.items() if wrong}


def test_vcglib_is_included_where_meshes_of_hosts_are_read_and_in_two_files_more():
    including = {
        str(path.relative_to(LIBRARY))
        for path in sources(LIBRARY)
        if VCGLIB.search(path.read_text(encoding="utf-8"))
    }
    assert including == WITH_VCGLIB


@pytest.mark.parametrize(
    ("file", "name"),
    [
        ("mesh/report.cpp", "developable/newton/constrained_newton.h"),
        ("newton/soundness.cpp", "developable/geometry/wide.h"),
        ("newton/soundness.cpp", "developable/newton/soundness.h"),
        ("newton/soundness.cpp", "../mesh/report.h"),
        ("newton/soundness.cpp", "developable/detail/soundness.h"),
    ],
)
def test_an_offender_is_found(file, name):
    assert len(offences(LIBRARY / file, f'#include "{name}"\n')) == 1


def test_a_plugin_may_not_open_inner_headers():
    plugin = ROOT / "filter_developable/run_filter.cpp"
    assert offences(plugin, '#include "developable/mesh/report.h"\n')
    assert not offences(plugin, '#include "developable/mesh/mesh.h"\n')
