"""Outputs that are no numbers: told with their expression, at the start and in the rows of a motion."""

from __future__ import annotations

import numpy as np

from lagdsl.diagnostics import Label, Sink
from lagdsl.flat.expression_text import flat_expression_text
from lagdsl.flat.model import FlatModel
from lagdsl.numerics.rank import Floats
from lagdsl.simulate.state_words import time_text


def first_unknown(flat: FlatModel, values: Floats) -> tuple[int, int] | None:
    """Row and column of the first output in `values` (rows, outputs) that is infinite or not a number.

    Where constraints lose rank there are no accelerations and no row of outputs: all are nan, none is at fault.
    """
    wrong = ~np.isfinite(values)
    if flat.constraints or flat.events.contacts:
        wrong &= ~np.isnan(values).all(axis=1, keepdims=True)
    rows = np.flatnonzero(wrong.any(axis=1))
    return (int(rows[0]), int(np.argmax(wrong[rows[0]]))) if len(rows) else None


def report_unknown(flat: FlatModel, which: int, time: float, value: float, sink: Sink) -> str:
    """E0857 for an output; returns its name."""
    output = flat.outputs[which]
    text = flat_expression_text(output.value)
    label = Label(output.spans[0], f"is {text}"[:120]) if output.spans else None
    found = "not a number" if np.isnan(value) else "infinite"
    sink.report("E0857", label, name=output.name, time=time_text(time), found=found)
    return output.name
