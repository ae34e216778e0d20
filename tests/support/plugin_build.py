# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin in this process's pymeshlab; DEVELOPABLE_PLUGIN names another build than build/ has."""

import os

import meshlab_developable
import pymeshlab


def load_plugin() -> None:
    path = os.environ.get("DEVELOPABLE_PLUGIN")
    if path is None:
        meshlab_developable.load()
    elif "apply_coord_global_developability" not in pymeshlab.filter_list():
        pymeshlab.load_plugin(path)
