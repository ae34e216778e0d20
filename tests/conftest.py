# SPDX-License-Identifier: GPL-3.0-or-later
"""What several folders of tests share lies in support/; the independent measures in python/."""

import signal
import sys
from pathlib import Path

import pytest

for folder in ("support", "python"):
    sys.path.insert(0, str(Path(__file__).parent / folder))


# A run in the background may have been started with interrupts ignored; what it starts shall not ignore them.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def _host_forgets_failures():
    """pymeshlab writes to the log of the document whose filter failed last when it next loads a
    file, though that document may be gone by then. Any filter that succeeds makes it forget."""
    yield
    pymeshlab = sys.modules.get("pymeshlab")
    if pymeshlab is not None:
        pymeshlab.MeshSet().create_cube()
