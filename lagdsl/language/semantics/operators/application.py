"""A call of a built-in function with its elaborated arguments."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.foundation.record import record
from lagdsl.language.semantics.operators.arithmetic import Operand
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import NUMERIC, Array, Numeric, Poison, Scalar, Vector
from lagdsl.language.semantics.types.dimensions import fits, report_unequal
from lagdsl.language.syntax import nodes


@record()
class Application:
    """A call with its elaborated arguments."""

    ctx: Context
    scope: Scope
    name: str
    node: nodes.Call
    arguments: tuple[Operand, ...]

    @property
    def numeric(self) -> tuple[Numeric, ...]:
        return tuple(item.value for item in self.arguments if isinstance(item.value, Scalar | Vector | Array))


def scalars(call: Application) -> list[Scalar] | None:
    """All arguments as real scalars, or None after a diagnostic."""
    found: list[Scalar] = []
    for item in call.arguments:
        if isinstance(item.value, Scalar) and item.value.kind in NUMERIC:
            found.append(item.value)
        elif not isinstance(item.value, Poison):
            expected = f"a scalar in `{call.name}`"
            call.ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(item.value))
    return found if len(found) == len(call.arguments) else None


def same(call: Application, values: Sequence[Scalar]) -> bool:
    """All arguments of one dimension, or E0401."""
    for item, value in zip(call.arguments[1:], values[1:], strict=True):
        if not fits(values[0].dimension, value.dimension):
            left, right = (call.arguments[0].node, values[0].dimension), (item.node, value.dimension)
            report_unequal(call.ctx, f"use together in `{call.name}`", call.scope, left, right)
            return False
    return True
