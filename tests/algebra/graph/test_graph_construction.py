"""Nodes are shared, and simplified one level deep when they are made."""

import math

import pytest

from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.algebra.graph.fold import fold
from lagdsl.algebra.graph.substitute import Substitution


@pytest.fixture
def graph() -> Graph:
    return Graph()


@pytest.fixture
def x(graph: Graph) -> int:
    return graph.symbol(Group.Q, 0)


@pytest.fixture
def y(graph: Graph) -> int:
    return graph.symbol(Group.QD, 1)


def test_equal_expressions_are_one_node(graph: Graph, x: int, y: int) -> None:
    assert graph.add(x, y) == graph.add(y, x)
    assert graph.multiply(x, y) == graph.multiply(y, x)
    assert graph.unary(Op.SIN, x) == graph.unary(Op.SIN, x)
    assert graph.select(graph.binary(Op.LESS, x, y), x, y) == graph.select(graph.binary(Op.LESS, x, y), x, y)
    assert graph.symbol(Group.Q, 0) == x
    assert graph.constant(-0.0) == graph.zero


def test_zeros_and_ones_vanish(graph: Graph, x: int) -> None:
    zero, one = graph.zero, graph.one
    assert graph.add(x, zero) == graph.add(zero, x) == x
    assert graph.subtract(x, zero) == x
    assert graph.subtract(zero, x) == graph.negate(x)
    assert graph.subtract(x, x) == zero
    assert graph.multiply(x, zero) == graph.multiply(zero, x) == zero
    assert graph.multiply(x, one) == graph.multiply(one, x) == x
    assert graph.divide(x, one) == x
    assert graph.divide(zero, x) == zero


def test_signs_move_outward(graph: Graph, x: int, y: int) -> None:
    minus_x, minus_y = graph.negate(x), graph.negate(y)
    assert graph.negate(minus_x) == x
    assert graph.add(x, minus_y) == graph.subtract(x, y)
    assert graph.add(minus_x, y) == graph.subtract(y, x)
    assert graph.subtract(x, minus_y) == graph.add(x, y)
    assert graph.subtract(minus_x, y) == graph.negate(graph.add(x, y))
    assert graph.negate(graph.subtract(x, y)) == graph.subtract(y, x)
    assert graph.multiply(minus_x, y) == graph.multiply(x, minus_y) == graph.negate(graph.multiply(x, y))
    assert graph.divide(minus_x, y) == graph.divide(x, minus_y) == graph.negate(graph.divide(x, y))
    assert graph.unary(Op.SIN, minus_x) == graph.negate(graph.unary(Op.SIN, x))
    assert graph.unary(Op.COS, minus_x) == graph.unary(Op.COS, x)
    assert graph.unary(Op.EXP, minus_x) != graph.unary(Op.EXP, x)
    assert graph.unary(Op.NEGATE, x) == minus_x


def test_constants_fold_and_gather(graph: Graph, x: int) -> None:
    c = graph.constant
    assert graph.add(c(2.0), c(3.0)) == c(5.0)
    assert graph.subtract(c(2.0), c(3.0)) == c(-1.0)
    assert graph.multiply(c(2.0), c(3.0)) == c(6.0)
    assert graph.divide(c(3.0), c(2.0)) == c(1.5)
    assert graph.power(c(2.0), c(10.0)) == c(1024.0)
    assert graph.unary(Op.SQRT, c(9.0)) == c(3.0)
    assert graph.binary(Op.MAX, c(2.0), c(3.0)) == c(3.0)
    assert graph.select(c(1.0), x, c(3.0)) == x
    assert graph.select(c(0.0), x, c(3.0)) == c(3.0)
    assert graph.select(x, c(3.0), c(3.0)) == c(3.0)
    assert graph.add(x, x) == graph.multiply(c(2.0), x)
    assert graph.multiply(c(3.0), graph.multiply(x, c(2.0))) == graph.multiply(c(6.0), x)
    assert graph.multiply(c(-3.0), x) == graph.negate(graph.multiply(c(3.0), x))
    assert graph.multiply(c(3.0), graph.negate(x)) == graph.negate(graph.multiply(c(3.0), x))
    assert graph.divide(x, c(4.0)) == graph.multiply(c(0.25), x)
    assert graph.op[graph.divide(x, c(3.0))] is Op.DIVIDE


