"""Velocities by the rates of the model's own definitions: of l cos b it is -l b' sin b, and b' follows from b."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from sympy import Expr, Symbol

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.textbook.differentiate import along
from lagdsl.derivation.textbook.geometry import Vector
from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY, STANDARD_GRAVITY_VALUE
from lagdsl.derivation.textbook.symbols import rates_of_motion
from lagdsl.derivation.textbook.tidy import Tidy, size
from lagdsl.derivation.textbook.to_graph import ToGraph
from lagdsl.documents.report.page import Page

_LONG = 60
_STATES = 8
_NEAR, _FAR = (0.98, 1.02), (0.5, 1.5)
_CLOSE = 1e-9


def velocity(page: Page, position: Vector, written_out: Vector) -> Vector:
    """Of a position; `written_out` where no definition of the model makes that shorter."""
    named = page.typeset.intermediates.named
    x, y, z = (each.xreplace(named) for each in position)
    if not named or max(map(size, written_out)) <= _LONG or (x, y, z) == tuple(position):
        return written_out
    rates = _rates(page)
    shown = (along(x, rates), along(y, rates), along(z, rates))
    _define(page, shown)
    return shown


def spin(page: Page, written_out: Expr) -> Expr:
    """An angular velocity in a plane; the rate of a definition of the model where it is that one at random states."""
    if size(written_out) <= _LONG:
        return written_out
    plain = rates_of_motion(page.flat, page.derivation.symbols)
    for value, symbol in page.typeset.intermediates.named.items():
        if _same(page, written_out, along(value, plain)):
            rate = Symbol(f"der({symbol.name})")
            _define(page, (rate,))
            return rate
    return written_out


def _rates(page: Page) -> dict[Symbol, Expr]:
    own = {symbol: Symbol(f"der({symbol.name})") for symbol, _ in page.derivation.definitions}
    return rates_of_motion(page.flat, page.derivation.symbols) | own


def _define(page: Page, shown: Iterable[Expr]) -> None:
    """Rates of definitions that are shown get their own lines, those that they are written with before them."""
    d, rates = page.derivation, _rates(page)
    tidy = Tidy(d.constants, frozenset(symbol for symbol in d.constants if page.is_positive(symbol)))
    wanted = {symbol for each in shown for symbol in each.free_symbols}
    lines: list[tuple[Symbol, Expr]] = []
    for symbol, value in reversed(d.definitions):
        rate = rates[symbol]
        if rate in wanted:
            lines.append((rate, tidy(along(value, rates))))
            wanted |= lines[-1][1].free_symbols
    page.typeset.intermediates.define(reversed(lines))
    page.typeset.intermediates.used |= {symbol for symbol, _ in d.definitions if symbol in wanted}


def _same(page: Page, one: Expr, other: Expr) -> bool:
    """True if both have the same values at random states, parameters close to those of the model."""
    draw = np.random.default_rng(3)
    near = {Symbol(parameter.name): parameter.value for parameter in page.flat.parameters}
    near[STANDARD_GRAVITY] = float(STANDARD_GRAVITY_VALUE)
    symbols = sorted(one.free_symbols | other.free_symbols, key=str)
    values = [near.get(s, 1.0) * draw.uniform(*(_NEAR if s in near else _FAR), _STATES) for s in symbols]
    graph = Graph()
    to_graph = ToGraph(graph, {symbol: graph.symbol(Group.P, index) for index, symbol in enumerate(symbols)})
    first, second = evaluate(graph, [to_graph.node(one), to_graph.node(other)], {Group.P: np.stack(values, axis=-1)})
    possible = np.isfinite(first) & np.isfinite(second)  # a loop may not close at a random state
    return bool(np.count_nonzero(possible) > 2 and np.all(np.abs(first - second)[possible] < _CLOSE))
