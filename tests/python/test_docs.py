# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages: their pictures and links are there, and every picture is in a page."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = [ROOT / "README.md", *sorted(DOCS.glob("*.md"))]


def targets(page):
    """What a page links to or shows, of this repository."""
    found = re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    return [page.parent / target for target in found if "://" not in target]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_what_a_page_points_to_is_there(page):
    assert [target for target in targets(page) if not target.exists()] == []


def test_every_picture_is_shown():
    shown = {target.resolve() for page in PAGES for target in targets(page)}
    assert [file.name for file in (DOCS / "pictures").iterdir() if file.resolve() not in shown] == []


@pytest.mark.parametrize("name", ["global", "local", "developability_maps", "flatten"])
def test_each_filters_page_shows_its_dialog(name):
    [page] = DOCS.glob(f"{name}*.md")
    assert [target for target in targets(page) if target.name.startswith(f"dialog_{name}")]
