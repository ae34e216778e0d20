# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds and runs the programs of this folder, which stand in for a host."""

import importlib.util
import os
import subprocess
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = Path(os.environ.get("DEVELOPABLE_BUILD", ROOT / "build"))


def host_library(host):
    """The library that the host's plugins link."""
    if host == "meshlab-2020.09":
        [library] = Path("/usr/lib").glob("*/meshlab/libmeshlab-common.so")
        return library
    package = Path(importlib.util.find_spec("pymeshlab").origin).parent
    return package / "lib" / "libmeshlab-common.so"


def checked(command, **options):
    result = subprocess.run(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options
    )
    assert result.returncode == 0, result.stdout[-8000:]
    return result.stdout


@pytest.fixture(scope="module")
def host(request):
    """A host's name, its programs built."""
    name = request.param
    folder = BUILD / "gui" / name
    library = BUILD / "library" / "vcg_ext" / "libdevelopable.a"
    options = [
        f"-DDEVELOPABLE_HOST={name}",
        f"-DDEVELOPABLE_HOST_LIBRARY={host_library(name)}",
        f"-DDEVELOPABLE_LIBRARY={library}",
    ]
    checked(["cmake", "-G", "Ninja", "-S", HERE, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", *options])
    checked(["cmake", "--build", folder])
    return name


def run(host, program):
    [platforms] = Path("/usr/lib").glob("*/qt5/plugins/platforms")
    environment = {
        **os.environ,
        "QT_LOGGING_RULES": "*.debug=false",
        "QT_QPA_PLATFORM": "offscreen",
        "QT_QPA_PLATFORM_PLUGIN_PATH": str(platforms),  # the wheel's Qt comes without it
        "LD_LIBRARY_PATH": str(host_library(host).parent),
    }
    return checked(
        [BUILD / "gui" / host / program, BUILD / host / "libfilter_developable.so"], env=environment
    )


@pytest.mark.parametrize("host", ["meshlab-2020.09", "pymeshlab-2025.7"], indirect=True)
def test_progress_stops_and_errors_in_the_host(host):
    output = run(host, "plugin_in_host_test")
    assert "PASS   : developable::test::PluginInHostTest::aStopLeavesTheLayerAsItWas" in output
    assert ", 0 failed, 0 skipped" in output


@pytest.mark.parametrize("host", ["pymeshlab-2025.7"], indirect=True)  # 2020.09 has it inside its program
def test_the_hosts_own_dialog(host):
    output = run(host, "dialog_test")
    assert ", 0 failed, 0 skipped" in output
