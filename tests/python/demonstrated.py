# SPDX-License-Identifier: GPL-3.0-or-later
"""What the demonstration is tried on."""

from pathlib import Path

PANTS = Path(__file__).parents[2] / "meshes" / "short_pants.obj"
