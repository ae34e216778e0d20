# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line `developable`, a module a command.

A command is a `click.Command` named `command` in its module; registering it is a line in COMMANDS. Modules
are imported when their command runs, so that help and completion need not wait for the others.
"""

from __future__ import annotations

import importlib
import os
import sys
from typing import Any

import click

from meshlab_developable.parent import OUT_OF_MEMORY

COMMANDS = {  # name: module beside this one
    "measure": "measure",
    "global": "global_method",
    "local": "local_method",
    "cut": "cut",
    "flatten": "flatten",
    "pattern": "pattern",
    "script": "script",
    "report": "report",
    "batch": "batch",
    "completion": "completion",
}


IN_OWN_PROCESSES = {"batch"}  # what they work on is in processes of its own already


class Commands(click.Group):
    """The commands of COMMANDS, in that order."""

    def __call__(self, *arguments: Any, **keywords: Any) -> Any:
        """The program."""
        guarded = not IN_OWN_PROCESSES.intersection(sys.argv[1:2])
        if guarded:
            from meshlab_developable.command_line.guard import continue_in_child

            continue_in_child()
        try:
            return super().__call__(*arguments, **keywords)
        except OSError as error:  # commands put those of their files into words themselves
            from meshlab_developable.command_line import shared

            shared.end_with_sentence(f"what there is to say cannot be printed: {error.strerror or error}")
        except MemoryError:
            if guarded:
                os._exit(OUT_OF_MEMORY)  # a sentence would need some, and so would leaving in order
            from meshlab_developable.command_line import shared

            shared.end_with_sentence(shared.TOO_LITTLE_MEMORY)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Their names."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """A command; None when there is none of that name."""
        if cmd_name not in COMMANDS:
            return None
        module = importlib.import_module(f"{__name__}.{COMMANDS[cmd_name]}")
        command: click.Command = module.command
        return command


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.version_option(package_name="meshlab-developable", prog_name="developable")
def main() -> None:
    """Make panels of triangle meshes developable, so that they can be cut from flat material.

    Exit codes: 0 done; 2 bad input; 3 not converged (the result is written all the same); 4 some meshes of
    a batch are not done; 130 interrupted.

    \b
    Examples:
      developable measure panel.ply
      developable global panel.ply --output flat_enough.ply
      developable COMMAND --help
    """
