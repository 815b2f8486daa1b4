"""Limits of the arguments of events: checked by the compiler if they are known then, else for each set of
parameters."""

from __future__ import annotations

import math

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.events import Limit
from lagdsl.language.flat.limits import found_wrong
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.scope.constants import NoValue, evaluate
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Scalar, is_structural, latest, rank
from lagdsl.language.syntax import nodes


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


def require_least(
    ctx: Context,
    scope: Scope,
    node: nodes.Expression,
    what: str,
    value: Scalar,
    least: Scalar,
    *,
    than: str = "`limit`",
) -> bool:
    """True if value >= least, as far as it is known; False after E0334."""
    if rank(latest(value, least)) > rank(Variability.PARAMETER):
        return True
    if is_structural(value) and is_structural(least):
        try:
            fits = evaluate(value.expression) >= evaluate(least.expression)
        except NoValue:
            fits = True
        if not fits:
            ctx.sink.report("E0334", node.span, what=what, expected=f"at least {than}", found=node.span.text)
        return fits
    difference = flat.Binary("-", value.expression, least.expression)
    limit = Limit(spans=(node.span, *scope.spans), what=f"{what} minus {than}", value=difference)
    ctx.product.occurrences.limits.append(limit)
    return True
