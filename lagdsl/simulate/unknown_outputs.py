"""Outputs that are no numbers: told with their expression, at the start and in the rows of a motion."""

from __future__ import annotations

import numpy as np

from lagdsl.diagnostics import Label, Sink
from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.dependence import Dependence
from lagdsl.flat.expression_text import flat_expression_text
from lagdsl.flat.model import FlatModel
from lagdsl.flat.traversal import postorder
from lagdsl.numerics.connected_blocks import Flags
from lagdsl.numerics.rank import Floats
from lagdsl.simulate.state_words import time_text

# So many derivatives of a quantity of this kind come from the equations of motion.
_SOLVED = {"coordinate": 2, "state": 1}


class UnknownOutputs:
    """Finds outputs that are infinite or not a number.

    Where constraints lose rank there are no accelerations and no multipliers for an instant: all outputs that read them
    are nan there, and none is at fault. They are where they are nan in rows that
    follow each other.
    """

    def __init__(self, flat: FlatModel) -> None:
        self._flat = flat
        held = bool(flat.constraints or flat.events.contacts)
        self._solved = np.array([held and reads for reads in _reading(flat)], dtype=np.bool_)

    def first(self, values: Floats, times: Floats) -> tuple[int, int] | None:
        """Row and column of the first one in `values` (rows, outputs) at `times` (rows,)."""
        wrong: Flags = ~np.isfinite(values)
        if self._solved.any() and len(values):
            lost = np.asarray(np.isnan(values[:, self._solved]).all(axis=1))
            wrong[:, self._solved] &= ~_instants(lost, times)[:, None]
        rows = np.flatnonzero(wrong.any(axis=1))
        return (int(rows[0]), int(np.argmax(wrong[rows[0]]))) if len(rows) else None

    def report(self, which: int, time: float, value: float, sink: Sink) -> str:
        """E0857 for an output; returns its name."""
        output = self._flat.outputs[which]
        text = flat_expression_text(output.value)
        label = Label(output.spans[0], f"is {text}"[:120]) if output.spans else None
        found = "not a number" if np.isnan(value) else "infinite"
        sink.report("E0857", label, name=output.name, time=time_text(time), found=found)
        return output.name


def _instants(lost: Flags, times: Floats) -> Flags:
    """Rows (rows,) that are `lost` while their neighbors at other times are not."""
    longer = lost[1:] & lost[:-1] & (times[1:] > times[:-1])
    result = lost.copy()
    result[1:] &= ~longer
    result[:-1] &= ~longer
    return result


def _reading(flat: FlatModel) -> list[bool]:
    """Of every output: it reads accelerations, rates of states or multipliers."""
    kinds = {c.name: "coordinate" for c in flat.coordinates} | {s.name: "state" for s in flat.states}
    dependence = Dependence(flat)
    reading: set[str] = set()

    def reads(expression: fx.FlatExpression) -> bool:
        orders = dependence.of(expression)
        if any(orders[name] >= _SOLVED[kinds[name]] for name in orders.differentiated() if name in kinds):
            return True
        return any(_is_solved(node) or getattr(node, "name", None) in reading for node in postorder(expression, ()))

    for item in flat.named:
        if isinstance(item, fm.Definition) and reads(item.value):
            reading.add(item.name)
    found = []
    for output in flat.outputs:
        found.append(reads(output.value))
        reading |= {output.name} if found[-1] else set()
    return found


def _is_solved(node: fx.FlatExpression) -> bool:
    return isinstance(node, fx.Multiplier | fx.FrameReaction | fx.ReactionAlong)
