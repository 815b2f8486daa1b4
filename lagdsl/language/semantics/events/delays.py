"""`delay(x, T)`: what x was the time T ago."""

from __future__ import annotations

from dataclasses import replace

from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME
from lagdsl.language.flat.expression import Variable
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators.arguments import named_element, positional
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
from lagdsl.language.semantics.types.dimensions import require as require_unit
from lagdsl.language.semantics.variables.resolver import every
from lagdsl.language.syntax import nodes


def delayed(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """A scalar, or an array element by element. It holds at all times, in clauses too, and moves like a rate."""
    arguments = positional(ctx, node, 2, 2)
    if arguments is None:
        return POISON
    value: Value | None = _named(ctx, scope, arguments[0])
    if value is None:
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


def _named(ctx: Context, scope: Scope, node: nodes.Expression) -> Scalar | Array | None:
    """A variable that has no value yet, by its name: it may depend on its own past. One without a unit is a number."""
    is_name = isinstance(node, nodes.Reference | nodes.Member | nodes.Index)
    symbol, indices = (named_element(ctx, scope, node) if is_name else None) or (None, ())
    if symbol is None or symbol.kind != "algebraic" or symbol.info is None or symbol.info.base not in NUMERIC:
        return None
    shape = (ctx.resolver.shape(ctx, symbol) or ())[len(indices) :]
    places = [(*indices, *rest) for rest in every(shape)]
    if all(place in symbol.made.cells for place in places):
        return None
    symbol.made.used = True
    dimension = symbol.info.dimension or DIMENSIONLESS
    ctx.product.occurrences.assumed.append((node, scope, symbol, places[0], dimension))
    variables = tuple(Variable(element_name(symbol.name, place)) for place in places)
    if shape:
        return Array(variables, shape, dimension, Variability.CONTINUOUS, Order.RATE)
    return Scalar(variables[0], dimension, Variability.CONTINUOUS, Order.RATE)


def check_assumed(ctx: Context) -> None:
    """E0407 for variables whose values have other units than their past was taken to have."""
    for node, scope, symbol, indices, dimension in ctx.product.occurrences.assumed:
        value = ctx.resolver.element(ctx, symbol, indices, node.span)
        if isinstance(value, Scalar) and value.dimension is not None and value.dimension != dimension:
            require_unit(
                ctx, scope, node, value.dimension, dimension, "E0407", what=f"`{symbol.short}`, which has no unit,"
            )


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
