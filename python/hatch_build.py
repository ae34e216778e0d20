# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the plugin into the wheel, compiled for the pymeshlab that the wheel asks for, and what it is compiled
from into the source distribution.

The compiling is scripts/setup.sh's, which brings headers, and says which of the system's packages are missing
but never installs them. An editable install goes without: it uses what set-up has built in the checkout.
"""

import importlib.metadata
import importlib.util
import os
import re
import subprocess
import sysconfig
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

# Symbols of the C++ runtime (GLIBCXX_3.4.x) and the C library that systems with them have, as auditwheel's
# policies say.
CXX_RUNTIMES = {29: (2, 34), 30: (2, 35), 31: (2, 38), 32: (2, 39), 33: (2, 39)}
HOST = "pymeshlab-2025.7"  # as the dependency in pyproject.toml says
PLUGIN = "libfilter_developable.so"
PACKAGE = "meshlab_developable"
SOURCES = (  # of the plugin, from the root of a clone
    *("CMakeLists.txt", "CMakePresets.json", "LICENSE", "VERSION"),
    *("cmake", "filter_developable", "scripts/lib", "scripts/setup.sh", "vcg_ext"),
)


class PluginBuildHook(BuildHookInterface):
    """Run by hatchling before it makes a wheel or a source distribution."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Tell hatchling what belongs in it besides the package, and compile the plugin for a wheel."""
        if version == "editable":
            return
        sources = find_sources(Path(self.root))
        if self.target_name == "sdist":
            build_data["force_include"].update({str(sources / name): name for name in SOURCES})
            return
        plugin = build_plugin(sources)
        build_data["force_include"][str(plugin)] = f"{PACKAGE}/plugins/{HOST}/{PLUGIN}"
        build_data["force_include"][str(sources / "LICENSE")] = f"{PACKAGE}/LICENSE"
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{platform_tag(plugin)}"  # one plugin serves every version of Python


def find_sources(root: Path) -> Path:
    """Where the plugin's sources are: above this folder in a clone, in it in a source distribution."""
    for folder in (root, root.parent):
        if all((folder / name).exists() for name in SOURCES):
            return folder
    raise RuntimeError("the plugin's sources are not here: run pip in the folder python/ of a clone")


def build_plugin(sources: Path) -> Path:
    """Compile what has changed; where the plugin is."""
    target = HOST if (sources / "build" / HOST / ".configured").exists() else "wheel"
    environment = dict(os.environ)
    # Set-up may have to install this package in its own environment, which this pip would take for a loop.
    environment.pop("PIP_BUILD_TRACKER", None)
    environment["DEVELOPABLE_INSTALL"] = "never"
    if target == "wheel":
        environment["DEVELOPABLE_HOST_LIBRARY"] = str(host_library())
    subprocess.run(["bash", str(sources / "scripts" / "setup.sh"), target], env=environment, check=True)
    return sources / "build" / target / PLUGIN


def platform_tag(plugin: Path) -> str:
    """The manylinux tag (PEP 600) of the oldest C library that both the plugin and its pymeshlab run with.

    The libraries that the plugin links besides the system's are pymeshlab's own, which the wheel asks for.
    """
    said = subprocess.run(["objdump", "-T", plugin], capture_output=True, text=True, check=True).stdout
    needed = {(int(major), int(minor)) for major, minor in re.findall(r"GLIBC_(\d+)\.(\d+)", said)}
    runtime = {int(minor) for minor in re.findall(r"GLIBCXX_3\.4\.(\d+)", said)}
    needed |= {since for release, since in CXX_RUNTIMES.items() if release <= max(runtime, default=0)}
    wheel = importlib.metadata.distribution("pymeshlab").read_text("WHEEL") or ""
    needed |= {(int(a), int(b)) for a, b in re.findall(r"manylinux_(\d+)_(\d+)_", wheel)}
    major, minor = max(needed)
    return f"manylinux_{major}_{minor}_{sysconfig.get_platform().rpartition('-')[2]}"


def host_library() -> Path:
    """What the plugin is linked with: the library of the pymeshlab that is there while the wheel is made."""
    found = importlib.util.find_spec("pymeshlab")
    if found is None or found.origin is None:
        raise RuntimeError("pymeshlab is needed to build this wheel: leave pip's build isolation on")
    return Path(found.origin).parent / "lib" / "libmeshlab-common.so"
