# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that are laid by hand stay where a file says."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pattern_readers as readers
import pytest
from click.testing import CliRunner
from meshlab_developable import PatternError
from meshlab_developable.command_line import main
from meshlab_developable.patterns import make_patterns
from shapes import grid

SHEET = Path(__file__).parents[2] / "meshes" / "sheet_bent.ply"


def plates():
    """Two flat plates of 100 by 60, apart."""
    one, faces = grid(5, 5, lambda u, v: (100 * u, 60 * v, 0 * u))
    return np.vstack([one, one + np.array((300, 0, 0))]), np.vstack([faces, faces + len(one)])


@pytest.fixture
def written(tmp_path):
    """The side file of a pattern, and how to write it changed."""
    make_patterns(*plates(), folder=tmp_path, formats=["dxf"])
    content = json.loads((tmp_path / "pattern.json").read_text())

    def change(**pieces):
        for piece in content["pieces"]:
            piece.update(pieces.get(piece["name"].replace(" ", "_"), {}))
        file = tmp_path / "layout.json"
        file.write_text(json.dumps(content))
        return file

    return content, change


def corners(folder, block):
    """Box of the cut line of a piece on the sheet of an SVG, y upwards from its height."""
    (line,) = readers.read_svg(folder / "pattern-2.svg")[block]["boundary"]
    points = readers.svg_points(line)
    return points.min(axis=0), points.max(axis=0)


def test_pieces_lie_where_the_file_says(written, tmp_path):
    content, change = written
    content["sheets"] = [[500, 500], [400, 300]]
    layout = change(
        Piece_1={"sheet": 2, "turned_degrees": 90, "shifted": [100, 20]},
        Piece_2={"sheet": 2, "turned_degrees": 0, "shifted": [150, 30]},
    )
    made = make_patterns(*plates(), folder=tmp_path / "new", layout=layout)
    assert made.sheets == ((500, 500), (400, 300))
    assert not made.notes
    low, high = corners(tmp_path / "new", "Piece_1")  # 120 by 80 with its allowance, turned to the left
    assert low == pytest.approx((20, 300 - 140), abs=1e-3)
    assert high == pytest.approx((100, 300 - 20), abs=1e-3)
    low, high = corners(tmp_path / "new", "Piece_2")
    assert low == pytest.approx((150, 300 - 110), abs=1e-3)
    kept = json.loads((tmp_path / "new" / "pattern.json").read_text())
    assert kept["sheets"] == content["sheets"]
    assert kept["pieces"] == json.loads(layout.read_text())["pieces"]


def test_what_is_written_gives_the_same_again(written, tmp_path):
    made = make_patterns(
        *plates(), folder=tmp_path / "new", formats=["dxf"], layout=tmp_path / "pattern.json"
    )
    assert not made.notes
    assert (tmp_path / "new" / "pattern.json").read_text() == (tmp_path / "pattern.json").read_text()


def test_pieces_that_lie_badly_are_kept_and_named(written, tmp_path):
    _, change = written
    same = {"sheet": 1, "turned_degrees": 0, "shifted": [-30, 0]}
    made = make_patterns(
        *plates(), folder=tmp_path / "new", formats=["dxf"], layout=change(Piece_1=same, Piece_2=same)
    )
    assert set(made.notes) == {
        "Piece 1 sticks out of its sheet.",
        "Piece 2 sticks out of its sheet.",
        "Piece 1 and Piece 2 lie on each other.",
    }


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"pieces": []}, "says nothing of Piece 1, nothing of Piece 2"),
        ({"sheets": []}, "on a sheet that it has not"),
        ({"sheets": [["wide", 1]]}, "is no layout"),
        ({"pieces": [{"name": "Piece 1"}]}, "'sheet' is missing"),
    ],
)
def test_a_file_that_is_no_layout_is_refused(written, tmp_path, change, words):
    content, _ = written
    (tmp_path / "bad.json").write_text(json.dumps(content | change))
    with pytest.raises(PatternError, match=words):
        make_patterns(*plates(), folder=tmp_path / "new", layout=tmp_path / "bad.json")
    assert not (tmp_path / "new").exists()


def test_the_command_takes_a_layout(tmp_path):
    (tmp_path / "layout.json").write_text("[1]")
    arguments = ["pattern", str(SHEET), "-o", tmp_path / "out", "--unit", "cm"]
    result = CliRunner().invoke(main, [*map(str, arguments), "--layout", str(tmp_path / "layout.json")])
    assert result.exit_code == 2
    assert "is no layout" in result.output
