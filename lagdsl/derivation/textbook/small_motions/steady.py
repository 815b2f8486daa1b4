"""Steady motions: ignorable coordinates have constant rates, all other coordinates are at rest.

Goldstein, Poole, Safko, *Classical Mechanics* (2002), 5.7 and 8.3; the conical pendulum is the oldest one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from sympy import Expr, Float, Integer, Symbol

from lagdsl.derivation.textbook.small_motions.balance import Balance
from lagdsl.derivation.textbook.small_motions.linear import SingularError, regular
from lagdsl.derivation.textbook.small_motions.roots import NotSolvedError
from lagdsl.derivation.textbook.small_motions.statics import Place, places
from lagdsl.derivation.textbook.tidy import TooLargeError

_ROUNDING = 1e-9
_RATE, _DIGITS = 3.3517, 30


@dataclass(frozen=True, slots=True, kw_only=True)
class Steady:
    """The `rates` are constant and free; the `equations` are what is left of the equations of motion then, and `places`
    all values of the other coordinates that satisfy them, at which the mass matrix has an inverse."""

    rates: tuple[Symbol, ...]
    equations: tuple[Expr, ...]
    places: tuple[Place, ...]


def steady(balance: Balance, residuals: Sequence[Expr]) -> Steady | None:
    """None where no coordinate is ignorable, its rate holds nothing, or the roots are not short.

    `residuals` are those of the equations of motion, one for each coordinate, without constraints.
    """
    table = balance.derivation.symbols
    present = {symbol for each in residuals for symbol in each.free_symbols}
    turning = [(q, qd) for q, qd in zip(table.q, table.qd, strict=True) if q not in present and qd in present]
    rates = tuple(qd for _, qd in turning)
    ignorable = {q for q, _ in turning}
    others = [q for q in table.q if q not in ignorable and q in present]
    values = {rate: _RATE * (number + 1) for number, rate in enumerate(rates)}
    balance = replace(balance, numbers={**balance.numbers, **values})
    rest = {x: Integer(0) for x in (*table.qd, *table.qdd) if x not in rates}
    try:
        equations = tuple(e for e in (balance.tidy(each.xreplace(rest)) for each in residuals) if e != 0)
        if not others or not any(e.free_symbols & {*rates} for e in equations):
            return None
        found = [each for each in places(balance, equations, others) if _is_regular(balance, residuals, each)]
    except (NotSolvedError, TooLargeError, ZeroDivisionError):
        return None
    lasting = tuple(each for each in found if _holds(balance, equations, each))
    needed = tuple(rate for rate in rates if any(rate in e.free_symbols for e in equations))
    return Steady(rates=needed, equations=equations, places=lasting) if lasting else None


def _is_regular(balance: Balance, residuals: Sequence[Expr], place: Place) -> bool:
    try:
        regular(balance, residuals, place.at)
    except SingularError:
        return False
    return True


def _holds(balance: Balance, equations: Sequence[Expr], place: Place) -> bool:
    """True if the equations hold at the rates that `balance` has; beyond the reals, too, where a condition is not
    fulfilled."""
    numbers = {symbol: Float(value, _DIGITS) for symbol, value in balance.numbers.items()}
    try:
        for equation in equations:
            there = [each.xreplace(place.at).xreplace(numbers) for each in equation.expand().as_ordered_terms()]
            terms = [complex(each.evalf(_DIGITS)) for each in there]
            if not abs(sum(terms)) <= _ROUNDING * max(map(abs, terms)):
                return False
    except (TypeError, ValueError, OverflowError):  # an input without a value, a pole
        return False
    return True
