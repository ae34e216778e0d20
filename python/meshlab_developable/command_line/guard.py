# SPDX-License-Identifier: GPL-3.0-or-later
"""A command in a process of its own: a crash of the host becomes a sentence, and Ctrl-C works at once.

Readers of the host end their process over an index of a vertex that is not there, and a signal that Python
handles waits until a filter returns. Where memory is short, this process has some left to say so.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from types import FrameType
from typing import NoReturn

from meshlab_developable.command_line import shared
from meshlab_developable.parent import OUT_OF_MEMORY, die_with

ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def continue_in_child() -> None:
    """Returns in a new process, which signals end at once; this one ends as that does.

    With BAD_INPUT and a sentence when that crashes, and with 128 and the signal's number when one ends it.
    """
    parent = os.getpid()
    try:
        child = os.fork()
    except OSError as error:
        shared.end_with_sentence(
            f"no process to work in could be started ({error.strerror}): end other programs, or raise the "
            "limits of processes and memory",
            "--json" in sys.argv,
        )
    if child == 0:
        die_with(parent)
        if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, signal.SIG_DFL)
        return

    def forward(number: int, _frame: FrameType | None) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.kill(child, number)

    for number in ENDING:
        signal.signal(number, forward)
    _end_as(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))


def _end_as(code: int) -> NoReturn:
    """As the process in which the command was did."""
    as_json = "--json" in sys.argv
    if code == OUT_OF_MEMORY:
        shared.end_with_sentence(shared.TOO_LITTLE_MEMORY, as_json)
    if code in (*shared.Exit, *(128 + number for number in ENDING)):
        sys.exit(code)
    if -code in ENDING:
        sys.exit(128 - code)
    how = signal.Signals(-code).name if code < 0 else f"exit code {code}"
    shared.end_with_sentence(
        f"MeshLab crashed ({how}). Most often a file is damaged, so that a face names "
        "a vertex that is not there, or there is too little memory; else please report it with the mesh",
        as_json,
    )
