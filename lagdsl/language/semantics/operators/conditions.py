"""`if c` after an item: a structural condition keeps or drops it, a parameter switches its value."""

from __future__ import annotations

from typing import TypeVar

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators.arithmetic import Operand, boolean
from lagdsl.language.semantics.scope.constants import NoValue, evaluate
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Scalar, Vector, is_structural, latest, rank
from lagdsl.language.syntax import nodes

SwitchedT = TypeVar("SwitchedT", Scalar, Vector)


def condition_of(ctx: Context, scope: Scope, node: nodes.Expression | None) -> Scalar | bool | None:
    """True or False where known while compiling, else the condition of parameters; None after a diagnostic."""
    if node is None:
        return True
    condition = boolean(ctx, Operand(node, ctx.elaborate(ctx, scope, node, False)))
    if condition is None:
        return None
    if is_structural(condition):
        try:
            return evaluate(condition.expression) != 0.0
        except NoValue as fault:
            ctx.sink.report("E0323", node.span, reason=str(fault))
            return None
    if rank(condition.variability) > rank(Variability.PARAMETER):
        ctx.sink.report("E0317", node.span, what="the condition of an item", allowed="parameters and constants")
        return None
    return condition


def structural_condition(ctx: Context, scope: Scope, node: nodes.Expression | None, what: str) -> bool | None:
    """The condition of an item that is there or not: known while compiling."""
    condition = condition_of(ctx, scope, node)
    if isinstance(condition, Scalar) and node is not None:
        ctx.sink.report("E0330", node.span, what=what)
        return None
    return condition if isinstance(condition, bool) else None


def where_active(ctx: Context, scope: Scope, node: nodes.Expression | None, value: SwitchedT) -> SwitchedT | None:
    """The value where the condition and those of the components around hold, else zero.

    A structural condition is true here: false items are dropped.
    """
    condition = condition_of(ctx, scope, node)
    if condition is None:
        return None
    instance = scope.owner.instance
    switches = [each for each, _ in instance.conditions] if instance is not None else []
    if isinstance(condition, Scalar):
        switches.append(condition)
    for switch in reversed(switches):
        value = _under(switch, value)
    return value


def _under(condition: Scalar, value: SwitchedT) -> SwitchedT:
    zero: FlatExpression = flat.ZERO if isinstance(value, Scalar) else flat.ZERO_VECTOR
    expression = flat.Conditional(condition.expression, value.expression, zero)
    variability = latest(value, condition)
    if isinstance(value, Scalar):
        return Scalar(expression, value.dimension, variability, value.order)
    return Vector(expression, value.dimension, variability, value.order)
