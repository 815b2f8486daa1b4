"""The search: nonlinear least squares by a trust region within bounds (SciPy's `least_squares`), from one or many
starts.

M. A. Branch, T. F. Coleman, Y. Li, SIAM J. Sci. Comput. 21 (1999) 1.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import qmc

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.motion.fit.problem import Problem, Residuals
from lagdsl.motion.fit.rollout import Signature

Loss: TypeAlias = Literal["linear", "soft_l1", "huber", "cauchy", "arctan"]
LOSSES: tuple[str, ...] = get_args(Loss)

# Relative changes of cost and unknowns, and the gradient, at which the search ends: below what data can tell.
_ENDS = 1e-9
_MOST_TRIALS = 200
# Of many starts so many of the best are followed to their minima.
_FOLLOWED = 3


@record(kw_only=True)
class Searched:
    """`x` (unknowns,) in SI units with its `cost`, half the sum of squares; `active` is -1 or 1 for an unknown at its
    lower or upper bound, else 0. `failures` are reasons of trials without a motion, `orders` those of events that were
    met, of each run."""

    x: Floats
    cost: float
    active: tuple[int, ...]
    trials: int
    converged: bool
    failures: tuple[str, ...]
    orders: tuple[tuple[Signature, ...], ...]


def search(problem: Problem, x: Floats, loss: Loss, progress: Callable[[float], None] | None = None) -> Searched:
    """From x (unknowns,), at which the motions exist, to a minimum."""
    residuals, sizes = Residuals(problem), problem.sizes
    begin = x / sizes
    low = np.array([unknown.low for unknown in problem.unknowns]) / sizes
    high = np.array([unknown.high for unknown in problem.unknowns]) / sizes
    count = 0

    # Values that data do not determine stay where they were: the weight is below that of directions that they do.
    pull = problem.derivatives.error * float(np.linalg.norm(residuals.jacobian(begin), 2)) * np.eye(len(x))

    def watched(s: Floats) -> Floats:
        nonlocal count
        count += 1
        if progress is not None:
            progress(min(count / _MOST_TRIALS, 1.0))
        return np.append(residuals(s), pull @ (s - begin))

    def differentiated(s: Floats) -> Floats:
        return np.vstack([residuals.jacobian(s), pull])

    found: Any = least_squares(
        watched,
        np.clip(begin, low, high),
        jac=differentiated,
        bounds=(low, high),
        method="trf",
        loss=loss,
        ftol=_ENDS,
        xtol=_ENDS,
        gtol=_ENDS,
        max_nfev=_MOST_TRIALS,
    )
    return Searched(
        x=found.x * sizes,
        cost=float(found.cost),
        active=tuple(int(each) for each in found.active_mask),
        trials=count,
        converged=found.status > 0,
        failures=tuple(residuals.failures),
        orders=tuple(map(tuple, residuals.orders)),
    )


def sampled(problem: Problem, count: int, seed: int) -> Floats:
    """Starts (count, unknowns): a Latin hypercube between the bounds; an unknown without them between the half and the
    double of its start, or one size about it."""
    edges = [_edges(u.value, u.low, u.high, u.size) for u in problem.unknowns]
    unit = qmc.LatinHypercube(len(edges), rng=np.random.default_rng(seed)).random(count)
    low, high = np.array(edges).T
    return np.asarray(low + unit * (high - low))


def _edges(value: float, low: float, high: float, size: float) -> tuple[float, float]:
    near = sorted((0.5 * value, 2.0 * value)) if value else [-size, size]
    return (low if np.isfinite(low) else min(near[0], high)), (high if np.isfinite(high) else max(near[1], low))


def best_of(problem: Problem, starts: Floats, costs: Sequence[float], loss: Loss) -> list[Searched]:
    """Minima from the starts with the least costs, the best one first."""
    order = [k for k in np.argsort(costs).tolist() if np.isfinite(costs[k])][:_FOLLOWED]
    return sorted((search(problem, starts[k], loss) for k in order), key=lambda each: each.cost)
