# SPDX-License-Identifier: GPL-3.0-or-later
"""The demonstration's page in a browser: it renders without an error or the network, and its view turns."""

from __future__ import annotations

import numpy as np
import pytest
from browser import browser, picture
from meshlab_developable.demo.__main__ import METHODS
from meshlab_developable.demo.study import MAPS
from selenium.webdriver import ActionChains, Keys
from selenium.webdriver.common.by import By

WHITE = 250


@pytest.fixture(scope="module")
def page(demonstration, tmp_path_factory):
    folder, _ = demonstration
    # A copy on its own: nothing that lies beside the original can help it.
    alone = tmp_path_factory.mktemp("alone") / "report.html"
    alone.write_bytes((folder / "report.html").read_bytes())
    with browser(tmp_path_factory.mktemp("browser")) as driver:
        driver.get(alone.as_uri())
        yield driver


@pytest.fixture
def canvas(page):
    page.refresh()
    canvas = page.find_element(By.CSS_SELECTOR, ".view canvas")
    page.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
    return canvas


def coloured(image):
    """The part of the picture that the shape covers."""
    return (image < WHITE).any(axis=2)


def changed(before, after):
    return (np.abs(after - before).max(axis=2) > 20).mean()


def test_the_page_renders_without_an_error(page, canvas):
    assert canvas.is_displayed()
    assert page.get_log("browser") == []
    broken = "return [...document.images].filter(image => !image.complete || !image.naturalWidth).length"
    assert page.execute_script(broken) == 0
    assert len(page.find_elements(By.TAG_NAME, "img")) == len(MAPS) + 2
    wide = "return document.documentElement.scrollWidth <= document.documentElement.clientWidth"
    assert page.execute_script(wide)


def test_each_map_is_shown_with_its_name_and_the_one_of_laying_flat_too(page, canvas):
    names = [name.text for name in page.find_elements(By.CSS_SELECTOR, "figure img + figcaption strong")]
    assert names[: len(MAPS)] == [f"{kind.title}." for kind in MAPS]
    [shown] = page.find_elements(By.CSS_SELECTOR, "img[alt='Elastic energy of short_pants']")
    image = picture(shown)
    height, width = image.shape[:2]
    violet = (image[..., 2] > image[..., 1] + 60) & (image[..., 0] < 150)  # what has much of it
    shapes = violet[: int(0.8 * height)]
    assert shapes[:, : width // 2].mean() > 0.005
    assert not shapes[:, width // 2 :].any()


def test_no_table_of_a_method_reaches_into_the_next(page, canvas):
    beyond = """return [...document.querySelectorAll("article table")].filter(table =>
        table.getBoundingClientRect().right > table.parentElement.getBoundingClientRect().right + 1).length"""
    assert len(page.find_elements(By.CSS_SELECTOR, "article table")) == 3 * len(METHODS)
    assert page.execute_script(beyond) == 0


def test_the_page_asks_for_nothing(page, canvas):
    requests = "return performance.getEntriesByType('resource').map(entry => entry.name)"
    assert [name for name in page.execute_script(requests) if not name.startswith("data:")] == []


def test_the_view_shows_the_shape_in_the_colours_of_its_map(canvas):
    image = picture(canvas)
    shape = coloured(image)
    assert 0.1 < shape.mean() < 0.9
    red, blue = image[shape][:, 0] - image[shape][:, 2], image[shape][:, 2] - image[shape][:, 0]
    assert (red > 50).mean() > 0.02
    assert (blue > 50).mean() > 0.02


def test_the_view_turns_and_comes_nearer(page, canvas):
    before = picture(canvas)
    ActionChains(page).drag_and_drop_by_offset(canvas, 120, 40).perform()
    dragged = picture(canvas)
    assert changed(before, dragged) > 0.05
    canvas.send_keys(Keys.ARROW_LEFT * 5)
    turned = picture(canvas)
    assert changed(dragged, turned) > 0.05
    canvas.send_keys("-" * 5)
    assert coloured(picture(canvas)).sum() < 0.6 * coloured(turned).sum()
    assert page.get_log("browser") == []


def test_the_view_shows_each_shape(page, canvas):
    before = picture(canvas)
    labels = page.find_elements(By.CSS_SELECTOR, ".view label")
    titles = [f"after: {method.title}" for method in METHODS]
    assert [label.text for label in labels] == ["before", *titles]
    labels[1].click()
    after = picture(canvas)
    assert changed(before, after) > 0.05
    # What is developable has no colour.
    assert np.ptp(after[coloured(after)], axis=1).max() < 60
    labels[0].click()
    assert changed(before, picture(canvas)) < 0.01
