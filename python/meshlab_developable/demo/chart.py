# SPDX-License-Identifier: GPL-3.0-or-later
"""The histogram of angle defects."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from meshlab_developable.rendering import Array

COLOURS = ("#777777", "#0072b2", "#d55e00", "#009e73")  # told apart by the colour-blind too


def write_histogram(file: Path, defects: Mapping[str, Array], tolerance: float) -> None:
    """Counts of angle defects (rad) for each named set, as an SVG. The tolerance is marked.

    The range shows 99 % of the first set; what lies beyond it is counted in the outermost bins.
    """
    from matplotlib.figure import Figure

    first = np.abs(next(iter(defects.values())))
    reach = max(float(np.quantile(first[first > 0], 0.99)) if (first > 0).any() else 0.0, 3 * tolerance)
    edges = np.linspace(-reach, reach, 62).tolist()
    figure = Figure(figsize=(8, 3.2), layout="constrained")
    axis = figure.subplots()
    axis.axvspan(-tolerance, tolerance, color="#dddddd", label=f"within {tolerance:g} rad")
    for (name, values), colour in zip(defects.items(), COLOURS, strict=False):
        axis.hist(
            np.clip(values, -reach, reach), edges, histtype="step", label=name, color=colour, linewidth=1.5
        )
    axis.set_yscale("log")
    axis.set_xlabel("angle defect g, rad")
    axis.set_ylabel("interior vertices")
    axis.legend(loc="upper left", fontsize=8)
    figure.savefig(file)
