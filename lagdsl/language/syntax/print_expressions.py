"""Expressions as text: `*`, `/` and `^` tight, blanks around the other operators, none around `+ -` in subscripts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import assert_never

from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.layout import Break, Piece

_TIGHT = ("*", "/", "^")
_ESCAPES = str.maketrans({"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t", "\r": "\\r"})


def quoted(text: str) -> str:
    """The literal of a string, on one line."""
    return f'"{text.translate(_ESCAPES)}"'


class ExpressionWriter:
    """Collects the pieces of expressions. `level` counts the brackets around: outer places break first."""

    def __init__(self) -> None:
        self.pieces: list[Piece] = []
        self._after_unit = False  # `2 m / s` divides by a variable, `2 m/s` is a unit

    def text(self, text: str) -> None:
        self.pieces.append(text)
        self._after_unit = False

    def place(self, level: int) -> None:
        """A blank where the line may break."""
        self.pieces.append(Break(level))

    def expression(self, node: nodes.Expression, level: int = 0, tight: bool = False) -> None:
        match node:
            case nodes.Binary():
                self._binary(node, level, tight)
            case nodes.Unary():
                self.text("not " if node.operator == "not" else node.operator)
                self.expression(node.operand, level, tight)
            case nodes.Conditional():
                self._conditional(node, level, tight)
            case nodes.Member() | nodes.Index() | nodes.Call() | nodes.Reduction():
                self._postfix(node, level, tight)
            case nodes.Parenthesized() | nodes.Tuple() | nodes.Array() | nodes.Matrix() | nodes.Comprehension():
                self._bracketed(node, level, tight)
            case nodes.Quantity():
                self.text(f"{node.number} {node.unit}")
                self._after_unit = True
            case nodes.Number() | nodes.String() | nodes.Boolean() | nodes.Reference():
                self.text(_leaf(node))
            case _:
                assert_never(node)

    def argument(self, node: nodes.Expression | nodes.Named, level: int) -> None:
        if isinstance(node, nodes.Named):
            self.text(f"{node.name} = ")
            node = node.value
        self.expression(node, level)

    def arguments(self, items: Iterable[nodes.Expression | nodes.Named], level: int) -> None:
        for position, item in enumerate(items):
            if position:
                self.text(",")
                self.place(level)
            self.argument(item, level + 1)

    def subscripts(self, items: Sequence[nodes.Subscript]) -> None:
        """`[i, 1:n]`, or nothing if there are none."""
        if not items:
            return
        self.text("[")
        for position, item in enumerate(items):
            if position:
                self.text(", ")
            self.subscript(item)
        self.text("]")

    def subscript(self, item: nodes.Subscript) -> None:
        match item:
            case nodes.All():
                self.text(":")
            case nodes.Range():
                for position, part in enumerate(
                    part for part in (item.start, item.step, item.stop) if part is not None
                ):
                    if position:
                        self.text(":")
                    self.expression(part, tight=True)
            case nodes.Literal() | nodes.Designator() | nodes.Compound() | nodes.Parenthesized():
                self.expression(item, tight=True)
            case _:
                assert_never(item)

    def iterators(self, items: Iterable[nodes.Iterator]) -> None:
        for position, item in enumerate(items):
            self.text(f"{', ' if position else ''}{item.name} in ")
            self.subscript(item.range)

    def _binary(self, node: nodes.Binary, level: int, tight: bool) -> None:
        """A chain of operators that associate to the left is written without recursion."""
        chain: list[nodes.Binary] = []
        left: nodes.Expression = node
        while isinstance(left, nodes.Binary):
            chain.append(left)
            left = left.left
        self.expression(left, level, tight)
        for link in reversed(chain):
            self._operator(link.operator, level, tight)
            self.expression(link.right, level + 1, tight)

    def _operator(self, operator: str, level: int, tight: bool) -> None:
        if operator in _TIGHT:
            self.text(f" {operator} " if self._after_unit and operator != "*" else operator)
        elif tight and operator in ("+", "-"):
            self.text(operator)
        else:
            self.place(level)
            self.text(f"{operator} ")

    def _conditional(self, node: nodes.Conditional, level: int, tight: bool) -> None:
        for position, branch in enumerate(node.branches):
            if position:
                self.place(level)
            self.text("elseif " if position else "if ")
            self.expression(branch.condition, level + 1, tight)
            self.place(level)
            self.text("then ")
            self.expression(branch.value, level + 1, tight)
        self.place(level)
        self.text("else ")
        self.expression(node.otherwise, level + 1, tight)

    def _postfix(
        self, node: nodes.Member | nodes.Index | nodes.Call | nodes.Reduction, level: int, tight: bool
    ) -> None:
        match node:
            case nodes.Member():
                self.expression(node.target, level, tight)
                self.text(f".{node.name}")
            case nodes.Index():
                self.expression(node.target, level, tight)
                self.subscripts(node.subscripts)
            case nodes.Call():
                self.expression(node.function, level, tight)
                self.text("(")
                self.arguments(node.arguments, level + 1)
                self.text(")")
            case nodes.Reduction():
                self.expression(node.function, level, tight)
                self._generator("(", node, ")", level)

    def _generator(self, opening: str, node: nodes.Reduction | nodes.Comprehension, closing: str, level: int) -> None:
        self.text(opening)
        self.expression(node.body, level + 1)
        self.text(" for ")
        self.iterators(node.iterators)
        self.text(closing)

    def _bracketed(
        self,
        node: nodes.Parenthesized | nodes.Tuple | nodes.Array | nodes.Matrix | nodes.Comprehension,
        level: int,
        tight: bool,
    ) -> None:
        match node:
            case nodes.Parenthesized():
                self.text("(")
                self.expression(node.inner, level + 1, tight)
                self.text(")")
            case nodes.Tuple() | nodes.Array():
                self.text("(" if isinstance(node, nodes.Tuple) else "{")
                self.arguments(node.elements, level + 1)
                self.text(")" if isinstance(node, nodes.Tuple) else "}")
            case nodes.Matrix():
                self.text("[")
                for position, row in enumerate(node.rows):
                    if position:
                        self.text(";")
                        self.place(level + 1)
                    self.arguments(row, level + 2)
                self.text("]")
            case nodes.Comprehension():
                self._generator("{", node, "}", level)


def _leaf(node: nodes.Number | nodes.String | nodes.Boolean | nodes.Reference) -> str:
    match node:
        case nodes.Number():
            return node.text
        case nodes.String():
            return quoted(node.value)
        case nodes.Boolean():
            return "true" if node.value else "false"
        case nodes.Reference():
            return node.name
