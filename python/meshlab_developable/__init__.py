# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes panels of a triangle mesh developable, moving the surface little (Wang and Tang 2004).

`load()` brings the filters into this process's pymeshlab; `measure`, `make_developable`, `cut_into_panels`
and `flatten` take and return NumPy arrays; `meshlab_developable.patterns` writes flat panels as patterns to
cut and sew.
"""

import meshlab_developable.host  # noqa: F401  (first, as all others import pymeshlab)
from meshlab_developable.cutting import CutPanels, CutReport
from meshlab_developable.errors import (
    DevelopableError,
    FilterError,
    InvalidMeshError,
    InvalidParameterError,
    LostFacesWarning,
    PatternError,
    PluginNotFoundError,
    WriteError,
)
from meshlab_developable.flattening import FlatteningResult
from meshlab_developable.methods import Developed, Measured
from meshlab_developable.panels import panel_reports
from meshlab_developable.plugin import load
from meshlab_developable.reports import (
    GlobalReport,
    LocalReport,
    Measures,
    OptimizationReport,
    PanelReport,
    PanelStrain,
    PatternReport,
    Status,
)
from meshlab_developable.sewing import Seam
from meshlab_developable.signatures import cut_into_panels, flatten, make_developable, measure

__version__ = "0.1.0"

__all__ = [
    "CutPanels",
    "CutReport",
    "DevelopableError",
    "Developed",
    "FilterError",
    "FlatteningResult",
    "GlobalReport",
    "InvalidMeshError",
    "InvalidParameterError",
    "LocalReport",
    "LostFacesWarning",
    "Measured",
    "Measures",
    "OptimizationReport",
    "PanelReport",
    "PanelStrain",
    "PatternError",
    "PatternReport",
    "PluginNotFoundError",
    "Seam",
    "Status",
    "WriteError",
    "cut_into_panels",
    "flatten",
    "load",
    "make_developable",
    "measure",
    "panel_reports",
]
