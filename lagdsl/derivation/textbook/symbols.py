"""The symbols of a model, and what differentiation by time means for them.

A symbol carries the name the user gave, so that `model.equations` reads like the model; SymPy never parses these names,
and printing goes through a table of its own. Arguments of motion are plain symbols: q, der(q), der(der(q)) are
independent in partial derivatives, and the total derivative is the chain rule over all of them.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass

from sympy import Expr, Integer, Symbol

from lagdsl.language.flat.events import entries
from lagdsl.language.flat.model import FlatModel


@dataclass(frozen=True, slots=True, kw_only=True)
class Symbols:
    """Symbols in the order of the layout; `lam` holds one multiplier per constraint row."""

    time: Symbol
    q: tuple[Symbol, ...]
    qd: tuple[Symbol, ...]
    qdd: tuple[Symbol, ...]
    z: tuple[Symbol, ...]
    u: tuple[Symbol, ...]
    w: tuple[Symbol, ...]
    p: tuple[Symbol, ...]
    lam: tuple[Symbol, ...]


def symbols(flat: FlatModel) -> Symbols:
    names = [coordinate.name for coordinate in flat.coordinates]
    rows = [row for constraint in flat.constraints for row in constraint.rows]
    return Symbols(
        time=Symbol("time"),
        q=tuple(Symbol(name) for name in names),
        qd=tuple(Symbol(f"der({name})") for name in names),
        qdd=tuple(Symbol(f"der(der({name}))") for name in names),
        z=tuple(Symbol(state.name) for state in flat.states),
        u=tuple(Symbol(item.name) for item in flat.inputs),
        w=tuple(Symbol(entry.name) for entry in entries(flat.events)),
        p=tuple(Symbol(item.name) for item in flat.parameters if not item.structural),
        lam=tuple(Symbol(f"multiplier({row})") for row in rows),
    )


def rates_of_motion(flat: FlatModel, symbols: Symbols) -> dict[Symbol, Expr]:
    """d/dt of time, coordinates, rates, and of inputs whose derivatives are inputs too, and of delayed values."""
    rates: dict[Symbol, Expr] = {symbols.time: Integer(1)}
    rates |= dict(zip(symbols.q, symbols.qd, strict=True))
    rates |= dict(zip(symbols.qd, symbols.qdd, strict=True))
    for item, symbol in zip(flat.inputs, symbols.u, strict=True):
        if item.derivative_of is not None:
            rates[Symbol(item.derivative_of)] = symbol
    rates |= {Symbol(each.name): Symbol(each.rate) for each in flat.events.delays}
    return rates


def occurring(expression: Expr) -> set[Symbol]:
    """The symbols of an expression; shared parts are looked at once, which SymPy's `free_symbols` does not."""
    found: set[Symbol] = set()
    seen: set[int] = set()
    stack = [expression]
    while stack:
        node = stack.pop()
        if id(node) in seen:
            continue
        seen.add(id(node))
        if node.is_Symbol:
            found.add(node)
        stack.extend(node.args)
    return found


def postorder(expression: Expr, known: Container[Expr]) -> Iterator[Expr]:
    """Every node after its arguments, shared ones once; nodes in `known` are left out with all below.

    The caller enters each node into `known` before it asks for the next one. Expressions may nest deeper than Python
    recurses.
    """
    stack = [expression]
    while stack:
        node = stack.pop()
        if node in known:
            continue
        waiting = [argument for argument in node.args if argument not in known]
        if waiting:
            stack += (node, *waiting)
        else:
            yield node


def replaced(expression: Expr, by: Mapping[Symbol, Expr]) -> Expr:
    """The expression with symbols replaced; shared parts are made once, which SymPy's `xreplace` does not."""
    known: dict[Expr, Expr] = dict(by)
    for node in postorder(expression, known):
        inner = [known[argument] for argument in node.args]
        same = all(one is other for one, other in zip(inner, node.args, strict=True))
        known[node] = node if same else node.func(*inner)
    return known[expression]
