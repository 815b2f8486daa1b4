"""Parameters that are found with the start of the motion: `parameter Length l(fixed = false, start = 1 m)`."""

from __future__ import annotations

from itertools import product as cartesian

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Binding, Symbol
from lagdsl.language.semantics.scope.values import Order, Scalar
from lagdsl.language.semantics.types.quantity_fields import quantity_fields
from lagdsl.language.semantics.variables import attributes
from lagdsl.language.semantics.variables.attributes import Attribute

_GUESSES = ("start", "nominal")


def is_free(ctx: Context, symbol: Symbol, shape: tuple[int, ...]) -> bool:
    """`fixed = false`; E0213 for a guess of a parameter that has a value, E0348 for some elements of an array."""
    if symbol.kind != "parameter":
        return False
    found = attributes.attributes(ctx, symbol)
    fixed = found.get("fixed")
    flags = attributes.flags(ctx, fixed, "`fixed`", shape) if fixed is not None else [True]
    if fixed is not None and any(flags) and not all(flags):
        _refuse(ctx, symbol, fixed, "all elements of an array are free, or none")
    if not all(flags):
        return True
    for name in _GUESSES:
        if name in found:
            ctx.sink.report("E0213", found[name].node.name.span, name=name, what=symbol.title)
    return False


def make(ctx: Context, symbol: Symbol, shape: tuple[int, ...], binding: Binding | None) -> None:
    """Independent parameters whose values are guesses."""
    found, info = attributes.attributes(ctx, symbol), symbol.info
    assert info is not None
    fixed = found["fixed"]
    if info.base != "Real" or symbol.given.final:
        reason = "a `final` one keeps its value" if symbol.given.final else f"this one is of type {info.base}"
        _refuse(ctx, symbol, fixed, reason)
        return
    freed_from_outside = fixed.scope is not symbol.scope
    if binding is not None and not (freed_from_outside and binding.scope is symbol.scope):
        label = Label(fixed.node.span, "free here")
        ctx.sink.report("E0347", binding.node.span, label, name=symbol.short)
        return
    if "start" not in found:
        ctx.sink.report("E0346", fixed.node.span, name=symbol.short)
        return
    dimension = info.dimension or DIMENSIONLESS
    columns = [
        attributes.numbers(
            ctx, found.get(name), f"`{name}`", dimension, shape, unit="1" if name == "nominal" else info.unit
        )
        for name in ("start", "nominal", "min", "max")
    ]
    sign = attributes.text(ctx, found.get("symbol"))
    places = list(cartesian(*(range(1, extent + 1) for extent in shape)))
    for indices, start, nominal, low, high in zip(places, *columns, strict=True):
        if start is None:
            continue
        parameter = flat_model.Parameter(
            **quantity_fields(symbol, indices, sign),
            value=start,
            free=True,
            nominal=nominal,
            minimum=info.minimum if low is None else low,
            maximum=high,
        )
        ctx.product.parameters.append(parameter)
        variable = flat.Variable(parameter.name)
        symbol.made.cells[indices] = Scalar(variable, dimension, Variability.PARAMETER, Order.STILL, "Real")


def _refuse(ctx: Context, symbol: Symbol, fixed: Attribute, reason: str) -> None:
    ctx.sink.report("E0348", fixed.node.span, name=symbol.short, reason=reason)
