"""What statements have in common: the shape of an expression, and what stands at its leaves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from lagdsl.backends.c.dialect import Place
from lagdsl.backends.c.statement import Listing, Statement
from lagdsl.graph.operation import ARGUMENT_NAMES, Op

# A variable (its index among the statements), a constant, or an entry of an array.
Leaf: TypeAlias = "int | float | Place"


@dataclass(frozen=True, slots=True)
class Shaped:
    """A statement without its indices: `shape` is a number that equal shapes share, `leaves` in order of reading."""

    shape: int
    leaves: tuple[Leaf, ...]


class Shapes:
    """Numbers for shapes of expressions; `parts` tells what number i is made of: an operation and shapes, or a leaf."""

    def __init__(self, listing: Listing) -> None:
        self._listing = listing
        self._number: dict[tuple[object, ...], int] = {}
        self.parts: list[tuple[object, ...]] = []
        self._position = {s.node: index for index, s in enumerate(listing.statements) if s.is_variable}

    def of(self, statement: Statement) -> Shaped:
        """Shape of what a statement does; a store has its target as the last leaf."""
        if statement.gather is not None:
            return Shaped(self._numbered("gather", statement.gather), ())
        if statement.store is None:
            shape, leaves = self._operation(statement.node)
            return Shaped(shape, tuple(leaves))
        shape, leaves = self._expression(statement.node)
        target = statement.store.target
        return Shaped(self._numbered("store", target.array, shape), (*leaves, target))

    def _expression(self, node: int) -> tuple[int, list[Leaf]]:
        graph = self._listing.graph
        place = self._listing.given.get(node)
        if place is None and graph.op[node] is Op.SYMBOL:
            place = Place(ARGUMENT_NAMES[graph.group(node)], graph.b[node])
        if place is not None:
            return self._numbered("place", place.array), [place]
        if graph.op[node] is Op.CONSTANT:
            return self._numbered("constant"), [graph.value[node]]
        index = self._position.get(node)
        if index is not None:
            return self._numbered("variable"), [index]
        return self._operation(node)

    def _operation(self, node: int) -> tuple[int, list[Leaf]]:
        """Arguments of sums and products stand in the order of their shapes: both orders give the same bits."""
        graph = self._listing.graph
        arguments = [self._expression(argument) for argument in graph.arguments(node)]
        if graph.op[node] in (Op.ADD, Op.MULTIPLY):
            arguments.sort(key=lambda argument: argument[0])
        shape = self._numbered(graph.op[node], *(argument[0] for argument in arguments))
        return shape, [leaf for argument in arguments for leaf in argument[1]]

    def _numbered(self, *parts: object) -> int:
        number = self._number.get(parts)
        if number is None:
            number = self._number[parts] = len(self.parts)
            self.parts.append(parts)
        return number
