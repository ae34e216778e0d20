# SPDX-License-Identifier: GPL-3.0-or-later
"""Imports pymeshlab, and says in words which libraries of the system it lacks."""

try:
    import pymeshlab  # noqa: F401 - to see whether it can be
except ImportError as error:
    if "shared object" not in str(error):
        raise
    raise ImportError(
        f"pymeshlab lacks a library of the system: {error}. On Debian and Ubuntu, install libgl1, "
        "libglu1-mesa, libegl1, libopengl0, libxrender1, libxcursor1, libfontconfig1, libglib2.0-0, "
        "libcom-err2 and libp11-kit0."
    ) from None
