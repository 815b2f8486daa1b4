"""Elimination of an acceleration form on a graph."""

import numpy as np
import pytest

from lagdsl.algebra.eliminate.form import AccelerationForm, NotApplicable
from lagdsl.algebra.eliminate.solve import solve
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op

TWO_RATES = 2
MANY = 60


def test_coordinate_without_inertia_is_left_to_the_dense_path() -> None:
    graph = Graph()
    first, second = graph.symbols(Group.QD, TWO_RATES)
    form = AccelerationForm(graph)
    form.add_square(first, graph.one)
    with pytest.raises(NotApplicable):
        solve(form, [first, second])


def test_velocity_that_is_not_linear_in_the_rates_is_left_to_the_dense_path() -> None:
    graph = Graph()
    (rate,) = graph.symbols(Group.QD, 1)
    form = AccelerationForm(graph)
    form.add_square(graph.unary(Op.SIN, rate), graph.one)
    with pytest.raises(NotApplicable):
        solve(form, [rate])


def test_indefinite_inertia_is_left_to_the_dense_path() -> None:
    """1/2 m x'^2 + x' y': the second pivot is -1/m."""
    graph = Graph()
    first, second = graph.symbols(Group.QD, TWO_RATES)
    form = AccelerationForm(graph)
    form.add_square(first, graph.symbol(Group.P))
    form.add_product(first, second, graph.one)
    with pytest.raises(NotApplicable):
        solve(form, [first, second])


@pytest.mark.parametrize(("inertia", "sign"), [(0.5, 1.0), (-0.5, -1.0), (0.1, -1.0)])
def test_pivots_tell_the_sign_of_inertia(inertia: float, sign: float) -> None:
    """[s, 0.5; 0.5, 1] is positive definite for s > 1/4."""
    graph = Graph()
    first, second = graph.symbols(Group.QD, TWO_RATES)
    form = AccelerationForm(graph)
    position = graph.symbol(Group.Q)
    form.add_square(first, position)
    form.add_product(first, second, graph.constant(0.5))
    form.add_square(second, graph.one)
    found = evaluate(graph, [solve(form, [first, second]).factor.pivot], {Group.Q: [inertia]})[0]
    assert np.sign(found) == sign


@pytest.mark.parametrize("mirrored", [False, True])
def test_turned_pairs_with_any_weights(mirrored: bool) -> None:
    """Two pairs turned by one angle, fully coupled with each other and with what they come from."""
    graph = Graph()
    rates = graph.symbols(Group.QD, 4)
    angle = graph.symbol(Group.Q)
    c, s = graph.unary(Op.COS, angle), graph.unary(Op.SIN, angle)
    turned = []
    for x, y in (rates[:2], rates[2:]):
        across = graph.subtract(graph.multiply(c, y), graph.multiply(s, x))
        turned.append(graph.add(graph.multiply(c, x), graph.multiply(s, y)))
        turned.append(graph.subtract(graph.multiply(s, x), graph.multiply(c, y)) if mirrored else across)
    velocities = [*rates, *turned]
    rng = np.random.default_rng(2)
    root = rng.normal(size=(8, 8))
    weights, forces = root @ root.T, rng.normal(size=8)
    form = AccelerationForm(graph)
    for i, velocity in enumerate(velocities):
        form.add_square(velocity, graph.constant(weights[i, i]))
        form.add_force(velocity, graph.constant(forces[i]))
        for j in range(i):
            form.add_product(velocity, velocities[j], graph.constant(weights[i, j]))
    solution = solve(form, rates)
    found = np.array(evaluate(graph, solution.own.accelerations, {Group.Q: [0.7], Group.QD: [0.0] * 4}))
    cos, sin, sign = np.cos(0.7), np.sin(0.7), -1.0 if mirrored else 1.0
    block = np.array([[cos, sin], [-sign * sin, sign * cos]])
    definition = np.vstack([np.eye(4), np.kron(np.eye(2), block)])
    expected = np.linalg.solve(definition.T @ weights @ definition, definition.T @ forces)
    np.testing.assert_allclose(found, expected, rtol=1e-10)


@pytest.mark.parametrize("hub", [0, MANY])
def test_an_order_that_fills_the_matrix_is_given_up(hub: int) -> None:
    """An arrow: a hub that all others are coupled with. Once it is eliminated first, everything is coupled."""
    graph = Graph()
    rates, masses = graph.symbols(Group.QD, MANY + 1), graph.symbols(Group.P, MANY + 1)
    products = [graph.unary(Op.EXP, mass) for mass in masses]
    velocities = [graph.multiply(graph.constant(2.0), rate) for rate in rates]
    form = AccelerationForm(graph)
    for i, velocity in enumerate(velocities):
        form.add_square(velocity, masses[i])
        form.add_force(velocity, graph.one)
        if i != hub:
            form.add_product(velocity, velocities[hub], products[i])
    before = len(graph)
    solution = solve(form, rates)
    assert len(graph) - before < MANY**3 / 6
    given_masses = np.linspace(1.0, 2.0, MANY + 1)
    given_masses[hub] = 60.0 * MANY
    weights = np.diag(given_masses)
    others = np.arange(MANY + 1) != hub
    weights[hub, others] = weights[others, hub] = np.exp(given_masses[others])
    given = {Group.P: list(given_masses), Group.QD: [0.0] * (MANY + 1)}
    found = evaluate(graph, solution.own.accelerations, given)
    np.testing.assert_allclose(found, np.linalg.solve(2.0 * weights, np.ones(MANY + 1)), rtol=1e-11)
