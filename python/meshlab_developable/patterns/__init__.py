# SPDX-License-Identifier: GPL-3.0-or-later
"""Patterns to cut and sew, 1:1: SVG, PDF and DXF of flat panels, with allowances, notches and letters."""

from meshlab_developable.patterns.options import FORMATS, PAPERS, UNITS, PatternOptions
from meshlab_developable.patterns.write import PatternFiles, make_patterns, write_patterns

__all__ = [
    "FORMATS",
    "PAPERS",
    "UNITS",
    "PatternFiles",
    "PatternOptions",
    "make_patterns",
    "write_patterns",
]
