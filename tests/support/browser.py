# SPDX-License-Identifier: GPL-3.0-or-later
"""A headless Chromium without network, driven by Selenium."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from PIL import Image
from selenium import webdriver
from selenium.webdriver.remote.webelement import WebElement

FLAGS = (
    *("--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking"),
    *("--disable-component-update", "--disable-sync", "--window-size=1200,900"),
    *("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),  # WebGL by the processor
    "--host-resolver-rules=MAP * ~NOTFOUND",
)


@contextmanager
def browser(folder: Path) -> Iterator[webdriver.Chrome]:
    """A browser that keeps what it must keep in the folder."""
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for flag in (*FLAGS, f"--user-data-dir={folder / 'browser'}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(options, webdriver.ChromeService("/usr/bin/chromedriver"))
    try:
        yield driver
    finally:
        driver.quit()


def picture(element: WebElement) -> np.ndarray:
    """What the element shows, height x width x 3."""
    image = Image.open(io.BytesIO(base64.b64decode(element.screenshot_as_base64)))
    return np.asarray(image.convert("RGB")).astype(int)
