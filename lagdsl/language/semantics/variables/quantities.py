"""Coordinates, states, inputs and outputs of the flat model, element by element."""

from __future__ import annotations

import math
from typing import Literal, TypedDict, cast

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.source import Span
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.events import Discrete
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Variability, fields_of
from lagdsl.language.semantics.scope.constants import structural_integer
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Indices, Symbol, TypeInfo
from lagdsl.language.semantics.scope.values import Array, Order, Poison, Scalar, rank
from lagdsl.language.semantics.types.bindings import Expected, conform
from lagdsl.language.semantics.types.quantity_fields import quantity_fields
from lagdsl.language.semantics.variables import attributes
from lagdsl.language.semantics.variables.attributes import Attribute
from lagdsl.language.semantics.variables.quaternion import normalisation, rate_starts
from lagdsl.language.semantics.variables.resolver import every


def _extent(ctx: Context, symbol: Symbol) -> tuple[int, ...] | None:
    shape = ctx.resolver.shape(ctx, symbol)
    return shape if symbol.info is not None else None


def _dimension(symbol: Symbol) -> Dimension:
    assert symbol.info is not None
    return symbol.info.dimension or DIMENSIONLESS


def _start(
    ctx: Context,
    symbol: Symbol,
    attribute: Attribute | None,
    what: str,
    dimension: Dimension,
    shape: tuple[int, ...],
    unit: str = "1",
) -> list[FlatExpression] | None:
    """The values of a start attribute, or None where there is none or it is wrong."""
    if attribute is None:
        return None
    return attributes.expressions(ctx, attribute, f"{what} of `{symbol.short}`", dimension, shape, unit=unit)


def coordinates(ctx: Context, symbol: Symbol) -> list[flat_model.Coordinate]:
    shape = _extent(ctx, symbol)
    if shape is None or symbol.info is None:
        return []
    if symbol.given.bindings:
        binding = next(iter(symbol.given.bindings.values()))
        ctx.sink.report("E0302", binding.node.span, name=symbol.short, value=binding.node.span.text)
        return []
    dimension = _dimension(symbol)
    rate_dimension = dimension / ctx.conventions.dimension(TIME)
    found = attributes.attributes(ctx, symbol)
    start = found.get("start")
    starts = _start(ctx, symbol, start, "the start", dimension, shape, symbol.info.unit)
    rate = found.get("der.start")
    rate_unit = unit_of_rate(symbol.info.unit, rate_dimension, 1)
    rates = _start(ctx, symbol, rate, "the start rate", rate_dimension, shape, rate_unit)
    fixed = attributes.flags(ctx, found.get("fixed"), "`fixed`", shape)
    rate_fixed = attributes.flags(ctx, found.get("der.fixed"), "`fixed`", shape)
    if symbol.info.quaternion:
        starts_known = starts or _identity(shape)
        omega = found.get("omega.start")
        if omega is not None and rate is not None:
            ctx.sink.report("E0345", omega.node.span, _label_of(rate), name=symbol.short)
        if omega is not None:
            rates, rate = rate_starts(ctx, symbol, omega, starts_known, shape), omega
            rate_fixed = attributes.flags(ctx, found.get("omega.fixed"), "`fixed`", shape)
        ctx.product.constraints.extend(normalisation(symbol, shape))
    else:
        starts_known = starts or [flat.ZERO] * math.prod(shape)
    rates_known = rates or [flat.ZERO] * math.prod(shape)
    nominal = attributes.numbers(ctx, found.get("nominal"), "`nominal`", dimension, shape)
    least = attributes.numbers(ctx, found.get("min"), "`min`", dimension, shape, unit=symbol.info.unit)
    most = attributes.numbers(ctx, found.get("max"), "`max`", dimension, shape, unit=symbol.info.unit)
    sign = attributes.text(ctx, found.get("symbol"))
    return [
        flat_model.Coordinate(
            **quantity_fields(symbol, indices, sign),
            start=starts_known[k],
            start_explicit=starts is not None,
            fixed=fixed[k],
            rate_start=rates_known[k],
            rate_start_explicit=rates is not None,
            rate_fixed=rate_fixed[k],
            nominal=nominal[k],
            minimum=least[k] if least[k] is not None else symbol.info.minimum,
            maximum=most[k],
            start_span=_span(start),
            rate_start_span=_span(rate),
        )
        for k, indices in enumerate(every(shape))
    ]


