"""Meaning of a dotted name, before anything has a value: symbols, components, the world."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TypeAlias, assert_never

from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.foundation.record import record
from lagdsl.language.semantics.operators.arrays import subscript_indices, turns
from lagdsl.language.semantics.operators.conditions import condition_of
from lagdsl.language.semantics.operators.geometry import METHODS
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import (
    ClassSymbol,
    Entry,
    FunctionSymbol,
    Indices,
    Instance,
    InstanceArray,
    Scope,
    Symbol,
    TypeSymbol,
    lookup,
)
from lagdsl.language.semantics.scope.values import POISON, AnyValue, FrameValue
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import children, descendants


@record()
class World:
    pass


@record()
class Element:
    """A declared name, or one element of it; `indices` None: all of it."""

    symbol: Symbol
    indices: Indices | None


@record()
class Absent:
    """Something of a component whose condition is false."""


Target: TypeAlias = "World | Element | Instance | InstanceArray | Absent"


def target_of(ctx: Context, scope: Scope, node: nodes.Expression) -> Target | None:
    """The item that the text names; None if it names none of these. Reports nothing."""
    match node:
        case nodes.Parenthesized():
            return target_of(ctx, scope, node.inner)
        case nodes.Reference():
            entry = lookup(scope, node.name)
            return World() if entry is None and node.name == "world" else _target(ctx, entry)
        case nodes.Member():
            around = target_of(ctx, scope, node.target)
            if isinstance(around, Absent) or (isinstance(around, Instance) and not around.present):
                return Absent()
            if isinstance(around, Instance) and node.name not in around.protected:
                return _target(ctx, around.scope.entries.get(node.name))
            return None
        case nodes.Index():
            return _indexed(ctx, scope, node)
        case nodes.Literal() | nodes.Compound():
            return None
        case _:
            assert_never(node)


def _target(ctx: Context, entry: Entry | None) -> Target | None:
    match entry:
        case Symbol():
            scalar = entry.declarator is not None and not ctx.resolver.shape(ctx, entry)
            return Element(entry, () if scalar else None)
        case Instance() if not entry.present:
            return Absent()
        case Instance() | InstanceArray():
            return entry
        case FunctionSymbol() | TypeSymbol() | ClassSymbol() | AnyValue() | None:
            return None
        case _:
            assert_never(entry)


def _indexed(ctx: Context, scope: Scope, node: nodes.Index) -> Target | None:
    around = target_of(ctx, scope, node.target)
    if isinstance(around, Absent):
        return around
    if isinstance(around, InstanceArray):
        indices = _indices(ctx, scope, node, around.shape)
        return _target(ctx, around.elements.get(indices)) if indices is not None else None
    if isinstance(around, Element) and around.indices is None:
        shape = ctx.resolver.shape(ctx, around.symbol)
        indices = _indices(ctx, scope, node, shape) if shape else None
        return Element(around.symbol, indices)
    return None


def _indices(ctx: Context, scope: Scope, node: nodes.Index, shape: tuple[int, ...]) -> Indices | None:
    with _quietly(ctx):
        found = subscript_indices(ctx, scope, node.subscripts, shape, node)
    if found is None or len(found) != len(shape):
        return None
    indices = tuple(index for index in found if isinstance(index, int))
    return indices if len(indices) == len(shape) else None


class _Quiet(Sink):
    """Drops what is said about the text at hand, which is said when it is elaborated, and keeps the rest.

    A symbol that gets its value on the way has it for good, and so what is wrong with it is said here or never.
    """

    def __init__(self, ctx: Context, kept: Sink) -> None:
        super().__init__()
        self._ctx, self._kept, self._depth = ctx, kept, len(ctx.current.active)

    def add(self, diagnostic: Diagnostic) -> None:
        if len(self._ctx.current.active) > self._depth:
            self._kept.add(diagnostic)


@contextmanager
def _quietly(ctx: Context) -> Iterator[None]:
    sink, reported, turns = ctx.sink, set(ctx.reports.reported), ctx.counts.turns
    ctx.sink = _Quiet(ctx, sink)
    try:
        yield
    finally:
        ctx.sink, ctx.reports.reported, ctx.counts.turns = sink, reported, turns


def inner_texts(ctx: Context, scope: Scope, node: nodes.Node) -> Iterator[tuple[Scope, nodes.Node]]:
    """The children of a node with the scopes they are read in: those of a comprehension know its indices.

    Each turn counts by itself where components are chosen by the index; else one text stands for all.
    """
    if not isinstance(node, nodes.Comprehension | nodes.Reduction):
        yield from ((scope, child) for child in children(node))
        return
    unknown = scope.local({iterator.name: POISON for iterator in node.iterators})
    yield from ((unknown, iterator.range) for iterator in node.iterators)
    turned: list[Scope] | None = None
    if _chooses_components(ctx, unknown, node.body):
        order = node.iterators if isinstance(node, nodes.Reduction) else node.iterators[::-1]
        with _quietly(ctx):
            turned = turns(ctx, scope, order)
    yield from ((turn, node.body) for turn in turned or (unknown,))


def texts_of(ctx: Context, scope: Scope, node: nodes.Node) -> Iterator[tuple[Scope, nodes.Node]]:
    """The node and all below it, with their scopes."""
    stack = [(scope, node)]
    while stack:
        at, current = stack.pop()
        yield at, current
        stack.extend(inner_texts(ctx, at, current))


def _chooses_components(ctx: Context, scope: Scope, node: nodes.Node) -> bool:
    return any(
        isinstance(part, nodes.Index) and isinstance(target_of(ctx, scope, part.target), InstanceArray)
        for part in descendants(node)
    )


def base_of(ctx: Context, scope: Scope, node: nodes.Expression) -> nodes.Expression | None:
    """The frame that the methods of `A.move(...).rotz(...)` start from, if the text is of that form."""
    while True:
        match node:
            case nodes.Parenthesized():
                node = node.inner
            case nodes.Conditional():
                chosen = _branch(ctx, scope, node)
                if chosen is None:
                    return None
                node = chosen
            case nodes.Call(function=nodes.Member() as function) if function.name in METHODS:
                node = function.target
            case nodes.Reference() | nodes.Member() | nodes.Index():
                return node if _is_frame(ctx, scope, node) else None
            case nodes.Literal() | nodes.Compound():
                return None
            case _:
                assert_never(node)


def _branch(ctx: Context, scope: Scope, node: nodes.Conditional) -> nodes.Expression | None:
    """The branch that a structural condition takes."""
    for branch in node.branches:
        condition = condition_of(ctx, scope, branch.condition)
        if not isinstance(condition, bool):
            return None
        if condition:
            return branch.value
    return node.otherwise


def _is_frame(ctx: Context, scope: Scope, node: nodes.Expression) -> bool:
    target = target_of(ctx, scope, node)
    match target:
        case World():
            return True
        case Element(symbol=symbol, indices=indices):
            return symbol.kind == "frame" and indices is not None
        case None:
            return isinstance(node, nodes.Reference) and isinstance(lookup(scope, node.name), FrameValue)
        case Instance() | InstanceArray() | Absent():
            return False
        case _:
            assert_never(target)
