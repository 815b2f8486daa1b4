"""Measurements name columns of the results, and no name stands for two (E0363, E0364)."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.quantity import Measurement
from lagdsl.language.flat.spans import place


def check_measurements(model: fm.FlatModel, sink: Sink) -> None:
    """E0363 for quantities without a column, E0364 for two meanings of one."""
    columns = {item.name for item in (*model.coordinates, *model.states, *model.outputs, *model.events.discretes)}
    columns |= {f"der({item.name})" for item in model.coordinates}
    seen: dict[str, Measurement] = {}
    for each in model.measurements:
        span = place(each)
        if not each.event and each.of not in columns:
            sink.report("E0363", span, text=each.of, why="it is no column of the results")
        before = place(seen[each.name]) if each.name in seen else None
        if before is not None:
            sink.report("E0364", span, Label(before, "and here"), name=each.name)
        seen[each.name] = each
