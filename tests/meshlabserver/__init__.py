# SPDX-License-Identifier: GPL-3.0-or-later
"""A package, so that modules here may be named like those of tests/pymeshlab (whose name is taken)."""
