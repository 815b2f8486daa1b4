"""Accelerations, equilibria and small motions of a derivation, each where it is short, else with the reason in words.

The equations at rest and their roots, the linear terms of the Taylor series about each, the roots of det(K - ω² M) = 0:
small oscillations as in Goldstein, Poole, Safko, *Classical Mechanics* (2002), chapter 6.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, Function, Integer, Symbol, nan, oo, zoo

from lagdsl.flat.model import FlatModel
from lagdsl.textbook import functions
from lagdsl.textbook.recipe import Derivation
from lagdsl.textbook.small_motions.accelerations import Accelerations, accelerations
from lagdsl.textbook.small_motions.balance import LONGEST, Balance, balance, defaults, written_out
from lagdsl.textbook.small_motions.linear import Linear, NotLinearError, SingularError, is_determined, linear
from lagdsl.textbook.small_motions.roots import Condition, NotSolvedError
from lagdsl.textbook.small_motions.statics import Place, places
from lagdsl.textbook.small_motions.steady import Steady, steady
from lagdsl.textbook.tidy import TooLargeError, size

_ROUNDING = 1e-9
_POLES = (zoo, oo, -oo, nan)
_TOO_LONG = (
    "The equations of equilibrium are too long for roots in symbols; `lag trim` finds an equilibrium in numbers."
)
_ROLLING = (
    "Constraints of rates leave configurations free: `lag trim` finds an equilibrium in numbers, `lag modes` its modes."
)
_STATES = "First-order states occur in the equations: `lag trim` and `lag modes` look at both together."
_TIME = "Time occurs in the equations, so that no equilibrium lasts."
_SWITCHES = "Relations, corners or discrete variables occur in the equations; `lag modes` looks at one side of them."
_NOT_SOLVED = "The equations of equilibrium have no short roots; `lag trim` finds an equilibrium in numbers."


@dataclass(frozen=True, slots=True, kw_only=True)
class Equilibrium:
    """`at` are values of coordinates and multipliers; those that are not in it are `arbitrary`. `exists` tells whether
    the `conditions` hold for the parameters of the model. `linear` is None where the linear equations are not short,
    and under constraints."""

    at: tuple[tuple[Symbol, Expr], ...]
    arbitrary: tuple[Symbol, ...]
    conditions: tuple[Condition, ...]
    exists: bool
    linear: Linear | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Study:
    """`equilibria` are all there are, up to whole turns, if `reason` is None; else none, and `reason` says why. Places
    of the coordinates alone, at which the mass matrix is singular, are `singular` instead.

    `statics` are the residuals at rest, one per coordinate, then the constraint rows, if the system is `constrained`,
    with the inputs `held` at their default."""

    accelerations: Accelerations
    statics: tuple[Expr, ...]
    held: tuple[tuple[Symbol, Expr], ...]
    equilibria: tuple[Equilibrium, ...]
    reason: str | None
    singular: tuple[Equilibrium, ...] = ()
    constrained: bool = False
    steady: Steady | None = None


def study(flat: FlatModel, derivation: Derivation) -> Study:
    """All of it; bounded, as the derivation is. `flat` has at least one coordinate."""
    found = balance(flat, derivation)
    solved = accelerations(found)
    held = defaults(found)
    rows = tuple(row.residual for row in found.rows)
    count = len(derivation.symbols.q)
    residuals = written_out(derivation, (*found.residuals[:count], *rows))
    reason = _reason(found, residuals)
    used = tuple((u, value) for u, value in held.items() if any(u in each.free_symbols for each in residuals))
    if reason is None:
        residuals = tuple(each.xreplace(held) for each in residuals)
        statics, found_places, reason = _equilibria(found, residuals)
    if reason is not None:
        return Study(accelerations=solved, statics=(), held=(), equilibria=(), reason=reason)
    return Study(
        accelerations=solved,
        statics=statics,
        held=used,
        equilibria=tuple(each for each, is_regular in found_places if is_regular),
        singular=tuple(each for each, is_regular in found_places if not is_regular),
        reason=None,
        constrained=bool(rows),
        steady=None if rows else steady(found, residuals),
    )


def _reason(balance: Balance, residuals: Sequence[Expr]) -> str | None:
    """None where the form of the equations lets equilibria be looked for."""
    table = balance.derivation.symbols
    if any(row.level != "position" for row in balance.rows):
        return _ROLLING
    if any(size(each) > LONGEST for each in residuals):
        return _TOO_LONG
    present = {symbol for each in residuals for symbol in each.free_symbols}
    if present & {*table.z}:
        return _STATES
    if table.time in present:
        return _TIME
    moving = {*table.q, *table.qd, *table.qdd}
    known = {*moving, *balance.unknowns, *table.u, *balance.numbers}
    switches = {n for each in residuals for n in each.atoms(Function) if type(n).__module__ == functions.__name__}
    if any(node.free_symbols & moving for node in switches) or not present <= known:
        return _SWITCHES
    return None


def _equilibria(
    balance: Balance, residuals: Sequence[Expr]
) -> tuple[tuple[Expr, ...], tuple[tuple[Equilibrium, bool], ...], str | None]:
    """Equations at rest; their solutions, each with whether it determines accelerations, or why there are none."""
    table = balance.derivation.symbols
    rest = dict.fromkeys((*table.qd, *table.qdd), Integer(0))
    statics = tuple(balance.tidy(each.xreplace(rest)) for each in residuals)
    try:
        found = places(balance, statics, _unknowns(balance))
        lasting = [each for each in found if _holds(balance, statics, each)]
        equilibria = tuple(_equilibrium(balance, residuals, each) for each in lasting)
    except (NotSolvedError, TooLargeError):
        return statics, (), _NOT_SOLVED
    return statics, equilibria, None


def _unknowns(balance: Balance) -> tuple[Symbol, ...]:
    """Coordinates, then multipliers."""
    return (*balance.derivation.symbols.q, *(row.multiplier for row in balance.rows))


def _holds(balance: Balance, statics: Sequence[Expr], place: Place) -> bool:
    """False for a place at which a coordinate is at a pole; raises NotSolvedError if the equations do not hold."""
    values = [balance.tidy(each.xreplace(place.at)) for each in statics]
    if any(value.has(*_POLES) for value in values):
        return False
    if _real(balance, place):
        numbers = [balance.number(value) for value in values if not value.free_symbols & {*_unknowns(balance)}]
        if any(not abs(number) < _ROUNDING * (1 + _scale(balance)) for number in numbers):
            raise NotSolvedError
    return True


def _scale(balance: Balance) -> float:
    return max((abs(value) for value in balance.numbers.values() if math.isfinite(value)), default=1.0)


def _real(balance: Balance, place: Place) -> bool:
    return all(_fulfilled(balance, condition) for condition in place.conditions)


def _fulfilled(balance: Balance, condition: Condition) -> bool:
    value = balance.number(condition.value)
    return abs(value) <= 1 if condition.kind == "unit" else value >= 0


def _equilibrium(balance: Balance, residuals: Sequence[Expr], place: Place) -> tuple[Equilibrium, bool]:
    """With False where accelerations stay open: a place of the coordinates alone, as the origin of polar ones."""
    arbitrary = tuple(x for x in _unknowns(balance) if x not in place.at)
    exists = _real(balance, place)
    is_regular, about = not balance.rows or is_determined(balance, residuals, place.at), None
    try:
        about = None if balance.rows else linear(balance, residuals, place.at, real=exists)
    except SingularError:
        is_regular = False
    except (NotLinearError, TooLargeError):
        pass
    equilibrium = Equilibrium(
        at=tuple(place.at.items()),
        arbitrary=arbitrary,
        conditions=place.conditions,
        exists=exists,
        linear=about,
    )
    return equilibrium, is_regular
