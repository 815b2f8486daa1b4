"""Random expression trees for property tests, and the graph nodes they stand for."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

from lagdsl.algebra.graph import Graph, Group, Op

Tree = Any

SMOOTH = (
    (Op.NEGATE, 1),
    (Op.SIN, 1),
    (Op.COS, 1),
    (Op.ATAN, 1),
    (Op.TANH, 1),
    (Op.EXP, 1),
    (Op.SQRT, 1),
    (Op.LOG, 1),
    (Op.ADD, 2),
    (Op.SUBTRACT, 2),
    (Op.MULTIPLY, 2),
    (Op.DIVIDE, 2),
)
# Not ATAN2: it tells -0.0 from 0.0, the graph does not.
EVERYTHING = (
    *SMOOTH,
    (Op.TAN, 1),
    (Op.ASIN, 1),
    (Op.ACOS, 1),
    (Op.SINH, 1),
    (Op.COSH, 1),
    (Op.ABS, 1),
    (Op.SIGN, 1),
    (Op.FLOOR, 1),
    (Op.CEIL, 1),
    (Op.NOT, 1),
    (Op.POWER, 2),
    (Op.MOD, 2),
    (Op.MIN, 2),
    (Op.MAX, 2),
    (Op.LESS, 2),
    (Op.LESS_EQUAL, 2),
    (Op.EQUAL, 2),
    (Op.AND, 2),
    (Op.OR, 2),
    (Op.SELECT, 3),
)


def trees(operations: tuple[tuple[Op, int], ...] = EVERYTHING) -> st.SearchStrategy[Tree]:
    """("symbol", 0..2), ("constant", value) or (op, argument, ...)."""
    leaves = st.one_of(
        st.tuples(st.just("symbol"), st.integers(0, 2)),
        st.tuples(st.just("constant"), st.sampled_from([0.0, 1.0, -1.0, 2.0, 0.5, -3.0, 1.7])),
    )

    def extend(inner: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
        return st.one_of(*(st.tuples(st.just(op), *[inner] * count) for op, count in operations))

    return st.recursive(leaves, extend, max_leaves=12)


def build(graph: Graph, tree: Tree) -> int:
    match tree:
        case ("symbol", index):
            return graph.symbol(Group.Q, index)
        case ("constant", value):
            return graph.constant(value)
        case (Op.SELECT, condition, value, otherwise):
            return graph.select(build(graph, condition), build(graph, value), build(graph, otherwise))
        case (op, x):
            return graph.unary(op, build(graph, x))
        case (op, x, y):
            return graph.binary(op, build(graph, x), build(graph, y))
    raise AssertionError(tree)
