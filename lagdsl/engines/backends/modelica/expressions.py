"""Nodes as expressions of Modelica, which tells Booleans from numbers. On the graph truths are the numbers 0 and 1."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import ELEMENTARY_NAMES, Op

_FUNCTIONS = {**ELEMENTARY_NAMES, Op.MOD: "mod"}
_TRUTHS = frozenset({Op.NOT, Op.LESS, Op.LESS_EQUAL, Op.EQUAL, Op.AND, Op.OR})
_LARGEST = "1.7976931348623157e308"
# Precedence of operators.
_CONDITIONAL, _OR, _AND, _NOT, _RELATION, _SUM, _PRODUCT, _POWER, _ATOM = range(9)
# Sign, its precedence, and the least ones of its operands without parentheses.
_INFIX = {
    Op.ADD: (" + ", _SUM, _SUM, _PRODUCT),
    Op.SUBTRACT: (" - ", _SUM, _SUM, _PRODUCT),
    Op.MULTIPLY: ("*", _PRODUCT, _PRODUCT, _POWER),
    Op.DIVIDE: ("/", _PRODUCT, _PRODUCT, _POWER),
    Op.POWER: ("^", _POWER, _ATOM, _ATOM),
}
_RELATIONS = {Op.LESS: "<", Op.LESS_EQUAL: "<="}
_CORNERED = frozenset({Op.ABS, Op.SIGN, Op.MIN, Op.MAX})


class Expressions:
    """Prints in the order of evaluation of the graph.

    `leaf` gives the text of a node that is at hand (a symbol, a variable) or None; `truths` are symbols that are
    Boolean in Modelica.
    """

    def __init__(self, graph: Graph, leaf: Callable[[int], str | None], truths: Iterable[int]) -> None:
        self._graph = graph
        self._leaf = leaf
        self._truth = dict.fromkeys(truths, True)

    def is_truth(self, node: int) -> bool:
        """True if the expression of `node` is Boolean."""
        known = self._truth.get(node)
        if known is None:
            known = self._truth[node] = self._found_truth(node)
        return known

    def _found_truth(self, node: int) -> bool:
        graph = self._graph
        if graph.op[node] is not Op.SELECT:
            return graph.op[node] in _TRUTHS
        branches = graph.arguments(node)[1:]
        return any(map(self.is_truth, branches)) and all(self.is_truth(b) or self._is_bit(b) for b in branches)

    def _is_bit(self, node: int) -> bool:
        return self._graph.is_constant(node) and self._graph.value[node] in (0.0, 1.0)

    def number(self, node: int) -> str:
        """The value of `node` as a Real expression."""
        return self._number(node)[0]

    def condition(self, node: int) -> str:
        """True where the value of `node` is not 0, as a Boolean expression."""
        return self._condition(node)[0]

    def definition(self, node: int) -> str:
        """The expression that computes `node` from its arguments, Boolean where `is_truth` says so."""
        return (self._truth_of(node) if self.is_truth(node) else self._operation(node))[0]

    def _number(self, node: int) -> tuple[str, int]:
        if self.is_truth(node):
            return f"if {self.condition(node)} then 1 else 0", _CONDITIONAL
        leaf = self._leaf(node)
        if leaf is not None:
            return leaf, _ATOM
        if self._graph.is_constant(node):
            return literal(self._graph.value[node])
        return self._operation(node)

    def _operation(self, node: int) -> tuple[str, int]:
        graph = self._graph
        op, arguments = graph.op[node], graph.arguments(node)
        if op is Op.NEGATE:
            return f"-{self._held(arguments[0], _PRODUCT)}", _SUM
        if op in _INFIX:
            sign, level, left, right = _INFIX[op]
            return f"{self._held(arguments[0], left)}{sign}{self._held(arguments[1], right)}", level
        if op is Op.SELECT:
            value, otherwise = (self._held(each, _OR) for each in arguments[1:])
            return f"if {self.condition(arguments[0])} then {value} else {otherwise}", _CONDITIONAL
        if op in _CORNERED:
            return self._cornered(op, *(self._held(each, _SUM) for each in arguments)), _CONDITIONAL
        return f"{_FUNCTIONS[op]}({', '.join(map(self.number, arguments))})", _ATOM

    def _cornered(self, op: Op, a: str, b: str = "0") -> str:
        """A function with a corner or a jump by a relation, so that steps end there: tools pass over those of `abs`."""
        if op is Op.SIGN:
            return f"if {a} > 0 then 1 elseif {a} < 0 then -1 else 0"
        otherwise = f"-({a})" if op is Op.ABS else b
        return f"if {a} {'<=' if op is Op.MIN else '>='} {b} then {a} else {otherwise}"

    def _held(self, node: int, level: int) -> str:
        text, own = self._number(node)
        return text if own >= level else f"({text})"

    def _condition(self, node: int) -> tuple[str, int]:
        graph = self._graph
        if graph.is_constant(node):
            return ("true" if graph.value[node] != 0.0 else "false"), _ATOM
        if not self.is_truth(node):
            return f"{self._held(node, _SUM)} < 0 or {self._held(node, _SUM)} > 0", _OR
        leaf = self._leaf(node)
        return self._truth_of(node) if leaf is None else (leaf, _ATOM)

    def _truth_of(self, node: int) -> tuple[str, int]:
        op, arguments = self._graph.op[node], self._graph.arguments(node)
        if op is Op.NOT:
            return f"not {self._kept(arguments[0], _RELATION)}", _NOT
        if op is Op.AND:
            return " and ".join(self._kept(each, _NOT) for each in arguments), _AND
        if op is Op.OR:
            return " or ".join(self._kept(each, _AND) for each in arguments), _OR
        if op is Op.SELECT:
            c, value, otherwise = (self._kept(each, _OR) for each in arguments)
            return f"if {c} then {value} else {otherwise}", _CONDITIONAL
        a, b = (self._held(each, _SUM) for each in arguments)
        if op is Op.EQUAL:  # Modelica has `==` for two Reals inside functions only
            return f"{a} <= {b} and {a} >= {b}", _AND
        return f"{a} {_RELATIONS[op]} {b}", _RELATION

    def _kept(self, node: int, level: int) -> str:
        text, own = self._condition(node)
        return text if own >= level else f"({text})"


def literal(value: float) -> tuple[str, int]:
    """A number and the precedence of its text; Modelica has no infinity, its largest Real stands for it."""
    size = abs(value)
    text = _LARGEST if math.isinf(size) else repr(int(size)) if size.is_integer() and size < 1e15 else repr(size)
    return (f"-{text}", _SUM) if value < 0.0 else (text, _ATOM)
