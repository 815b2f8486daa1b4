"""Built-in functions of arrays: reductions, constructors, sizes."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, prod

from lagdsl.foundation.numerics.gauss import legendre as legendre_values
from lagdsl.foundation.numerics.gauss import quadrature, quadrature_to
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.semantics.operators.application import Application, same, scalars
from lagdsl.language.semantics.operators.arithmetic import Operand
from lagdsl.language.semantics.operators.arrays import elements_of, reduced, spaced
from lagdsl.language.semantics.scope.constants import structural_integer, structural_number
from lagdsl.language.semantics.scope.limits import array_fits, turns_fit
from lagdsl.language.semantics.scope.naming import kind_of, quantity
from lagdsl.language.semantics.scope.scope import InstanceArray
from lagdsl.language.semantics.scope.values import (
    POISON,
    Array,
    Component,
    Poison,
    Scalar,
    Value,
    Vector,
    components,
    element_at,
    highest,
    latest,
)
from lagdsl.language.semantics.types.dimensions import fits, joined


def reduction(call: Application) -> Value:
    """`sum`, `product`, `min`, `max` of an array, or `min(a, b)`."""
    if len(call.arguments) > 1 and call.name in ("min", "max"):
        return reduced(call.ctx, call.scope, call.name, list(call.arguments), call.node)
    item = call.arguments[0]
    value = components(item.value) if isinstance(item.value, Vector) else item.value
    if len(call.arguments) != 1 or not isinstance(value, Array):
        if not isinstance(value, Poison):
            expected = f"an array in `{call.name}`"
            call.ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(value))
        return POISON
    operands = [Operand(item.node, part) for part in elements_of(value)]
    return reduced(call.ctx, call.scope, call.name, operands, call.node)


def _sizes(call: Application, items: tuple[Operand, ...]) -> list[int] | None:
    sizes = []
    for item in items:
        number = structural_integer(call.ctx, item.value, item.node, "E0301", name=item.node.span.text)
        if number is None:
            return None
        if number < 1:
            call.ctx.sink.report("E0334", item.node.span, what="an array size", expected="positive", found=str(number))
            return None
        sizes.append(number)
    square = sizes * 2 if call.name == "identity" else sizes
    if not array_fits(call.ctx, call.node.span, tuple(square)):
        return None
    return sizes


def filled(call: Application) -> Value:
    """`zeros(n, m)`, `ones(n)`, `fill(x, n, m)`."""
    sizes = _sizes(call, call.arguments[1:] if call.name == "fill" else call.arguments)
    filler = (
        call.arguments[0].value
        if call.name == "fill"
        else Scalar(flat.ZERO if call.name == "zeros" else flat.ONE, None, kind="Integer")
    )
    if sizes is None or not isinstance(filler, Scalar):
        return POISON
    dimension = DIMENSIONLESS if call.name == "ones" else filler.dimension
    return Array(
        (filler.expression,) * prod(sizes), tuple(sizes), dimension, filler.variability, filler.order, filler.kind
    )


def identity(call: Application) -> Value:
    sizes = _sizes(call, call.arguments)
    if sizes is None:
        return POISON
    n = sizes[0]
    parts = tuple(flat.ONE if row == column else flat.ZERO for row in range(n) for column in range(n))
    return Array(parts, (n, n), DIMENSIONLESS, kind="Integer")


def diagonal(call: Application) -> Value:
    array = _array(call, 1)
    if array is None:
        return POISON
    n = array.shape[0]
    if not array_fits(call.ctx, call.node.span, (n, n)):
        return POISON
    parts = tuple(array.elements[row] if row == column else flat.ZERO for row in range(n) for column in range(n))
    return Array(parts, (n, n), array.dimension, array.variability, array.order, array.kind)


def transpose(call: Application) -> Value:
    array = _array(call, 2)
    if array is None:
        return POISON
    rows, columns = array.shape
    parts = tuple(array.elements[row * columns + column] for column in range(columns) for row in range(rows))
    return Array(parts, (columns, rows), array.dimension, array.variability, array.order, array.kind)


def _array(call: Application, rank: int) -> Array | None:
    value = call.arguments[0].value
    if isinstance(value, Array) and len(value.shape) == rank:
        return value
    if not isinstance(value, Poison):
        expected = "a matrix" if rank == 2 else "an array"
        call.ctx.sink.report("E0312", call.arguments[0].node.span, expected=expected, found=kind_of(value))
    return None


def size(call: Application) -> Value:
    """`size(a)` or `size(a, k)`."""
    value = call.arguments[0].value
    if isinstance(value, Poison):
        return POISON
    shape = value.shape if isinstance(value, Array) else (3,) if isinstance(value, Vector) else ()
    if isinstance(value, Component) and isinstance(value.instance, InstanceArray):
        shape = value.instance.shape
    sizes = Array(tuple(flat.Number(float(n)) for n in shape), (len(shape),), DIMENSIONLESS, kind="Integer")
    if len(call.arguments) == 1:
        return sizes
    item = call.arguments[1]
    index = structural_integer(call.ctx, item.value, item.node, "E0333")
    if index is None:
        return POISON
    if not 1 <= index <= len(shape):
        call.ctx.sink.report("E0341", item.node.span, index=index, extent=len(shape))
        return POISON
    return element_at(sizes, index - 1)


def gauss(call: Application) -> Value:
    """`gauss_points(n)` in (0, 1) and `gauss_weights(n)`, which have the sum 1. `gauss_weights(n, x, k)` are for the
    integral of `t^k*f(t)` from 0 to `x`; without `k` it is 0."""
    sizes = _sizes(call, call.arguments[:1])
    upper = [_number(call, "the end", item) for item in call.arguments[1:2]]
    powers = [_power(call, item) for item in call.arguments[2:]]
    if sizes is None or None in upper or None in powers:
        return POISON
    count, power = sizes[0], sum(power for power in powers if power is not None)
    if not turns_fit(call.ctx, call.node.span, (count + power) ** 2):  # of the recurrences
        return POISON
    if call.name == "gauss_points":
        return _numbers(call, quadrature(count)[0])
    ends = [x for x in upper if x is not None]
    return _numbers(call, quadrature_to(ends[0], count, power) if ends else quadrature(count)[1])


def legendre(call: Application) -> Value:
    """`legendre(x, n)`: values at `x` of the `n` first polynomials of Legendre, orthogonal on (0, 1)."""
    x, sizes = _number(call, "the place", call.arguments[0]), _sizes(call, call.arguments[1:])
    return POISON if x is None or sizes is None else _numbers(call, legendre_values(x, sizes[0]))


_KNOWN = "constants and structural parameters"


def _number(call: Application, what: str, item: Operand) -> float | None:
    """A number without a unit that is known while compiling."""
    number = structural_number(call.ctx, item.value, item.node, "E0317", what=what, allowed=_KNOWN)
    if number is not None and isinstance(item.value, Scalar) and not fits(item.value.dimension, DIMENSIONLESS):
        found = quantity(item.value.dimension)
        call.ctx.sink.report("E0402", item.node.span, function=f"`{call.name}`", found=found)
        return None
    return number


def _power(call: Application, item: Operand) -> int | None:
    number = structural_integer(call.ctx, item.value, item.node, "E0317", what="the power", allowed=_KNOWN)
    if number is not None and number < 0:
        call.ctx.sink.report("E0334", item.node.span, what="the power", expected="at least 0", found=str(number))
        return None
    return number


def _numbers(call: Application, values: Sequence[float]) -> Value:
    if not all(isfinite(value) for value in values):
        call.ctx.sink.report("E0323", call.node.span, reason="the number is too large")
        return POISON
    return Array(tuple(flat.Number(value) for value in values), (len(values),), DIMENSIONLESS)


def linspace(call: Application) -> Value:
    ends = call.arguments[:2]
    values = scalars(Application(call.ctx, call.scope, call.name, call.node, ends))
    sizes = _sizes(call, call.arguments[2:])
    if (
        values is None
        or sizes is None
        or not same(Application(call.ctx, call.scope, call.name, call.node, ends), values)
    ):
        return POISON
    if sizes[0] < 2:
        call.ctx.sink.report("E0323", call.node.span, reason="`linspace` needs at least two values")
        return POISON
    start, stop = values
    parts = tuple(spaced(start, stop, sizes[0]))
    return Array(parts, (sizes[0],), joined(start.dimension, stop.dimension), latest(*values), highest(*values))
