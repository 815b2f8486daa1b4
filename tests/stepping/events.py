"""An instant: passes over the clauses, resets, blows, contacts that close and open.

Written from docs/reference/events.md and docs/explanation/mechanics.md, section 9.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from stepping.balance import Balance, Floats, impact, least_impulse, pushed
from stepping.state import AHEAD, NOW, State, System

# Blows that a row of bodies passes on become weaker by a constant factor, often by less than a tenth.
_BLOWS = 2000
_PASSES = 100
# Of the run: how long bounces may still go on in a contact that is at rest; of that, how long the next flight is
# where bounces do not become shorter.
_REST, _SHORT = 1e-6, 1e-3
_ZERO = 1e-10
# Of the largest terms of a gap: below it they touch, below that it is round-off.
_TOUCHING, _NOISE = 1e-13, 4e-15
# Of the terms of the acceleration of a gap: below it none.
_NO_ACCELERATION = 1e-9


class UnsettledError(AssertionError):
    """Clauses or relations turn each other over for ever at one instant: the model has no motion beyond it."""

    def __init__(self, time: float) -> None:
        super().__init__(f"passes that do not settle at t = {time:.9g}")
        self.time = time


@dataclass
class Happening:
    time: float
    name: str
    kind: str


@dataclass
class Memory:
    """Of rates and of positions: the largest so far. Events that were told."""

    speeds: Floats
    places: Floats
    told: list[Happening] = field(default_factory=list)
    ended: bool = False


class Instant:
    """Carries out one instant."""

    def __init__(self, system: System, memory: Memory) -> None:
        self._system, self._memory = system, memory

    def run(self, s: State, b: list[float], flags: list[int]) -> tuple[State, list[float]]:
        """The state after it. `flags` are clocks and instants that are true in the first pass."""
        system = self._system
        w = s.w.copy()
        w[flags] = 1.0
        s = replace(s, w=w)
        for _ in range(_PASSES):
            before = s
            s, acted = self._pass(s, b)
            struck, s = self._strike(s, b, *acted)
            w, b = system.standing(s, b)
            w[flags] = 0.0
            s = replace(s, w=w)
            s = self._taken_hold(before, s, b)
            s = self._opened(s, b)
            if np.array_equal(before.w, s.w) and not struck and not acted[2]:
                return s, system.standing(s, b)[1]
        raise UnsettledError(s.t)

    def _pass(self, s: State, b: list[float]) -> tuple[State, tuple[list[int], list[float], bool]]:
        """One look at all clauses: the state, the impacts they ask for, whether something was set."""
        system = self._system
        if "event" not in {f.name for f in system.functions._program.functions}:
            return s, ([], [], False)
        found = system.call("event", s, None, system.solved(s, b))
        v, z, n = s.v.copy(), s.z.copy(), len(s.q)
        held = []
        for place, acts, value in zip(system.layout.instants.reset_places, found["reset"], found["value"], strict=True):
            if acts and place < 2 * n:
                v[place - n] = value
                held.append(place - n)
            elif acts:
                z[place - 2 * n] = value
        self._memory.ended |= bool(np.any(found["stop"]))
        changed = not np.array_equal(found["w"], s.w)
        after = replace(s, v=v, z=z, w=found["w"])
        if held:
            after = self._moved_apart(after, b)
        if held or changed:
            rows = system.call("velocity_constraint", after, b)
            mass = system.call("dynamics", after, b)["M"]
            after = replace(after, v=v + least_impulse(mass, rows["J"], rows["residual"], held))
        asked = [int(i) for i in np.flatnonzero(found["impact"])]
        acted = bool(np.any(found["reset"]))
        return after, (asked, [float(found["restitution"][i]) for i in asked], acted)

    def _moved_apart(self, s: State, b: list[float]) -> State:
        """Closed contacts that resets move apart open: nothing pulls them back."""
        system = self._system
        if not system.contacts:
            return s
        found, w = system.call("contact", s, b), s.w.copy()
        scale = self._zero_speed(found["jacobian"], s.v)
        for i in np.flatnonzero(w[system.contacts]):
            if found["speed"][i] > scale[i]:
                w[system.contacts[i]] = 0.0
                self._tell(s.t, int(i), "opened")
        return replace(s, w=w)

    def _taken_hold(self, before: State, s: State, b: list[float]) -> State:
        """Rates follow constraints that relations switch."""
        system = self._system
        relations = [*system.relations, *system.timed]
        if np.array_equal(before.w[relations], s.w[relations]) or not system.layout.constraints:
            return s
        rows = system.call("velocity_constraint", s, b)
        mass = system.call("dynamics", s, b)["M"]
        return replace(s, v=s.v + least_impulse(mass, rows["J"], rows["residual"], []))

    # ---- contacts ----------------------------------------------------------------------------------------------------

    def _touching(self, s: State, b: list[float]) -> tuple[dict[str, Floats], np.ndarray]:
        """Gaps and rates; which contacts touch: within a billionth of the run they meet or have met."""
        system = self._system
        found = system.call("contact", s, b)
        later = system.call("contact", system.later(s, b, 1e-6), b)
        moving = np.maximum(np.abs(found["speed"]), np.abs(later["speed"])) * system.length
        return found, np.abs(found["gap"]) <= np.maximum(NOW * moving, _TOUCHING * self._size(found["jacobian"], s.q))

    def _size(self, gaps: Floats, q: Floats) -> Floats:
        """The largest terms that gaps ever had."""
        self._memory.places = np.maximum(self._memory.places, np.abs(q))
        return np.abs(gaps) @ self._memory.places

    def noise(self, s: State, b: list[float]) -> Floats:
        """Gaps of contacts below it are round-off."""
        return _NOISE * self._size(self._system.call("contact", s, b)["jacobian"], s.q)[: len(self._system.contacts)]

    def _strike(self, s: State, b: list[float], asked: list[int], e: list[float], _: bool) -> tuple[bool, State]:
        """Blows until no gap closes any more."""
        system, count = self._system, len(self._system.contacts)
        if not count and not asked:
            return False, s
        found, touching = self._touching(s, b)
        mass, rows = system.call("dynamics", s, b)["M"], system.call("velocity_constraint", s, b)["J"].copy()
        lam = system.solved(s, b)[1]
        rows[system.rows] = 0.0
        closed = s.w[system.contacts] > 0
        none = system.no_forces(s, b) if count else np.zeros(0)
        carrying = [i for i in range(count) if closed[i] and lam[system.rows[i]] > none[i]]
        approach: dict[int, float] = {}
        v, first = s.v.copy(), True
        for _round in range(_BLOWS):
            speed = found["speed"] + found["jacobian"] @ (v - s.v)
            # a body at rest has no speed to measure round-off against before the first blow
            scale = self._zero_speed(found["jacobian"], v)
            hits = [i for i in range(count) if touching[i] and i not in carrying and speed[i] < -scale[i]]
            wanted = [(i, float(found["restitution"][i])) for i in hits]
            wanted += [(count + i, each) for i, each in zip(asked, e, strict=True)] if first else []
            driven = [i for i in carrying if speed[i] < -scale[i]]
            if not wanted and not driven:
                break
            for i in hits:
                approach.setdefault(i, -speed[i])
            part = wanted + [(i, 0.0) for i in carrying]
            index = [i for i, _ in part]
            v = v + impact(mass, rows, found["jacobian"][index], speed[index], [each for _, each in part])[0]
            first = False
        else:
            raise AssertionError("impacts without end")
        if np.array_equal(v, s.v):
            return False, s
        return True, self._judged(replace(s, v=v), b, found, approach, closed, scale)

    def _zero_speed(self, gaps: Floats, v: Floats) -> Floats:
        """Rates of gaps that are round-off: against the largest terms that they ever had."""
        self._memory.speeds = np.maximum(self._memory.speeds, np.abs(v))
        return _ZERO * np.max(np.abs(gaps) * self._memory.speeds, axis=1, initial=0.0) + 1e-300

    def _judged(
        self,
        s: State,
        b: list[float],
        found: dict[str, Floats],
        approach: dict[int, float],
        closed: Floats,
        scale: Floats,
    ) -> State:
        """Contacts that stay together after blows, and those that part."""
        system = self._system
        speed = system.call("contact", s, b)["speed"]
        w, noise = s.w.copy(), self.noise(s, b)
        parting = [int(i) for i in np.flatnonzero(closed) if speed[i] > scale[i]]
        flying = w.copy()
        flying[[system.contacts[i] for i in (*parting, *approach)]] = 0.0
        ahead = system.later(replace(s, w=flying), b, AHEAD)
        back = (speed - system.call("contact", ahead, b)["speed"]) / (ahead.t - s.t)
        for i in parting:
            # one that rises by round-off stays: two that throw each other up so would do so for ever
            if i in approach or not (back[i] > 0 and speed[i] ** 2 / (2 * back[i]) < noise[i]):
                w[system.contacts[i]] = 0.0
                if i not in approach:
                    self._tell(s.t, i, "opened")
        for i, was in approach.items():
            w[system.counts[i]] += 1
            left = self._left(found, i, float(speed[i]), was, float(back[i]), float(scale[i]), float(noise[i]))
            stays = left < np.inf
            w[system.contacts[i]] = float(stays)
            self._tell(s.t, i, "impact")
            if left and stays:
                self._tell(s.t + left, i, "closed")
            elif bool(closed[i]) != stays:
                self._tell(s.t, i, "closed" if stays else "opened")
        s = replace(s, w=w)
        rows = system.call("velocity_constraint", s, b)
        mass = system.call("dynamics", s, b)["M"]
        return replace(s, v=s.v + least_impulse(mass, rows["J"], rows["residual"], []))

    def _left(
        self, found: dict[str, Floats], i: int, speed: float, was: float, back: float, zero: float, noise: float
    ) -> float:
        """Time left of the series of bounces of a contact that struck, 0 where it does not rebound, inf where it does
        not come to rest in short and rises above round-off: flights of 2 v/a, r times that, r^2 times that."""
        capture_speed = float(found["capture_speed"][i])
        if speed <= zero or 0 <= speed < capture_speed:
            return 0.0
        rest = float(found["zeno_time"][i]) if found["zeno_time"][i] >= 0 else _REST * self._system.length
        flight, ratio = 2 * speed / back if back > 0 else np.inf, speed / was
        left = flight / (1 - ratio) if ratio < 1 else np.inf
        short = left < rest or flight < _SHORT * rest or speed * flight / 8 < noise
        return min(left, flight / _SHORT) if short else np.inf

    def _opened(self, s: State, b: list[float]) -> State:
        """Closed contacts whose gaps accelerate apart open; touching ones without speed that are driven in close."""
        system = self._system
        if not system.contacts:
            return s
        s = self._driven_in(s, b)
        while True:
            closed = [int(i) for i in np.flatnonzero(s.w[system.contacts] > 0)]
            begins = self._begins(s, b, closed)
            apart = [i for i in self._apart(s, b, closed) if i not in begins] or self._soon_apart(s, b, closed, begins)
            if not apart:
                return s
            w = s.w.copy()
            for i in apart:
                w[system.contacts[i]] = 0.0
                self._tell(s.t, i, "opened")
            s = replace(s, w=w)

    def _apart(self, s: State, b: list[float], closed: list[int]) -> list[int]:
        """Of the closed contacts those that part: forces p >= 0, accelerations of gaps a >= 0, p a = 0."""
        system = self._system
        if not closed:
            return []
        found, none = system.call("dynamics", s, b), system.no_forces(s, b)
        rows = system.rows[closed]
        acceleration, terms = pushed(found, rows, 2 * none[closed])
        return [i for i, a, size in zip(closed, acceleration, terms, strict=True) if a > _NO_ACCELERATION * size]

    def _begins(self, s: State, b: list[float], closed: list[int]) -> list[int]:
        """Of the closed contacts those whose force begins here: it is zero but for the round-off of the time."""
        system = self._system
        if not closed:
            return []
        then = system.later(s, b, AHEAD)
        now, later = (system.solved(each, b)[1][system.rows[closed]] for each in (s, then))
        return [closed[k] for k in np.flatnonzero(np.abs(now) < NOW / AHEAD * np.abs(later - now))]

    def _soon_apart(self, s: State, b: list[float], closed: list[int], begins: list[int]) -> list[int]:
        """Closed contacts without a force here, up to round-off of the time, that part a moment later."""
        system = self._system
        if not closed:
            return []
        none, then = system.no_forces(s, b)[closed], system.later(s, b, AHEAD)
        now, later = (system.solved(each, b)[1][system.rows[closed]] for each in (s, then))
        zero = (np.abs(now) <= 2 * none) | np.isin(closed, begins)
        pulling = zero & (later < -2 * none)
        return [i for i in self._apart(then, b, closed) if pulling[closed.index(i)]]

    def _driven_in(self, s: State, b: list[float]) -> State:
        """Open contacts that touch, do not move apart, and are accelerated towards each other, are closed."""
        system, count = self._system, len(self._system.contacts)
        found, touching = self._touching(s, b)
        scale = self._zero_speed(found["jacobian"], s.v)
        ahead = system.later(s, b, AHEAD)
        further = system.later(ahead, b, AHEAD)
        then = system.call("contact", ahead, b)["speed"]
        change, following = then - found["speed"], system.call("contact", further, b)["speed"] - then
        terms = np.abs(found["jacobian"]) @ np.maximum(np.abs(ahead.v - s.v), np.abs(further.v - ahead.v))
        # an acceleration that begins here is zero but for the round-off of the time
        change = np.where(np.abs(change) <= NOW / AHEAD * np.abs(following - change), following, change)
        closing = touching & (np.abs(found["speed"]) <= scale) & (change < -_NO_ACCELERATION * terms)
        w = s.w.copy()
        for i in np.flatnonzero(closing[:count] & (w[system.contacts] == 0)):
            w[system.contacts[i]] = 1.0
            self._tell(s.t, int(i), "closed")
        return replace(s, w=w)

    def settled(self, s: State, b: list[float]) -> State:
        """At the start: contacts that touch and do not move apart are closed unless they pull."""
        system = self._system
        if not system.contacts:
            return s
        found, touching = self._touching(s, b)
        scale = self._zero_speed(found["jacobian"], s.v)
        count = len(system.contacts)
        w = s.w.copy()
        w[system.contacts] = (touching & (np.abs(found["speed"]) <= scale))[:count]
        s, told = replace(s, w=w), len(self._memory.told)
        s = self._opened(s, b)
        del self._memory.told[told:]
        return s

    def _tell(self, t: float, contact: int, kind: str) -> None:
        label = self._system.layout.discretes[self._system.contacts[contact]].name
        name = label.removeprefix("closed(").removesuffix(")")
        told = self._memory.told
        here = next((each for each in reversed(told) if each.name == name and each.time == t), None)
        if kind == "opened" and here is not None and here.kind == "closed":
            told.remove(here)  # it struck and does not stay
        else:
            told.append(Happening(t, name, kind))


def balanced(system: System, before: State, b: list[float], s: State, after: list[float]) -> State:
    """Rates after corners changed their branches: momenta are kept but for the impulses of the constraints."""
    kept = system.call("momenta", before, b)["momenta"]
    mass = system.call("dynamics", s, after)["M"]
    rows = system.call("velocity_constraint", s, after)
    lost = kept - system.call("momenta", s, after)["momenta"]
    return replace(s, v=s.v + Balance(mass, rows["J"]).solve(lost, -rows["residual"])[0])
