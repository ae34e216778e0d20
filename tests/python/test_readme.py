# SPDX-License-Identifier: GPL-3.0-or-later
"""What the README tells people to type works, and what it points to is there."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from meshlab_developable import Status

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
PAGES = [
    str(page.relative_to(ROOT))
    for page in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").glob("*.md"))
    if "](" in page.read_text(encoding="utf-8")
]


def test_python_examples_run():
    in_pymeshlab, on_arrays = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    between = "mesh = meshes.current_mesh()\nvertices, faces = mesh.vertex_matrix(), mesh.face_matrix()\n"
    check = (
        'fell = report["detect_function_after"] < report["detect_function_before"]\n'
        "print(fell, result.vertices.shape)\n"
    )
    script = in_pymeshlab + between + on_arrays + check
    command = [sys.executable, "-c", script]
    ran = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    status, summary = ran.stdout.strip().splitlines()[-2:]
    assert any(status.startswith(known.text) for known in Status)
    assert summary == "True (1697, 3)"


@pytest.mark.parametrize("page", PAGES)
def test_links_and_files_exist(page):
    text = (ROOT / page).read_text(encoding="utf-8")
    links = [link for link in re.findall(r"\]\(([^)#]+)\)", text) if "://" not in link]
    assert all(((ROOT / page).parent / link).exists() for link in links)
    named = re.findall(r"\b(?:scripts|meshes|docs)/[\w/.-]+\.\w+", text)
    assert all((ROOT / path).exists() for path in named)
    assert links or named
