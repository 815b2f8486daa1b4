"""The option that all commands that compute have."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from lagdsl.runtime.engine import ENGINES

_Command = TypeVar("_Command", bound=Callable[..., Any])


def takes_engine(command: _Command) -> _Command:
    """Add `--engine`."""
    option = click.option(
        "--engine",
        type=click.Choice(ENGINES),
        default="auto",
        show_default=True,
        help="auto: tape, at once and without a compiler, and C for long work; numpy: to compare with.",
    )
    return option(command)
