"""The sampled loop over one period: states and signals together, just before the first tick of a period.

Between ticks the flow is the exponential of its matrix, exactly; a tick is the derivative of its passes over the
clauses. Both are taken at one point, which is a fixed point of the loop where the result is to mean something.
Sources: Åström and Wittenmark, Computer-Controlled Systems, 3rd ed. (1997), chapter 2 (sampling); Bittanti and
Colaneri, Periodic Systems (2009), chapter 3 (several clocks: the matrix of the period).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.border import on_both_sides
from lagdsl.motion.analysis.linearize import Named, Reduced, holonomic_rows, reduce, state_names
from lagdsl.motion.analysis.point import Directions, Point, System
from lagdsl.motion.analysis.sampled.held_flow import HeldFlow, held_flow
from lagdsl.motion.analysis.sampled.instant import Deviations, tick
from lagdsl.motion.analysis.sampled.moved import Borders
from lagdsl.motion.analysis.sampled.schedule import Schedule
from lagdsl.motion.analysis.sampled.signals import Signals, integers, signals_of
from lagdsl.motion.analysis.turning import in_chart

# Periods after which truths and counters have to be as they were.
_MOST_PERIODS = 64


@dataclass(frozen=True, slots=True, kw_only=True)
class Loop:
    """xi' = `matrix` (xi, u, 1), y = `outputs` (xi, u, 1) over `period` [s], of the deviations xi = (x, w) of minimal
    state and signals from `point`: the last column is what the loop does there by itself. `still` are the rates of x
    there, `w` the discretes at the end of the period; `switching` are names of what acts and does not return."""

    point: Point
    at: Reduced
    signals: Signals
    names: tuple[Named, ...]
    schedule: Schedule
    period: float
    matrix: Floats
    outputs: Floats
    still: Floats
    w: Floats
    switching: tuple[str, ...]


def loop_at(
    system: System, point: Point, schedule: Schedule, sink: Sink, *, with_outputs: bool, leaks: bool = False
) -> Loop | None:
    """About `point`; `leaks`: limits move with what they limit, and borders are no errors. None after E0850, E0851,
    E0855, E0860, E0865 or E0866."""
    moving: list[int] = []
    while True:
        signals = signals_of(system, moving, with_outputs=with_outputs)
        composing = _Composing(system=system, point=point, signals=signals, schedule=schedule, sink=sink, leaks=leaks)
        found = composing.run()
        if found is None:
            return None
        more = [place for place in integers(system) if place not in moving and np.any(composing.seen[place])]
        if not more:
            return found
        moving += more


class _Composing:
    """Products over the ticks of a period, or of several: until truths are as they were."""

    def __init__(
        self,
        *,
        system: System,
        point: Point,
        signals: Signals,
        schedule: Schedule,
        sink: Sink,
        leaks: bool,
    ) -> None:
        self._system, self._point, self._signals = system, point, signals
        self._schedule, self._sink, self._leaks = schedule, sink, leaks
        self._chart: Reduced | None = None
        self._flows: dict[bytes, HeldFlow] = {}
        self._exponentials: dict[tuple[int, float], Floats] = {}
        self.seen = np.zeros(len(point.w))

    def run(self) -> Loop | None:
        first = self._flow(self._point.w)
        if first is None:
            return None
        states, count = len(first.at.value), len(self._signals)
        inputs = len(self._point.u)
        width = states + count + inputs + 1
        now, w = np.eye(width), self._point.w
        modes = list(self._signals.modes)
        outputs = np.zeros((len(first.at.flow.y), width))
        for period in range(_MOST_PERIODS):
            ticks = zip(self._schedule.instants, self._schedule.gaps, strict=True)
            for place, ((_, clocks), gap) in enumerate(ticks):
                found = self._instant(now, w, clocks) if clocks else (now, w)
                if found is None:
                    return None
                now, w = found
                here = self._flow(w)
                if here is None:
                    return None
                if place == period == 0:
                    outputs = np.hstack([here.outputs, np.zeros((len(outputs), 1))]) @ now
                now = self._exponential(here, gap) @ now
            if np.array_equal(w[modes], self._point.w[modes]):
                break
        names = [slot.name for slot in self._system.program.layout.discretes]
        return Loop(
            point=self._point,
            at=first.at,
            signals=self._signals,
            names=(*state_names(self._system, first.at.partition), *self._signals.names),
            schedule=self._schedule,
            period=(period + 1) * self._schedule.period,
            matrix=now[: states + count],
            outputs=outputs,
            still=first.at.value,
            w=w,
            switching=tuple(names[k] for k in modes if w[k] != self._point.w[k]),
        )

    def _flow(self, w: Floats) -> HeldFlow | None:
        """With these truths, and the signals of the point."""
        held = w.copy()
        held[list(self._signals.places)] = self._point.w[list(self._signals.places)]
        key = held.tobytes()
        if key not in self._flows:
            rows = holonomic_rows(self._system)
            chart = None if self._chart is None else self._chart.partition
            at = reduce(self._system, replace(self._point, w=held), rows, self._sink, chart)
            at = None if at is None else on_both_sides(self._system, at, self._sink)
            if at is None:
                return None
            self._chart = self._chart or at
            found = held_flow(self._system, at, self._signals)
            if found.borders and not self._leaks:
                _refuse(self._system, "the motion", self._sink)
                return None
            self._flows[key] = found
        return self._flows[key]

    def _exponential(self, here: HeldFlow, gap: float) -> Floats:
        """exp of the matrix of (x, w, u, 1) over the gap."""
        from scipy.linalg import expm

        key = (id(here), gap)
        if key not in self._exponentials:
            states, width = len(here.at.value), here.rates.shape[1] + 1
            matrix = np.zeros((width, width))
            matrix[:states, :-1], matrix[:states, -1] = here.rates, here.at.value
            self._exponentials[key] = np.asarray(expm(matrix * gap))
        return self._exponentials[key]

    def _instant(self, now: Floats, w: Floats, clocks: tuple[int, ...]) -> tuple[Floats, Floats] | None:
        """`now` and w behind these ticks. The signals of the point are those before; their change is a constant."""
        here = self._flow(w)
        assert here is not None
        states, places = len(here.at.value), list(self._signals.places)
        columns = now[:-1].T
        along = Directions(
            q=columns @ here.along.q, qd=columns @ here.along.qd, z=columns @ here.along.z, u=columns @ here.along.u
        )
        moves = np.zeros((len(columns), len(w)))
        moves[:, places] = columns[:, states : states + len(places)]
        before = w.copy()
        before[places] = self._point.w[places]
        point = replace(here.at.flow.point, w=before)
        moving = Deviations(point=point, along=along, w=moves, borders={}, leaks=self._leaks)
        after = tick(self._system, moving, clocks, self._sink)
        if after is None or (not self._leaks and self._meets_border(after)):
            return None
        self.seen = np.maximum(self.seen, np.max(np.abs(after.w), axis=0))
        following = now.copy()
        following[:states] = in_chart(here.at, after.along.q, after.along.qd, after.along.z).T
        following[states : states + len(places)] = after.w[:, places].T
        x, was = (in_chart(here.at, p.q[None], p.qd[None], p.z[None])[0] for p in (after.point, point))
        following[:states, -1] += x - was
        following[states : states + len(places), -1] += after.point.w[places] - before[places]
        return following, after.point.w

    def _meets_border(self, after: Deviations) -> bool:
        """True after E0865, where what acts has two sides at the point."""
        acting = {*self._signals.places, *self._signals.modes}
        names = [self._system.program.layout.discretes[k].name for k in sorted(after.borders) if k in acting]
        found: Borders = after.reset_borders
        if not names and not found:
            return False
        _refuse(self._system, f"`{names[0]}`" if names else "a clause that sets a state", self._sink)
        return True


def _refuse(system: System, what: str, sink: Sink) -> None:
    """E0865 with the functions that may turn."""
    name = what.strip("`")
    events = system.flat.events
    told = [each for each in events.sampled if name in each.variables] or list(events.sampled)
    items = [each for each in events.discretes if each.name == name]
    spans = told[0].spans if told else items[0].spans if items else ()
    functions = ", ".join(f"`{each.name}`" for each in told[:3]) or "a function"
    sink.report("E0865", spans[0] if spans else None, what=what, names=functions)
