"""Limits of what parameters decide: all of it is finite; restitutions, periods of clocks, stiffnesses have bounds."""

from __future__ import annotations

import math
from collections.abc import Mapping

from lagdsl.diagnostics import Sink
from lagdsl.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.flat.events import Limit
from lagdsl.flat.finite import check_finite
from lagdsl.flat.model import FlatModel
from lagdsl.flat.spans import around, place


def check_limits(flat: FlatModel, parameters: Mapping[str, float], sink: Sink) -> None:
    """E0334 for each limit that does not hold for these values of parameters, E0329 and E0506 for what they make
    infinite or negative; those left out have their defaults."""
    evaluator = Evaluator(flat, Values(variables=parameters))
    check_finite(flat, parameters, evaluator, sink)
    for limit in flat.events.limits:
        try:
            value = evaluator.scalar(limit.value)
        except NotEvaluable:
            continue
        wrong = found_wrong(limit, value)
        if wrong is not None:
            sink.report("E0334", place(limit), *around(limit), what=limit.what, expected=wrong, found=f"{value:g}")


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
