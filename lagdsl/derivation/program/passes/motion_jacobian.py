"""The motion at one state with its derivatives by everything: the equations of the accelerations differentiated, and
their solution for any right-hand side.

The accelerations and multipliers v and the rates zd solve F(x, p, v, zd) = 0: r = 0, s = 0 and zd - g = 0. So
d(qdd, zd) along a direction is `response` times (by_state d + by_parameter dp), with F_x and F_p at the solution. F has
few entries for each parameter, and one product with `response` serves all of them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.algebra.eliminate.count import Budget, TooMany, flops
from lagdsl.algebra.eliminate.rows import Side
from lagdsl.algebra.eliminate.solve import Factor, respond
from lagdsl.algebra.graph.differentiate import adjoints
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import DIRECTION_OF, Group
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.program.passes.along import along, elements
from lagdsl.derivation.program.passes.reassociate import reassociated
from lagdsl.derivation.program.program import Block, Eliminated, Program, matrix_block, number_block
from lagdsl.foundation.record import record, remembered

# Names of the results in lag_tangents.
RESULTS = ("qdd", "lam", "pivot", "response", "by_state", "by_parameter")
# Directions of one pass over lanes.
_LANES = 8
# Nodes that a derivative may make before it is given up, by the operations that it is to beat.
_NODES_PER_OPERATION = 2
_STATE = (Group.Q, Group.QD, Group.Z, Group.U)
_VALUES = (Group.QDD, Group.LAMBDA)


@record()
class MotionJacobian:
    """`motion` are accelerations, multipliers and pivot; `response` (nq + nz, nq + nc + nz), `by_state` (nq + nc + nz,
    2 nq + nz + nu) and `by_parameter` (nq + nc + nz, np) as lag_tangents has them."""

    motion: tuple[Block, ...]
    response: Block
    by_state: Block
    by_parameter: Block

    @property
    def results(self) -> tuple[Block, ...]:
        return (*self.motion, self.response, self.by_state, self.by_parameter)


@remembered
def motion_jacobian(program: Program) -> MotionJacobian | None:
    """None where passes over lanes of directions take fewer operations, a vector counting as one; and where
    multipliers, or loads, are left to run time."""
    eliminated = program.eliminated
    if eliminated is None or program.kept_rows or "load" in program.layout.kinds:
        return None
    most = _operations_in_lanes(program)
    budget = Budget(program.graph, _NODES_PER_OPERATION * most)
    try:
        found = _found(program, eliminated, budget)
    except TooMany:
        return None
    nodes = [node for block in found.results for node in block.nodes]
    return found if flops(program.graph, nodes) <= most else None


def _operations_in_lanes(program: Program) -> int:
    """Of the passes over all states, inputs and parameters."""
    graph, layout = program.graph, program.layout
    total = 0
    for parameters, groups in ((False, _STATE), (True, (Group.P,))):
        roots = elements(along(program, parameters=parameters).functions.values())
        moving = sum(1 << DIRECTION_OF[group] for group in groups)
        passes = -(-sum(map(layout.size, groups)) // _LANES)
        inside = flops(graph, roots)
        own = inside - flops(graph, [node for node in graph.live(roots) if not graph.groups[node] & moving])
        total += inside + max(0, passes - 1) * own
    return total


def _found(program: Program, eliminated: Eliminated, budget: Budget) -> MotionJacobian:
    graph = program.graph
    motion = (eliminated.accelerations, eliminated.multipliers, number_block("pivot", eliminated.pivot))
    values = _symbols(program, _VALUES)
    solution = Substitution(graph, dict(zip(values, (*motion[0].elements, *motion[1].elements), strict=True)))
    equations = [node for block in program.function("residual").results for node in block.nodes]
    rates = [node for block in program.function("state_derivative").results for node in block.nodes]
    rows = [_row(graph, node, budget) for node in (*equations, *(graph.negate(rate) for rate in rates))]

    def derivatives(symbols: Sequence[int]) -> list[list[int]]:
        return [solution.of_all([row.get(symbol, graph.zero) for symbol in symbols]) for row in rows]

    state, parameters = _symbols(program, _STATE), _symbols(program, (Group.P,))
    of_values = derivatives(values)[len(equations) :]
    response = _response(graph, eliminated.factor, program.layout.size(Group.LAMBDA))
    budget.check()
    own = [graph.zero] * len(rates)
    accelerations = [[*row, *own] for row in response[: len(motion[0].elements)]]
    solved = [*accelerations, *_of_rates(graph, of_values, response)]
    derived = (
        matrix_block("response", solved, len(rows)),
        matrix_block("by_state", derivatives(state), len(state)),
        matrix_block("by_parameter", derivatives(parameters), len(parameters)),
    )
    first, second, third, *others = reassociated(graph, (*motion, *derived))
    return MotionJacobian((first, second, third), *others)


def _symbols(program: Program, groups: Sequence[Group]) -> list[int]:
    return [program.graph.symbol(group, index) for group in groups for index in range(program.layout.size(group))]


def _row(graph: Graph, node: int, budget: Budget) -> Mapping[int, int]:
    """Raises TooMany."""
    budget.check()
    return adjoints(graph, {node: graph.one}, (*_STATE, Group.P, *_VALUES))


def _response(graph: Graph, factor: Factor, rows: int) -> list[list[int]]:
    """Changes of accelerations and multipliers with dr, then with ds of so many rows: (nq + nc, nq + nc)."""
    minus = graph.negate(graph.one)
    sides = [Side(forces={rate: minus}) for rate in factor.rates]
    sides += [Side(forces={}, biases={row: minus}) for row in range(rows)]
    columns = []
    for side in sides:
        found = respond(factor, side)
        columns.append([*found.accelerations, *(found.multipliers.get(row, graph.zero) for row in range(rows))])
    return [list(row) for row in zip(*columns, strict=True)]


def _of_rates(graph: Graph, of_values: Sequence[Sequence[int]], response: Sequence[Sequence[int]]) -> list[list[int]]:
    """Rows of zd: what its equation changes by through accelerations and multipliers, and itself."""
    minus = graph.negate(graph.one)
    rows = []
    for number, weights in enumerate(of_values):
        through = [graph.negate(graph.dot(weights, column)) for column in zip(*response, strict=True)]
        rows.append([*through, *(minus if other == number else graph.zero for other in range(len(of_values)))])
    return rows
