# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that goes from a scan to a cut pattern: its script does what it says, and so do its commands."""

from __future__ import annotations

import json
import re
import shlex
import subprocess
import sys
from pathlib import Path

import ezdxf
import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "garment.md").read_text(encoding="utf-8")
PIECES = {"right front", "right back", "left front", "left back"}


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """A working folder as the page's reader has it."""
    made = tmp_path_factory.mktemp("reader")
    (made / "meshes").symlink_to(ROOT / "meshes")
    return made


@pytest.fixture(scope="module")
def printed(folder) -> str:
    (script,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    command = [sys.executable, "-c", script]
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


def test_the_script_prints_what_the_page_says(printed):
    (said,) = re.findall(r"It prints\n\n```\n(.*?)```", PAGE, re.DOTALL)
    assert printed == said


def test_the_files_are_there_and_hold_the_pieces(printed, folder):
    named = set(re.findall(r"`(short pants[^`]*)`", PAGE))
    assert {path.name for path in (folder / "out" / "pants").iterdir()} == named
    drawing = ezdxf.readfile(folder / "out" / "pants" / "short pants.dxf")
    texts = " ".join(text.dxf.text for block in drawing.blocks for text in block.query("TEXT"))
    assert all(piece in texts for piece in PIECES)
    sewn = json.loads((folder / "out" / "pants" / "short pants.json").read_text("utf-8"))
    assert {piece["name"] for piece in sewn["pieces"]} == PIECES
    assert len(sewn["seams"]) >= 5


def test_the_picture_is_of_the_same_sheet(printed, folder):
    picture = (ROOT / "docs" / "pictures" / "short_pants_sheet.svg").read_text("utf-8")
    fresh = (folder / "out" / "pants" / "short pants.svg").read_text("utf-8")
    for pattern in (r'viewBox="[^"]*"', r"<title>[^<]*</title>"):
        assert re.findall(pattern, picture) == re.findall(pattern, fresh)


def test_the_commands_work(folder):
    (commands,) = re.findall(r"```sh\n(.*?)```", PAGE, re.DOTALL)
    for line in commands.splitlines():
        name, *arguments = shlex.split(line)
        program = Path(sys.executable).with_name(name)
        ran = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True, check=False)
        assert ran.returncode == 0, ran.stderr
