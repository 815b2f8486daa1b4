"""Partial derivatives of single operations, as nodes that reuse the operation's own value where they can."""

from __future__ import annotations

from collections.abc import Callable

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import STEPS, Op


def unary_partial(graph: Graph, node: int) -> int:
    """d(node)/d(its argument). Steps (sign, floor, ceil, not) have derivative 0, |x| has sign(x): 0 at 0."""
    return _UNARY[graph.op[node]](graph, node, graph.a[node])


_UNARY: dict[Op, Callable[[Graph, int, int], int]] = {
    Op.SIN: lambda graph, node, x: graph.unary(Op.COS, x),
    Op.COS: lambda graph, node, x: graph.negate(graph.unary(Op.SIN, x)),
    Op.TAN: lambda graph, node, x: graph.add(graph.one, graph.multiply(node, node)),
    Op.ASIN: lambda graph, node, x: graph.divide(graph.one, _root_of_one_minus_square(graph, x)),
    Op.ACOS: lambda graph, node, x: graph.negate(graph.divide(graph.one, _root_of_one_minus_square(graph, x))),
    Op.ATAN: lambda graph, node, x: graph.divide(graph.one, graph.add(graph.one, graph.multiply(x, x))),
    Op.SINH: lambda graph, node, x: graph.unary(Op.COSH, x),
    Op.COSH: lambda graph, node, x: graph.unary(Op.SINH, x),
    Op.TANH: lambda graph, node, x: graph.subtract(graph.one, graph.multiply(node, node)),
    Op.EXP: lambda graph, node, x: node,
    Op.LOG: lambda graph, node, x: graph.divide(graph.one, x),
    Op.SQRT: lambda graph, node, x: graph.divide(graph.constant(0.5), node),
    Op.ABS: lambda graph, node, x: graph.unary(Op.SIGN, x),
    **dict.fromkeys((Op.SIGN, Op.FLOOR, Op.CEIL, Op.NOT), lambda graph, node, x: graph.zero),
}


def _root_of_one_minus_square(graph: Graph, x: int) -> int:
    """sqrt(1 - x^2) as (1 - x)(1 + x), which keeps its digits near 1."""
    product = graph.multiply(graph.subtract(graph.one, x), graph.add(graph.one, x))
    return graph.unary(Op.SQRT, product)


def binary_partial(graph: Graph, node: int, position: int) -> int:
    """d(node)/d(argument 0 or 1) of an operation other than + - * /. Comparisons and logic have derivative 0."""
    x, y = graph.a[node], graph.b[node]
    op = graph.op[node]
    if op is Op.POWER:
        return _power_exponent(graph, node) if position else _power_base(graph, x, y)
    if op is Op.ATAN2:
        square = graph.add(graph.multiply(x, x), graph.multiply(y, y))
        return graph.negate(graph.divide(x, square)) if position else graph.divide(y, square)
    if op is Op.MOD:
        return graph.negate(graph.unary(Op.FLOOR, graph.divide(x, y))) if position else graph.one
    if op is Op.MIN:
        return _indicator(graph, graph.binary(Op.LESS_EQUAL, x, y), position)
    if op is Op.MAX:
        return _indicator(graph, graph.binary(Op.LESS_EQUAL, y, x), position)
    assert op in STEPS, op
    return graph.zero


def _power_base(graph: Graph, x: int, y: int) -> int:
    """y x^(y-1); with a constant exponent the lower power is a product or a root where it can be one."""
    return graph.multiply(y, graph.power(x, graph.subtract(y, graph.one)))


def _power_exponent(graph: Graph, node: int) -> int:
    """x^y log(x), and 0 at x = 0: the logarithm is taken of 1 there."""
    x = graph.a[node]
    at_zero = graph.binary(Op.EQUAL, x, graph.zero)
    return graph.multiply(node, graph.unary(Op.LOG, graph.select(at_zero, graph.one, x)))


def _indicator(graph: Graph, first: int, position: int) -> int:
    """1 where the argument at `position` is the one taken, else 0."""
    return graph.select(first, graph.zero, graph.one) if position else graph.select(first, graph.one, graph.zero)
