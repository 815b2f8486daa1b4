"""Quaternion coordinates: unit length, and rates from an angular velocity."""

from __future__ import annotations

import math

from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Symbol
from lagdsl.language.semantics.scope.values import balanced_sum
from lagdsl.language.semantics.variables import attributes
from lagdsl.language.semantics.variables.attributes import Attribute


def _leading(shape: tuple[int, ...]) -> list[tuple[int, ...]]:
    """Indices of the quaternions in an array of them; the last dimension are the four components."""
    found: list[tuple[int, ...]] = [()]
    for extent in shape[:-1]:
        found = [(*indices, index) for indices in found for index in range(1, extent + 1)]
    return found


def normalisation(symbol: Symbol, shape: tuple[int, ...]) -> list[flat_model.Constraint]:
    """e*e - 1 = 0 for each quaternion."""
    result = []
    for indices in _leading(shape):
        parts = [flat.Variable(element_name(symbol.name, (*indices, k))) for k in range(1, 5)]
        square = balanced_sum([flat.Binary("*", part, part) for part in parts])
        name = f"norm({element_name(symbol.name, indices)})"
        constraint = flat_model.Constraint(
            spans=(symbol.span, *symbol.scope.spans),
            name=name,
            rows=(name,),
            residuals=(flat.Binary("-", square, flat.ONE),),
            dimension=DIMENSIONLESS,
            level="position",
            normalisation=True,
        )
        result.append(constraint)
    return result


def rate_starts(
    ctx: Context, symbol: Symbol, omega: Attribute, starts: list[FlatExpression], shape: tuple[int, ...]
) -> list[FlatExpression] | None:
    """de/dt = 1/2 e o (0, omega) with omega in the frame's own axes; scalar first (Hamilton's product)."""
    dimension = DIMENSIONLESS / ctx.conventions.dimension(TIME)
    what = f"the start of omega of `{symbol.short}`"
    values = attributes.expressions(ctx, omega, what, dimension, (*shape[:-1], 3), unit="rad/s")
    if values is None:
        return None
    rates: list[FlatExpression] = []
    for k in range(math.prod(shape[:-1])):
        s, x, y, z = _unit(starts[4 * k : 4 * k + 4])
        a, b, c = values[3 * k : 3 * k + 3]
        rates += [
            _half([], [(x, a), (y, b), (z, c)]),
            _half([(s, a), (y, c)], [(z, b)]),
            _half([(s, b), (z, a)], [(x, c)]),
            _half([(s, c), (x, b)], [(y, a)]),
        ]
    return rates


def _unit(e: list[FlatExpression]) -> list[FlatExpression]:
    """e/|e|: the rotation is that of the unit quaternion, and omega belongs to the rotation."""
    if all(isinstance(part, flat.Number) for part in e):
        length = math.hypot(*(part.value for part in e if isinstance(part, flat.Number)))
        if length in (0.0, 1.0):
            return e
        return [flat.Number(part.value / length) for part in e if isinstance(part, flat.Number)]
    size = flat.Function("sqrt", (balanced_sum([flat.Binary("*", part, part) for part in e]),))
    return [part if part == flat.ZERO else flat.Binary("/", part, size) for part in e]


Products = list[tuple[FlatExpression, FlatExpression]]


def _half(plus: Products, minus: Products) -> FlatExpression:
    """Half of a sum of products, without the terms that are zero."""
    terms: list[FlatExpression] = [flat.Binary("*", a, b) for a, b in plus if flat.ZERO not in (a, b)]
    terms += [flat.Unary("-", flat.Binary("*", a, b)) for a, b in minus if flat.ZERO not in (a, b)]
    return flat.Binary("/", balanced_sum(terms), flat.Number(2.0)) if terms else flat.ZERO
