"""Derivatives of whole runs by differences: what exact ones are compared with.

Central differences of two steps, extrapolated (L. F. Richardson, Phil. Trans. A 210 (1911) 307); at a bound differences
to one side of the same order. The step follows from what it does: results change by a small part of their range.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.fit.rollout import Differentiated, Rollout, happened
from lagdsl.motion.fit.unknowns import Unknown
from lagdsl.motion.signals.trajectory import Trajectory

# The error of fourth order, (part)^4, equals that of the integration, (tolerance/part), near this part.
_PART = 0.02
_FIRST = 1e-4  # of the size of an unknown
# Runs for differences of fourth order are this much more accurate than those that are compared with data.
_FINER, _FINEST = 1e-2, 1e-12
# Weights of f(x), f(x+h) ... f(x+4h) for h f'(x), of fourth order.
_ONE_SIDE = np.array([-25.0, 48.0, -36.0, 16.0, -3.0]) / 12.0


class DifferencesOfRuns:
    """Remembers the steps that were good from one call to the next."""

    error = 1e-5

    def __init__(self) -> None:
        self._steps: dict[tuple[str, str], float] = {}

    def __call__(self, rollout: Rollout, x: Floats, *, exact: bool = False) -> Differentiated:
        """See `Derivatives`: of second order along the search, of fourth order with `exact`."""
        tolerance = max(_FINER * rollout.tolerance, _FINEST) if exact else rollout.tolerance
        motion = rollout.motion(x, tolerance=tolerance)
        values, order = rollout.observed(motion), happened(motion, rollout.series)
        jacobian = np.empty((len(values), len(x)))
        steady: list[bool] = []

        def at(k: int, moved: float) -> tuple[Floats, bool]:
            there = x.copy()
            there[k] = moved
            found: Trajectory = rollout.motion(there, tolerance=tolerance)
            return rollout.observed(found), happened(found, rollout.series) == order

        for k, unknown in enumerate(rollout.unknowns):
            seen: list[bool] = []

            def watched(moved: float, k: int = k, seen: list[bool] = seen) -> Floats:
                found, same = at(k, moved)
                seen.append(same)
                return found

            if exact:
                self._steps.pop((rollout.name, unknown.label), None)
            step = self._step(rollout, unknown, float(x[k]), values, watched)
            seen.clear()
            jacobian[:, k] = _difference(float(x[k]), step, (unknown.low, unknown.high), values, watched, exact)
            steady.append(all(seen))
        return Differentiated(motion=motion, values=values, jacobian=jacobian, steady=tuple(steady))

    def _step(
        self, rollout: Rollout, unknown: Unknown, x: float, values: Floats, at: Callable[[float], Floats]
    ) -> float:
        """A step that changes the values by a small part of their range, found once."""
        key = rollout.name, unknown.label
        if key not in self._steps:
            step = _FIRST * unknown.size
            ranges = np.maximum(_ranges(rollout, values), np.finfo(float).tiny)
            side = 1.0 if x + step <= unknown.high else -1.0
            moved = float(np.nanmax(np.abs(at(x + side * step) - values) / ranges, initial=0.0))
            factor = _PART / moved if moved > 0.0 else np.inf
            self._steps[key] = float(np.clip(step * factor, 1e-2 * step, _PART / _FIRST * step))
        return self._steps[key]


def _ranges(rollout: Rollout, values: Floats) -> Floats:
    """Ranges of the values (n,) of each series, in its rows; for events the mean time between them."""
    found, first = [], 0
    for series in rollout.series:
        own = values[first : first + len(series.values)]
        seen = own[np.isfinite(own)]
        span = float(np.ptp(seen)) if len(seen) else 0.0
        span = span / max(len(seen), 1) if series.event else span
        found.append(np.full(len(own), span or float(np.max(np.abs(seen), initial=0.0)) or 1.0))
        first += len(own)
    return np.concatenate(found)


def _difference(
    x: float, step: float, bounds: tuple[float, float], values: Floats, at: Callable[[float], Floats], exact: bool
) -> Floats:
    low, high = bounds
    if low <= x - step and x + step <= high:
        whole = (at(x + step) - at(x - step)) / (2.0 * step)
        if not exact:
            return np.asarray(whole)
        half = (at(x + 0.5 * step) - at(x - 0.5 * step)) / step
        return np.asarray((4.0 * half - whole) / 3.0)
    side = 0.25 * step if high - x >= x - low else -0.25 * step
    side = np.sign(side) * min(abs(side), 0.25 * max(high - x, x - low))
    nodes = [values, *(at(x + k * side) for k in range(1, 5))]
    return np.asarray(np.einsum("k,kn->n", _ONE_SIDE, np.array(nodes)) / side)
