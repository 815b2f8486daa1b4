"""The condition behind a residual whose gradient vanishes with it: `x = l` behind `(x - l)^2`."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from lagdsl.foundation.units.dimension import BASE_UNITS, Dimension
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.expression import Binary, Dot, FlatExpression, Function, Norm, Number, Unary, Variable, Vector
from lagdsl.language.flat.expression_text import flat_expression_text, number_text
from lagdsl.language.flat.traversal import operands

_ZERO, _ONE = Number(0.0), Number(1.0)
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


def is_steep(residual: FlatExpression) -> bool:
    """True for a root of what is zero where the residual is: its gradient grows without bound toward there."""
    return any(power < 1 for _, power in _roots(residual, Fraction(1)) if power)


def _roots(residual: FlatExpression, power: Fraction) -> Iterator[_Root]:
    """Of an expression of no known form itself."""
    if isinstance(residual, Binary):
        found = _of_binary(residual, power)
    elif isinstance(residual, Unary) and residual.operator == "-":
        found = [(residual.operand, power)]
    elif isinstance(residual, Function) and residual.name in ("abs", "sqrt"):
        found = [(residual.arguments[0], power if residual.name == "abs" else power / 2)]
    elif isinstance(residual, Norm) and isinstance(residual.vector, Vector):
        found = _of_vector(residual.vector, power)
    elif isinstance(residual, Dot) and isinstance(residual.left, Vector) and residual.left == residual.right:
        found = _of_vector(residual.left, 2 * power)
    else:
        found = []
    for root, of in found:
        yield from _roots(root, of) if of else [(root, of)]
    if not found:
        yield residual, power


def _of_vector(vector: Vector, power: Fraction) -> list[_Root]:
    return [(component, power) for component in (vector.x, vector.y, vector.z) if component != _ZERO]


def _of_binary(node: Binary, power: Fraction) -> list[_Root]:
    left, right = node.left, node.right
    if node.operator == "-":
        if _ZERO in (left, right):
            return [(left if right == _ZERO else right, power)]
        other = right if left == _ONE else left if right == _ONE else None
        if isinstance(other, Function) and other.name == "cos":
            return [(other.arguments[0], Fraction(0))]
    if node.operator == "^" and isinstance(right, Number) and right.value > 0.0:
        return [(left, power * Fraction(right.value))]
    if node.operator == "*" and left == right:
        return [(left, 2 * power)]
    if node.operator == "*" and isinstance(left, Number) and left.value != 0.0:
        return [(right, power)]
    if node.operator == "+" and _is_square(left) and _is_square(right):
        return [(left, power), (right, power)]
    return []


def _is_square(term: FlatExpression) -> bool:
    """A power of an even number, a product with itself, an absolute value, or a sum of such."""
    if isinstance(term, Function):
        return term.name == "abs"
    if not isinstance(term, Binary):
        return False
    left, right = term.left, term.right
    if term.operator == "^":
        return isinstance(right, Number) and right.value > 0.0 and right.value % 2.0 == 0.0
    if term.operator == "*":
        return left == right or (isinstance(left, Number) and _is_square(right))
    return term.operator == "+" and _is_square(left) and _is_square(right)


def _equation(root: FlatExpression, power: Fraction, dimension: Dimension) -> str | None:
    if isinstance(root, Binary) and root.operator == "-" and not _has_numbers(root.left):
        left, right = flat_expression_text(root.left), root.right
        if isinstance(right, Number):
            unit = _unit(dimension, power)
            return None if unit is None else f"{left} = {number_text(right.value)}{unit}"
        if not _has_numbers(right):
            return f"{left} = {flat_expression_text(right)}"
    return None if _has_numbers(root) else f"{flat_expression_text(root)} = 0"


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
