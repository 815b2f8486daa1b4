"""`lag sweep FILE`: many runs, one labelled dataset."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import CompilationFailed, Diagnostic, Severity, Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.cli.columns import columns_of
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.groups import PATH, group
from lagdsl.interfaces.cli.model_file import ModelFile, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.interfaces.cli.options import (
    InputOptions,
    Method,
    Span,
    Table,
    takes_method,
    takes_span,
    takes_swept_signals,
    takes_table,
)
from lagdsl.interfaces.cli.output import Unwritable, require_units, require_writable
from lagdsl.interfaces.cli.pages import require_page, write_page
from lagdsl.interfaces.cli.plots import Plot, require_sound, takes_plot
from lagdsl.interfaces.cli.progress import progress
from lagdsl.interfaces.cli.status import FAILED_RUN, INTERRUPTED
from lagdsl.interfaces.cli.sweep_inputs import swept_inputs_or_leave
from lagdsl.interfaces.cli.sweep_page import page_of, require_one_machine
from lagdsl.interfaces.cli.sweep_plot import draw_sweep, require_kept
from lagdsl.interfaces.cli.text_table import aligned
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.settings import split
from lagdsl.motion.pipeline import Compilation, compile_flat, flatten_file, flatten_for_runs
from lagdsl.motion.signals.inputs import report_missing
from lagdsl.motion.simulate.table import called_heads

if TYPE_CHECKING:
    import xarray

    from lagdsl.motion.sweep.plan import Axis, Plan
    from lagdsl.motion.sweep.run import Options, SweptModel
    from lagdsl.motion.sweep.sweep import Work

_MOST_REASONS = 3


@record(kw_only=True)
class Values:
    """Assignments of values, the number of draws from distributions, and the seed of the draws."""

    assignments: tuple[str, ...]
    random: int | None
    seed: int


@record(kw_only=True)
class Machines:
    """Threads or the cluster that make the runs; with `resume` only those that are missing."""

    jobs: int | None
    scheduler: str | None
    resume: bool


_takes_values = group(
    "values",
    Values,
    click.option(
        "--set",
        "assignments",
        multiple=True,
        metavar="NAME=VALUES",
        help="Range 'l=0.1:0.1:1 m' (first:step:last) or 'l=linspace(0.1, 1, 10) m', list 'm=1, 2, 5 kg', draws "
        "'m=normal(1, 0.1) kg'; starts as 'x.start=...'.",
    ),
    click.option("--random", type=click.IntRange(min=1), metavar="N", help="Number of draws from the distributions."),
    click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True, help="Seed of the draws."),
)
_takes_machines = group(
    "machines",
    Machines,
    click.option("--jobs", type=click.IntRange(min=1), metavar="N", help="Threads; default: one for each core."),
    click.option("--scheduler", metavar="ADDRESS", help="Make the runs on the Dask cluster at ADDRESS."),
    click.option("--resume", is_flag=True, help="Continue an interrupted sweep to the same output."),
)


@click.command("sweep", cls=Command)
@takes_model
@_takes_values
@takes_span
@takes_swept_signals
@takes_method("auto, dop853, radau.")
@takes_table("Write the dataset: .nc, .parquet or .csv.")
@takes_plot
@click.option("--page", type=PATH, metavar="F.html", help="Write a page with a slider over the runs.")
@_takes_machines
def command(
    model_file: ModelFile,
    values: Values,
    span: Span,
    inputs: InputOptions,
    method: Method,
    table: Table,
    plot: Plot,
    page: Path | None,
    machines: Machines,
) -> None:
    """Run the model in FILE with every combination of values; without -o, show a summary."""
    from lagdsl.motion.sweep.plan import variants
    from lagdsl.motion.sweep.run import Options
    from lagdsl.motion.sweep.sweep import Work, options_of

    style = model_file.style
    require_writable(table.output)
    if machines.resume and table.output is None:
        raise click.UsageError("--resume continues a sweep to a file: give the file with -o")
    _require_packages(table.output, machines.scheduler)
    require_units(table.output, table.units)
    require_sound(plot)
    require_page(page)
    source = read_or_leave(model_file.file, style)
    given = swept_inputs_or_leave(inputs, style)
    sink = Sink()
    pairs = split(values.assignments)
    flat, known = _front(source, model_file, pairs, sink)
    signals, tables = given.of(flat, sink, style)
    report_missing(flat, given.names, sink)
    subjects = _subjects(source, model_file, known)
    the_plan = _plan(subjects, pairs, values, sink, given.values, tables)
    if variants(the_plan) != known:  # a setting brings structural parameters that the first one has not
        known = variants(the_plan)
        subjects = _subjects(source, model_file, known)
    tell(sink.diagnostics, style)
    end, step = options_of(flat, stop=span.end, interval=span.step)
    models = [swept.flat for swept in subjects if swept.flat is not None]
    kept = columns_of(table.columns, models)
    require_kept(plot, models, kept)
    if page is not None:
        require_one_machine(the_plan)
    options = Options(
        stop=end,
        interval=step,
        tolerance=span.tolerance,
        solver=method.solver,
        engine=method.engine,
        inputs=signals,
        columns=kept,
    )
    work = Work(
        jobs=machines.jobs,
        scheduler=machines.scheduler,
        output=table.output,
        resume=machines.resume,
        units=table.units,
    )
    data = _sweep(the_plan, known, subjects, options, work)
    if table.output is None:
        click.echo(_summary(data, the_plan, subjects))
    draw_sweep(plot, data, the_plan, models)
    if page is not None:
        wishes = Wishes(stop=end, tolerance=span.tolerance, inputs=signals)
        write_page(page, lambda: page_of(the_plan, models, wishes, source, sink), sink, style)
    failed = _tell_failures(data, the_plan)
    if failed == the_plan.runs:
        click.get_current_context().exit(FAILED_RUN)


def _sweep(
    plan: Plan, known: list[dict[str, float]], subjects: list[SweptModel], options: Options, work: Work
) -> xarray.Dataset:
    from lagdsl.motion.sweep.sweep import journal_path, sweep

    try:
        with progress(_counted(plan.runs)) as report:
            return sweep(plan, known, subjects, options, work, report)
    except KeyboardInterrupt:
        if work.output is not None:
            kept = journal_path(work.output)
            click.echo(f"interrupted; {kept} holds the finished runs, continue with --resume", err=True)
            click.get_current_context().exit(INTERRUPTED)
        raise
    except ConnectionError as error:
        hint = ""
        if work.output is not None and journal_path(work.output).exists():
            hint = f"; {journal_path(work.output)} holds the finished runs, continue with --resume"
        raise click.UsageError(f"{error}{hint}") from error
    except OSError as error:
        if work.output is None:
            raise click.UsageError(str(error)) from error
        raise Unwritable(work.output, error) from error
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def _require_packages(output: Path | None, scheduler: str | None) -> None:
    """Leave with status 2, before the work is done, where something is missing."""
    from importlib.util import find_spec

    if find_spec("xarray") is None or (scheduler is not None and find_spec("distributed") is None):
        raise click.UsageError("sweeps need more packages: pip install xarray 'dask[distributed]' pyarrow pandas")
    from lagdsl.motion.sweep.dataset import require_writer

    if output is not None:
        try:
            require_writer(output)
        except (ValueError, ModuleNotFoundError) as error:
            raise click.UsageError(str(error)) from error


def _plan(
    subjects: list[SweptModel],
    pairs: dict[str, str],
    values: Values,
    sink: Sink,
    inputs: dict[str, str],
    tables: list[Axis],
) -> Plan:
    """The runs, with the names of every model; `inputs` are texts of values by name, `tables` axes over files."""
    from lagdsl.motion.sweep.plan import require_sound
    from lagdsl.motion.sweep.values import plan

    try:
        flats = [swept.flat for swept in subjects if swept.flat is not None]
        made = plan(flats, pairs, values.random, values.seed, sink, inputs)
        made = replace(made, axes=(*made.axes, *tables))
        require_sound(made)
    except ValueError as error:
        raise click.UsageError(str(error)) from error
    return made


def _front(
    source: SourceFile, model_file: ModelFile, pairs: dict[str, str], sink: Sink
) -> tuple[FlatModel, list[dict[str, float]]]:
    """A flat model, and all structural settings. It is that of the first one, or of none where the first one is wrong,
    which then is a run that fails; leaves where both are wrong."""
    from lagdsl.motion.sweep.values import first_of, structures

    found = Sink()
    try:
        flat = flatten_for_runs(source, found, model=model_file.model, pairs=pairs, read=first_of)
        if flat is not None:
            for diagnostic in found.diagnostics:
                sink.add(diagnostic)
        else:
            flat = flatten_file(source, sink, model=model_file.model)
        if flat is None:
            leave_with_errors(found.diagnostics, model_file.style)
        return flat, structures(flat, pairs)
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def _subjects(source: SourceFile, model_file: ModelFile, known: list[dict[str, float]]) -> list[SweptModel]:
    """A compiled model for every structural setting; where all are wrong, leaves with what is."""
    from lagdsl.motion.sweep.run import SweptModel

    subjects: list[SweptModel] = []
    found: tuple[Diagnostic, ...] = ()
    for structural in known:
        sink = Sink()
        compilation = _compiled(source, model_file.model, structural, sink)
        if compilation is None:
            found = found or sink.diagnostics
            first = next(d for d in sink.diagnostics if d.severity is Severity.ERROR)
            subjects.append(SweptModel(fault=f"{first.code}: {first.message}"))
        else:
            subjects.append(SweptModel(flat=compilation.flat, program=compilation.program))
    if all(swept.flat is None for swept in subjects):
        leave_with_errors(found, model_file.style)
    return subjects


def _compiled(source: SourceFile, model: str | None, structural: dict[str, float], sink: Sink) -> Compilation | None:
    try:
        flat = flatten_file(source, sink, model=model, structural=structural)
        return None if flat is None else compile_flat(flat, sink)
    except CompilationFailed as failure:
        for diagnostic in failure.diagnostics:
            sink.add(diagnostic)
        return None


def _summary(data: xarray.Dataset, plan: Plan, subjects: list[SweptModel]) -> str:
    """Columns at the end of the runs, in the units that `lag run` shows."""
    import numpy as np

    flats = [swept.flat for swept in subjects if swept.flat is not None]
    shown = {name: head[3] for flat in flats for name, head in called_heads(flat).items()}
    rows: list[tuple[str, ...]] = []
    for name, variable in data.data_vars.items():
        if len(variable.dims) > len(plan.shape):  # over time, too
            ends = variable.values[..., -1]
            sound, display = ends[np.isfinite(ends)], shown[str(name)]
            numbers = [f"{display(f(sound)):.5g}" if sound.size else "" for f in (np.min, np.mean, np.max)]
            rows.append((str(name), *numbers, display.unit))
    header = ("", "least end", "mean end", "largest end", "")
    lines = aligned([header, *rows], left=(0, 4))
    return "\n".join([f"{data.attrs['model']}: {_counted(plan.runs)}", *lines])


def _tell_failures(data: xarray.Dataset, plan: Plan) -> int:
    """Number of failed runs. Writes it to standard error, with the most frequent reasons and the first run of each."""
    from lagdsl.motion.sweep.dataset import MESSAGE, STATUS, about_runs
    from lagdsl.motion.sweep.plan import place

    status, messages = about_runs(data, STATUS), about_runs(data, MESSAGE)
    reasons = Counter(why for each, why in zip(status, messages, strict=True) if each != "ok")
    for reason, count in reasons.most_common(_MOST_REASONS):
        first = place(plan, messages.index(reason))
        where = f" ({'at' if count == 1 else 'first at'} {first})" if first else ""
        click.echo(f"{count} of {_counted(len(status))} failed: {reason}{where}", err=True)
    if len(reasons) > _MOST_REASONS:
        click.echo(f"and for {len(reasons) - _MOST_REASONS} more reasons", err=True)
    return reasons.total()


def _counted(runs: int) -> str:
    return "1 run" if runs == 1 else f"{runs} runs"
