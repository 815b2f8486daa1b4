"""Derivatives on the graph: reverse sweeps from weighted seeds, tangents along a direction, Jacobians.

Rules are local and the results share everything they can with the expressions they come from; nothing is expanded. Only
parts that depend on the symbols asked for are visited. Griewank and Walther, *Evaluating Derivatives* (2nd ed., 2008),
ch. 3.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from heapq import heapify, heappop, heappush

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import FIRST_BINARY, FIRST_UNARY, STEPS, Group, Op
from lagdsl.algebra.graph.partial import binary_partial, unary_partial

# Looking a member up in its enumeration costs as much as the rest of a rule.
_SYMBOL, _NEGATE, _ADD, _SUBTRACT, _MULTIPLY = Op.SYMBOL, Op.NEGATE, Op.ADD, Op.SUBTRACT, Op.MULTIPLY
_DIVIDE, _SELECT = Op.DIVIDE, Op.SELECT
# A small change does not pass through all arguments.
_PARTLY = frozenset((*STEPS, Op.SELECT))


def mask_of(groups: Iterable[Group]) -> int:
    """Bits of `Graph.groups` for these groups."""
    mask = 0
    for group in groups:
        mask |= 1 << group
    return mask


def adjoints(graph: Graph, seeds: Mapping[int, int], groups: Sequence[Group]) -> dict[int, int]:
    """Derivatives of sum(weight * node) with respect to the symbols of `groups`, the weights held constant.

    `seeds` maps node to weight (a node). The result maps symbol to derivative; symbols that do not matter are left out.
    One reverse sweep, a small multiple of the size of the seeded expressions, however many symbols there are.
    """
    wanted = mask_of(groups)
    masks, ops, zero, add = graph.groups, graph.op, graph.zero, graph.add
    collected = {node: weight for node, weight in seeds.items() if weight != zero and masks[node] & wanted}
    heap = [-node for node in collected]
    heapify(heap)
    result: dict[int, int] = {}
    while heap:
        node = -heappop(heap)
        adjoint = collected.pop(node)
        if adjoint == zero:
            continue
        if ops[node] is _SYMBOL:
            result[node] = adjoint
            continue
        for argument, contribution in _pull(graph, node, adjoint, wanted):
            known = collected.get(argument)
            if known is None:
                collected[argument] = contribution
                heappush(heap, -argument)
            else:
                collected[argument] = add(known, contribution)
    return result


def _pull(graph: Graph, node: int, adjoint: int, wanted: int) -> list[tuple[int, int]]:
    """Contribution of `node` with this adjoint to the adjoints of those arguments that depend on what is wanted."""
    op, masks = graph.op[node], graph.groups
    a = graph.a[node]
    if op < FIRST_BINARY:
        return [(a, graph.negate(adjoint) if op is _NEGATE else graph.multiply(adjoint, unary_partial(graph, node)))]
    b = graph.b[node]
    if op is _MULTIPLY:  # most nodes
        if not masks[b] & wanted:
            return [(a, graph.multiply(adjoint, b))]
        if not masks[a] & wanted:
            return [(b, graph.multiply(adjoint, a))]
        return [(a, graph.multiply(adjoint, b)), (b, graph.multiply(adjoint, a))]
    if op is _SELECT:
        c = graph.c[node]
        branches = ((b, graph.select(a, adjoint, graph.zero)), (c, graph.select(a, graph.zero, adjoint)))
        return [pair for pair in branches if masks[pair[0]] & wanted]
    contributions = []
    if op is _DIVIDE:
        adjoint = graph.divide(adjoint, b)
    if masks[a] & wanted:
        contributions.append((a, _weigh(graph, op, node, 0, adjoint)))
    if masks[b] & wanted:
        contributions.append((b, _weigh(graph, op, node, 1, adjoint)))
    return contributions


def _weigh(graph: Graph, op: Op, node: int, position: int, adjoint: int) -> int:
    """Adjoint times the partial derivative of a two-argument node (a quotient's adjoint is divided already)."""
    if op is _ADD:
        return adjoint
    if op is _SUBTRACT:
        return graph.negate(adjoint) if position else adjoint
    if op is _DIVIDE:
        return graph.negate(graph.multiply(adjoint, node)) if position else adjoint
    return graph.multiply(adjoint, binary_partial(graph, node, position))


class Tangent:
    """Directional derivatives of nodes, memoised: `of(node)` is the sum over all symbols of d(node)/d(symbol) * seed.

    `seed` gives the derivative of a symbol of one of `groups` as a node; all other symbols are held.
    """

    def __init__(self, graph: Graph, groups: Iterable[Group], seed: Callable[[int], int]) -> None:
        self._graph = graph
        self._mask = mask_of(groups)
        self._seed = seed
        self._known: dict[int, int] = {}

    def of(self, root: int) -> int:
        graph, known, mask = self._graph, self._known, self._mask
        masks, ops, operands = graph.groups, graph.op, graph.operands
        if not masks[root] & mask:
            return graph.zero
        stack = [root]
        while stack:
            node = stack[-1]
            if node in known:
                stack.pop()
                continue
            op = ops[node]
            if op is _SYMBOL:
                known[node] = self._seed(node)
                stack.pop()
                continue
            before = len(stack)
            for x in moved_arguments(graph, node) if op in _PARTLY else operands[node]:
                if masks[x] & mask and x not in known:
                    stack.append(x)
            if len(stack) == before:
                known[node] = push(graph, node, known)
                stack.pop()
        return known[root]

    def of_all(self, roots: Iterable[int]) -> list[int]:
        return [self.of(root) for root in roots]

    def known(self) -> Mapping[int, int]:
        """Derivatives by node of everything visited so far."""
        return self._known


def moved_arguments(graph: Graph, node: int) -> tuple[int, ...]:
    """Arguments through which a small change passes: none of a step, not the condition of a choice."""
    op = graph.op[node]
    if op in STEPS:
        return ()
    return (graph.b[node], graph.c[node]) if op is _SELECT else graph.operands[node]


def push(graph: Graph, node: int, tangents: Mapping[int, int]) -> int:
    """Tangent of `node` from those of its arguments; arguments not in `tangents` do not move."""
    op, zero = graph.op[node], graph.zero
    a, b = graph.a[node], graph.b[node]
    tangent_a = tangents.get(a, zero)
    if op < FIRST_BINARY:
        assert op >= FIRST_UNARY
        if tangent_a == zero:
            return zero
        return graph.negate(tangent_a) if op is _NEGATE else graph.multiply(unary_partial(graph, node), tangent_a)
    tangent_b = tangents.get(b, zero)
    if op is _ADD:
        return graph.add(tangent_a, tangent_b)
    if op is _MULTIPLY:
        return graph.add(graph.multiply(tangent_a, b), graph.multiply(a, tangent_b))
    if op is _SUBTRACT:
        return graph.subtract(tangent_a, tangent_b)
    if op is _SELECT:
        return graph.select(a, tangent_b, tangents.get(graph.c[node], zero))
    if tangent_a == zero and tangent_b == zero:
        return zero
    if op is _DIVIDE:
        return graph.divide(graph.subtract(tangent_a, graph.multiply(node, tangent_b)), b)
    total = zero
    if tangent_a != zero:
        total = graph.multiply(binary_partial(graph, node, 0), tangent_a)
    if tangent_b != zero:
        total = graph.add(total, graph.multiply(binary_partial(graph, node, 1), tangent_b))
    return total


def jacobian(graph: Graph, roots: Sequence[int], symbols: Sequence[int]) -> list[dict[int, int]]:
    """d(roots)/d(symbols), one reverse sweep per root over what that root depends on; row by row, by column, ascending,
    without what is identically zero."""
    groups = tuple({graph.group(symbol): None for symbol in symbols})
    columns = {symbol: column for column, symbol in enumerate(symbols)}
    rows = []
    for root in roots:
        found = adjoints(graph, {root: graph.one}, groups)
        row = {columns[symbol]: node for symbol, node in found.items() if symbol in columns and node != graph.zero}
        rows.append(dict(sorted(row.items())))
    return rows


def symmetric_jacobian(graph: Graph, roots: Sequence[int], symbols: Sequence[int]) -> list[list[int]]:
    """d(roots)/d(symbols) where it is known to be symmetric: only the lower triangle is differentiated.

    Column k is a forward push from symbol k through its users, which stops where nothing below row k is fed any more.
    """
    size = len(symbols)
    assert len(roots) == size
    users, lowest_row = _users(graph, roots, symbols)
    positions: dict[int, list[int]] = {}
    for row, root in enumerate(roots):
        positions.setdefault(root, []).append(row)
    matrix = [[graph.zero] * size for _ in range(size)]
    for column, symbol in enumerate(symbols):
        tangents: dict[int, int] = {symbol: graph.one}
        heap, queued = [symbol], {symbol}
        while heap:
            node = heappop(heap)
            if node != symbol:
                tangent = push(graph, node, tangents)
                if tangent == graph.zero:
                    continue
                tangents[node] = tangent
            for row in positions.get(node, ()):
                if row >= column:
                    matrix[row][column] = matrix[column][row] = tangents[node]
            for user in users.get(node, ()):
                if user not in queued and lowest_row[user] >= column:
                    queued.add(user)
                    heappush(heap, user)
    return matrix


def _users(graph: Graph, roots: Sequence[int], symbols: Sequence[int]) -> tuple[dict[int, list[int]], dict[int, int]]:
    """For what `roots` are computed from: the users of each node, and the last row that a node feeds."""
    wanted = mask_of({graph.group(symbol): None for symbol in symbols})
    users: dict[int, list[int]] = {}
    row_of: dict[int, int] = {}
    for row, root in enumerate(roots):
        row_of[root] = row
    live = [node for node in graph.live(roots) if graph.groups[node] & wanted]
    for node in reversed(live):
        row = row_of[node]
        for argument in dict.fromkeys(graph.arguments(node)):
            if graph.groups[argument] & wanted:
                users.setdefault(argument, []).append(node)
                row_of[argument] = max(row, row_of.get(argument, -1))
    return users, row_of
