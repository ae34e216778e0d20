# SPDX-License-Identifier: GPL-3.0-or-later
"""What every test here needs: the plugin in pymeshlab, and a display, one for all runs of meshlabserver."""

import os
import subprocess

import plugin_build
import pytest


@pytest.fixture(autouse=True, scope="session")
def _plugin():
    plugin_build.load_plugin()


@pytest.fixture(autouse=True, scope="session")
def _display():
    with subprocess.Popen(["Xvfb", "-displayfd", "1", "-nolisten", "tcp"], stdout=subprocess.PIPE) as display:
        before = os.environ.get("DISPLAY")
        os.environ["DISPLAY"] = f":{display.stdout.readline().decode().strip()}"
        yield
        display.terminate()
        if before is None:
            del os.environ["DISPLAY"]
        else:
            os.environ["DISPLAY"] = before
