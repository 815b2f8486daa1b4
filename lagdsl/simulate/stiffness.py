"""Is the step limited by stability instead of accuracy? Asked of the exact Jacobian now and then.

Source of the idea: Hairer and Wanner II, section IV.2 (h |lambda| against the border of the stability region); here
lambda is an eigenvalue of the exact Jacobian in the left half plane.
"""

from __future__ import annotations

import numpy as np

from lagdsl.mechanics.rank import Floats

# The region of the order-8 pair reaches to about -6 on the real axis; accuracy keeps h*lambda near 1.
_LIMIT = 3.5
_EVERY = 20
_IN_A_ROW = 3
# An implicit step costs several explicit ones: it must be at least this much longer to be worth it.
_GAIN = 4.0
_TRIAL = 40
# Squarings of the Jacobian before its norm is taken as a bound.
_DOUBLINGS = 6


class Stiffness:
    """Decides for the solver `auto` when to change method."""

    def __init__(self) -> None:
        self.settled = False
        self._steps = 0
        self._signs = 0
        self._explicit_mean = 0.0

    def seems_stiff(self, step: float, jacobian_at_present: object) -> bool:
        """To be asked after every explicit step; `jacobian_at_present()` is called every twentieth time."""
        self._steps += 1
        self._explicit_mean += (step - self._explicit_mean) / min(self._steps, _EVERY)
        if self.settled or self._steps % _EVERY:
            return False
        assert callable(jacobian_at_present)
        jacobian = jacobian_at_present()
        slow = step * radius_bound(jacobian) <= _LIMIT
        self._signs = 0 if slow or step * fastest_decay(jacobian) <= _LIMIT else self._signs + 1
        return self._signs >= _IN_A_ROW

    def implicit_started(self) -> None:
        self._steps, self._signs = 0, 0

    def not_worth_it(self, elapsed: float) -> bool:
        """To be asked after every implicit step with the time since the change: True once, if steps did not become
        much longer."""
        self._steps += 1
        if self.settled or self._steps < _TRIAL:
            return False
        self.settled = True
        return elapsed / self._steps < _GAIN * self._explicit_mean


def radius_bound(jacobian: Floats) -> float:
    """No eigenvalue is larger, in 1/s: |lambda|^k <= |J^k| for every k (Gelfand), which for large k says little more.

    Costs a few products of matrices, a small part of what the eigenvalues of a large system do.
    """
    logarithm, power = 0.0, jacobian
    for doubling in range(_DOUBLINGS + 1):
        size = float(np.linalg.norm(power))
        if not 0.0 < size < np.inf:
            return 0.0 if size == 0.0 else np.inf
        logarithm += np.log(size) / 2**doubling
        power = power / size
        power = power @ power
    return float(np.exp(logarithm))


def fastest_decay(jacobian: Floats) -> float:
    """Largest |lambda| among eigenvalues that decay at a noticeable rate, in 1/s."""
    if not jacobian.size or not np.all(np.isfinite(jacobian)):
        return 0.0
    values = np.linalg.eigvals(jacobian)
    decaying = values[-values.real > 0.05 * np.abs(values)]
    return float(np.max(np.abs(decaying), initial=0.0))
