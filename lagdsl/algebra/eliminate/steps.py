"""Record of an elimination, step by step: the factor of the system, with which any right-hand side is solved."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.algebra.eliminate.count import Budget
from lagdsl.algebra.eliminate.rows import is_multiplier
from lagdsl.algebra.graph.graph import Graph
from lagdsl.foundation.record import record


@record()
class Defined:
    """The variable follows from its definition."""

    variable: int


@record()
class Pivoted:
    """a = h / pivot - sum of shares times others, h: what is left of the right-hand side."""

    variable: int
    pivot: int
    shares: dict[int, int]


@record()
class Exchanged:
    """A rate that follows from the variable it alone makes free: variable = rest + factor * rate."""

    rate: int
    variable: int
    factor: int


@record()
class Weightless:
    """A rate without inertia that a row gives, and the multiplier of the row, which the equation of the rate gives.

    `row` has the other rates of the row, `column` the multipliers of the other rows with the rate; nodes.
    """

    rate: int
    multiplier: int
    factor: int
    row: dict[int, int]
    column: dict[int, int]


Step = Defined | Pivoted | Exchanged | Weightless


def solve_steps(
    graph: Graph,
    terms: Mapping[int, Mapping[int, int]],
    steps: Sequence[Step],
    side: Mapping[int, int],
    budget: Budget,
) -> dict[int, int]:
    """Accelerations of all variables, and multipliers, for a right-hand side by variable; `terms` are the definitions.

    Raises TooMany.
    """
    return _backward(graph, terms, steps, _forward(graph, terms, steps, side, budget), budget)


def strength(
    graph: Graph,
    terms: Mapping[int, Mapping[int, int]],
    steps: Sequence[Step],
    row: Mapping[int, int],
) -> tuple[int, int]:
    """The part of row' A^-1 row that the rates give, and the one that multipliers take from it."""
    parts = _forward(graph, terms, steps, row, Budget(graph, None))
    given, taken = [], []
    for step in steps:
        if isinstance(step, Pivoted) and parts[step.variable] != graph.zero:
            part = parts[step.variable]
            own = graph.multiply(graph.multiply(part, part), step.pivot)
            if is_multiplier(step.variable):
                taken.append(graph.negate(own))
            else:
                given.append(own)
    return graph.sum(given), graph.sum(taken)


def _forward(
    graph: Graph,
    terms: Mapping[int, Mapping[int, int]],
    steps: Sequence[Step],
    side: Mapping[int, int],
    budget: Budget,
) -> dict[int, int]:
    """h / pivot of every variable with an equation of its own. Most of a side may be zero: one row of many."""
    left = dict(side)
    parts: dict[int, int] = {}
    zero = graph.zero

    def move(source: int, shares: Mapping[int, int]) -> None:
        if source == zero:
            return
        budget.check()
        for p, share in shares.items():
            moved = graph.multiply(share, source)
            if moved != zero:
                left[p] = graph.add(left.get(p, zero), moved)

    for step in steps:
        match step:
            case Defined(variable):
                move(left.pop(variable, zero), terms[variable])
            case Pivoted(variable, pivot, shares):
                own = left.pop(variable, zero)
                parts[variable] = zero
                if own != zero:
                    parts[variable] = graph.multiply(own, graph.divide(graph.one, pivot))
                    move(graph.negate(own), shares)
            case Exchanged(rate, variable, factor):
                own = graph.divide(left.pop(rate, zero), factor)
                move(own, {variable: graph.one})
                move(graph.negate(own), {p: c for p, c in terms[variable].items() if p != rate})
            case Weightless(rate, multiplier, factor, row, column):
                parts[rate] = graph.negate(graph.divide(left.pop(multiplier, zero), factor))
                parts[multiplier] = graph.negate(graph.divide(left.pop(rate, zero), factor))
                move(parts[multiplier], row)
                move(parts[rate], column)
    return parts


def _backward(
    graph: Graph,
    terms: Mapping[int, Mapping[int, int]],
    steps: Sequence[Step],
    parts: Mapping[int, int],
    budget: Budget,
) -> dict[int, int]:
    known: dict[int, int] = {}
    zero = graph.zero

    def total(shares: Mapping[int, int]) -> int:
        found = zero
        for p, c in shares.items():
            if known[p] != zero:
                found = graph.add(found, graph.multiply(c, known[p]))
        if found != zero:
            budget.check()
        return found

    for step in reversed(steps):
        match step:
            case Pivoted(variable, _, shares):
                known[variable] = graph.subtract(parts[variable], total(shares))
            case Defined(variable):
                known[variable] = total(terms[variable])
            case Exchanged(rate, variable, factor):
                rest = graph.subtract(known[variable], total({p: c for p, c in terms[variable].items() if p != rate}))
                known[rate] = graph.divide(rest, factor)
            case Weightless(rate, multiplier, factor, row, column):
                known[rate] = graph.subtract(parts[rate], graph.divide(total(row), factor))
                acting = {p: c for p, c in column.items() if p in known}
                known[multiplier] = graph.subtract(parts[multiplier], graph.divide(total(acting), factor))
    return known
