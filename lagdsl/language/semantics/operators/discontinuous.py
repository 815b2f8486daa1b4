"""Discontinuities as they are met: a later pass decides what becomes of them (`semantics/discontinuities`)."""

from __future__ import annotations

from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Spans, Variability
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.product import Met, Pieces
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import AnyDimension, Numeric, Order, highest, latest
from lagdsl.language.syntax import nodes


def relation(
    ctx: Context, spans: Spans, text: str, truth: FlatExpression, dimension: AnyDimension, order: Order
) -> FlatExpression:
    """A truth that changes at events only, which are where the sides of the relation meet. `text` names it."""
    found = Met(
        expression=truth, function="", text=text, spans=spans, dimension=dimension or DIMENSIONLESS, order=order
    )
    ctx.product.met.append(found)
    return truth


def met(
    ctx: Context,
    scope: Scope,
    node: nodes.Node,
    function: str,
    expression: FlatExpression,
    *values: Numeric,
    text: str | None = None,
    located: bool = True,
    pieces: Pieces | None = None,
) -> FlatExpression:
    """The same expression, remembered where `values` change, on which its branches depend. `text` is that of the node
    unless given. Not `located`: no instant is searched for."""
    if latest(*values) not in (Variability.DISCRETE, Variability.CONTINUOUS):
        return expression
    found = Met(
        expression=expression,
        function=function,
        text=scope.owner.prefix + (text or node.span.text),
        spans=(node.span, *scope.spans),
        dimension=next((value.dimension for value in values if value.dimension is not None), DIMENSIONLESS),
        order=highest(*values),
        located=located and not ctx.current.quiet,
        pieces=pieces,
        moves=moves(*values),
    )
    ctx.product.met.append(found)
    return expression


def moves(*values: Numeric) -> bool:
    """True for what changes between events."""
    return latest(*values) == Variability.CONTINUOUS
