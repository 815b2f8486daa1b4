"""A fit on one screen: data, unknowns, search, and what follows from its minimum."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from typing import Any

import numpy as np

from lagdsl.engines.runtime.engines.broadcast import BatchEngine
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.fit.data import Measured, Reading
from lagdsl.motion.fit.derivatives import derivatives_of_runs
from lagdsl.motion.fit.findings import findings_of, told
from lagdsl.motion.fit.identifiability import seen_directions
from lagdsl.motion.fit.many_starts import costs_of
from lagdsl.motion.fit.problem import Problem, Residuals, places_of
from lagdsl.motion.fit.result import Fit
from lagdsl.motion.fit.rollout import Derivatives, Rollout, instants, rows_of
from lagdsl.motion.fit.search import LOSSES, Loss, Searched, best_of, sampled, search
from lagdsl.motion.fit.shooting import require_segments, shot
from lagdsl.motion.fit.sigmas import first_sigmas, sigmas_of, with_sigmas
from lagdsl.motion.fit.unknowns import Free, Unknown, bounded, found_targets, of_runs, unknown_of
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.simulate.failure import SimulationFailed

# Passes in which unknown sigmas follow from residuals, and the part by which they may still change.
_PASSES, _SAME = 6, 1e-2
# Of values that data leave open the search comes back to the first ones, so often, and to this part of a size.
_RETURNS, _NEAR = 3, 0.02


@record(kw_only=True)
class RunGiven:
    """One run as it is given: a path or columns by name; values of parameters and starts, and inputs, that are its
    own, in SI units."""

    name: str
    data: Any
    parameters: Mapping[str, float] = field(default_factory=dict)
    start: Mapping[str, float] = field(default_factory=dict)
    inputs: Mapping[str, Signal] = field(default_factory=dict)


@record(kw_only=True)
class Method:
    """Options of a fit. `free` are the unknowns; None: those that the text frees. `own` are names of unknowns that
    each run has for itself, `sigma` standard deviations by name
    as numbers in SI units or texts, `renamed` names of the model by those of columns."""

    free: Free | None = None
    own: Sequence[str] = ()
    sigma: Mapping[str, float | str] = field(default_factory=dict)
    renamed: Mapping[str, str | None] = field(default_factory=dict)
    hold: bool = False
    stop: float | None = None
    tolerance: float | None = None
    solver: str = "auto"
    loss: Loss = "linear"
    starts: int = 1
    segments: int = 1
    seed: int = 0
    confidence: float = 0.95


def fit(
    compilation: Compilation,
    engine: BatchEngine,
    runs: Sequence[RunGiven],
    method: Method,
    sink: Sink,
    *,
    derivatives: Derivatives | None = None,
    progress: Callable[[float], None] | None = None,
) -> Fit:
    """The unknowns of `method` from the data of the runs; warnings go to `sink`, too.

    Raises CompilationFailed for data, names and starts that do not fit and where the motions of the first values do not
    exist, ValueError for options that make no sense.
    """
    _require_sound(method, runs)
    flat = compilation.flat
    own = Sink()
    stated = {each.name: each.of for each in flat.measurements if each.stated}
    read = Reading(flat=flat, renamed={**stated, **method.renamed}, sink=own, hold=method.hold)
    measured = [read.run(run.name, run.data) for run in runs]
    own.raise_if_errors()
    problem = _problem(compilation, engine, runs, measured, method, own, derivatives or derivatives_of_runs())
    own.raise_if_errors()
    given = sigmas_of(flat, method.sigma, problem.all_series, own)
    own.raise_if_errors()
    problem = with_sigmas(problem, first_sigmas(problem, given))
    x = np.array([unknown.value for unknown in problem.unknowns])
    first = _first_values(problem, x, own)
    own.raise_if_errors()
    found = _searched(problem, _shot(problem, x, method.segments, own), method, progress)
    problem, found = _with_own_sigmas(problem, found, method, given)
    found = _nearest(problem, found, x, method.loss)
    result = findings_of(problem, found, first, method.loss, method.confidence, given)
    told(result, problem, found, own)
    for diagnostic in own.diagnostics:
        sink.add(diagnostic)
    return replace(result, notes=own.diagnostics)


def _with_own_sigmas(
    problem: Problem, found: Searched, method: Method, given: Mapping[str, float]
) -> tuple[Problem, Searched]:
    """The same with sigmas that are those of the residuals where none were given; a search goes on only where they
    weigh some series against others in another way."""
    for _ in range(_PASSES):
        robust = method.loss != "linear"
        again = with_sigmas(problem, first_sigmas(problem, given, problem.values(found.x), robust))
        factors, problem = again.sigmas / problem.sigmas, again
        if np.ptp(factors) <= _SAME * np.max(factors) and (not robust or np.max(np.abs(factors - 1.0)) <= _SAME):
            break
        found = search(problem, found.x, method.loss)
    return problem, found


def _nearest(problem: Problem, found: Searched, x: Floats, loss: Loss) -> Searched:
    """Of the minima that data do not tell apart, one that is near to x (unknowns,), where the search began."""
    sizes = problem.sizes
    for _ in range(_RETURNS):
        _, jacobian = problem.differentiated(found.x, exact=True)
        scaled = jacobian * sizes / problem.sigmas[:, None]
        unseen = seen_directions(scaled, problem.derivatives.error)[1]
        away = unseen @ (unseen.T @ ((found.x - x) / sizes))
        if not np.any(np.abs(away) > _NEAR):
            break
        moved = np.clip(found.x - sizes * away, [u.low for u in problem.unknowns], [u.high for u in problem.unknowns])
        again = search(problem, moved, loss) if np.isfinite(Residuals(problem)(moved / sizes)).all() else found
        if again.cost > found.cost + _SAME * max(found.cost, 1.0):
            break
        found = again
    return found


def _require_sound(method: Method, runs: Sequence[RunGiven]) -> None:
    """Raises ValueError."""
    if not runs:
        raise ValueError("a fit needs the data of at least one run")
    if method.loss not in LOSSES:
        raise ValueError(f"there is no loss `{method.loss}`; there are {', '.join(LOSSES)}")
    if method.starts < 1:
        raise ValueError(f"the number of starts must be at least 1, not {method.starts}")
    if method.segments < 1:
        raise ValueError(f"the number of segments must be at least 1, not {method.segments}")
    if not 0.0 < method.confidence < 1.0:
        raise ValueError(f"the confidence {method.confidence:g} must be between 0 and 1")


def _problem(
    compilation: Compilation,
    engine: BatchEngine,
    runs: Sequence[RunGiven],
    measured: Sequence[Measured],
    method: Method,
    sink: Sink,
    derivatives: Derivatives,
) -> Problem:
    flat = compilation.flat
    estimated = [each.name for each in flat.parameters if each.estimated]
    free = bounded(flat, estimated if method.free is None else method.free, sink)
    own = {target.name for target in found_targets(flat, method.own)}
    lost = [name for name in own if name not in free]
    if lost:
        raise ValueError(f"`{lost[0]}` cannot be own to each run, as it is not free")
    values = values_of(flat, engine, runs)
    unknowns = [unknown_of(target, values[0][target.name], low, high, sink) for target, low, high in free.values()]
    spread = [
        each if each.run is None else replace(each, value=values[each.run][each.target.name])
        for each in of_runs(unknowns, own, [run.name for run in runs])
    ]
    places = places_of(spread, len(runs))
    rollouts = tuple(
        _rollout(compilation, engine, run, data, [spread[i] for i in at], method, sink)
        for run, data, at in zip(runs, measured, places, strict=True)
    )
    count = sum(len(series.values) for data in measured for series in data.series)
    if count <= len(spread):
        sink.report("E1104", None, values=count, unknowns=len(spread))
    return Problem(
        rollouts=rollouts, unknowns=tuple(spread), places=places, sigmas=np.ones(count), derivatives=derivatives
    )


def values_of(flat: FlatModel, engine: BatchEngine, runs: Sequence[RunGiven]) -> list[dict[str, float]]:
    """Values of all parameters and starts of each run before the fit, by the names of settings."""
    found = []
    for run in runs:
        p = parameters_of(engine, run)
        t = flat.experiment.start_time
        q, qd, z, _ = (np.asarray(each).tolist() for each in engine.evaluate("start", t, p))
        known = {slot.name: value for slot, value in zip(engine.layout.parameters, p.tolist(), strict=True)}
        known |= {f"{item.name}.start": value for item, value in zip(flat.coordinates, q, strict=True)}
        known |= {f"der({item.name}).start": value for item, value in zip(flat.coordinates, qd, strict=True)}
        known |= {f"{item.name}.start": value for item, value in zip(flat.states, z, strict=True)}
        found.append(known | {f"{name}.start": value for name, value in run.start.items()})
    return found


def parameters_of(engine: BatchEngine, run: RunGiven) -> Floats:
    slots = engine.layout.parameters
    values = {slot.name: value for slot, value in zip(slots, engine.layout.defaults, strict=True)}
    return np.array(list({**values, **run.parameters}.values()), dtype=np.float64)


def _rollout(
    compilation: Compilation,
    engine: BatchEngine,
    run: RunGiven,
    data: Measured,
    unknowns: Sequence[Unknown],
    method: Method,
    sink: Sink,
) -> Rollout:
    """E1103 for values that were measured before the run begins, or after it ends."""
    flat = compilation.flat
    first = flat.experiment.start_time
    times = np.concatenate([series.times for series in data.series])
    outside = times[(times < first) | (times > (np.inf if method.stop is None else method.stop))]
    if len(outside):
        end = "" if method.stop is None else f" and ends at {method.stop:g} s"
        sink.report("E1103", None, run=run.name, time=f"{outside[0]:g}", first=f"{first:g}", end=end)
    last = method.stop
    if last is None and any(series.event for series in data.series):
        # Computed events may come later than those that were measured: the run goes on for as long again.
        last = max(flat.experiment.stop_time, 2.0 * float(np.max(times)) - first)
    rows = rows_of(data.series, first, last)
    if len(rows) < 2:
        sink.report("E1104", None, values=len(times), unknowns=len(unknowns))
    return Rollout(
        name=run.name,
        flat=flat,
        engine=engine,
        program=compilation.program,
        p=parameters_of(engine, run),
        start=run.start,
        inputs={**data.inputs, **run.inputs},
        unknowns=tuple(unknowns),
        series=data.series,
        times=rows,
        tolerance=flat.experiment.tolerance if method.tolerance is None else method.tolerance,
        solver=method.solver,
    )


def _first_values(problem: Problem, x: Floats, sink: Sink) -> Floats:
    """Values (n,) where the search begins; E1107 and E1108 where it cannot."""
    for rollout, at in zip(problem.rollouts, problem.places, strict=True):
        try:
            motion = rollout.motion(x[list(at)], sink=sink)
        except (CompilationFailed, SimulationFailed) as failure:
            for diagnostic in failure.diagnostics:
                sink.add(diagnostic)
            sink.report("E1107", None, run=rollout.name)
            continue
        for series in rollout.series:
            count = len(instants(motion, series.name)) if series.event else len(series.values)
            if count < len(series.values):
                sink.report("E1108", None, run=rollout.name, name=series.name, found=count, measured=len(series.values))
    if sink.has_errors:
        return x
    return problem.values(x)


def _shot(problem: Problem, x: Floats, segments: int, sink: Sink) -> Floats:
    """Unknowns to go on with: x, or what multiple shooting makes of it. Raises CompilationFailed (E1117)."""
    if segments == 1:
        return x
    require_segments(problem.rollouts[0].flat, sink)
    sink.raise_if_errors()
    return shot(problem, x, segments)


def _searched(problem: Problem, x: Floats, method: Method, progress: Callable[[float], None] | None) -> Searched:
    if method.starts == 1:
        return search(problem, x, method.loss, progress)
    starts = np.vstack([x, sampled(problem, method.starts - 1, method.seed)])
    return best_of(problem, starts, costs_of(problem, starts, progress), method.loss)[0]
