"""`lag run FILE`: the motion of a model."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import NoReturn

import click

from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.interfaces.api.model import Model
from lagdsl.interfaces.cli.columns import columns_of
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.compile_model import compile_or_leave
from lagdsl.interfaces.cli.groups import PATH
from lagdsl.interfaces.cli.inputs import inputs_or_leave
from lagdsl.interfaces.cli.model_file import Format, ModelFile, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.interfaces.cli.options import (
    InputOptions,
    Method,
    Span,
    Table,
    takes_derivation,
    takes_method,
    takes_settings,
    takes_signals,
    takes_span,
    takes_table,
)
from lagdsl.interfaces.cli.output import require_ending, require_units, require_writable
from lagdsl.interfaces.cli.pictures import Pictures, draw_pictures, require_pictures, takes_pictures
from lagdsl.interfaces.cli.plots import Plot, draw_plot, require_names, require_sound, takes_plot
from lagdsl.interfaces.cli.progress import progress
from lagdsl.interfaces.cli.status import FAILED_RUN, USAGE
from lagdsl.language.settings.literal import seconds
from lagdsl.language.settings.settings import split
from lagdsl.motion.pipeline import Route, findings
from lagdsl.motion.signals.table_io import has_writer, write_events, write_table
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed


@click.command("run", cls=Command)
@takes_model
@takes_span
@takes_settings
@takes_signals
@takes_method(
    "auto, dop853, radau, rk4, leapfrog, ros2.",
    click.option("--step", metavar="H", help="Length of steps [s], for the solvers rk4, leapfrog and ros2."),
)
@takes_derivation
@takes_table("Write the columns to this .csv or .parquet.")
@click.option("--events", type=PATH, help="Write the events to this .csv.")
@takes_plot
@takes_pictures
def command(
    model_file: ModelFile,
    span: Span,
    assignments: tuple[str, ...],
    inputs: InputOptions,
    method: Method,
    derivation: Route,
    table: Table,
    events: Path | None,
    plot: Plot,
    pictures: Pictures,
) -> None:
    """Simulate the model in FILE; without -o, show a summary of the motion."""
    style = model_file.style
    for path in (table.output, events):
        require_writable(path)
    _require_table(table.output, style)
    require_sound(plot)
    require_pictures(pictures)
    require_ending(events, "events are", ".csv")
    require_units(table.output, table.units)
    source = read_or_leave(model_file.file, style)
    given = inputs_or_leave(inputs, style)
    sink = Sink()
    compilation, chosen = compile_or_leave(model_file, source, sink, split(assignments), derivation)
    kept = columns_of(table.columns, [compilation.flat])
    require_names(plot, [compilation.flat])
    signals = given.of(compilation.flat, sink, style)
    try:
        compiled = Model(compilation, engine_of(compilation.program, method.engine))
        with progress(compiled.name) as report:
            motion = compiled.simulate(
                stop=span.end,
                interval=span.step,
                tolerance=span.tolerance,
                parameters=chosen.parameters,
                start=chosen.start,
                inputs=signals,
                solver=method.solver,
                step=seconds("--step", method.step),
                progress=report,
                sink=sink,
            )
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    except SimulationFailed as failure:
        tell((*sink.diagnostics, *failure.diagnostics), style)
        _write(failure.trajectory.only(kept), table, events, style)
        click.get_current_context().exit(FAILED_RUN)
    except ValueError as error:  # options that make no sense
        raise click.UsageError(str(error)) from error
    tell(sink.diagnostics, style)
    whole, motion = motion, motion.only(kept)
    _write(motion, table, events, style)
    draw_plot(plot, whole, motion)
    if pictures.wanted:
        wishes = Wishes(
            stop=span.end,
            tolerance=span.tolerance,
            parameters=chosen.parameters,
            start=chosen.start,
            inputs=signals,
        )
        draw_pictures(pictures, compilation.flat, wishes, Sink())
    if table.output is None:
        from lagdsl.interfaces.cli.summary import summary
        from lagdsl.motion.signals.moved import loops_of

        loops = loops_of(compilation.flat)
        on_terminal = sys.stdout.isatty()
        click.echo(summary(motion, freedom=compilation.structure.freedom, loops=loops, curves=on_terminal))
        if on_terminal and not pictures.wanted:
            click.echo(f"lag show {model_file.file} opens the machine")


def _require_table(output: Path | None, style: Format) -> None:
    """Leave with status 2, before the work is done, where a table of that ending cannot be written."""
    sink = Sink()
    if output is not None and not has_writer(output, sink):
        _leave_with_usage(sink, style)


def _write(motion: Trajectory, table: Table, events: Path | None, style: Format) -> None:
    """To the files that there are; leaves with status 2 where one cannot be written."""
    sink = Sink()
    if table.output is not None:
        write_table(motion, table.output, sink, units=table.units)
    if events is not None:
        write_events(motion, events, sink)
    if sink.has_errors:
        _leave_with_usage(sink, style)


def _leave_with_usage(sink: Sink, style: Format) -> NoReturn:
    tell(sink.diagnostics, style)
    click.get_current_context().exit(USAGE)
