"""`lag sensitivity FILE`: how the end of a motion changes with parameters and starts."""

from __future__ import annotations

import click

from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.interfaces.api.model import Model
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.compile_model import compile_or_leave
from lagdsl.interfaces.cli.inputs import inputs_or_leave
from lagdsl.interfaces.cli.model_file import ModelFile, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.interfaces.cli.options import (
    InputOptions,
    Method,
    Span,
    takes_end,
    takes_method,
    takes_settings,
    takes_signals,
)
from lagdsl.interfaces.cli.progress import progress
from lagdsl.interfaces.cli.status import FAILED_RUN
from lagdsl.language.settings.arrays import names_in
from lagdsl.language.settings.settings import split
from lagdsl.motion.pipeline import findings
from lagdsl.motion.simulate.failure import SimulationFailed


@click.command("sensitivity", cls=Command)
@takes_model
@click.option("--of", metavar="NAMES", help="Columns of the motion: 'theta, der(theta)'; default: all coordinates.")
@click.option("--by", metavar="NAMES", help="Parameters and starts: 'l, m, theta.start'; default: all parameters.")
@takes_end
@takes_settings
@takes_signals
@takes_method("auto, dop853, radau.")
def command(
    model_file: ModelFile,
    of: str | None,
    by: str | None,
    span: Span,
    assignments: tuple[str, ...],
    inputs: InputOptions,
    method: Method,
) -> None:
    """Rank what moves the end of the motion of FILE most: changes of columns by one percent of each value."""
    style = model_file.style
    source = read_or_leave(model_file.file, style)
    given = inputs_or_leave(inputs, style)
    sink = Sink()
    compilation, chosen = compile_or_leave(model_file, source, sink, split(assignments))
    signals = given.of(compilation.flat, sink, style)
    try:
        compiled = Model(compilation, engine_of(compilation.program, method.engine), source)
        with progress(compiled.name):
            found = compiled.sensitivity(
                names_in(of) if of is not None else compiled.coordinates,
                names_in(by) if by is not None else compiled.parameters,
                parameters=chosen.parameters,
                start=chosen.start,
                inputs=signals,
                stop=span.end,
                tolerance=span.tolerance,
                solver=method.solver,
                sink=sink,
            )
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    except SimulationFailed as failure:
        tell((*sink.diagnostics, *failure.diagnostics), style)
        click.get_current_context().exit(FAILED_RUN)
    except ValueError as error:  # options that make no sense
        raise click.UsageError(str(error)) from error
    tell(sink.diagnostics, style)
    click.echo(str(found))