def _label_of(attribute: Attribute) -> Label:
    return Label(attribute.node.span, "the rates are given here")


def _span(attribute: Attribute | None) -> Span | None:
    return attribute.node.span if attribute is not None else None


def _identity(shape: tuple[int, ...]) -> list[FlatExpression]:
    return [flat.ONE, flat.ZERO, flat.ZERO, flat.ZERO] * math.prod(shape[:-1])


def states(ctx: Context, symbol: Symbol) -> list[flat_model.State]:
    """States with their equations `der(x) = ...`."""
    shape = _extent(ctx, symbol)
    if shape is None or symbol.info is None:
        return []
    if symbol.given.bindings:
        binding = next(iter(symbol.given.bindings.values()))
        ctx.sink.report("E0338", binding.node.span, name=symbol.short)
        return []
    found = attributes.attributes(ctx, symbol)
    dimension = _dimension(symbol)
    starts = _start(ctx, symbol, found.get("start"), "the start", dimension, shape, symbol.info.unit)
    fixed = attributes.flags(ctx, found.get("fixed"), "`fixed`", shape)
    nominal = attributes.numbers(ctx, found.get("nominal"), "`nominal`", dimension, shape)
    least = attributes.numbers(ctx, found.get("min"), "`min`", dimension, shape, unit=symbol.info.unit)
    most = attributes.numbers(ctx, found.get("max"), "`max`", dimension, shape, unit=symbol.info.unit)
    sign = attributes.text(ctx, found.get("symbol"))
    result = []
    whole = _derivative(ctx, symbol, None, shape) if None in symbol.given.derivatives else None
    for k, indices in enumerate(every(shape)):
        if whole is not None:
            derivative: FlatExpression | None = whole.elements[k] if isinstance(whole, Array) else whole.expression
        else:
            single = _derivative(ctx, symbol, indices, ()) if None not in symbol.given.derivatives else None
            derivative = single.expression if isinstance(single, Scalar) else None
        if derivative is not None:
            state = flat_model.State(
                **quantity_fields(symbol, indices, sign),
                start=starts[k] if starts is not None else flat.ZERO,
                start_explicit=starts is not None,
                fixed=fixed[k],
                derivative=derivative,
                nominal=nominal[k],
                minimum=least[k] if least[k] is not None else symbol.info.minimum,
                maximum=most[k],
            )
            result.append(state)
    return result


def discretes(ctx: Context, symbol: Symbol) -> list[Discrete]:
    """Variables that change at events; their starts default to zero, false and the first of an enumeration."""
    shape = _extent(ctx, symbol)
    if shape is None or symbol.info is None:
        return []
    if symbol.given.bindings:
        binding = next(iter(symbol.given.bindings.values()))
        ctx.sink.report("E0370", binding.node.span, name=symbol.short)
        return []
    found = attributes.attributes(ctx, symbol)
    dimension, info = _dimension(symbol), symbol.info
    start = found.get("start")
    starts = None
    if start is not None:
        what = f"the start of `{symbol.short}`"
        starts = attributes.expressions(ctx, start, what, dimension, shape, unit=info.unit, base=info.base)
    attributes.flags(ctx, found.get("fixed"), "`fixed`", shape)
    least = attributes.numbers(ctx, found.get("min"), "`min`", dimension, shape, unit=symbol.info.unit)
    most = attributes.numbers(ctx, found.get("max"), "`max`", dimension, shape, unit=symbol.info.unit)
    sign = attributes.text(ctx, found.get("symbol"))
    listed = info.base not in ("Real", "Integer", "Boolean")  # a value of an enumeration is the number of its place
    kind = cast(Literal["Real", "Integer", "Boolean"], "Integer" if listed else info.base)
    return [
        Discrete(
            **quantity_fields(symbol, indices, sign),
            start=starts[k] if starts is not None else flat.ONE if listed else flat.ZERO,
            start_explicit=starts is not None,
            kind=kind,
            minimum=least[k] if least[k] is not None else info.minimum,
            maximum=most[k],
        )
        for k, indices in enumerate(every(shape))
    ]


