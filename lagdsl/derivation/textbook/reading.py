"""Conversion of a model for people: exact numbers, named constants, definitions kept as symbols, everything tidied.

The numbers of a simulation come from `derive`; people read this form, and a test checks it against `derive`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

import sympy
from sympy import Expr, Float, Rational, Symbol, preorder_traversal

from lagdsl.derivation.textbook.contributions import Contributions, contributions
from lagdsl.derivation.textbook.convert import Converter, Style
from lagdsl.derivation.textbook.settle import settled
from lagdsl.derivation.textbook.shortening.choices import decided
from lagdsl.derivation.textbook.shortening.constant_sums import constant_sums
from lagdsl.derivation.textbook.shortening.whole_sums import KnownSums
from lagdsl.derivation.textbook.symbols import Symbols, symbols
from lagdsl.derivation.textbook.tidy import Tidy
from lagdsl.language.flat.expression import Number, Variable
from lagdsl.language.flat.model import Definition, FlatModel
from lagdsl.language.flat.quantity import Variability

STANDARD_GRAVITY = Symbol("g_n")
_G_N = 9.80665
STANDARD_GRAVITY_VALUE = Float(_G_N)
_NICE_DENOMINATOR = 360
_LONGEST_WHOLE = 4


def readable_number(value: float) -> Expr:
    """The rational a person would have typed; multiples of pi and the standard gravity by name."""
    if not math.isfinite(value) or abs(value) >= 1e15:
        return Float(value)
    if abs(value) == _G_N:
        return STANDARD_GRAVITY if value > 0 else -STANDARD_GRAVITY
    return _unnamed(value)


def _unnamed(value: float) -> Expr:
    """The number without a letter."""
    if not math.isfinite(value) or abs(value) >= 1e15:
        return Float(value)
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


def read(flat: FlatModel, *, written_out: bool = False) -> Reading:
    """`written_out`: no definition stays a symbol."""
    table = symbols(flat)
    definitions = [item for item in flat.named if isinstance(item, Definition) and not _is_alias(item)]
    definitions = [] if written_out else definitions
    number = _unnamed if STANDARD_GRAVITY.name in _names(flat) else readable_number
    fixed_definitions = [d for d in definitions if d.variability is not Variability.CONTINUOUS]
    constants, plain = _constants(flat, table, number, fixed_definitions)
    abbreviations = {d.name: Symbol(d.name) for d in definitions if d.variability is Variability.CONTINUOUS}
    positive = {symbol for symbol, value in _parameter_values(flat, table) if value > 0}
    tidy = Tidy(frozenset({*table.p, *constants.values(), STANDARD_GRAVITY}), frozenset({*positive, STANDARD_GRAVITY}))
    settle = decided(tidy.positive)
    named = [item.name for item in (*flat.parameters, *flat.named)]
    fixed = frozenset({name for name in named if Symbol(name) in tidy.constants} | {p.name for p in flat.parameters})
    tidy.known = KnownSums(constant=constant_sums(flat, fixed, plain.scalar))
    style = Style(number=number, tidy=tidy, settle=settle, opaque=constants)
    places = Converter(model=flat, symbols=table, style=style)
    style = Style(number=number, tidy=tidy, settle=settle, opaque=constants | abbreviations)
    values = Converter(model=flat, symbols=table, style=style)
    for name, symbol in abbreviations.items():
        rate = Symbol(f"der({name})")
        values.rates |= {symbol: rate, rate: Symbol(f"der({rate.name})")}
    parts = contributions(flat, places, values)
    tidy.keep_whole(tuple(_whole(flat, places, tidy.constants)))
    return Reading(flat, table, tidy, parts, values, constants, abbreviations)


def _whole(flat: FlatModel, converter: Converter, constants: frozenset[Symbol]) -> Iterator[Expr]:
    """Short sums of declared energies that are factors, as r - l0 of a spring: people leave them as they are."""
    for term in flat.energies:
        yield from whole_sums(converter.scalar(term.value), constants)


def whole_sums(expression: Expr, constants: frozenset[Symbol]) -> Iterator[Expr]:
    """Short sums that move and are factors."""
    for node in preorder_traversal(expression):
        factors = node.args if node.is_Mul else node.args[:1] if node.is_Pow else ()
        for factor in factors:
            if factor.is_Add and len(factor.args) <= _LONGEST_WHOLE and not factor.free_symbols <= constants:
                yield factor


def _names(flat: FlatModel) -> set[str]:
    """Of everything that has a symbol."""
    items = (*flat.parameters, *flat.coordinates, *flat.states, *flat.inputs, *flat.named)
    return {item.name for item in items}


def _is_alias(item: Definition) -> bool:
    """Another name for a number or a quantity, which is written through."""
    return isinstance(item.value, Number | Variable)


def _constants(
    flat: FlatModel, table: Symbols, number: Callable[[float], Expr], definitions: list[Definition]
) -> tuple[dict[str, Symbol], Converter]:
    """Dependent parameters that stay symbols: those that are numbers by now are written as numbers. With what converts
    expressions in constants."""
    every = [item for item in flat.named if isinstance(item, Definition)]
    others = _other_names(every)
    known_later = {name for names in others.values() for name in names}
    named = tuple(item for item in every if _is_alias(item) and item.name not in known_later)
    values = Converter(model=replace(flat, named=named), symbols=table, style=Style(number=number))
    kept: dict[str, Symbol] = {}
    for item in definitions:
        value = settled(values.scalar(item.value))
        kept |= {} if value.is_number or value.is_Symbol else {item.name: Symbol(item.name)}
        for name in (item.name, *others.get(item.name, ())):
            values.known(name, value if value.is_number or value.is_Symbol else kept[item.name])
    return kept, values


def _other_names(definitions: list[Definition]) -> dict[str, list[str]]:
    """Names that stand for definitions with a formula, such as parameters of components that are bound to one."""
    ends = {item.name: item.name for item in definitions if not _is_alias(item)}
    found: dict[str, list[str]] = {}
    for item in definitions:  # what a name stands for is defined before it
        if isinstance(item.value, Variable) and item.value.name in ends:
            ends[item.name] = ends[item.value.name]
            found.setdefault(ends[item.name], []).append(item.name)
    return found


def _parameter_values(flat: FlatModel, table: Symbols) -> list[tuple[Symbol, float]]:
    independent = [parameter for parameter in flat.parameters if not parameter.structural]
    return [(symbol, parameter.value) for symbol, parameter in zip(table.p, independent, strict=True)]


def needed(definitions: tuple[tuple[Symbol, Expr], ...], printed: Iterable[Expr]) -> tuple[tuple[Symbol, Expr], ...]:
    """Definitions that stand in what is printed, directly or through others."""
    wanted = {symbol for value in printed for symbol in value.free_symbols}
    for _ in range(2):
        wanted |= {Symbol(s.name[4:-1]) for s in wanted if s.name.startswith("der(")}
    for symbol, value in reversed(definitions):
        if symbol in wanted:
            wanted |= value.free_symbols
    return tuple((symbol, value) for symbol, value in definitions if symbol in wanted)
