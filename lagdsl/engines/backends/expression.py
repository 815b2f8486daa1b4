"""Printing nodes as infix expressions; C, Python and their kin differ in their leaves and function names only."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Op

_INFIX: Final = {Op.ADD: (" + ", 1), Op.SUBTRACT: (" - ", 1), Op.MULTIPLY: ("*", 2), Op.DIVIDE: ("/", 2)}
_NEGATION: Final = 3
_ATOM: Final = 4


class ExpressionPrinter:
    """Expressions in the order of evaluation of the graph: nothing is reassociated.

    `leaf` gives the text of a node that is at hand (a variable, a symbol, a number) or None; `functions` the names of
    operations that are not infix; `divide`, where given, that of a quotient of two numbers, which is no number then;
    `fuse` that of x*y + z, for the sums and differences of `fused`, by which of their operands is the product.
    """

    def __init__(
        self,
        graph: Graph,
        leaf: Callable[[int], str | None],
        functions: Mapping[Op, str],
        *,
        divide: str | None = None,
        fused: Mapping[int, int] | None = None,
        fuse: str = "",
    ) -> None:
        self._graph = graph
        self._leaf = leaf
        self._functions = functions
        self._divide = divide
        self._fused = fused or {}
        self._fuse = fuse

    def text(self, node: int) -> str:
        """The expression of `node`; an atom if the node is at hand."""
        leaf = self._leaf(node)
        return self.definition(node) if leaf is None else leaf

    def definition(self, node: int) -> str:
        """The expression that computes `node` from its arguments."""
        return self._operation(node)[0]

    def _operation(self, node: int) -> tuple[str, int]:
        graph = self._graph
        op = graph.op[node]
        if node in self._fused:
            return self._fusion(node), _ATOM
        if op is Op.NEGATE:
            return "-" + self._wrapped(graph.a[node], _ATOM), _NEGATION
        if op is Op.DIVIDE and self._divide is not None and all(map(graph.is_constant, graph.arguments(node))):
            return f"{self._divide}({self.text(graph.a[node])}, {self.text(graph.b[node])})", _ATOM
        if op in _INFIX:
            sign, level = _INFIX[op]
            return self._wrapped(graph.a[node], level) + sign + self._wrapped(graph.b[node], level + 1), level
        arguments = ", ".join(self.text(argument) for argument in graph.arguments(node))
        return f"{self._functions[op]}({arguments})", _ATOM

    def _fusion(self, node: int) -> str:
        own, which = self._graph.arguments(node), self._fused[node]
        x, y = (self.text(factor) for factor in self._graph.arguments(own[which]))
        rest = self.text(own[1 - which])
        return f"{self._fuse}({fused_arguments(self._graph.op[node], which, x, y, rest)})"

    def _wrapped(self, node: int, level: int) -> str:
        leaf = self._leaf(node)
        text, own = self._operation(node) if leaf is None else (leaf, _ATOM)
        if text.startswith("-"):
            own = 0  # a sign never stands next to another one
        return f"({text})" if own < level else text


def fused_arguments(op: Op, which: int, x: str, y: str, rest: str) -> str:
    """The arguments of x*y + z for a sum or difference of the product x*y, its operand `which`, and `rest`."""
    if op is Op.ADD:
        return f"{x}, {y}, {rest}"
    return f"{x}, {y}, -({rest})" if which == 0 else f"-({x}), {y}, {rest}"
