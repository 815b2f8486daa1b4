"""Multipliers eliminated with the accelerations: any split of the rows gives the solution of the whole system."""

import numpy as np
import pytest

from lagdsl.algebra.eliminate.form import AccelerationForm, NotApplicable
from lagdsl.algebra.eliminate.rows import Row, Rows, Side, components
from lagdsl.algebra.eliminate.solve import Response, Solution, respond, solve
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group

N, M = 5, 3


class Chain:
    """Masses on a line, each velocity the one before plus a rate, with rows along random directions."""

    def __init__(self, *, massless: bool = False) -> None:
        rng = np.random.default_rng(7)
        graph = self.graph = Graph()
        self.rates = graph.symbols(Group.QD, N)
        self.form = AccelerationForm(graph)
        self.mass, self.force = np.zeros((N, N)), np.zeros(N)
        velocity, definition = graph.zero, np.zeros(N)
        for index, rate in enumerate(self.rates):
            velocity = graph.add(velocity, rate)
            definition[index] = 1.0
            weight, force = (0.0 if massless and index == N - 1 else rng.uniform(1.0, 2.0)), rng.normal()
            self.form.add_square(velocity, graph.constant(weight))
            self.form.add_force(velocity, graph.constant(force))
            self.mass += weight * np.outer(definition, definition)
            self.force += force * definition
        self.jacobian, self.bias = rng.normal(size=(M, N)), rng.normal(size=M)
        self.rows = [
            Row(
                index=index,
                terms={rate: graph.constant(x) for rate, x in zip(self.rates, row, strict=True)},
                bias=graph.constant(bias),
            )
            for index, (row, bias) in enumerate(zip(self.jacobian, self.bias, strict=True))
        ]

    def values(self, nodes: list[int]) -> np.ndarray:
        return np.array([float(x) for x in evaluate(self.graph, nodes, {Group.QD: [0.0] * N})])

    def expected(self) -> tuple[np.ndarray, np.ndarray]:
        whole = np.block([[self.mass, -self.jacobian.T], [self.jacobian, np.zeros((M, M))]])
        solution = np.linalg.solve(whole, np.concatenate([self.force, self.bias]))
        return solution[:N], solution[N:]

    def response(self, found: Response) -> tuple[np.ndarray, np.ndarray]:
        multipliers = [found.multipliers.get(index, self.graph.zero) for index in range(M)]
        return self.values(found.accelerations), self.values(multipliers)

    def completed(self, rows: Rows, solution: Solution) -> tuple[np.ndarray, np.ndarray]:
        """The work of a program at run time with the multipliers that are left to it."""
        kept = [row.index for row in rows.kept]
        own, first = self.response(solution.own)
        if not kept:
            return own, first
        y, k = (np.array(found) for found in zip(*map(self.response, solution.along), strict=True))
        j = self.jacobian[kept]
        strength = j @ y.T
        np.testing.assert_allclose(strength, strength.T, rtol=1e-12)
        lam = np.linalg.solve(strength, self.bias[kept] - j @ own)
        multipliers = first + k.T @ lam
        multipliers[kept] += lam
        return own + y.T @ lam, multipliers


@pytest.mark.parametrize("kept", [(), (0,), (1, 2), (0, 1, 2)])
@pytest.mark.parametrize("massless", [False, True])
def test_any_split_gives_the_solution_of_the_whole_system(kept: tuple[int, ...], massless: bool) -> None:
    chain = Chain(massless=massless)
    half = chain.graph.constant(0.5)
    rows = Rows(
        solved=tuple(row for row in chain.rows if row.index not in kept),
        kept=tuple(row for row in chain.rows if row.index in kept),
        stiffened={0: half, 2: half} if massless else {},
    )
    found = chain.completed(rows, solve(chain.form, chain.rates, rows))
    for one, other in zip(found, chain.expected(), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-11)


def test_coordinate_without_inertia_needs_a_row() -> None:
    chain = Chain(massless=True)
    with pytest.raises(NotApplicable):
        solve(chain.form, chain.rates, Rows(solved=tuple(chain.rows)))


def test_other_right_hand_sides() -> None:
    """M a - J' l = b, J a = g for b and g of one's own; where a row gives inertia, too."""
    chain = Chain()
    graph = chain.graph
    b, g = np.arange(1.0, N + 1.0), np.array([0.3, -1.0, 2.0])
    side = Side(
        forces={rate: graph.constant(x) for rate, x in zip(chain.rates, b, strict=True)},
        biases={index: graph.constant(x) for index, x in enumerate(g)},
    )
    rows = Rows(solved=tuple(chain.rows), stiffened={1: graph.constant(2.0)})
    found = respond(solve(chain.form, chain.rates, rows).factor, side)
    chain.force, chain.bias = b, g
    for one, other in zip(chain.response(found), chain.expected(), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-11)


def test_strength_tells_what_other_rows_leave_of_a_row() -> None:
    """Two rows a small angle apart: of the second one, what is across the first is left."""
    graph = Graph()
    rates = graph.symbols(Group.QD, 2)
    form = AccelerationForm(graph)
    for rate in rates:
        form.add_square(rate, graph.one)
    angle = 1e-3
    rows = [
        Row(index=0, terms={rates[0]: graph.one}, bias=graph.zero),
        Row(
            index=1,
            terms={rates[0]: graph.constant(np.cos(angle)), rates[1]: graph.constant(np.sin(angle))},
            bias=graph.zero,
        ),
    ]
    strengths = solve(form, rates, Rows(solved=tuple(rows))).factor.strengths
    first, second = (evaluate(graph, strengths[index], {}) for index in (0, 1))
    assert first[0] == first[1] == 1.0
    np.testing.assert_allclose(second, [np.sin(angle) ** 2, 1.0], rtol=1e-9)


def ring() -> tuple[AccelerationForm, list[int]]:
    graph = Graph()
    rates = graph.symbols(Group.QD, 60)
    form = AccelerationForm(graph)
    for index, rate in enumerate(rates):
        form.add_square(rate, graph.one)
        form.add_force(rate, graph.symbol(Group.U, index))
        form.add_square(graph.add(rate, rates[(index + 1) % 60]), graph.symbol(Group.P, index))
        form.add_product(rate, rates[(index * 13 + 5) % 60], graph.symbol(Group.P, 60 + index))
    return form, rates


def test_effort_is_bounded_by_what_is_to_be_beaten() -> None:
    assert solve(*ring()).flops > 3000
    form, rates = ring()
    with pytest.raises(NotApplicable):
        solve(form, rates, most=1000)
    assert len(form.graph) < 10_000


def test_rows_that_share_coordinates_belong_together() -> None:
    rows = [
        Row(index=index, terms=dict.fromkeys(rates, 0), bias=0)
        for index, rates in enumerate([(1, 2), (5,), (3, 4), (2, 3), (6, 5)])
    ]
    assert [[row.index for row in group] for group in components(rows)] == [[0, 2, 3], [1, 4]]
