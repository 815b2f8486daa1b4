"""SymPy expressions on the graph: one node per distinct subexpression, nothing expanded."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce

import sympy
from sympy import Expr, Symbol

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Op
from lagdsl.derivation.textbook import functions
from lagdsl.derivation.textbook.symbols import postorder

_UNARY: dict[type, Op] = {
    sympy.sin: Op.SIN,
    sympy.cos: Op.COS,
    sympy.tan: Op.TAN,
    sympy.asin: Op.ASIN,
    sympy.acos: Op.ACOS,
    sympy.atan: Op.ATAN,
    sympy.sinh: Op.SINH,
    sympy.cosh: Op.COSH,
    sympy.tanh: Op.TANH,
    sympy.exp: Op.EXP,
    sympy.log: Op.LOG,
    functions.Absolute: Op.ABS,
    functions.Sign: Op.SIGN,
    functions.Floor: Op.FLOOR,
    functions.Ceil: Op.CEIL,
    functions.Not: Op.NOT,
}

_BINARY: dict[type, Op] = {
    functions.ArcTangent2: Op.ATAN2,
    functions.Modulo: Op.MOD,
    functions.Minimum: Op.MIN,
    functions.Maximum: Op.MAX,
    functions.Less: Op.LESS,
    functions.LessEqual: Op.LESS_EQUAL,
    functions.Equal: Op.EQUAL,
    functions.And: Op.AND,
    functions.Or: Op.OR,
}


class ToGraph:
    """Lowers expressions in the symbols of `nodes`, sharing what they share."""

    def __init__(self, graph: Graph, nodes: Mapping[Symbol, int]) -> None:
        self.graph = graph
        self._memo: dict[Expr, int] = dict(nodes)

    def define(self, symbol: Symbol, value: Expr) -> None:
        """From here on the symbol stands for the value."""
        self._memo[symbol] = self.node(value)

    def node(self, expression: Expr) -> int:
        memo = self._memo
        for part in postorder(expression, memo):
            memo[part] = self._make(part)
        return memo[expression]

    def _make(self, expression: Expr) -> int:
        graph = self.graph
        if expression.is_Number or expression.is_NumberSymbol:
            return self._number(expression)
        arguments = [self._memo[argument] for argument in expression.args]
        if expression.is_Add:
            return graph.sum(arguments)
        if expression.is_Mul:
            return self._product(expression)
        if expression.is_Pow:
            return self._power(expression)
        kind = type(expression)
        if kind in _UNARY:
            return graph.unary(_UNARY[kind], arguments[0])
        if kind in _BINARY:
            return graph.binary(_BINARY[kind], *arguments)
        if kind is functions.Select:
            return graph.select(*arguments)
        return self._not_a_number(expression)

    def _number(self, value: Expr) -> int:
        if value is sympy.nan or value is sympy.zoo:
            return self._not_a_number(value)
        return self.graph.constant(float(value))

    def _not_a_number(self, value: Expr) -> int:
        """An expression that folds to no real number (a division by zero, the root of -1) is left to the run."""
        assert value in (sympy.nan, sympy.zoo, sympy.I), f"no operation for {type(value).__name__}"
        return self.graph.divide(self.graph.one, self.graph.zero)

    def _product(self, expression: Expr) -> int:
        """Factors with negative exponents are divided by, once."""
        graph = self.graph
        above, below = [], []
        for factor in expression.args:
            if factor.is_Pow and factor.exp.is_Number and factor.exp.is_negative:
                below.append(self._raised(factor.base, -factor.exp))
            else:
                above.append(self._memo[factor])
        numerator = _times(graph.multiply, above, graph.one)
        return graph.divide(numerator, _times(graph.multiply, below, graph.one)) if below else numerator

    def _power(self, expression: Expr) -> int:
        exponent = expression.exp
        if exponent.is_Number and exponent.is_negative:
            return self.graph.divide(self.graph.one, self._raised(expression.base, -exponent))
        return self._raised(expression.base, exponent)

    def _raised(self, base: Expr, exponent: Expr) -> int:
        """base^exponent; x^(n/2) of a small whole n is a product and a root."""
        graph = self.graph
        under = self._memo[base]
        if exponent.is_Rational and exponent.q == 2 and exponent.p < 16:
            root = graph.unary(Op.SQRT, under)
            return graph.power(root, graph.constant(float(exponent.p)))
        return graph.power(under, self.node(exponent))


def _times(multiply: Callable[[int, int], int], factors: list[int], one: int) -> int:
    return reduce(multiply, factors, one)
