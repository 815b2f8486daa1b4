"""`lag run FILE`: from a page of text to motion."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import NoReturn

import click

from lagdsl.api.model import Model
from lagdsl.cli.assignments import seconds, split
from lagdsl.cli.compile_model import compile_or_leave
from lagdsl.cli.engine import takes_engine
from lagdsl.cli.model_file import Format, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.cli.output import draft_of, require_figure, require_writable
from lagdsl.cli.progress import progress
from lagdsl.cli.status import FAILED_RUN, USAGE
from lagdsl.diagnostics import CompilationFailed, Sink
from lagdsl.pipeline import Route, findings
from lagdsl.runtime.engines.engine import EngineName
from lagdsl.runtime.engines.selection import engine_of
from lagdsl.signals.table_io import Tables, has_writer, read_inputs, write_events, write_table
from lagdsl.signals.trajectory import Trajectory
from lagdsl.simulate.failure import SimulationFailed

_SECONDS = "e.g. 10, '500 ms'"


@click.command("run")
@takes_model
@click.option("--stop", metavar="T", help=f"End of the simulation [s], {_SECONDS}; default: the model's experiment.")
@click.option("--interval", metavar="H", help="Time between rows [s].")
@click.option("--tolerance", type=float, metavar="R", help="Relative tolerance of the integration.")
@click.option(
    "--set",
    "assignments",
    multiple=True,
    metavar="NAME=VALUE",
    help="Parameter or start value: 'm=2 kg', 'x.start=1 m'.",
)
@click.option("--input", "inputs", type=click.Path(path_type=Path), help="CSV: time and a column for each input.")
@takes_engine
@click.option(
    "--solver", default="auto", show_default=True, metavar="NAME", help="auto, dop853, radau, rk4, leapfrog, ros2."
)
@click.option("--step", metavar="H", help="Length of steps [s], for the solvers rk4, leapfrog and ros2.")
@click.option(
    "--derivation",
    type=click.Choice(["graph", "textbook"]),
    default="graph",
    help="Derivation of the equations: graph, or textbook in SymPy.",
)
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Write the columns to this .csv or .parquet.")
@click.option("--events", type=click.Path(path_type=Path), help="Write the events to this .csv.")
@click.option("--plot", "picture", type=click.Path(path_type=Path), help="Write a figure of the motion.")
def command(
    file: Path,
    model: str | None,
    style: Format,
    stop: str | None,
    interval: str | None,
    tolerance: float | None,
    assignments: tuple[str, ...],
    inputs: Path | None,
    engine: EngineName,
    solver: str,
    step: str | None,
    derivation: Route,
    output: Path | None,
    events: Path | None,
    picture: Path | None,
) -> None:
    """Simulate the model in FILE; without -o, show a summary of the motion."""
    for path in (output, events, picture):
        require_writable(path)
    _require_forms(output, picture, style)
    source = read_or_leave(file, style)
    signals = _read_inputs(inputs, style)
    sink = Sink()
    compilation, chosen = compile_or_leave(source, sink, style, model, derivation, split(assignments))
    try:
        compiled = Model(compilation, engine_of(compilation.program, engine))
        with progress(compiled.name) as report:
            motion = compiled.simulate(
                stop=seconds("--stop", stop),
                interval=seconds("--interval", interval),
                tolerance=tolerance,
                parameters=chosen.parameters,
                start=chosen.start,
                inputs=signals,
                solver=solver,
                step=seconds("--step", step),
                progress=report,
                sink=sink,
            )
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    except SimulationFailed as failure:
        tell((*sink.diagnostics, *failure.diagnostics), style)
        _write(failure.trajectory, output, events, style)
        click.get_current_context().exit(FAILED_RUN)
    except ValueError as error:  # options that make no sense
        raise click.UsageError(str(error)) from error
    tell(sink.diagnostics, style)
    _write(motion, output, events, style)
    if picture is not None:
        from lagdsl.plot.figure import plot

        with draft_of(picture) as draft:
            plot(motion, draft)
    if output is None:
        from lagdsl.cli.summary import summary
        from lagdsl.signals.moved import loops_of

        loops = loops_of(compilation.flat)
        click.echo(summary(motion, freedom=compilation.structure.freedom, loops=loops, curves=sys.stdout.isatty()))


def _require_forms(output: Path | None, picture: Path | None, style: Format) -> None:
    """Leave with status 2, before the work is done, where a file of that ending cannot be written."""
    sink = Sink()
    if output is not None and not has_writer(output, sink):
        _leave_with_usage(sink, style)
    if picture is not None:
        require_figure(picture)


def _read_inputs(path: Path | None, style: Format) -> Tables:
    """The table of inputs; leaves with status 2 where it cannot be read."""
    sink = Sink()
    tables = {} if path is None else read_inputs(path, sink)
    if tables is None:
        _leave_with_usage(sink, style)
    return tables


def _write(motion: Trajectory, output: Path | None, events: Path | None, style: Format) -> None:
    """To the files that there are; leaves with status 2 where one cannot be written."""
    sink = Sink()
    if output is not None:
        write_table(motion, output, sink)
    if events is not None:
        write_events(motion, events, sink)
    if sink.has_errors:
        _leave_with_usage(sink, style)


def _leave_with_usage(sink: Sink, style: Format) -> NoReturn:
    tell(sink.diagnostics, style)
    click.get_current_context().exit(USAGE)
