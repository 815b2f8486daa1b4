"""Intermediate quantities: parts of expressions that are too long for a page get a symbol, as on paper.

A part that the model itself has named keeps that name; any other one that occurs several times is `s` with a number.
Values are those of the expressions: nothing is rounded, and each symbol stands before what is written with it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import TypeAlias

from sympy import Expr, Symbol, sqrt

from lagdsl.derivation.textbook.contributions import HALF
from lagdsl.derivation.textbook.symbols import postorder, replaced
from lagdsl.derivation.textbook.tidy import size

LONGEST = 700
"""Nodes of an expression that is printed as it is."""
_SHORT = 120
_SMALLEST = 8
_LEAST_GAIN = 24
_LONGEST_UNNAMED = 60

_LONG_ROOT = 16
_LARGEST = 20_000
_HANDFUL = 14

Rules: TypeAlias = list[dict[Expr, Expr]]


class _TooManyError(Exception):
    pass


@dataclass
class Intermediates:
    """`symbol` makes the symbol of a number; `named` are symbols of the model by their values, written out. Parts with
    an `unnamed` symbol, as accelerations, stay where they are. New symbols are `made` in turn, at most `most`."""

    symbol: Callable[[int], Symbol]
    unnamed: frozenset[Symbol] = frozenset()
    named: Mapping[Expr, Symbol] = field(default_factory=dict)
    made: list[tuple[Symbol, Expr]] = field(default_factory=list)
    used: set[Symbol] = field(default_factory=set)
    most: int | None = None
    _by_value: dict[Expr, Expr] = field(default_factory=dict)
    _values: dict[Symbol, Expr] = field(default_factory=dict)
    _names: dict[Expr, Expr] = field(init=False)

    def __post_init__(self) -> None:
        roots = {value.base: symbol for value, symbol in self.named.items() if value.is_Pow and value.exp == HALF}
        powers = {base ** (HALF * n): symbol**n for base, symbol in roots.items() for n in (-3, -1, 3)}
        self._names = {**powers, **self.named}

    def define(self, lines: Iterable[tuple[Symbol, Expr]]) -> None:
        """Symbols that others have made, each once."""
        known = {symbol for symbol, _ in self.made}
        self.made += [(symbol, value) for symbol, value in lines if symbol not in known]

    def reach(self, expression: Expr) -> bool:
        """True if a handful of new symbols makes the expression short."""
        total = size(expression, _LARGEST + 1)
        if total <= LONGEST or total > _LARGEST:
            return total <= LONGEST
        made, known, values = list(self.made), dict(self._by_value), dict(self._values)
        trial = replace(self, made=made, used=set(), most=len(values) + _HANDFUL, _by_value=known, _values=values)
        try:
            trial.short(expression)
        except _TooManyError:
            return False
        return True

    def short(self, expression: Expr) -> tuple[Expr, Rules]:
        """The expression itself if it is short enough, else one with symbols. A part of it becomes a part of that one
        by the same replacements, one after the other."""
        if expression in self.named or expression in self._by_value:
            return expression, []
        rules: Rules = []
        if size(expression) > _LONGEST_UNNAMED:
            found = self._with_names(expression)
            rules += [self._names] if found is not expression else []
            expression = found
        expression, roots = self._with_roots(expression)
        rules += roots
        if size(expression) <= LONGEST:
            return expression, rules
        found, more = self._shortened(expression)
        return found, [*rules, *more]

    def _with_roots(self, expression: Expr) -> tuple[Expr, Rules]:
        """Long square roots by a name, as the length of a spring: one that stands there twice, or has its name."""
        powers = {} if expression.is_Pow else _roots(expression)
        names: dict[Expr, Expr] = {}
        for base, found in powers.items():
            root = sqrt(base)
            symbol = self.named.get(root, self._by_value.get(root))
            if symbol is None and sum(found.values()) > 1:
                symbol = self._named(root)
            if symbol is not None:
                self.used |= {symbol} & {*self.named.values()}
                names |= {base**power: symbol ** (2 * power) for power in found}
        return (expression.xreplace(names), [names]) if names else (expression, [])

    def _with_names(self, expression: Expr) -> Expr:
        if not self.named:
            return expression
        found = expression.xreplace(self._names)
        if found == expression:
            return expression
        self.used |= found.free_symbols - expression.free_symbols
        return found

    def _shortened(self, expression: Expr) -> tuple[Expr, Rules]:
        rules: Rules = [self._names, dict(self._by_value)]
        found = self._with_names(expression).xreplace(self._by_value)
        while (total := size(found)) > _SHORT:
            part = _best(found, self.unnamed, forced=total > LONGEST)
            if part is None:
                break
            rules.append({part: self._named(part)})
            found = found.xreplace(rules[-1])
        return found, rules

    def _named(self, part: Expr) -> Expr:
        value, _ = self._shortened(part)
        symbol = self._by_value.get(value)
        if symbol is None:
            if len(self._values) == self.most:
                raise _TooManyError
            symbol = self.symbol(len(self._values) + 1)
            self.made.append((symbol, value))
            self._by_value |= {value: symbol, part: symbol, replaced(part, self._values): symbol}
            self._values[symbol] = replaced(value, self._values)
        return symbol


def _roots(expression: Expr) -> dict[Expr, dict[Expr, int]]:
    """Long sums under square roots that are in no other one, with their powers and how often these occur."""
    found: dict[Expr, dict[Expr, int]] = {}
    stack = [expression]
    while stack:
        node = stack.pop()
        if node.is_Pow and node.exp.is_Rational and node.exp.q == 2 and node.base.is_Add and size(node) >= _LONG_ROOT:
            own = found.setdefault(node.base, {})
            own[node.exp] = own.get(node.exp, 0) + 1
            continue
        stack.extend(node.args)
    return found


def _sizes(expression: Expr) -> dict[Expr, int]:
    """Of each part, the parts of a part before it."""
    known: dict[Expr, int] = {}
    for node in postorder(expression, known):
        known[node] = 1 + sum(known[argument] for argument in node.args)
    return known


def _best(expression: Expr, unnamed: frozenset[Symbol], *, forced: bool) -> Expr | None:
    """The part whose name saves the most; `forced` takes the largest one of a readable size if none occurs twice."""
    sizes = _sizes(expression)
    parts = [part for part in reversed(sizes) if part != expression]
    counts = dict.fromkeys(sizes, 0)
    counts[expression] = 1
    for part in (expression, *parts):  # a part comes after all that it is in
        for argument in part.args:
            counts[argument] += counts[part]
    able = [part for part in parts if sizes[part] >= _SMALLEST and not part.free_symbols & unnamed]
    gains = {part: (counts[part] - 1) * (sizes[part] - 1) for part in able}
    best = max(able, key=lambda part: gains[part], default=None)
    if best is not None and gains[best] >= _LEAST_GAIN:
        return best
    readable = [part for part in able if sizes[part] <= LONGEST // 2] if forced else []
    return max(readable, key=lambda part: sizes[part], default=None)
