"""Outputs that are no numbers: told with their expression, at the start and in the rows of a motion."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from lagdsl.engines.runtime.engines.engine import Engine, SingularSystem
from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.numerics.rank import Floats, rank
from lagdsl.foundation.record import remembered
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.traversal import postorder
from lagdsl.motion.simulate.state_words import time_text

# So many derivatives of a quantity of this kind come from the equations of motion.
_SOLVED = {"coordinate": 2, "state": 1}
# Singular values below this part of the largest count as lost: those of a row on a singular position, by the runtime's
# own bound of 1e-7 in natural sizes.
_LOST = 1e-6
# The state (2 nq + nz,) of a row, inputs (nu,) and parameters (np,) there.
State: TypeAlias = tuple[Floats, Floats, Floats]


class UnknownOutputs:
    """Finds outputs that are infinite or not a number.

    Where constraints lose rank there are no accelerations for an instant, or multipliers without a limit: outputs that
    read them are nan there, and are not at fault. They are where they are nan in rows that follow each other, or where
    the equations of motion have a solution. Constraints that come and go may be others at the row: there the equations
    are not looked at. `left` are row and column of outputs that were left alone.
    """

    def __init__(self, flat: FlatModel, engine: Engine) -> None:
        self._flat, self._engine = flat, engine
        held = bool(flat.constraints or flat.events.contacts)
        self._solved = np.array([held and reads for reads in _reading(flat)], dtype=np.bool_)
        self.left: list[tuple[int, int]] = []
        self._changing = any(each.of_law or each.switched for each in flat.constraints)

    def first(self, values: Floats, times: Floats, state: Callable[[int], State]) -> tuple[int, int] | None:
        """Row and column of the first one in `values` (rows, outputs) at `times` (rows,); `state` of a row."""
        wrong: Flags = ~np.isfinite(values)
        if self._solved.any() and len(values):
            unknown = np.isnan(values) & self._solved
            instants = _instants(np.asarray(unknown.any(axis=1)), times)
            for row in np.flatnonzero(instants).tolist():
                instants[row] = not self._is_solvable(row, times, state)
            wrong[:, self._solved] &= ~instants[:, None]
            self.left += [(row, column) for row, column in np.argwhere(unknown & instants[:, None]).tolist()]
        rows = np.flatnonzero(wrong.any(axis=1))
        return (int(rows[0]), int(np.argmax(wrong[rows[0]]))) if len(rows) else None

    def _is_solvable(self, row: int, times: Floats, state: Callable[[int], State]) -> bool:
        """True if accelerations and multipliers exist at this row, and rank is not less than beside it."""
        if self._changing:
            return False
        engine, n = self._engine, len(self._flat.coordinates)
        ranks = []
        for each in sorted({max(row - 1, 0), row, min(row + 1, len(times) - 1)}, key=lambda other: other != row):
            t, (x, u, p) = float(times[each]), state(each)
            w = engine.evaluate("discrete_start", t, p)[0] if engine.layout.discretes else np.zeros(0)
            arguments = (t, x[:n], x[n : 2 * n], x[2 * n :], u, w, p)
            try:
                found = engine.solve(*arguments)
            except SingularSystem:
                return False
            if not all(bool(np.isfinite(values).all()) for values in found):
                return False
            ranks.append(rank(engine.evaluate("velocity_constraint", *arguments)[1], _LOST))
        return ranks[0] == max(ranks)

    def note(self, which: int, time: float) -> str:
        """A note for an output that was left alone."""
        name = self._flat.outputs[which].name
        return f"the constraints lose rank at t = {time_text(time)} s, where `{name}` has no limit and is nan"

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


@remembered
def _reading(flat: FlatModel) -> tuple[bool, ...]:
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
    return tuple(found)


def _is_solved(node: fx.FlatExpression) -> bool:
    return isinstance(node, fx.Multiplier | fx.FrameReaction | fx.ReactionAlong)
