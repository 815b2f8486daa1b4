"""Reverse sweeps, tangents and time derivatives against complex steps and high-precision differences."""

import math
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from choice import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from random_graphs import SMOOTH, build, trees

from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.algebra.graph.differentiate import Tangent, adjoints, jacobian, symmetric_jacobian
from lagdsl.algebra.graph.evaluate import evaluate, evaluate_with_size
from lagdsl.algebra.graph.taylor import TimeDerivative

points = st.lists(st.floats(0.1, 2.0), min_size=3, max_size=3)


def slopes_by_complex_step(graph: Graph, root: int, values: list[float]) -> list[float]:
    slopes = []
    for k in range(3):
        step = np.array(values, dtype=complex)
        step[k] += 1e-200j
        slopes.append(float(np.imag(evaluate(graph, [root], {Group.Q: step})[0]) / 1e-200))
    return slopes


def gradient(graph: Graph, root: int) -> list[int]:
    found = adjoints(graph, {root: graph.one}, (Group.Q,))
    return [found.get(symbol, graph.zero) for symbol in graph.symbols(Group.Q, 3)]


def forward(graph: Graph, root: int) -> list[int]:
    result = []
    for symbol in graph.symbols(Group.Q, 3):
        result.append(
            Tangent(graph, (Group.Q,), lambda x, symbol=symbol: graph.one if x == symbol else graph.zero).of(root)
        )
    return result


@settings(max_examples=examples(300), deadline=None)
@given(trees(SMOOTH), points)
def test_both_modes_equal_complex_steps(tree, values) -> None:
    graph = Graph()
    root = build(graph, tree)
    if not math.isfinite(evaluate(graph, [root], {Group.Q: np.array(values)})[0]):
        return
    expected = slopes_by_complex_step(graph, root, values)
    for nodes in (gradient(graph, root), forward(graph, root)):
        for (slope, size), known in zip(
            evaluate_with_size(graph, nodes, {Group.Q: np.array(values)}), expected, strict=True
        ):
            # a slope of 1e100 is a root at zero, where there is none: the complex step takes it 1e-200 away
            if abs(known) < 1e100 and math.isfinite(size) and math.isfinite(slope):
                assert abs(slope - known) <= 1e-11 * max(1.0, size)


def differentiable(graph: Graph, x: int, y: int) -> dict[str, int]:
    functions = {op.name: graph.unary(op, x) for op in Op if Op.NEGATE <= op < Op.ADD}
    functions |= {op.name: graph.binary(op, x, y) for op in Op if Op.ADD <= op < Op.SELECT}
    functions["COS of the other"] = graph.unary(Op.COS, y)
    functions["SELECT"] = graph.select(graph.binary(Op.LESS, x, y), graph.multiply(x, y), graph.unary(Op.SIN, y))
    functions["power with constant base"] = graph.power(graph.constant(1.5), y)
    functions["power with constant exponent"] = graph.power(x, graph.constant(2.5))
    functions["power with large exponent"] = graph.power(x, graph.constant(11.0))
    return functions


@pytest.mark.parametrize("at", [(0.3, 0.7, 0.0), (0.8, 0.45, 0.0), (0.6, 0.6001, 0.0)])
def test_every_operation_has_its_derivative(at) -> None:
    graph = Graph()
    x, y, _ = graph.symbols(Group.Q, 3)
    for name, root in differentiable(graph, x, y).items():
        expected = slopes_by_complex_step(graph, root, list(at))
        for nodes in (gradient(graph, root), forward(graph, root)):
            found = [float(value) for value in evaluate(graph, nodes, {Group.Q: list(at)})]
            assert found == pytest.approx(expected, rel=1e-13, abs=1e-14), name


def test_adjoints_of_weighted_seeds_hold_the_weights() -> None:
    graph = Graph()
    x, y, z = graph.symbols(Group.Q, 3)
    first, second = graph.multiply(x, y), graph.unary(Op.SIN, x)
    found = adjoints(graph, {first: z, second: y, z: graph.zero}, (Group.Q,))
    expected = {
        x: graph.add(graph.multiply(z, y), graph.multiply(y, graph.unary(Op.COS, x))),
        y: graph.multiply(z, x),
    }
    values = {Group.Q: [0.3, 0.5, 0.9]}
    assert set(found) == {x, y}
    for symbol, node in expected.items():
        assert evaluate(graph, [found[symbol]], values) == pytest.approx(evaluate(graph, [node], values))


def test_adjoints_stop_at_the_groups_asked_for() -> None:
    graph = Graph()
    x, p = graph.symbol(Group.Q), graph.symbol(Group.P)
    size = len(graph)
    assert adjoints(graph, {graph.unary(Op.EXP, p): graph.one}, (Group.Q,)) == {}
    assert len(graph) == size + 1
    assert adjoints(graph, {x: p}, (Group.Q,)) == {x: p}


