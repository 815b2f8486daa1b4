"""Operators and functions of flat expressions as operations of the graph."""

from __future__ import annotations

from typing import assert_never

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Op
from lagdsl.language.flat.expression import BinaryOperator

_BINARY: dict[str, Op] = {
    "+": Op.ADD,
    "-": Op.SUBTRACT,
    "*": Op.MULTIPLY,
    "/": Op.DIVIDE,
    "^": Op.POWER,
    "<": Op.LESS,
    "<=": Op.LESS_EQUAL,
    "==": Op.EQUAL,
    "and": Op.AND,
    "or": Op.OR,
}

_FUNCTIONS: dict[str, Op] = {
    "sin": Op.SIN,
    "cos": Op.COS,
    "tan": Op.TAN,
    "asin": Op.ASIN,
    "acos": Op.ACOS,
    "atan": Op.ATAN,
    "atan2": Op.ATAN2,
    "sinh": Op.SINH,
    "cosh": Op.COSH,
    "tanh": Op.TANH,
    "exp": Op.EXP,
    "log": Op.LOG,
    "sqrt": Op.SQRT,
    "abs": Op.ABS,
    "sign": Op.SIGN,
    "floor": Op.FLOOR,
    "ceil": Op.CEIL,
    "mod": Op.MOD,
    "min": Op.MIN,
    "max": Op.MAX,
}


def binary(graph: Graph, operator: BinaryOperator, left: int, right: int) -> int:
    """A scalar operator; `>` and `>=` are the opposite comparisons with sides exchanged."""
    match operator:  # what models consist of stands first
        case "+" | "-" | "*" | "/" | "^" | "<" | "<=" | "==" | "and" | "or":
            return graph.binary(_BINARY[operator], left, right)
        case ">":
            return graph.binary(Op.LESS, right, left)
        case ">=":
            return graph.binary(Op.LESS_EQUAL, right, left)
        case "<>":
            return graph.unary(Op.NOT, graph.binary(Op.EQUAL, left, right))
        case _:
            assert_never(operator)


def function(graph: Graph, name: str, arguments: list[int]) -> int:
    """One of `flat_expression.FUNCTIONS`."""
    op = _FUNCTIONS[name]
    return graph.unary(op, *arguments) if len(arguments) == 1 else graph.binary(op, *arguments)
