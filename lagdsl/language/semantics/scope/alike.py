"""Sums, products and powers whose operands are of the same types as those of the same text before.

The text of a loop stands in every turn, that of a class in every instance. It is checked where it is met first: types
and units of its operands decide what is told of it, and the type of its value.
"""

from __future__ import annotations

from dataclasses import field

from lagdsl.foundation.record import mutable_record, record
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.scope.values import AnyDimension, Kind, Order, Scalar, Value, is_structural
from lagdsl.language.syntax import nodes


@record()
class Type:
    """Of a scalar; with the class of its expression, and the number that is known."""

    dimension: AnyDimension
    variability: Variability
    order: Order
    kind: Kind
    form: type
    number: float | None

    def has(self, value: Value) -> bool:
        if not isinstance(value, Scalar) or value.is_nothing or type(value.expression) is not self.form:
            return False
        if value.variability is not self.variability or value.order is not self.order or value.kind != self.kind:
            return False
        if isinstance(value.expression, flat.Number) and value.expression.value != self.number:
            return False
        return value.dimension is self.dimension or value.dimension == self.dimension


@record()
class Known:
    """An operation on operands of these types; its node is kept, so that no other one gets its identity."""

    node: nodes.Binary
    operator: flat.BinaryOperator
    left: Type
    right: Type
    result: Type

    def value(self, left: Value, right: Value) -> Scalar | None:
        """None for operands of other types."""
        if not self.left.has(left) or not self.right.has(right):
            return None
        assert isinstance(left, Scalar) and isinstance(right, Scalar)
        result = self.result
        expression = flat.Binary(self.operator, left.expression, right.expression)
        return Scalar(expression, result.dimension, result.variability, result.order, result.kind)


@mutable_record()
class Alike:
    """The answers met last, by identity of the node."""

    _known: dict[int, Known] = field(default_factory=dict)

    def of(self, node: nodes.Binary) -> Known | None:
        return self._known.get(id(node))

    def keep(self, node: nodes.Binary, left: Value, right: Value, value: Value) -> None:
        """`value` is what the checks of `node` gave without a word; kept where the types alone led to it."""
        if not (isinstance(left, Scalar) and isinstance(right, Scalar) and isinstance(value, Scalar)):
            return
        made = value.expression
        if not isinstance(made, flat.Binary) or made.left is not left.expression or made.right is not right.expression:
            return
        if follows(made.operator, left, right, value):
            self._known[id(node)] = Known(node, made.operator, *map(type_of, (left, right, value)))


_OPERATORS = frozenset(("+", "-", "*", "/", "^"))


def follows(operator: str, left: Scalar, right: Scalar, value: Scalar) -> bool:
    """True if operands of the same types have a value of the same type, whatever they are."""
    integers = left.kind == right.kind == "Integer" and is_structural(value)  # a number, if there is one
    power = operator == "^" and not isinstance(right.expression, flat.Number)
    return operator in _OPERATORS and not (integers or power)


def type_of(value: Scalar) -> Type:
    number = value.expression.value if isinstance(value.expression, flat.Number) else None
    return Type(value.dimension, value.variability, value.order, value.kind, type(value.expression), number)
