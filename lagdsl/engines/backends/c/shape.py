"""Parts that statements share: the shape of an expression, and its leaves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Op
from lagdsl.engines.backends.c.dialect import Place
from lagdsl.engines.backends.c.statement import Listing, Statement
from lagdsl.foundation.record import record

# A variable (its index among the statements), a constant, or an entry of an array.
Leaf: TypeAlias = "int | float | Place"


@record()
class Shaped:
    """A statement without its indices: `shape` is a number that equal shapes share, `leaves` in order of reading."""

    shape: int
    leaves: tuple[Leaf, ...]


class Shapes:
    """Numbers for shapes of expressions; `parts` tells what number i is made of: an operation and shapes, or a leaf."""

    def __init__(self, listing: Listing, fused: Mapping[int, int]) -> None:
        self._fused = fused
        self._graph, self._given = listing.graph, listing.given
        self._number: dict[tuple[object, ...], int] = {}
        self.parts: list[tuple[object, ...]] = []
        self._position = {s.node: index for index, s in enumerate(listing.statements) if s.is_variable}
        self._variable, self._constant = self._numbered("variable"), self._numbered("constant")
        self._entry = {array: self._numbered("place", array) for array in ARGUMENT_NAMES.values()}

    def of(self, statement: Statement) -> Shaped:
        """Shape of what a statement does; a store has its target as the last leaf."""
        if statement.gather is not None:
            return Shaped(self._numbered("gather", statement.gather), ())
        if statement.store is None:
            return Shaped(*self._operation(statement.node))
        shape, leaves = self._expression(statement.node)
        target = statement.store.target
        return Shaped(self._numbered("store", target.array, shape), (*leaves, target))

    def _expression(self, node: int) -> tuple[int, tuple[Leaf, ...]]:
        index = self._position.get(node)
        if index is not None:
            return self._variable, (index,)
        place = self._given.get(node)
        if place is not None:
            return self._numbered("place", place.array), (place,)
        graph = self._graph
        if graph.op[node] is Op.SYMBOL:
            place = Place(ARGUMENT_NAMES[graph.group(node)], graph.b[node])
            return self._entry[place.array], (place,)
        if graph.op[node] is Op.CONSTANT:
            return self._constant, (graph.value[node],)
        return self._operation(node)

    def _operation(self, node: int) -> tuple[int, tuple[Leaf, ...]]:
        """Arguments of sums and products stand in the order of their shapes: both orders give the same bits."""
        op, operands = self._graph.op[node], self._graph.operands[node]
        if node in self._fused:
            return self._fusion(op, operands, self._fused[node])
        if len(operands) == 1:
            shape, leaves = self._expression(operands[0])
            return self._numbered(op, shape), leaves
        if len(operands) == 2:
            first, first_leaves = self._expression(operands[0])
            second, second_leaves = self._expression(operands[1])
            if second < first and (op is Op.ADD or op is Op.MULTIPLY):
                return self._numbered(op, second, first), second_leaves + first_leaves
            return self._numbered(op, first, second), first_leaves + second_leaves
        found = [self._expression(operand) for operand in operands]
        return self._numbered(op, *(shape for shape, _ in found)), tuple(leaf for _, leaves in found for leaf in leaves)

    def _fusion(self, op: Op, operands: Sequence[int], which: int) -> tuple[int, tuple[Leaf, ...]]:
        """The shapes of both factors and of what is added."""
        first, second = (self._expression(factor) for factor in self._graph.operands[operands[which]])
        if second[0] < first[0]:
            first, second = second, first
        rest = self._expression(operands[1 - which])
        return self._numbered("fused", (op, which), first[0], second[0], rest[0]), first[1] + second[1] + rest[1]

    def _numbered(self, *parts: object) -> int:
        number = self._number.get(parts)
        if number is None:
            number = self._number[parts] = len(self.parts)
            self.parts.append(parts)
        return number
