"""The degree of an expression as a polynomial in the rates: a kinetic energy has two, a velocity one."""

from __future__ import annotations

import math
from typing import assert_never

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.traversal import postorder

INFINITE = math.inf


class RateDegree:
    """Upper bounds from the structure of the text: cancellation is not seen; inf where it is no polynomial."""

    def __init__(self, dependence: Dependence) -> None:
        self.dependence = dependence
        flat = dependence.flat
        self._moving = {item.name for item in (*flat.coordinates, *flat.states, *flat.inputs)}
        self._definitions = {item.name: item for item in flat.named if isinstance(item, fm.Definition)}
        self._known: dict[int, tuple[fx.FlatExpression, float]] = {}

    def of(self, expression: fx.FlatExpression) -> float:
        """0 for an expression without rates, up to inf."""
        known = self._known
        if id(expression) not in known:
            for node in postorder(expression, known):
                known[id(node)] = (node, self._compute(node))
        return known[id(expression)][1]

    def _compute(self, expression: fx.FlatExpression) -> float:  # noqa: C901, PLR0912 one case per node
        orders = self.dependence.of(expression)
        if not any(name in self._moving for name in orders.differentiated()):
            return 0
        match expression:
            case fx.Variable(name):
                return self.of(self._definitions[name].value)
            case fx.Derivative(operand):
                return 1 if self.of(operand) == 0 else INFINITE
            case fx.AngularVelocity() | fx.MaterialVelocity():
                return 1
            case fx.Unary(operator, operand):
                return self.of(operand) if operator == "-" else INFINITE
            case fx.Binary(operator, left, right):
                return self._binary(operator, left, right)
            case fx.Conditional(condition, value, otherwise):
                return INFINITE if self.of(condition) else max(self.of(value), self.of(otherwise))
            case fx.Component(vector, _):
                return self.of(vector)
            case fx.Dot(left, right) | fx.Cross(left, right):
                return self.of(left) + self.of(right)
            case fx.Vector(x, y, z):
                return max(self.of(x), self.of(y), self.of(z))
            case fx.Number() | fx.Previous() | fx.PointReference() | fx.OfFrame() | fx.Operation():
                return INFINITE
            case fx.Mechanical() | fx.OfMechanism():
                return INFINITE
            case _:
                assert_never(expression)

    def _binary(self, operator: fx.BinaryOperator, left: fx.FlatExpression, right: fx.FlatExpression) -> float:
        match operator:
            case "+" | "-":
                return max(self.of(left), self.of(right))
            case "*":
                return self.of(left) + self.of(right)
            case "/":
                return INFINITE if self.of(right) else self.of(left)
            case "^":
                return self._power(left, right)
            case "<" | "<=" | ">" | ">=" | "==" | "<>" | "and" | "or":
                return INFINITE
            case _:
                assert_never(operator)

    def _power(self, base: fx.FlatExpression, exponent: fx.FlatExpression) -> float:
        if not isinstance(exponent, fx.Number) or exponent.value < 0 or exponent.value % 1:
            return INFINITE
        even = exponent.value % 2 == 0
        if even and isinstance(base, fx.Norm):
            return self.of(base.vector) * exponent.value
        if even and isinstance(base, fx.Function) and base.name in ("abs", "sqrt"):
            degree = self.of(base.arguments[0]) * exponent.value
            return degree if base.name == "abs" else degree / 2
        return self.of(base) * exponent.value
