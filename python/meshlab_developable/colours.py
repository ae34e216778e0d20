# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours of maps, as the plugin paints them (`filter_developable/colour_map.h` says why so).

OKLab and its matrices are Björn Ottosson's, "A perceptual color space for image processing" (2020).
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

SHOWN_SHARE = 0.98  # of the values that are more than noise

_TO_CONES = np.array(
    [
        [1.0, 0.3963377774, 0.2158037573],
        [1.0, -0.1055613458, -0.0638541728],
        [1.0, -0.0894841775, -1.2914855480],
    ]
)
_TO_LIGHT = np.array(
    [
        [4.0767416621, -3.3077115913, 0.2309699292],
        [-1.2684380046, 2.6097574011, -0.3413193965],
        [-0.0041960863, -0.7034186147, 1.7076147010],
    ]
)


def colour_range(values: npt.ArrayLike, noise: float = 1e-15) -> float:
    """The absolute value that the last colour stands for: 98 % of the values above `noise` are shown in full.

    It is at least `noise`, which is positive.
    """
    sizes = np.sort(np.abs(np.ravel(values)))
    sizes = sizes[sizes > noise]
    return float(sizes[int(np.ceil(SHOWN_SHARE * sizes.size)) - 1]) if sizes.size else noise


def map_colours(shares: npt.ArrayLike, signed: bool) -> npt.NDArray[np.uint8]:
    """Colours (n x 3, sRGB) of values given as shares of the range: -1 to 1 where signed, else 0 to 1."""
    t = np.clip(np.ravel(np.asarray(shares, dtype=float)), -1.0 if signed else 0.0, 1.0)
    lab = _signed(t) if signed else _one_sided(t)
    light = np.clip((lab @ _TO_CONES.T) ** 3 @ _TO_LIGHT.T, 0.0, 1.0)
    encoded = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    rounded: npt.NDArray[np.uint8] = np.floor(255 * encoded + 0.5).astype(np.uint8)
    return rounded


def colour_map(signed: bool) -> Any:
    """The same colours for matplotlib, over the whole range."""
    from matplotlib.colors import ListedColormap

    shares = np.linspace(-1.0 if signed else 0.0, 1.0, 511 if signed else 256)
    return ListedColormap(map_colours(shares, signed) / 255.0, "signed" if signed else "one-sided")


def _one_sided(t: Array) -> Array:
    """An arc of a helix: light yellow, red, dark violet."""
    angle = np.radians(120.0 - 200.0 * t)
    return np.stack(
        [0.9 - 0.54 * t, 0.05 + 0.13 * np.cos(angle), -0.04 + 0.13 * np.sin(angle)],
        axis=1,
    )


def _signed(t: Array) -> Array:
    """Two straight lines that meet at 0: blue, light grey, red."""
    middle = np.array([0.87, 0.0, 0.0])
    hue = np.radians(np.where(t < 0, 262.0, 30.0))
    ends = np.stack([np.full(t.shape, 0.5), 0.19 * np.cos(hue), 0.19 * np.sin(hue)], axis=1)
    lines: Array = middle + np.abs(t)[:, None] * (ends - middle)
    return lines
