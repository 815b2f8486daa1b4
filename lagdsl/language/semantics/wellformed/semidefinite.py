"""Expressions that are positive semidefinite by their form: sums of squares, with factors that are not negative."""

from __future__ import annotations

from typing import assert_never

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.traversal import postorder

_FUNCTIONS = frozenset({"abs", "sqrt", "exp", "cosh"})


class Semidefinite:
    """Answers for one flat model, with the defaults of its parameters; shared nodes are looked at once."""

    def __init__(self, flat: fm.FlatModel) -> None:
        self._parameters = {parameter.name: parameter.value >= 0.0 for parameter in flat.parameters}
        self._definitions = {item.name: item.value for item in flat.named if isinstance(item, fm.Definition)}
        self._known: dict[int, tuple[fx.FlatExpression, bool]] = {}

    def of(self, expression: fx.FlatExpression) -> bool:
        """True if a scalar is at least zero wherever it is defined; False where the form does not show it."""
        known = self._known
        if id(expression) not in known:
            for node in postorder(expression, known):
                known[id(node)] = node, self._compute(node)
        return known[id(expression)][1]

    def _compute(self, expression: fx.FlatExpression) -> bool:
        match expression:
            case fx.Binary(operator, left, right):
                return self._binary(operator, left, right)
            case fx.Number(value):
                return value >= 0.0
            case fx.Variable(name):
                if name in self._definitions:
                    return self.of(self._definitions[name])
                return self._parameters.get(name, False)
            case fx.Function(name, _):
                return name in _FUNCTIONS
            case fx.Conditional(_, value, otherwise):
                return self.of(value) and self.of(otherwise)
            case fx.Dot(left, right):
                return left == right
            case fx.Norm():
                return True
            case fx.Unary() | fx.Component() | fx.Vector() | fx.Cross() | fx.PointReference() | fx.OfFrame():
                return False
            case fx.Operation() | fx.Previous() | fx.Derivative() | fx.Mechanical() | fx.OfMechanism():
                return False
            case _:
                assert_never(expression)

    def _product(self, left: fx.FlatExpression, right: fx.FlatExpression) -> bool:
        """True for `m*x*x`, too, which is `(m*x)*x`."""
        if isinstance(left, fx.Binary) and left.operator == "*" and left.right == right and self.of(left.left):
            return True
        return (self.of(left) and self.of(right)) or left == right

    def _binary(self, operator: fx.BinaryOperator, left: fx.FlatExpression, right: fx.FlatExpression) -> bool:
        match operator:
            case "+" | "/":
                return self.of(left) and self.of(right)
            case "*":
                return self._product(left, right)
            case "^":
                return self.of(left) or (isinstance(right, fx.Number) and right.value % 2.0 == 0.0)
            case "-":
                return False
            case "<" | "<=" | ">" | ">=" | "==" | "<>" | "and" | "or":
                return True
            case _:
                assert_never(operator)
