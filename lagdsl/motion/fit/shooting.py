"""Multiple shooting: motions cut into segments, whose first states are unknowns, too.

Over a short time a motion depends mildly on its parameters, though over a long one it may be chaotic or unstable. The
jumps between segments are made to vanish, ever more strictly, and the search then goes on with whole motions: H. G.
Bock, in Modelling of Chemical Reaction Systems, Springer 1981, 102.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from scipy.optimize import least_squares

from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.target import targets
from lagdsl.motion.fit.data import Series
from lagdsl.motion.fit.problem import Problem
from lagdsl.motion.fit.rollout import Rollout
from lagdsl.motion.fit.unknowns import Unknown, is_parameter
from lagdsl.motion.simulate.failure import SimulationFailed

# Weights of the jumps, in parts of the ranges of states, beside residuals in standard deviations.
_WEIGHTS = (1.0, 10.0, 1e2, 1e3, 1e4)
_ENDS = 1e-6
_MOST_TRIALS = 50


@record(kw_only=True)
class _Segment:
    """A part of a run: its unknowns are at `places` of all, its last row is the first state, at `next`, of the segment
    after it (none: the run ends). `measured` and `sigmas` (n,) are of the data in it."""

    rollout: Rollout
    places: tuple[int, ...]
    next: tuple[int, ...]
    measured: Floats
    sigmas: Floats


def require_segments(flat: FlatModel, sink: Sink) -> None:
    """E1117 for a model whose state is more than its coordinates, rates and states."""
    events = flat.events
    found = {
        "a contact": events.contacts,
        "dry friction": events.frictions,
        "a clock": events.clocks,
        "a discrete variable": events.discretes,
        "a relation": events.relations,
        "a jump at a time": events.timed,
        "a constraint": flat.constraints,
    }
    for what, items in found.items():
        if items:
            sink.report("E1117", None, what=what)
            return


def shot(problem: Problem, x: Floats, count: int) -> Floats:
    """Unknowns (k,) near the minimum, from x, with every run in `count` segments."""
    joint = list(problem.unknowns)
    values = x.tolist()
    segments: list[_Segment] = []
    first = 0
    for rollout, at in zip(problem.rollouts, problem.places, strict=True):
        own = sum(len(series.values) for series in rollout.series)
        segments += _segments(rollout, at, x, count, problem.sigmas[first : first + own], joint, values)
        first += own
    sizes = np.array([unknown.size for unknown in joint])
    low = np.array([unknown.low for unknown in joint]) / sizes
    high = np.array([unknown.high for unknown in joint]) / sizes
    s = np.array(values) / sizes
    for weight in _WEIGHTS:
        shooting = _Shooting(problem, segments, sizes, weight)
        found: Any = least_squares(
            shooting.residuals,
            s,
            jac=shooting.jacobian,
            bounds=(low, high),
            method="trf",
            ftol=_ENDS,
            xtol=_ENDS,
            gtol=_ENDS,
            max_nfev=_MOST_TRIALS,
        )
        s = found.x
    return np.asarray((s * sizes)[: len(x)])


class _Shooting:
    """Residuals of the data and jumps between the segments, by the scaled unknowns."""

    def __init__(self, problem: Problem, segments: Sequence[_Segment], sizes: Floats, weight: float) -> None:
        self._problem, self._segments, self._sizes, self._weight = problem, segments, sizes, weight

    def residuals(self, s: Floats) -> Floats:
        """Infinite where a segment has no motion."""
        x, found = s * self._sizes, []
        for each in self._segments:
            try:
                values = each.rollout.observed(each.rollout.motion(x[list(each.places)]))
            except (CompilationFailed, SimulationFailed):
                values = np.full(len(each.measured) + len(each.next), np.inf)
            count, after = len(each.measured), list(each.next)
            found.append((values[:count] - each.measured) / each.sigmas)
            found.append(self._weight * (values[count:] - x[after]) / self._sizes[after])
        return np.concatenate(found)

    def jacobian(self, s: Floats) -> Floats:
        """(residuals, unknowns)."""
        x, rows = s * self._sizes, []
        for each in self._segments:
            found = self._problem.derivatives(each.rollout, x[list(each.places)]).jacobian
            count, after = len(each.measured), list(each.next)
            whole = np.zeros((len(found), len(s)))
            whole[:, list(each.places)] = found * self._sizes[list(each.places)]
            whole[:count] /= each.sigmas[:, None]
            whole[count:] *= self._weight / self._sizes[after][:, None]
            whole[count + np.arange(len(after)), after] -= self._weight
            rows.append(whole)
        return np.vstack(rows)


def _segments(
    rollout: Rollout,
    at: tuple[int, ...],
    x: Floats,
    count: int,
    sigmas: Floats,
    joint: list[Unknown],
    values: list[float],
) -> list[_Segment]:
    """Segments of one run; their first states are added to the unknowns `joint`, with `values` to begin with."""
    edges = np.linspace(rollout.times[0], rollout.times[-1], count + 1)
    states = list(targets(rollout.flat, ("start",)).values())
    guesses = [_guesses(rollout, target.key, edges[1:-1], x[list(at)]) for target in states]
    nodes: list[tuple[int, ...]] = []
    for k in range(count - 1):
        nodes.append(tuple(range(len(joint), len(joint) + len(states))))
        for target, guess in zip(states, guesses, strict=True):
            size = float(np.ptp(guess)) or float(np.max(np.abs(guess))) or 1.0
            label = f"{target.name} after {edges[k + 1]:g} s of {rollout.name}"
            joint.append(Unknown(target=target, label=label, value=guess[k], low=-np.inf, high=np.inf, size=size))
            values.append(float(guess[k]))
    found = []
    for k in range(count):
        own = [i for i in at if k == 0 or is_parameter(joint[i])] + list(nodes[k - 1] if k else ())
        after = nodes[k] if k < count - 1 else ()
        found.append(_segment(rollout, edges, k, own, after, sigmas, joint))
    return found


def _segment(
    rollout: Rollout,
    edges: Floats,
    k: int,
    own: Sequence[int],
    after: tuple[int, ...],
    sigmas: Floats,
    joint: Sequence[Unknown],
) -> _Segment:
    begin, end, last = edges[k], edges[k + 1], k == len(edges) - 2
    parts: list[Series] = []
    kept: list[Floats] = []
    first = 0
    for series in rollout.series:
        inside = (series.times >= begin) & ((series.times < end) | last)
        parts.append(replace(series, times=series.times[inside], values=series.values[inside]))
        kept.append(sigmas[first : first + len(series.values)][inside])
        first += len(series.values)
    states = [Series(name=joint[i].target.key, times=np.array([end]), values=np.zeros(1)) for i in after]
    times = np.unique(np.concatenate([[begin, end], *(part.times for part in parts)]))
    experiment = replace(rollout.flat.experiment, start_time=float(begin))
    return _Segment(
        rollout=replace(
            rollout,
            name=f"{rollout.name}, segment {k + 1}",
            flat=replace(rollout.flat, experiment=experiment),
            start=rollout.start if k == 0 else {},
            unknowns=tuple(joint[i] for i in own),
            series=(*parts, *states),
            times=times,
        ),
        places=tuple(own),
        next=after,
        measured=np.concatenate([part.values for part in parts]),
        sigmas=np.concatenate(kept),
    )


def _guesses(rollout: Rollout, name: str, times: Floats, x: Floats) -> Floats:
    """Values of a state at `times`: those that were measured, for a rate the slope of them, else those of the motion
    with the first values."""
    for series in rollout.series:
        if series.name == name:
            return np.interp(times, series.times, series.values)
    for series in rollout.series:
        if name == f"der({series.name})" and len(series.times) > 1:
            return np.interp(times, series.times, np.gradient(series.values, series.times))
    motion = rollout.motion(x)
    return np.interp(times, motion.time, motion[name])
