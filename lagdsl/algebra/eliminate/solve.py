"""An acceleration form solved: candidate orders are tried, the one with the fewest operations is kept."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from lagdsl.algebra.eliminate.count import Budget, TooMany, flops
from lagdsl.algebra.eliminate.definitions import Definitions, find_definitions
from lagdsl.algebra.eliminate.form import AccelerationForm, NotApplicable
from lagdsl.algebra.eliminate.matrix import SparseSystem
from lagdsl.algebra.eliminate.order import Elimination, Order, by_creation, by_depth
from lagdsl.algebra.eliminate.pivots import References, least
from lagdsl.algebra.eliminate.redundant_multipliers import RedundantMultipliers, find_redundant_multipliers, shortest
from lagdsl.algebra.eliminate.rows import Rows, Side, is_multiplier, multiplier_of, velocity_of
from lagdsl.algebra.eliminate.steps import Pivoted, Steps, solve_steps, steps_of
from lagdsl.algebra.eliminate.weightless import Reduced, reduce, reduced_biases, shares
from lagdsl.algebra.graph.graph import ZERO, Graph
from lagdsl.foundation.record import record

# The composite order costs the square of the depth at least; beyond this many rates it never won.
_LARGEST_DELAYED = 16
# Nodes that an order may make before it is given up, by the operations that it is to beat.
_NODES_PER_OPERATION = 2
_FEWEST = 1000
# Nodes that each order may make at first, while none is done, and by what that grows.
_FIRST_BOUND = 1 << 14
_GROWTH = 4


@record(kw_only=True)
class Factor:
    """An order carried out: `steps` for any right-hand side. Nodes all.

    `pivot` is the least part that subtraction left of the pivot of a rate; about 1e-16 where M is singular. `strengths`
    are, by row that is not kept, the pivot of its multiplier, and what it would be without the others; of a row that
    follows from others, these leave nothing. They are told of the rows of `left`: those of `rows` as they are once the
    rates without inertia are exchanged.
    """

    graph: Graph
    rates: Sequence[int]
    rows: Rows
    left: Rows
    steps: Steps
    pivot: int
    strengths: dict[int, tuple[int, int]]
    redundant_multipliers: RedundantMultipliers


@record(kw_only=True)
class Response:
    """Accelerations of `rates`, by rate those `moved` that are not identically zero, and multipliers of rows that are
    not kept by index, for one right-hand side."""

    rates: Sequence[int]
    moved: dict[int, int]
    multipliers: dict[int, int]

    @property
    def accelerations(self) -> list[int]:
        """All, in the order of the rates."""
        return [self.moved.get(rate, ZERO) for rate in self.rates]


@record(kw_only=True)
class Solution:
    """`own` for the form's own forces with the biases of the rows, and `along` the kept rows, one by one, with nothing
    else."""

    factor: Factor
    own: Response
    along: list[Response]
    flops: int


def solve(
    form: AccelerationForm, rates: Sequence[int], rows: Rows | None = None, *, most: int | None = None
) -> Solution:
    """Accelerations of `rates` (nodes of symbols QD).

    Raises NotApplicable where a velocity is not linear in the rates, where a coordinate has no inertia, or where it
    needs more than `most` operations, by and large.
    """
    rows = rows or Rows()
    reduced = reduce(form, rates, rows)
    definitions = find_definitions(form.graph, dict.fromkeys((*form.weights, *form.forces)))
    stiffened = [row for row in (*reduced.left.solved, *reduced.left.kept) if row.index in rows.stiffened]
    terms = {**definitions.terms, **{velocity_of(row.index): row.terms for row in stiffened}}
    definitions = Definitions(terms=terms, rotations=definitions.rotations)
    exchanged = {step.rate for step in reduced.steps}
    heavy = [rate for rate in rates if rate not in exchanged]
    # Among rates alone there is nothing to choose.
    ranked = (by_depth, by_creation) if definitions.terms or definitions.rotations else (by_depth,)
    orders = [
        Order(rates=heavy, priority=priority(definitions, heavy), delayed=frozenset(delayed))
        for delayed in (((), heavy) if 1 < len(heavy) <= _LARGEST_DELAYED else ((),))
        for priority in ranked
    ]

    def solved(order: Order, nodes: int | None) -> Solution | None:
        budget = Budget(form.graph, nodes)
        try:
            factor = replace(_factorize(form, definitions, rows, reduced, order, budget), rates=rates)
            return _solve(form, factor, budget)
        except TooMany:
            return None

    return _best(orders, solved, None if most is None else _nodes(most))


def _best(
    orders: Sequence[Order], solved: Callable[[Order, int | None], Solution | None], most: int | None
) -> Solution:
    """The solution with the fewest operations, of those that `solved` finds with at most so many new nodes. Orders can
    differ by a power in what they make, so the first to be done is sought with bounds that grow; it bounds the others.

    Raises NotApplicable where there is none.
    """
    first, best = _first(orders, solved, most)
    limit = _nodes(best.flops) if most is None else min(_nodes(best.flops), most)
    found = [best if number == first else solved(order, limit) for number, order in enumerate(orders)]
    return min((solution for solution in found if solution is not None), key=lambda solution: solution.flops)


def _first(
    orders: Sequence[Order], solved: Callable[[Order, int | None], Solution | None], most: int | None
) -> tuple[int, Solution]:
    """The number of an order that is done with as few nodes as any, about, and its solution."""
    bound = _FIRST_BOUND
    while True:
        nodes = bound if most is None else min(bound, most)
        for number, order in enumerate(orders):
            solution = solved(order, nodes)
            if solution is not None:
                return number, solution
        if nodes == most:
            raise NotApplicable
        bound *= _GROWTH


def _nodes(operations: int) -> int:
    """Nodes that an order may make to win against one of so many operations."""
    return _NODES_PER_OPERATION * (operations + _FEWEST)


def respond(factor: Factor, side: Side, budget: Budget | None = None) -> Response:
    """The solution for any right-hand side, with the multipliers of kept rows zero. Raises TooMany."""
    graph, rows = factor.graph, factor.rows
    given = dict(side.forces)
    for row in rows.solved:
        given[multiplier_of(row.index)] = graph.negate(side.biases.get(row.index, graph.zero))
    along = reduced_biases(graph, factor.steps.order, side.biases) if rows.stiffened else {}
    for index, weight in rows.stiffened.items():
        given[velocity_of(index)] = graph.multiply(weight, along.get(multiplier_of(index), graph.zero))
    known = solve_steps(graph, factor.steps, given, budget or Budget(graph, None))
    multipliers = {row.index: known.get(multiplier_of(row.index), graph.zero) for row in rows.solved}
    symbols = ((variable, node) for variable, node in known.items() if variable >= 0 and not graph.operands[variable])
    return Response(
        rates=factor.rates,
        moved={rate: node for rate, node in symbols if node != ZERO},
        multipliers=shortest(graph, factor.redundant_multipliers, multipliers),
    )


def _solve(form: AccelerationForm, factor: Factor, budget: Budget) -> Solution:
    rows = factor.rows
    biases = {row.index: row.bias for row in (*rows.solved, *rows.kept)}
    own = respond(factor, Side(forces=form.forces, biases=biases), budget)
    along = [respond(factor, Side(forces=row.terms), budget) for row in rows.kept]
    roots = [node for found in (own, *along) for node in (*found.moved.values(), *found.multipliers.values())]
    return Solution(factor=factor, own=own, along=along, flops=flops(form.graph, roots))


def _factorize(
    form: AccelerationForm, definitions: Definitions, rows: Rows, reduced: Reduced, order: Order, budget: Budget
) -> Factor:
    graph, left = form.graph, reduced.left
    system = SparseSystem(graph, form.weights)
    for index, weight in rows.stiffened.items():
        system.add(velocity_of(index), velocity_of(index), weight)
    for row in (*left.solved, *left.following):
        for rate, term in row.terms.items():
            system.add(multiplier_of(row.index), rate, graph.negate(term))
    elimination = Elimination(system, definitions, order, budget, left)
    steps, found = elimination.run(), elimination.multipliers
    pivots = {step.variable: step.pivot for step in steps if isinstance(step, Pivoted)}
    inertias = [pivot for variable, pivot in pivots.items() if not is_multiplier(variable)]
    references = References(graph, of_sums=bool(left.solved))
    rests = found.rests | {v: graph.negate(pivot) for v, pivot in pivots.items() if is_multiplier(v)}
    multipliers = {row.index: multiplier_of(row.index) for row in (*left.solved, *left.following)}
    return Factor(
        graph=graph,
        rates=order.rates,
        rows=rows,
        left=left,
        steps=steps_of(definitions.terms, (*reduced.steps, *steps)),
        pivot=least(graph, [(pivot, references.of(pivot)) for pivot in inertias]),
        strengths={index: (rests[v], found.sizes[v]) for index, v in multipliers.items()},
        redundant_multipliers=find_redundant_multipliers(graph, rows, shares(graph, reduced.steps) | found.tied),
    )
