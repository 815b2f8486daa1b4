"""Positions that were typed as sums, rearranged before anything is differentiated (see `lagdsl.algebra.graph.sums`).

Only scalars that depend on coordinates, parameters and time, without conditions: forces stay as they were typed.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import assert_never

from lagdsl.algebra.graph.sums import share_sums
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import Definition, FlatModel, Point
from lagdsl.language.flat.traversal import operands, postorder

_SMOOTH = frozenset(
    {"sin", "cos", "tan", "sqrt", "exp", "log", "sinh", "cosh", "tanh", "asin", "acos", "atan", "atan2"}
)
_ARITHMETIC = frozenset({"+", "-", "*", "/", "^"})
# Fewer sums than this have nothing in common that is worth a look.
_FEW = 6


def share_positions(lowering: Lowering, flat: FlatModel) -> None:
    """To be called before anything else is lowered."""
    plain = _Plain(flat)
    found = [item.value if isinstance(item, Definition) else item.position for item in plain.named]
    for term in flat.energies:
        parts = plain.visit(term.value)
        found += [part for part in (*parts, term.value) if id(part) in plain.done]
    if _are_few(found):
        return
    roots: list[int] = []
    for expression in found:
        value = lowering.value(expression)
        roots += (value,) if isinstance(value, int) else value
    lowering.values.replace(share_sums(lowering.graph, roots))


def _are_few(expressions: Sequence[FlatExpression]) -> bool:
    seen: dict[int, FlatExpression] = {}
    sums = 0
    for expression in expressions:
        for node in postorder(expression, seen):
            seen[id(node)] = node
            sums += isinstance(node, fx.Binary) and node.operator in ("+", "-")
            if sums >= _FEW:
                return False
    return True


class _Plain:
    """Recognizes expressions that are arithmetic of coordinates, parameters, time and other such expressions."""

    def __init__(self, flat: FlatModel) -> None:
        moving = (*flat.states, *flat.inputs)
        self._others = {item.name for item in moving}
        self._points: set[str] = set()
        self.done: dict[int, FlatExpression] = {}
        """Nodes that are, by identity."""
        self.named: list[Definition | Point] = []
        for item in flat.named:
            if isinstance(item, Definition):
                if self.covers(item.value):
                    self.named.append(item)
                else:
                    self._others.add(item.name)
            elif isinstance(item, Point) and self.covers(item.position):
                self._points.add(item.name)
                self.named.append(item)

    def covers(self, expression: FlatExpression) -> bool:
        self.visit(expression)
        return id(expression) in self.done

    def visit(self, expression: FlatExpression) -> list[FlatExpression]:
        """Terms in it that are differentiated."""
        done, found = self.done, []
        for node in postorder(expression, done):
            if type(node) is fx.Binary:  # most nodes
                if node.operator in _ARITHMETIC and id(node.left) in done and id(node.right) in done:
                    done[id(node)] = node
            elif isinstance(node, fx.Derivative):
                found.append(node.operand)
            elif self._is_plain(node) and all(id(part) in done for part in operands(node)):
                done[id(node)] = node
        return found

    def _is_plain(self, node: FlatExpression) -> bool:
        match node:
            case fx.Binary(operator):
                return operator in _ARITHMETIC
            case fx.Variable(name):
                return name not in self._others
            case fx.Number() | fx.Unary("-") | fx.Vector() | fx.Component() | fx.Cross():
                return True
            case fx.PointReference(name):
                return name in self._points
            case fx.Function(name):
                return name in _SMOOTH
            case fx.Previous() | fx.Derivative() | fx.Operation() | fx.OfFrame() | fx.Mechanical() | fx.OfMechanism():
                return False
            case _:
                assert_never(node)
