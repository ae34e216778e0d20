# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels painted in the stock MeshLab's own window, as docs/garment.md says: Z-painting's select tool selects
faces, which move to a layer of their own and come back as a panel that is sewn to the rest."""

import os
import time
from pathlib import Path

import pytest
from desktop import Desktop, MeshLab, keep, stage, wait_for

ROOT = Path(__file__).resolve().parents[2]
SCREENSHOTS = Path(os.environ.get("DEVELOPABLE_BUILD", ROOT / "build")) / "screenshots"
SHELL = ROOT / "meshes" / "dented_shell.ply"
SELECT_TOOL = 26, 367  # in the box that Z-painting opens in the upper left corner; pixels of the screen
TOOL_BUTTON = 756, 65  # of Z-painting in the window
MERGE_DUPLICATES = 26, 190  # in the dialog of Flatten Visible Layers, as it opens


@pytest.fixture
def meshlab(tmp_path):
    with Desktop(tmp_path) as desktop:
        yield MeshLab(desktop, stage(ROOT), SHELL)


def click(desktop, place):
    desktop.xdotool("mousemove", "--sync", *map(str, place))
    desktop.xdotool("click", "1")
    desktop.still()


def stroke(desktop, height, begin, end):
    """Of the brush across the screen."""
    desktop.xdotool("mousemove", "--sync", str(begin), str(height), "mousedown", "1")
    for across in range(begin, end, 15):
        desktop.xdotool("mousemove", "--sync", str(across), str(height))
        time.sleep(0.15)  # the tool works when the view is drawn anew
    desktop.xdotool("mouseup", "1")


def apply(host, name):
    """Through its dialog, which is closed again."""
    dialog = host.open(name)
    dialog.click(0.75, 20)
    host.wait_for_log(f"Applied filter {name}")
    dialog.click(0.25, 20)
    wait_for("the dialog to close", lambda: not host.desktop.windows(name))


def test_a_painted_panel_is_sewn_to_the_rest(meshlab):
    host, desktop = meshlab, meshlab.desktop
    host.find("Z-paint")
    host.wait_for_log("Started Mode Z-painting")
    click(desktop, SELECT_TOOL)
    for height in range(440, 540, 25):
        stroke(desktop, height, 480, 640)
    keep(desktop.still(), SCREENSHOTS / "Z-painting.png")
    click(desktop, TOOL_BUTTON)
    apply(host, "Move selected faces")
    [moved] = [line for line in host.log() if line.startswith("Moved ")]
    assert int(moved.split()[1]) > 45
    dialog = host.open("Flatten Visible Layers")
    click(desktop, MERGE_DUPLICATES)
    keep(dialog.picture(), SCREENSHOTS / "Flatten Visible Layers dialog.png")
    dialog.click(0.75, 20)
    host.wait_for_log("Applied filter Flatten Visible Layers")
    dialog.click(0.25, 20)
    wait_for("the dialog to close", lambda: not desktop.windows("Flatten Visible Layers"))
    apply(host, "Developability Maps")
    said = dict(line.split(": ", 1) for line in host.log() if ": " in line)
    assert int(said["patches"]) == 2
    assert int(said["assembling_vertices"]) > 10
