# SPDX-License-Identifier: GPL-3.0-or-later
"""Files are written whole or not at all."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from meshlab_developable import DevelopableError, WriteError
from meshlab_developable.writing import written_together, written_whole

WRITER = """
import os, signal, sys
from pathlib import Path
from meshlab_developable.writing import written_whole
signal.signal(signal.SIGINT, signal.SIG_DFL)
with written_whole(Path(sys.argv[1])) as path:
    path.write_text("half")
    os.kill(os.getpid(), int(sys.argv[2]))
    path.write_text("whole")
"""


def write_nothing(target: Path) -> None:
    with written_whole(target):
        pass


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_while_writing_leaves_nothing(number, tmp_path):
    (tmp_path / "out.txt").write_text("old")
    ran = subprocess.run([sys.executable, "-c", WRITER, tmp_path / "out.txt", str(int(number))], check=False)
    assert ran.returncode == 128 + number
    assert os.listdir(tmp_path) == ["out.txt"]
    assert (tmp_path / "out.txt").read_text() == "old"


def test_signals_do_afterwards_what_they_did(tmp_path):
    before = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]
    with written_whole(tmp_path / "out.txt") as path:
        path.write_text("new")
    assert [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)] == before
    assert (tmp_path / "out.txt").read_text() == "new"


def test_errors_name_the_target(tmp_path):
    with pytest.raises(WriteError, match=f"there is no folder {tmp_path / 'no'} to write out.txt to"):
        write_nothing(tmp_path / "no" / "out.txt")
    with pytest.raises(DevelopableError, match=f"^{tmp_path / 'out.txt'} cannot be written: ") as caught:
        write_nothing(tmp_path / "out.txt")
    assert isinstance(caught.value, OSError)
    assert os.listdir(tmp_path) == []


def test_several_files_come_together(tmp_path):
    folder = tmp_path / "new"
    with contextlib.suppress(ZeroDivisionError), written_together(folder) as path:
        (path / "a").touch()
        raise ZeroDivisionError
    assert os.listdir(tmp_path) == []
    with written_together(folder) as path:
        (path / "a").touch()
        (path / "b").touch()
        assert not folder.exists()
    assert sorted(os.listdir(folder)) == ["a", "b"]
    assert os.listdir(tmp_path) == ["new"]
    (tmp_path / "file").touch()
    with pytest.raises(WriteError, match="file cannot be written"), written_together(tmp_path / "file"):
        pass
