"""A polynomial as a sum over what moves: its factor of constants, factored, times it."""

from __future__ import annotations

from collections.abc import Callable

from sympy import Add, Expr

from lagdsl.derivation.textbook.polynomial import Monomial, Polynomial
from lagdsl.derivation.textbook.shortening.products import content_of, numbered

_LARGEST = 100


def by_motion(
    polynomial: Polynomial, is_constant: Callable[[int], bool], factored: Callable[[Polynomial], tuple[Expr, Expr]]
) -> Expr | None:
    """None where no factor is a sum, and where there are too many terms; `factored` gives a number and the rest."""
    groups: dict[Monomial, Polynomial] = {}
    for monomial, coefficient in polynomial.items():
        fixed = tuple(pair for pair in monomial if is_constant(pair[0]))
        moving = tuple(pair for pair in monomial if not is_constant(pair[0]))
        groups.setdefault(moving, {})[fixed] = coefficient
    if len(polynomial) > _LARGEST or all(len(constants) == 1 for constants in groups.values()):
        return None
    brackets: dict[Expr, Polynomial] = {}
    for moving, constants in groups.items():
        content, factor = factored(constants)
        if -factor in brackets:
            content, factor = -content, -factor
        brackets.setdefault(factor, {})[moving] = content
    terms = []
    for factor, part in brackets.items():
        number = content_of(part)
        content, bracket = factored({monomial: c / number for monomial, c in part.items()})
        terms.append(numbered(number * content, factor, bracket))
    return Add(*terms)
