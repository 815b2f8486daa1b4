"""Rates without inertia exchanged with multipliers: the solution of the whole system, at a cost that does not fill."""

import numpy as np
import pytest

from lagdsl.algebra.eliminate.form import AccelerationForm, NotApplicable
from lagdsl.algebra.eliminate.rows import Row, Rows, Side
from lagdsl.algebra.eliminate.solve import Response, respond, solve
from lagdsl.algebra.eliminate.weightless import reduce
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group

MASS = np.diag([2.0, 3.0, 0.0, 0.0, 0.0])
FORCE = np.array([0.3, -1.0, 0.7, 0.2, -0.5])
# The first three give the last three rates; the fourth is the sum of the first and twice the second.
JACOBIAN = np.array(
    [
        [1.0, 0.5, 0.0, 1.0, 0.0],
        [0.0, 1.0, -1.0, 1.0, 0.0],
        [1.0, 1.0, 1.0, 1.0, 2.0],
        [1.0, 2.5, -2.0, 3.0, 0.0],
        [0.4, 0.3, 0.0, 1.0, -1.0],
    ]
)
BIAS = np.array([0.1, -0.2, 0.4, -0.3, 0.6])


class Problem:
    def __init__(self, mass: np.ndarray = MASS) -> None:
        graph = self.graph = Graph()
        self.rates = graph.symbols(Group.QD, len(mass))
        self.form = AccelerationForm(graph)
        for rate, weight, force in zip(self.rates, np.diag(mass), FORCE, strict=True):
            if weight:
                self.form.add_square(rate, graph.constant(weight))
            self.form.add_force(rate, graph.constant(force))
        self.rows = [
            Row(
                index=index,
                terms={r: graph.constant(x) for r, x in zip(self.rates, row, strict=True) if x},
                bias=graph.constant(bias),
            )
            for index, (row, bias) in enumerate(zip(JACOBIAN, BIAS, strict=True))
        ]

    def values(self, found: Response) -> tuple[np.ndarray, np.ndarray]:
        nodes = [*found.accelerations, *(found.multipliers.get(row, self.graph.zero) for row in range(len(BIAS)))]
        values = np.array([float(x) for x in evaluate(self.graph, nodes, {})])
        return values[: len(self.rates)], values[len(self.rates) :]


def expected(rows: list[int], force: np.ndarray = FORCE, bias: np.ndarray = BIAS) -> tuple[np.ndarray, np.ndarray]:
    """Accelerations, and of the multipliers the shortest."""
    j = JACOBIAN[rows]
    whole = np.block([[MASS, -j.T], [j, np.zeros((len(rows), len(rows)))]])
    found = np.linalg.lstsq(whole, np.concatenate([force, bias[rows]]), rcond=1e-12)[0]
    multipliers = np.zeros(len(BIAS))
    multipliers[rows] = found[5:]
    return found[:5], multipliers


def test_rows_solved_and_following() -> None:
    problem = Problem()
    rows = problem.rows
    solution = solve(problem.form, problem.rates, Rows(solved=tuple(rows[:3]), following=(rows[3],)))
    assert not solution.factor.left.solved and not solution.factor.left.following
    for one, other in zip(problem.values(solution.own), expected([0, 1, 2, 3]), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12)


def test_rows_left_to_run_time() -> None:
    """As the program completes the solution at run time: rates without inertia stand in the kept row."""
    problem = Problem()
    rows = problem.rows
    solution = solve(problem.form, problem.rates, Rows(solved=tuple(rows[:3]), kept=(rows[4],)))
    a, l = problem.values(solution.own)
    y, k = problem.values(solution.along[0])
    lam = (BIAS[4] - JACOBIAN[4] @ a) / (JACOBIAN[4] @ y)
    accelerations, multipliers = expected([0, 1, 2, 4])
    np.testing.assert_allclose(a + y * lam, accelerations, rtol=1e-12)
    np.testing.assert_allclose(l + k * lam + np.eye(5)[4] * lam, multipliers, rtol=1e-12)


