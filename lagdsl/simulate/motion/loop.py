"""The step loop: a stepper of SciPy, projection after every accepted step, events, rows at the requested times.

Where the engine is C it takes as many steps at once as need no closer look.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_names import contact_rows
from lagdsl.runtime.c_run import Status
from lagdsl.simulate.departure import Departure
from lagdsl.simulate.events.compiled import CompiledHappenings
from lagdsl.simulate.events.happenings import Found, Happenings
from lagdsl.simulate.events.passes import Result
from lagdsl.simulate.leap import Leaps, can_leap
from lagdsl.simulate.motion.choice import Choice
from lagdsl.simulate.motion.ends import Ends
from lagdsl.simulate.motion.passage import Passage
from lagdsl.simulate.motion.rows import Dense, Rows
from lagdsl.simulate.motion.task import Reached, Task, tools_of
from lagdsl.simulate.trajectory import Statistics, Trajectory


class Motion:
    """One run. Not to be used twice."""

    def __init__(self, task: Task) -> None:
        self._task, self._flat, self._times = task, task.flat, task.times
        self._tools = tools = tools_of(task)
        self._system, self._projection, self._watch = tools.system, tools.projection, tools.watch
        self._notes: list[str] = []
        self._rows = Rows(task, tools)
        self._choice = Choice(task, tools, self._notes)
        self._ends = Ends(task, tools, self._choice.accuracy, self._so_far)
        self._passage = Passage(task, tools, self._choice.accuracy, self._ends, self._notes)
        self._leaps = self._made_leaps()
        self._happenings = self._made_happenings()
        self._far = task.last
        self._steps = 0
        self._ended = False

    def _made_leaps(self) -> Leaps | None:
        task, tools = self._task, self._tools
        if not can_leap(task.engine, task.solver):
            return None
        self._choice.leave_to_c()
        return Leaps(
            task.engine,
            tools.system,
            tools.projection,
            self._choice.accuracy,
            tools.watch,
            task.times,
            task.tolerance,
            task.solver,
            self._passage.ranks,
            sorted(contact_rows(task.flat)),
        )

    def _made_happenings(self) -> Happenings:
        task, tools = self._task, self._tools
        given = (task.flat, tools.system, tools.exact, (task.first, task.last))
        return Happenings(*given) if self._leaps is None else CompiledHappenings(*given, self._leaps.run)

    def run(self) -> Trajectory:
        """From the first to the last of the requested times."""
        initial, t, last = self._task.initial, self._task.first, self._task.last
        stops = [*(b for b in self._task.signals.breaks if b > t), last]
        self._system.enter(np.inf)
        y = self._begin(t, np.concatenate([initial.q, initial.qd, initial.z]))
        while t < last and not self._ended:
            self._far = stops[0]
            end = min(self._far, self._happenings.next_tick())
            self._system.enter(self._far)
            if self._passage.lost:
                found = self._passage.leave(t, y, end)
                t, y = (t, y) if found is None else self._follow(found)
            t, y = self._segment(t, y, end)
            stops = [stop for stop in stops if stop > t]
            y = self._tick(t, self._jump(t, y))
        if self._happenings.ends:
            self._after_event(t, self._happenings.end(t, y))
        return self._so_far()

    def _so_far(self) -> Trajectory:
        leaps = self._leaps
        statistics = Statistics(
            solver=self._choice.method.name,
            steps=self._steps,
            evaluations=self._system.evaluations + (leaps.evaluations if leaps else 0),
            jacobians=self._system.jacobians + (leaps.jacobians if leaps else 0),
            projections=self._projection.count + (leaps.projections if leaps else 0),
            notes=tuple(self._notes),
        )
        events = tuple(self._happenings.events)
        return self._rows.recorder.trajectory(self._watch.records(), self._task.initial.moved, statistics, events)

    # ---- one segment without kinks of inputs -------------------------------------------------------------------------

    def _begin(self, t: float, y: Floats) -> Floats:
        self._ends.require_acceleration(t, y)
        if self._happenings.active:
            y = self._settle(t, self._happenings.begin(t, y))
        self._check(t, y)
        self._passage.look_at(t, y)
        self._rows.start(t, y)
        return y

    def _segment(self, t: float, y: Floats, end: float) -> tuple[float, Floats]:
        """To `end`, or to where the motion ends before."""
        stepper = self._ahead(Reached(t, y, 0.0), end)
        while stepper.t < end and not self._ended:
            stepper = self._on(stepper, end)
        return float(stepper.t), np.asarray(stepper.y)

    def _on(self, stepper: Any, end: float) -> Any:
        """The stepper after one step, or another one that begins anew; a `Reached` at the end."""
        before, y_before = float(stepper.t), stepper.y
        self._step(stepper)
        after, step = float(stepper.t), float(stepper.t) - before
        projected = self._passage.projected(after, stepper.y)
        if projected is None:
            self._ends.require_progress(before, y_before, step / 4.0, lost=(after, stepper.y))
            return self._stepper(before, y_before, end, step / 4.0)
        found = self._happenings.find(before, after, stepper.dense_output)
        if found is not None:
            return self._ahead(Reached(found.t, self._happen(found, stepper.dense_output()), 0.0), end)
        lost = self._passage.lost_at(before, y_before, after, projected, stepper.dense_output)
        if lost is not None:
            crossing = self._passage.cross(before, y_before, lost - before, end)
            if crossing is not None:
                return self._stepper(*self._follow(crossing), end, None)
            self._passage.require_decided(before, y_before, step / 4.0)
            return self._stepper(before, y_before, end, step / 4.0)
        self._accept(stepper, projected)
        distance = self._passage.distance()
        crossing = None if distance is None else self._passage.cross(after, stepper.y, distance, end)
        if crossing is not None:
            return self._stepper(*self._follow(crossing), end, None)
        self._passage.require_decided(after, stepper.y, np.inf)
        changed = after < end and self._choice.reconsider(after, stepper.y, step)
        return self._ahead(self._stepper(after, stepper.y, end, None) if changed else stepper, end)

    def _step(self, stepper: Any) -> None:
        self._steps += 1
        before = float(stepper.t)
        if self._steps > self._task.max_steps:
            self._ends.fail("E0812", before, stepper.y, None, steps=self._task.max_steps)
        stepper.step()
        if stepper.status == "failed":
            self._ends.stuck(before, stepper.y)
        step = float(stepper.t) - before if stepper.t < stepper.t_bound else np.inf
        self._ends.require_progress(before, stepper.y, step)

    def _accept(self, stepper: Any, projected: Floats) -> None:
        """Record the rows inside the step, put the projected state in place, look at what must stay true."""
        self._rows.inside(float(stepper.t), stepper.dense_output, self._check)
        if projected is not stepper.y:
            self._choice.method.correct(stepper, self._system, projected)
        stepper.atol = self._choice.accuracy.after(projected)
        self._reached(float(stepper.t), projected)

    def _stepper(self, t: float, y: Floats, end: float, first_step: float | None) -> Any:
        self._ends.require_acceleration(t, y)
        stepper = self._choice.method.start(self._system, t, y, end, self._choice.accuracy.after(y), first_step)
        stepper.max_step = self._happenings.longest_step
        return stepper

    def _reached(self, t: float, y: Floats) -> None:
        """An accepted state."""
        self._check(t, y)
        self._passage.look_at(t, y)
        self._rows.reached(t, y)

    def _follow(self, found: Departure) -> tuple[float, Floats]:
        """The state behind a singular position."""
        self._rows.inside(found.t + found.length, lambda: found.at, self._check)
        self._reached(found.t + found.length, found.y)
        return found.t + found.length, found.y

    def _check(self, t: float, y: Floats) -> None:
        """What must stay true."""
        report = Sink()
        name = self._watch.check(t, y, report)
        if name is not None:
            self._rows.last_good(t, y)
            self._ends.raise_reported(report, t, y, name)

    # ---- events ------------------------------------------------------------------------------------------------------

    def _happen(self, found: Found, dense: Dense) -> Floats:
        """The state after an event inside a step."""
        self._rows.inside(found.t, lambda: dense, self._check)
        return self._carried_out(found, np.asarray(dense(found.t)))

    def _carried_out(self, found: Found, y: Floats) -> Floats:
        """What is left of the rate along a contact that opens would be an impact: the state before is exact."""
        projected = self._tools.exact(found.t, y)
        y = y if projected is None else projected
        self._rows.before_event(found.t, y)
        return self._after_event(found.t, self._happenings.carry_out(found, y))

    def _tick(self, t: float, y: Floats) -> Floats:
        """The state after the clocks that tick at the end of a segment."""
        found = None if self._ended else self._happenings.tick(t)
        if found is None:
            return y
        self._system.enter(np.inf)
        self._rows.before_event(t, y)
        return self._after_event(t, self._happenings.carry_out(found, y))

    def _jump(self, t: float, y: Floats) -> Floats:
        """The state after what inputs bring that jump at the end of a segment."""
        if self._ended or t not in self._task.signals.breaks:
            return y
        self._system.enter(np.inf)
        found = self._happenings.jumped(t, y)
        if found is None:
            return y
        self._system.enter(t)  # the row before has the inputs before
        self._rows.before_event(t, y)
        self._system.enter(np.inf)
        return self._after_event(t, self._happenings.carry_out(found, y))

    def _after_event(self, t: float, result: Result) -> Floats:
        """The state that an event left, with a row."""
        y = self._settle(t, result)
        self._check(t, y)
        self._passage.look_at(t, y)
        self._rows.after_event(t, y)
        return y

    def _settle(self, t: float, result: Result) -> Floats:
        """The state that an event left; the end of the run where it failed."""
        if result.failed is not None:
            code, item, text = result.failed
            self._ends.fail(code, t, result.y, item.spans, text=text)
        self._ended = result.stop is not None
        self._ends.require_acceleration(t, result.y)
        return result.y

    # ---- many steps at once ------------------------------------------------------------------------------------------

    def _ahead(self, stepper: Any, end: float) -> Any:
        """The stepper from which to go on: after as many steps as C can do without us."""
        here = Reached(float(stepper.t), stepper.y, float(stepper.h_abs))
        leaps = None if here.t >= end or self._ended else self._leaps
        there = here if leaps is None else self._leap(leaps, here, end)
        if there.t >= end or self._ended:
            return there
        if there is here and not isinstance(stepper, Reached):
            return stepper
        return self._stepper(there.t, there.y, end, there.h_abs if there.h_abs > 0.0 else None)

    def _leap(self, leaps: Leaps, here: Reached, end: float) -> Reached:
        there, going = here, True
        while going and there.t < end:
            left = self._task.max_steps - self._steps
            going = leaps.forward(there.t, there.y, there.h_abs, self._far, row=self._rows.next, steps=left)
            if leaps.t > there.t or leaps.run.told:
                there = Reached(leaps.t, leaps.y, leaps.h)
                self._steps += leaps.steps
                self._rows.leapt(leaps.engine, leaps.rows(self._rows.next))
                self._rows.tell(there.t)
                self._follow_leap(leaps, there)
        if there is not here:
            self._choice.follow(leaps.changes)
            self._passage.look_at(there.t, there.y)
            self._passage.forget(there.t)
        return there

    def _follow_leap(self, leaps: Leaps, there: Reached) -> None:
        """What happened in a leap, and why it ended."""
        assert isinstance(self._happenings, CompiledHappenings)
        result = self._happenings.result(leaps.status)
        if result.failed is not None or result.stop is not None:
            self._settle(there.t, result)
        if leaps.status == Status.VIOLATED:
            self._check(there.t, there.y)
