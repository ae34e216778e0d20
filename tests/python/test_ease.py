# SPDX-License-Identifier: GPL-3.0-or-later
"""Sewn panels of a material that gives: closed on the model, and with the ease that each seam gets."""

from __future__ import annotations

import json
import re
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest
from meshlab_developable import flatten, make_developable
from meshlab_developable.patterns import make_patterns

PANTS = Path(__file__).parents[2] / "meshes" / "short_pants.ply"
MATERIAL = {"allowed_stretch": 3.0, "allowed_compression": 3.0}


@pytest.fixture(scope="module")
def moved():
    return make_developable(PANTS, **MATERIAL)


@pytest.fixture(scope="module")
def made(moved, tmp_path_factory):
    folder = tmp_path_factory.mktemp("pants")
    files = make_patterns(
        moved.vertices, moved.faces, folder=folder, unit="cm", outline="exact", formats=["dxf"], **MATERIAL
    )
    return files, json.loads((folder / "pattern.json").read_text())


def test_sewn_seams_stay_closed_on_the_model(moved):
    before, after = make_developable(PANTS, max_iterations=0).vertices, moved.vertices
    copies = defaultdict(set)
    for position, vertex in zip(before.tolist(), after.tolist(), strict=True):
        copies[tuple(position)].add(tuple(vertex))
    assert len(copies) < len(before)
    assert all(len(places) == 1 for places in copies.values())


def test_each_seam_says_its_ease(made):
    files, written = made
    points = {piece["name"]: piece["sew_lines"] for piece in written["pieces"]}
    assert len(written["seams"]) == 7
    for seam in written["seams"]:
        lengths = []
        for side in seam["sides"]:
            ring = np.array(points[side["piece"]][side["boundary"]])
            steps = np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1)
            lengths.append(steps[side["edges"]].sum())
        expected = 100 * (max(lengths) / min(lengths) - 1)
        assert seam["ease_percent"] == pytest.approx(expected, abs=1e-3)
        # Both sides are within the bounds, so they can't differ by more than both give together.
        assert seam["ease_percent"] < 100 * (1.03 / 0.97 - 1) + 0.05
    eased = {seam["letter"] for seam in written["seams"] if seam["ease_percent"] > 0.1}
    assert eased
    (note,) = [note for note in files.notes if note.startswith("Ease the longer side")]
    assert set(re.findall(r"\b([A-G]) \S+ % \(", note)) == eased
    assert any("which the material bears" in note for note in files.notes)


def test_without_strain_no_seam_needs_ease(tmp_path):
    developed = make_developable(PANTS)
    made = make_patterns(developed.vertices, developed.faces, folder=tmp_path, unit="cm", formats=["dxf"])
    assert not any("Ease" in note for note in made.notes)
    assert all(seam.ease < 1e-3 for seam in made.seams)


def test_seams_of_flat_pieces_have_their_ease(moved):
    flat = flatten(moved.vertices, moved.faces, **MATERIAL)
    assert any(seam.ease > 1e-3 for seam in flat.seams)
    for seam in flat.seams:
        short, long = sorted(seam.lengths)
        assert seam.ease == pytest.approx(long / short - 1, abs=1e-12)
