"""The evaluator against Python's own arithmetic, and its measure of size."""

import math

import mpmath
import numpy as np
import pytest
from choice import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from random_graphs import SMOOTH, build, trees

from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.algebra.graph.evaluate import evaluate, evaluate_with_size
from lagdsl.algebra.graph.fold import SCALAR

numbers = st.floats(-3.0, 3.0, allow_nan=False)


def python_value(tree, values):
    """The tree in Python floats; nan where Python raises."""
    match tree:
        case ("symbol", index):
            return values[index]
        case ("constant", value):
            return value
        case (op, *arguments):
            inner = [python_value(x, values) for x in arguments]
            if op is Op.SELECT:
                return inner[1] if inner[0] != 0.0 else inner[2]
            return SCALAR[op](*inner)
    raise AssertionError(tree)


@settings(max_examples=examples(300), deadline=None)
@given(trees(), st.lists(numbers, min_size=3, max_size=3))
def test_evaluates_as_python_does(tree, values) -> None:
    graph = Graph()
    root = build(graph, tree)
    try:
        expected = python_value(tree, values)
    except (ValueError, ArithmeticError):
        return
    (value,) = evaluate(graph, [root], {Group.Q: np.array(values)})
    if math.isfinite(expected):
        (sized,) = evaluate_with_size(graph, [root], {Group.Q: np.array(values)})
        if math.isfinite(sized[1]):
            assert abs(value - expected) <= 1e-12 * max(sized[1], 1.0)


@settings(max_examples=examples(100), deadline=None)
@given(trees(SMOOTH), st.lists(st.floats(0.2, 2.0), min_size=3, max_size=3))
def test_floats_agree_with_fifty_digits_to_the_size_of_the_terms(tree, values) -> None:
    graph = Graph()
    root = build(graph, tree)
    ((value, size),) = evaluate_with_size(graph, [root], {Group.Q: np.array(values)})
    if not (math.isfinite(value) and size < 1e30):
        return
    with mpmath.workdps(50):
        (exact,) = evaluate(graph, [root], {Group.Q: [mpmath.mpf(x) for x in values]})
        assert abs(exact - mpmath.mpf(float(value))) <= 1e-13 * max(1.0, size)


def test_leading_axes_broadcast() -> None:
    graph = Graph()
    q, p, t = graph.symbol(Group.Q, 1), graph.symbol(Group.P, 0), graph.symbol(Group.TIME)
    root = graph.add(graph.multiply(q, p), t)
    values = np.arange(12.0).reshape(2, 3, 2)
    (result,) = evaluate(graph, [root], {Group.Q: values, Group.P: [2.0], Group.TIME: np.array([10.0, 20.0, 30.0])})
    np.testing.assert_array_equal(result, values[..., 1] * 2.0 + [10.0, 20.0, 30.0])


def test_division_by_zero_is_a_value_and_no_warning() -> None:
    graph = Graph()
    x = graph.symbol(Group.Q, 0)
    roots = [graph.divide(graph.one, x), graph.unary(Op.LOG, graph.negate(graph.one)), graph.divide(x, x)]
    values = evaluate(graph, roots, {Group.Q: [0.0]})
    assert values[0] == math.inf
    assert math.isnan(values[1]) and math.isnan(values[2])


def every_operation(graph: Graph, x: int, y: int) -> list[int]:
    unary = [graph.unary(op, x) for op in Op if Op.NEGATE < op < Op.ADD]
    binary = [graph.binary(op, x, y) for op in Op if Op.ADD <= op < Op.SELECT]
    return [*unary, *binary, graph.select(graph.binary(Op.LESS, x, y), x, y), graph.negate(x)]


def test_arrays_and_high_precision_know_every_operation() -> None:
    graph = Graph()
    roots = every_operation(graph, graph.symbol(Group.Q, 0), graph.symbol(Group.Q, 1))
    plain = evaluate(graph, roots, {Group.Q: [0.3, 0.7]})
    batch = evaluate(graph, roots, {Group.Q: np.array([[0.3, 0.7], [0.3, 0.7]])})
    precise = evaluate(graph, roots, {Group.Q: (mpmath.mpf(0.3), mpmath.mpf(0.7)), Group.TIME: mpmath.mpf(0)})
    np.testing.assert_allclose([float(value) for value in precise], plain, rtol=1e-15)
    np.testing.assert_allclose(np.array(batch)[:, 1], plain, rtol=1e-15)
    sizes = [size for _, size in evaluate_with_size(graph, roots, {Group.Q: [0.3, 0.7]})]
    assert all(size >= abs(value) for size, value in zip(sizes, plain, strict=True))


def test_complex_step_passes_through_the_kinks() -> None:
    graph = Graph()
    x, y = graph.symbol(Group.Q, 0), graph.symbol(Group.Q, 1)
    roots = [
        graph.unary(Op.ABS, x),
        graph.binary(Op.ATAN2, x, y),
        graph.binary(Op.MOD, x, y),
        graph.binary(Op.MIN, x, y),
        graph.binary(Op.MAX, x, y),
        graph.unary(Op.FLOOR, x),
        graph.binary(Op.LESS, x, y),
    ]
    values = evaluate(graph, roots, {Group.Q: np.array([-2.5 + 1e-30j, 2.0 + 0j])})
    slopes = [np.imag(value) / 1e-30 for value in values]
    np.testing.assert_allclose(slopes, [-1.0, 2.0 / 10.25, 1.0, 1.0, 0.0, 0.0, 0.0])
    assert np.real(values[0]) == 2.5
    assert np.real(values[2]) == 1.5


def test_time_may_be_precise() -> None:
    graph = Graph()
    t = graph.symbol(Group.TIME)
    with mpmath.workdps(40):
        (value,) = evaluate(graph, [graph.unary(Op.SIN, t)], {Group.TIME: mpmath.mpf(1)})
        assert abs(value - mpmath.sin(1)) < mpmath.mpf(10) ** -38


def test_size_shows_cancellation() -> None:
    graph = Graph()
    x, y = graph.symbol(Group.Q, 0), graph.symbol(Group.Q, 1)
    difference = graph.subtract(x, y)
    roots = [
        difference,
        graph.multiply(difference, graph.constant(2.0)),
        graph.unary(Op.SIN, difference),
        graph.divide(graph.one, difference),
        graph.unary(Op.SQRT, graph.subtract(x, x)),
        graph.unary(Op.SQRT, graph.multiply(difference, graph.zero)),
    ]
    sized = evaluate_with_size(graph, roots, {Group.Q: [100.0, 99.0]})
    assert [float(size) for _, size in sized[:2]] == [199.0, 398.0]
    assert float(sized[2][1]) == pytest.approx(199.0 * math.cos(1.0))
    assert float(sized[3][1]) == pytest.approx(199.0)
    assert float(sized[4][1]) == 0.0
