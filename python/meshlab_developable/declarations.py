# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions that are declared in one place, for help and editors, and implemented in another."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")


def implemented_by(implementation: Callable[..., R]) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """A decorator for a function that only declares: names, types, defaults, and what they mean.

    A call goes to the implementation, with the arguments that were given and no others: so it can tell a
    choice from a default, and refuse a name in its own words.
    """

    def decorate(declared: Callable[P, R]) -> Callable[P, R]:
        @functools.wraps(declared)
        def call(*arguments: P.args, **keywords: P.kwargs) -> R:
            return implementation(*arguments, **keywords)

        return call

    return decorate