def outputs_of_discretes(items: list[Discrete]) -> list[flat_model.Output]:
    """Outputs of the same names, for discrete variables that are declared `output`."""
    return [
        flat_model.Output(
            **fields_of(item),
            value=flat.Variable(item.name),
            minimum=item.minimum,
            maximum=item.maximum,
        )
        for item in items
    ]


def _derivative(ctx: Context, symbol: Symbol, indices: Indices | None, shape: tuple[int, ...]) -> Scalar | Array | None:
    binding = symbol.given.derivatives.get(indices) or symbol.given.derivatives.get(None)
    if binding is None:
        ctx.sink.report("E0320", symbol.span, name=element_name(symbol.short, indices or ()))
        return None
    value = ctx.elaborate(ctx, binding.scope, binding.node, True)
    if isinstance(value, Poison):
        return None
    dimension = _dimension(symbol) / ctx.conventions.dimension(TIME)
    expected = Expected(f"`der({symbol.short})`", dimension, shape, code="E0415")
    found = conform(ctx, binding.scope, binding.node, value, expected)
    if found is not None and found.order == Order.ACCELERATION:
        ctx.sink.report("E0354", binding.node.span, name=symbol.short)
        return None
    if found is not None and found.order > Order.ACCELERATION:
        ctx.sink.report("E0324", binding.node.span, what=f"`der({symbol.short})`")
        return None
    return found


def inputs(ctx: Context, symbol: Symbol) -> list[flat_model.Input]:
    """Inputs, each followed by the time derivatives it declares with `smooth`."""
    shape = _extent(ctx, symbol)
    if shape is None or symbol.info is None:
        return []
    found = attributes.attributes(ctx, symbol)
    dimension = _dimension(symbol)
    defaults = _default(ctx, symbol, dimension, shape)
    start = None
    if "start" in found:
        what, info = f"the start of `{symbol.short}`", symbol.info
        start = attributes.expressions(ctx, found["start"], what, dimension, shape, unit=info.unit, base=info.base)
    nothing = flat.ZERO if symbol.info.base in ("Real", "Integer", "Boolean") else flat.ONE  # the first literal
    values = defaults or start or [nothing] * math.prod(shape)
    stated = bool(defaults or start)
    smooth = smoothness(ctx, symbol)
    sign = attributes.text(ctx, found.get("symbol"))
    limits = _limits(ctx, found, dimension, shape, symbol.info)
    result = []
    for k, indices in enumerate(every(shape)):
        fields = quantity_fields(symbol, indices, sign)
        result.append(flat_model.Input(**fields, **limits[k], default=values[k], smooth=smooth, stated=stated))
        for level in range(1, smooth + 1):
            rate = quantity_fields(symbol, indices, None)
            base = rate["name"]
            rate["name"] = "der(" * level + base + ")" * level
            rate["dimension"] = fields["dimension"] / ctx.conventions.dimension(TIME) ** level
            rate["unit"], rate["display_unit"] = unit_of_rate(fields["unit"], rate["dimension"], level), None
            integral = "der(" * (level - 1) + base + ")" * (level - 1)
            result.append(flat_model.Input(**rate, default=flat.ZERO, derivative_of=integral))
    return result


def unit_of_rate(unit: str, dimension: Dimension, level: int) -> str:
    return unit_text(dimension) if unit != "rad" else "rad/s" if level == 1 else f"rad/s{level}"


