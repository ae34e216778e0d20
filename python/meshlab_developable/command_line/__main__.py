# SPDX-License-Identifier: GPL-3.0-or-later
"""`python -m meshlab_developable.command_line`: the same as `developable`."""

from meshlab_developable.command_line import main

main(prog_name="developable")
