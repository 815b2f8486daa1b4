"""The equations of motion solved before run time, where that is cheaper than a dense factorization at run time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.algebra.eliminate.count import flops
from lagdsl.algebra.eliminate.form import AccelerationForm, NotApplicable
from lagdsl.algebra.eliminate.rows import Row, Rows
from lagdsl.algebra.eliminate.solve import Solution, solve
from lagdsl.derivation.mechanics.constraints import rows_of, with_baumgarte_terms
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.lagrange.inertia import acceleration_form
from lagdsl.derivation.mechanics.lowering.symbols import Directions
from lagdsl.derivation.program.functions import OPTIONAL
from lagdsl.derivation.program.passes.reassociate import reassociated
from lagdsl.derivation.program.program import Block, Eliminated, Function, matrix_block, number_block, vector_block
from lagdsl.derivation.structure.redundant_multipliers import (
    choose_rows,
    least_pivot,
    strengths_at_points,
    without_weak_rows,
)
from lagdsl.derivation.structure.structure import Structure
from lagdsl.foundation.diagnostics import CompilationFailed


def eliminate(
    equations: Equations, structure: Structure | None, forming: int, stabilization: int | None = None
) -> Eliminated | None:
    """None where it costs more than `forming`, the operations for M, f, J and gamma, and solving at run time.

    `structure` is needed where there are constraints. `stabilization` is the rate [1/s] of Baumgarte's terms, a node;
    without it there are none.
    """
    lowering, directions = equations.lowering, equations.symbols.directions
    rows = rows_of(lowering, equations.rows, directions)
    if stabilization is not None:
        rows = with_baumgarte_terms(lowering, equations.rows, rows, stabilization)
    assert structure is not None or not rows, "ranks decide which multipliers are eliminated"
    graph, n, m = lowering.graph, len(directions.rates), len(rows)
    if not n:
        return None
    most = forming + _factorization(n, m)
    try:
        form = acceleration_form(lowering, equations.flat, equations.dynamics, directions)
        if structure is None:
            solution = solve(form, directions.rates, most=most)
            pivot = solution.factor.pivot
        else:
            solution, pivot = _with_rows(form, directions, rows, structure, most)
    except NotApplicable:
        return None
    except CompilationFailed:  # an input has no derivative that only this form asks for
        return None
    blocks = _blocks(solution, m, pivot)
    cost = flops(graph, [node for block in blocks for node in block.nodes])
    if cost + _delassus(n, m, len(solution.along)) >= most:
        return None
    function = Function(name="elimination", arguments=OPTIONAL["elimination"], results=reassociated(graph, blocks))
    return Eliminated(
        function=function, factor=solution.factor, pivot=pivot, accelerations=blocks[0], multipliers=blocks[1]
    )


def _with_rows(
    form: AccelerationForm, directions: Directions, rows: Sequence[Row], structure: Structure, most: int
) -> tuple[Solution, int]:
    chosen: Rows | None = choose_rows(form, directions.rates, rows, structure)
    while chosen is not None:
        solution = solve(form, directions.rates, chosen, most=most)
        strengths = strengths_at_points(solution.factor, structure)
        chosen = without_weak_rows(solution.factor, strengths)
    return solution, least_pivot(solution.factor, strengths)


def _factorization(n: int, m: int) -> int:
    """Operations of the null-space method: orthogonal factors of J', M turned by them from both sides, a Cholesky
    factorization of what is left free, and solutions with all of it."""
    rank = min(n, m)
    return 2 * m * rank * n + 8 * rank * n * n + (n - rank) ** 3 // 3 + 2 * n * n + 4 * m * n


def _delassus(n: int, m: int, kept: int) -> int:
    """Operations of forming J Y' of the kept rows, of its Cholesky factorization and of solutions with it."""
    return kept * kept * n + kept**3 // 3 + 4 * kept * n + 2 * kept * (kept + m)


def _blocks(solution: Solution, m: int, pivot: int) -> tuple[Block, ...]:
    factor, own, along = solution.factor, solution.own, solution.along
    n, zero, kept = len(factor.rates), factor.graph.zero, factor.rows.kept
    columns = {rate: column for column, rate in enumerate(factor.rates)}

    def by_column(row: Mapping[int, int]) -> dict[int, int]:
        return {columns[rate]: node for rate, node in row.items()}

    return (
        vector_block("a", own.accelerations),
        vector_block("l", [own.multipliers.get(row, zero) for row in range(m)]),
        matrix_block("Y", [by_column(found.moved) for found in along], n),
        matrix_block("K", [found.multipliers for found in along], m),
        matrix_block("J", [by_column(row.terms) for row in kept], n),
        vector_block("gamma", [row.bias for row in kept]),
        number_block("pivot", pivot),
    )
