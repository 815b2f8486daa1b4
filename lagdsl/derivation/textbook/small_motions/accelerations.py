"""The equations of motion solved for the accelerations, where that is short."""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Integer, Symbol

from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.small_motions.balance import LONGEST, Balance
from lagdsl.derivation.textbook.small_motions.quotients import solved
from lagdsl.derivation.textbook.tidy import size

LONGEST_SOLUTION = 160


@dataclass(frozen=True, slots=True, kw_only=True)
class Accelerations:
    """`values` are accelerations and multipliers of constraints with what they are equal to; `left_out` are the
    symbols whose solution is not short, and `nonlinear` is true if some equation is not linear in them."""

    values: tuple[tuple[Symbol, Expr], ...]
    left_out: tuple[Symbol, ...]
    nonlinear: bool = False


def accelerations(balance: Balance) -> Accelerations:
    unknowns, residuals = balance.unknowns, balance.residuals
    if any(size(residual) > LONGEST for residual in residuals):
        return Accelerations(values=(), left_out=unknowns)
    matrix = [[balance.tidy(partial(residual, x)) for x in unknowns] for residual in residuals]
    if any(entry.free_symbols & {*unknowns} for row in matrix for entry in row):
        return Accelerations(values=(), left_out=unknowns, nonlinear=True)
    none = dict.fromkeys(unknowns, Integer(0))
    found = solved(balance.tidy, matrix, [-residual.xreplace(none) for residual in residuals])
    short = {x: value for x, value in zip(unknowns, found, strict=True) if value is not None and _is_short(value)}
    return Accelerations(values=tuple(short.items()), left_out=tuple(x for x in unknowns if x not in short))


def _is_short(value: Expr) -> bool:
    return size(value) <= LONGEST_SOLUTION
