"""The equations of motion solved before run time, where that is cheaper than a dense factorization at run time."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.diagnostics import CompilationFailed
from lagdsl.eliminate.count import flops
from lagdsl.eliminate.form import NotApplicable
from lagdsl.eliminate.solve import Solution, solve
from lagdsl.flat.model import FlatModel
from lagdsl.graph.graph import Graph
from lagdsl.mechanics.inertia import acceleration_form
from lagdsl.mechanics.lagrange import Dynamics
from lagdsl.mechanics.lowering import Lowering
from lagdsl.mechanics.symbols import Directions
from lagdsl.program.functions import OPTIONAL
from lagdsl.program.program import Block, Function


def eliminated_equations(
    lowering: Lowering,
    flat: FlatModel,
    found: Dynamics,
    directions: Directions,
    jacobian: Sequence[Sequence[int]],
    gamma: Sequence[int],
    forming: int,
) -> tuple[Function, ...]:
    """The function `elimination`, or nothing; all rows of `jacobian` are left to run time.

    `forming` are the operations for M, f, J and gamma that it is to beat.
    """
    graph, size = lowering.graph, len(directions.rates)
    if not size:
        return ()
    sides = [dict(zip(directions.rates, row, strict=True)) for row in jacobian]
    try:
        solution = solve(acceleration_form(lowering, flat, found, directions), directions.rates, sides)
    except NotApplicable:
        return ()
    except CompilationFailed:  # an input has no derivative that only this form asks for
        return ()
    blocks = _blocks(graph, solution, jacobian, gamma)
    cost = flops(graph, [node for block in blocks for node in block.elements])
    if cost + _delassus(size, len(gamma)) >= forming + _factorization(size, len(gamma)):
        return ()
    return (Function(name="elimination", arguments=OPTIONAL["elimination"], results=blocks),)


def _factorization(n: int, m: int) -> int:
    """Operations of the null-space method: orthogonal factors of J', M turned by them from both sides, a Cholesky
    factorization of what is left free, and solutions with all of it."""
    return 2 * m * m * n + 8 * m * n * n + (n - m) ** 3 // 3 + 2 * n * n + 4 * m * n


def _delassus(n: int, m: int) -> int:
    """Operations of forming J Y', of its Cholesky factorization and of solutions with it."""
    return m * m * n + m**3 // 3 + 4 * m * n + 2 * m * m


def _blocks(
    graph: Graph, solution: Solution, jacobian: Sequence[Sequence[int]], gamma: Sequence[int]
) -> tuple[Block, ...]:
    n, m = len(solution.accelerations), len(gamma)
    responses = [node for row in solution.responses for node in row]
    rows = [node for row in jacobian for node in row]
    return (
        Block(name="a", shape=(n,), elements=tuple(solution.accelerations)),
        Block(name="l", shape=(m,), elements=(graph.zero,) * m),
        Block(name="Y", shape=(m, n), elements=tuple(responses)),
        Block(name="K", shape=(m, m), elements=(graph.zero,) * (m * m)),
        Block(name="J", shape=(m, n), elements=tuple(rows)),
        Block(name="gamma", shape=(m,), elements=tuple(gamma)),
        Block(name="pivot", shape=(), elements=(solution.pivot,)),
    )
