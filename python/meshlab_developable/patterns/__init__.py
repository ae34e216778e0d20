# SPDX-License-Identifier: GPL-3.0-or-later
"""Patterns to cut and sew, 1:1: SVG, PDF and DXF of flat panels, with allowances, notches and letters."""

from typing import TYPE_CHECKING, Any

from meshlab_developable.patterns.options import FORMATS, PAPERS, UNITS, PatternOptions

if TYPE_CHECKING:
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


def __getattr__(name: str) -> Any:
    """What draws patterns is imported when it is asked for: it takes seconds, and options do without."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from meshlab_developable.patterns import write

    return getattr(write, name)
