# SPDX-License-Identifier: GPL-3.0-or-later
"""File names as text: a name on disk is bytes, and no text need stand for them."""

from __future__ import annotations


def printable(text: str) -> str:
    """The text with bytes that are not UTF-8, which Python keeps in names, as `\\xff`."""
    return text.encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")
