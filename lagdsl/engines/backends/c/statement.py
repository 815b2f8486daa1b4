"""Statements of a function, in order: variables, stores, and sines and cosines of many arguments at once."""

from __future__ import annotations

from collections.abc import Collection, Container, Mapping, Sequence

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Op
from lagdsl.derivation.program.passes.fuse import fusible
from lagdsl.derivation.program.passes.schedule import schedule
from lagdsl.engines.backends.c.dialect import SCRATCH, Place
from lagdsl.foundation.record import record


@record()
class Store:
    """`target` receives the value of `node`; `comment` tells where in the user's text it comes from."""

    target: Place
    node: int
    comment: str = ""


@record()
class Gather:
    """Sines and cosines of `count` arguments: in the scratch array from `first` on, arguments, sines and cosines."""

    first: int
    count: int


@record()
class Statement:
    """The variable of `node`, or a store of it, or a gathering."""

    node: int
    store: Store | None = None
    gather: Gather | None = None

    @property
    def is_variable(self) -> bool:
        return self.store is None and self.gather is None


@record()
class Listing:
    """`given` are the places of values that are at hand; the scratch array starts with `gathered` entries in use."""

    graph: Graph
    statements: tuple[Statement, ...]
    given: Mapping[int, Place]
    gathered: int


def listing(
    graph: Graph, stores: tuple[Store, ...], given: Mapping[int, Place], exact: Collection[int] | None = None
) -> Listing:
    """Statements that do all `stores`, each as soon as it can be done; `given` values are in their places already.

    Sines and cosines come first: those of arguments that hold no others, then what further ones need, and so on.
    With `exact`, the nodes that are not to be fused, products that all their sums can be fused with get no variable.
    """
    live = graph.live([store.node for store in stores], given)
    turned = [node for node in live if graph.op[node] in (Op.SIN, Op.COS) and node not in given]
    level = _levels(graph, turned, given)
    gathers, inner, known = _gathers(graph, level, turned, given)
    every = [*inner, *stores]
    roots = [store.node for store in every]
    inside = () if exact is None else fusible(graph, live, roots, exact)
    named: Sequence[int] = schedule(graph, roots, known, live, inside).named
    if level:
        named = sorted(named, key=lambda node: (level.get(node, len(gathers)), node))
    position = {node: index for index, node in enumerate(named)}
    due: list[list[Statement]] = [[] for _ in range(len(named) + 1)]
    for store in every:
        statement = Statement(store.node, store)
        last = max((position[node] for node in reads(graph, statement, position, known)), default=-1)
        due[1 + last].append(statement)
    return Listing(graph, tuple(_ordered(named, due, level, gathers)), known, 3 * len(inner))


def _levels(graph: Graph, turned: Sequence[int], given: Mapping[int, Place]) -> dict[int, int]:
    """For what sines and cosines are computed from: how many of these are one inside the other."""
    level: dict[int, int] = {}
    inside = set(turned)
    for node in graph.live([graph.a[node] for node in turned], given):
        if node not in given:
            level[node] = max((level.get(x, 0) for x in graph.operands[node]), default=0) + (node in inside)
    return level


def _gathers(
    graph: Graph, level: Mapping[int, int], turned: Sequence[int], given: Mapping[int, Place]
) -> tuple[list[Gather], list[Store], dict[int, Place]]:
    """One gathering per level, the stores of their arguments, and `given` with the places of what they give."""
    gathers: list[Gather] = []
    stores: list[Store] = []
    place: dict[int, tuple[int, int]] = {}
    by_level: dict[int, list[int]] = {}
    for argument in dict.fromkeys(graph.a[node] for node in turned):
        by_level.setdefault(level.get(argument, 0), []).append(argument)
    first = 0
    for which in sorted(by_level):
        group = by_level[which]
        gathers.append(Gather(first, len(group)))
        for index, argument in enumerate(group, first):
            stores.append(Store(Place(SCRATCH, index), argument))
            place[argument] = (index, len(group))
        first += 3 * len(group)
    known = dict(given)
    for node in turned:
        index, count = place[graph.a[node]]
        known[node] = Place(SCRATCH, index + (count if graph.op[node] is Op.SIN else 2 * count))
    return gathers, stores, known


def _ordered(
    named: Sequence[int], due: list[list[Statement]], level: Mapping[int, int], gathers: list[Gather]
) -> list[Statement]:
    """Variables by level, stores after what they read, and gatherings between the levels."""
    ordered: list[Statement] = []
    depth, last = 0, len(gathers)
    waiting: list[list[Statement]] = [[] for _ in range(len(gathers) + 1)]

    def put(statements: list[Statement]) -> None:
        for statement in statements:
            needed = level.get(statement.node, last)
            (ordered if needed <= depth else waiting[needed]).append(statement)

    put(due[0])
    for index in range(len(named) + 1):
        wanted = level.get(named[index], last) if index < len(named) else last
        while depth < wanted:
            ordered.append(Statement(-1, gather=gathers[depth]))
            depth += 1
            ordered.extend(waiting[depth])
        if index < len(named):
            ordered.append(Statement(named[index]))
            put(due[index + 1])
    return ordered


def reads(graph: Graph, statement: Statement, named: Container[int], known: Container[int]) -> tuple[int, ...]:
    """The variables, of the nodes `named`, that the expression of a statement reads."""
    node = statement.node
    if statement.gather is not None:
        return ()
    if statement.store is not None and node in named:
        return (node,)
    found: dict[int, None] = {}
    operands = graph.operands
    stack = [] if node in known else list(operands[node])
    while stack:
        operand = stack.pop()
        if operand in named:
            found[operand] = None
        elif operand not in known:
            stack.extend(operands[operand])
    return tuple(found)