def test_what_is_not_a_number_is_left_to_run_time(graph: Graph, x: int) -> None:
    c = graph.constant
    assert graph.op[graph.divide(graph.one, graph.zero)] is Op.DIVIDE
    assert graph.op[graph.divide(x, graph.zero)] is Op.DIVIDE
    assert graph.op[graph.unary(Op.SQRT, c(-1.0))] is Op.SQRT
    assert graph.op[graph.unary(Op.LOG, graph.zero)] is Op.LOG
    assert graph.op[graph.power(graph.zero, c(-1.5))] is Op.POWER
    assert graph.op[graph.multiply(c(1e300), c(1e300))] is Op.MULTIPLY
    assert graph.op[graph.b[graph.multiply(c(1e300), graph.multiply(c(1e300), x))]] is Op.MULTIPLY
    assert graph.op[graph.add(c(1.7e308), c(1.6e308))] is Op.ADD
    assert graph.op[graph.subtract(c(math.inf), graph.add(c(math.inf), c(1.0)))] is Op.CONSTANT
    assert graph.op[graph.subtract(c(1.7e308), c(-1.7e308))] is Op.SUBTRACT
    assert graph.op[graph.divide(c(1e300), c(1e-300))] is Op.DIVIDE
    assert fold(Op.ADD, math.inf, 1.0) == math.inf
    assert fold(Op.SUBTRACT, math.inf, math.inf) is None


def test_powers_become_products_and_roots(graph: Graph, x: int, y: int) -> None:
    c = graph.constant
    assert graph.power(x, c(2.0)) == graph.multiply(x, x)
    assert graph.power(x, c(0.0)) == graph.one
    assert graph.power(x, c(0.5)) == graph.unary(Op.SQRT, x)
    assert graph.power(x, c(-1.0)) == graph.divide(graph.one, x)
    assert graph.power(x, c(3.0)) == graph.multiply(graph.multiply(x, x), x)
    assert graph.op[graph.power(x, c(9.0))] is Op.POWER
    assert graph.op[graph.power(x, y)] is Op.POWER


@pytest.mark.parametrize(("op", "value"), [(Op.ADD, 5.0), (Op.SUBTRACT, -1.0), (Op.DIVIDE, 2 / 3), (Op.POWER, 8.0)])
def test_binary_goes_through_the_rules(graph: Graph, op: Op, value: float) -> None:
    assert graph.value[graph.binary(op, graph.constant(2.0), graph.constant(3.0))] == pytest.approx(value)


def test_groups_tell_what_a_node_depends_on(graph: Graph, x: int, y: int) -> None:
    both = graph.select(x, graph.unary(Op.SIN, y), graph.one)
    assert graph.depends(both, Group.Q) and graph.depends(both, Group.QD, Group.P)
    assert not graph.depends(both, Group.P, Group.TIME)
    assert not graph.groups[graph.one]


def test_live_and_arguments(graph: Graph, x: int, y: int) -> None:
    product = graph.multiply(x, y)
    graph.add(x, graph.one)
    assert graph.live([product]) == sorted([x, y, product])
    assert graph.live([]) == []
    assert graph.arguments(x) == ()
    choice = graph.select(x, y, product)
    assert graph.arguments(choice) == (x, y, product)
    assert graph.rebuild(choice, (graph.one, y, product)) == y
    assert graph.rebuild(x, ()) == x
    assert len(graph) > 5
    assert graph.symbols(Group.P, 2)[1] == graph.symbol(Group.P, 1)


def test_substitution_simplifies_on_the_way_up(graph: Graph, x: int, y: int) -> None:
    root = graph.add(graph.multiply(graph.unary(Op.SIN, x), y), graph.unary(Op.COS, x))
    at_zero = Substitution(graph, {x: graph.zero})
    assert at_zero.of(root) == graph.one
    assert at_zero.of(y) == y
    assert at_zero.of_all([x, root]) == [graph.zero, graph.one]
