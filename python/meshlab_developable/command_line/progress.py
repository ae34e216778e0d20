# SPDX-License-Identifier: GPL-3.0-or-later
"""A progress bar for a filter that runs: pymeshlab prints its progress, and this draws what it reads."""

from __future__ import annotations

import contextlib
import io
import os
import re
import sys
import threading
from collections.abc import Iterator
from typing import IO, Any

import click

_SHARE = re.compile(rb"\[ *(\d+)% *\]")


@contextlib.contextmanager
def progress_shown(label: str, quiet: bool = False) -> Iterator[bool]:
    """Draws a bar on standard error while the block runs a verbose mesh set, whose own words are kept away.

    Gives whether it does, which is not when told to be quiet or when standard error is no terminal.
    """
    if quiet or not sys.stderr.isatty():
        yield False
        return
    with (
        os.fdopen(os.dup(2), "w") as terminal,
        click.progressbar(length=100, label=label, file=terminal) as bar,
    ):
        with _printed_to_pipe() as pipe:
            reader = threading.Thread(target=_follow, args=(pipe, bar), daemon=True)
            reader.start()
            yield True
        reader.join()  # the pipe ends where the block does


@contextlib.contextmanager
def _printed_to_pipe() -> Iterator[IO[bytes]]:
    """Gives a file that reads what this process prints meanwhile, its libraries included."""
    reading, writing = os.pipe()
    sys.stdout.flush()
    sys.stderr.flush()
    kept = [(number, os.dup(number)) for number in (1, 2)]
    for number, _ in kept:
        os.dup2(writing, number)
    os.close(writing)
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            yield os.fdopen(reading, "rb")
    finally:
        for number, copy in kept:
            os.dup2(copy, number)
            os.close(copy)


def _follow(lines: IO[bytes], bar: Any) -> None:
    with lines:
        for line in lines:
            match = _SHARE.search(line)
            if match:
                bar.update(max(0, min(100, int(match[1])) - bar.pos))
