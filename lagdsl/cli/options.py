"""The options that several commands have: each means the same in all of them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeAlias

import click

from lagdsl.runtime.engines.engine import ENGINES

Command: TypeAlias = Callable[..., Any]
Decorator: TypeAlias = Callable[[Command], Command]
PATH = click.Path(path_type=Path)

takes_engine: Decorator = click.option(
    "--engine",
    type=click.Choice(ENGINES),
    default="auto",
    show_default=True,
    help="tape: interpreted, no compiler; c: compiled; numpy: for comparison; auto: tape, and C for long runs.",
)
takes_settings: Decorator = click.option(
    "--set",
    "assignments",
    multiple=True,
    metavar="NAME=VALUE",
    help="Parameter or start value: 'm=2 kg', 'x.start=1 m', 'q.start={10, 20} deg'.",
)
takes_inputs: Decorator = click.option(
    "--input",
    "inputs",
    multiple=True,
    metavar="NAME=VALUE|FILE",
    help="Value of an input, 'f=2 N', or a CSV file: time and a column for each input.",
)
takes_input_hold: Decorator = click.option(
    "--input-hold",
    "hold",
    is_flag=True,
    help="Hold inputs between the rows of a file; without it, real numbers are linear between rows.",
)
takes_columns: Decorator = click.option(
    "--column", "columns", multiple=True, metavar="NAME", help="Keep this column only; may be repeated."
)
takes_units: Decorator = click.option(
    "--units", is_flag=True, help="Write units into the header of CSV: `theta [rad]`."
)
takes_derivation: Decorator = click.option(
    "--derivation",
    type=click.Choice(["graph", "textbook"]),
    default="graph",
    help="Derivation of the equations: graph, or textbook in SymPy.",
)


takes_stop: Decorator = click.option(
    "--stop", metavar="T", help="End of the motion [s], e.g. 10, '500 ms'; default: the model's experiment."
)
takes_interval: Decorator = click.option("--interval", metavar="H", help="Time between rows [s].")
takes_tolerance: Decorator = click.option(
    "--tolerance", type=float, metavar="R", help="Relative tolerance of the integration."
)


def combined(*options: Decorator) -> Decorator:
    """Several decorators in the order of the help."""

    def decorate(command: Command) -> Command:
        for option in reversed(options):
            command = option(command)
        return command

    return decorate


takes_span: Decorator = combined(takes_stop, takes_interval, takes_tolerance)
