# SPDX-License-Identifier: GPL-3.0-or-later
"""A virtual desktop with a window manager, and programs' windows on it driven by keys and clicks.

Xvfb keeps the screen in a file (XWD, X11's window dump), openbox manages windows, xdotool presses keys.
"""

from __future__ import annotations

import os
import re
import signal
import struct
import subprocess
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from PIL import Image

SIZE = 1280, 900
PATIENCE = 120  # seconds; a busy machine draws slowly
CURSOR = 64  # pixels at the most, of a text cursor that blinks

Result = TypeVar("Result")


def wait_for(what: str, look: Callable[[], Result]) -> Result:
    """What `look` returns once that is true."""
    end = time.monotonic() + PATIENCE
    while not (found := look()):
        assert time.monotonic() < end, f"waited in vain for {what}"
        time.sleep(0.1)
    return found


class Window:
    """A window on a desktop."""

    def __init__(self, desktop: Desktop, number: str):
        self.desktop, self.number = desktop, number

    @property
    def place(self) -> tuple[int, int, int, int]:
        """Left, top, width and height on the screen, pixels."""
        text = self.desktop.xdotool("getwindowgeometry", "--shell", self.number)
        values = dict(line.split("=") for line in text.split())
        left, top, width, height = (int(values[key]) for key in ("X", "Y", "WIDTH", "HEIGHT"))
        return left, top, width, height

    def keys(self, *names: str) -> None:
        """Press keys one after the other."""
        self.desktop.xdotool("windowfocus", "--sync", self.number)
        for name in names:
            self.desktop.xdotool("key", name)
            time.sleep(0.1)

    def write(self, text: str) -> None:
        """Type a text."""
        self.desktop.xdotool("type", "--delay", "60", text)

    def click(self, across: float, above_bottom: int) -> None:
        """Click at a share of the width, so many pixels above the bottom."""
        left, top, width, height = self.place
        x, y = left + round(across * width), top + height - above_bottom
        self.desktop.xdotool("mousemove", "--sync", str(x), str(y), "click", "1")

    def picture(self) -> np.ndarray:
        """What shows of it."""
        left, top, width, height = self.place
        return self.desktop.screen()[max(top, 0) : top + height, max(left, 0) : left + width]


