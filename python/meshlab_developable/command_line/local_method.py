# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable local`: one vertex moves at a time."""

from meshlab_developable.command_line.optimization import optimization_command
from meshlab_developable.filters import LOCAL

command = optimization_command(
    LOCAL,
    """Move one vertex at a time along its normal, the worst first; the paper's fast method.

    Ends with 3 when a panel did not become developable; what was reached is written all the same.

    \b
    Examples:
      developable local panel.ply --output better.ply --angle-tolerance 0.01
      developable local panel.ply -o out.ply --descent --smoothing 0.01 --max-displacement 0.5
    """,
)
