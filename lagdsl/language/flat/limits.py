"""Limits of what parameters decide: all of it is finite; restitutions, periods of clocks, stiffnesses have bounds."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import remembered
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.language.flat.events import Limit
from lagdsl.language.flat.finite import certainly_finite, check_finite
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.spans import around, place


@remembered
def _sound(flat: FlatModel) -> list[dict[str, float]]:
    """The values of parameters that were found without fault last; none at first."""
    return []


def check_limits(flat: FlatModel, parameters: Mapping[str, float], sink: Sink) -> None:
    """E0334 for each limit that does not hold for these values of parameters, E0329 and E0506 for what they make
    infinite or negative; those left out have their defaults. Only values that follow from parameters that changed since
    nothing was wrong are computed anew."""
    sound = _sound(flat)
    changed = None
    for last in sound[:1]:
        if last == parameters:
            return
        if last.keys() == parameters.keys():
            changed = {name for name, value in parameters.items() if value != last[name]}
    before = len(sink.diagnostics)
    evaluator = Evaluator(flat, Values(variables=parameters))
    check_finite(flat, parameters, evaluator, sink, changed)
    for limit in flat.events.limits:
        try:
            value = evaluator.scalar(limit.value)
        except NotEvaluable:
            continue
        wrong = found_wrong(limit, value)
        if wrong is not None:
            sink.report("E0334", place(limit), *around(limit), what=limit.what, expected=wrong, found=f"{value:g}")
    if len(sink.diagnostics) == before:
        sound[:] = [dict(parameters)]


def certainly_within(flat: FlatModel, changed: Mapping[str, NDArray[np.float64]]) -> NDArray[np.bool_] | bool:
    """True of those values (runs,) of parameters with which `check_limits` and `check_clocks` have nothing to tell,
    where they had nothing to tell before these changed. Of others nothing is known."""
    return not flat.events.limits and not flat.events.clocks and certainly_finite(flat, changed)


def check_clocks(
    flat: FlatModel, parameters: Mapping[str, float], span: tuple[float, float], most: int, sink: Sink
) -> None:
    """E0858 for each clock that ticks more than `most` times in `span` [s]: the run could not end."""
    if not flat.events.clocks:
        return
    evaluator = Evaluator(flat, Values(variables=parameters))
    for clock in flat.events.clocks:
        first, period = evaluator.scalar(clock.start), evaluator.scalar(clock.period)
        length = span[1] - max(span[0], first)
        if length > most * period:
            with np.errstate(all="ignore"):
                ticks = f"{np.float64(length) / period:.3g}"
            sink.report("E0858", place(clock), *around(clock), name=clock.name, ticks=ticks, most=most)


def found_wrong(limit: Limit, value: float) -> str | None:
    """The condition that the value violates; None if it violates none."""
    if limit.strict and math.isinf(value) and value > 0.0:
        return "finite"
    low = value > limit.least if limit.strict else value >= limit.least
    if low and value <= limit.most:
        return None
    if limit.most < math.inf:
        return f"{limit.least:g} to {limit.most:g}"
    return "positive" if limit.strict else f"at least {limit.least:g}"
