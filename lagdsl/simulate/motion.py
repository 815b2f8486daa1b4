"""The step loop: a stepper of SciPy, projection after every accepted step, dense output on the requested times."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, NoReturn

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_names import contact_rows, located, place
from lagdsl.mechanics.structure_points import geometry
from lagdsl.runtime.engine import Engine
from lagdsl.simulate.accuracy import Accuracy
from lagdsl.simulate.departure import Departure, cross, depart
from lagdsl.simulate.events.discretes import Discretes
from lagdsl.simulate.events.happenings import Found, Happenings
from lagdsl.simulate.events.passes import Result
from lagdsl.simulate.failure import SimulationFailed
from lagdsl.simulate.initialize import InitialState
from lagdsl.simulate.integrators import METHODS, Method
from lagdsl.simulate.leap import Leaps, can_leap
from lagdsl.simulate.projection import Projection
from lagdsl.simulate.recorder import Recorder
from lagdsl.simulate.right_hand_side import RightHandSide
from lagdsl.simulate.signals import Signals
from lagdsl.simulate.singular import LOST, MEETING, NEAR, Look, Ranks, saddle_height
from lagdsl.simulate.stiffness import Stiffness
from lagdsl.simulate.trajectory import Statistics, Trajectory
from lagdsl.simulate.trouble import component_name, report_trouble, state_text, state_values, time_text
from lagdsl.simulate.watch import Watch

# Language reference, section 6.4: residuals below this part of the tolerance need no projection.
PROJECTION_PART = 1e-3
_PROGRESS_STEP = 0.002
# J has turned by much in a step where less than this part of a direction is left; so often a step is halved to see
# whether it turned steadily.
_TURNED = 0.25
_HALVINGS = 6
# Nearer to a lost rank than this the branches are not told apart any more.
_UNDECIDED = 1e-5
# A fitted crossing is as smooth as this, in tolerances, within these bounds.
_SMOOTH, _SMOOTHEST, _ROUGHEST = 10.0, 1e-9, 1e-7
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


@dataclass(frozen=True, slots=True)
class Reached:
    """A state from which no stepper has been started."""

    t: float
    y: Floats
    h_abs: float


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
        self._exact = Projection(self._system, self._space, 0.0)
        loose = contact_rows(flat)
        lasting = tuple(flag or row in loose for row, flag in enumerate(task.initial.redundant))
        self._ranks = Ranks(self._space, lasting)
        self._look: Look | None = None
        self._times = (-np.inf, -np.inf)
        self._margins = (np.inf, np.inf)
        self._stiffness = Stiffness() if task.solver == "auto" else None
        self._method = METHODS["dop853" if task.solver == "auto" else task.solver]
        self._accuracy = Accuracy(flat, self._space.sizes, self._method.factor * task.tolerance)
        self._happenings = Happenings(flat, self._system, self._exact, (float(task.times[0]), float(task.times[-1])))
        self._leaps = self._made_leaps()
        self._next = 0
        self._steps = 0
        self._changes = 0
        self._shown = 0.0
        self._notes: list[str] = []
        self._method_since = task.initial.t
        self._ended = False

    def _made_leaps(self) -> Leaps | None:
        task = self._task
        if not can_leap(task.engine, task.solver):
            return None
        self._stiffness = None  # the method is chosen in C
        return Leaps(
            task.engine,
            self._system,
            self._projection,
            self._accuracy,
            self._watch,
            task.times,
            task.tolerance,
            task.solver,
            self._ranks,
            Discretes(task.flat, self._system),
            self._happenings.slack,
        )

    def run(self) -> Trajectory:
        """From the first to the last of the requested times."""
        initial, times = self._task.initial, self._task.times
        y = np.concatenate([initial.q, initial.qd, initial.z])
        t = float(times[0])
        last = float(times[-1])
        stops = [*(b for b in self._task.signals.breaks if b > t), last]
        self._system.enter(np.inf)
        y = self._begin(t, y)
        while t < last and not self._ended:
            end = min(stops[0], self._happenings.next_tick())
            self._system.enter(end)
            if self._margins[1] <= LOST:
                t, y = self._leave_singular_position(t, y, end)
            t, y = self._segment(t, y, end)
            stops = [stop for stop in stops if stop > t]
            y = self._tick(t, y)
        if self._happenings.ends:
            self._after_event(t, self._happenings.end(t, y))
        return self._finish()

    # ---- one segment without kinks of inputs -------------------------------------------------------------------------

    def _begin(self, t: float, y: Floats) -> Floats:
        if not np.all(np.isfinite(self._system(t, y))):
            self._fail_without_acceleration(t, y)
        if self._happenings.active:
            y = self._settle(t, self._happenings.begin(t, y))
        self._check(t, y)
        self._look_at_rank(t, y)
        self._recorder.add(t, y)
        self._next = 1
        return y

    def _segment(self, t: float, y: Floats, end: float) -> tuple[float, Floats]:
        """To `end`, or to where the motion ends before."""
        stepper = self._ahead(Reached(t, y, 0.0), end)
        while stepper.t < end and not self._ended:
            self._steps += 1
            if self._steps > self._task.max_steps:
                self._fail("E0812", stepper.t, stepper.y, None, steps=self._task.max_steps)
            before, y_before = float(stepper.t), stepper.y
            self._step(stepper)
            step = float(stepper.t) - before
            projected = self._projected(float(stepper.t), stepper.y)
            if projected is None:
                self._require_progress(before, y_before, step / 4.0, lost=(float(stepper.t), stepper.y))
                stepper = self._stepper(before, y_before, end, step / 4.0)
                continue
            found = self._happenings.find(before, float(stepper.t), stepper.dense_output)
            if found is not None:
                y = self._happen(found, stepper.dense_output())
                if self._ended or found.t >= end:
                    return found.t, y
                stepper = self._ahead(Reached(found.t, y, 0.0), end)
                continue
            lost = self._lost_at(before, y_before, float(stepper.t), projected, stepper.dense_output)
            if lost is not None:
                crossed = self._cross(before, y_before, lost - before, end)
                if crossed is None:
                    self._require_decided(before, y_before, step / 4.0)
                    stepper = self._stepper(before, y_before, end, step / 4.0)
                else:
                    stepper = self._stepper(*crossed, end, None)
                continue
            self._accept(stepper, projected)
            distance = self._distance()
            crossed = None if distance is None else self._cross(float(stepper.t), stepper.y, distance, end)
            if crossed is not None:
                stepper = self._stepper(*crossed, end, None)
            else:
                self._require_decided(float(stepper.t), stepper.y, np.inf)
                stepper = self._reconsider(stepper, step, end)
            stepper = self._ahead(stepper, end)
        return float(stepper.t), np.asarray(stepper.y)

    # ---- events ------------------------------------------------------------------------------------------------------

    def _happen(self, found: Found, dense: Callable[[float], Floats]) -> Floats:
        """The state after an event inside a step."""
        self._record_inside(found.t, lambda: dense)
        y = self._on_constraints(found.t, np.asarray(dense(found.t)))
        self._row_before(found.t, y)
        return self._after_event(found.t, self._happenings.carry_out(found, y))

    def _on_constraints(self, t: float, y: Floats) -> Floats:
        """The state before an event: what is left of a rate along a contact that opens would be an impact."""
        projected = self._exact(t, y)
        return y if projected is None else projected

    def _tick(self, t: float, y: Floats) -> Floats:
        """The state after the clocks that tick at the end of a segment."""
        found = self._happenings.tick(t)
        if found is None or self._ended:
            return y
        self._system.enter(np.inf)
        self._row_before(t, y)
        return self._after_event(t, self._happenings.carry_out(found, y))

    def _row_before(self, t: float, y: Floats) -> None:
        """The row just before an event, unless it is there because its time was asked for."""
        times = self._task.times
        if not (self._next and times[self._next - 1] == t):
            self._recorder.add(t, y)
        while self._next < len(times) and times[self._next] <= t:
            self._next += 1

    def _after_event(self, t: float, result: Result) -> Floats:
        """The state that an event left, with a row."""
        y = self._settle(t, result)
        self._check(t, y)
        self._look_at_rank(t, y)
        self._recorder.add(t, y)
        self._tell(t)
        return y

    def _settle(self, t: float, result: Result) -> Floats:
        """The state that an event left; the end of the run where it failed."""
        if result.failed is not None:
            code, item, text = result.failed
            self._fail(code, t, result.y, item.spans, text=text)
        self._ended = result.stop is not None
        if not np.all(np.isfinite(self._system(t, result.y))):
            self._fail_without_acceleration(t, result.y)
        return result.y

    # ---- many steps at once ------------------------------------------------------------------------------------------

    def _ahead(self, stepper: Any, end: float) -> Any:
        """The stepper from which to go on: after as many steps as C can do without us."""
        here = Reached(float(stepper.t), stepper.y, float(stepper.h_abs))
        there = here if self._leaps is None or here.t >= end else self._leap(self._leaps, here, end)
        if there.t >= end or self._ended:
            return there
        if there is here and not isinstance(stepper, Reached):
            return stepper
        return self._stepper(there.t, there.y, end, there.h_abs if there.h_abs > 0.0 else None)

    def _leap(self, leaps: Leaps, here: Reached, end: float) -> Reached:
        there, going = here, True
        while going and there.t < end:
            going = leaps.forward(
                there.t, there.y, there.h_abs, end, row=self._next, steps=self._task.max_steps - self._steps
            )
            if leaps.t > there.t:
                there = Reached(leaps.t, leaps.y, leaps.h)
                self._steps += leaps.steps
                self._recorder.add_many(
                    leaps.engine, self._task.times[self._next : leaps.row], leaps.rows[self._next : leaps.row]
                )
                self._next = leaps.row
                self._tell(there.t)
                if leaps.happened is not None:
                    y = self._happen_in_leap(there.t, there.y, leaps.happened, leaps.h)
                    there, going = Reached(there.t, y, 0.0), not self._ended
        if there is not here:
            self._follow_method(leaps)
            self._look_at_rank(there.t, there.y)
            self._times, self._margins = (-np.inf, there.t), (np.inf, self._margins[1])
        return there

    def _happen_in_leap(self, t: float, y: Floats, changed: tuple[list[int], list[int]], step: float) -> Floats:
        """The state after an event that C has located."""
        y = self._on_constraints(t, y)
        self._row_before(t, y)
        return self._after_event(t, self._happenings.carry_out(self._happenings.located(t, changed, step), y))

    def _follow_method(self, leaps: Leaps) -> None:
        """Where C changed its method, the steppers of this loop do so too."""
        for t, implicit in leaps.changes[self._changes :]:
            why = "stability, not accuracy, limited the steps" if implicit else "accuracy limits the steps again"
            self._change(METHODS["radau" if implicit else "dop853"], t, why)
            self._changes += 1

    # ---- singular positions ------------------------------------------------------------------------------------------

    def _projected(self, t: float, y: Floats) -> Floats | None:
        """Branches are told apart by the constraints alone where rank is nearly lost."""
        return (self._exact if self._margins[1] < NEAR else self._projection)(t, y)

    def _leave_singular_position(self, t: float, y: Floats, end: float) -> tuple[float, Floats]:
        """The state at which integration begins."""
        found = depart(self._system, self._exact, self._space.sizes, t, y, end)
        return (t, y) if found is None else self._follow(found)

    def _cross(self, t: float, y: Floats, distance: float, end: float) -> tuple[float, Floats] | None:
        """The state beyond a singular position so far ahead, if there is one and the motion leads across."""
        if t >= end:
            return None

        def meets(time: float, state: Floats) -> bool:
            return self._saddle_height(time, state) <= MEETING

        n = self._system.n
        ahead = np.concatenate([y[:n] + distance * y[n : 2 * n], y[n:]])
        if MEETING < self._saddle_height(t + distance, ahead) < np.inf:  # a first look, much cheaper than a fit
            return None
        relative = float(np.clip(_SMOOTH * self._task.tolerance, _SMOOTHEST, _ROUGHEST))
        tolerances = self._accuracy.after(y)[n:] * relative / self._accuracy.relative
        found = cross(self._system, self._exact, t, y, distance, end, meets=meets, tolerances=tolerances)
        if found is None or self._ranks.look(self._jacobian(t + found.length, found.y)).margin <= LOST:
            return None
        return self._follow(found)

    def _saddle_height(self, t: float, y: Floats) -> float:
        return saddle_height(self._system, replace(self._space, t=t), self._ranks.general, t, y)

    def _follow(self, found: Departure) -> tuple[float, Floats]:
        self._record_inside(found.t + found.length, lambda: found.at)
        self._reached(found.t + found.length, found.y)
        return found.t + found.length, found.y

    def _jacobian(self, t: float, y: Floats) -> Floats:
        q, _, z = self._system.split(y)
        space = replace(self._space, t=t, z=z.copy(), u=self._system.inputs(t))
        return space.velocity(np.ascontiguousarray(q), self._space.qd)[1]

    def _lost_at(
        self, t: float, y: Floats, after: float, reached: Floats, dense: Callable[[], Callable[[float], Floats]]
    ) -> float | None:
        """The time in a step at which rank was lost, about; None where it was not."""
        look = self._look
        if look is None or not look.directions:
            return None
        jacobian = self._jacobian(after, reached)
        turn = self._ranks.turn(look, jacobian)
        if turn >= _TURNED:
            return None
        state, first, last = dense(), t, after
        for _ in range(_HALVINGS):
            middle = 0.5 * (first + last)
            between = self._jacobian(middle, np.asarray(state(middle)))
            if self._ranks.turn(look, between) < _TURNED:
                last, jacobian = middle, between
            else:
                first, look = middle, self._ranks.look(between)
            turn = self._ranks.turn(look, jacobian)
            if turn >= _TURNED:
                if last >= after:
                    return None
                first, look, last, jacobian = last, self._ranks.look(jacobian), after, self._jacobian(after, reached)
        return first + (last - first) / (1.0 - min(turn, 0.0))

    def _distance(self) -> float | None:
        """The time until rank is lost, if the last two states lead to that and it is near."""
        (earlier, later), (before, now) = self._times, self._margins
        if not now < min(NEAR, before) or not np.isfinite(before):
            return None
        return now * (later - earlier) / (before - now)

    def _require_decided(self, t: float, y: Floats, step: float) -> None:
        """End the run where branches cannot be told apart. Where none meet rates run away; that shows by itself."""
        span = float(self._task.times[-1] - self._task.times[0])
        margin = self._margins[1]
        if margin > _UNDECIDED and step >= 16.0 * _EPSILON * max(abs(t), span):
            return
        if margin > LOST and not np.isfinite(self._saddle_height(t, y)):
            return
        row = self._ranks.weakest(self._jacobian(t, y))
        item = next(item for item in located(self._flat) if row in item.rows)
        name = self._task.engine.layout.constraints[row].name
        self._fail("E0830", t, y, (place(item.constraint),), name=name)

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
        jacobian = self._jacobian(t, y)
        look = self._ranks.look(jacobian)
        self._times, self._margins = (self._times[1], t), (self._margins[1], look.margin)
        if self._look is None and look.margin <= LOST:
            self._tell_lost_rank(t, jacobian, look.rank)
        self._look = look

    def _tell_lost_rank(self, t: float, jacobian: Floats, rank: int) -> None:
        row = self._ranks.weakest(jacobian)
        item = next(item for item in located(self._flat) if row in item.rows)
        name = self._task.engine.layout.constraints[row].name
        general = self._ranks.general
        at = place(item.constraint)
        self._task.sink.report("W0608", at, time=time_text(t), rank=rank, general=general, name=name)
        self._notes.append(f"the constraints lost rank at t = {time_text(t)} s ({rank} instead of {general}) at {name}")

    # ---- ends --------------------------------------------------------------------------------------------------------

    def _finish(self) -> Trajectory:
        leaps = self._leaps
        statistics = Statistics(
            solver=self._method.name,
            steps=self._steps,
            evaluations=self._system.evaluations + (leaps.evaluations if leaps else 0),
            jacobians=self._system.jacobians + (leaps.jacobians if leaps else 0),
            projections=self._projection.count + (leaps.projections if leaps else 0),
            notes=tuple(self._notes),
        )
        events = tuple(self._happenings.events)
        return self._recorder.trajectory(self._watch.records(), self._task.initial.moved, statistics, events)

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
