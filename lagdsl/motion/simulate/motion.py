"""One motion: the runtime moves from break to break of the inputs, what it found becomes a trajectory."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import isfinite
from typing import NoReturn

import numpy as np

from lagdsl.derivation.structure.names import located, place
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.structures import Status
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.admissible import EXACT_INTEGERS
from lagdsl.language.flat.event_flow import branches
from lagdsl.language.flat.events import Check
from lagdsl.language.flat.model import Assertion, FlatModel
from lagdsl.language.flat.spans import around
from lagdsl.language.flat.spans import place as where
from lagdsl.motion.signals.inputs import Signals
from lagdsl.motion.signals.trajectory import Statistics, Trajectory
from lagdsl.motion.simulate.control import Controls
from lagdsl.motion.simulate.derivatives import report_no_derivative, tell_one_sided
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.initialize import InitialState
from lagdsl.motion.simulate.messages import Course, report_fault
from lagdsl.motion.simulate.resolution import Resolution, hidden
from lagdsl.motion.simulate.state_words import state_values, time_text
from lagdsl.motion.simulate.stepping import Stepping
from lagdsl.motion.simulate.table import heads_of, recorded_by, trajectory
from lagdsl.motion.simulate.unknown_outputs import State, UnknownOutputs

_PROGRESS_STEP = 0.002
_STATE = ("coordinate", "rate", "state")


@record(kw_only=True)
class Asked:
    """A motion but for its rows; `q` are the start values of coordinates."""

    flat: FlatModel
    engine: Engine
    p: Floats
    q: Floats
    signals: Signals
    start: Mapping[str, float]
    tolerance: float
    solver: str
    step: float | None
    max_steps: int
    controls: Controls | None = None
    tangents: tuple[str, ...] = ()
    extremes: bool = True


@record(kw_only=True)
class Task:
    """Everything one motion needs; `run` has not begun. `finer` makes the same motion with other rows."""

    asked: Asked
    run: Run
    initial: InitialState
    times: Floats
    sink: Sink
    progress: Callable[[float], None] | None
    finer: Callable[[bool], Trajectory | None] | None


class Motion:
    """Not to be used twice."""

    def __init__(self, task: Task) -> None:
        self._task, self._asked, self._run = task, task.asked, task.run
        self._first, self._last = float(task.times[0]), float(task.times[-1])
        span, most = (self._first, self._last), task.asked.max_steps
        told = None if task.progress is None else self._tell_progress
        self._stepping = Stepping(task.asked.engine, task.run, span, most, told)
        self._shown = 0.0
        self._notes: list[str] = []

    def trajectory(self) -> Trajectory:
        """From the first to the last of the requested times."""
        task, run = self._task, self._run
        status = self._ended(run.begin(self._first, task.initial.x))
        self._tell_lost_rank()
        if status is Status.OK:
            controlled = self._asked.controls is not None
            status = self._controlled() if controlled else self._ended(self._stepping.over(self._breaks()))
        if status is Status.OK:
            self._ended(self._stepping.to(self._last))
        self._ended(run.end())
        found = self._check_outputs(self._so_far(self._task.finer, whole=True))
        tell_rounded(self._asked.flat, found, self._task.sink)
        tell_doubted(self._asked.flat, self._run.doubted(len(self._asked.flat.events.relations)), self._task.sink)
        tell_warnings(self._asked.flat, found, self._task.sink)
        tell_one_sided(self._run, self._task.sink)
        return found

    def _breaks(self) -> list[float]:
        """Times at which inputs may jump."""
        return [b for b in self._asked.signals.breaks if b > self._first]

    def _controlled(self) -> Status:
        """Up to the last of them, or of the times at which controllers act."""
        controls, run, status = self._asked.controls, self._run, Status.OK
        assert controls is not None
        instants = {b: list[int]() for b in self._breaks()} | dict(controls.instants())
        for stop, acting in sorted(instants.items()):
            if status is Status.OK and stop > self._first:
                status = self._ended(self._stepping.to(stop))
            if status is Status.OK and stop < self._last:
                if acting:
                    self._check_law(controls.act(acting, run, self._task.sink))
                status = self._ended(run.jump())
        return status

    def _check_law(self, none: int | None) -> None:
        """E0882 where a law has no derivative by the quantity of this number."""
        if none is not None:
            sink, name = Sink(), self._asked.tangents[none]
            sink.report("E0882", None, name=name, time=time_text(self._run.t))
            values = state_values(self._asked.flat, self._run.explain(Status.NOT_SMOOTH).x)
            raise SimulationFailed(sink.diagnostics[-1], self._run.t, values, name, self._so_far())

    def _inputs_at(self, t: float) -> Floats:
        """u (nu,) of a row at time t."""
        u = self._asked.signals.at(t)
        return u if self._asked.controls is None else self._asked.controls.at(t, u)

    def _check_outputs(self, found: Trajectory) -> Trajectory:
        """E0857 for the first output that is no number, with all rows; a note for each without a limit."""
        asked, count = self._asked, len(self._asked.flat.outputs)
        if not count or isfinite(np.add.reduce(self._run.results.rows()[:, -3 - count : -3], axis=None)):
            return found
        columns = [column.values for column in found.columns if column.kind == "output"]
        states = [column.values for column in found.columns if column.kind in _STATE]

        def state_of(row: int) -> State:
            return np.array([values[row] for values in states]), self._inputs_at(float(found.time[row])), self._run.p

        outputs = UnknownOutputs(asked.flat, asked.engine)
        unknown = outputs.first(np.column_stack(columns), found.time, state_of)
        if unknown is not None:
            row, which = unknown
            sink, t = Sink(), float(found.time[row])
            name = outputs.report(which, t, float(columns[which][row]), sink)
            state = {column.name: float(column.values[row]) for column in found.columns if column.kind in _STATE}
            raise SimulationFailed(sink.diagnostics[-1], t, state, name, replace(found, finer=None))
        notes = (outputs.note(which, float(found.time[row])) for row, which in outputs.left)
        statistics = replace(found.statistics, notes=(*found.statistics.notes, *notes))
        return replace(found, statistics=statistics)

    def _ended(self, status: Status) -> Status:
        """OK, or STOPPED where a `terminate` acted; all others end the run as an error."""
        if status not in (Status.OK, Status.STOPPED):
            self._fail(status)
        return status

    def _fail(self, status: Status) -> NoReturn:
        asked, run = self._asked, self._run
        course = Course(asked.flat, asked.engine.layout, run, self._last, asked.max_steps)
        fault = run.explain(status)
        sink = Sink()
        name: str | None
        if status in (Status.GRAZING, Status.NOT_SMOOTH):
            name = report_no_derivative(asked.flat, run, status, asked.tangents, sink)
        else:
            name = report_fault(course, status, fault, self._inputs_at(fault.t), sink)
        values = state_values(asked.flat, fault.x)
        found = self._so_far()
        tell_warnings(self._asked.flat, found, sink)
        raise SimulationFailed(sink.diagnostics[-1], fault.t, values, name, found)

    def _tell_progress(self) -> None:
        assert self._task.progress is not None, "somebody listens"
        part = (self._run.t - self._first) / (self._last - self._first)
        if part - self._shown >= _PROGRESS_STEP or part >= 1.0:
            self._shown = part
            self._task.progress(part)

    def _tell_lost_rank(self) -> None:
        """W0608 where rank is lost at the start."""
        task = self._task
        if not any(self._asked.engine.layout.position_level):
            return
        rank, general, row = self._run.rank()
        if rank < general:
            constraint = next(item.constraint for item in located(self._asked.flat) if row in item.rows)
            name, time = self._asked.engine.layout.constraints[row].name, time_text(self._first)
            task.sink.report("W0608", place(constraint), time=time, rank=rank, general=general, name=name)
            self._notes.append(f"the constraints lost rank at t = {time} s ({rank} instead of {general}) at {name}")

    # ---- what became of it -------------------------------------------------------------------------------------------

    def _so_far(self, finer: Callable[[bool], Trajectory | None] | None = None, *, whole: bool = False) -> Trajectory:
        """With a note on the rows if it is the whole motion."""
        run, report, notes = self._run, self._run.report, tuple(self._notes)
        if report.changes:
            notes += change_notes(run.changes())
        if whole:
            resolution = Resolution(run.results.turns(run.size))
            notes += hidden(resolution, heads_of(self._asked.flat), self._task.times, report.t)
        automatic = "radau" if report.implicit else "dop853"
        statistics = Statistics(
            solver=automatic if self._asked.solver == "auto" else self._asked.solver,
            steps=self._stepping.steps,
            evaluations=report.counts.evaluations,
            jacobians=report.counts.jacobians,
            projections=report.projections,
            notes=notes,
        )
        task, asked = self._task, self._asked
        recorded = recorded_by(asked.flat, run, asked.tangents)
        return trajectory(asked.flat, asked.engine.layout, recorded, task.initial.moved, statistics, finer)


def change_notes(changes: Sequence[tuple[float, bool]]) -> tuple[str, ...]:
    """Changes of the method, where the runtime chooses it."""
    names = {False: "dop853", True: "radau"}
    why = {False: "explicit steps take less work again", True: "implicit steps take less work"}
    return tuple(f"changed from {names[not to]} to {names[to]} at t = {time_text(t)} s: {why[to]}" for t, to in changes)


def tell_doubted(flat: FlatModel, times: Sequence[float], sink: Sink) -> None:
    """W0886 for each relation that turned by what may be the error of the method, with the first of these times."""
    for relation, time in zip(flat.events.relations, times, strict=True):
        if np.isfinite(time):
            sink.report("W0886", where(relation), name=relation.name, time=time_text(time))


def tell_rounded(flat: FlatModel, found: Trajectory, sink: Sink) -> None:
    """W0859 for each discrete Integer that is beyond the whole numbers that are exact."""
    for discrete in flat.events.discretes:
        if discrete.kind != "Integer":
            continue
        column = found.column(discrete.name)
        if max(abs(column.lowest), abs(column.highest)) < EXACT_INTEGERS:
            continue
        values = column.values
        rows = np.flatnonzero(np.abs(values) >= EXACT_INTEGERS)
        if len(rows):
            value, time = f"{values[rows[0]]:.6g}", time_text(float(found.time[rows[0]]))
            sink.report("W0859", where(discrete), name=discrete.name, value=value, time=time)


def tell_warnings(flat: FlatModel, found: Trajectory, sink: Sink) -> None:
    """W0888 for each assertion that warned, with the first time and how often it began to."""
    checks = [a for branch in branches(flat) for a in branch.actions if isinstance(a, Check)]
    watched: list[Assertion | Check] = [*flat.assertions, *checks]
    times: dict[str, list[float]] = {}
    for event in found.events:
        if event.kind == "warning":
            times.setdefault(event.name, []).append(event.time)
    for text, begun in times.items():
        items = [item for item in watched if item.warning and item.message == text]
        often = "" if len(begun) == 1 else f" (the first of {len(begun)} times)"
        sink.report("W0888", where(items[0]), *around(items[0]), time=time_text(begun[0]), text=text, often=often)
