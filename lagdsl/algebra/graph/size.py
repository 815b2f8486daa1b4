"""Propagation of rounding errors from arguments, measured by their sizes, to a result: one rule per operation."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.algebra.graph.arithmetic import Value
from lagdsl.algebra.graph.operation import Op

Sized = tuple[Value, Value]  # value, size of its terms
Rule = Callable[..., Value]


def _slope(derivative: Callable[[Value, Value], Value]) -> Rule:
    """|f'(x)| size(x), with f' of the argument and of the value itself."""
    return lambda value, x: np.abs(derivative(x[0], value)) * x[1]


def _quotient(value: Value, x: Sized, y: Sized) -> Value:
    divisor = np.abs(y[0])
    return x[1] / divisor * (y[1] / divisor)


def _power(value: Value, x: Sized, y: Sized) -> Value:
    base = np.where(x[0] == 0, 1.0, x[0])
    through_base = np.abs(value * y[0] / base) * x[1]
    through_exponent = np.abs(value * np.log(np.abs(base))) * y[1]
    return through_base + through_exponent


def _angle(value: Value, y: Sized, x: Sized) -> Value:
    square = x[0] ** 2 + y[0] ** 2
    return (np.abs(x[0]) * y[1] + np.abs(y[0]) * x[1]) / square


def _same(value: Value, *arguments: Sized) -> Value:
    return np.abs(value)


SIZES: dict[Op, Rule] = {
    **dict.fromkeys(Op, _same),
    Op.NEGATE: lambda value, x: x[1],
    Op.SIN: _slope(lambda x, value: np.cos(x)),
    Op.COS: _slope(lambda x, value: np.sin(x)),
    Op.TAN: _slope(lambda x, value: 1.0 + value**2),
    Op.ASIN: _slope(lambda x, value: 1.0 / np.cos(value)),
    Op.ACOS: _slope(lambda x, value: 1.0 / np.sin(value)),
    Op.ATAN: _slope(lambda x, value: 1.0 / (1.0 + x**2)),
    Op.SINH: _slope(lambda x, value: np.cosh(x)),
    Op.COSH: _slope(lambda x, value: np.sinh(x)),
    Op.TANH: _slope(lambda x, value: 1.0 - value**2),
    Op.EXP: _slope(lambda x, value: value),
    Op.LOG: _slope(lambda x, value: 1.0 / x),
    Op.SQRT: lambda value, x: np.where(value == 0, np.sqrt(x[1]), x[1] / np.where(value == 0, 1.0, value)),
    Op.ABS: lambda value, x: x[1],
    Op.ADD: lambda value, x, y: x[1] + y[1],
    Op.SUBTRACT: lambda value, x, y: x[1] + y[1],
    Op.MULTIPLY: lambda value, x, y: x[1] * y[1],
    Op.DIVIDE: _quotient,
    Op.POWER: _power,
    Op.ATAN2: _angle,
    Op.MOD: lambda value, x, y: x[1] + y[1],
    Op.MIN: lambda value, x, y: np.maximum(x[1], y[1]),
    Op.MAX: lambda value, x, y: np.maximum(x[1], y[1]),
    Op.SELECT: lambda value, condition, x, y: np.where(condition[0] != 0, x[1], y[1]),
}
