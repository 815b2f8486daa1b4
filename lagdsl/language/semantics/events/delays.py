"""`delay(x, T)`: what x was the time T ago."""

from __future__ import annotations

from dataclasses import replace

from lagdsl.foundation.units.dimension import TIME
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators.arguments import positional
from lagdsl.language.semantics.operators.arrays import elements_of
from lagdsl.language.semantics.operators.event_limits import require
from lagdsl.language.semantics.operators.geometry import operand
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name, kind_of
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import (
    NUMERIC,
    POISON,
    Array,
    Order,
    Poison,
    Scalar,
    Value,
    Vector,
    components,
    rank,
)
from lagdsl.language.semantics.types.bindings import Expected, conform
from lagdsl.language.semantics.variables.resolver import every
from lagdsl.language.syntax import nodes


def delayed(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """A scalar, or an array element by element. It holds at all times, in clauses too, and moves like a rate."""
    arguments = positional(ctx, node, 2, 2)
    if arguments is None:
        return POISON
    with ctx.current.standing():
        value = operand(ctx, ctx.elaborate(ctx, scope, arguments[0], False), arguments[0].span)
    time = _time(ctx, scope, arguments[1])
    if isinstance(value, Poison) or time is None:
        return POISON
    value = components(value) if isinstance(value, Vector) else value
    if not isinstance(value, Scalar | Array) or value.kind not in NUMERIC:
        ctx.sink.report("E0312", arguments[0].span, expected="a number", found=kind_of(value))
        return POISON
    if value.order >= Order.ACCELERATION:
        ctx.sink.report("E0390", arguments[0].span)
        return POISON
    if rank(value.variability) <= rank(Variability.PARAMETER):
        return value
    text, spans = scope.owner.prefix + node.span.text, (node.span, *scope.spans)
    whole = isinstance(value, Scalar)
    places = [()] if isinstance(value, Scalar) else every(value.shape)
    entries = tuple(
        ctx.product.occurrences.delay(text if whole else element_name(text, place), spans, each, time.expression)
        for place, each in zip(places, [value] if isinstance(value, Scalar) else elements_of(value), strict=True)
    )
    moves = replace(value, variability=Variability.CONTINUOUS, order=Order.RATE, kind="Real")
    return replace(moves, expression=entries[0]) if isinstance(moves, Scalar) else replace(moves, elements=entries)


def _time(ctx: Context, scope: Scope, node: nodes.Expression) -> Scalar | None:
    """A positive time that parameters decide; None after a diagnostic."""
    value = ctx.elaborate(ctx, scope, node, True)
    expected = Expected("the delay", ctx.conventions.dimension(TIME), (), code="E0415")
    found = conform(ctx, scope, node, value, expected)
    if not isinstance(found, Scalar):
        return None
    if rank(found.variability) > rank(Variability.PARAMETER):
        ctx.sink.report("E0317", node.span, what="a delay", allowed="parameters and constants")
        return None
    return found if require(ctx, scope, node, "the delay", found, strict=True) else None
