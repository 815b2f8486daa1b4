"""Limits of the arguments of events: checked by the compiler if they are known then, else for each set of
parameters."""

from __future__ import annotations

import math

from lagdsl.flat.events import Limit
from lagdsl.flat.limits import found_wrong
from lagdsl.semantics.scope.constants import NoValue, evaluate
from lagdsl.semantics.scope.context import Context
from lagdsl.semantics.scope.scope import Scope
from lagdsl.semantics.scope.values import Scalar, is_structural
from lagdsl.syntax import nodes


def require(
    ctx: Context,
    scope: Scope,
    node: nodes.Expression,
    what: str,
    value: Scalar,
    *,
    most: float = math.inf,
    strict: bool = False,
) -> bool:
    """True if 0 <= value <= most, with `strict` 0 < value, as far as it is known; False after E0334."""
    limit = Limit(spans=(node.span, *scope.spans), what=what, value=value.expression, most=most, strict=strict)
    if is_structural(value):
        try:
            wrong = found_wrong(limit, evaluate(value.expression))
        except NoValue:
            wrong = None
        if wrong is not None:
            ctx.sink.report("E0334", node.span, what=what, expected=wrong, found=node.span.text)
            return False
    ctx.product.occurrences.limits.append(limit)
    return True
