"""Rates without inertia, exchanged with multipliers before anything else is eliminated.

A row with a constant entry gives such a rate, and the equation of the rate, in which nothing but multipliers stands,
gives the multiplier of the row. The charge of a capacitor is one, and the row is Kirchhoff's law of its node: what is
left has the charges of meshes as unknowns. Each pair has the least product of other entries in its row and its column,
which bounds the fill (Markowitz, *Management Science* 3 (1957), 255), and an entry that is not small in its column
(Duff, Erisman and Reid, *Direct Methods for Sparse Matrices*, 2nd ed., 2017, section 5.2).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from heapq import heapify, heappop, heappush

from lagdsl.algebra.eliminate.form import AccelerationForm, NotApplicable
from lagdsl.algebra.eliminate.rows import Row, Rows, multiplier_of
from lagdsl.algebra.eliminate.steps import Step, Weightless
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Op
from lagdsl.foundation.record import record

# The least entry, as a part of the largest one of its column.
_NOT_SMALL = 0.1
# Subtraction that leaves less than this part of a constant entry leaves round-off.
_ROUND_OFF = 1e-13


@record(kw_only=True)
class Reduced:
    """`steps` in their order, and the rows that are `left`, without the rates that were exchanged."""

    steps: tuple[Weightless, ...]
    left: Rows


def reduce(form: AccelerationForm, rates: Sequence[int], rows: Rows) -> Reduced:
    """Exchange all rates that have no inertia, and constant entries only, with multipliers of solved rows.

    Raises NotApplicable where this leaves nothing of a solved row.
    """
    exchange = _Exchange(form.graph, rows, _without_inertia(form, rates))
    steps = tuple(exchange.run())
    solved = exchange.left([row for row in rows.solved if row.index in exchange.solved])
    following = [row for row in exchange.left(rows.following) if row.terms]
    if not all(row.terms for row in solved) or (following and not solved):
        raise NotApplicable
    left = replace(rows, solved=tuple(solved), following=tuple(following), kept=tuple(exchange.left(rows.kept)))
    return Reduced(steps=steps, left=left)


def reduced_biases(graph: Graph, steps: Sequence[Step], biases: Mapping[int, int]) -> dict[int, int]:
    """Accelerations along the rows that are left, by multiplier."""
    known = {multiplier_of(index): bias for index, bias in biases.items()}
    for step in steps:
        if isinstance(step, Weightless):
            own = graph.divide(known.pop(step.multiplier, graph.zero), step.factor)
            for multiplier, entry in step.column.items():
                given = known.get(multiplier, graph.zero)
                known[multiplier] = graph.subtract(given, graph.multiply(entry, own))
    return known


def shares(graph: Graph, steps: Sequence[Weightless]) -> dict[int, dict[int, int]]:
    """By multiplier that was exchanged, in order, its dependence on others."""
    return {s.multiplier: {p: graph.divide(c, s.factor) for p, c in s.column.items()} for s in steps}


def _without_inertia(form: AccelerationForm, rates: Sequence[int]) -> list[int]:
    """Rates that no velocity with a weight or a force is made of; a force may act on them directly."""
    graph = form.graph
    used = form.weights.keys() | set(
        graph.live(v for v in (*form.weights, *form.forces) if graph.op[v] is not Op.SYMBOL)
    )
    return [rate for rate in rates if rate not in used]


class _Exchange:
    """The entries of all rows by index and rate, and the rows of each rate without inertia."""

    def __init__(self, graph: Graph, rows: Rows, rates: Collection[int]) -> None:
        self._graph = graph
        self.solved = {row.index: None for row in rows.solved}
        changed = (*rows.solved, *rows.following, *(row for row in rows.kept if row.index in rows.stiffened))
        self._rows = {row.index: dict(row.terms) for row in changed}
        self._columns: dict[int, dict[int, None]] = {rate: {} for rate in rates}
        for index, terms in self._rows.items():
            for rate in terms:
                if rate in self._columns:
                    self._columns[rate][index] = None

    def left(self, rows: Sequence[Row]) -> list[Row]:
        return [replace(row, terms=self._rows.get(row.index, row.terms)) for row in rows]

    def run(self) -> list[Weightless]:
        heap = [(self._choice(rate)[0], rate) for rate in self._columns]
        heapify(heap)
        steps = []
        while heap:
            known, rate = heappop(heap)
            if rate not in self._columns:
                continue
            cost, index = self._choice(rate)
            if index is None:
                continue
            if cost > known:
                heappush(heap, (cost, rate))
                continue
            steps.append(self._exchange(rate, index))
            for other in steps[-1].row:  # their columns are shorter now
                if other in self._columns:
                    heappush(heap, (self._choice(other)[0], other))
        return steps

    def _choice(self, rate: int) -> tuple[int, int | None]:
        """The row to exchange with, and the bound of the fill; None where there is no such row."""
        graph, column = self._graph, self._columns[rate]
        entries = {index: self._rows[index][rate] for index in column}
        if not all(graph.is_constant(entry) for entry in entries.values()):
            return 0, None
        sizes = {index: abs(graph.value[entry]) for index, entry in entries.items()}
        least = _NOT_SMALL * max(sizes.values(), default=0.0)
        fills = [
            ((len(self._rows[index]) - 1) * (len(column) - 1), index)
            for index, size in sizes.items()
            if index in self.solved and size >= least
        ]
        return min(fills, default=(0, None))

    def _exchange(self, rate: int, index: int) -> Weightless:
        graph = self._graph
        own = self._rows.pop(index)
        del self.solved[index]
        for other in own:
            if other in self._columns:
                del self._columns[other][index]
        factor = own.pop(rate)
        column = {other: self._rows[other].pop(rate) for other in self._columns.pop(rate)}
        for other, entry in column.items():
            self._subtract(other, graph.divide(entry, factor), own)
        return Weightless(rate, multiplier_of(index), factor, own, {multiplier_of(i): e for i, e in column.items()})

    def _subtract(self, index: int, share: int, row: Mapping[int, int]) -> None:
        graph, terms = self._graph, self._rows[index]
        for rate, entry in row.items():
            before = terms.get(rate, graph.zero)
            after = graph.subtract(before, graph.multiply(share, entry))
            if self._is_round_off(after, before):
                after = graph.zero
            if after == graph.zero:
                terms.pop(rate, None)
            else:
                terms[rate] = after
            if rate in self._columns:
                self._columns[rate].pop(index, None)
                if after != graph.zero:
                    self._columns[rate][index] = None

    def _is_round_off(self, after: int, before: int) -> bool:
        constants = self._graph.value
        return (
            after in constants and before in constants and abs(constants[after]) <= _ROUND_OFF * abs(constants[before])
        )
