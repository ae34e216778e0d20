# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line when the system fails it: each call of each kind in turn, by strace's fault injection,
until a run meets no fault any more; and file systems that are full or take nothing.

Whatever fails, the target is as it was or whole, nothing unfinished stays, and the exit code tells.
"""

import json
import os
import re
import shutil
import subprocess

import pymeshlab
import pytest
from hostile_commands import COMMAND, run

FORMATS = [".ply", ".obj", ".stl", ".off", ".wrl", ".dae", ".x3d", ".3ds", ".json", ".u3d"]
ERRORS = {"write": "ENOSPC", "rename": "EACCES", "mkdir": "EROFS", "clone": "EAGAIN", "unlinkat,rmdir": "EIO"}
MOST_FAULTS = 60


def with_fault(arguments, call, number, log, fault):
    """A run whose n-th call of a kind fails in that way. Returns it, and whether there was such a call."""
    log.unlink(missing_ok=True)
    strace = ["strace", "-f", "-qq", "-o", log, "-e", f"trace={call}", "-e", "signal=none"]
    ran = run(arguments, [*strace, "-e", f"inject={call}:{fault}:when={number}"])
    text = log.read_text() if log.exists() else ""
    return ran, "(INJECTED)" in text or "+++ killed" in text


def assert_sane(ran, target, old, folder):
    """The target is what it was or a whole mesh; a failure says so in one sentence."""
    content = target.read_bytes()
    if ran.returncode == 0:
        assert content != old
    if content != old:
        again = pymeshlab.MeshSet()
        again.load_new_mesh(str(target))
        assert again.current_mesh().face_number() == 32
    assert "Traceback" not in ran.stderr
    leftovers = [path.name for path in folder.iterdir() if path != target]
    assert all(name.startswith(".unfinished-") for name in leftovers), leftovers
    return leftovers


@pytest.mark.parametrize(
    ("call", "command"),
    [
        ("rename", "measure"),
        ("mkdir", "measure"),
        pytest.param("write", "measure", marks=pytest.mark.hostile),
        pytest.param("clone", "measure", marks=pytest.mark.hostile),
        pytest.param("unlinkat,rmdir", "measure", marks=pytest.mark.hostile),
        *(pytest.param(call, "global", marks=pytest.mark.hostile) for call in ERRORS),
    ],
)
def test_every_call_may_fail(call, command, source, tmp_path):
    target, log = tmp_path / "out" / "mesh.ply", tmp_path / "log"
    target.parent.mkdir()
    for number in range(1, MOST_FAULTS):
        old = b"old"
        target.write_bytes(old)
        ran, failed = with_fault(
            [command, source / "small.ply", "-o", target], call, number, log, f"error={ERRORS[call]}"
        )
        leftovers = assert_sane(ran, target, old, target.parent)
        assert call in ("unlinkat,rmdir", "clone") or leftovers == []
        if not failed:
            assert ran.returncode == 0, ran.stderr
            assert number > 1, "no call was ever made to fail"
            return
        if target.read_bytes() == old:
            assert ran.returncode != 0
        shutil.rmtree(target.parent)
        target.parent.mkdir()
    pytest.fail(f"still failing at the call {MOST_FAULTS}")


@pytest.mark.hostile
@pytest.mark.parametrize("call", ["write", "rename", "mkdir", "openat"])
def test_a_kill_at_any_stage_leaves_a_whole_target(call, source, tmp_path):
    """SIGKILL: nothing can be tidied, but the target is never half of anything, and the next run is right."""
    target, log = tmp_path / "out" / "mesh.ply", tmp_path / "log"
    target.parent.mkdir()
    steps = range(1, MOST_FAULTS) if call != "openat" else range(1, 2000, 97)
    for number in steps:
        target.write_bytes(b"old")
        ran, failed = with_fault(
            ["measure", source / "small.ply", "-o", target], call, number, log, "signal=KILL"
        )
        assert_sane(ran, target, b"old", target.parent)
        if not failed:
            break
        shutil.rmtree(target.parent)
        target.parent.mkdir()
    assert run(["measure", source / "small.ply", "-o", target]).returncode == 0


@pytest.mark.hostile
def test_a_batch_survives_a_kill_of_any_of_its_writes(source, tmp_path):
    """Killed at one stage after another, it goes on each time and ends with every mesh."""
    inputs = tmp_path / "in"
    inputs.mkdir()
    for number in range(3):
        shutil.copy(source / "small.ply", inputs / f"{number}.ply")
    out, log = tmp_path / "out", tmp_path / "log"
    for number in (1, 3, 10, 30, 60, 100, 200):
        with_fault(["batch", inputs, "--out", out, "-q"], "rename,write", number, log, "signal=KILL")
    ran = run(["batch", inputs, "--out", out, "--json"])
    assert ran.returncode in (0, 4), ran.stderr
    told = json.loads(ran.stdout)
    assert told["done"] + told["not_converged"] == 3, told
    assert sorted(path.name for path in (out / "meshes").iterdir()) == ["0.ply", "1.ply", "2.ply"]
    assert not (out / ".unfinished").exists()


def mounted(script, *options):
    """A shell's script in a mount namespace of its own, where $PLACE is a file system with these options."""
    mount = f'mount -t tmpfs -o {",".join(options)} tmpfs "$PLACE" && '
    ran = subprocess.run(
        ["unshare", "--mount", "--user", "--map-root-user", "bash", "-c", mount + script],
        capture_output=True,
        check=False,
        text=True,
        timeout=600,
        env={**os.environ, "COMMAND": str(COMMAND)},
    )
    assert "mount:" not in ran.stderr, ran.stderr
    assert "unshare:" not in ran.stderr, ran.stderr
    return ran


