# SPDX-License-Identifier: GPL-3.0-or-later
"""The demonstration: real meshes through the filters, with pictures and a report that a person can read."""
