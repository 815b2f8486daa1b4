"""The equations of motion as residuals, and the numbers that the model gives its symbols."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sympy import Expr, Float, Integer, Symbol

from lagdsl.derivation.textbook.differentiate import along
from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY, STANDARD_GRAVITY_VALUE, readable_number, whole_sums
from lagdsl.derivation.textbook.recipe import ConstraintRow, Derivation
from lagdsl.derivation.textbook.shortening.whole_sums import KnownSums
from lagdsl.derivation.textbook.symbols import Symbols
from lagdsl.derivation.textbook.tidy import Tidy, size
from lagdsl.language.flat.expression import Number
from lagdsl.language.flat.model import FlatModel

LONGEST = 400
"""Nodes of an equation of motion that is looked at."""
_BUDGET = 30_000


@dataclass(frozen=True)
class Balance:
    """Equations of motion as residuals, left-hand side less right-hand side, one per coordinate, then the constraint
    rows as accelerations; `unknowns` are the accelerations, then the multipliers of these rows.

    Contacts that are not in `closed` are open, and friction slides, so that their multipliers are zero; `rows` are the
    other constraints'.
    `numbers` are the values of all that is constant; inputs with a default are held at it.
    """

    flat: FlatModel
    derivation: Derivation
    residuals: tuple[Expr, ...]
    rows: tuple[ConstraintRow, ...]
    unknowns: tuple[Symbol, ...]
    tidy: Tidy
    numbers: Mapping[Symbol, float]
    closed: frozenset[str] = frozenset()

    def number(self, expression: Expr) -> float:
        """The value of an expression in constants; nan where it has none."""
        try:
            value = complex(expression.xreplace({s: Float(v) for s, v in self.numbers.items()}))
        except (TypeError, ValueError, OverflowError, ZeroDivisionError):
            return math.nan
        return value.real if abs(value.imag) <= 1e-12 * (1.0 + abs(value.real)) else math.nan


def balance(flat: FlatModel, derivation: Derivation, closed: frozenset[str] = frozenset()) -> Balance:
    """With the contacts of the names `closed`."""
    table = derivation.symbols
    present = (row for row in derivation.constraints if row.is_lasting or row.name in closed)
    lasting = tuple(row for row in present if row.restricts)
    open_ = {row.multiplier: Integer(0) for row in derivation.constraints if row not in lasting}
    equations = [s.left - right for s, right in zip(derivation.coordinates, derivation.rights, strict=True)]
    independent = [parameter for parameter in flat.parameters if not parameter.structural]
    values = dict(zip(table.p, (parameter.value for parameter in independent), strict=True))
    values |= {symbol: float(value) for symbol, value in defaults(flat, table).items()}
    tidy = Tidy(
        derivation.constants | {*defaults(flat, table)},
        frozenset({*(symbol for symbol, value in values.items() if value > 0), STANDARD_GRAVITY}),
        budget=_BUDGET,
        known=KnownSums(constant=derivation.sums),
    )
    tidy.keep_whole(tuple(whole_sums(derivation.potential, derivation.constants)))
    numbers = {STANDARD_GRAVITY: float(STANDARD_GRAVITY_VALUE), **values}
    result = Balance(
        flat=flat,
        derivation=derivation,
        residuals=tuple(e.xreplace(open_) for e in (*equations, *(row.acceleration for row in lasting))),
        rows=lasting,
        unknowns=(*table.qdd, *(row.multiplier for row in lasting)),
        tidy=tidy,
        numbers=numbers,
        closed=closed,
    )
    for symbol, value in derivation.dependent_parameters:
        numbers[symbol] = result.number(value)
    return result


def written_out(derivation: Derivation, expressions: Sequence[Expr]) -> tuple[Expr, ...]:
    """The expressions without definitions of the model; those that grow beyond the bound keep some."""
    table = derivation.symbols
    rates = dict(zip((*table.q, *table.qd), (*table.qd, *table.qdd), strict=True)) | {table.time: Integer(1)}
    for symbol, _ in derivation.abbreviations:
        rate = Symbol(f"der({symbol.name})")
        rates |= {symbol: rate, rate: Symbol(f"der({rate.name})")}
    result = tuple(expressions)
    for symbol, value in reversed(derivation.abbreviations):
        rate = along(value, rates)
        pair = {symbol: value, rates[symbol]: rate, rates[rates[symbol]]: along(rate, rates)}
        result = tuple(each.xreplace(pair) if size(each) <= LONGEST else each for each in result)
    return result


def defaults(flat: FlatModel, table: Symbols) -> dict[Symbol, Expr]:
    """Inputs whose value is a number while nothing is given from outside."""
    pairs = zip(table.u, flat.inputs, strict=True)
    return {symbol: readable_number(item.default.value) for symbol, item in pairs if isinstance(item.default, Number)}
