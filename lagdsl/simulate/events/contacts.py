"""Contacts of one run: open, impacting, closed.

A contact closes when it rebounds slowly, or when what is left of a series of impacts is short: with the last interval
dt between impacts and the ratio r of rebound speeds the rest of a geometric series is dt r/(1 - r).
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.events.discretes import Discretes, Flags
from lagdsl.simulate.events.impact import collide

# Language reference, ruling 40: parts of the largest approach speed so far and of the length of the experiment.
_STICK, _REST = 1e-3, 1e-6
# A gap, or its rate, is zero where an event is looked at below this part of the size of the state.
_TOUCHING = 1e-9
# What is below this part of the size of the state, or of the forces, is round-off and no event.
ROUNDING = 1e-13
# A force below this part of the others is none: what only touches hands a blow on, what carries takes part as it is.
_NOTHING = 1e-9
_MOST_IMPACTS = 10_000


def size(y: Floats) -> float:
    """Of a state; gaps and their rates are told from zero against it."""
    return 1.0 + float(np.max(np.abs(y), initial=0.0))


class Contacts:
    """The memory of contacts between impacts, and the impacts."""

    def __init__(self, discretes: Discretes, length: float) -> None:
        count = len(discretes.contacts)
        self._discretes, self._length = discretes, length
        self._fastest = np.zeros(count)
        self._last = np.full(count, -np.inf)
        # what is round-off: of gaps, as a part of the size of the state, and of forces
        self.slack = np.array([ROUNDING, 0.0])
        self._force = 0.0

    # ---- what changes ------------------------------------------------------------------------------------------------

    def look(self, t: float, y: Floats, w: Floats, inside: Flags) -> tuple[Floats, Flags]:
        """What passes zero when contacts change, the gap of open and the multiplier of closed ones, and which have
        changed: gaps that are negative, if those that were so before, `inside`, close further; multipliers that pull.
        """
        entries = self._discretes.contacts
        count, closed = len(entries), w[entries] != 0.0
        if not count:
            return np.zeros(0), inside
        gaps = self._discretes.gaps(t, y, w)
        gap = gaps.gap[:count]
        through = (gap < -ROUNDING * size(y)) & (~inside | (gaps.speed[:count] < 0.0))
        if not closed.any():
            return gap, through
        force = self._discretes.multipliers(t, y, w)
        return np.where(closed, force, gap), np.where(closed, force < -self.slack[1], through)

    def inside(self, t: float, y: Floats, w: Floats) -> Flags:
        """Gaps that are negative but for round-off."""
        count = len(self._discretes.contacts)
        if not count:
            return np.zeros(0, dtype=np.bool_)
        return np.asarray(self._discretes.gaps(t, y, w).gap[:count] < -ROUNDING * size(y))

    def pierced(self, t: float, y: Floats, w: Floats) -> list[int]:
        """Contacts whose gap is negative."""
        count = len(self._discretes.contacts)
        if not count:
            return []
        return np.flatnonzero(self._discretes.gaps(t, y, w).gap[:count] < -_TOUCHING * size(y)).tolist()

    def settled(self, t: float, y: Floats, w: Floats) -> Floats:
        """At the start: contacts that touch and do not move apart are closed if they push."""
        count = len(self._discretes.contacts)
        if not count:
            return w
        gaps = self._discretes.gaps(t, y, w)
        self._force = self._discretes.force(t, y, w)
        self.slack[1] = ROUNDING * self._force
        touching = np.abs(gaps.gap[:count]) <= _TOUCHING * size(y)
        touching &= np.abs(gaps.speed[:count]) <= _TOUCHING * size(y)
        return self.pushing(t, y, w, np.flatnonzero(touching).tolist())

    def pushing(self, t: float, y: Floats, w: Floats, candidates: list[int]) -> Floats:
        """w with those of the candidates closed that do not pull: the one that pulls most opens until none does."""
        w = w.copy()
        entries = self._discretes.contacts
        closed = list(candidates)
        w[entries[closed]] = 1.0
        while closed:
            force = self._discretes.multipliers(t, y, w)[closed]
            weakest = int(np.argmin(force))
            if not force[weakest] < -_NOTHING * self._force:
                break
            w[entries[closed.pop(weakest)]] = 0.0
        return w

    # ---- impacts -----------------------------------------------------------------------------------------------------

    def strike(
        self, t: float, y: Floats, w: Floats, struck: dict[int, float]
    ) -> tuple[Floats, Floats, list[tuple[int, str]]]:
        """y and w after impacts until nothing closes any more; `struck` are impacts of clauses by index with their e.

        Closed contacts that are driven in take part with e = 0; those that move apart afterwards, or would pull, open.
        Also tells what happened to which contact.
        """
        discretes, n = self._discretes, self._discretes.system.n
        count, closed_before = len(discretes.contacts), w[discretes.contacts] != 0.0
        first: dict[int, float] = {}
        w = w.copy()
        for _ in range(_MOST_IMPACTS):
            gaps, small = discretes.gaps(t, y, w), size(y)
            restitution, stick, rest = discretes.laws(t, y, w)
            speed, touching = gaps.speed[:count], gaps.gap[:count] <= _TOUCHING * small
            open_ = w[discretes.contacts] == 0.0
            closing = np.flatnonzero(touching & open_ & (speed < -_TOUCHING * small)).tolist()
            if (closing or struck) and not first:
                w = self._released(t, y, w)
            closed = w[discretes.contacts] != 0.0
            if not (closing or struck or np.any(closed & (speed < -_TOUCHING * small))):
                break
            active = dict.fromkeys([*closing, *struck])
            part = [*active, *(i for i in np.flatnonzero(closed).tolist() if i not in active)]
            factor = np.array([struck.get(i, restitution[i] if i < count else 0.0) for i in part])
            factor[len(active) :] = 0.0
            for i in closing:
                first.setdefault(i, float(speed[i]))
            y = y.copy()
            y[n : 2 * n] = self._after(t, y, w, gaps.jacobian[part], gaps.speed[part], factor)
            struck = {}
        w[discretes.impacts[list(first)]] += 1.0
        w[discretes.contacts] = np.where(closed_before, 1.0, w[discretes.contacts])
        slow = self._slow(y, stick, first)
        self.apart(t, y, w, slow)
        w[discretes.contacts[self._closing(t, y, w, first, slow, rest)]] = 1.0
        w = self.pushing(t, y, w, np.flatnonzero(w[discretes.contacts]).tolist())
        return y, w, self._told(closed_before, w, first)

    def _told(self, before: Flags, w: Floats, struck: Iterable[int]) -> list[tuple[int, str]]:
        """What happened to contacts: those that were `struck`, those that changed."""
        now = w[self._discretes.contacts] != 0.0
        changed = np.flatnonzero(before != now).tolist()
        return [
            (i, "impact" if before[i] == now[i] else "closed" if now[i] else "opened")
            for i in dict.fromkeys([*struck, *changed])
        ]

    def _released(self, t: float, y: Floats, w: Floats) -> Floats:
        """w with closed contacts opened that carry nothing."""
        entries = self._discretes.contacts
        self._force = max(self._force, self._discretes.force(t, y, w))
        self.slack[1] = ROUNDING * self._force
        if not np.any(w[entries] != 0.0):
            return w
        idle = self._discretes.multipliers(t, y, w) <= _NOTHING * self._force
        w[entries[idle]] = 0.0
        return w

    def apart(self, t: float, y: Floats, w: Floats, slow: Floats | float = 0.0) -> None:
        """Opens in w closed contacts that do not touch, or move apart faster than `slow`."""
        entries = self._discretes.contacts
        if np.any(w[entries] != 0.0):
            gaps, small = self._discretes.gaps(t, y, w), _TOUCHING * size(y)
            count = len(entries)
            away = (gaps.gap[:count] > small) | (gaps.speed[:count] > np.maximum(small, slow))
            w[entries[away]] = 0.0

    def _after(self, t: float, y: Floats, w: Floats, rows: Floats, speeds: Floats, factor: Floats) -> Floats:
        """Rates after one impact; closed contacts take part as such, not as rows that hold."""
        discretes, system = self._discretes, self._discretes.system
        q, qd, z = (np.ascontiguousarray(part) for part in system.split(y))
        opened = w.copy()
        opened[discretes.contacts] = 0.0
        state = (t, q, qd, z, system.inputs(t), opened, system.p)
        mass = system.engine.evaluate("mass_matrix", *state)[0]
        jacobian = system.engine.evaluate("velocity_constraint", *state)[1]
        return collide(mass, jacobian, len(jacobian), qd, rows, speeds, factor)

    def _slow(self, y: Floats, stick: Floats, first: dict[int, float]) -> Floats:
        """Speeds below which contacts stay together, now that some were approached with the speeds `first`."""
        for index, approach in first.items():
            self._fastest[index] = max(self._fastest[index], -approach)
        return np.maximum(np.where(stick >= 0.0, stick, _STICK * self._fastest), _TOUCHING * size(y))

    def _closing(
        self, t: float, y: Floats, w: Floats, first: dict[int, float], slow: Floats, rest: Floats
    ) -> list[int]:
        """Those that struck and stay."""
        found = []
        if first:
            speeds = self._discretes.gaps(t, y, w).speed
        for index, approach in first.items():
            interval = t - self._last[index]
            ratio = float(speeds[index]) / -approach if approach else 0.0
            self._last[index] = t
            short = rest[index] if rest[index] >= 0.0 else _REST * self._length
            over = ratio < 1.0 and interval * ratio / (1.0 - ratio) < short
            if abs(speeds[index]) < slow[index] or over:
                found.append(index)
        return found
