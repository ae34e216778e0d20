# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings the plugin into this process's pymeshlab. MeshLab's loader takes a plugin only when it was built for
the very same version, so there is one build a version, and this picks the one that fits."""

from __future__ import annotations

import importlib.metadata
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pymeshlab

from meshlab_developable import filters
from meshlab_developable.errors import PluginNotFoundError

FILTERS = tuple(known.function for known in filters.FILTERS)
PLUGIN_FILE = "libfilter_developable.so"
_HOST = re.compile(r"pymeshlab-(\d+\.\d+)")


def load() -> None:
    """Load the plugin into pymeshlab; when it is there already, do nothing.

    Afterwards its filters answer to `MeshSet.apply_filter(name)` and, as pymeshlab's own, to methods of
    `MeshSet`. Raises PluginNotFoundError when no build fits the running pymeshlab.
    """
    if is_loaded():
        return
    path = find_plugin(pymeshlab_version(), plugin_folders())
    try:
        pymeshlab.load_plugin(str(path))
    except pymeshlab.PyMeshLabException as error:
        raise PluginNotFoundError(
            f"pymeshlab {pymeshlab_version()} did not take the Developable plugin {path}: {error}"
        ) from error
    for name in pymeshlab.filter_list():
        if not hasattr(pymeshlab.MeshSet, name):
            setattr(pymeshlab.MeshSet, name, pymeshlab.bind_function(name))


def is_loaded() -> bool:
    """Whether pymeshlab has the filters, however they came there."""
    return FILTERS[0] in pymeshlab.filter_list()


def pymeshlab_version() -> str:
    """Version of the installed pymeshlab, year and month only: post-releases have the same interface."""
    year, month = importlib.metadata.version("pymeshlab").split(".")[:2]
    return f"{year}.{month}"


def plugin_folders() -> list[Path]:
    """Where builds may lie, a folder a host in each: in the installed package, and in a source checkout."""
    package = Path(__file__).resolve().parent
    return [package / "plugins", package.parents[1] / "build"]


def find_plugin(version: str, folders: Sequence[Path]) -> Path:
    """The build for a version of pymeshlab. Raises PluginNotFoundError, naming the versions there are."""
    builds = {
        match[1]: path
        for folder in reversed(folders)
        for path in sorted(folder.glob(f"*/{PLUGIN_FILE}"))
        if (match := _HOST.fullmatch(path.parent.name))
    }
    if version in builds:
        return builds[version]
    if not builds:
        looked = " and ".join(str(folder) for folder in folders)
        raise PluginNotFoundError(
            f"the Developable plugin has not been built: looked for pymeshlab-*/{PLUGIN_FILE} in {looked}. "
            "In a source checkout, run: bash scripts/setup.sh"
        )
    versions = sorted(builds)
    raise PluginNotFoundError(
        f"no build of the Developable plugin fits pymeshlab {version}; there are builds for pymeshlab "
        f"{', '.join(versions)}. Install one of these, for example: pip install 'pymeshlab=={versions[-1]}.*'"
    )


def vertex_quality(mesh: Any) -> npt.NDArray[np.float64]:
    """A mesh's quality a vertex, by either of the names that pymeshlab has had for it."""
    read = getattr(mesh, "vertex_scalar_array", None) or mesh.vertex_quality_array
    return np.array(read(), dtype=np.float64)
