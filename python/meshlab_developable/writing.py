# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are at no moment half written, whatever ends the program."""

from __future__ import annotations

import os
import signal
import sys
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

from meshlab_developable.errors import WriteError


@contextmanager
def written_whole(target: Path, scratch: Path | None = None) -> Iterator[Path]:
    """A path to write to, of the target's name; it becomes the target when the block ends well.

    A target that is a link stays one, and what it leads to is replaced. scratch: an existing folder on the
    target's file system for what is not finished; the target's, when None.
    Raises WriteError, which names the target.
    """
    place = Path(os.path.realpath(target))
    if not place.parent.is_dir():
        raise WriteError(f"there is no folder {target.parent} to write {target.name} to")
    with _unfinished(scratch or place.parent, target) as folder:
        path = folder / place.name
        yield path
        os.replace(path, place)


@contextmanager
def written_together(target: Path) -> Iterator[Path]:
    """A folder to write files to; they go to the target, which is made where it is not there, when the block
    ends well. Raises WriteError, which names the target."""
    there = next(parent for parent in (target, *target.absolute().parents) if parent.is_dir())
    with _unfinished(there, target) as folder:
        yield folder
        target.mkdir(parents=True, exist_ok=True)
        for file in sorted(folder.iterdir()):
            os.replace(file, target / file.name)


@contextmanager
def _unfinished(parent: Path, target: Path) -> Iterator[Path]:
    try:
        with (
            _ended_by_exceptions(),
            # A short name of its own: the target's may be as long as names can be.
            tempfile.TemporaryDirectory(
                dir=parent, prefix=".unfinished-", ignore_cleanup_errors=True
            ) as folder,
        ):
            yield Path(folder)
    except OSError as error:
        if isinstance(error, WriteError):
            raise
        raise WriteError(f"{target} cannot be written: {error.strerror or error}") from None


@contextmanager
def _ended_by_exceptions() -> Iterator[None]:
    """Signals that would end the process at once end it by an exception, so that blocks are left in order."""
    if threading.current_thread() is not threading.main_thread():
        yield  # only the main thread may say what signals do
        return
    changed = [
        number for number in (signal.SIGINT, signal.SIGTERM) if signal.getsignal(number) is signal.SIG_DFL
    ]
    for number in changed:
        signal.signal(number, _exit)
    try:
        yield
    finally:
        for number in changed:
            signal.signal(number, signal.SIG_DFL)


def _exit(number: int, _frame: FrameType | None) -> None:
    sys.exit(128 + number)
