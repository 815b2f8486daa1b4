"""Accelerations, equilibria and small motions of a derivation, each where it is short, else with the reason in words.

The equations at rest and their roots, the linear terms of the Taylor series about each, the roots of det(K - ω² M) = 0:
small oscillations as in Goldstein, Poole, Safko, *Classical Mechanics* (2002), chapter 6.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import assert_never

from sympy import Expr, Integer, Symbol, nan, oo, zoo

from lagdsl.derivation.textbook import functions
from lagdsl.derivation.textbook.recipe import Derivation
from lagdsl.derivation.textbook.small_motions.accelerations import Accelerations, accelerations
from lagdsl.derivation.textbook.small_motions.balance import LONGEST, Balance, balance, defaults, written_out
from lagdsl.derivation.textbook.small_motions.contacts import MOST_CONTACTS, admissible, cases
from lagdsl.derivation.textbook.small_motions.likely import LONGEST_LIKELY, likely
from lagdsl.derivation.textbook.small_motions.linear import Linear, NotLinearError, SingularError, is_determined, linear
from lagdsl.derivation.textbook.small_motions.roots import Condition, NotSolvedError
from lagdsl.derivation.textbook.small_motions.statics import Place, places, vanishes
from lagdsl.derivation.textbook.small_motions.steady import Steady, steady
from lagdsl.derivation.textbook.symbols import occurring, postorder
from lagdsl.derivation.textbook.tidy import TooLargeError, size
from lagdsl.language.flat.model import FlatModel

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
_FRICTION = (
    "Dry friction holds the system at rest in whole ranges of positions; `lag trim` finds one of them in numbers."
)
_DELAYS = "Delayed values make the characteristic function one that is no polynomial: simulate small motions."
_FEEDBACK = (
    "Loads depend on multipliers, reactions or accelerations: `lag trim` finds an equilibrium in numbers, `lag modes` "
    "its modes."
)
_OTHERS = "There may be other equilibria, without short roots; `lag trim` finds one in numbers."
_NOT_SOLVED = "The equations of equilibrium have no short roots; `lag trim` finds an equilibrium in numbers."


@dataclass(frozen=True, slots=True, kw_only=True)
class Equilibrium:
    """`at` are values of coordinates and multipliers; those that are not in it are `arbitrary`. `exists` tells whether
    the `conditions` hold for the parameters of the model. `linear` is None where the linear equations are not short,
    and under constraints. The contacts `closed` are so there, all others are open."""

    at: tuple[tuple[Symbol, Expr], ...]
    arbitrary: tuple[Symbol, ...]
    conditions: tuple[Condition, ...]
    exists: bool
    linear: Linear | None
    closed: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Study:
    """`equilibria` are all there are, up to whole turns, if it is `complete`; else some of them. If `reason` is not
    None there are none, and it says why. Places of the coordinates alone, at which the mass matrix
    is singular, are `singular` instead.

    `statics` are the residuals at rest, one per coordinate, then the constraint rows, if the system is `constrained`;
    the multipliers of contacts are in them. The inputs `held` have their default; those of zero are left out."""

    accelerations: Accelerations
    statics: tuple[Expr, ...]
    held: tuple[Symbol, ...]
    equilibria: tuple[Equilibrium, ...]
    reason: str | None
    singular: tuple[Equilibrium, ...] = ()
    constrained: bool = False
    complete: bool = True
    steady: Steady | None = None

    @property
    def not_all_because(self) -> str | None:
        """Why the `equilibria` are none, or not all; None if they are all."""
        return self.reason if self.complete or self.reason is not None else _OTHERS


def study(flat: FlatModel, derivation: Derivation) -> Study:
    """All of it; bounded, as the derivation is. `flat` has at least one coordinate."""
    found = balance(flat, derivation)
    solved = accelerations(found)
    residuals = _residuals(found)
    reason = _reason(found, residuals)
    if reason is not None:
        return Study(accelerations=solved, statics=(), held=(), equilibria=(), reason=reason)
    together: list[tuple[Equilibrium, bool]] = []
    complete = True
    for closed in cases(derivation):
        case = balance(flat, derivation, closed) if closed else found
        some, all_of_them = _equilibria(case, _residuals(case))
        together += some
        complete = complete and all_of_them
    if not complete and not together:
        reason = _TOO_LONG if any(size(each) > LONGEST for each in residuals) else _NOT_SOLVED
        return Study(accelerations=solved, statics=(), held=(), equilibria=(), reason=reason)
    present = {symbol for each in written_out(derivation, found.residuals) for symbol in occurring(each)}
    return Study(
        accelerations=solved,
        statics=_statics(flat, derivation, found, residuals),
        held=tuple(u for u in defaults(flat, derivation.symbols) if u in present),
        equilibria=tuple(each for each, is_regular in together if is_regular),
        singular=tuple(each for each, is_regular in together if not is_regular),
        reason=None,
        constrained=bool(found.rows),
        complete=complete and sum(row.contact for row in derivation.constraints) <= MOST_CONTACTS,
        steady=None if found.rows else steady(found, residuals),
    )


def _residuals(balance: Balance) -> tuple[Expr, ...]:
    """The equations of motion, then the constraint rows, without definitions; inputs that are zero at their default,
    and those that switches read, have this value."""
    count = len(balance.derivation.symbols.q)
    rows = tuple(row.residual for row in balance.rows)
    found = written_out(balance.derivation, (*balance.residuals[:count], *rows))
    read = {symbol for each in _switches(found) for symbol in occurring(each)}
    values = defaults(balance.flat, balance.derivation.symbols)
    put_in = {u: value for u, value in values.items() if value == 0 or u in read}
    return tuple(each.xreplace(put_in) for each in found)


def _statics(flat: FlatModel, derivation: Derivation, opened: Balance, residuals: Sequence[Expr]) -> tuple[Expr, ...]:
    """At rest, with the multipliers of contacts."""
    contacts = frozenset(row.name for row in derivation.constraints if row.contact)
    if not contacts:
        return _at_rest(opened, residuals)
    closed, count = balance(flat, derivation, contacts), len(derivation.symbols.q)
    return (*_at_rest(closed, _residuals(closed)[:count]), *_at_rest(opened, residuals[count:]))


def _at_rest(balance: Balance, residuals: Sequence[Expr]) -> tuple[Expr, ...]:
    table = balance.derivation.symbols
    rest = dict.fromkeys((*table.qd, *table.qdd), Integer(0))
    return tuple(balance.tidy(each.xreplace(rest)) for each in residuals)


def _reason(balance: Balance, residuals: Sequence[Expr]) -> str | None:
    """None where the form of the equations lets equilibria be looked for."""
    table = balance.derivation.symbols
    if any(row.friction for row in balance.derivation.constraints):
        return _FRICTION
    if balance.flat.events.delays:
        return _DELAYS
    if balance.flat.events.feedbacks:
        return _FEEDBACK
    if any(row.level != "position" for row in balance.rows):
        return _ROLLING
    if any(size(each, LONGEST_LIKELY) >= LONGEST_LIKELY for each in residuals):
        return _TOO_LONG
    present = {symbol for each in residuals for symbol in occurring(each)}
    if present & {*table.z}:
        return _STATES
    if table.time in present:
        return _TIME
    moving = {*table.q, *table.qd, *table.qdd}
    known = {*moving, *balance.unknowns, *table.u, *balance.numbers}
    if any(occurring(node) & moving for node in _switches(residuals)) or not present <= known:
        return _SWITCHES
    return None


def _switches(residuals: Sequence[Expr]) -> set[Expr]:
    known: dict[Expr, None] = {}
    for each in residuals:
        for node in postorder(each, known):
            known[node] = None
    return {node for node in known if node.is_Function and type(node).__module__ == functions.__name__}


def _equilibria(balance: Balance, residuals: Sequence[Expr]) -> tuple[list[tuple[Equilibrium, bool]], bool]:
    """Solutions of the equations at rest, each with whether it determines accelerations, and whether these are all."""
    statics = _at_rest(balance, residuals)
    try:
        if any(size(each) > LONGEST for each in statics):
            raise NotSolvedError
        found = places(balance, statics, _unknowns(balance))
        lasting = [each for each in found if _holds(balance, statics, each)]
        own = [place for place in (admissible(balance, each) for each in lasting) if place is not None]
        return [_equilibrium(balance, residuals, each) for each in own], True
    except (NotSolvedError, TooLargeError):
        return [_equilibrium(balance, residuals, each) for each in likely(balance, statics)], False


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
    """For the numbers of the model; a condition of coordinates that stay arbitrary restricts these."""
    if condition.value.free_symbols & {*_unknowns(balance)}:
        return True
    value = balance.number(condition.value)
    match condition.kind:
        case "unit":
            return abs(value) <= 1
        case "nonnegative":
            return value >= 0
        case "zero":
            return vanishes(balance, condition.value)
        case _:
            assert_never(condition.kind)


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
        closed=tuple(sorted(balance.closed)),
    )
    return equilibrium, is_regular
