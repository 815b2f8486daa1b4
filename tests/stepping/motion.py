"""A motion with events, mode by mode, by SciPy: an independent formulation of what the runtime does.

Functions of the program mean what the graph says; everything else - integration, location, clauses, impacts, contacts -
is here, and nothing of it comes from `lagdsl.motion.simulate` or `lagdsl.engines.runtime`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq, minimize_scalar
from stepping.balance import Balance, Floats
from stepping.events import Happening, Instant, Memory, balanced
from stepping.state import State, System

from lagdsl.derivation.program.program import Program

_LOOKS = 8  # at each step
_STEPS = 100  # at least, of a run
_RTOL = 1e-12
_LEAST = 1e-16  # what counts of a state that begins at zero


@dataclass
class Motion:
    """States at the requested times (those before an event at the same time) and what happened."""

    times: list[float] = field(default_factory=list)
    states: list[State] = field(default_factory=list)
    told: list[Happening] = field(default_factory=list)
    instants: list[float] = field(default_factory=list)


def motion(
    program: Program, stop: float, times: Sequence[float], known: Sequence[float] = (), least: float = 1.0
) -> Motion:
    """`known` are instants at which something may happen: the integration begins anew there. `least` is
    the smallest scale of what moves."""
    return _Run(System(program, stop), sorted(times), sorted(known), least).run()


class _Run:
    def __init__(self, system: System, times: Sequence[float], known: Sequence[float], least: float) -> None:
        self._least = least * _LEAST
        self._system, self._times, self._known = system, times, known
        self._memory = Memory(np.abs(system.start.v), np.abs(system.start.q))
        self._instant = Instant(system, self._memory)
        self._motion = Motion()
        self._deeper: dict[int, float] = {}  # factors of floors that led to nothing

    def run(self) -> Motion:
        system = self._system
        s = system.start
        b = system.functions.standing(system.point(s))
        s = self._projected(s, b)
        w, b = system.standing(s, b)
        s = self._instant.settled(replace(s, w=w), b)
        s, b = self._at_start(s, b)
        while s.t < system.length and not self._memory.ended:
            s, b = self._mode(s, b)
        self._motion.told = sorted(self._memory.told, key=lambda each: each.time)
        return self._motion

    def _at_start(self, s: State, b: list[float]) -> tuple[State, list[float]]:
        names = [slot.name for slot in self._system.layout.discretes]
        w = s.w.copy()
        if any(kind == "condition" for kind in self._system.layout.kinds):
            # what is true already does not become true
            found = self._system.call("event", s, None, self._system.solved(s, b))["w"]
            conditions = self._system.kind["condition"]
            w[conditions] = found[conditions]
        flags = self._ticking(0.0) + [i for i, name in enumerate(names) if name == "initial()"]
        return self._instant.run(replace(s, w=w), b, flags)

    def _ticking_at(self, t: float) -> list[int]:
        """Clocks that tick at a time."""
        ticks = zip(self._system.ticking.get("start", ()), self._system.ticking.get("period", ()), strict=True)
        near = 1e-12 * max(1.0, t)
        return [
            clock
            for clock, (start, period) in zip(self._system.clocks, ticks, strict=True)
            if abs(t - self._tick(start, period, t)) <= near
        ]

    def _ticking(self, t: float) -> list[int]:
        found = self._ticking_at(t)
        told = (Happening(t, self._system.layout.discretes[clock].name, "tick") for clock in found)
        self._memory.told.extend(told)
        return found

    @staticmethod
    def _tick(start: float, period: float, t: float) -> float:
        return float(start + max(0, round((t - start) / period)) * period)

    def _next_known(self, t: float) -> float:
        """The next instant that is known beforehand."""
        later = [self._system.length, *(k for k in self._known if k > t * (1 + 1e-12))]
        for i, _ in enumerate(self._system.clocks):
            start, period = self._system.ticking["start"][i], self._system.ticking["period"][i]
            k = max(0, int(np.floor((t - start) / period)) - 1)
            later.append(next(start + j * period for j in range(k, k + 5) if start + j * period > t + 1e-11))
        end = min(later)
        return end if end < self._system.length * (1 - 1e-12) else self._system.length

    # ---- one mode ----------------------------------------------------------------------------------------------------

    def _mode(self, s: State, b: list[float]) -> tuple[State, list[float]]:
        """Integrates until something changes, and carries that out."""
        end = self._system.next_timed(s, self._next_known(s.t))
        armed = self._system.valid(self._system.later(s, b, 1e-9), b) > 0
        floor = self._floor(s, b, len(armed))
        solver = self._solver(s, b, end)
        while solver.status == "running":
            before = s.moved(solver.t, solver.y.copy())
            message = solver.step()
            assert solver.status != "failed", message
            dense = solver.dense_output()
            at = self._first(before, dense, solver.t, b, armed, floor)
            self._note(s, dense, before.t, solver.t if at is None else at)
            if at is not None:
                s = self._exactly(before, at, b)
                after, b = self._event(s, b)
                same = np.array_equal(after.x, s.x) and np.array_equal(after.w, s.w)
                self._deeper = {self._which: 4 * self._deeper.get(self._which, 1.0)} if same else {}
                return after, b
        s = self._projected(s.moved(end, solver.y), b)
        if end >= self._system.length and not self._ticking_at(end):
            return s, b
        return self._event(s, b)

    def _solver(self, s: State, b: list[float], end: float) -> DOP853:
        x = s.x
        rates = np.abs(self._system.rates(s, b)) * self._system.length
        return DOP853(
            lambda t, y: self._system.rates(s.moved(t, y), b),
            s.t,
            x,
            end,
            rtol=_RTOL,
            atol=1e-13 * np.maximum(np.abs(x), np.minimum(rates, 1.0)) + self._least,
            max_step=self._system.length / _STEPS,
        )

    def _floor(self, s: State, b: list[float], count: int) -> Floats:
        """So far open contacts are let in that never were seen apart, by round-off, and farther where that led to
        nothing: a rate that is round-off goes on. All else, without end."""
        system, floor = self._system, np.full(count, -np.inf)
        if system.contacts:
            first, closed = len(system.relations), s.w[system.contacts] > 0
            floor[first : first + len(closed)] = np.where(closed, -np.inf, -self._instant.noise(s, b))
        for k, factor in self._deeper.items():
            floor[k] *= factor
        return floor

    def _first(
        self, before: State, dense: object, end: float, b: list[float], armed: Floats, floor: Floats
    ) -> float | None:
        """When the first of what must stay positive is so no more; what began on its border is looked at once it left
        it, or where it goes below its floor."""
        system = self._system
        times = np.linspace(before.t, end, _LOOKS + 1)

        def valid(t: float) -> Floats:
            return system.valid(before.moved(t, dense(t)), b)  # type: ignore[operator]

        looks = np.array([valid(t) for t in times])
        found = [
            (at, k)
            for k in range(looks.shape[1])
            if (at := self._border(valid, times, looks[:, k], k, armed, floor[k])) is not None
        ]
        if not found:
            return None
        at, self._which = min(found)
        return at

    @staticmethod
    def _border(
        valid: Callable[[float], Floats], times: Floats, looks: Floats, k: int, armed: Floats, floor: float
    ) -> float | None:
        """When entry k becomes negative, which it does between looks, too: where it has a minimum, and where it left
        its border, by more than round-off, and came back."""
        noise = -floor if np.isfinite(floor) else 0.0

        def value(t: float) -> float:
            return float(valid(t)[k])

        for i in range(len(times) - 1):
            armed[k] |= looks[i] > 0
            low, high = float(times[i]), float(times[i + 1])
            if looks[i + 1] < 0 and (armed[k] or looks[i + 1] < floor):
                inside = (low + (high - low) / 2**m for m in range(1, 30))
                above = low if looks[i] > noise else next((t for t in inside if value(t) > noise), None)
                if above is not None:
                    return float(brentq(value, above, high, xtol=1e-15))
                if looks[i] > floor > looks[i + 1]:
                    return float(brentq(lambda t: value(t) - floor, low, high, xtol=1e-15))
                return low
            if i > 0 and 0 < looks[i] < min(looks[i - 1], looks[i + 1]):
                low = float(times[i - 1])
                dip = minimize_scalar(value, bounds=(low, high), method="bounded")
                if dip.fun < 0 and armed[k]:
                    return float(brentq(value, low, dip.x, xtol=1e-15)) if value(low) > 0 else low
        return None

    def _exactly(self, before: State, at: float, b: list[float]) -> State:
        """The state at the crossing: integrated to it, and the crossing corrected by that, as dense output is less
        exact than steps are."""
        system, k = self._system, self._which
        s = self._integrated(before, at, b)
        for _ in range(2):
            step = 1e-7 * system.length
            now = float(system.valid(s, b)[k])
            then = float(system.valid(self._integrated(s, s.t + step, b), b)[k])
            shift = -now * step / (then - now) if then != now else 0.0
            far = abs(shift) > 1e-6 * system.length or s.t + shift < before.t
            if far or abs(shift) < 1e-15 * system.length:
                break
            s = self._integrated(s, min(s.t + shift, system.length), b)
        return self._projected(s, b)

    def _integrated(self, s: State, end: float, b: list[float]) -> State:
        if end == s.t:
            return s
        solver = self._solver(s, b, end)
        while solver.status == "running":
            solver.step()
        return s.moved(end, solver.y)

    def _event(self, s: State, b: list[float]) -> tuple[State, list[float]]:
        system = self._system
        self._motion.instants.append(s.t)
        w, after = system.standing(s, b)
        changed = replace(s, w=w)
        if after != b or not np.array_equal(w, s.w):
            changed = balanced(system, s, b, changed, after)
        changed = self._instant._opened(changed, after)
        return self._instant.run(changed, after, self._ticking(s.t))

    def _projected(self, s: State, b: list[float]) -> State:
        """Onto the constraints, in the metric of M."""
        system = self._system
        if not system.layout.constraints:
            return s
        for _ in range(4):
            mass = system.call("dynamics", s, b)["M"]
            found = system.call("position_constraint", s, b)
            s = replace(s, q=s.q + Balance(mass, found["J"]).solve(np.zeros(len(s.q)), -found["phi"])[0])
        rates = system.call("velocity_constraint", s, b)
        return replace(s, v=s.v + Balance(mass, rates["J"]).solve(np.zeros(len(s.q)), -rates["residual"])[0])

    def _note(self, s: State, dense: object, begin: float, end: float) -> None:
        """Rows of a step."""
        while len(self._motion.times) < len(self._times) and self._times[len(self._motion.times)] <= end:
            t = self._times[len(self._motion.times)]
            self._motion.times.append(t)
            self._motion.states.append(s.moved(t, dense(max(t, begin))))  # type: ignore[operator]