def test_power_at_base_zero() -> None:
    graph = Graph()
    x, y, _ = graph.symbols(Group.Q, 3)
    values = {Group.Q: [0.0, 3.0, 0.0]}
    variable = evaluate(graph, gradient(graph, graph.power(x, y)), values)
    assert [float(value) for value in variable] == [0.0, 0.0, 0.0]
    constant = evaluate(graph, gradient(graph, graph.power(x, graph.constant(1.5))), values)
    assert float(constant[0]) == 0.0


def test_symmetric_jacobian_equals_the_full_one() -> None:
    graph = Graph()
    symbols = graph.symbols(Group.Q, 4)
    pairs = [graph.unary(Op.COS, graph.subtract(a, b)) for a, b in pairwise(symbols)]
    potential = graph.sum([*pairs, graph.unary(Op.EXP, graph.multiply(symbols[0], symbols[3]))])
    slopes = adjoints(graph, {potential: graph.one}, (Group.Q,))
    roots = [slopes[symbol] for symbol in symbols]
    values = {Group.Q: [0.3, 0.5, 0.9, -0.4]}
    full, half = jacobian(graph, roots, symbols), symmetric_jacobian(graph, roots, symbols)
    for row in range(4):
        whole = [full[row].get(column, graph.zero) for column in range(4)]
        assert evaluate(graph, half[row], values) == pytest.approx(evaluate(graph, whole, values))
        assert [half[k][row] for k in range(4)] == half[row]
    assert half[0][2] == graph.zero


def test_symmetric_jacobian_of_equal_and_of_missing_roots() -> None:
    """Two rows that are one node, a row that is a constant, a row that is the symbol itself."""
    graph = Graph()
    x, y, z = graph.symbols(Group.Q, 3)
    sum_ = graph.add(x, y)
    assert symmetric_jacobian(graph, [sum_, sum_, graph.one], [x, y, z])[0][:2] == [graph.one, graph.one]
    assert symmetric_jacobian(graph, [x, graph.zero], [x, y])[0] == [graph.one, graph.zero]
    steps = graph.unary(Op.FLOOR, x)
    assert symmetric_jacobian(graph, [steps], [x]) == [[graph.zero]]


@settings(max_examples=examples(60), deadline=None)
@given(trees(SMOOTH))
def test_time_derivatives_equal_differences_along_a_motion(tree) -> None:
    graph = Graph()
    root = build(graph, tree)
    rate = TimeDerivative(graph, lambda symbol: graph.zero)
    first = rate.of(root)
    second = rate.of(first)

    def along(t, node):
        q = [mpmath.mpf(1) / (k + 2) + mpmath.sin(t * (k + 1)) / 7 for k in range(3)]
        qd = [mpmath.cos(t * (k + 1)) * (k + 1) / 7 for k in range(3)]
        qdd = [-mpmath.sin(t * (k + 1)) * (k + 1) ** 2 / 7 for k in range(3)]
        (value,) = evaluate(graph, [node], {Group.Q: q, Group.QD: qd, Group.QDD: qdd})
        return mpmath.mpmathify(value)

    with mpmath.workdps(40):
        t = mpmath.mpf("0.3")
        try:
            known = [along(t, node) for node in (root, first, second)]
            differences = [mpmath.diff(lambda s: along(s, root), t), mpmath.diff(lambda s: along(s, first), t)]
        except (ZeroDivisionError, ValueError, OverflowError):
            return
        if all(abs(x) < 1e12 for x in (*known, *differences)):
            for found, difference in zip(known[1:], differences, strict=True):
                assert abs(found - difference) <= 1e-9 * (1 + abs(difference))


def test_time_derivative_of_each_kind_of_symbol() -> None:
    graph = Graph()
    asked = []

    def rate(symbol: int) -> int:
        asked.append(graph.group(symbol))
        return graph.constant(7.0)

    derivative = TimeDerivative(graph, rate)
    bias = TimeDerivative(graph, rate, bias=True)
    of = {group: graph.symbol(group, 2) for group in Group}
    assert derivative.of(of[Group.TIME]) == graph.one
    assert derivative.of(of[Group.Q]) == of[Group.QD]
    assert derivative.of(of[Group.QD]) == of[Group.QDD]
    assert bias.of(of[Group.QD]) == graph.zero
    assert derivative.of(of[Group.P]) == graph.zero
    assert derivative.of(of[Group.RELEASE]) == of[Group.RELEASE_RATE]
    assert derivative.of(of[Group.RELEASE_RATE]) == graph.zero
    assert asked == []
    assert derivative.of(of[Group.Z]) == derivative.of(of[Group.U]) == graph.constant(7.0)
    assert asked == [Group.Z, Group.U]


def test_conditions_are_not_differentiated() -> None:
    """An input without a derivative may stand in a condition."""
    graph = Graph()
    q, u = graph.symbol(Group.Q), graph.symbol(Group.U)

    def refuse(symbol: int) -> int:
        raise AssertionError(symbol)

    condition = graph.binary(Op.LESS, u, graph.one)
    root = graph.add(graph.select(condition, q, graph.zero), graph.unary(Op.SIGN, u))
    qd = graph.symbol(Group.QD)
    assert TimeDerivative(graph, refuse).of(root) == graph.select(condition, qd, graph.zero)
