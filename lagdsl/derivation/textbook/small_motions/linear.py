"""Linear equations about an equilibrium, and the squares of their natural frequencies."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from typing import TypeAlias

import numpy as np
import sympy
from sympy import Expr, Integer, Symbol

from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.rational import divided, in_lowest_terms, lowest
from lagdsl.derivation.textbook.small_motions.balance import LONGEST, Balance
from lagdsl.derivation.textbook.small_motions.quotients import blocks, determinant, ratio
from lagdsl.derivation.textbook.tidy import Tidy, TooLargeError, size
from lagdsl.foundation.numerics.rank import null_space, rank

Square: TypeAlias = tuple[tuple[Expr, ...], ...]
_LONGEST_ENTRY = 80
_LONGEST_FREQUENCY = 120
_LONGEST_DAMPED = 60


@dataclass(frozen=True, slots=True, kw_only=True)
class Damped:
    """Damping ratio ζ = D/(2 M ω) and the square of the frequency that damping leaves, ω_d² = ω² (1 - ζ²), with their
    values for the parameters of the model. Meirovitch, *Fundamentals of Vibrations* (2001), 2.2."""

    ratio: Expr
    square: Expr
    ratio_number: float
    square_number: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Frequency:
    """`square` is ω² of a motion of the `coordinates`; `damping` is D/M where they are one coordinate. `sign` is that
    of the square for all positive parameters, 0 if it depends on them; `number` its value for those of the model, and
    `growth` [1/s] the largest real part of the eigenvalues then. `damped` is None without damping, and where nothing
    pulls back."""

    coordinates: tuple[Symbol, ...]
    square: Expr
    damping: Expr
    sign: int
    number: float
    growth: float
    damped: Damped | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Linear:
    """mass ẍ + damping ẋ + stiffness x = 0 in the deviations x of the coordinates; gyroscopic terms are in `damping`.

    `frequencies` are in the order of the blocks of coordinates; `coupled` are the coordinates of blocks whose
    frequencies are not short, `damped` of those that damping or gyroscopic terms couple."""

    mass: Square
    damping: Square
    stiffness: Square
    frequencies: tuple[Frequency, ...]
    coupled: tuple[Symbol, ...]
    damped: tuple[Symbol, ...]


class SingularError(Exception):
    """The mass matrix has no inverse at the place."""


class NotLinearError(Exception):
    """No short linear equations: an entry is long or has no value there."""


def linear(balance: Balance, residuals: Sequence[Expr], at: dict[Symbol, Expr], *, real: bool) -> Linear:
    """About the place `at`, which is `real` for the numbers of the model."""
    table = balance.derivation.symbols
    rest = dict.fromkeys((*table.qd, *table.qdd), Integer(0))

    def derivatives(by: Sequence[Symbol]) -> Square:
        values = ((_short(balance, partial(each, x).xreplace(rest)) for x in by) for each in residuals)
        return tuple(tuple(balance.tidy(value.xreplace(at)) for value in row) for row in values)

    mass = regular(balance, residuals, at)
    damping, stiffness = derivatives(table.qd), derivatives(table.q)
    for entry in chain.from_iterable((*mass, *damping, *stiffness)):
        if size(entry) > _LONGEST_ENTRY or entry.free_symbols & {*table.q}:
            raise NotLinearError
        if real and not math.isfinite(balance.number(entry)):
            raise NotLinearError
    return _with_frequencies(balance, mass, damping, stiffness)


def _short(balance: Balance, value: Expr) -> Expr:
    """Tidied; a long one is looked at after its place is put in."""
    return balance.tidy(value) if size(value) <= LONGEST else value


def regular(balance: Balance, residuals: Sequence[Expr], at: dict[Symbol, Expr]) -> Square:
    """The mass matrix at a place of a system without constraints; raises SingularError where it has no inverse."""
    table = balance.derivation.symbols
    rest = dict.fromkeys((*table.qd, *table.qdd), Integer(0))
    rows = ((partial(each, x).xreplace(rest).xreplace(at) for x in table.qdd) for each in residuals[: len(table.q)])
    mass = tuple(tuple(balance.tidy(value) for value in row) for row in rows)
    if balance.tidy.is_zero(determinant(mass)):
        raise SingularError
    return mass


def is_determined(balance: Balance, residuals: Sequence[Expr], at: dict[Symbol, Expr]) -> bool:
    """False where masses and constraints leave accelerations open: M has no inverse on the null space of J, by the
    values of the parameters."""
    table = balance.derivation.symbols
    rest = dict.fromkeys((*table.qd, *table.qdd), Integer(0))
    unknowns = (*table.qdd, *(row.multiplier for row in balance.rows))
    rows = [[partial(each, x).xreplace(rest).xreplace(at) for x in unknowns] for each in residuals[: len(table.q)]]
    values = np.array([[balance.number(value) for value in row] for row in rows])
    if not np.isfinite(values).all():  # a place with something arbitrary
        return True
    mass, jacobian = values[:, : len(table.qdd)], values[:, len(table.qdd) :].T
    diagonal = np.abs(np.diag(mass))
    unit = 1.0 / np.sqrt(np.where(diagonal > 0.0, diagonal, 1.0))
    free = null_space(jacobian * unit)
    return bool(rank(free.T @ (mass * unit[:, None] * unit) @ free) == free.shape[1])


def _with_frequencies(balance: Balance, mass: Square, damping: Square, stiffness: Square) -> Linear:
    q = balance.derivation.symbols.q
    count = range(len(q))
    pattern = [[any(m[i][j] != 0 for m in (mass, damping, stiffness)) for j in count] for i in count]
    found: list[Frequency] = []
    coupled: list[Symbol] = []
    damped: list[Symbol] = []
    for block in blocks(pattern):
        names = tuple(q[i] for i in block)
        part = [tuple(tuple(m[i][j] for j in block) for i in block) for m in (mass, damping, stiffness)]
        if len(block) > 1 and any(chain.from_iterable(part[1])):
            damped += names
            continue
        try:
            squares = _squares(balance.tidy, part[0], part[2])
            drag = ratio(balance.tidy, part[1][0][0], part[0][0][0]) if len(block) == 1 else Integer(0)
        except (TooLargeError, ZeroDivisionError, NotLinearError):
            coupled += names
            continue
        found += [
            Frequency(
                coordinates=names,
                square=s,
                damping=drag,
                sign=_sign(balance.tidy, s),
                number=balance.number(s),
                growth=_growth(balance.number(drag), balance.number(s)),
                damped=_damped(balance, drag, s),
            )
            for s in squares
        ]
    return Linear(
        mass=mass,
        damping=damping,
        stiffness=stiffness,
        frequencies=tuple(found),
        coupled=tuple(coupled),
        damped=tuple(damped),
    )


def _growth(drag: float, square: float) -> float:
    """Largest real part of the roots of x² + drag x + square = 0, without cancellation; nan where one is unknown."""
    half = drag / 2.0
    inside = half * half - square
    if not inside > 0.0:
        return -half if math.isfinite(inside) else math.nan
    root = math.sqrt(inside)
    return -square / (half + root) if half > 0.0 else root - half


def _damped(balance: Balance, drag: Expr, square: Expr) -> Damped | None:
    """`drag` is D/M; None if it is zero or `square` is not positive, and where their values are not short."""
    if drag == 0 or not balance.number(square) > 0.0:
        return None
    tidy = balance.tidy
    try:
        above, below = ratio(tidy, drag**2, 4 * square).as_numer_denom()
        (first, inside), (second, under) = (_without_squares(tidy, each) for each in (above, below))
        damping_ratio = ratio(tidy, first, second) * sympy.sqrt(inside) / sympy.sqrt(under)
        left = square - drag**2 / 4
    except (TooLargeError, ZeroDivisionError):
        return None
    if max(size(damping_ratio), size(left)) > _LONGEST_DAMPED:
        return None
    return Damped(
        ratio=damping_ratio,
        square=left,
        ratio_number=balance.number(damping_ratio),
        square_number=balance.number(left),
    )


def _squares(tidy: Tidy, mass: Square, stiffness: Square) -> list[Expr]:
    """Roots of det(K - λ M), whose factors are linear or quadratic in λ. Raises NotLinearError for others."""
    if len(mass) > 4:
        raise NotLinearError
    unknown = sympy.Symbol("λ of the frequencies")
    rows = [[k - unknown * m for k, m in zip(ks, ms, strict=True)] for ks, ms in zip(stiffness, mass, strict=True)]
    result: list[Expr] = []
    for factor in tidy.factors(determinant(rows)):
        if unknown not in factor.free_symbols:
            continue
        result += _roots(tidy, factor, unknown)
    if not result:
        raise NotLinearError
    return result


def _roots(tidy: Tidy, factor: Expr, x: Symbol) -> list[Expr]:
    zero = {x: Integer(0)}
    first = tidy(partial(factor, x))
    second = tidy(partial(first, x))
    if x in second.free_symbols:
        raise NotLinearError
    a, b, c = second / 2, first.xreplace(zero), tidy(factor.xreplace(zero))
    if a == 0:
        return [ratio(tidy, -c, b)]
    inside = tidy(b**2 - 4 * a * c)
    found = [_quotient(tidy, -b, sign, inside, 2 * a) for sign in (-1, 1)]
    if any(size(each) > _LONGEST_FREQUENCY for each in found):
        raise NotLinearError
    return found


def _quotient(tidy: Tidy, middle: Expr, sign: int, inside: Expr, below: Expr) -> Expr:
    """(middle ± √inside)/below with common factors before the fraction; squares leave the root."""
    outside, root = _without_squares(tidy, inside)
    if middle == 0 or root.is_Rational:
        return ratio(tidy, middle + sign * outside * sympy.sqrt(root), below)
    first, second = in_lowest_terms(tidy.reduced(middle), tidy.reduced(outside))
    shared = ratio(tidy, outside, tidy.collected(second))
    numerator = tidy.factored(first) + sign * tidy.collected(second) * sympy.sqrt(root)
    return numerator * ratio(tidy, shared, below)


def _without_squares(tidy: Tidy, inside: Expr) -> tuple[Expr, Expr]:
    """a and b of inside = a² b, where a is a product of positive symbols and a number."""
    polynomial = tidy.reduced(inside)
    common = lowest(polynomial)
    half = tuple((kernel, power // 2) for kernel, power in common if tidy.monomial(((kernel, 1),)) in tidy.positive)
    content = (
        math.gcd(*(int(c.p) for c in polynomial.values())) if all(c.is_Integer for c in polynomial.values()) else 1
    )
    number, _ = sympy.core.intfunc.integer_nthroot(int(content), 2)
    while content % number**2:
        number -= 1
    rest = divided(polynomial, tuple((kernel, 2 * power) for kernel, power in half if power))
    outside = number * tidy.monomial(tuple((kernel, power) for kernel, power in half if power))
    return outside, tidy.factored({m: c / number**2 for m, c in rest.items()})


def _sign(tidy: Tidy, square: Expr) -> int:
    """1 or -1 where SymPy sees that sign for all positive values of the positive parameters."""
    known = {s: Symbol(s.name, positive=True) for s in square.free_symbols & tidy.positive}
    shown = square.xreplace(known)
    return 1 if shown.is_positive else -1 if shown.is_negative else 0
