"""Derivatives by the rules of the calculus, each subexpression differentiated once.

SymPy's own `diff` gives the same, and a test says so; but it looks through the whole tree at every step, which takes
minutes where frames are nested a few deep. The derivatives of functions are SymPy's (`fdiff`).
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy
from sympy import Add, Expr, Integer, Mul, Symbol

from lagdsl.derivation.textbook.symbols import postorder

_ZERO = Integer(0)


def partial(expression: Expr, symbol: Symbol) -> Expr:
    """The partial derivative with respect to one symbol."""
    return along(expression, {symbol: Integer(1)})


def along(expression: Expr, rates: Mapping[Symbol, Expr]) -> Expr:
    """The chain rule: the sum of partial derivatives times `rates`; symbols without a rate are held."""
    known: dict[Expr, Expr] = dict(rates)
    for node in postorder(expression, known):
        known[node] = _rule(node, [known[argument] for argument in node.args])
    return known[expression]


def _rule(node: Expr, inner: list[Expr]) -> Expr:
    """The derivative of `node`, given those of its arguments."""
    if all(derivative is _ZERO for derivative in inner):
        return _ZERO
    if node.is_Add:
        return Add(*inner)
    if node.is_Mul:
        factors = node.args
        terms = enumerate(inner)
        return Add(*(Mul(*factors[:i], dx, *factors[i + 1 :]) for i, dx in terms if dx is not _ZERO))
    if node.is_Pow:
        return _power(node, *inner)
    return Add(*(node.fdiff(i) * dx for i, dx in enumerate(inner, start=1) if dx is not _ZERO))


def _power(node: Expr, base_rate: Expr, exponent_rate: Expr) -> Expr:
    base, exponent = node.args
    by_base = exponent * base ** (exponent - 1) * base_rate
    return by_base if exponent_rate is _ZERO else by_base + node * sympy.log(base) * exponent_rate
