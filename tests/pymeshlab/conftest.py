# SPDX-License-Identifier: GPL-3.0-or-later
"""Every test here needs the plugin in pymeshlab."""

import plugin_build
import pytest


@pytest.fixture(autouse=True, scope="session")
def _plugin():
    plugin_build.load_plugin()
