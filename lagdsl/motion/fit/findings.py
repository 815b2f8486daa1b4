"""From the minimum of a fit to its result, and to what is told about it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.display import Display
from lagdsl.motion.fit.identifiability import hidden_of, seen_directions
from lagdsl.motion.fit.problem import Problem
from lagdsl.motion.fit.result import Estimate, Fit, SeriesResiduals
from lagdsl.motion.fit.rollout import Differentiated, Signature
from lagdsl.motion.fit.search import Searched
from lagdsl.motion.fit.statistics import correlation_of, uncertainty, weights_of, whiteness
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.table import called_heads

# Residuals with autocorrelations that are so improbable are not white.
_CHANCE = 0.01
_TOLD = 4  # events
# Residuals below so many tolerances of the values are errors of the integration.
_NOISE = 1e3
# Between directions that change values and those that do not, singular values fall by this factor.
_CLEAR = 1e-4


def findings_of(
    problem: Problem, found: Searched, first: Floats, loss: str, confidence: float, given: Mapping[str, float]
) -> Fit:
    """The result at the minimum `found`; `first` (n,) are the values where the search began."""
    runs, jacobian = problem.differentiated(found.x, exact=True)
    values = np.concatenate([each.values for each in runs])
    residuals = (values - problem.measured) / problem.sigmas
    scaled = jacobian * problem.sizes / problem.sigmas[:, None]
    seen, unseen = seen_directions(scaled, problem.derivatives.error)
    weights = weights_of(loss, residuals)
    sizes = problem.sizes
    found_spread = uncertainty(residuals, scaled, weights, seen, [a == 0 for a in found.active], confidence)
    covariance = found_spread.covariance * np.outer(sizes, sizes)
    estimates = zip(problem.unknowns, found.x.tolist(), (found_spread.halves * sizes).tolist(), strict=True)
    return Fit(
        model=problem.rollouts[0].flat.name,
        estimates=tuple(Estimate(unknown=u, value=x, half=half) for u, x, half in estimates),
        covariance=covariance,
        correlation=correlation_of(covariance),
        confidence=confidence,
        deviation=found_spread.deviation,
        freedom=found_spread.freedom,
        series=_series(problem, runs),
        motions=tuple(each.motion for each in runs),
        hidden=hidden_of(
            [u.label for u in problem.unknowns],
            found.x,
            sizes,
            unseen,
            lambda x: _changed(problem, values, x),
            lambda x: _unseen_at(problem, x, unseen.shape[1]),
        ),
        corners=tuple(
            (unknown.label, rollout.name)
            for rollout, run in zip(problem.rollouts, runs, strict=True)
            for unknown, steady in zip(rollout.unknowns, run.steady, strict=True)
            if not steady
        ),
        notes=(),
        sum_of_squares=float(np.sum(residuals**2)),
        first_sum_of_squares=float(np.sum(((first - problem.measured) / problem.sigmas) ** 2)),
        trials=found.trials,
        converged=found.converged,
    )


def _unseen_at(problem: Problem, x: Floats, count: int) -> Floats | None:
    """So many directions (k, count) in x / sizes that change no value at x; None where there is no motion, and where
    errors of the derivatives hide them."""
    try:
        _, jacobian = problem.differentiated(x, exact=True)
    except (CompilationFailed, SimulationFailed):
        return None
    scaled = jacobian * problem.sizes / problem.sigmas[:, None]
    if not np.isfinite(scaled).all():
        return None
    _, found, across = np.linalg.svd(scaled, full_matrices=False)
    clear = len(found) > count and found[-count] < _CLEAR * found[-count - 1]
    return across[-count:].T if clear else None


def _changed(problem: Problem, values: Floats, x: Floats) -> float:
    """The largest change of a value from `values` (n,) to those of x, as a part of the range of its series."""
    try:
        moved = np.abs(problem.values(x) - values)
    except (CompilationFailed, SimulationFailed):
        return np.inf
    largest, first = 0.0, 0
    for rollout in problem.rollouts:
        for series in rollout.series:
            part = slice(first, first + len(series.values))
            largest = max(largest, float(np.max(moved[part])) / (float(np.ptp(values[part])) or 1.0))
            first = part.stop
    return largest if np.isfinite(largest) else np.inf


def _series(problem: Problem, runs: list[Differentiated]) -> tuple[SeriesResiduals, ...]:
    found, first = [], 0
    for rollout, run in zip(problem.rollouts, runs, strict=True):
        heads, begin = called_heads(rollout.flat), 0
        for series in rollout.series:
            count = len(series.values)
            computed = run.values[begin : begin + count]
            noise = _NOISE * rollout.tolerance * float(np.max(np.abs(computed), initial=0.0))
            is_seen = float(np.max(np.abs(computed - series.values), initial=0.0)) > noise
            found.append(
                SeriesResiduals(
                    run=rollout.name,
                    name=series.name,
                    display=Display("s") if series.event else heads[series.name][3],
                    times=series.times,
                    measured=series.values,
                    computed=computed,
                    sigma=float(problem.sigmas[first]) if count else np.nan,
                    white=whiteness(computed - series.values) if is_seen else np.nan,
                    event=series.event,
                )
            )
            first, begin = first + count, begin + count
    return tuple(found)


def told(result: Fit, problem: Problem, found: Searched, sink: Sink) -> None:
    """W1110 to W1115: what an engineer has to know before using the values."""
    if not found.converged:
        sink.report("W1110", None, trials=found.trials)
    for estimate, side in zip(result.estimates, found.active, strict=True):
        if side:
            unknown = estimate.unknown
            bound = estimate.display(unknown.low if side < 0 else unknown.high)
            which = "lower" if side < 0 else "upper"
            text = f"{bound:.6g} {estimate.display.unit}".rstrip()
            sink.report("W1111", None, name=estimate.name, which=which, bound=text)
    for rollout, orders in zip(problem.rollouts, found.orders, strict=True):
        if len(orders) > 1:
            where = f"along the search: {_order_text(orders[0])} at its begin, {_order_text(orders[-1])} later"
            sink.report("W1112", None, run=rollout.name, where=where)
    for name, run in result.corners:
        sink.report("W1112", None, run=run, where=f"with `{name}` near the value that was found")
    for hidden in result.hidden:
        sink.report("W1113", None, text=str(hidden))
    for series in result.series:
        if series.white < _CHANCE:
            sink.report("W1114", None, run=series.run, name=series.name, chance=f"{series.white:.1g}")
    if found.failures:
        sink.report("W1115", None, count=len(found.failures), trials=found.trials, reason=found.failures[0])


def _order_text(order: Signature) -> str:
    """The first events of an order."""
    first = ", ".join(f"{name} {kind}" for kind, name in order[:_TOLD])
    return f"{first} and {len(order) - _TOLD} more" if len(order) > _TOLD else first or "nothing"
