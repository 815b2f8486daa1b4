"""An instant of a motion with contacts and dry friction: blows, the end of a series of them, and the mode that
follows.

Modes are found by trying all of them, at the level of rates, then of accelerations. Restitution is Poisson's:
compression to rest, then e times its normal impulses, with Coulomb's friction in both. The largest force at rest
may be above that of sliding.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
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

# Of the largest terms so far: gaps and rates below it are none.
_GAP, _RATE = 1e-12, 1e-10
_BLOWS = 500
# Of the run: bounces that are over within it are rest.
_REST = 1e-6


class JammedError(AssertionError):
    """No motion goes on: friction presses a contact as much as the contact makes friction."""

    def __init__(self, time: float) -> None:
        super().__init__(f"jammed at t = {time:.9g}")
        self.time = time


class FrictionInstant:
    """Carries out instants of one run; `told` is what happened."""

    def __init__(self, system: FrictionSystem, length: float) -> None:
        self._system, self._length = system, length
        self.told: list[Happening] = []
        self._places, self._speeds = np.abs(system.start.q), np.abs(system.start.v)
        self._left: dict[int, int] = {}  # rows that left their modes at this instant, and where they went
        self._since = -1.0

    def grow(self, s: State) -> None:
        self._places, self._speeds = np.maximum(self._places, np.abs(s.q)), np.maximum(self._speeds, np.abs(s.v))

    def near(self, rows: Rows, row: int) -> float:
        terms = np.abs(rows.J[row])
        return _GAP * float(terms @ np.maximum(self._places, self._speeds * self._length * 1e-3)) + 1e-300

    def slow(self, rows: Rows, row: int) -> float:
        """Rates of the row below it are none: against its largest terms so far, and what its forces make in a
        moment."""
        moment = np.abs(rows.inverse) @ (np.abs(rows.h) + 1e-300) * 1e-4 * self._length
        return _RATE * (float(np.abs(rows.J[row]) @ np.maximum(self._speeds, moment)) + 1e-300)

    def reserve(self, rows: Rows, mode: Mode) -> tuple[float, Floats]:
        """The largest least reserve, and forces of all rows that have it."""
        order = self._system.held(mode) + [row for row, code in mode.items() if code in (PLUS, MINUS)]
        frictions = [each for each in rows.frictions if each.row in order]
        c = rows.J @ rows.inverse @ rows.h - rows.gamma
        value, found = reserve(rows.of(order, c, frictions), tuple(mode.get(row, CLOSED) for row in order))
        f = np.zeros(len(rows.gamma))
        f[order] = found
        return value, f

    def run(self, s: State, mode: Mode | None, fired: Sequence[int]) -> tuple[State, Mode]:
        system = self._system
        rows = system.rows(s)
        f = self._before(rows, mode, fired)
        left = self._leaving(s.t, mode, fired, f)
        opened = {row for row, code in left.items() if code == OPEN}
        touching = [
            row
            for k, row in enumerate(system.contacts)
            if system.one_way[k]
            or row in fired
            or (mode is not None and mode[row] == CLOSED)
            or rows.gap[k] <= 10 * self.near(rows, row)
        ]
        force = float(np.max(np.abs(f), initial=0.0))
        carrying = [
            row for row in touching if mode and mode[row] == CLOSED and row not in opened and f[row] > 1e-9 * force
        ]
        s, approach = self._struck(s, rows, touching, carrying)
        struck = bool(approach)
        s = self._at_rest(s, rows, touching, max(approach.values(), default=0.0))
        if struck:
            self._left = {}
        new = self._decided(s, touching, {} if struck else left)
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
        return self.reserve(rows, mode)[1] if redundant and fired else f

    def _leaving(self, t: float, mode: Mode | None, fired: Sequence[int], f: Floats) -> dict[int, int]:
        """A contact that pulled opens; friction that stuck without reserve slips against its force, for the whole
        instant."""
        if t - self._since > 1e-13 * self._length:
            self._left = {}
        self._since = t
        for row in fired:
            assert mode is not None
            if mode[row] == CLOSED:
                self._left[row] = OPEN
            elif mode[row] == STICK:
                self._left[row] = MINUS if f[row] > 0 else PLUS
        return self._left

    def _struck(self, s: State, rows: Rows, touching: list[int], carrying: list[int]) -> tuple[State, dict[int, float]]:
        """Blows until no gap closes any more: the state, and how fast what struck approached."""
        approach: dict[int, float] = {}
        v, first = s.v, rows.speed
        for _ in range(_BLOWS):
            self.grow(replace(s, v=v))
            speed = first + rows.J @ (v - s.v)
            slow = {row: self.slow(rows, row) for row in touching}
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
        order = [*self._system.bilateral, *e, *(each.row for each in laws)]
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
        """The state without the rest of a series of bounces that is over in short: flights of 2 u/a, each shorter
        by the same factor."""
        system = self._system
        speed = system.rows(s).speed
        parting = [row for row in touching if speed[row] > self.slow(rows, row)]
        ratio = max((speed[row] for row in parting), default=0.0) / approach if approach > 0 else 1.0
        if not parting or ratio >= 1 - 1e-9:
            return s
        resting = [row for row in touching if row not in parting]
        mode = self._decided(s, resting, {})
        now = system.rows(s)
        a = system.accelerations(now, system.forces(now, mode)[0])
        for row in parting:
            pull = -float(now.J[row] @ a - now.gamma[row])
            if pull <= 0 or 2 * speed[row] / pull >= _REST * self._length * (1 - ratio):
                return s
        slips = [
            each.row
            for each in rows.frictions
            if each.contact in touching and abs(speed[each.row]) <= self.slow(rows, each.row)
        ]
        return replace(s, v=system.projected(now, system.bilateral + touching + slips, s.v, speed))

    def _decided(self, s: State, touching: list[int], left: dict[int, int]) -> Mode:
        """The mode of the accelerations. Friction that slips at the limit of rest has that of sliding then."""
        system = self._system
        rows = system.rows(s)
        speed = rows.speed
        near = [row for row in touching if left.get(row) != OPEN and abs(speed[row]) <= self.slow(rows, row)]
        laws = [each for each in rows.frictions if each.contact is None or each.contact in near]
        moving = {
            each.row: PLUS if speed[each.row] > 0 else MINUS
            for each in laws
            if abs(speed[each.row]) > self.slow(rows, each.row)
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
        names, told = self._system.names, self.told
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


def left_to(each: Friction, f: Floats) -> float:
    """The reserve of a friction that sticks."""
    mu, r0 = each.law(at_rest=True)
    return float(r0 + (mu * f[each.contact] if each.contact is not None else 0.0) - abs(f[each.row]))


def _only(found: list[Solution], t: float = 0.0) -> Solution:
    if len(found) != 1:
        raise AmbiguousError(f"{len(found)} solutions at t = {t:.9g}")
    return found[0]
