# SPDX-License-Identifier: GPL-3.0-or-later
"""`developable completion`: what makes a shell complete commands and options."""

from __future__ import annotations

import click
from click.shell_completion import get_completion_class


@click.command(name="completion")
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
@click.pass_context
def command(context: click.Context, shell: str) -> None:
    """Print the script that makes a SHELL complete commands, options and their values.

    \b
    Examples:
      developable completion bash >> ~/.bashrc
      developable completion fish > ~/.config/fish/completions/developable.fish
    """
    completion = get_completion_class(shell)
    assert completion is not None
    click.echo(completion(context.find_root().command, {}, "developable", "_DEVELOPABLE_COMPLETE").source())
