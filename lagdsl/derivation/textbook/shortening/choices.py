"""Choices by one condition, merged: (c ? 0 : 1) + (c ? 1 : 0) = 1, wherever terms differ by such choices alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sympy import Expr, Integer, Symbol

from lagdsl.derivation.textbook import functions
from lagdsl.derivation.textbook.polynomial import Monomial, Polynomial, add_term, times
from lagdsl.derivation.textbook.settle import step


def without_twin_choices(polynomial: Polynomial, kernels: Sequence[Expr], kernel: Callable[[Expr], int]) -> Polynomial:
    """Of terms with a choice between numbers by the same condition one is left; the same object where there is none."""
    groups: dict[tuple[Monomial, Expr], list[Monomial]] = {}
    for monomial in polynomial:
        for index, power in monomial:
            if power == 1 and _is_of_numbers(kernels[index]):
                rest = times(monomial, ((index, -1),))
                groups.setdefault((rest, kernels[index].args[0]), []).append(monomial)
    twins = {key: members for key, members in groups.items() if len(members) > 1}
    if not twins:
        return polynomial
    result = dict(polynomial)
    for (rest, condition), members in twins.items():
        if not all(member in result for member in members):
            continue
        own = [(result.pop(member), _choice_of(member, rest, kernels)) for member in members]
        yes, no = (sum((factor * choice.args[k] for factor, choice in own), Integer(0)) for k in (1, 2))
        if yes == no:
            merged = rest
            add_term(result, merged, yes) if yes != 0 else None
            continue
        # One of both is the factor, so that what is left is a choice between 1 and a number.
        factor = yes if yes != 0 else no
        choice = functions.Select(condition, yes / factor, no / factor)
        add_term(result, times(rest, ((kernel(choice), 1),)), factor)
    return result


def _is_of_numbers(expression: Expr) -> bool:
    return isinstance(expression, functions.Select) and all(each.is_Rational for each in expression.args[1:])


def _choice_of(monomial: Monomial, rest: Monomial, kernels: Sequence[Expr]) -> Expr:
    without = dict(rest)
    [index] = [index for index, power in monomial if without.get(index, 0) != power]
    return kernels[index]


def decided(positive: frozenset[Symbol]) -> Callable[[Expr], Expr]:
    """Choices that numbers make, or the signs of positive symbols: l = 0 is false."""
    known = {symbol: Symbol(symbol.name, positive=True) for symbol in positive}

    def made(node: Expr) -> Expr:
        node = step(node)
        if isinstance(node, functions.Equal | functions.Less | functions.LessEqual):
            left, right = node.args
            if left.free_symbols | right.free_symbols <= positive:
                return _of_sign(node, (right - left).xreplace(known))
        return node

    return made


def _of_sign(node: Expr, difference: Expr) -> Expr:
    """The relation if the sign of the right side less the left one is known, else as it is."""
    if difference.is_positive:
        return Integer(not isinstance(node, functions.Equal))
    if difference.is_negative:
        return Integer(0)
    return node
