# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands and batches whose n-th allocation fails, or all from then on, by a library of ours that is
preloaded: a sentence and a code, or a row, and what was there before is as it was."""

import json
import os
import subprocess
from pathlib import Path

import pymeshlab
import pytest
from hostile_commands import run

ALL = 10**9
OWN = 20  # of a new process of Python's, before anything of ours runs in it
BATCH = "meshlab_developable.batch.child"


@pytest.fixture(scope="module")
def preloaded(tmp_path_factory):
    """The library."""
    library = tmp_path_factory.mktemp("library") / "failing_allocations.so"
    source = Path(__file__).with_name("failing_allocations.cpp")
    subprocess.run(
        [
            "g++",
            "-std=c++17",
            "-O1",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-shared",
            "-fPIC",
            "-I",
            Path(__file__).parents[1],
            source,
            "-o",
            library,
        ],
        check=True,
    )
    return library


def failing(library, where, first=0, count=0, log=None):
    """The environment in which allocations fail."""
    told = {"FAILING_IN": where, "FAILING_FIRST": first, "FAILING_COUNT": count}
    if log is not None:
        told["FAILING_LOG"] = log
    return os.environ | {"LD_PRELOAD": str(library)} | {name: str(value) for name, value in told.items()}


def thousands(library, where, log, arguments):
    """How many thousand allocations a run makes."""
    ran = run(arguments, env=failing(library, where, log=log))
    assert ran.returncode in (0, 3, 4), ran.stderr
    return log.stat().st_size


def steps(library, where, log, arguments, number):
    """The numbers of so many of a run's allocations."""
    last = 1000 * (thousands(library, where, log, arguments) + 1)
    return [OWN + last * i // number for i in range(number)]


@pytest.mark.parametrize(
    ("command", "number"),
    [
        (["measure"], 3),
        *(
            pytest.param(command, number, marks=pytest.mark.hostile)
            for command, number in [
                (["measure"], 30),
                (["global", "-q"], 20),
                (["local", "-q"], 10),
                (["cut", "-q"], 10),
                (["flatten", "-q"], 10),
            ]
        ),
    ],
)
def test_a_command_ends_in_words(command, number, preloaded, source, tmp_path):
    target = tmp_path / "out" / "mesh.ply"
    target.parent.mkdir()
    arguments = [command[0], source / "small.ply", *command[1:], "-o", target]
    told = 0
    for first in steps(preloaded, "fork", tmp_path / "log", arguments, number):
        for count in (1, ALL):
            target.write_text("old")
            ran = run(arguments, env=failing(preloaded, "fork", first, count))
            where = (first, count, ran.stderr[-2000:])
            assert ran.returncode in (0, 2, 3), where
            assert "Traceback" not in ran.stderr, where
            if ran.returncode == 2:
                told += 1
                assert ran.stderr.splitlines()[-1].startswith("error: "), where
                assert "memory" in ran.stderr, where
            if ran.returncode != 2 or target.read_bytes() != b"old":  # it is there before that is said
                assert_whole(target)
            for left in set(target.parent.iterdir()) - {target}:  # to be tidied needs memory, too
                assert left.name.startswith(".unfinished-"), where
                assert count == ALL, where
                left.rename(tmp_path / f"{first}-{left.name}")
    assert told >= number


@pytest.mark.hostile
def test_a_pattern_ends_in_words(preloaded, source, tmp_path):
    target = tmp_path / "out" / "patterns"
    arguments = ["pattern", source / "small.ply", "--unit", "cm", "--max-strain", 90, "-o", target]
    target.mkdir(parents=True)
    whole = None
    for first in steps(preloaded, "fork", tmp_path / "log", arguments, 15):
        whole = whole or {path.name for path in target.iterdir()}
        for count in (1, ALL):
            for path in target.iterdir():
                path.write_text("old")
            ran = run(arguments, env=failing(preloaded, "fork", first, count))
            where = (first, count, ran.stderr[-2000:])
            assert ran.returncode in (0, 2, 3), where
            assert "Traceback" not in ran.stderr, where
            assert {path.name for path in target.iterdir()} == whole, where
            kept = sum(path.read_bytes() == b"old" for path in target.iterdir())
            assert kept in (0, len(whole)), where
            assert kept == 0 or ran.returncode == 2, where


def assert_whole(path):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    assert meshes.current_mesh().face_number() >= 32


@pytest.mark.parametrize("number", [1, pytest.param(8, marks=pytest.mark.hostile)])
def test_a_batch_has_a_row(number, preloaded, source, tmp_path):
    (tmp_path / "list.txt").write_text(f"{source}/small.ply\n")
    arguments = ["batch", tmp_path / "list.txt", "--out", tmp_path / "counted", "-q", "--json"]
    last = 1000 * thousands(preloaded, BATCH, tmp_path / "log", arguments)
    crashed = 0
    for first in [last * (2 * i + 1) // (2 * number) for i in range(number)]:
        for count in (1, ALL):
            out = tmp_path / f"{first}-{count}"
            arguments[3] = out
            ran = run(arguments, env=failing(preloaded, BATCH, first, count))
            where = (first, count, ran.stdout, ran.stderr[-2000:])
            assert ran.returncode in (0, 4), where
            assert "Traceback" not in ran.stderr, where
            told = json.loads(ran.stdout)
            crashed += told["crashed"]
            assert told["done"] + told["not_converged"] + told["crashed"] == 1, where
            if not told["crashed"]:
                assert_whole(out / "meshes" / "small.ply")
            assert not (out / ".unfinished").exists()
    assert crashed > 0
