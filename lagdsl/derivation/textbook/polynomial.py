"""Sparse polynomials over numbered kernels, exponents of either sign: just enough to multiply out and look at terms."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from sympy import Expr

Monomial: TypeAlias = tuple[tuple[int, int], ...]
"""(kernel, exponent) pairs in ascending order of kernels, no exponent zero."""
Polynomial: TypeAlias = dict[Monomial, Expr]
"""Rational coefficients, none zero."""


def times(left: Monomial, right: Monomial) -> Monomial:
    if not left or not right:
        return left or right
    powers = dict(left)
    for kernel, power in right:
        powers[kernel] = powers.get(kernel, 0) + power
    return tuple(sorted((kernel, power) for kernel, power in powers.items() if power))


def add_term(polynomial: Polynomial, monomial: Monomial, coefficient: Expr) -> None:
    total = polynomial.get(monomial, 0) + coefficient
    if total == 0:
        polynomial.pop(monomial, None)
    else:
        polynomial[monomial] = total


def add_into(total: Polynomial, other: Polynomial) -> None:
    for monomial, coefficient in other.items():
        add_term(total, monomial, coefficient)


def multiply(left: Polynomial, right: Polynomial) -> Polynomial:
    product: Polynomial = {}
    for a, x in left.items():
        for b, y in right.items():
            add_term(product, times(a, b), x * y)
    return product


def folded(polynomial: Polynomial, sum_: Polynomial, kernel: int) -> Polynomial:
    """Every rest*(all terms of the sum) as rest*kernel; the same object where there is none."""
    (lead, leading), *others = sorted(sum_.items(), key=lambda term: -len(term[0]))
    inverse = tuple((index, -power) for index, power in lead)
    result = polynomial
    for monomial in list(polynomial):
        if monomial not in result or any(dict(monomial).get(index, 0) < power for index, power in lead):
            continue
        rest, factor = times(monomial, inverse), result[monomial] / leading
        if all(result.get(times(rest, other)) == factor * coefficient for other, coefficient in others):
            result = dict(result)
            for other in sum_:
                del result[times(rest, other)]
            add_term(result, times(rest, ((kernel, 1),)), factor)
    return result


def exponents(monomial: Monomial, kernels: Sequence[int]) -> tuple[int, ...]:
    powers = dict(monomial)
    return tuple(powers.get(kernel, 0) for kernel in kernels)
