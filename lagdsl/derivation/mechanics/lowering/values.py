"""Nodes of the graph that expressions of one model became, by identity."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias, cast

from lagdsl.derivation.mechanics.kinematics.vectors import Vector
from lagdsl.language.flat.expression import FlatExpression

Value: TypeAlias = "int | Vector"


class Values:
    """A node for a scalar, three for a vector: `by_identity` of the expressions. These are kept: another one never has
    the identity of one."""

    def __init__(self) -> None:
        self.by_identity: dict[int, Value] = {}
        self._kept: list[FlatExpression] = []

    def __contains__(self, expression: FlatExpression) -> bool:
        return id(expression) in self.by_identity

    def __getitem__(self, expression: FlatExpression) -> Value:
        return self.by_identity[id(expression)]

    def __setitem__(self, expression: FlatExpression, value: Value) -> None:
        self._kept.append(expression)
        self.by_identity[id(expression)] = value

    def node(self, expression: FlatExpression) -> int:
        return cast(int, self.by_identity[id(expression)])

    def triple(self, expression: FlatExpression) -> Vector:
        return cast(Vector, self.by_identity[id(expression)])

    def replace(self, nodes: Mapping[int, int]) -> None:
        """Nodes to be others in all values so far, and so in what is made of them later."""
        for key, value in self.by_identity.items() if nodes else ():
            if isinstance(value, int):
                self.by_identity[key] = nodes.get(value, value)
            else:
                x, y, z = (nodes.get(component, component) for component in value)
                self.by_identity[key] = (x, y, z)
