"""One instant of a motion: what the functions of the model say there, with everything that switches held."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from stepping.balance import Balance, Floats, tied
from stepping.functions import Functions, Point

from lagdsl.derivation.program.program import Program

FROZEN = (
    "dynamics",
    "state_derivative",
    "indicator",
    "contact",
    "velocity_constraint",
    "position_constraint",
    "momenta",
    "friction",
)
# As parts of the length of the run: how far ahead what is zero now is looked at, what counts as now.
AHEAD, NOW = 1e-6, 1e-9
# The same for what time alone decides, which is as exact as the time is: nothing may change in between.
_TIME_AHEAD = 1e-10
_ROUND_OFF = 1e-11
_SCAN = 4000  # looks at what depends on time alone, in a run


@dataclass(frozen=True)
class State:
    t: float
    q: Floats
    v: Floats
    z: Floats
    w: Floats

    @property
    def x(self) -> Floats:
        return np.concatenate((self.q, self.v, self.z))

    def moved(self, t: float, x: Floats) -> State:
        n = len(self.q)
        return replace(self, t=t, q=x[:n], v=x[n : 2 * n], z=x[2 * n :])


class System:
    """The functions of a program at states. `branches` are those of the corners of its expressions."""

    def __init__(self, program: Program, length: float) -> None:
        layout = program.layout
        self.functions, self.length, self.layout = Functions(program, FROZEN), length, layout
        self.p = np.array(layout.defaults)
        kinds = layout.kinds
        self.kind = {k: [i for i, kind in enumerate(kinds) if kind == k] for k in set(kinds)}
        self.relations = self.kind.get("relation", [])
        self.contacts = self.kind.get("contact", [])
        self.counts = self.kind.get("impacts", [])
        self.timed = self.kind.get("timed", [])
        self.clocks = self.kind.get("clock", [])
        self.rows = np.array(layout.instants.contact_rows, dtype=int)
        self.strict = layout.instants.strict
        self._has_z = bool(layout.states)
        self._asks = self.functions.asks_for_accelerations(("indicator",))
        nothing = np.zeros(0)
        zero = Point(0.0, nothing, nothing, nothing, nothing, nothing, self.p, nothing, nothing)
        start = self.functions.call("start", zero, None)
        self.u = start["u"]
        w = self.functions.call("discrete_start", zero, None)["w"] if program.has("discrete_start") else nothing
        self.start = State(0.0, start["q"], start["qd"], start["z"], w)
        self.ticking = self.functions.call("clock", zero, None) if self.clocks else {}

    def point(self, s: State, solved: tuple[Floats, Floats] | None = None) -> Point:
        qdd, lam = solved or (np.full(len(s.q), np.nan), np.full(len(self.layout.constraints), np.nan))
        return Point(s.t, s.q, s.v, s.z, self.u, s.w, self.p, qdd, lam)

    def call(
        self, name: str, s: State, b: list[float] | None, solved: tuple[Floats, Floats] | None = None
    ) -> dict[str, Floats]:
        return self.functions.call(name, self.point(s, solved), b)

    def solved(self, s: State, b: list[float]) -> tuple[Floats, Floats]:
        """Accelerations and multipliers: M a - J' lam = f, J a = gamma."""
        found = self.call("dynamics", s, b)
        return Balance(found["M"], found["J"]).solve(found["f"], found["gamma"])

    def rates(self, s: State, b: list[float]) -> Floats:
        solved = self.solved(s, b)
        zd = self.call("state_derivative", s, b, solved)["zd"] if self._has_z else np.zeros(0)
        return np.concatenate((s.v, solved[0], zd))

    def valid(self, s: State, b: list[float]) -> Floats:
        """Values that stay positive in a mode: of relations, of contacts (gap, or the force), of corners."""
        closed = bool(self.contacts) and bool(np.any(s.w[self.contacts]))
        solved = self.solved(s, b) if closed or self._asks else None
        values: list[float] = []
        if self.relations:
            g = self.call("indicator", s, b, solved)["g"]
            values += list(np.where(s.w[self.relations] > 0, g, -g))
        if self.contacts:
            gap = self.call("contact", s, b)["gap"][: len(self.contacts)]
            force = solved[1][self.rows] + self.no_forces(s, b) if solved else gap
            values += list(np.where(s.w[self.contacts] > 0, force, gap))
        return np.array(values + self.functions.valid(self.point(s, solved), b))

    def no_forces(self, s: State, b: list[float]) -> Floats:
        """Multipliers of contacts below them are round-off: against the forces on all that is tied to what enters the
        gap, those there are and those that would stop it."""
        found = self.call("dynamics", s, b)
        mass, gaps = found["M"], self.call("contact", s, b)["jacobian"][: len(self.contacts)]
        forces = np.abs(found["f"]) + mass @ np.abs(self.start.v) / self.length
        part = tied(mass, np.vstack((found["J"], gaps)))
        enters = [np.isin(part, part[row != 0]) for row in gaps]
        return _ROUND_OFF * np.array([np.max(forces[own], initial=0.0) for own in enters])

    # ---- a moment later ----------------------------------------------------------------------------------------------

    def later(self, s: State, b: list[float], ahead: float) -> State:
        """The state so much later, to second order."""
        h, n = ahead * self.length, len(s.q)
        rates = self.rates(s, b)
        x = s.x + h * rates
        x[:n] += h * h / 2 * rates[n : 2 * n]
        return s.moved(s.t + h, x)

    def standing(self, s: State, b: list[float]) -> tuple[Floats, list[float]]:
        """Discretes with relations, and branches of corners, as they stand a moment later: what is not near its border
        is as it is now."""
        w = s.w.copy()
        if self.timed:
            w[self.timed] = self.timed_values(s, s.t + _TIME_AHEAD * self.length)
        s = replace(s, w=w)
        corners = self.functions.standing(self.point(self.later(s, b, AHEAD), self.solved(s, b)))
        if not self.relations:
            return w, corners
        now = self.call("indicator", s, b, self.solved(s, b))["g"]
        truth = np.array([x > 0 if strict else x >= 0 for x, strict in zip(now, self.strict, strict=True)], dtype=float)
        for ahead in (AHEAD, 30 * AHEAD, 1000 * AHEAD):
            then = self.later(s, corners, ahead)
            g = self.call("indicator", then, corners, self.solved(then, corners))["g"]
            near = np.abs(now) <= NOW / AHEAD * np.abs(g - now)
            truth = np.where(near, (g > 0).astype(float), truth)
            if np.all(near | (np.abs(now) > 0)):
                break
        w[self.relations] = truth
        return w, corners

    def timed_values(self, s: State, t: float) -> Floats:
        """Values at a time of the entries that depend on time alone."""
        return self.call("time_event", replace(s, t=t), None)["value"]

    def next_timed(self, s: State, end: float) -> float:
        """When one of them changes next, up to round-off; `end` without."""
        if not self.timed:
            return end
        low, step = s.t + _TIME_AHEAD * self.length, self.length / _SCAN
        now = self.timed_values(s, low)
        while low < end:
            high = min(low + step, end)
            if not np.array_equal(self.timed_values(s, high), now):
                while low < (middle := 0.5 * (low + high)) < high:
                    low, high = (middle, high) if np.array_equal(self.timed_values(s, middle), now) else (low, middle)
                return high
            low = high
        return end
