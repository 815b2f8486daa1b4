"""All expressions on which others depend, also behind the names of definitions, points and frames."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TypeAlias, assert_never

from lagdsl.foundation.record import remembered
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.traversal import operands, step_expressions

Below: TypeAlias = Callable[[fx.FlatExpression], tuple[fx.FlatExpression, ...]]


def reached(
    flat: fm.FlatModel,
    roots: Iterable[fx.FlatExpression],
    below: Below = operands,
) -> Iterator[fx.FlatExpression]:
    """Every expression below the roots, also behind names, once; `below` gives the operands that are followed."""
    named = _named(flat)
    # Keeps what it has seen: the identity of an expression that nobody holds is given to the next one.
    seen: dict[int, fx.FlatExpression] = {}
    stack = list(roots)
    while stack:
        expression = stack.pop()
        if id(expression) not in seen:
            seen[id(expression)] = expression
            yield expression
            stack += below(expression)
            stack += _behind(expression, named)


@remembered
def _named(flat: fm.FlatModel) -> dict[str, fm.Named]:
    """The items by name: each of many constraints may be followed by itself."""
    return {item.name: item for item in flat.named}


def _behind(expression: fx.FlatExpression, named: dict[str, fm.Named]) -> list[fx.FlatExpression]:
    """Expressions that a name stands for."""
    match expression:
        case fx.Variable(name) | fx.PointReference(name):
            item = named.get(name)
        case fx.OfFrame():
            item = named.get(expression.frame)
        case fx.Number() | fx.Previous() | fx.Derivative() | fx.Operation() | fx.Mechanical() | fx.OfMechanism():
            item = None
        case _:
            assert_never(expression)
    match item:
        case fm.Definition():
            return [item.value]
        case fm.Point():
            return [item.position]
        case fm.Frame():
            found: list[fx.FlatExpression] = [x for step in item.steps for x in step_expressions(step)]
            return [*found, fx.FrameOrigin(item.parent)]
        case None:
            return []
        case _:
            assert_never(item)


def switch(residual: fx.FlatExpression) -> fx.Conditional | None:
    """The conditional that switches a row of a constraint on and off: `(if l > l0 then l - l0 else 0) = 0`."""
    row = residual
    if isinstance(row, fx.Binary) and row.operator == "-" and row.right == fx.ZERO:
        row = row.left
    return row if isinstance(row, fx.Conditional) and fx.ZERO in (row.value, row.otherwise) else None