def test_other_right_hand_sides_with_a_row_that_gives_inertia() -> None:
    """One rate has coefficients that are no constants, so a row lends it inertia."""
    problem = Problem()
    graph, rows = problem.graph, problem.rows
    varied = Row(index=2, terms={**rows[2].terms, problem.rates[4]: graph.symbol(Group.P, 0)}, bias=rows[2].bias)
    chosen = Rows(solved=(*rows[:2], varied), stiffened={2: graph.constant(0.5)})
    factor = solve(problem.form, problem.rates, chosen).factor
    assert [row.index for row in factor.left.solved] == [2]
    force, bias = np.arange(5.0) + 1.0, np.array([0.3, -1.0, 2.0, 0.0, 0.0])
    side = Side(
        forces={rate: graph.constant(x) for rate, x in zip(problem.rates, force, strict=True)},
        biases={index: graph.constant(x) for index, x in enumerate(bias[:3])},
    )
    found = respond(factor, side)
    nodes = [*found.accelerations, *(found.multipliers[row] for row in range(3))]
    values = [float(x) for x in evaluate(graph, nodes, {Group.P: [2.0]})]
    accelerations, multipliers = expected([0, 1, 2], force, bias)
    np.testing.assert_allclose(values, [*accelerations, *multipliers[:3]], rtol=1e-12)


def test_solved_row_without_rest_is_refused() -> None:
    problem = Problem()
    with pytest.raises(NotApplicable):
        solve(problem.form, problem.rates, Rows(solved=tuple(problem.rows[:4])))


def test_nothing_is_exchanged_by_a_small_entry() -> None:
    problem = Problem()
    graph, rates = problem.graph, problem.rates
    entries = [1e-3, 1.0]
    rows = [
        Row(index=index, terms={rates[4]: graph.constant(x), rates[0]: graph.one}, bias=graph.zero)
        for index, x in enumerate(entries)
    ]
    (step,) = reduce(problem.form, rates, Rows(solved=tuple(rows))).steps
    assert graph.value[step.factor] == 1.0


def mesh(n: int) -> tuple[AccelerationForm, list[int], Rows]:
    """n x n nodes with a capacitor to ground each, and inductors between neighbours: Kirchhoff's laws by charges."""
    graph = Graph()
    nodes = n * n
    edges = [(i, i + 1) for i in range(nodes) if (i + 1) % n] + [(i, i + n) for i in range(nodes - n)]
    rates = graph.symbols(Group.QD, nodes + len(edges) + 1)
    form = AccelerationForm(graph)
    for index, rate in enumerate(rates):
        form.add_force(rate, graph.symbol(Group.Q, index))
        if nodes <= index < nodes + len(edges):
            form.add_square(rate, graph.symbol(Group.P, index))
    laws: list[dict[int, int]] = [{rates[i]: graph.one} for i in range(nodes)]
    for rate, (one, other) in zip(rates[nodes:], edges, strict=False):
        laws[one][rate], laws[other][rate] = graph.one, graph.constant(-1.0)
    ground = {**dict.fromkeys(rates[:nodes], graph.constant(-1.0)), rates[-1]: graph.one}
    rows = [Row(index=i, terms=terms, bias=graph.zero) for i, terms in enumerate([ground, *laws])]
    return form, rates, Rows(solved=tuple(rows))


def test_meshes_do_not_fill() -> None:
    """Operations and nodes in proportion to the branches, though one row has all capacitors."""
    found = []
    for n in (4, 8):
        form, rates, rows = mesh(n)
        before = len(form.graph)
        found.append((len(rates), solve(form, rates, rows).flops, len(form.graph) - before))
    (branches, flops, nodes), (more, flops_of_more, nodes_of_more) = found
    assert flops_of_more / flops < 1.1 * more / branches
    assert nodes_of_more / nodes < 1.1 * more / branches
