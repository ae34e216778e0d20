# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours of maps, as the plugin paints them (`filter_developable/colour_map.h` says why so).

They are a table that `generate_colours.py` writes, from the plugin's own ramps.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

_TABLE = json.loads(Path(__file__).with_name("colours.json").read_text(encoding="utf-8"))


def colour_range(values: npt.ArrayLike, noise: float = 1e-15) -> float:
    """The absolute value that the last colour stands for: 98 % of the values above `noise` are shown in full.

    It is at least `noise`, which is positive.
    """
    sizes = np.abs(np.ravel(values))
    sizes = sizes[sizes > noise]
    return float(np.quantile(sizes, _TABLE["shown_share"], method="inverted_cdf")) if sizes.size else noise


def map_colours(shares: npt.ArrayLike, signed: bool) -> npt.NDArray[np.uint8]:
    """Colours (n x 3, sRGB) of values given as shares of the range: -1 to 1 where signed, else 0 to 1."""
    ramp = _ramp(signed)
    low = -1.0 if signed else 0.0
    steps = (np.clip(np.ravel(np.asarray(shares, dtype=float)), low, 1.0) - low) / (1.0 - low)
    colours: npt.NDArray[np.uint8] = ramp[np.rint(steps * (len(ramp) - 1)).astype(int)]
    return colours


def colour_map(signed: bool) -> Any:
    """The same colours for matplotlib, over the whole range."""
    from matplotlib.colors import ListedColormap

    return ListedColormap(_ramp(signed) / 255.0, "signed" if signed else "one-sided")


def _ramp(signed: bool) -> npt.NDArray[np.uint8]:
    return np.frombuffer(bytes.fromhex(_TABLE["signed" if signed else "one_sided"]), np.uint8).reshape(-1, 3)
