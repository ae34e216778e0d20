# SPDX-License-Identifier: GPL-3.0-or-later
"""What the README tells people to type works, and what it points to is there."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import reference_measures as reference

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_python_examples_run(monkeypatch, capsys):
    monkeypatch.chdir(ROOT)
    in_pymeshlab, on_arrays = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    names = {}
    exec(in_pymeshlab, names)
    assert names["report"]["detect_function_after"] < names["report"]["detect_function_before"]
    vertices, faces, _ = reference.read_obj(ROOT / "meshes" / "dented_shell.obj")
    names |= {"vertices": vertices, "faces": faces}
    exec(on_arrays, names)
    assert names["result"].vertices.shape == vertices.shape
    assert names["result"].report.status.text in capsys.readouterr().out


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md", "docs/examples.md"])
def test_links_and_files_exist(page):
    text = (ROOT / page).read_text(encoding="utf-8")
    links = [link for link in re.findall(r"\]\(([^)#]+)\)", text) if "://" not in link]
    assert all(((ROOT / page).parent / link).exists() for link in links)
    named = re.findall(r"\b(?:scripts|meshes|docs)/[\w/.-]+\.\w+", text)
    assert all((ROOT / path).exists() for path in named)
    assert links or named
