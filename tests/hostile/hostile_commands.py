# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line as a process."""

import subprocess
import sys
from pathlib import Path

COMMAND = Path(sys.executable).with_name("developable")


def run(arguments, before=(), **options):
    """The command with these arguments, behind what is to be before it."""
    return subprocess.run(
        [*before, COMMAND, *map(str, arguments)],
        capture_output=True,
        check=False,
        text=True,
        errors="replace",
        timeout=300,
        **options,
    )
