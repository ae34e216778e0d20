# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable global`: all vertices move together."""

from meshlab_developable.command_line.optimization import optimization_command
from meshlab_developable.filters import GLOBAL

command = optimization_command(
    GLOBAL,
    """Move all vertices together, to the nearest developable shape; begin with this.

    Ends with 3 when a panel did not become developable; what was reached is written all the same.

    \b
    Examples:
      developable global panel.ply --output developable.ply
      developable global panel.obj -o out.ply --solver "Conjugate gradient" --angle-tolerance 0.01
      developable global panel.ply -o out.ply --fix-boundary --json
    """,
)
