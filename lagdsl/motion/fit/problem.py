"""All runs of a fit together: residuals in standard deviations, and their derivatives by the scaled unknowns."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.motion.fit.data import Series
from lagdsl.motion.fit.rollout import Derivatives, Differentiated, Rollout, Signature, happened
from lagdsl.motion.fit.unknowns import Unknown
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed


@record(kw_only=True)
class Problem:
    """`unknowns` of all runs; those of run k are at `places[k]`. `sigmas` (n,) are the standard deviations that values
    are divided by, in the order of runs, series and times."""

    rollouts: tuple[Rollout, ...]
    unknowns: tuple[Unknown, ...]
    places: tuple[tuple[int, ...], ...]
    sigmas: Floats
    derivatives: Derivatives

    @property
    def all_series(self) -> list[Series]:
        """Series of all runs, in their order."""
        return [series for rollout in self.rollouts for series in rollout.series]

    @property
    def measured(self) -> Floats:
        """All values (n,) that were measured."""
        return np.concatenate([series.values for series in self.all_series])

    @property
    def sizes(self) -> Floats:
        """Of the unknowns, by which the search divides them."""
        return np.array([unknown.size for unknown in self.unknowns])

    def values(self, x: Floats) -> Floats:
        """Values (n,) that would be measured for the unknowns x. Raises CompilationFailed and SimulationFailed."""
        return np.concatenate([r.observed(motion) for r, motion in zip(self.rollouts, self.motions(x), strict=True)])

    def motions(self, x: Floats) -> list[Trajectory]:
        """The motions of all runs for the unknowns x. Raises CompilationFailed and SimulationFailed."""
        return [rollout.motion(x[list(at)]) for rollout, at in self._each()]

    def differentiated(self, x: Floats, *, exact: bool = False) -> tuple[list[Differentiated], Floats]:
        """Every run with its derivatives, and those of all values (n, unknowns). Raises as `values`."""
        found = [self.derivatives(rollout, x[list(at)], exact=exact) for rollout, at in self._each()]
        jacobian = np.zeros((len(self.sigmas), len(self.unknowns)))
        first = 0
        for each, (_, at) in zip(found, self._each(), strict=True):
            jacobian[first : first + len(each.values), list(at)] = each.jacobian
            first += len(each.values)
        return found, jacobian

    def _each(self) -> list[tuple[Rollout, tuple[int, ...]]]:
        return list(zip(self.rollouts, self.places, strict=True))


class Residuals:
    """The function that a search calls with scaled unknowns s = x / size; motions that fail have no residuals, so that
    the search takes a shorter step. `failures` are the reasons, `orders` those of the events of each run, in the order
    in which they were met."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._measured, self._sizes = problem.measured, problem.sizes
        self.failures: list[str] = []
        self.orders: list[dict[Signature, None]] = [{} for _ in problem.rollouts]
        self._last: tuple[bytes, Floats] | None = None

    def __call__(self, s: Floats) -> Floats:
        """Residuals (n,), infinite where there is no motion or an event is missing."""
        try:
            motions = self._problem.motions(s * self._sizes)
        except (CompilationFailed, SimulationFailed) as failure:
            self.failures.append(failure.diagnostics[0].message)
            return np.full(len(self._measured), np.inf)
        pairs = list(zip(self._problem.rollouts, motions, strict=True))
        for met, (rollout, motion) in zip(self.orders, pairs, strict=True):
            met[happened(motion, rollout.series)] = None
        values = np.concatenate([rollout.observed(motion) for rollout, motion in pairs])
        found = (values - self._measured) / self._problem.sigmas
        return np.where(np.isfinite(found), found, np.inf)

    def jacobian(self, s: Floats) -> Floats:
        """Derivatives (n, unknowns)."""
        key = np.asarray(s).tobytes()
        if self._last is None or self._last[0] != key:
            _, found = self._problem.differentiated(s * self._sizes)
            self._last = key, np.asarray(found * self._sizes / self._problem.sigmas[:, None])
        return self._last[1]


def places_of(unknowns: Sequence[Unknown], runs: int) -> tuple[tuple[int, ...], ...]:
    """Places of the unknowns of each run."""
    return tuple(tuple(i for i, each in enumerate(unknowns) if each.run in (None, k)) for k in range(runs))
