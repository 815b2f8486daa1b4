"""`assert(condition, "text", AssertionLevel.warning)`: Modelica 3.6, 8.3.7."""

from __future__ import annotations

from lagdsl.foundation.record import record
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.operators.arguments import named, positional
from lagdsl.language.semantics.operators.arithmetic import Operand, boolean
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Poison, Text
from lagdsl.language.syntax import nodes

_LEVELS = {"AssertionLevel.error": False, "AssertionLevel.warning": True}


@record(kw_only=True)
class Asserted:
    """The arguments, the name of the component before the message; `warning` is True where the motion goes on."""

    condition: FlatExpression
    message: str
    warning: bool


def asserted(ctx: Context, scope: Scope, call: nodes.Call) -> Asserted | None:
    """The arguments of `assert`, or None after what is wrong with them has been told."""
    arguments = positional(ctx, call, 2, 3, ("level",))
    if arguments is None:
        return None
    with ctx.current.without_relations():
        condition = boolean(ctx, Operand(arguments[0], ctx.elaborate(ctx, scope, arguments[0], False)))
    message = ctx.elaborate(ctx, scope, arguments[1], False)
    warning = _is_warning(ctx, arguments[2] if len(arguments) == 3 else named(call, "level"))
    if not isinstance(message, Text):
        if not isinstance(message, Poison):
            ctx.sink.report("E0312", arguments[1].span, expected="a message in quotes", found=kind_of(message))
        return None
    if condition is None or warning is None:
        return None
    text = f"{scope.prefix.rstrip('.')}: {message.value}" if scope.prefix else message.value
    return Asserted(condition=condition.expression, message=text, warning=warning)


def _is_warning(ctx: Context, level: nodes.Expression | None) -> bool | None:
    """False where no level is given; None for something that is no level."""
    if level is None:
        return False
    found = _LEVELS.get(level.span.text)
    if found is None:
        expected = " or ".join(f"`{name}`" for name in _LEVELS)
        ctx.sink.report("E0312", level.span, expected=expected, found=f"`{level.span.text}`")
    return found
