"""Costs of many starts, in the threads that make the runs of sweeps."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.engines.runtime.engines.cores import cores
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.fit.problem import Problem, Residuals
from lagdsl.motion.fit.rollout import Rollout
from lagdsl.motion.fit.unknowns import is_parameter
from lagdsl.motion.sweep.plan import Task
from lagdsl.motion.sweep.run import Options, Outcome, SweptModel
from lagdsl.motion.sweep.threads import in_threads

# Rows between which values are interpolated, to compare starts only.
_ROWS = 2000


def costs_of(problem: Problem, starts: Floats, progress: Callable[[float], None] | None = None) -> list[float]:
    """Half the sum of squares for each of the starts (count, unknowns); infinite where there is no motion."""
    if any(series.event for rollout in problem.rollouts for series in rollout.series):
        residuals = Residuals(problem)
        return [0.5 * float(np.sum(residuals(x / problem.sizes) ** 2)) for x in starts]
    costs, first = np.zeros(len(starts)), 0
    for k, (rollout, at) in enumerate(zip(problem.rollouts, problem.places, strict=True)):
        count = sum(len(series.values) for series in rollout.series)
        costs += _costs(rollout, starts[:, list(at)], problem.sigmas[first : first + count])
        first += count
        if progress is not None:
            progress((k + 1) / len(problem.rollouts))
    return [float(each) for each in costs]


def _costs(rollout: Rollout, starts: Floats, sigmas: Floats) -> Floats:
    names = dict.fromkeys(series.name for series in rollout.series)
    first, last = float(rollout.times[0]), float(rollout.times[-1])
    options = Options(
        stop=last,
        interval=(last - first) / _ROWS,
        tolerance=rollout.tolerance,
        solver=rollout.solver,
        engine=rollout.engine.name,
        inputs=rollout.inputs,
        columns=tuple(names),
    )
    slots = [slot.name for slot in rollout.engine.layout.parameters]
    fixed = dict(zip(slots, rollout.p.tolist(), strict=True))
    tasks = [_task(rollout, fixed, index, x) for index, x in enumerate(starts)]
    subject = SweptModel(flat=rollout.flat, program=rollout.program)
    costs = np.full(len(starts), np.inf)
    for outcome in in_threads([subject], options, iter(tasks), len(tasks), cores()):
        costs[outcome.index] = _cost(rollout, outcome, sigmas)
    return costs


def _task(rollout: Rollout, fixed: dict[str, float], index: int, x: Floats) -> Task:
    pairs = list(zip(rollout.unknowns, x.tolist(), strict=True))
    return Task(
        index=index,
        swept=0,
        parameters=fixed | {u.target.key: value for u, value in pairs if is_parameter(u)},
        start={**rollout.start, **{u.target.key: value for u, value in pairs if not is_parameter(u)}},
    )


def _cost(rollout: Rollout, outcome: Outcome, sigmas: Floats) -> float:
    if outcome.status != "ok" or not outcome.ended >= rollout.times[-1]:
        return np.inf
    times = np.linspace(rollout.times[0], rollout.times[-1], len(outcome.values))
    found = [np.interp(s.times, times, outcome.values[:, outcome.names.index(s.name)]) for s in rollout.series]
    measured = np.concatenate([series.values for series in rollout.series])
    cost = 0.5 * float(np.sum(((np.concatenate(found) - measured) / sigmas) ** 2))
    return cost if np.isfinite(cost) else np.inf