class Desktop:
    """Started by `with`; everything on it ends with it."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.processes: list[subprocess.Popen[bytes]] = []
        self.environment = dict(os.environ)

    def __enter__(self) -> Desktop:
        starts = 3  # a screen that has said its number does, rarely, not answer
        while not self._start_screen():
            starts -= 1
            assert starts, "Xvfb did not start"
            self.__exit__()
        self._start(["openbox"])
        # Windows that are there before their manager may never be shown.
        wait_for("the window manager", lambda: int(self.xdotool("get_num_desktops") or 0))
        return self

    def _start_screen(self) -> bool:
        """Whether it answers."""
        width, height = SIZE
        read, write = os.pipe()
        screen = ["-screen", "0", f"{width}x{height}x24", "-fbdir", str(self.folder), "-nolisten", "tcp"]
        # The screen must not begin anew when its first program ends.
        self._start(["Xvfb", "-displayfd", str(write), "-noreset", *screen], pass_fds=(write,))
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        self.environment |= {
            "DISPLAY": f":{number}",
            "HOME": str(self.folder),  # programs begin as on their first day
            "XDG_RUNTIME_DIR": str(self.folder),
            "LIBGL_ALWAYS_SOFTWARE": "1",
        }
        for _ in range(50):
            if self.xdotool("getdisplaygeometry").split() == [str(width), str(height)]:
                return True
            time.sleep(0.1)
        return False

    def __exit__(self, *_: object) -> None:
        for process in reversed(self.processes):
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    def _start(self, command: Sequence[str], **options: Any) -> None:
        with (self.folder / f"{Path(command[0]).name}.log").open("wb") as log:
            self.processes.append(
                subprocess.Popen(
                    command,
                    stdout=log,
                    stderr=log,
                    env=self.environment,
                    start_new_session=True,
                    **options,
                )
            )

    def run(self, *command: str) -> None:
        """Start a program; what it prints is in the folder, in a file named after it."""
        self._start(command)

    def printed(self, program: str) -> str:
        """What a program has printed so far."""
        return (self.folder / f"{program}.log").read_text(errors="replace")

    def xdotool(self, *arguments: str) -> str:
        """What xdotool prints."""
        return subprocess.run(
            ["xdotool", *arguments], env=self.environment, capture_output=True, text=True, check=False
        ).stdout

    def windows(self, title: str) -> list[Window]:
        """The visible windows with such a title."""
        pattern = f"^{re.escape(title)}"
        return [
            Window(self, number)
            for number in self.xdotool("search", "--onlyvisible", "--name", pattern).split()
        ]

    def window(self, title: str) -> Window:
        """The window whose title begins so, as soon as there is one."""
        return wait_for(f"the window {title}", lambda: self.windows(title))[-1]

    def screen(self) -> np.ndarray:
        """The whole screen, height x width x 3 bytes."""
        data = (self.folder / "Xvfb_screen0").read_bytes()
        header = struct.unpack(">25I", data[:100])
        width, height, row, colours = header[4], header[5], header[12], header[19]
        begin = header[0] + 12 * colours
        rows = np.frombuffer(data, np.uint8, row * height, begin).reshape(height, row)
        return rows[:, : 4 * width].reshape(height, width, 4)[:, :, 2::-1].copy()

    def still(self) -> np.ndarray:
        """The screen once nothing but a text cursor has changed for half a second."""

        def look() -> list[np.ndarray]:
            before = self.screen()
            time.sleep(0.5)
            after = self.screen()
            return [after] if np.any(before != after, axis=2).sum() <= CURSOR else []

        return wait_for("a still screen", look)[0]


def stage(root: Path) -> str:
    """The stock MeshLab 2020.09 with the plugin in it; DEVELOPABLE_MESHLAB names another program."""
    if "DEVELOPABLE_MESHLAB" in os.environ:
        return os.environ["DEVELOPABLE_MESHLAB"]
    steps = ". scripts/lib/common.sh; . scripts/lib/stage.sh; provide_stage; echo $stage/bin/meshlab"
    result = subprocess.run(["bash", "-c", steps], cwd=root, stdout=subprocess.PIPE, text=True, check=True)
    return result.stdout.split()[-1]


class MeshLab:
    """MeshLab with one mesh open."""

    def __init__(self, desktop, program, mesh, question=None):
        """Newer releases begin with a question; it gets a no."""
        self.desktop = desktop
        desktop.run(program, str(mesh))
        if question is not None:
            desktop.window(question).keys("alt+n")
        self.window = desktop.window("MeshLab")
        self.wait_for_log("Opened mesh")
        wait_for("the model in the view", self.shows_a_model)  # the log comes before the picture

    def log(self):
        lines = self.desktop.printed("meshlab").splitlines()
        return [line.split(" ", 2)[2] for line in lines if line.startswith("LOG: ") and line.count(" ") > 1]

    def wait_for_log(self, beginning):
        def look():
            return [line for line in self.log() if line.startswith(beginning)]

        return wait_for(f"'{beginning}' in the log", look)

    def find(self, name):
        """Through the search box, as a user who does not know the menu."""
        self.desktop.still()
        self.window.keys("ctrl+f")
        self.window.write(name)
        self.desktop.still()
        self.desktop.xdotool("key", "Down")
        self.desktop.xdotool("key", "Return")

    def open(self, name):
        self.find(name)
        dialog = self.desktop.window(name)
        self.desktop.still()
        return dialog

    def shows_a_model(self):
        """Whether a part of the view stands out from the backdrop, which has one colour along a row."""
        view = self.view()
        return (np.abs(view - view[:, :1]).max(axis=2) > 40).mean() > 0.05

    def view(self):
        self.desktop.xdotool("mousemove", "1270", "890")  # the pointer shows too
        return self.desktop.still()[100:760, 10:850].astype(int)


def keep(picture: np.ndarray, file: Path) -> None:
    """Save a picture for people to look at."""
    file.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(picture).save(file)
