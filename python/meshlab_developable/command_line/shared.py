# SPDX-License-Identifier: GPL-3.0-or-later
"""What the commands share: exit codes, options made from a filter's parameters, output, errors in words."""

from __future__ import annotations

import contextlib
import enum
import json
import signal
import sys
import warnings
from collections.abc import Callable, Collection, Iterator, Mapping
from pathlib import Path
from typing import Any, NoReturn

import click
from click.shell_completion import CompletionItem

from meshlab_developable.errors import DevelopableError, InvalidParameterError, LostFacesWarning
from meshlab_developable.filters import Filter
from meshlab_developable.names import printable
from meshlab_developable.parameters import Boolean, Choice, Grain, Kind, Length, Number, Parameter


class Exit(enum.IntEnum):
    """The exit codes."""

    DONE = 0
    BAD_INPUT = 2  # click's own for a command that it does not understand
    NOT_CONVERGED = 3
    SOME_NOT_DONE = 4
    INTERRUPTED = 128 + signal.SIGINT


TOO_LITTLE_MEMORY = "there is not enough memory: end other programs, or simplify the mesh"
MESH = click.Path(exists=True, dir_okay=False, path_type=Path)
json_option = click.option("--json", "as_json", is_flag=True, help="Print JSON instead of text.")
quiet_option = click.option("-q", "--quiet", is_flag=True, help="No progress bar.")


def output_option(
    text: str, required: bool = True, folder: bool = False
) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """A decorator that gives a command the option of where to write."""
    path = click.Path(file_okay=not folder, path_type=Path)
    return click.option("-o", "--output", required=required, type=path, help=text)


class Value(click.ParamType[Any]):
    """What a kind of parameter takes, from text."""

    def __init__(self, kind: Kind) -> None:
        self.kind = kind
        self.name = type(kind).__name__.lower()

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The plain Python value."""
        if not isinstance(value, str):
            return value
        try:
            return self.kind.parse(value)
        except ValueError as error:
            self.fail(f"{value!r}: {error}", param, ctx)

    def get_metavar(self, param: click.Parameter, ctx: click.Context) -> str | None:
        """The texts of a choice."""
        others = ("X,Y,Z",) if isinstance(self.kind, Grain) else ()
        return f"[{'|'.join(self.kind.texts + others)}]" if isinstance(self.kind, Choice) else None

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """The texts of a choice that begin so."""
        texts = self.kind.texts if isinstance(self.kind, Choice) else ()
        return [CompletionItem(text) for text in texts if text.lower().startswith(incomplete.lower())]


def filter_options(
    applied: Filter, without: Collection[str] = ()
) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """A decorator that gives a command an option a parameter of the filter; the command takes those that were
    given as keyword arguments, and None for the others."""

    def decorate(function: Callable[..., Any]) -> Callable[..., Any]:
        for parameter in reversed(applied.parameters):
            if parameter.name not in without:
                function = _option(parameter)(function)
        return function

    return decorate


def given(values: Mapping[str, Any]) -> dict[str, Any]:
    """The values of options that were given."""
    return {name: value for name, value in values.items() if value is not None}


@contextlib.contextmanager
def errors_in_words(as_json: bool = False) -> Iterator[None]:
    """Ends the program with BAD_INPUT and a sentence when something is wrong with the input, and with
    INTERRUPTED when it is interrupted; says where a file was not read whole."""
    with warnings.catch_warnings():
        warnings.simplefilter("always", LostFacesWarning)
        warnings.showwarning = _warn
        try:
            yield
        except KeyboardInterrupt:
            sys.exit(Exit.INTERRUPTED)
        except DevelopableError as error:
            end_with_sentence(str(error), as_json)
        except OSError as error:
            place = f": {error.filename}" if error.filename else ""
            end_with_sentence(f"{error.strerror or error}{place}", as_json)
        except MemoryError as error:
            if not str(error) or "bad_alloc" in str(error):
                raise  # to where no memory is needed
            end_with_sentence(str(error), as_json)


def end_with_sentence(sentence: str, as_json: bool = False) -> NoReturn:
    """Ends the program with BAD_INPUT and says why."""
    sentence = printable(" ".join(sentence.split()))
    if as_json:
        print_json({"error": sentence})
    click.echo(f"error: {sentence}", err=True)
    sys.exit(Exit.BAD_INPUT)


def _warn(message: Warning | str, category: type[Warning], *_: Any, **_places: Any) -> None:
    if issubclass(category, LostFacesWarning):
        click.echo(f"warning: {printable(str(message))}", err=True)


def print_json(content: Any) -> None:
    """The content on standard output."""
    click.echo(printable(json.dumps(content, indent=2, ensure_ascii=False, default=str)))


def print_result(as_json: bool, heading: str, values: Mapping[str, Any], **words: Any) -> None:
    """Values with their names: as a table below the heading, or in JSON behind other words."""
    if as_json:
        print_json(words | dict(values))
    else:
        print_table(heading, values)


def print_table(heading: str, rows: Mapping[str, Any]) -> None:
    """Names and values in two columns."""
    click.echo(printable(heading))
    width = max(map(len, rows))
    for name, value in rows.items():
        click.echo(
            f"  {name:{width}}  {value:.6g}" if isinstance(value, float) else f"  {name:{width}}  {value}"
        )


def assignments(texts: Collection[str]) -> dict[str, str]:
    """Names and values of texts like `name=value`. Raises InvalidParameterError for another text."""
    pairs = {}
    for text in texts:
        name, sign, value = text.partition("=")
        if not sign:
            raise InvalidParameterError(f"{text!r} is not of the form name=value")
        pairs[name.strip()] = value.strip()
    return pairs


def _option(parameter: Parameter) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    name = "--" + parameter.name.replace("_", "-")
    kind = parameter.kind
    allowed = kind.range_in_words if isinstance(kind, Number) and kind != Number() else ""
    unit = "length, or % of the mesh's diagonal" if isinstance(kind, Length) else parameter.unit
    notes = filter(None, (unit, allowed, f"default: {_shown(parameter)}"))
    text = f"{parameter.help}  [{'; '.join(notes)}]"
    if isinstance(kind, Boolean):
        return click.option(f"{name}/--no-{name[2:]}", parameter.name, default=None, help=text)
    return click.option(name, parameter.name, type=Value(kind), help=text)


def _shown(parameter: Parameter) -> str:
    if isinstance(parameter.default, bool):
        return "on" if parameter.default else "off"
    return f"{parameter.default:g}" if isinstance(parameter.default, float) else str(parameter.default)
