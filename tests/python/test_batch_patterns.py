# SPDX-License-Identifier: GPL-3.0-or-later
"""What a batch shows while it runs and when it ends: patterns, lines without a terminal, pages that grow."""

from __future__ import annotations

import importlib
import json
import re
import shutil
from pathlib import Path

import ezdxf
import pytest
from click.testing import CliRunner
from meshlab_developable.batch import overview, records
from meshlab_developable.batch.inputs import find_inputs
from meshlab_developable.batch.settings import Settings
from meshlab_developable.command_line import main
from meshlab_developable.errors import InvalidParameterError
from PIL import Image

MODELS = Path(__file__).parents[2] / "meshes"
run_module = importlib.import_module("meshlab_developable.batch.run")


def batch(*arguments):
    return CliRunner().invoke(main, ["batch", *map(str, arguments)], prog_name="developable")


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    """Two panels and a file that is none, with patterns."""
    folder = tmp_path_factory.mktemp("batch")
    (folder / "in").mkdir()
    for name in ("sheet_bent.ply", "shoe_upper.ply"):
        shutil.copy(MODELS / name, folder / "in")
    (folder / "in" / "empty.ply").write_bytes(b"")
    result = batch(folder / "in", "--out", folder / "out", "--patterns", "--unit", "cm", "--workers", 1)
    assert result.exit_code == 4, result.output
    return folder / "out", result


def test_each_mesh_has_its_pattern(ran):
    out, _ = ran
    assert sorted(folder.name for folder in (out / "patterns").iterdir()) == ["sheet_bent", "shoe_upper"]
    for name in ("sheet_bent", "shoe_upper"):
        drawing = ezdxf.readfile(out / "patterns" / name / f"{name}.dxf")
        assert [block.name for block in drawing.blocks if not block.name.startswith(("*", "$"))] == [
            "PIECE_1"
        ]
        pieces = json.loads((out / "patterns" / name / f"{name}.json").read_text())["pieces"]
        assert len(pieces) == 1
    page = (out / "overview.html").read_text("utf-8")
    assert 'href="patterns/shoe_upper/shoe_upper.svg"' in page


def test_lines_say_how_each_mesh_ended_without_a_terminal(ran):
    _, result = ran
    lines = re.findall(r"^(\d)/3 (\S+): (\w+): .+$", result.stderr, re.MULTILINE)
    assert [number for number, _, _ in lines] == ["1", "2", "3"]
    assert {(name, state) for _, name, state in lines} == {
        ("sheet_bent.ply", "done"),
        ("shoe_upper.ply", "done"),
        ("empty.ply", "bad_input"),
    }


def test_the_page_has_pictures_before_and_after_and_a_hint(ran):
    out, result = ran
    page = (out / "overview.html").read_text("utf-8")
    befores = re.findall(r"url\('(thumbnails_before/[^']+)'\)", page)
    assert len(befores) == 2
    for address in befores:
        with Image.open(out / address) as before, Image.open(out / address.replace("_before", "")) as after:
            assert before.size == after.size
            assert before.tobytes() != after.tobytes()
    assert "mend the files" in page
    assert "mend the files" in result.stdout
    assert "http-equiv" not in page  # it is complete


def test_pages_grow_while_a_batch_runs(tmp_path, monkeypatch):
    monkeypatch.setattr(run_module, "SECONDS_BETWEEN", 0.0)
    (tmp_path / "in").mkdir()
    for number in range(3):
        shutil.copy(MODELS / "sheet_bent.ply", tmp_path / "in" / f"{number}.ply")
    seen = []
    write = run_module.write_overview

    def written(out, jobs, rows, scratch, total):
        write(out, jobs, rows, scratch, total)
        seen.append(((out / "overview.html").read_text("utf-8"), (out / "results.csv").read_text("utf-8")))

    monkeypatch.setattr(run_module, "write_overview", written)
    run_module.run(find_inputs(tmp_path / "in", tmp_path / "out"), tmp_path / "out", Settings(), workers=1)
    tables = [len(table.splitlines()) - 1 for _, table in seen]
    assert tables == sorted(tables)
    assert tables[-1] == 3
    assert tables[0] < 3
    assert "2 are still to come" in seen[0][0] or "1 are still to come" in seen[0][0]
    assert "still to come" not in seen[-1][0]


def test_a_pattern_that_is_refused_is_said(tmp_path):
    (tmp_path / "in").mkdir()
    shutil.copy(MODELS / "short_pants.ply", tmp_path / "in")
    (tmp_path / "settings.toml").write_text(
        "[parameters]\nmax_iterations = 0\n[patterns]\nunit = 'cm'\nformats = ['dxf']\n"
    )
    batch(tmp_path / "in", "--out", tmp_path / "out", "--parameters", tmp_path / "settings.toml")
    record = json.loads((tmp_path / "out" / "records" / "short_pants.json").read_text())
    assert "no pattern: Piece" in record["message"]
    assert not (tmp_path / "out" / "patterns" / "short_pants").exists()


@pytest.mark.parametrize(
    ("patterns", "words"), [({}, "unit"), ({"unit": "cm", "zip": 3}, "zip"), ({"unit": "parsec"}, "parsec")]
)
def test_bad_settings_are_refused(patterns, words):
    with pytest.raises(InvalidParameterError, match=words):
        Settings(patterns=patterns)


def test_patterns_without_a_unit_end_with_2(tmp_path):
    result = batch(MODELS, "--out", tmp_path / "out", "--patterns")
    assert result.exit_code == 2
    assert "--unit cm" in result.output
    assert not (tmp_path / "out").exists()


def test_every_state_but_done_has_a_hint():
    states = [state for state in records.State if state is not records.State.DONE]
    assert len(overview.hints(dict.fromkeys(records.State, 1))) == len(states)
    assert not overview.hints({records.State.DONE: 3})
