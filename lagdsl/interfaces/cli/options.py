"""Options that several commands have, alone and in groups: each means the same in all of them."""

from __future__ import annotations

from pathlib import Path

import click

from lagdsl.engines.runtime.engines.engine import ENGINES, EngineName
from lagdsl.foundation.record import record
from lagdsl.interfaces.cli.groups import PATH, Decorator, group
from lagdsl.language.settings.literal import seconds

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
takes_derivation: Decorator = click.option(
    "--derivation",
    type=click.Choice(["graph", "textbook"]),
    default="graph",
    help="Derivation of the equations: graph, or textbook in SymPy.",
)


@record(kw_only=True)
class Span:
    """Times of a motion as texts with units, and the tolerance of its integration."""

    stop: str | None
    interval: str | None = None
    tolerance: float | None

    @property
    def end(self) -> float | None:
        """End of the motion [s]. Raises SettingError for a text that is no time."""
        return seconds("--stop", self.stop)

    @property
    def step(self) -> float | None:
        """Time between rows [s]. Raises SettingError for a text that is no time."""
        return seconds("--interval", self.interval)


_takes_stop = click.option(
    "--stop", metavar="T", help="End of the motion [s], e.g. 10, '500 ms'; default: the model's experiment."
)
_takes_tolerance = click.option("--tolerance", type=float, metavar="R", help="Relative tolerance of the integration.")
takes_span: Decorator = group(
    "span", Span, _takes_stop, click.option("--interval", metavar="H", help="Time between rows [s]."), _takes_tolerance
)
takes_end: Decorator = group("span", Span, _takes_stop, _takes_tolerance)


@record(kw_only=True)
class InputOptions:
    """Arguments of `--input`, and True if tables keep their values between the rows."""

    given: tuple[str, ...]
    held: bool = False


_takes_input = click.option(
    "--input",
    "given",
    multiple=True,
    metavar="NAME=VALUE|FILE",
    help="Value of an input, 'f=2 N', or a CSV file: time and a column for each input.",
)
_takes_hold = click.option(
    "--input-hold",
    "held",
    is_flag=True,
    help="Hold inputs between the rows of a file; without it, real numbers are linear between rows.",
)
takes_inputs: Decorator = group("inputs", InputOptions, _takes_input)
takes_signals: Decorator = group("inputs", InputOptions, _takes_input, _takes_hold)
takes_swept_signals: Decorator = group(
    "inputs",
    InputOptions,
    click.option(
        "--input",
        "given",
        multiple=True,
        metavar="NAME=VALUES|FILES",
        help="Values of an input, as for --set: 'f=1, 2, 3 N'; or a CSV file: time and a column for each input; or a "
        "pattern of such files, 'wind/day?.csv', for a run with each.",
    ),
    _takes_hold,
)


@record(kw_only=True)
class Method:
    """Engine and integrator of a motion; `step` is a text, the length of its steps where that is fixed."""

    engine: EngineName
    solver: str
    step: str | None = None


def takes_method(solvers: str, *more: Decorator) -> Decorator:
    """Add `--engine`, `--solver` with these names, and `more` of `Method`; the command gets them as `method`."""
    solver = click.option("--solver", default="auto", show_default=True, metavar="NAME", help=solvers)
    return group("method", Method, takes_engine, solver, *more)


@record(kw_only=True)
class Table:
    """Columns to keep, the file that they go to, and True if its header has their units."""

    columns: tuple[str, ...]
    output: Path | None
    units: bool


def takes_table(files: str) -> Decorator:
    """Add `--column`, `-o` with this help, and `--units`; the command gets them as `table`."""
    return group(
        "table",
        Table,
        click.option(
            "--column", "columns", multiple=True, metavar="NAME", help="Keep this column only; may be repeated."
        ),
        click.option("-o", "--output", type=PATH, help=files),
        click.option("--units", is_flag=True, help="Write units into the header of CSV: `theta [rad]`."),
    )
