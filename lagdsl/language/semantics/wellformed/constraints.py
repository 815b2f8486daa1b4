"""Constraints that no coordinate enters, or all only through jumps: `sign(x) = 1` (E0609).

The gradient of such a row is zero wherever it exists. Ranks do not show that of rows with relations, because rows that
hold at some times only are left out of them.
"""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.reached import reached
from lagdsl.language.flat.spans import around, place
from lagdsl.language.flat.traversal import operands

_STEPS = ("sign", "floor", "ceil")
_RELATIONS = ("<", "<=", ">", ">=", "==", "<>", "and", "or")
_JUMPS = "is zero, because the coordinates change it in jumps only"
_ABSENT = "is zero, because no coordinate enters it"
_HELP = 'write a condition that is to be watched as `assert(..., "text")`; a constraint equates what coordinates move'


def check_constraints(flat: fm.FlatModel, sink: Sink) -> None:
    """E0609 for each row that changes, but not continuously with the coordinates."""
    coordinates = {item.name for item in flat.coordinates}
    events = flat.events
    changing = coordinates | {"time"} | {item.name for item in (*flat.states, *flat.inputs, *events.discretes)}
    changing |= {each.name for each in events.relations} | {each.name for each in events.timed}
    for constraint in flat.constraints:
        if constraint.of_law or constraint.closure is not None:
            continue
        for row, residual in zip(constraint.rows, constraint.residuals, strict=True):
            if not _tied(flat, residual, coordinates):
                names = {x.name for x in reached(flat, [residual]) if isinstance(x, fx.Variable)}
                if names & changing:
                    fault = _JUMPS if names & coordinates or _turned(flat, names, coordinates) else _ABSENT
                    sink.report("E0609", place(constraint), *around(constraint), help=_HELP, name=row, fault=fault)


def _turned(flat: fm.FlatModel, names: set[str], coordinates: set[str]) -> bool:
    """True if a relation among `names` depends on coordinates."""
    differences = [each.difference for each in flat.events.relations if each.name in names]
    return any(isinstance(x, fx.Variable) and x.name in coordinates for x in reached(flat, differences))


def _tied(flat: fm.FlatModel, residual: fx.FlatExpression, coordinates: set[str]) -> bool:
    """True if a coordinate or rate reaches the value on a way without jumps."""
    return any(
        isinstance(x, fx.Mechanical) or (isinstance(x, fx.Variable) and x.name in coordinates)
        for x in reached(flat, [residual], _without_steps)
    )


def _without_steps(expression: fx.FlatExpression) -> tuple[fx.FlatExpression, ...]:
    """The operands on which the value depends continuously."""
    if isinstance(expression, fx.Conditional):
        return (expression.value, expression.otherwise)
    if isinstance(expression, fx.Function) and expression.name in _STEPS:
        return ()
    if isinstance(expression, fx.Binary) and expression.operator in _RELATIONS:
        return ()
    return operands(expression)
