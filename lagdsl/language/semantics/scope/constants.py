"""Values that are known while compiling: evaluation of closed flat expressions."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import assert_never

from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.values import Scalar, Value, is_structural
from lagdsl.language.syntax import nodes


class NoValue(ArithmeticError):  # noqa: N818 named after what it says
    """The expression has no finite value."""


BINARY: dict[str, Callable[[float, float], float]] = {
    "+": lambda x, y: x + y,
    "-": lambda x, y: x - y,
    "*": lambda x, y: x * y,
    "/": lambda x, y: x / y,
    "^": math.pow,
    "<": lambda x, y: float(x < y),
    "<=": lambda x, y: float(x <= y),
    ">": lambda x, y: float(x > y),
    ">=": lambda x, y: float(x >= y),
    "==": lambda x, y: float(x == y),
    "<>": lambda x, y: float(x != y),
    "and": lambda x, y: float(x != 0 and y != 0),
    "or": lambda x, y: float(x != 0 or y != 0),
}

FUNCTIONS: dict[str, Callable[..., float]] = {
    "abs": abs,
    "sign": lambda x: float((x > 0) - (x < 0)),
    "floor": lambda x: float(math.floor(x)),
    "ceil": lambda x: float(math.ceil(x)),
    "mod": lambda x, y: x - math.floor(x / y) * y,
    "min": min,
    "max": max,
}


def evaluate(expression: FlatExpression) -> float:
    """The value of an expression of numbers; raises NoValue where there is none."""
    try:
        value = expression.value if isinstance(expression, flat.Number) else _Evaluation().scalar(expression)
    except ZeroDivisionError:
        raise NoValue("division by zero") from None
    except OverflowError:
        raise NoValue("the number is too large") from None
    except ValueError:
        raise NoValue("outside the domain of the function") from None
    if math.isnan(value):
        raise NoValue("not a number")
    return value


class _Evaluation:
    """Shared parts are evaluated once: an expanded function may hold its argument many times."""

    def __init__(self) -> None:
        self.known: dict[int, float] = {}

    def scalar(self, expression: FlatExpression) -> float:
        found = self.known.get(id(expression))
        if found is None:
            found = self.known[id(expression)] = self._scalar(expression)
        return found

    def _scalar(self, expression: FlatExpression) -> float:
        match expression:
            case flat.Number(value):
                return value
            case flat.Unary(operator, operand):
                value = self.scalar(operand)
                return -value if operator == "-" else float(value == 0)
            case flat.Binary(operator, left, right):
                return BINARY[operator](self.scalar(left), self.scalar(right))
            case flat.Function(name, arguments):
                function = FUNCTIONS.get(name) or getattr(math, name)
                return float(function(*(self.scalar(argument) for argument in arguments)))
            case flat.Conditional(condition, value, otherwise):
                return self.scalar(value if self.scalar(condition) != 0 else otherwise)
            case flat.Norm(vector, _):
                return math.hypot(*self.vector(vector))
            case flat.Dot(left, right):
                return sum(x * y for x, y in zip(self.vector(left), self.vector(right), strict=True))
            case flat.Component(vector, axis):
                return self.vector(vector)[axis]
            case flat.Variable() | flat.Previous() | flat.Derivative() | flat.Mechanical() | flat.OfMechanism():
                raise NoValue("not known while compiling")
            case flat.Vector() | flat.Cross() | flat.PointReference() | flat.OfFrame():
                raise NoValue("not known while compiling")
            case _:
                assert_never(expression)

    def vector(self, expression: FlatExpression) -> tuple[float, float, float]:
        if isinstance(expression, flat.Vector):
            return self.scalar(expression.x), self.scalar(expression.y), self.scalar(expression.z)
        if isinstance(expression, flat.Unary):
            a, b, c = self.vector(expression.operand)
            return -a, -b, -c
        if isinstance(expression, flat.Cross):
            (a, b, c), (d, e, f) = self.vector(expression.left), self.vector(expression.right)
            return b * f - c * e, c * d - a * f, a * e - b * d
        if isinstance(expression, flat.Binary):
            return self._vector_binary(expression.operator, expression.left, expression.right)
        raise NoValue("not known while compiling")

    def _vector_binary(
        self, operator: flat.BinaryOperator, left: FlatExpression, right: FlatExpression
    ) -> tuple[float, float, float]:
        match operator:
            case "*":
                k = self.scalar(left)
                a, b, c = self.vector(right)
                return k * a, k * b, k * c
            case "/":
                k = self.scalar(right)
                a, b, c = self.vector(left)
                return a / k, b / k, c / k
            case "+" | "-":
                sign = 1.0 if operator == "+" else -1.0
                (a, b, c), (d, e, f) = self.vector(left), self.vector(right)
                return a + sign * d, b + sign * e, c + sign * f
            case "^" | "<" | "<=" | ">" | ">=" | "==" | "<>" | "and" | "or":
                raise AssertionError(f"`{operator}` gives no vector")
            case _:
                assert_never(operator)


def structural_number(ctx: Context, value: Value, node: nodes.Node, code: str, **words: object) -> float | None:
    """The number that a structural scalar is, or None after `code` (not structural) or E0312, E0323."""
    if not isinstance(value, Scalar):
        if kind_of(value) != "nothing":
            ctx.sink.report("E0312", node.span, expected="a number", found=kind_of(value))
        return None
    if not is_structural(value):
        kind = "is a parameter" if value.variability == Variability.PARAMETER else "varies in time"
        words.setdefault("kind", kind)
        ctx.sink.report(code, node.span, help=None, edit=None, notes=(), **words)
        return None
    try:
        return evaluate(value.expression)
    except NoValue as fault:
        ctx.sink.report("E0323", node.span, reason=str(fault))
        return None


def structural_integer(ctx: Context, value: Value, node: nodes.Node, code: str, **words: object) -> int | None:
    number = structural_number(ctx, value, node, code, **words)
    if number is None or not isinstance(value, Scalar):
        return None
    if value.kind == "Boolean" or not (value.dimension is None or value.dimension == DIMENSIONLESS):
        ctx.sink.report("E0312", node.span, expected="an Integer", found=kind_of(value))
        return None
    if not math.isfinite(number) or number != int(number):
        ctx.sink.report("E0312", node.span, expected="an Integer", found=f"{number:g}")
        return None
    return int(number)
