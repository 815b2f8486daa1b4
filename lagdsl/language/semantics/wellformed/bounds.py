"""`min`, `max`, `nominal` and the start values of coordinates, states and inputs (W0328, E0517)."""

from __future__ import annotations

from typing import TypeAlias

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.admissible import report_outside
from lagdsl.language.flat.evaluate import Evaluator, NotEvaluable, Values
from lagdsl.language.flat.spans import around, place

_Bounded: TypeAlias = fm.Coordinate | fm.State | fm.Input | fm.Output


def check_bounds(flat: fm.FlatModel, sink: Sink) -> None:
    """E0517 for bounds that leave no value and sizes that are none, W0328 for a start value out of bounds."""
    evaluator = Evaluator(flat, Values())
    items: tuple[_Bounded, ...] = (*flat.coordinates, *flat.states, *flat.inputs, *flat.outputs)
    for item in items:
        low, high = item.minimum, item.maximum
        if low is not None and high is not None and low > high:
            sink.report(
                "E0517",
                place(item),
                *around(item),
                name=item.name,
                reason=f"its min {low:g} is larger than its max {high:g}",
            )
        elif item.nominal is not None and not 0.0 < item.nominal < float("inf"):
            reason = f"its nominal size must be positive and finite, found {item.nominal:g}"
            sink.report("E0517", place(item), *around(item), name=item.name, reason=reason)
        elif isinstance(item, fm.Input) or (not isinstance(item, fm.Output) and item.start_explicit):
            try:
                start = evaluator.scalar(item.default if isinstance(item, fm.Input) else item.start)
            except NotEvaluable:
                continue
            report_outside(item, f"{item.name}(start)", start, sink)
