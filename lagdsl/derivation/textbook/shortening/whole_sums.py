"""Sums with square roots as symbols: multiplied out, their squares would be lost."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from sympy import Expr, Symbol

from lagdsl.derivation.textbook.shortening.products import has_root


@dataclass(frozen=True, slots=True)
class KnownSums:
    """`constant` ones are factors in the model, `whole` ones stay brackets. Of those with roots `closed` has a symbol
    for each form, `opened` the sum of each symbol."""

    constant: frozenset[Expr] = frozenset()
    whole: tuple[Expr, ...] = ()
    closed: Mapping[Expr, Expr] = field(default_factory=dict)
    opened: Mapping[Symbol, Expr] = field(default_factory=dict)


def with_whole(known: KnownSums, pairs: Sequence[tuple[Expr, Expr]]) -> KnownSums:
    """Of sums as the model has them and as they are short."""
    whole = tuple(dict.fromkeys(short for _, short in pairs if short.is_Add))
    short_ones = dict.fromkeys(short for _, short in pairs if short.is_Add and has_root(short))
    symbols = {short: Symbol(f"whole {n}") for n, short in enumerate(short_ones)}
    closed = {each: symbols[short] for each, short in pairs if short in symbols} | symbols
    # SymPy multiplies a number into a sum: the derivative of a square has twice the sum.
    closed |= {n * each: n * symbol for each, symbol in closed.items() for n in (-2, -1, 2)}
    return replace(known, whole=whole, closed=closed, opened={symbol: short for short, symbol in symbols.items()})
