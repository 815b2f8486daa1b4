"""Parameters and constants: independent numbers, dependent definitions, structural values."""

from __future__ import annotations

import math
from itertools import product as cartesian

from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.finite import is_unbounded
from lagdsl.language.flat.quantity import QuantityFields, Variability
from lagdsl.language.semantics.scope.constants import NoValue, evaluate
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.instance_diagnostics import report_missing
from lagdsl.language.semantics.scope.naming import element_name, kind_of
from lagdsl.language.semantics.scope.scope import Indices, InstanceArray, Symbol
from lagdsl.language.semantics.scope.values import (
    POISON,
    Array,
    Order,
    Poison,
    Scalar,
    Text,
    Value,
    is_structural,
    rank,
)
from lagdsl.language.semantics.types.bindings import Expected, bound
from lagdsl.language.semantics.types.quantity_fields import quantity_fields
from lagdsl.language.semantics.variables import attributes, free_parameters
from lagdsl.language.syntax import nodes

Bounds = tuple[float | None, float | None]

_VARIABILITY = {
    "constant": Variability.CONSTANT,
    "structural": Variability.STRUCTURAL,
    "parameter": Variability.PARAMETER,
}


def make(ctx: Context, symbol: Symbol, shape: tuple[int, ...], key: Indices | None) -> None:
    """Fill the cells of a parameter or constant from its binding."""
    info = symbol.info
    if info is None:
        return
    binding = symbol.given.bindings.get(key) or symbol.given.bindings.get(None)
    if free_parameters.is_free(ctx, symbol, shape):
        free_parameters.make(ctx, symbol, shape, binding)
        return
    if info.base == "String":
        _text(ctx, symbol)
        return
    expected = Expected(f"`{symbol.short}`", info.dimension or DIMENSIONLESS, shape, info.base, info.unit)
    bounds = _bounds(ctx, symbol, expected)
    value: Value | None = (
        _given(ctx, symbol, expected, bounds[0]) if symbol.kind == "structural" and not shape else None
    )
    if value is None:
        if binding is None:
            code = "E0303" if symbol.kind == "parameter" else "E0337"
            report_missing(ctx, code, symbol, symbol.short)
            return
        value = bound(ctx, binding.scope, binding.node, expected)
        if not isinstance(value, Scalar | Array) or not _steady(ctx, symbol, value, binding.node):
            return
    assert isinstance(value, Scalar | Array)
    sign = attributes.text(ctx, attributes.attributes(ctx, symbol).get("symbol"))
    parts = (value.expression,) if isinstance(value, Scalar) else value.elements
    places = list(cartesian(*(range(1, extent + 1) for extent in shape)))
    for part, indices, pair in zip(parts, places, bounds, strict=True):
        cell = Scalar(part, expected.dimension, value.variability, value.order, value.kind)
        symbol.made.cells[indices] = _element(ctx, symbol, indices, cell, pair, quantity_fields(symbol, indices, sign))


def _bounds(ctx: Context, symbol: Symbol, expected: Expected) -> list[Bounds]:
    """Of each element."""
    found = attributes.attributes(ctx, symbol)
    least, most = (
        attributes.numbers(ctx, found.get(name), f"`{name}`", expected.dimension, expected.shape, unit=expected.unit)
        for name in ("min", "max")
    )
    lowest = symbol.info.minimum if symbol.info is not None else None
    return [(lowest if low is None else low, high) for low, high in zip(least, most, strict=True)]


def _given(ctx: Context, symbol: Symbol, expected: Expected, bounds: Bounds) -> Scalar | None:
    """The value of a structural parameter that is set from outside; None where it has that of the model."""
    asked = _parameter(ctx, symbol, quantity_fields(symbol, (), None), math.nan, bounds)
    number = ctx.conventions.structural(asked, lambda: _alike(symbol))
    return None if number is None else Scalar(flat.Number(float(number)), expected.dimension, kind=expected.base)


def _alike(symbol: Symbol) -> list[str]:
    """The names of the parameter in all elements of the arrays of components around it, in their order."""
    steps: list[list[str]] = [[symbol.short]]
    instance = symbol.scope.owner.instance
    while instance is not None and instance.around is not None:
        name = instance.name.rpartition(".")[2].partition("[")[0]
        array = instance.around.owner.entries.get(name)
        shape = array.shape if isinstance(array, InstanceArray) else ()
        steps.insert(0, [element_name(name, each) for each in cartesian(*(range(1, n + 1) for n in shape))])
        instance = instance.around.owner.instance
    return [".".join(path) for path in cartesian(*steps)]


