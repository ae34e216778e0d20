# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes panels of a triangle mesh developable, moving the surface little (Wang and Tang 2004).

`load()` brings the filters into this process's pymeshlab; `measure` and `make_developable` take and return
NumPy arrays.
"""

from meshlab_developable.errors import (
    DevelopableError,
    FilterError,
    InvalidMeshError,
    InvalidParameterError,
    PluginNotFoundError,
)
from meshlab_developable.methods import Developed, Measured, make_developable, measure
from meshlab_developable.plugin import load
from meshlab_developable.reports import LocalReport, Measures, OptimizationReport, Status

__version__ = "0.1.0"

__all__ = [
    "DevelopableError",
    "Developed",
    "FilterError",
    "InvalidMeshError",
    "InvalidParameterError",
    "LocalReport",
    "Measured",
    "Measures",
    "OptimizationReport",
    "PluginNotFoundError",
    "Status",
    "load",
    "make_developable",
    "measure",
]
