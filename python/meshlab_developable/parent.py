# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes that do not outlive the one that started them."""

from __future__ import annotations

import ctypes
import os
import signal
import sys

OUT_OF_MEMORY = 77  # exit code of a process that leaves it to its parent to say so

_PARENT_DEATH_SIGNAL = 1  # PR_SET_PDEATHSIG of prctl


def die_with(parent: int) -> None:
    """Linux ends this process when its parent is gone, however that came."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PARENT_DEATH_SIGNAL, signal.SIGKILL)
    if os.getppid() != parent:
        sys.exit("the parent is gone")
