# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab 2025.07's own window, in float as its downloads are. It is built first, from its source: asked for
with `-m slow`; some ten minutes on two cores.

DEVELOPABLE_MESHLAB_2025 names the folder of one that is built already, with `meshlab` and `plugins` in it.
"""

import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from desktop import Desktop, MeshLab, keep

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("DEVELOPABLE_BUILD", ROOT / "build"))
SHELL = ROOT / "meshes" / "dented_shell.ply"
TARGETS = ("meshlab", "io_base", "decorate_base", "decorate_background")
FETCH = """
. scripts/lib/common.sh; . scripts/lib/packages.sh; . scripts/lib/debian_source.sh; . scripts/lib/headers.sh
bash scripts/setup.sh meshlab-2025.07
if [[ -d "$1/tree" ]]; then exit; fi
install_packages xz-utils libgl1-mesa-dev libglu1-mesa-dev
mkdir -p "$1"
read -ra suites <<<"${tarball_suites[2025.07]}"
fetch_tarball meshlab "${tarball_sha256[2025.07]}" "$1" "${suites[@]}"
mkdir "$1/unpacked"
tar -xf "$1"/*.orig.tar.* -C "$1/unpacked" --strip-components=1
mv "$1/unpacked" "$1/tree"
"""


def run(*command):
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)


@pytest.fixture(scope="module")
def program():
    """MeshLab in a folder of its own, with the plugin."""
    folder = BUILD / "meshlab-2025.07-window"
    if "DEVELOPABLE_MESHLAB_2025" in os.environ:
        built = Path(os.environ["DEVELOPABLE_MESHLAB_2025"])
    else:
        run("bash", "-euc", FETCH, "fetch", str(folder))
        build, built = folder / "build", folder / "build" / "src" / "distrib"
        options = ["-DCMAKE_BUILD_TYPE=Release", "-DMESHLAB_BUILD_MINI=ON"]
        run("cmake", "-G", "Ninja", "-S", str(folder / "tree"), "-B", str(build), *options)
        run("cmake", "--build", str(build), "--target", *TARGETS)
    plugin = BUILD / "meshlab-2025.07" / "libfilter_developable.so"
    shutil.copy(plugin, built / "plugins")
    return str(built / "meshlab")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "report"),
    [("Developability Maps", "total_absolute_curvature: 2.97"), ("Local Developability", "status: ")],
)
def test_a_filter_is_found_and_colours_the_model(name, report, program, tmp_path):
    with Desktop(tmp_path) as desktop:
        host = MeshLab(desktop, program, SHELL, question="Send Anonymous Statistics")
        before = host.view()
        dialog = host.open(name)
        keep(dialog.picture(), BUILD / "screenshots" / f"{name} 2025.07 dialog.png")
        dialog.click(0.75, 22)
        host.wait_for_log(f"Applied filter: {name}")
        assert [line for line in host.log() if line.startswith(report)], host.log()
        assert [line for line in host.log() if line.startswith("vertex colours: ")]
        after = host.view()
        keep(desktop.screen(), BUILD / "screenshots" / f"{name} 2025.07.png")
        assert (np.abs(after - before).max(axis=2) > 20).mean() > 0.05
