"""Record of an elimination, step by step: the factor of the system, with which any right-hand side is solved."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from heapq import heapify, heappop, heappush

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


@record()
class Steps:
    """Steps in their order, with the definitions `terms`; which of them takes a variable out of a right-hand side, and
    which ones read its value. Most of a side may be zero, one row of many: what is not zero alone is followed."""

    terms: Mapping[int, Mapping[int, int]]
    order: Sequence[Step]
    takers: dict[int, int]
    readers: dict[int, list[int]]


def steps_of(terms: Mapping[int, Mapping[int, int]], order: Sequence[Step]) -> Steps:
    takers: dict[int, int] = {}
    readers: dict[int, list[int]] = {}
    for number, step in enumerate(order):
        match step:
            case Defined(variable):
                taken, read = [variable], [*terms[variable]]
            case Pivoted(variable, _, shares):
                taken, read = [variable], [*shares]
            case Exchanged(rate, variable, _):
                taken, read = [rate], [variable, *terms[variable]]
            case Weightless(rate, multiplier, _, row, column):
                taken, read = [rate, multiplier], [*row, *column]
        takers.update(dict.fromkeys(taken, number))
        for variable in read:
            readers.setdefault(variable, []).append(number)
    return Steps(terms, order, takers, readers)


class _Queue:
    """Numbers of steps that are to be carried out, each once, in one direction (1 or -1)."""

    def __init__(self, direction: int, numbers: Iterable[int]) -> None:
        self._direction = direction
        self._waiting = set(numbers)
        self._heap = [direction * number for number in self._waiting]
        heapify(self._heap)

    def add(self, number: int) -> None:
        if number not in self._waiting:
            self._waiting.add(number)
            heappush(self._heap, self._direction * number)

    def __iter__(self) -> Iterator[int]:
        while self._heap:
            yield self._direction * heappop(self._heap)


def solve_steps(graph: Graph, steps: Steps, side: Mapping[int, int], budget: Budget) -> dict[int, int]:
    """Accelerations of variables, and multipliers, for a right-hand side by variable; those not there are zero.

    Raises TooMany.
    """
    return _backward(graph, steps, _forward(graph, steps, side, budget), budget)


def strength(graph: Graph, steps: Steps, row: Mapping[int, int]) -> tuple[int, int]:
    """The part of row' A^-1 row that the rates give, and the one that multipliers take from it."""
    given, taken = [], []
    for variable, part in _forward(graph, steps, row, Budget(graph, None)).items():
        step = steps.order[steps.takers[variable]]
        if isinstance(step, Pivoted):
            own = graph.multiply(graph.multiply(part, part), step.pivot)
            if is_multiplier(variable):
                taken.append(graph.negate(own))
            else:
                given.append(own)
    return graph.sum(given), graph.sum(taken)


def _forward(graph: Graph, steps: Steps, side: Mapping[int, int], budget: Budget) -> dict[int, int]:
    """h / pivot of variables with an equation of their own, where it is not zero."""
    left = dict(side)
    parts: dict[int, int] = {}
    zero = graph.zero
    takers = steps.takers
    queue = _Queue(1, (takers[p] for p, source in left.items() if source != zero and p in takers))

    def move(source: int, shares: Mapping[int, int]) -> None:
        if source == zero:
            return
        budget.check()
        for p, share in shares.items():
            moved = graph.multiply(share, source)
            if moved != zero:
                left[p] = graph.add(left.get(p, zero), moved)
                if p in takers:
                    queue.add(takers[p])

    for number in queue:
        match steps.order[number]:
            case Defined(variable):
                move(left.pop(variable, zero), steps.terms[variable])
            case Pivoted(variable, pivot, shares):
                own = left.pop(variable, zero)
                if own != zero:
                    parts[variable] = graph.multiply(own, graph.divide(graph.one, pivot))
                    move(graph.negate(own), shares)
            case Exchanged(rate, variable, factor):
                own = graph.divide(left.pop(rate, zero), factor)
                move(own, {variable: graph.one})
                move(graph.negate(own), {p: c for p, c in steps.terms[variable].items() if p != rate})
            case Weightless(rate, multiplier, factor, row, column):
                parts[rate] = graph.negate(graph.divide(left.pop(multiplier, zero), factor))
                parts[multiplier] = graph.negate(graph.divide(left.pop(rate, zero), factor))
                move(parts[multiplier], row)
                move(parts[rate], column)
    return {p: part for p, part in parts.items() if part != zero}


def _backward(graph: Graph, steps: Steps, parts: Mapping[int, int], budget: Budget) -> dict[int, int]:
    known: dict[int, int] = {}
    zero = graph.zero
    queue = _Queue(-1, (steps.takers[p] for p in parts))

    def total(shares: Mapping[int, int]) -> int:
        found = zero
        for p, c in shares.items():
            if known.get(p, zero) != zero:
                found = graph.add(found, graph.multiply(c, known[p]))
        if found != zero:
            budget.check()
        return found

    for number in queue:
        for variable, value in _values(graph, steps, steps.order[number], parts, total):
            if value != zero:
                known[variable] = value
                for reader in steps.readers.get(variable, ()):
                    if reader < number:
                        queue.add(reader)
    return known


def _values(
    graph: Graph, steps: Steps, step: Step, parts: Mapping[int, int], total: Callable[[Mapping[int, int]], int]
) -> Iterator[tuple[int, int]]:
    """The variables that a step gives, each with its value, from the sums `total` of shares of those that are known."""
    zero = graph.zero
    match step:
        case Pivoted(variable, _, shares):
            yield variable, graph.subtract(parts.get(variable, zero), total(shares))
        case Defined(variable):
            yield variable, total(steps.terms[variable])
        case Exchanged(rate, variable, factor):
            others = {p: c for p, c in steps.terms[variable].items() if p != rate}
            yield rate, graph.divide(graph.subtract(total({variable: graph.one}), total(others)), factor)
        case Weightless(rate, multiplier, factor, row, column):
            yield rate, graph.subtract(parts.get(rate, zero), graph.divide(total(row), factor))
            yield multiplier, graph.subtract(parts.get(multiplier, zero), graph.divide(total(column), factor))
