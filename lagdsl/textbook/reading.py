"""Conversion of a model for people: exact numbers, named constants, definitions kept as symbols, everything tidied.

The numbers of a simulation come from `derive`; people read this form, and a test checks it against `derive`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

import sympy
from sympy import Expr, Float, Rational, Symbol

from lagdsl.flat.model import Definition, FlatModel
from lagdsl.flat.quantity import Variability
from lagdsl.textbook.contributions import Contributions, contributions
from lagdsl.textbook.convert import Converter, Style
from lagdsl.textbook.symbols import Symbols, symbols
from lagdsl.textbook.tidy import Tidy

STANDARD_GRAVITY = Symbol("g_n")
_G_N = 9.80665
STANDARD_GRAVITY_VALUE = Float(_G_N)
_NICE_DENOMINATOR = 360


def readable_number(value: float) -> Expr:
    """The rational a person would have typed; multiples of pi and the standard gravity by name."""
    if not math.isfinite(value) or abs(value) >= 1e15:
        return Float(value)
    if abs(value) == _G_N:
        return STANDARD_GRAVITY if value > 0 else -STANDARD_GRAVITY
    nice = _nice(value)
    if nice is not None:
        return nice
    turns = _nice(value / math.pi)
    if turns is not None and abs(turns.q) <= 24 and float(turns) * math.pi == value:
        return turns * sympy.pi
    return Rational(repr(value))


def _nice(value: float) -> Rational | None:
    fraction = Fraction(value).limit_denominator(_NICE_DENOMINATOR)
    if float(fraction) != value:
        return None
    return Rational(fraction.numerator, fraction.denominator)


@dataclass(frozen=True, slots=True)
class Reading:
    """A model converted for people. `values` converts loads, outputs and states, where definitions stay symbols;
    `parts` has them written out, since they are differentiated."""

    flat: FlatModel
    symbols: Symbols
    tidy: Tidy
    parts: Contributions
    values: Converter
    constants: dict[str, Symbol]
    abbreviations: dict[str, Symbol]


def read(flat: FlatModel) -> Reading:
    table = symbols(flat)
    definitions = [item for item in flat.named if isinstance(item, Definition)]
    constants = {d.name: Symbol(d.name) for d in definitions if d.variability is not Variability.CONTINUOUS}
    abbreviations = {d.name: Symbol(d.name) for d in definitions if d.variability is Variability.CONTINUOUS}
    positive = {symbol for symbol, value in _parameter_values(flat, table) if value > 0}
    tidy = Tidy(frozenset({*table.p, *constants.values(), STANDARD_GRAVITY}), frozenset({*positive, STANDARD_GRAVITY}))
    places = Converter(model=flat, symbols=table, style=Style(number=readable_number, tidy=tidy, opaque=constants))
    style = Style(number=readable_number, tidy=tidy, opaque=constants | abbreviations)
    values = Converter(model=flat, symbols=table, style=style)
    for name, symbol in abbreviations.items():
        values.rates[symbol] = Symbol(f"der({name})")
    return Reading(flat, table, tidy, contributions(flat, places, values), values, constants, abbreviations)


def _parameter_values(flat: FlatModel, table: Symbols) -> list[tuple[Symbol, float]]:
    independent = [parameter for parameter in flat.parameters if not parameter.structural]
    return [(symbol, parameter.value) for symbol, parameter in zip(table.p, independent, strict=True)]
