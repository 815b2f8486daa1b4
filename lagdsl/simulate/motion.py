"""The step loop: a stepper of SciPy, projection after every accepted step, dense output on the requested times."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, NoReturn

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_names import located, place
from lagdsl.mechanics.structure_points import geometry
from lagdsl.runtime.engine import Engine
from lagdsl.semantics.flat_model import FlatModel
from lagdsl.simulate.accuracy import Accuracy
from lagdsl.simulate.departure import cross, depart
from lagdsl.simulate.failure import SimulationFailed
from lagdsl.simulate.initialize import InitialState
from lagdsl.simulate.integrators import METHODS, Method
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.recorder import Recorder
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.signals import Signals
from lagdsl.simulate.stiffness import Stiffness
from lagdsl.simulate.trajectory import Statistics, Trajectory
from lagdsl.simulate.trouble import component_name, report_trouble, state_text, state_values, time_text
from lagdsl.simulate.watch import RankWatch, Watch

# Language reference, section 6.4: residuals below this part of the tolerance need no projection.
PROJECTION_PART = 1e-3
_PROGRESS_STEP = 0.002
_EPSILON = float(np.finfo(np.float64).eps)


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """Everything one run needs."""

    flat: FlatModel
    engine: Engine
    p: Floats
    signals: Signals
    initial: InitialState
    times: Floats
    sink: Sink
    tolerance: float
    solver: str
    max_steps: int
    progress: Callable[[float], None] | None


class Motion:
    """One run. Not to be used twice."""

    def __init__(self, task: Task) -> None:
        flat, engine = task.flat, task.engine
        self._task = task
        self._flat = flat
        w = np.zeros(len(engine.layout.discretes))
        self._system = RightHandSide(engine, task.signals, w, task.p)
        self._space = replace(geometry(flat, engine, task.p), t=task.initial.t, q=task.initial.q, qd=task.initial.qd)
        self._projection = Projection(self._system, self._space, PROJECTION_PART * task.tolerance)
        self._recorder = Recorder(flat, engine, self._system, self._projection)
        self._watch = Watch(flat, engine, self._system, task.tolerance)
        self._ranks = RankWatch(self._space, engine.layout.redundant.count(False))
        self._stiffness = Stiffness() if task.solver == "auto" else None
        self._method = METHODS["dop853" if task.solver == "auto" else task.solver]
        self._accuracy = Accuracy(flat, self._space.sizes, self._method.factor * task.tolerance)
        self._next = 0
        self._steps = 0
        self._shown = 0.0
        self._notes: list[str] = []
        self._method_since = task.initial.t

    def run(self) -> Trajectory:
        """From the first to the last of the requested times."""
        initial, times = self._task.initial, self._task.times
        y = np.concatenate([initial.q, initial.qd, initial.z])
        t = float(times[0])
        stops = [b for b in self._task.signals.breaks if b > t]
        self._system.enter(np.inf)
        self._begin(t, y)
        for end in [*stops, float(times[-1])]:
            self._system.enter(end)
            if self._ranks.inside:
                t, y = self._leave_singular_position(t, y, end)
            y = self._segment(t, y, end)
            t = end
        return self._finish()

    # ---- one segment without kinks of inputs -------------------------------------------------------------------------

    def _begin(self, t: float, y: Floats) -> None:
        if not np.all(np.isfinite(self._system(t, y))):
            self._fail_without_acceleration(t, y)
        self._check(t, y)
        self._look_at_rank(t, y)
        self._recorder.add(t, y)
        self._next = 1

    def _segment(self, t: float, y: Floats, end: float) -> Floats:
        stepper = self._stepper(t, y, end, None)
        while stepper.t < end:
            self._steps += 1
            if self._steps > self._task.max_steps:
                self._fail("E0812", stepper.t, stepper.y, None, steps=self._task.max_steps)
            before, y_before = float(stepper.t), stepper.y
            self._step(stepper)
            step = float(stepper.t) - before
            projected = self._projection(float(stepper.t), stepper.y)
            if projected is None:
                self._require_progress(before, y_before, step / 4.0, lost=(float(stepper.t), stepper.y))
                stepper = self._stepper(before, y_before, end, step / 4.0)
                continue
            self._accept(stepper, projected)
            crossed = self._cross_singular_position(float(stepper.t), stepper.y, end)
            if crossed is not None:
                stepper = self._stepper(*crossed, end, None)
            else:
                stepper = self._reconsider(stepper, step, end)
        return np.asarray(stepper.y)

    def _leave_singular_position(self, t: float, y: Floats, end: float) -> tuple[float, Floats]:
        """The state at which integration begins."""
        exact = Projection(self._system, self._space, 0.0)
        found = depart(self._system, exact, self._space.sizes, t, y, end)
        if found is None:
            return t, y
        self._record_inside(found.t + found.length, lambda: found.at)
        self._reached(found.t + found.length, found.y)
        return found.t + found.length, found.y

    def _cross_singular_position(self, t: float, y: Floats, end: float) -> tuple[float, Floats] | None:
        """The state beyond a singular position just ahead, if there is one and the motion leads across."""
        distance = self._ranks.ahead()
        if distance is None or t >= end:
            return None
        exact = Projection(self._system, self._space, 0.0)
        found = cross(self._system, exact, t, y, distance, end)
        if found is None:
            return None
        self._record_inside(found.t + found.length, lambda: found.at)
        self._reached(found.t + found.length, found.y)
        return found.t + found.length, found.y

    def _stepper(self, t: float, y: Floats, end: float, first_step: float | None) -> Any:
        if not np.all(np.isfinite(self._system(t, y))):
            self._fail_without_acceleration(t, y)
        return self._method.start(self._system, t, y, end, self._accuracy.after(y), first_step)

    def _step(self, stepper: Any) -> None:
        before = float(stepper.t)
        stepper.step()
        if stepper.status == "failed":
            self._fail_stuck(before, stepper.y)
        self._require_progress(before, stepper.y, float(stepper.t) - before if stepper.t < stepper.t_bound else np.inf)

    def _accept(self, stepper: Any, projected: Floats) -> None:
        """Record the rows inside the step, put the projected state in place, look at what must stay true."""
        self._record_inside(float(stepper.t), stepper.dense_output)
        if projected is not stepper.y:
            self._method.correct(stepper, self._system, projected)
        stepper.atol = self._accuracy.after(projected)
        self._reached(float(stepper.t), projected)

    def _record_inside(self, t: float, dense: Callable[[], Callable[[float], Floats]]) -> None:
        """Record the requested times before `t`; `dense()` gives the states since the last accepted one."""
        times = self._task.times
        first = self._next
        while self._next < len(times) and times[self._next] < t:
            self._next += 1
        if self._next > first:
            state = dense()
            for time in times[first : self._next].tolist():
                y = np.asarray(state(time))
                better = self._projection(time, y)
                row = y if better is None else better
                if self._flat.assertions:
                    self._check(time, row)
                self._recorder.add(time, row)

    def _reached(self, t: float, y: Floats) -> None:
        """Look at what must stay true, record the state if its time was asked for."""
        self._check(t, y)
        self._look_at_rank(t, y)
        if self._next < len(self._task.times) and self._task.times[self._next] == t:
            self._recorder.add(t, y)
            self._next += 1
        self._tell(t)

    def _tell(self, t: float) -> None:
        first, last = float(self._task.times[0]), float(self._task.times[-1])
        part = (t - first) / (last - first)
        if self._task.progress is not None and (part - self._shown >= _PROGRESS_STEP or part >= 1.0):
            self._shown = part
            self._task.progress(part)

    # ---- change of method --------------------------------------------------------------------------------------------

    def _reconsider(self, stepper: Any, step: float, end: float) -> Any:
        """For `auto`: implicit where stability limits the step, explicit again where that does not pay."""
        stiffness, t = self._stiffness, float(stepper.t)
        if stiffness is None or t >= end:
            return stepper
        if not self._method.implicit:
            if not stiffness.seems_stiff(step, lambda: self._system.jacobian(t, stepper.y)):
                return stepper
            stiffness.implicit_started()
            self._change(METHODS["radau"], t, "stability, not accuracy, limited the steps")
        elif stiffness.not_worth_it(t - self._method_since):
            self._change(METHODS["dop853"], t, "implicit steps were hardly longer")
        else:
            return stepper
        return self._stepper(t, stepper.y, end, None)

    def _change(self, method: Method, t: float, why: str) -> None:
        self._notes.append(f"changed from {self._method.name} to {method.name} at t = {time_text(t)} s: {why}")
        self._method = method
        self._method_since = t
        self._accuracy.relative = method.factor * self._task.tolerance

    # ---- what must stay true -----------------------------------------------------------------------------------------

    def _check(self, t: float, y: Floats) -> None:
        report = Sink()
        name = self._watch.check(t, y, report)
        if name is not None:
            if self._next:
                self._recorder.add(t, y)
            self._raise(report, t, y, name)

    def _look_at_rank(self, t: float, y: Floats) -> None:
        if not self._projection.active:
            return
        q = np.ascontiguousarray(self._system.split(y)[0])
        space = replace(self._space, t=t, z=self._system.split(y)[2].copy(), u=self._system.inputs(t))
        jacobian = space.velocity(q, self._space.qd)[1]
        now = self._ranks.singular(t, jacobian)
        if now is None:
            return
        row = self._ranks.weakest(jacobian)
        item = next(item for item in located(self._flat) if row in item.rows)
        name = self._task.engine.layout.constraints[row].name
        general = self._task.engine.layout.redundant.count(False)
        self._task.sink.report("W0608", place(item.constraint), time=time_text(t), rank=now, general=general, name=name)
        self._notes.append(f"the constraints lost rank at t = {time_text(t)} s ({now} instead of {general}) at {name}")

    # ---- ends --------------------------------------------------------------------------------------------------------

    def _finish(self) -> Trajectory:
        statistics = Statistics(
            solver=self._method.name,
            steps=self._steps,
            evaluations=self._system.evaluations,
            jacobians=self._system.jacobians,
            projections=self._projection.count,
            notes=tuple(self._notes),
        )
        return self._recorder.trajectory(self._watch.records(), self._task.initial.moved, statistics)

    def _require_progress(self, t: float, y: Floats, step: float, lost: tuple[float, Floats] | None = None) -> None:
        """End the run if steps are no longer than the round-off of time."""
        span = float(self._task.times[-1] - self._task.times[0])
        if step >= 16.0 * _EPSILON * max(abs(t), span):
            return
        if lost is not None:
            row, size = self._projection.worst(*lost)
            item = next(item for item in located(self._flat) if row in item.rows)
            name = self._task.engine.layout.constraints[row].name
            self._fail("E0811", t, y, item.constraint.spans, name=name, residual=f"{size:.3g}")
        self._fail_stuck(t, y)

    def _fail_without_acceleration(self, t: float, y: Floats) -> NoReturn:
        trouble = self._system.trouble
        assert trouble is not None
        report = Sink()
        name = report_trouble(self._flat, self._system, trouble, report)
        self._raise(report, t, y, name)

    def _fail_stuck(self, t: float, y: Floats) -> NoReturn:
        """The step shrank to nothing: because of trouble just ahead, or because the motion runs away."""
        trouble = self._system.trouble
        if trouble is not None and trouble.t >= t:
            self._fail_without_acceleration(t, y)
        speed = np.abs(self._system(t, y)) / self._accuracy.after(y)
        index = int(np.argmax(np.nan_to_num(speed, nan=np.inf)))
        step = f"{16.0 * _EPSILON * float(self._task.times[-1]):.1g}"
        self._fail("E0809", t, y, None, name=component_name(self._flat, index), step=step)

    def _fail(self, code: str, t: float, y: Floats, spans: Any, **arguments: Any) -> NoReturn:
        report = Sink()
        notes = (f"state: {state_text(self._flat, y)}",)
        report.report(code, spans[0] if spans else None, notes=notes, time=time_text(t), **arguments)
        name = arguments.get("name")
        self._raise(report, t, y, None if name is None else str(name))

    def _raise(self, report: Sink, t: float, y: Floats, name: str | None) -> NoReturn:
        raise SimulationFailed(report.diagnostics[-1], t, state_values(self._flat, y), name, self._finish())