def smoothness(ctx: Context, symbol: Symbol) -> int:
    """Number of times that an input may be differentiated."""
    attribute = attributes.attributes(ctx, symbol).get("smooth")
    if attribute is None:
        return 0
    value = ctx.elaborate(ctx, attribute.scope, attribute.value, False)
    number = structural_integer(ctx, value, attribute.value, "E0317", what="`smooth`", allowed="a number")
    if number and symbol.info is not None and symbol.info.base != "Real":
        ctx.sink.report("E0334", attribute.value.span, what="`smooth`", expected="of a Real", found=str(number))
        return 0
    if number is not None and not 0 <= number <= 10:
        ctx.sink.report("E0334", attribute.value.span, what="`smooth`", expected="0 to 10", found=str(number))
        return 0
    return number or 0


def _default(ctx: Context, symbol: Symbol, dimension: Dimension, shape: tuple[int, ...]) -> list[FlatExpression] | None:
    binding = symbol.given.bindings.get(None)
    if binding is None or symbol.info is None:
        return None
    value = ctx.elaborate(ctx, binding.scope, binding.node, True)
    expected = Expected(f"`{symbol.short}`", dimension, shape, symbol.info.base, symbol.info.unit)
    found = conform(ctx, binding.scope, binding.node, value, expected)
    if found is None:
        return None
    if rank(found.variability) > rank(Variability.PARAMETER):
        what, way = f"the default of input `{symbol.short}`", None
        outside = binding.scope.owner.instance
        if binding.scope is not symbol.scope and symbol.scope.owner.instance is outside:  # from `extends`
            name = symbol.scope.title.strip("`")
            text = " ".join(binding.node.span.text.split())
            way = (
                f"the input of a component takes what varies: in place of `extends {name}(...)` write "
                f"`{name} {_component(name)}({symbol.short} = {text});`"
            )
        ctx.sink.report("E0317", binding.node.span, what=what, allowed="parameters and constants", help=way)
        return None
    return [found.expression] if isinstance(found, Scalar) else list(found.elements)


def _component(name: str) -> str:
    """`a` for `A`, a name for a component of the class."""
    short = name.rpartition(".")[2]
    return short[:1].lower() + short[1:] if not short[:1].islower() else f"{short}_1"


def outputs(ctx: Context, symbol: Symbol) -> list[flat_model.Output]:
    shape = _extent(ctx, symbol)
    if shape is None or symbol.info is None:
        return []
    result = []
    sign = attributes.sign_of(ctx, symbol)
    found = attributes.attributes(ctx, symbol)
    limits = None
    for k, indices in enumerate(every(shape)):
        value = ctx.resolver.element(ctx, symbol, indices, symbol.span)
        if isinstance(value, Scalar):
            fields = quantity_fields(symbol, indices, sign, value.dimension)
            limits = _limits(ctx, found, fields["dimension"], shape, symbol.info) if limits is None else limits
            result.append(flat_model.Output(**fields, **limits[k], value=value.expression))
    return result


class _Limits(TypedDict):
    nominal: float | None
    minimum: float | None
    maximum: float | None


def _limits(
    ctx: Context, found: dict[str, Attribute], dimension: Dimension, shape: tuple[int, ...], info: TypeInfo
) -> list[_Limits]:
    """`nominal`, `min` and `max` of each element; a `min` that is not given is that of the type."""
    nominals = attributes.numbers(ctx, found.get("nominal"), "`nominal`", dimension, shape)
    lowest = attributes.numbers(ctx, found.get("min"), "`min`", dimension, shape, unit=info.unit)
    highest = attributes.numbers(ctx, found.get("max"), "`max`", dimension, shape, unit=info.unit)
    return [
        {"nominal": nominal, "minimum": info.minimum if low is None else low, "maximum": high}
        for nominal, low, high in zip(nominals, lowest, highest, strict=True)
    ]