@pytest.mark.parametrize(
    "suffix", [".ply", *(pytest.param(s, marks=pytest.mark.hostile) for s in FORMATS[1:])]
)
def test_a_full_file_system_is_told_and_keeps_the_old(suffix, source, tmp_path, monkeypatch):
    monkeypatch.setenv("PLACE", str(tmp_path))
    ran = mounted(
        f'echo old > "$PLACE/out{suffix}"; '
        f'"$COMMAND" measure {source}/large.ply -o "$PLACE/out{suffix}" >&2; '
        f'echo $? "$(cat "$PLACE/out{suffix}")" "$(ls -A "$PLACE")"',
        "size=64k",
    )
    assert ran.stdout == f"2 old out{suffix}\n", (ran.stdout, ran.stderr)
    assert ran.stderr.startswith(f"error: {tmp_path}/out{suffix} cannot be written"), ran.stderr
    assert ran.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "suffix", [".ply", *(pytest.param(s, marks=pytest.mark.hostile) for s in FORMATS[1:])]
)
def test_a_read_only_file_system_is_told(suffix, source, tmp_path, monkeypatch):
    monkeypatch.setenv("PLACE", str(tmp_path))
    ran = mounted(
        f'"$COMMAND" measure {source}/small.ply -o "$PLACE/out{suffix}" >&2; echo $? "$(ls -A "$PLACE")"',
        "ro",
    )
    assert ran.stdout == "2 \n", (ran.stdout, ran.stderr)
    assert re.match(rf"error: {tmp_path}/out{suffix} cannot be written: Read-only file system", ran.stderr)


@pytest.mark.hostile
@pytest.mark.parametrize("options", [("size=64k",), ("ro",)])
@pytest.mark.parametrize(
    "arguments",
    [
        'pattern {source}/large.ply --unit cm --max-strain 90 -o "$PLACE/patterns"',
        'flatten {source}/large.ply -o "$PLACE/flat.obj"',
        'global {source}/large.ply -o "$PLACE/out.ply"',
        'batch {source} --out "$PLACE/batch" -q',
        'script global -o "$PLACE/script.mlx"',
    ],
)
def test_other_commands_on_such_file_systems(arguments, options, source, tmp_path, monkeypatch):
    monkeypatch.setenv("PLACE", str(tmp_path))
    filled = 'head -c 49152 /dev/zero > "$PLACE/filler"; ' if options != ("ro",) else ""
    ran = mounted(
        f'{filled}"$COMMAND" {arguments.format(source=source)} >&2; '
        f'echo $? "$(ls -A "$PLACE" | grep unfinished)"',
        *options,
    )
    code, leftovers = ran.stdout.split(" ", 1)
    assert "Traceback" not in ran.stderr, ran.stderr
    assert leftovers == "\n"
    assert int(code) in ((2,) if options == ("ro",) else (0, 2, 3, 4)), ran.stderr
    if code == "2":
        assert "error: " in ran.stderr


NAMES = ["-rf.ply", " a b\t.ply", "\n.ply", "'\"$(x).ply", "名前.ply", "%s%n.ply"]


@pytest.mark.parametrize("name", ["=1+1.ply", *(pytest.param(n, marks=pytest.mark.hostile) for n in NAMES)])
def test_hostile_names_are_names(name, source, tmp_path):
    target = tmp_path / name
    ran = run(["measure", source / "small.ply", "-o", target])
    assert ran.returncode == 0, ran.stderr
    assert os.listdir(tmp_path) == [name]
    shutil.copy(source / "small.ply", tmp_path / "copy.ply")
    os.replace(tmp_path / "copy.ply", target)
    assert run(["measure", target, "--json"]).returncode == 0
