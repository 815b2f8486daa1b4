"""The vector of discretes of one run, and what the model says of events at a state."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lagdsl.flat.events import INITIAL, TERMINAL
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.right_hand_side import RightHandSide

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Gaps:
    """Of contacts, then of `impact`: gap, its rate and dgap/dq."""

    gap: Floats
    speed: Floats
    jacobian: Floats


@dataclass(frozen=True, slots=True)
class Outcome:
    """One pass over the clauses: w after it, resets with their values, impacts with their restitutions, what stops."""

    w: Floats
    reset: Floats
    value: Floats
    impact: Floats
    restitution: Floats
    stop: Floats
    fail: Floats


class Discretes:
    """Where what stands in w, and the functions of the model at (t, y) with any w."""

    def __init__(self, flat: FlatModel, system: RightHandSide) -> None:
        self.flat, self.system = flat, system
        self._engine = system.engine
        kinds = np.array(self._engine.layout.kinds, dtype=object)
        self.variables = np.flatnonzero(kinds == "variable")
        self.contacts = np.flatnonzero(kinds == "contact")
        self.impacts = np.flatnonzero(kinds == "impacts")
        self.relations = np.flatnonzero(kinds == "relation")
        self.conditions = np.flatnonzero(kinds == "condition")
        self.clocks = np.flatnonzero(kinds == "clock")
        self.pulses = np.flatnonzero((kinds == "clock") | (kinds == "instant"))
        self.strict = np.array([relation.strict for relation in flat.events.relations], dtype=np.bool_)
        self._instants = {
            slot.name: index for index, slot in enumerate(self._engine.layout.discretes) if kinds[index] == "instant"
        }

    @property
    def any(self) -> bool:
        return len(self._engine.layout.discretes) > 0

    def instant(self, *, initial: bool) -> int | None:
        """The entry of `initial()` or of `terminal()`, if it occurs."""
        return self._instants.get(INITIAL if initial else TERMINAL)

    def started(self, t: float) -> Floats:
        """w before anything happened."""
        return self._engine.evaluate("discrete_start", t, self.system.p)[0].copy()

    def clock(self, t: float) -> tuple[Floats, Floats]:
        """First ticks and periods."""
        start, period = self._engine.evaluate("clock", t, self.system.p)
        return start, period

    def truths(self, t: float, y: Floats, w: Floats) -> Flags:
        """Relations as they stand."""
        return self.holds(self.indicators(t, y, w))

    def holds(self, indicators: Floats) -> Flags:
        """Which relations these values mean."""
        return np.asarray((indicators > 0.0) | ((indicators == 0.0) & ~self.strict))

    def indicators(self, t: float, y: Floats, w: Floats) -> Floats:
        """Left - right of every relation."""
        if not len(self.relations):
            return np.zeros(0)
        return self._engine.evaluate("indicator", *self._solved(t, y, w))[0]

    def multipliers(self, t: float, y: Floats, w: Floats) -> Floats:
        """Of the contacts: what pushes is positive."""
        lam = self._solved(t, y, w)[-1]
        assert isinstance(lam, np.ndarray)
        return lam[self.rows]

    def force(self, t: float, y: Floats, w: Floats) -> float:
        """The largest multiplier that what acts now would give a contact by itself."""
        solved = self._solved(t, y, w)
        (tau,) = self._engine.evaluate("inverse_dynamics", *solved[:-2], np.zeros(self.system.n))
        rows = self.gaps(t, y, w).jacobian
        return float(np.max(np.abs(tau), initial=0.0)) / max(float(np.max(np.abs(rows), initial=0.0)), 1e-300)

    @property
    def rows(self) -> Indices:
        """The constraint rows of the contacts."""
        names = [slot.name for slot in self._engine.layout.constraints]
        return np.array([names.index(contact.name) for contact in self.flat.events.contacts], dtype=np.intp)

    def gaps(self, t: float, y: Floats, w: Floats) -> Gaps:
        found = self._engine.evaluate("contact", *self._state(t, y, w))
        return Gaps(*found[:3])

    def laws(self, t: float, y: Floats, w: Floats) -> tuple[Floats, Floats, Floats]:
        """Of each contact: restitution; speed and time below which it closes, negative where the default holds."""
        _, _, _, restitution, stick, rest = self._engine.evaluate("contact", *self._state(t, y, w))
        return restitution, stick, rest

    def one_pass(self, t: float, y: Floats, w: Floats) -> Outcome:
        return Outcome(*self._engine.evaluate("event", *self._solved(t, y, w)))

    def _state(self, t: float, y: Floats, w: Floats) -> tuple[Floats | float, ...]:
        q, qd, z = (np.ascontiguousarray(part) for part in self.system.split(y))
        return t, q, qd, z, self.system.inputs(t), w, self.system.p

    def _solved(self, t: float, y: Floats, w: Floats) -> tuple[Floats | float, ...]:
        """The state with its accelerations and multipliers; not numbers where there are none."""
        state = self._state(t, y, w)
        solved = self.system.with_discretes(w).solved(t, y)
        layout = self._engine.layout
        if solved is None:
            return (*state, np.full(len(layout.coordinates), np.nan), np.full(len(layout.constraints), np.nan))
        return (*state, solved.qdd, solved.lam)
