"""One run of a sweep: it ends with rows, or with rows so far and the reason; it raises nothing."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lagdsl.derivation.program.program import Layout, Program
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import CompilationFailed, Diagnostic, Severity
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.admissible import require_value
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.derivatives import directions_of
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.simulate import grid, simulate
from lagdsl.motion.sweep.plan import Task

if TYPE_CHECKING:
    from lagdsl.engines.runtime.engines.broadcast import BatchEngine

Status: TypeAlias = Literal["ok", "failed"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Options:
    """Options of every run; times in s. `columns` are the names to keep, None for all; `inputs` those that all runs
    share; `tangents` what they are differentiated by."""

    stop: float
    interval: float | None
    tolerance: float | None
    solver: str
    engine: EngineName
    inputs: Mapping[str, Signal]
    columns: tuple[str, ...] | None = None
    tangents: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class SweptModel:
    """A model to run; `fault` says why there is none. `engines` are ready for derivatives: a runner takes one and puts
    it back."""

    flat: FlatModel | None = None
    program: Program | None = None
    fault: str = ""
    engines: list[BatchEngine] = field(default_factory=list, compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class Outcome:
    """Columns of one run in SI units: `values` (rows, columns) at the times of the grid up to `ended` [s].

    `ended` is nan where the run failed before its first row; `message` says why a run failed. `derivatives` (rows,
    tangents, columns) are there where they are asked for.
    """

    index: int
    status: Status
    ended: float
    message: str
    names: tuple[str, ...]
    units: tuple[str, ...]
    values: Floats
    derivatives: Floats | None = None


class Interrupted(BaseException):
    """The sweep ends before this run does."""


class Runner:
    """Makes runs, one after the other; every model is built when it is first needed, for derivatives at once, as these
    are made of the program, which serves one thread. `progress` is called with the part of a run that is done; it may
    raise Interrupted only."""

    def __init__(
        self, subjects: Sequence[SweptModel], options: Options, progress: Callable[[float], None] | None = None
    ) -> None:
        self._progress = progress
        self._subjects = subjects
        self._options = options
        self._engines: dict[int, BatchEngine] = {}
        for k, swept in enumerate(subjects if options.tangents else ()):
            if swept.flat is not None and swept.program is not None:
                self._engines[k] = swept.engines.pop() if swept.engines else engine_of(swept.program, options.engine)
                directions_of(swept.flat, self._engines[k], options.tangents)

    def leave(self) -> None:
        """No more runs are to be made."""
        for k, engine in self._engines.items() if self._options.tangents else ():
            self._subjects[k].engines.append(engine)

    def __call__(self, task: Task) -> Outcome:
        try:
            motion = self._simulate(task)
        except SimulationFailed as failure:
            ended = None if failure.diagnostic.code == "E0857" else failure.time  # the motion itself goes on
            return _outcome(task, failure.trajectory, self._options, _text(failure.diagnostics), ended)
        except CompilationFailed as failure:
            return failed(task.index, _text(failure.diagnostics))
        except (ValueError, KeyError, ArithmeticError) as error:
            return failed(task.index, str(error.args[0]) if error.args else type(error).__name__)
        except Exception as error:  # one run must not end the others
            return failed(task.index, f"internal error: {type(error).__name__}: {error}")
        return _outcome(task, motion, self._options)

    def _simulate(self, task: Task) -> Trajectory:
        swept, options = self._subjects[task.swept], self._options
        if swept.flat is None or swept.program is None:
            raise ValueError(swept.fault)
        p = np.array(list(parameters_of(swept.flat, swept.program.layout, task.parameters).values()), dtype=np.float64)
        if task.swept not in self._engines:
            self._engines[task.swept] = engine_of(swept.program, options.engine)
        return simulate(
            self._engines[task.swept],
            swept.flat,
            stop=options.stop,
            interval=options.interval,
            tolerance=options.tolerance,
            p=p,
            inputs={**options.inputs, **task.inputs},
            start=task.start,
            solver=options.solver,
            tangents=options.tangents,
            progress=self._progress,
        )


def failed(index: int, message: str) -> Outcome:
    """A run without rows."""
    return Outcome(
        index=index, status="failed", ended=np.nan, message=message, names=(), units=(), values=np.empty((0, 0))
    )


def parameters_of(flat: FlatModel, layout: Layout, chosen: Mapping[str, float]) -> dict[str, float]:
    """The parameters by name, in the order of their vector. Raises ValueError for a name that is none of them, and for
    a value that a parameter may not have."""
    values = {slot.name: value for slot, value in zip(layout.parameters, layout.defaults, strict=True)}
    for name in chosen:
        if name not in values:
            raise ValueError(f"there is no parameter `{name}`")
    for parameter in flat.parameters:
        if parameter.name in chosen:
            require_value(parameter, chosen[parameter.name])
    return {**values, **chosen}


def _outcome(
    task: Task, motion: Trajectory, options: Options, message: str = "", ended: float | None = None
) -> Outcome:
    kept = motion.only(options.columns).columns[1:]
    rows = _rows(motion, options)
    values = np.column_stack([c.values[rows] for c in kept]) if kept else np.empty((len(rows), 0))
    found = motion.sensitivities
    derivatives = None if found is None else np.moveaxis(found.jacobian([c.name for c in kept]), 0, -1)[rows]
    end = float(motion.time[-1]) if len(motion) else np.nan
    return Outcome(
        index=task.index,
        status="failed" if message else "ok",
        ended=end if ended is None else ended,
        message=message,
        names=tuple(c.name for c in kept),
        units=tuple(c.unit for c in kept),
        values=values,
        derivatives=derivatives,
    )


def _rows(motion: Trajectory, options: Options) -> NDArray[np.intp]:
    """Rows at the times of the grid, which all runs share; of two at an event the one after it."""
    if not len(motion):
        return np.zeros(0, dtype=np.intp)
    times = grid(float(motion.time[0]), options.stop, options.interval)
    rows = np.searchsorted(motion.time, times, side="right") - 1
    return np.asarray(rows[motion.time[rows] == times])


def first_error(diagnostics: Sequence[Diagnostic]) -> str | None:
    """In one line; None where there is no error."""
    return next((f"{d.code}: {d.message}" for d in diagnostics if d.severity is Severity.ERROR), None)


def _text(diagnostics: Sequence[Diagnostic]) -> str:
    """The reason of a failure, in one line."""
    return first_error(diagnostics) or f"{diagnostics[0].code}: {diagnostics[0].message}"
