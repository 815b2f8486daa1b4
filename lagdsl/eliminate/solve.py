"""An acceleration form solved: candidate orders are tried, the one with the fewest operations is kept."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.eliminate.count import flops
from lagdsl.eliminate.definitions import Definitions, find_definitions
from lagdsl.eliminate.form import AccelerationForm
from lagdsl.eliminate.matrix import SparseSystem
from lagdsl.eliminate.order import Elimination, Minimized, Step, back_substitute, by_creation, by_depth
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Op
from lagdsl.record import record

# The composite order costs the square of the depth at least; beyond this many rates it never won.
_LARGEST_DELAYED = 16


@record(kw_only=True)
class Solution:
    """`accelerations` qdd by the form's own forces; `responses` M^-1 b, one row per further right-hand side.

    `pivot` is the least part that subtraction left of a pivot: about 1e-16 where M is singular. Nodes all.
    """

    accelerations: list[int]
    responses: list[list[int]]
    pivot: int
    flops: int


def solve(form: AccelerationForm, rates: Sequence[int], sides: Sequence[Mapping[int, int]] = ()) -> Solution:
    """Accelerations of `rates` (nodes of symbols QD). `sides` are right-hand sides by rate.

    Raises NotApplicable where a velocity is not linear in the rates, or a coordinate has no inertia.
    """
    graph = form.graph
    definitions = find_definitions(graph, dict.fromkeys((*form.weights, *form.forces)))
    orders = [by_depth(definitions, rates), by_creation(definitions, rates)]
    candidates = [_solve(form, definitions, rates, sides, priority, delayed=()) for priority in orders]
    if 1 < len(rates) <= _LARGEST_DELAYED:
        candidates += [_solve(form, definitions, rates, sides, priority, delayed=rates) for priority in orders]
    return min(candidates, key=lambda solution: solution.flops)


def _solve(
    form: AccelerationForm,
    definitions: Definitions,
    rates: Sequence[int],
    sides: Sequence[Mapping[int, int]],
    priority: Mapping[int, tuple[int, int]],
    *,
    delayed: Sequence[int],
) -> Solution:
    graph = form.graph
    system = SparseSystem(graph, form.weights, [form.forces, *sides])
    steps = Elimination(system, definitions, rates, priority=priority, delayed=frozenset(delayed)).run()
    found = back_substitute(graph, definitions, steps, 1 + len(sides))
    rows = [[known[rate] for rate in rates] for known in found]
    roots = [node for row in rows for node in row]
    return Solution(
        accelerations=rows[0],
        responses=rows[1:],
        pivot=smallest_pivot(graph, steps),
        flops=flops(graph, roots),
    )


def smallest_pivot(graph: Graph, steps: Sequence[Step]) -> int:
    """The least of pivot / what the last elimination before subtracted from; 1 where nothing was subtracted."""
    least = graph.one
    for step in steps:
        if isinstance(step, Minimized) and graph.op[step.pivot] is Op.SUBTRACT:
            part = graph.divide(step.pivot, graph.a[step.pivot])
            least = graph.binary(Op.MIN, least, part)
    return least
