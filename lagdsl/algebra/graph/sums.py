"""Long sums with many terms in common, rearranged so that what they have in common is summed once.

x_i = t_i + ... + t_1, written out anew for every i, has no part in common with x_{i-1} as it stands: n sums then have
n^2/2 terms, and everything that is differentiated from them as many. With the terms that occur most often first, every
sum goes on where the one before ended.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from typing import TypeAlias

from lagdsl.algebra.graph.differentiate import mask_of
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op

Terms: TypeAlias = "list[tuple[int, bool]]"
"""Terms of a sum, with True where one is subtracted."""

_POSITION = mask_of((Group.P, Group.TIME, Group.Q))
_SUMS = (Op.ADD, Op.SUBTRACT, Op.NEGATE)
_LEAST_TERMS = 3
_LONG = 8
# Terms may be sums of sums: of turned angles, of places of links that are turned.
_ROUNDS = 4


def share_sums(graph: Graph, roots: Sequence[int]) -> Mapping[int, int]:
    """Replacements of the nodes below `roots`, expressions of positions, that change; values change by rounding."""
    total: dict[int, int] = {}
    for _ in range(_ROUNDS):
        changed = _share(graph, [total.get(root, root) for root in roots])
        if not changed:
            break
        total = {**changed, **{node: changed.get(made, made) for node, made in total.items()}}
    return total


def _share(graph: Graph, roots: Sequence[int]) -> dict[int, int]:
    live = graph.live(roots)
    sums = _sums(graph, live, roots)
    occurrences: dict[int, int] = {}
    for terms in sums.values():
        for term, _ in terms:
            occurrences[term] = occurrences.get(term, 0) + 1
    common = {node: terms for node, terms in sums.items() if sum(1 for term, _ in terms if occurrences[term] > 1) > 1}
    changed: dict[int, int] = {}
    for node in live if common else ():
        if node in common:
            ordered = sorted(common[node], key=lambda term: (-occurrences[term[0]], term[0]))
            made = _summed(graph, [(changed.get(term, term), negative) for term, negative in ordered])
        else:
            arguments = graph.arguments(node)
            if not any(x in changed for x in arguments):
                continue
            made = graph.rebuild(node, [changed.get(x, x) for x in arguments])
        if made != node:
            changed[node] = made
    after = graph.live([changed.get(root, root) for root in roots]) if changed else []
    fewer = _additions(graph, after) < _additions(graph, live)
    return changed if fewer else {}


def _additions(graph: Graph, nodes: Sequence[int]) -> int:
    return sum(1 for node in nodes if graph.op[node] in (Op.ADD, Op.SUBTRACT))


def _sums(graph: Graph, live: Sequence[int], roots: Sequence[int]) -> dict[int, Terms]:
    """Sums of at least _LEAST_TERMS terms that are not only parts of others. None where most is shared already, and
    writing them all out would be long."""
    inner = [node for node in live if graph.op[node] in _SUMS and not graph.groups[node] & ~_POSITION]
    named = dict.fromkeys(roots)
    whole = dict(named)
    for node in live:
        if graph.op[node] not in _SUMS:
            whole |= dict.fromkeys(graph.arguments(node))
    sums = [node for node in inner if node in whole and graph.depends(node, Group.Q)]
    single = {x for node in inner for x in graph.arguments(node) if graph.op[x] not in _SUMS}
    lengths: dict[int, int] = {}
    for node in inner:
        lengths[node] = sum(lengths.get(x, 1) for x in graph.arguments(node))
    if len(inner) <= len(sums) + len(single) and sum(lengths[node] for node in sums) > _LONG * len(live):
        return {}
    found = {}
    for node in sums:
        terms = _terms(graph, node, ())
        if len(dict.fromkeys(term for term, _ in terms)) < len(terms):
            terms = _terms(graph, node, named)
        if len(terms) >= _LEAST_TERMS:
            found[node] = terms
    return found


def _terms(graph: Graph, root: int, whole: Container[int]) -> Terms:
    """Terms of the sum `root`; of `whole` each is one term of it."""
    found: Terms = []
    stack = [(root, False)]
    while stack:
        node, negative = stack.pop()
        if graph.op[node] not in _SUMS or (node != root and node in whole):
            found.append((node, negative))
        elif graph.op[node] is Op.NEGATE:
            stack.append((graph.a[node], not negative))
        else:
            stack.append((graph.b[node], negative != (graph.op[node] is Op.SUBTRACT)))
            stack.append((graph.a[node], negative))
    return found


def _summed(graph: Graph, terms: Terms) -> int:
    total = graph.zero
    for term, negative in terms:
        total = graph.subtract(total, term) if negative else graph.add(total, term)
    return total
