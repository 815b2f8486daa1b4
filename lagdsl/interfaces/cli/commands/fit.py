"""`lag fit FILE DATA...`: parameters and starts from measured motions."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import click

from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.record import record
from lagdsl.interfaces.api.fit import Fit
from lagdsl.interfaces.api.model import Model
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.compile_model import compile_or_leave
from lagdsl.interfaces.cli.groups import PATH, Decorator, group
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
from lagdsl.interfaces.cli.output import draft_of, require_ending, require_writable, write_text
from lagdsl.interfaces.cli.progress import progress
from lagdsl.language.settings.arrays import names_in
from lagdsl.language.settings.failure import SettingError
from lagdsl.language.settings.settings import split
from lagdsl.motion.fit.search import LOSSES
from lagdsl.motion.pipeline import findings

if TYPE_CHECKING:
    from lagdsl.motion.fit.search import Loss
    from lagdsl.motion.fit.unknowns import Bounds


@record(kw_only=True)
class Wanted:
    """Unknowns, their bounds, and what is known of the data."""

    free: str | None
    bounds: tuple[str, ...]
    own: str | None
    sigma: tuple[str, ...]
    columns: tuple[str, ...]
    loss: Loss
    starts: int
    segments: int
    seed: int


@record(kw_only=True)
class Written:
    """Files of the result: the text of the model with the values, and the report."""

    output: Path | None
    report: Path | None


_takes_unknowns: Decorator = group(
    "wanted",
    Wanted,
    click.option("--free", metavar="NAMES", help="Parameters and starts to find: 'c, k, theta.start'."),
    click.option(
        "--bounds", multiple=True, metavar="NAME=LOW:HIGH", help="Bounds, e.g. 'c=0:1 N.m.s'; one may be left out."
    ),
    click.option("--own", metavar="NAMES", help="Those of --free that each of the files has for itself."),
    click.option(
        "--sigma", multiple=True, metavar="NAME=VALUE", help="Standard deviation of a column: 'theta=0.2 deg'."
    ),
    click.option(
        "--column", "columns", multiple=True, metavar="COLUMN=NAME", help="Meaning of a column; none: left out."
    ),
    click.option("--loss", type=click.Choice(LOSSES), default="linear", show_default=True, help="Weight of outliers."),
    click.option(
        "--starts", type=click.IntRange(min=1), default=1, show_default=True, metavar="N", help="Starts of the search."
    ),
    click.option(
        "--segments",
        type=click.IntRange(min=1),
        default=1,
        show_default=True,
        metavar="N",
        help="Segments of each run (multiple shooting), for motions that are chaotic or unstable.",
    ),
    click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True, help="Seed of the starts."),
)
_takes_results: Decorator = group(
    "results",
    Written,
    click.option("-o", "--output", type=PATH, metavar="FITTED.lag", help="Write the text with the values in it."),
    click.option("--report", type=PATH, metavar="F.html", help="Write a page with values, residuals and motions."),
)


@click.command("fit", cls=Command)
@takes_model
@click.argument("data", nargs=-1, required=True, type=PATH)
@_takes_unknowns
@takes_end
@takes_settings
@takes_signals
@takes_method("auto, dop853, radau.")
@_takes_results
def command(
    model_file: ModelFile,
    data: tuple[Path, ...],
    wanted: Wanted,
    span: Span,
    assignments: tuple[str, ...],
    inputs: InputOptions,
    method: Method,
    results: Written,
) -> None:
    """Find parameters and start values of the model in FILE for which its motions are nearest to the DATA.

    DATA are CSV files: `time` and columns of the results of a run, or, without `time`, times of impacts by contact.
    """
    style = model_file.style
    for path in (results.output, results.report):
        require_writable(path)
    require_ending(results.output, "models are", ".lag")
    require_ending(results.report, "pages are", ".html", ".htm")
    source = read_or_leave(model_file.file, style)
    given = inputs_or_leave(inputs, style)
    sink = Sink()
    compilation, chosen = compile_or_leave(model_file, source, sink, split(assignments))
    signals = given.of(compilation.flat, sink, style)
    try:
        compiled = Model(compilation, engine_of(compilation.program, method.engine), source)
        with progress(compiled.name) as report:
            found = compiled.fit(
                [str(path) for path in data],
                _free(wanted),
                sigma=split(wanted.sigma),
                own=names_in(wanted.own or ""),
                columns=_columns(wanted.columns),
                hold=inputs.held,
                parameters=chosen.parameters,
                start=chosen.start,
                inputs=signals,
                stop=span.end,
                tolerance=span.tolerance,
                solver=method.solver,
                loss=wanted.loss,
                starts=wanted.starts,
                segments=wanted.segments,
                seed=wanted.seed,
                progress=report,
                sink=sink,
            )
        tell(sink.diagnostics, style)
        _write(found, results)
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    except SettingError:
        raise
    except ValueError as error:  # options that make no sense
        raise click.UsageError(str(error)) from error
    click.echo(str(found))


def _write(found: Fit, results: Written) -> None:
    if results.output is not None:
        write_text(found.text, results.output)
    if results.report is not None:
        with draft_of(results.report) as draft:
            found.report(draft)


def _free(wanted: Wanted) -> Mapping[str, Bounds] | None:
    """Names with bounds; None where nothing is said. Raises SettingError."""
    if wanted.free is None and not wanted.bounds:
        return None
    free: dict[str, Bounds] = dict.fromkeys(names_in(wanted.free or ""))
    for name, text in split(wanted.bounds).items():
        low, colon, high = text.partition(":")
        if not colon:
            raise SettingError(f"--bounds {name}={text}: bounds are written LOW:HIGH, as in 'c=0:1 N.m.s'")
        unit = high.strip().partition(" ")[2]
        low = f"{low.strip()} {unit}" if low.strip() and unit and " " not in low.strip() else low.strip()
        free[name] = (low or None, high.strip() or None)
    return free


def _columns(texts: tuple[str, ...]) -> dict[str, str | None]:
    """Names of the model by names of columns, None for those that are left out. Raises SettingError."""
    found: dict[str, str | None] = {}
    for text in texts:
        column, equals, name = text.partition("=")
        if not equals or not column.strip():
            raise SettingError(f"--column {text}: expected COLUMN=NAME, or COLUMN= to leave it out")
        found[column.strip()] = name.strip() or None
    return found
