"""A sweep from its plan to its dataset: who makes the runs, and what of them is kept where."""

from __future__ import annotations

import sys
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from lagdsl.engines.runtime.engines.cores import cores
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.version import __version__
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.text import flat_text
from lagdsl.motion.simulate.resolution import DEFAULT_ROWS
from lagdsl.motion.simulate.simulate import check_options, grid
from lagdsl.motion.sweep.dataset import dataset, require_room, require_writer, write
from lagdsl.motion.sweep.journal import Journal, fingerprint_of, outcomes, require_idle
from lagdsl.motion.sweep.plan import Plan, calls_python, fingerprint, require_sound, tasks_of
from lagdsl.motion.sweep.run import Options, Outcome, SweptModel
from lagdsl.motion.sweep.threads import in_threads

if TYPE_CHECKING:
    import xarray


class Unfinished(ValueError):  # noqa: N818  it is not the sweep that is wrong
    """There is a journal, and it is not clear whether to go on with it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Work:
    """Resources of a sweep: `jobs` threads (None: one per core) or the scheduler at an address. `units` asks for units
    in the header of a table."""

    jobs: int | None = None
    scheduler: str | None = None
    output: Path | None = None
    resume: bool = False
    units: bool = False


def sweep(
    plan: Plan,
    known: list[dict[str, float]],
    subjects: Sequence[SweptModel],
    options: Options,
    work: Work,
    progress: Callable[[float], None] | None = None,
) -> xarray.Dataset:
    """All runs of `plan`; `subjects` are the models of the structural settings `known`.

    With `work.output` every run is in the journal when it has ended, so that an interrupted sweep can be resumed; the
    result is written there and the journal deleted. Raises ValueError for what is no sweep or too large, Unfinished and
    Busy, OSError for files that cannot be written, ModuleNotFoundError for a package that is missing, ConnectionError
    for a cluster that does not answer.
    """
    import xarray  # noqa: F401  found out before the work is done

    require_sound(plan)
    flat = next((swept.flat for swept in subjects if swept.flat is not None), None)
    if flat is None:
        raise ValueError(subjects[0].fault)
    times = times_of(subjects, options)
    require_room(plan.runs, len(times), width_of(subjects, options), work.output)
    if work.output is None:
        if work.resume:
            raise ValueError("only a sweep with an output can be resumed")
        found = list(_watched(_made(plan, known, subjects, options, work, frozenset()), 0, plan.runs, progress))
        return dataset(plan, times, found, model=flat.name)
    require_writer(work.output)
    path = journal_path(work.output)
    identity = _identity(plan, subjects, options)
    _require_own(path, identity, work.resume)
    with Journal(path, identity) as journal:
        finished = frozenset(outcome.index for outcome in outcomes(path))
        made = _made(plan, known, subjects, options, work, finished)
        for outcome in _watched(made, len(finished), plan.runs, progress):
            journal.append(outcome)
    result = dataset(plan, times, outcomes(path), model=flat.name)
    write(result, work.output, units=work.units)
    path.unlink()
    return result


def journal_path(output: Path) -> Path:
    """Path of the finished runs of an unfinished sweep: `out.nc.partial`."""
    return output.with_name(f"{output.name}.partial")


def _made(
    plan: Plan,
    known: list[dict[str, float]],
    subjects: Sequence[SweptModel],
    options: Options,
    work: Work,
    finished: frozenset[int],
) -> Generator[Outcome, None, None]:
    """The outcomes of what is left to do, in the order in which they end."""
    tasks = tasks_of(plan, known, finished)
    left = plan.runs - len(finished)
    if work.scheduler is not None:
        from lagdsl.motion.sweep.cluster import on_cluster

        return on_cluster(work.scheduler, subjects, options, tasks, left)
    jobs = cores() if work.jobs is None else work.jobs
    return in_threads(subjects, options, tasks, left, 1 if calls_python(plan) else jobs)


def _watched(
    made: Generator[Outcome, None, None], done: int, total: int, progress: Callable[[float], None] | None
) -> Iterator[Outcome]:
    """The same outcomes; whoever makes them stops when nobody asks for more."""
    with closing(made) as source:
        for count, outcome in enumerate(source, done + 1):
            yield outcome
            if progress is not None:
                progress(count / total)


def _require_own(path: Path, fingerprint: str, resume: bool) -> None:
    """Raise Unfinished or Busy where there is a journal that this sweep may not go on with."""
    found = fingerprint_of(path)
    if found is None:
        return
    require_idle(path)
    if next(outcomes(path), None) is None:  # of a process that was killed before its first run ended
        return
    if not resume:
        raise Unfinished(
            f"{path} holds the finished runs of a sweep that was interrupted; resume it, or delete that file"
        )
    if found != fingerprint:
        raise Unfinished(f"{path} belongs to another sweep: model, values or options have changed; delete that file")


def width_of(subjects: Sequence[SweptModel], options: Options) -> int:
    """Number of columns that every run has at most."""
    if options.columns is not None:
        return len(options.columns)
    layouts = [swept.program.layout for swept in subjects if swept.program is not None]
    return max(
        2 * len(x.coordinates) + len(x.states) + len(x.inputs) + len(x.outputs) + x.kinds.count("variable")
        for x in layouts
    )


def times_of(subjects: Sequence[SweptModel], options: Options) -> Floats:
    """The times of the rows, which all runs share."""
    starts = {s.flat.experiment.start_time for s in subjects if s.flat is not None}
    if len(starts) > 1:
        raise ValueError("the runs of a sweep must start at the same time")
    (start,) = starts
    check_options(start, options.stop, 1e-8 if options.tolerance is None else options.tolerance, options.solver)
    return grid(start, options.stop, options.interval)


def _identity(plan: Plan, subjects: Sequence[SweptModel], options: Options) -> str:
    """A digest of the settings that must stay the same when a sweep is resumed; arrays with all their digits."""
    models = [swept.fault if swept.flat is None else flat_text(swept.flat) for swept in subjects]
    with np.printoptions(threshold=sys.maxsize, floatmode="unique"):
        return fingerprint(plan, __version__, repr(options), *models)


def options_of(flat: FlatModel, *, stop: float | None, interval: float | None) -> tuple[float, float]:
    """Stop time and interval of all runs, which share their rows: what is left out says the experiment of the model."""
    experiment = flat.experiment
    end = experiment.stop_time if stop is None else float(stop)
    between = experiment.interval if interval is None else float(interval)
    return end, (end - experiment.start_time) / DEFAULT_ROWS if between is None else between
