"""Groups of options: a command gets the values of each as one record."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any, TypeAlias

import click

Command: TypeAlias = Callable[..., Any]
Decorator: TypeAlias = Callable[[Command], Command]
PATH = click.Path(path_type=Path)


def combined(*options: Decorator) -> Decorator:
    """Several decorators in the order of the help."""

    def decorate(command: Command) -> Command:
        for option in reversed(options):
            command = option(command)
        return command

    return decorate


def group(name: str, made: type, *options: Decorator) -> Decorator:
    """Options in the order of the help. The command gets their values as one record `made`, in its argument `name`; a
    field without an option keeps its default. Names of fields differ between the groups of one command."""

    def decorate(command: Command) -> Command:
        @wraps(command)
        def called(**given: Any) -> None:
            values = {field: given.pop(field) for field in made.__annotations__ if field in given}
            command(**{name: made(**values)}, **given)

        return combined(*options)(called)

    return decorate
