"""The condition behind a residual whose gradient vanishes with it: `x = l` behind `(x - l)^2`."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from lagdsl.flat import expression as fx
from lagdsl.flat.expression import Binary, Dot, FlatExpression, Function, Norm, Number, Unary, Variable, Vector
from lagdsl.flat.expression_text import flat_expression_text, number_text
from lagdsl.flat.traversal import operands
from lagdsl.units.dimension import BASE_UNITS, Dimension

# An expression that is zero where the residual is, with the power of its unit that the residual has.
_Root = tuple[FlatExpression, Fraction]


def restated(residual: FlatExpression, dimension: Dimension) -> str | None:
    """The equations that hold where `residual` is zero, as the user would write them; None where its form tells none,
    or where they have numbers whose units are lost."""
    roots = list(_roots(residual, Fraction(1)))
    if any(root is residual for root, _ in roots):
        return None
    texts = [_equation(root, power, dimension) for root, power in roots]
    return " and ".join(f"`{text}`" for text in texts if text) if texts and all(texts) else None


def _roots(residual: FlatExpression, power: Fraction) -> Iterator[_Root]:
    match residual:
        case Unary("-", inner) | Binary("-", inner, Number(0.0)) | Binary("-", Number(0.0), inner):
            yield from _roots(inner, power)
        case Binary("^", base, Number(exponent)) if exponent > 0.0:
            yield from _roots(base, power * Fraction(exponent))
        case Binary("*", left, right) if left == right:
            yield from _roots(left, 2 * power)
        case Binary("*", Number(factor), inner) if factor != 0.0:
            yield from _roots(inner, power)
        case Binary("+", left, right) if _is_square(left) and _is_square(right):
            yield from _roots(left, power)
            yield from _roots(right, power)
        case Function("abs", (inner,)):
            yield from _roots(inner, power)
        case Function("sqrt", (inner,)):
            yield from _roots(inner, power / 2)
        case Binary("-", Number(1.0), Function("cos", (angle,))) | Binary("-", Function("cos", (angle,)), Number(1.0)):
            yield angle, Fraction(0)
        case Norm(Vector(x, y, z), _):
            yield from ((component, power) for component in (x, y, z) if component != Number(0.0))
        case Dot(Vector(x, y, z), right) if right == Vector(x, y, z):
            yield from ((component, 2 * power) for component in (x, y, z) if component != Number(0.0))
        case _:
            yield residual, power


def _is_square(term: FlatExpression) -> bool:
    """A power of an even number, a product with itself, or a sum of such."""
    match term:
        case Binary("^", _, Number(exponent)):
            return exponent > 0.0 and exponent % 2.0 == 0.0
        case Binary("*", left, right):
            return left == right or (isinstance(left, Number) and _is_square(right))
        case Binary("+", left, right):
            return _is_square(left) and _is_square(right)
        case Function("abs", _):
            return True
        case _:
            return False


def _equation(root: FlatExpression, power: Fraction, dimension: Dimension) -> str | None:
    match root:
        case Binary("-", left, Number(value)) if not _has_numbers(left):
            unit = _unit(dimension, power)
            return None if unit is None else f"{flat_expression_text(left)} = {number_text(value)}{unit}"
        case Binary("-", left, right) if not _has_numbers(root):
            return f"{flat_expression_text(left)} = {flat_expression_text(right)}"
        case _ if not _has_numbers(root):
            return f"{flat_expression_text(root)} = 0"
        case _:
            return None


def _unit(dimension: Dimension, power: Fraction) -> str | None:
    """The coherent unit of the root of a residual, with a leading blank."""
    if power == 0 or dimension.is_dimensionless:
        return "" if dimension.is_dimensionless else None
    exponents = [Fraction(exponent) / power for exponent in dimension.exponents]
    if any(exponent.denominator != 1 for exponent in exponents):
        return None
    parts = [
        base if exponent == 1 else f"{base}{exponent}"
        for base, exponent in zip(BASE_UNITS, exponents, strict=True)
        if exponent
    ]
    return f" {'.'.join(parts)}"


def _has_numbers(root: FlatExpression) -> bool:
    """True if numbers stand in it that may have had a unit."""
    if isinstance(root, fx.Binary) and root.operator == "^":
        return _has_numbers(root.left)
    if isinstance(root, Number):
        return True
    return not isinstance(root, Variable) and any(_has_numbers(each) for each in operands(root))
