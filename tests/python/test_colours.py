# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of maps: what the eye, the colour-blind too, can tell from them. Colours are measured in CIELAB,
another space than the one they are made in."""

from __future__ import annotations

from pathlib import Path

import generate_colours
import meshlab_developable
import numpy as np
import pytest
from meshlab_developable.colours import colour_range, map_colours

# What a deuteranope sees of linear light: Machado, Oliveira, Fernandes 2009, Table 1, severity 1.
DEUTERANOPIA = np.array(
    [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
)
TO_XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])  # sRGB's
SHARES = np.linspace(0, 1, 17)


def linear(colours):
    """Light from the bytes of sRGB."""
    encoded = colours / 255.0
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


def cielab(colours, eye=None):
    """CIE 1976 under D65."""
    light = linear(colours) if eye is None else np.clip(linear(colours) @ eye.T, 0, 1)
    ratios = light @ TO_XYZ.T / TO_XYZ.sum(axis=1)
    f = np.where(ratios > (6 / 29) ** 3, np.cbrt(ratios), ratios * (29 / 6) ** 2 / 3 + 4 / 29)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=1)


def oklab(colours):
    """By the matrices that Ottosson gives for the way there."""
    to_cones = np.array(
        [
            [0.4122214708, 0.5363325363, 0.0514459929],
            [0.2119034982, 0.6806995451, 0.1073969566],
            [0.0883024619, 0.2817188376, 0.6299787005],
        ]
    )
    to_lab = np.array(
        [
            [0.2104542553, 0.7936177850, -0.0040720468],
            [1.9779984951, -2.4285922050, 0.4505937099],
            [0.0259040371, 0.7827717662, -0.8086757660],
        ]
    )
    return np.cbrt(linear(colours) @ to_cones.T) @ to_lab.T


TABLE = Path(meshlab_developable.__file__).with_name("colours.json")


def test_the_table_is_what_the_plugin_has():
    assert TABLE.read_text(encoding="utf-8") == generate_colours.colour_table(), "run generate_colours.py"


SIDES = pytest.mark.parametrize(("signed", "side"), [(False, 1), (True, 1), (True, -1)])


@SIDES
@pytest.mark.parametrize("eye", [None, DEUTERANOPIA], ids=["usual", "deuteranopia"])
def test_lightness_alone_orders_the_values(eye, signed, side):
    lightness = cielab(map_colours(side * SHARES, signed), eye)[:, 0]
    assert np.diff(lightness).max() < -1
    assert lightness[0] > 80
    assert 20 < lightness[-1] < 45  # dark, but shading still shows


@SIDES
def test_equal_steps_look_equal(signed, side):
    steps = np.linalg.norm(np.diff(oklab(map_colours(side * SHARES, signed)), axis=0), axis=1)
    assert steps.max() < 1.3 * steps.min()


def test_a_sign_shows_in_the_hue_and_not_in_the_lightness():
    up, down = (map_colours(side * SHARES, signed=True) for side in (1, -1))
    assert np.abs(cielab(up)[:, 0] - cielab(down)[:, 0]).max() < 2
    for eye in (None, DEUTERANOPIA):
        apart = np.linalg.norm(cielab(up, eye) - cielab(down, eye), axis=1)
        assert np.diff(apart).min() > 0
        assert apart[-1] > 70
    red, blue = up[-1].astype(int), down[-1].astype(int)
    assert red[0] - red[2] > 100
    assert blue[2] - blue[0] > 100


def test_values_beyond_the_range_take_the_last_colour():
    assert np.array_equal(map_colours([1, 7], False)[0], map_colours([1, 7], False)[1])
    assert np.array_equal(map_colours([-1, -7], True)[0], map_colours([-1, -7], True)[1])
    assert np.array_equal(map_colours([-1, 0], False)[0], map_colours([-1, 0], False)[1])


def test_a_few_outliers_do_not_change_the_range():
    values = np.linspace(0, 1, 1001)
    assert 0.95 < colour_range(values) < 1
    assert colour_range([*values, 1e6, -1e7]) == pytest.approx(colour_range(values), rel=0.01)


def test_a_bump_on_a_flat_sheet_is_no_outlier():
    noise = np.full(10_000, 1e-9)
    assert 0.9 < colour_range([*noise, *np.linspace(0, 1, 60)], noise=1e-6) <= 1


def test_constant_and_tiny_values_have_a_range():
    assert colour_range(np.full(5, -3.0)) == 3
    assert colour_range(np.full(5, 1e-9), noise=1e-6) == 1e-6
    assert colour_range([], noise=1e-6) == 1e-6
