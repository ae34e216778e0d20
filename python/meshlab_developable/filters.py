# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin's filters, and how to find one by any of its names."""

from __future__ import annotations

from meshlab_developable.description import CUT, FILTERS, FLATTEN, GLOBAL, LOCAL, MAPS, TRIANGULATE
from meshlab_developable.errors import InvalidParameterError
from meshlab_developable.parameters import Filter

__all__ = ["CUT", "FILTERS", "FLATTEN", "GLOBAL", "LOCAL", "MAPS", "TRIANGULATE", "Filter", "find_filter"]


def find_filter(name: str) -> Filter:
    """The filter with that name: on the command line, in menus, or in pymeshlab.

    Raises InvalidParameterError with the names there are.
    """
    for known in FILTERS:
        if name.strip().lower() in (known.name, known.title.lower(), known.function):
            return known
    names = ", ".join(known.name for known in FILTERS)
    raise InvalidParameterError(f"there is no filter {name!r}; the filters are {names}")
