"""A motion with contacts and dry friction, mode by mode. Modes are found by trying all of them, at the level of
rates, then of accelerations; while one holds, the motion is integrated by SciPy. Nothing of it comes from the
runtime.

Restitution is Poisson's: compression to rest, then e times its normal impulses, with Coulomb's friction in both.
The largest force at rest may be above that of sliding.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq, minimize_scalar
from stepping.friction_instant import FrictionInstant, JammedError, left_to
from stepping.friction_modes import CLOSED, MINUS, OPEN, PLUS, STICK, AmbiguousError, Floats
from stepping.friction_rows import FrictionSystem, Mode
from stepping.motion import Motion
from stepping.state import State

from lagdsl.derivation.program.program import Program

_LOOKS = 8  # at each step
_STEPS = 20  # at least, of a run
_RTOL, _ATOL = 1e-12, 1e-14
# Of the largest forces: those below it are none.
_FORCE = 1e-10
_PASSES = 60
# Determinant of the equations of a mode, against that without friction: below it sliding has no unique force.
_JAMMED = 1e-7


@dataclass
class FrictionMotion(Motion):
    """With the forces of all rows at the requested times."""

    forces: list[Floats] = field(default_factory=list)


def friction_motion(program: Program, stop: float, times: Sequence[float]) -> FrictionMotion:
    """Errors: `AmbiguousError` where not exactly one motion goes on, `JammedError`."""
    return _Run(FrictionSystem(program, stop), stop, sorted(times)).run()


@dataclass(frozen=True)
class _Guard:
    """Positive while the mode holds; below `band` it is zero."""

    row: int  # -1: the reserve of redundant rows, -2: the determinant
    value: float
    band: float


class _Run:
    def __init__(self, system: FrictionSystem, stop: float, times: Sequence[float]) -> None:
        self._system, self._stop, self._times = system, stop, times
        self._motion = FrictionMotion()
        self._instant = FrictionInstant(system, stop)

    def run(self) -> FrictionMotion:
        s = self._system.start
        s, mode = self._instant.run(s, None, ())
        self._instant.told.clear()
        again = 0
        while s.t < self._stop:
            begin = s.t
            s, mode = self._mode(s, mode)
            again = again + 1 if s.t - begin <= 1e-13 * self._stop else 0
            if again > _PASSES:
                raise AmbiguousError(f"no mode holds at t = {s.t:.9g}")
        self._motion.told = sorted(self._instant.told, key=lambda each: each.time)
        return self._motion

    # ---- one mode ----------------------------------------------------------------------------------------------------

    def _mode(self, s: State, mode: Mode) -> tuple[State, Mode]:
        end = self._system.system.next_timed(s, self._stop)
        armed = {each.row: each.value > each.band for each in self._guards(s, mode)}
        solver = self._solver(s, mode, end)
        while solver.status == "running":
            before = s.moved(solver.t, solver.y.copy())
            message = solver.step()
            if solver.status == "failed":
                raise JammedError(solver.t) if self._jams(before, mode) else AssertionError(message)
            dense = solver.dense_output()
            self._instant.grow(s.moved(solver.t, solver.y))
            at, row = self._first(before, dense, solver.t, mode, armed)
            self._note(s, dense, before.t, solver.t if at is None else at, mode)
            if at is not None:
                after = self._exactly(before, at, row, mode)
                self._motion.instants.append(after.t)
                if row == -2:
                    raise JammedError(after.t)
                return self._instant.run(self._clean(after, mode), mode, self._fired(after, mode, row))
        s = self._clean(s.moved(end, solver.y), mode)
        return (s, mode) if end >= self._stop else self._instant.run(self._system.timed(s), mode, ())

    def _jams(self, s: State, mode: Mode) -> bool:
        return self._system.forces(self._system.rows(s), mode)[2] < 0.1

    def _solver(self, s: State, mode: Mode, end: float) -> DOP853:
        system = self._system

        def rates(t: float, x: Floats) -> Floats:
            at = s.moved(t, x)
            rows = system.rows(at)
            a = system.accelerations(rows, system.forces(rows, mode)[0])
            return np.concatenate((system.projected(rows, system.held(mode), at.v, rows.speed), a))

        return DOP853(rates, s.t, s.x, end, rtol=_RTOL, atol=_ATOL, max_step=self._stop / _STEPS)

    def _guards(self, s: State, mode: Mode) -> list[_Guard]:
        system = self._system
        rows = system.rows(s)
        f, redundant, determinant = system.forces(rows, mode)
        strongest = float(np.max(np.abs(f), initial=0.0)) + float(np.max(np.abs(rows.h), initial=0.0)) * 1e-3
        guards = []
        for k, row in enumerate(system.contacts):
            if mode[row] == OPEN:
                value, band = (
                    (rows.speed[row], self._instant.slow(rows, row))
                    if system.one_way[k]
                    else (rows.gap[k], self._instant.near(rows, row))
                )
                guards.append(_Guard(row, float(value), band))
            elif not redundant:
                guards.append(_Guard(row, float(f[row]), _FORCE * strongest))
        for each in rows.frictions:
            if mode[each.row] == STICK and not redundant:
                guards.append(_Guard(each.row, left_to(each, f), _FORCE * strongest))
            elif mode[each.row] in (PLUS, MINUS):
                sign = 1.0 if mode[each.row] == PLUS else -1.0
                guards.append(_Guard(each.row, float(sign * rows.speed[each.row]), self._instant.slow(rows, each.row)))
        if redundant:
            guards.append(_Guard(-1, self._instant.reserve(rows, mode)[0], _FORCE * strongest))
        guards.append(_Guard(-2, determinant - _JAMMED, 0.0))
        return guards

    def _fired(self, s: State, mode: Mode, row: int) -> tuple[int, ...]:
        """Rows that left the mode; of redundant ones all without reserve."""
        if row >= 0:
            return (row,)
        rows = self._system.rows(s)
        value, f = self._instant.reserve(rows, mode)
        limit = value + 1e-7 * float(np.max(np.abs(f)))
        left = [each.row for each in rows.frictions if mode[each.row] == STICK and left_to(each, f) <= limit]
        return (*left, *(row for row in self._system.contacts if mode[row] == CLOSED and f[row] <= limit))

    def _first(
        self, before: State, dense: object, end: float, mode: Mode, armed: dict[int, bool]
    ) -> tuple[float | None, int]:
        """When the first guard leaves: an armed one at zero, another one below its band."""
        times = np.linspace(before.t, end, _LOOKS + 1)

        def guards(t: float) -> list[_Guard]:
            return self._guards(before.moved(t, dense(t)), mode)  # type: ignore[operator]

        looks = [guards(t) for t in times]
        found: list[tuple[float, int]] = []
        for k, first in enumerate(looks[0]):
            values = np.array([look[k].value for look in looks])
            at = self._leaves(lambda t, k=k: guards(t)[k].value, times, values, looks[-1][k].band, armed, first.row)
            if at is not None:
                found.append((at, first.row))
        return min(found) if found else (None, 0)

    @staticmethod
    def _leaves(
        value: Callable[[float], float], times: Floats, values: Floats, band: float, armed: dict[int, bool], row: int
    ) -> float | None:
        for i in range(len(times) - 1):
            low, high = float(times[i]), float(times[i + 1])
            armed[row] |= bool(values[i] > band)
            if values[i + 1] < -band or (armed[row] and values[i + 1] < 0 < values[i]):
                if not armed[row]:  # up and back between two looks, or down at once
                    top = minimize_scalar(
                        lambda t: -value(t), bounds=(low, high), method="bounded", options={"xatol": 1e-13}
                    )
                    if -top.fun <= band:
                        return low
                    low = float(top.x)
                return float(brentq(value, low, high, xtol=1e-15)) if value(low) > 0 else low
            if i > 0 and armed[row] and 0 < values[i] < min(values[i - 1], values[i + 1]):
                low = float(times[i - 1])
                dip = minimize_scalar(value, bounds=(low, high), method="bounded")
                if dip.fun < -band:
                    return float(brentq(value, low, dip.x, xtol=1e-15))
        return None

    def _exactly(self, before: State, at: float, row: int, mode: Mode) -> State:
        """The state at the crossing: integrated to it, the crossing corrected by that."""

        def value(s: State) -> float:
            return next(each.value for each in self._guards(s, mode) if each.row == row)

        s = self._integrated(before, at, mode)
        for _ in range(2):
            step = 1e-7 * self._stop
            now, then = value(s), value(self._integrated(s, s.t + step, mode))
            shift = -now * step / (then - now) if then != now else 0.0
            if abs(shift) > 1e-7 * self._stop or s.t + shift < before.t:
                break
            s = self._integrated(s, s.t + shift, mode)
        return s

    def _integrated(self, s: State, end: float, mode: Mode) -> State:
        if end == s.t:
            return s
        solver = self._solver(s, mode, end)
        while solver.status == "running":
            solver.step()
        return s.moved(end, solver.y)

    def _note(self, s: State, dense: object, begin: float, end: float, mode: Mode) -> None:
        found = self._motion
        while len(found.times) < len(self._times) and self._times[len(found.times)] <= end:
            t = self._times[len(found.times)]
            at = s.moved(t, dense(max(t, begin)))  # type: ignore[operator]
            found.times.append(t)
            found.states.append(at)
            found.forces.append(self._system.forces(self._system.rows(at), mode)[0])

    def _clean(self, s: State, mode: Mode) -> State:
        """Gaps and rates of held rows are zero."""
        system = self._system
        held = system.held(mode)
        for _ in range(3):
            at = system.system.call("position_constraint", s, None)
            places = [row for row in held if np.any(at["J"][row])]
            if places:
                J, inverse = at["J"][places], system.rows(s).inverse
                s = replace(
                    s, q=s.q - inverse @ J.T @ np.linalg.lstsq(J @ inverse @ J.T, at["phi"][places], rcond=1e-11)[0]
                )
        rows = system.rows(s)
        return replace(s, v=system.projected(rows, held, s.v, rows.speed))
