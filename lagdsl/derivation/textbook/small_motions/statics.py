"""Solutions of the equations of equilibrium, one unknown after the other."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from sympy import Add, Expr, Symbol, pi

from lagdsl.derivation.textbook.small_motions.balance import Balance
from lagdsl.derivation.textbook.small_motions.quotients import ratio
from lagdsl.derivation.textbook.small_motions.roots import Condition, NotSolvedError, Root, roots
from lagdsl.derivation.textbook.tidy import TooLargeError, size

_MOST_SOLUTIONS = 8
_LONGEST_ROOT = 60
_LONGEST_EQUATION = 120
_ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class Place:
    """Values of the coordinates that equilibrium determines, and what they need to be real."""

    at: dict[Symbol, Expr] = field(default_factory=dict)
    conditions: tuple[Condition, ...] = ()


def places(balance: Balance, equations: Sequence[Expr], unknowns: Sequence[Symbol]) -> list[Place]:
    """All solutions, in the order of the coordinates; raises NotSolvedError where that is not certain."""
    try:
        found = _solutions(balance, list(equations), tuple(unknowns), Place())
    except (TooLargeError, ZeroDivisionError) as error:
        raise NotSolvedError from error
    settled = [_settled(balance, place, unknowns) for place in found]
    return [place for n, place in enumerate(settled) if all(place.at != other.at for other in settled[:n])]


def _solutions(balance: Balance, equations: list[Expr], unknowns: Sequence[Symbol], place: Place) -> list[Place]:
    left = [e for e in (balance.tidy(e.xreplace(place.at)) for e in equations) if e != 0]
    if not left:
        return [place]
    if any(size(each) > _LONGEST_EQUATION for each in left):
        raise NotSolvedError
    fixed = [e for e in left if not e.free_symbols & {*unknowns}]
    if fixed:
        if any(_is_never_zero(balance, e) for e in fixed):
            return []
        if place.at and not all(vanishes(balance, e) for e in fixed):
            if all(math.isfinite(balance.number(e)) for e in fixed):
                return []
            raise NotSolvedError
        place = replace(place, conditions=(*place.conditions, *(Condition("zero", e) for e in fixed)))
        left = [e for e in left if e not in fixed]
        if not left:
            return [place]
    chosen, split = _choice(balance, left, unknowns)
    others = [e for e in left if e is not chosen]
    result: list[Place] = []
    for x, root in split:
        if size(root.value) > _LONGEST_ROOT:
            raise NotSolvedError
        at = {name: balance.tidy(value.xreplace({x: root.value})) for name, value in place.at.items()} | {x: root.value}
        conditions = place.conditions if root.condition is None else (*place.conditions, root.condition)
        result += _solutions(balance, others, unknowns, Place(at, conditions))
        if len(result) > _MOST_SOLUTIONS:
            raise NotSolvedError
    return result


def _choice(
    balance: Balance, equations: list[Expr], unknowns: Sequence[Symbol]
) -> tuple[Expr, list[tuple[Symbol, Root]]]:
    """An equation whose roots are known, with them: that of the fewest unknowns in a factor, then of fewest roots."""
    found = []
    for number, equation in enumerate(equations):
        try:
            split = list(_split(balance, equation, unknowns))
        except NotSolvedError:
            continue
        found.append((max((present for present, _, _ in split), default=0), len(split), number, split))
    if not found:
        raise NotSolvedError
    _, _, number, split = min(found, key=lambda each: each[:3])
    return equations[number], [(x, root) for _, x, root in split]


def _split(balance: Balance, equation: Expr, unknowns: Sequence[Symbol]) -> Iterator[tuple[int, Symbol, Root]]:
    """Roots of each factor that holds an unknown, with the number of unknowns in it."""
    for factor in balance.tidy.factors(equation):
        present = [x for x in unknowns if x in factor.free_symbols]
        if present:
            yield from ((len(present), x, root) for x, root in _roots_in_one(balance, factor, present))


def _roots_in_one(balance: Balance, factor: Expr, present: Sequence[Symbol]) -> list[tuple[Symbol, Root]]:
    """Roots in the first unknown, from the last one, in which the factor is solved; its own slope must not vanish."""
    for x in reversed(present):
        try:
            found = roots(balance.tidy, factor, x)
        except NotSolvedError:
            continue
        if all(root.condition is None if len(present) > 1 else _is_finite(balance, root) for root in found):
            return [(x, _lowest(balance, root)) for root in found]
    raise NotSolvedError


def _is_finite(balance: Balance, root: Root) -> bool:
    """False where the numbers of the model make a denominator vanish."""
    return root.condition is not None or math.isfinite(balance.number(root.value))


def _lowest(balance: Balance, root: Root) -> Root:
    """Quotients in lowest terms."""
    above, below = root.value.as_numer_denom()
    return root if root.value.atoms(pi) or below == 1 else replace(root, value=ratio(balance.tidy, above, below))


def _settled(balance: Balance, place: Place, unknowns: Sequence[Symbol]) -> Place:
    """In the order of the coordinates, angles without whole turns, conditions in constants alone."""
    at = {x: _without_turns(place.at[x]) for x in unknowns if x in place.at}
    conditions = (Condition(c.kind, balance.tidy(c.value.xreplace(at))) for c in place.conditions)
    return Place(at, tuple(dict.fromkeys(c for c in conditions if not _is_certain(balance, c))))


def _is_certain(balance: Balance, condition: Condition) -> bool:
    """True if SymPy sees that it holds for all real values of the parameters, positive ones where they are so."""
    return condition.kind == "nonnegative" and bool(of_real_values(balance, condition.value).is_nonnegative)


def of_real_values(balance: Balance, value: Expr) -> Expr:
    """With symbols that SymPy knows to be real, positive ones where the parameters are so."""
    positive = balance.tidy.positive
    return value.xreplace(
        {s: Symbol(s.name, **{"positive" if s in positive else "real": True}) for s in value.free_symbols}
    )


def _is_never_zero(balance: Balance, value: Expr) -> bool:
    return bool(of_real_values(balance, value).is_nonzero)


def vanishes(balance: Balance, value: Expr) -> bool:
    """True if it is zero for the values of the parameters, but for rounding."""
    terms = [abs(balance.number(term)) for term in Add.make_args(value.expand())]
    return bool(abs(balance.number(value)) <= _ROUNDING * max(terms))


def _without_turns(value: Expr) -> Expr:
    turns = value / pi
    if not turns.is_Rational:
        return value
    reduced = turns % 2
    return (reduced - 2 if reduced > 1 else reduced) * pi
