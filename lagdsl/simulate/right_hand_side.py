"""The model as a first-order system: y = (q, qd, z)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.runtime.engine import Engine, SingularSystem
from lagdsl.simulate.signals import Signals


@dataclass(frozen=True, slots=True)
class Solved:
    """Everything known at one state."""

    t: float
    q: Floats
    qd: Floats
    z: Floats
    u: Floats
    qdd: Floats
    lam: Floats


@dataclass(frozen=True, slots=True)
class Trouble:
    """A state at which the accelerations could not be found: nan somewhere, or `singular` names a coordinate's
    index."""

    t: float
    y: Floats
    derivative: Floats
    singular: int | None


def finite(values: Floats) -> bool:
    """Whether all are numbers; one sum is several times cheaper than looking at each (a sum that overflows is none)."""
    return math.isfinite(float(values.sum()))


class RightHandSide:
    """f(t, y) and its Jacobian. Remembers the last solution and the last trouble; trouble is nan to the integrator,
    which then tries a shorter step.

    `until` is the end of the present segment: inputs there are taken from the left.
    """

    def __init__(self, engine: Engine, signals: Signals, w: Floats, p: Floats) -> None:
        self.engine = engine
        self.signals = signals
        self.w = w
        self.p = p
        self.n = len(engine.layout.coordinates)
        self.until = np.inf
        self.evaluations = 0
        self.jacobians = 0
        self.trouble: Trouble | None = None
        self._key: tuple[float, bytes] | None = None
        self._solved: Solved | None = None
        self._derivative: Floats = np.zeros(0)

    def enter(self, until: float) -> None:
        """Begin a segment that ends at `until`."""
        self.until = until
        self._key = None

    def with_discretes(self, w: Floats) -> RightHandSide:
        """The same system, from now on with these discretes."""
        if w is not self.w and not np.array_equal(w, self.w):
            self.w = w.copy()
            self._key = None
        return self

    def split(self, y: Floats) -> tuple[Floats, Floats, Floats]:
        """q, qd, z as contiguous arrays."""
        return y[: self.n], y[self.n : 2 * self.n], y[2 * self.n :]

    def inputs(self, t: float) -> Floats:
        return self.signals.at(t, before=t >= self.until)

    def __call__(self, t: float, y: Floats) -> Floats:
        """dy/dt; all nan where it does not exist."""
        key = (t, y.tobytes())
        if key == self._key:
            return self._derivative
        if not finite(y):  # a stage after one in trouble: not worth remembering
            return np.full_like(y, np.nan)
        self.evaluations += 1
        y = y.copy()
        q, qd, z = self.split(y)
        u = self.inputs(t)
        self._key = None
        try:
            qdd, lam = self.engine.solve(t, q, qd, z, u, self.w, self.p)
        except SingularSystem as singular:
            self.trouble = Trouble(t, y, np.full_like(y, np.nan), singular.coordinate)
            return np.full_like(y, np.nan)
        parts = [qd, qdd]
        if len(z):
            parts.append(self.engine.evaluate("state_derivative", t, q, qd, z, u, self.w, self.p, qdd, lam)[0])
        derivative = np.concatenate(parts)
        if not finite(derivative):
            self.trouble = Trouble(t, y, derivative, None)
            return np.full_like(y, np.nan)
        self._key, self._derivative = key, derivative
        self._solved = Solved(t, q, qd, z, u, qdd, lam)
        return derivative

    def solved(self, t: float, y: Floats) -> Solved | None:
        """Accelerations and multipliers at a state, or None where there are none."""
        derivative = self(t, y)
        return self._solved if finite(derivative) else None

    def jacobian(self, t: float, y: Floats) -> Floats:
        """df/dy, exact; zero where it does not exist, which makes an implicit step fail and become shorter."""
        self.jacobians += 1
        q, qd, z = self.split(np.ascontiguousarray(y))
        try:
            matrix = self.engine.jacobian(t, q, qd, z, self.inputs(t), self.w, self.p)
        except SingularSystem as singular:
            self.trouble = Trouble(t, y.copy(), np.full_like(y, np.nan), singular.coordinate)
            return np.zeros((len(y), len(y)))
        return matrix if finite(matrix) else np.zeros((len(y), len(y)))
