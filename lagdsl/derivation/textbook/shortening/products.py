"""Numbers, signs and squares of products, as people write them."""

from __future__ import annotations

from sympy import Expr, Mul, Pow, Rational, igcd, ilcm

from lagdsl.derivation.textbook.polynomial import Polynomial


def content_of(polynomial: Polynomial) -> Rational:
    """The greatest rational number of which all coefficients are whole multiples."""
    values = list(polynomial.values())
    return Rational(igcd(0, *(v.p for v in values)), ilcm(1, *(v.q for v in values)))


def mostly_negative(polynomial: Polynomial) -> bool:
    negative = sum(1 for coefficient in polynomial.values() if coefficient < 0)
    return 2 * negative > len(polynomial)


def turned_positive(polynomial: Polynomial) -> Polynomial:
    return {m: -c for m, c in polynomial.items()} if mostly_negative(polynomial) else polynomial


def numbered(number: Expr, factor: Expr, bracket: Expr) -> Expr:
    """Their product; a number before a sum stays there, which SymPy would multiply out."""
    if bracket == 1 and factor.is_Add and number != 1:
        return Mul(number, factor, evaluate=False)
    return Mul(number, factor, bracket)


def revealed(expression: Expr, hidden: dict[Expr, Expr]) -> Expr:
    """Symbols replaced; a number before a sum stays there, which SymPy would multiply out."""
    if not hidden or expression.is_Atom:
        return hidden.get(expression, expression)
    inner = [revealed(argument, hidden) for argument in expression.args]
    kept = expression.is_Mul and len(inner) == 2 and inner[0].is_Rational and inner[1].is_Add
    return Mul(*inner, evaluate=False) if kept else expression.func(*inner)


def squares(expression: Expr) -> int:
    """Number of squares of sums that are factors in it."""
    return sum(power.base.is_Add and power.exp == 2 for power in expression.atoms(Pow))


def has_root(expression: Expr) -> bool:
    return any(node.exp.is_Rational and not node.exp.is_Integer for node in expression.atoms(Pow))
