"""The option that all commands that compute have."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from lagdsl.runtime.engines.engine import ENGINES

_Command = TypeVar("_Command", bound=Callable[..., Any])


def takes_engine(command: _Command) -> _Command:
    """Add `--engine`."""
    option = click.option(
        "--engine",
        type=click.Choice(ENGINES),
        default="auto",
        show_default=True,
        help="tape: interpreted, no compiler; c: compiled; numpy: for comparison; auto: tape, and C for long runs.",
    )
    return option(command)
