# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands as processes: crashes, signals, full disks and damaged files end in a sentence and a code."""

from __future__ import annotations

import json
import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

MODELS = Path(__file__).parents[2] / "meshes"
SHOE = MODELS / "shoe_upper.ply"
COMMAND = [sys.executable, "-m", "meshlab_developable.command_line"]
ENDLESS = ["--solver", "Conjugate gradient", "--relative-change", "0", "--max-iterations", "2000000000"]
CORNERS = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
HEADER = "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
HEADER += "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"


def run(*arguments: object, largest_file: int | None = None) -> subprocess.CompletedProcess[str]:
    def limit() -> None:
        if largest_file is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))

    command = [*COMMAND, *map(os.fsencode, map(str, arguments))]
    return subprocess.run(command, capture_output=True, text=True, check=False, preexec_fn=limit)


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("zero.obj", CORNERS + "f 0 1 2\n"),
        ("wild.obj", CORNERS + "f 1 2 999999999\n"),
        ("wild.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 70000\n"),
        ("negative.ply", HEADER.format(-5)),
        ("huge.ply", HEADER.format(99999999999)),
        ("garbage.e57", "\x01\x02garbage" * 500),
    ],
)
def test_damaged_files_are_2_in_words(name, content, tmp_path):
    source = tmp_path / name
    source.write_text(content)
    ran = run("measure", source)
    assert ran.returncode == 2
    assert ran.stderr.startswith("error: ")
    assert ran.stderr.count("\n") == 1
    ran = run("measure", source, "--json")
    assert ran.returncode == 2
    assert json.loads(ran.stdout)["error"] in ran.stderr


@pytest.mark.parametrize(
    "suffix", [".ply", ".dae", ".x3d", ".obj", ".stl", ".off", ".xyz", ".wrl", ".3ds", ".json"]
)
def test_a_full_disk_leaves_what_was_there(suffix, tmp_path):
    target = tmp_path / f"out{suffix}"
    target.write_text("old")
    ran = run("measure", SHOE, "-o", target, largest_file=16384)
    assert ran.returncode == 2, ran.stdout
    assert ran.stderr.startswith("error: ")
    assert str(target) in ran.stderr
    assert ran.stderr.count("\n") == 1
    assert ".unfinished" not in ran.stderr
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


def test_a_full_disk_leaves_no_pattern(tmp_path):
    ran = run("pattern", SHOE, "-o", tmp_path / "out", "--unit", "cm", "--max-strain", 50, largest_file=4096)
    assert ran.returncode == 2
    assert ran.stderr.startswith(f"error: {tmp_path / 'out'} cannot be written: ")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "arguments",
    [["measure", SHOE, "-o", "/proc/out.ply"], ["pattern", SHOE, "--unit", "cm", "-o", "/proc/out"]],
)
def test_a_folder_that_takes_no_files_is_2_in_words(arguments):
    ran = run(*arguments, *(["--max-strain", 50] if "pattern" in arguments else []))
    assert ran.returncode == 2
    assert ran.stderr.startswith(f"error: {arguments[-1]} cannot be written: ")
    assert ran.stderr.count("\n") == 1


def test_a_number_that_hosts_do_not_take_is_2_in_words(tmp_path):
    ran = run("global", SHOE, "-o", tmp_path / "out.ply", "--max-iterations", 99999999999999)
    assert ran.returncode == 2
    assert "at most 2147483647" in ran.stderr


@pytest.mark.parametrize(
    ("name", "content", "lost"),
    [
        ("nan.obj", CORNERS + "v nan 1 1\nf 1 2 3\nf 2 3 4\n", "1 of the 2 faces"),
        ("whole.obj", CORNERS + "v 1 1 1\nf 1 2 3\nf 2 3 4\n", ""),
        ("whole.off", "OFF\n# f\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", ""),
    ],
)
def test_faces_that_were_left_out_are_told(name, content, lost, tmp_path):
    (tmp_path / name).write_text(content)
    ran = run("measure", tmp_path / name, "--json")
    assert ran.returncode == 0, ran.stderr
    assert json.loads(ran.stdout)["patches"] == 1
    assert ran.stderr.startswith(f"warning: {lost}") if lost else ran.stderr == ""


def test_a_link_stays_one(tmp_path):
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "mesh.ply").write_text("old")
    link = tmp_path / "link.ply"
    link.symlink_to(Path("real") / "mesh.ply")
    assert run("measure", SHOE, "-o", link).returncode == 0
    assert link.is_symlink()
    assert (tmp_path / "real" / "mesh.ply").read_bytes().startswith(b"ply")
    assert os.listdir(tmp_path / "real") == ["mesh.ply"]


@pytest.mark.parametrize("name", ["\udcff.ply", "n" * 251 + ".ply"])
def test_names_that_are_hard_to_write(name, tmp_path):
    """A name that is no text is refused in words; the longest that there may be is written."""
    ran = run("measure", SHOE, "-o", tmp_path / name)
    written = name.startswith("n")
    assert ran.returncode == (0 if written else 2), ran.stderr
    assert os.listdir(tmp_path) == ([name] if written else [])
    if not written:
        assert ran.stderr.startswith("error: ")
        assert "\\xff.ply" in ran.stderr


def busy(process: subprocess.Popen[bytes]) -> None:
    """Waits until its child has computed for a while, which it does in the filter."""
    end = time.monotonic() + 120
    while time.monotonic() < end:
        children = psutil.Process(process.pid).children()
        if children and sum(children[0].cpu_times()[:2]) > 2:
            return
        time.sleep(0.05)
    raise AssertionError("it did nothing")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("by_terminal", [True, False])
def test_a_filter_that_runs_is_interrupted(number, by_terminal, tmp_path):
    arguments = [*COMMAND, "global", SHOE, "-o", tmp_path / "out.ply", *ENDLESS]
    process = subprocess.Popen(arguments, stderr=subprocess.PIPE, start_new_session=True)
    busy(process)
    children = psutil.Process(process.pid).children()
    started = time.monotonic()
    (os.killpg if by_terminal else os.kill)(process.pid, number)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 128 + number
    assert time.monotonic() - started < 5
    assert said == b""
    assert not any(child.is_running() for child in children)
    assert list(tmp_path.iterdir()) == []


def test_the_work_does_not_outlive_the_command(tmp_path):
    process = subprocess.Popen([*COMMAND, "global", SHOE, "-o", tmp_path / "out.ply", *ENDLESS])
    busy(process)
    children = psutil.Process(process.pid).children()
    process.kill()
    process.wait()
    psutil.wait_procs(children, timeout=30)
    assert not any(child.is_running() for child in children)
