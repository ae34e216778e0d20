# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures: there is a shape, its colours say the values, and the scale is under it."""

from __future__ import annotations

from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
import reference_measures as reference
from meshlab_developable.rendering import FOOTING, HEADING, PICTURE_SIZE, Picture, View, render, robust_scale

SHELL = Path(__file__).parents[2] / "meshes" / "dented_shell.obj"


@pytest.fixture(scope="module")
def shell():
    positions, triangles, _ = reference.read_obj(SHELL)
    return Picture("shell", positions, triangles, reference.angle_defects(positions, triangles))


def rendered(tmp_path, pictures, scale, view=None):
    render(tmp_path / "picture.png", pictures, scale, view)
    return matplotlib.image.imread(tmp_path / "picture.png")[:, :, :3]


def shape_part(image, column):
    width, height = PICTURE_SIZE
    return image[HEADING : HEADING + height, column * width : (column + 1) * width]


def with_values(picture, values):
    return Picture(picture.title, picture.vertices, picture.faces, values)


def test_shape_fills_the_picture_and_no_more(tmp_path, shell):
    image = rendered(tmp_path, [shell], robust_scale("g, rad", [shell.values], signed=True))
    shape = (shape_part(image, 0) < 0.95).any(axis=2)
    assert 0.2 < shape.mean() < 0.9
    rim = [shape[0], shape[-1], shape[:, 0], shape[:, -1]]
    assert not np.concatenate(rim).any()


def test_scale_is_drawn_with_its_colours_and_label(tmp_path, shell):
    image = rendered(tmp_path, [shell], robust_scale("g, rad", [shell.values], signed=True))
    bar, label = image[-FOOTING:-66], image[-66:]
    bar_row = bar[np.ptp(bar, axis=2).sum(axis=1).argmax()]
    reddest, bluest = np.argmax(bar_row[:, 0] - bar_row[:, 2]), np.argmax(bar_row[:, 2] - bar_row[:, 0])
    assert bar_row[reddest, 0] - bar_row[reddest, 2] > 0.5
    assert bluest < reddest
    assert (label < 0.5).all(axis=2).sum() > 50


def test_colours_tell_the_sign(tmp_path, shell):
    scale = robust_scale("x", [np.ones(1)], signed=True)
    up, down = (with_values(shell, np.full(len(shell.vertices), sign)) for sign in (1.0, -1.0))
    image = rendered(tmp_path, [up, down], scale)
    red, _, blue = np.moveaxis(shape_part(image, 0), 2, 0)
    assert (red - blue).max() > 0.3
    assert (red - blue).min() > -0.1
    red, _, blue = np.moveaxis(shape_part(image, 1), 2, 0)
    assert (blue - red).max() > 0.3
    assert (blue - red).min() > -0.1


def test_pictures_share_eye_and_scale(tmp_path, shell):
    small = Picture("small", shell.vertices * 0.5, shell.faces, shell.values * 0.5)
    image = rendered(tmp_path, [shell, shell, small], robust_scale("g", [shell.values], signed=True))
    assert np.array_equal(shape_part(image, 0), shape_part(image, 1))
    areas = [(shape_part(image, i) < 0.95).any(axis=2).sum() for i in (0, 2)]
    assert 0.2 < areas[1] / areas[0] < 0.3
    colourful = [np.ptp(shape_part(image, i), axis=2).max() for i in (0, 2)]
    assert colourful[1] < colourful[0]


def test_view_changes_the_picture(tmp_path, shell):
    scale = robust_scale("g", [shell.values], signed=True)
    above, side = (rendered(tmp_path, [shell], scale, View(eye)) for eye in ((0.1, 0, 1), (1, 0, 0.1)))
    assert np.abs(above - side).mean() > 0.02


def test_faces_may_have_colours_of_their_own_and_then_there_is_no_scale(tmp_path, shell):
    left = shell.vertices[shell.faces].mean(axis=1)[:, 0] < np.median(shell.vertices[:, 0])
    painted = with_values(shell, np.where(left[:, None], (0.8, 0.1, 0.1), (0.1, 0.1, 0.8)))
    image = rendered(tmp_path, [painted], None, View((0, 0, 1), (0, 1, 0)))
    width, height = PICTURE_SIZE
    assert image.shape == (HEADING + height, width, 3)
    red, _, blue = np.moveaxis(shape_part(image, 0), 2, 0)
    reds, blues = (np.nonzero((more - less) > 0.3)[1] for more, less in ((red, blue), (blue, red)))
    assert min(reds.size, blues.size) > 0.1 * width * height
    assert np.quantile(reds, 0.99) < np.quantile(blues, 0.01) + 0.05 * width


def test_range_ignores_a_few_outliers_and_is_centred_on_zero_when_signed():
    values = np.concatenate([np.linspace(-1, 1, 1001), [1e6]])
    scale = robust_scale("x", [values], signed=True)
    assert 0.9 < scale.high < 1.0
    assert scale.low == -scale.high
    assert robust_scale("x", [np.abs(values)], signed=False).low == 0.0


def test_range_of_nothing_but_zeros_is_a_range():
    assert robust_scale("x", [np.zeros(5)], signed=False).high == 1.0
