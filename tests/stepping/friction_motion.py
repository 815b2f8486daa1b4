"""A motion with contacts and dry friction, mode by mode. Modes are found by trying all of them, at the level of rates, then of
accelerations; while one holds, the motion is integrated by SciPy. Nothing of it comes from the runtime.

Restitution is Poisson's: compression to rest, then e times its normal impulses, with Coulomb's friction in both. The largest force
at rest may be above that of sliding.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq, minimize_scalar
from stepping.events import Happening
from stepping.friction_modes import (
    CLOSED,
    MINUS,
    OFF,
    OPEN,
    PLUS,
    STICK,
    AmbiguousError,
    Floats,
    Friction,
    Solution,
    reserve,
    solutions,
)
from stepping.friction_rows import FrictionSystem, Mode, Rows
from stepping.state import State

from lagdsl.program.program import Program

_LOOKS = 8  # at each step
_STEPS = 60  # at least, of a run
_RTOL, _ATOL = 1e-12, 1e-14
# Of the largest terms so far: gaps, rates, forces below it are none.
_GAP, _RATE, _FORCE = 1e-12, 1e-10, 1e-10
_BLOWS, _PASSES = 500, 60
# Of the run: bounces that are over within it are rest.
_REST = 1e-6
# Determinant of the equations of a mode, against that without friction: below it sliding has no unique force.
_JAMMED = 1e-7


class JammedError(AssertionError):
    """No motion goes on: friction presses a contact as much as the contact makes friction."""

    def __init__(self, time: float) -> None:
        super().__init__(f"jammed at t = {time:.9g}")
        self.time = time


@dataclass
class FrictionMotion:
    """States at the requested times, those before an event, the forces of all rows there, and what happened."""

    times: list[float] = field(default_factory=list)
    states: list[State] = field(default_factory=list)
    forces: list[Floats] = field(default_factory=list)
    told: list[Happening] = field(default_factory=list)


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
        self._places, self._speeds = np.abs(system.start.q), np.abs(system.start.v)
        self._shortest = False

    def run(self) -> FrictionMotion:
        s = self._system.start
        s, mode = self._instant(s, None, ())
        self._motion.told.clear()
        again = 0
        while s.t < self._stop:
            begin = s.t
            s, mode = self._mode(s, mode)
            again = again + 1 if s.t - begin <= 1e-13 * self._stop else 0
            if again > _PASSES:
                raise AmbiguousError(f"no mode holds at t = {s.t:.9g}")
        return self._motion

    # ---- one mode ----------------------------------------------------------------------------------------------------

    def _mode(self, s: State, mode: Mode) -> tuple[State, Mode]:
        end = self._system.system.next_timed(s, self._stop)
        armed = {each.row: each.value > each.band for each in self._guards(s, mode)}
        solver = self._solver(s, mode, end)
        while solver.status == "running":
            before = s.moved(solver.t, solver.y.copy())
            message = solver.step()
            if solver.status != "running" and solver.status != "finished":
                raise JammedError(solver.t) if self._jams(before, mode) else AssertionError(message)
            dense = solver.dense_output()
            self._grow(s.moved(solver.t, solver.y))
            at, row = self._first(before, dense, solver.t, mode, armed)
            self._note(s, dense, before.t, solver.t if at is None else at, mode)
            if at is not None:
                after = self._exactly(before, at, row, mode)
                if row == -2:
                    raise JammedError(after.t)
                return self._instant(self._clean(after, mode), mode, self._fired(after, mode, row))
        s = self._clean(s.moved(end, solver.y), mode)
        return (s, mode) if end >= self._stop else self._instant(self._system.timed(s), mode, ())

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
                    (rows.speed[row], self._slow(rows, row))
                    if system.one_way[k]
                    else (rows.gap[k], self._near(rows, row))
                )
                guards.append(_Guard(row, float(value), band))
            elif not redundant:
                guards.append(_Guard(row, float(f[row]), _FORCE * strongest))
        for each in rows.frictions:
            if mode[each.row] == STICK and not redundant:
                guards.append(_Guard(each.row, _left(each, f), _FORCE * strongest))
            elif mode[each.row] in (PLUS, MINUS):
                sign = 1.0 if mode[each.row] == PLUS else -1.0
                guards.append(_Guard(each.row, float(sign * rows.speed[each.row]), self._slow(rows, each.row)))
        if redundant:
            guards.append(_Guard(-1, self._reserve(rows, mode)[0], _FORCE * strongest))
        guards.append(_Guard(-2, determinant - _JAMMED, 0.0))
        return guards

    def _reserve(self, rows: Rows, mode: Mode) -> tuple[float, Floats]:
        """The largest least reserve, and forces of all rows that have it."""
        order = self._system.held(mode) + [row for row, code in mode.items() if code in (PLUS, MINUS)]
        frictions = [each for each in rows.frictions if each.row in order]
        c = rows.J @ rows.inverse @ rows.h - rows.gamma
        value, found = reserve(rows.of(order, c, frictions), tuple(mode.get(row, CLOSED) for row in order))
        f = np.zeros(len(rows.gamma))
        f[order] = found
        return value, f

    def _fired(self, s: State, mode: Mode, row: int) -> tuple[int, ...]:
        """Rows that left the mode; of redundant ones all without reserve."""
        if row >= 0:
            return (row,)
        rows = self._system.rows(s)
        value, f = self._reserve(rows, mode)
        limit = value + 1e-7 * float(np.max(np.abs(f)))
        left = [each.row for each in rows.frictions if mode[each.row] == STICK and _left(each, f) <= limit]
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

    def _grow(self, s: State) -> None:
        self._places, self._speeds = np.maximum(self._places, np.abs(s.q)), np.maximum(self._speeds, np.abs(s.v))

    def _near(self, rows: Rows, row: int) -> float:
        terms = np.abs(rows.J[row])
        return _GAP * float(terms @ np.maximum(self._places, self._speeds * self._stop * 1e-3)) + 1e-300

    def _slow(self, rows: Rows, row: int) -> float:
        """Rates of the row below it are none: against its largest terms so far, and what its forces make in a moment."""
        moment = np.abs(rows.inverse) @ (np.abs(rows.h) + 1e-300) * 1e-4 * self._stop
        return _RATE * (float(np.abs(rows.J[row]) @ np.maximum(self._speeds, moment)) + 1e-300)

    # ---- one instant -------------------------------------------------------------------------------------------------

    def _instant(self, s: State, mode: Mode | None, fired: Sequence[int]) -> tuple[State, Mode]:
        system = self._system
        rows = system.rows(s)
        f = self._before(rows, mode, fired)
        opened = {row for row in fired if mode is not None and row in system.contacts and mode[row] == CLOSED}
        touching = [
            row
            for k, row in enumerate(system.contacts)
            if system.one_way[k]
            or row in fired
            or (mode is not None and mode[row] == CLOSED)
            or rows.gap[k] <= 10 * self._near(rows, row)
        ]
        force = float(np.max(np.abs(f), initial=0.0))
        carrying = [
            row for row in touching if mode and mode[row] == CLOSED and row not in opened and f[row] > 1e-9 * force
        ]
        s, approach = self._struck(s, rows, touching, carrying)
        struck = bool(approach)
        s = self._at_rest(s, rows, touching, max(approach.values(), default=0.0))
        new = self._decided(s, touching, opened, self._directions(mode, fired, f) if not struck else {})
        held = system.held(new)
        rows = system.rows(s)
        s = replace(s, v=system.projected(rows, held, s.v, rows.speed))
        self._tell(s.t, mode, new, approach)
        return s, new

    def _before(self, rows: Rows, mode: Mode | None, fired: Sequence[int]) -> Floats:
        """Forces in the mode that ends."""
        if mode is None:
            return np.zeros(len(rows.gamma))
        f, redundant, _ = self._system.forces(rows, mode)
        return self._reserve(rows, mode)[1] if redundant and fired else f

    @staticmethod
    def _directions(mode: Mode | None, fired: Sequence[int], f: Floats) -> dict[int, int]:
        """What stuck and has no reserve slips against its force."""
        if mode is None:
            return {}
        return {row: MINUS if f[row] > 0 else PLUS for row in fired if mode[row] == STICK}

    def _struck(self, s: State, rows: Rows, touching: list[int], carrying: list[int]) -> tuple[State, dict[int, float]]:
        """Blows until no gap closes any more: the state, and how fast what struck approached."""
        approach: dict[int, float] = {}
        v, first = s.v, rows.speed
        for _ in range(_BLOWS):
            self._grow(replace(s, v=v))
            speed = first + rows.J @ (v - s.v)
            slow = {row: self._slow(rows, row) for row in touching}
            hits = [row for row in touching if row not in carrying and speed[row] < -slow[row]]
            if not hits and not any(speed[row] < -slow[row] for row in carrying):
                return replace(s, v=v), approach
            for row in hits:
                approach.setdefault(row, -float(speed[row]))
            v = v + self._blow(rows, speed, hits, carrying)
        raise AssertionError("blows without end")

    def _blow(self, rows: Rows, speed: Floats, hits: list[int], carrying: list[int]) -> Floats:
        """The jump of rates. Where restitutions differ and energy would grow, the least is that of all."""
        e = {row: float(rows.restitution[self._system.contacts.index(row)]) for row in hits} | dict.fromkeys(
            carrying, 0.0
        )
        jump, gain = self._poisson(rows, speed, e)
        if gain > 0 and len(set(e.values())) > 1:
            jump, _ = self._poisson(rows, speed, dict.fromkeys(e, min(e.values())))
        return jump

    def _poisson(self, rows: Rows, speed: Floats, e: dict[int, float]) -> tuple[Floats, float]:
        """The jump of rates, and the energy gained beyond rounding."""
        laws = [
            Friction(each.row, each.contact, each.mu) for each in rows.frictions if each.contact in e and each.mu > 0
        ]
        order = self._system.bilateral + [*e, *(each.row for each in laws)]
        problem = rows.of(order, speed, laws)
        compressed = _only(solutions(problem))
        impulse = compressed.f.copy()
        back = np.array([e.get(row, 0.0) for row in order]) * impulse
        if np.any(back > 0):
            place = {row: at for at, row in enumerate(order)}
            known = tuple(replace(each, r0=each.mu * float(back[each.contact])) for each in problem.frictions)  # type: ignore[index]
            again = replace(problem, c=problem.c + problem.G @ (impulse + back), frictions=known)
            assert len(place) == len(order)
            impulse = impulse + back + _only(solutions(again)).f
        after = problem.c + problem.G @ impulse
        gain = float((after + problem.c) @ impulse / 2)
        size = float(np.abs(problem.c) @ np.abs(impulse))
        return rows.inverse @ rows.J[order].T @ impulse, gain if gain > 1e-10 * size else 0.0

    def _at_rest(self, s: State, rows: Rows, touching: list[int], approach: float) -> State:
        """The state without the rest of a series of bounces that is over in short: flights of 2 u/a, each shorter by the same
        factor."""
        system = self._system
        speed = system.rows(s).speed
        parting = [row for row in touching if speed[row] > self._slow(rows, row)]
        ratio = max((speed[row] for row in parting), default=0.0) / approach if approach > 0 else 1.0
        if not parting or ratio >= 1 - 1e-9:
            return s
        resting = [row for row in touching if row not in parting]
        mode = self._decided(s, resting, set(), {})
        now = system.rows(s)
        a = system.accelerations(now, system.forces(now, mode)[0])
        for row in parting:
            pull = -float(now.J[row] @ a - now.gamma[row])
            if pull <= 0 or 2 * speed[row] / pull >= _REST * self._stop * (1 - ratio):
                return s
        slips = [
            each.row
            for each in rows.frictions
            if each.contact in touching and abs(speed[each.row]) <= self._slow(rows, each.row)
        ]
        return replace(s, v=system.projected(now, system.bilateral + touching + slips, s.v, speed))

    def _decided(self, s: State, touching: list[int], opened: set[int], left: dict[int, int]) -> Mode:
        """The mode of the accelerations. What slips at the limit of rest slips with that of sliding: again with it."""
        system = self._system
        rows = system.rows(s)
        speed = rows.speed
        near = [row for row in touching if row not in opened and abs(speed[row]) <= self._slow(rows, row)]
        laws = [each for each in rows.frictions if each.contact is None or each.contact in near]
        moving = {
            each.row: PLUS if speed[each.row] > 0 else MINUS
            for each in laws
            if abs(speed[each.row]) > self._slow(rows, each.row)
        }
        given = left | moving
        order = system.bilateral + near + [each.row for each in laws]
        place = {row: at for at, row in enumerate(order)}
        problem = rows.of(order, rows.J @ rows.inverse @ rows.h - rows.gamma, laws)
        kinetic = {place[row] for row in given if row in place}
        while True:
            fixed = {place[row]: code for row, code in given.items() if row in place}
            found = _only(solutions(problem, kinetic, fixed), s.t)
            above = {each.row for each in problem.frictions if each.law(True) != each.law(False)}
            more = {at for at in above if found.mode[at] in (PLUS, MINUS)} - kinetic
            if not more:
                break
            kinetic |= more
        mode = dict.fromkeys(system.contacts, OPEN) | dict.fromkeys(system.frictions, OFF)
        return mode | {row: found.mode[place[row]] for row in order if row in mode}

    def _tell(self, t: float, was: Mode | None, now: Mode, approach: dict[int, float]) -> None:
        names, told = self._system.names, self._motion.told
        told.extend(Happening(t, names[row], "impact") for row in approach)
        for row in self._system.contacts:
            if was is not None and was[row] != now[row]:
                told.append(Happening(t, names[row], "closed" if now[row] == CLOSED else "opened"))
        for row in self._system.frictions:
            before, after = was[row] if was is not None else OFF, now[row]
            if after == STICK != before:
                told.append(Happening(t, names[row], "sticks"))
            elif after in (PLUS, MINUS) and before in (STICK, OFF):
                told.append(Happening(t, names[row], "slips"))
            elif after in (PLUS, MINUS) and before != after:
                told.append(Happening(t, names[row], "reverses"))


def _left(each: Friction, f: Floats) -> float:
    """The reserve of a friction that sticks."""
    mu, r0 = each.law(at_rest=True)
    return float(r0 + (mu * f[each.contact] if each.contact is not None else 0.0) - abs(f[each.row]))


def _only(found: list[Solution], t: float = 0.0) -> Solution:
    if len(found) != 1:
        raise AmbiguousError(f"{len(found)} solutions at t = {t:.9g}")
    return found[0]