def _kind(ctx: Context, symbol: Symbol) -> str:
    return "parameter" if symbol.kind == "structural" and symbol.name in ctx.conventions.plain else symbol.kind


def _steady(ctx: Context, symbol: Symbol, value: Scalar | Array, node: nodes.Expression) -> bool:
    """A binding must not vary more than what it defines."""
    allowed = _VARIABILITY[_kind(ctx, symbol)]
    if rank(value.variability) <= rank(allowed):
        return True
    words = {"constant": "constants", "structural": "constants and structural parameters"}
    permitted = words.get(symbol.kind, "parameters and constants")
    ctx.sink.report("E0317", node.span, what=f"`{symbol.short}`", allowed=permitted)
    return False


def _element(
    ctx: Context, symbol: Symbol, indices: Indices, value: Scalar, bounds: Bounds, fields: QuantityFields
) -> Scalar | Poison:
    """One scalar: an independent parameter, a dependent one (a definition) or a number folded into expressions."""
    kind = _kind(ctx, symbol)
    name, dimension, variability = fields["name"], fields["dimension"], _VARIABILITY[kind]
    assert symbol.info is not None
    if not is_structural(value) or (symbol.given.final and kind == "parameter"):
        definition = flat_model.Definition(**fields, value=value.expression, variability=variability)
        ctx.product.named.append(definition)
        return Scalar(flat.Variable(name), dimension, variability, Order.STILL, value.kind)
    try:
        number = evaluate(value.expression)
        if math.isinf(number) and not is_unbounded(value.expression):
            raise NoValue("the number is too large")
    except NoValue as fault:
        place = next(iter(symbol.given.bindings.values())).node.span if symbol.given.bindings else symbol.span
        ctx.sink.report("E0323", place, reason=str(fault))
        return POISON
    _check_bounds(ctx, symbol, number, bounds)
    parameter = _parameter(ctx, symbol, fields, number, bounds)
    ctx.product.parameters.append(parameter)
    expression = flat.Number(number) if parameter.structural else flat.Variable(name)
    return Scalar(expression, dimension, variability, Order.STILL, value.kind)


def _parameter(
    ctx: Context, symbol: Symbol, fields: QuantityFields, number: float, bounds: Bounds
) -> flat_model.Parameter:
    kind, base = _kind(ctx, symbol), symbol.info.base if symbol.info is not None else "Real"
    return flat_model.Parameter(
        **fields,
        value=number,
        minimum=bounds[0],
        maximum=bounds[1],
        structural=kind != "parameter",
        constant=kind == "constant",
        kind="Boolean" if base == "Boolean" else "Real" if base == "Real" else "Integer",
    )


def _check_bounds(ctx: Context, symbol: Symbol, number: float, bounds: Bounds) -> None:
    low, high = bounds
    assert symbol.info is not None
    for bound_, outside, word in (
        (low, low is not None and number < low, "min"),
        (high, high is not None and number > high, "max"),
    ):
        if outside and bound_ is not None:
            unit = symbol.info.unit
            shown = f"{number:g}" if unit == "1" else f"{number:g} {unit}"
            limit = f"{bound_:g}" if unit == "1" else f"{bound_:g} {unit}"
            ctx.sink.report("W0328", symbol.span, name=symbol.short, value=shown, which=word, limit=limit)


def _text(ctx: Context, symbol: Symbol) -> None:
    """A String parameter."""
    binding = symbol.given.bindings.get(None)
    if binding is None:
        report_missing(ctx, "E0303", symbol, symbol.short)
        return
    value = ctx.elaborate(ctx, binding.scope, binding.node, False)
    if not isinstance(value, Text):
        if not isinstance(value, Poison):
            ctx.sink.report(
                "E0334", binding.node.span, what=f"`{symbol.short}`", expected="a String", found=kind_of(value)
            )
        return
    fields = quantity_fields(symbol, (), None)
    folded = symbol.kind != "parameter"
    parameter = flat_model.Parameter(
        **fields, value=0.0, structural=folded, constant=symbol.kind == "constant", kind="String", text=value.value
    )
    ctx.product.parameters.append(parameter)
    symbol.made.cells[()] = value
