"""Evaluation of an operation on plain numbers."""

import math
from collections.abc import Callable

from lagdsl.algebra.graph.operation import Op


def _sign(x: float) -> float:
    return float((x > 0) - (x < 0))


def _modulo(x: float, y: float) -> float:
    """Modelica's mod: x - floor(x/y)*y, with the sign of y."""
    return x - math.floor(x / y) * y


SCALAR: dict[Op, Callable[..., float]] = {
    Op.NEGATE: lambda x: -x,
    Op.SIN: math.sin,
    Op.COS: math.cos,
    Op.TAN: math.tan,
    Op.ASIN: math.asin,
    Op.ACOS: math.acos,
    Op.ATAN: math.atan,
    Op.SINH: math.sinh,
    Op.COSH: math.cosh,
    Op.TANH: math.tanh,
    Op.EXP: math.exp,
    Op.LOG: math.log,
    Op.SQRT: math.sqrt,
    Op.ABS: abs,
    Op.SIGN: _sign,
    Op.FLOOR: lambda x: float(math.floor(x)),
    Op.CEIL: lambda x: float(math.ceil(x)),
    Op.NOT: lambda x: float(x == 0.0),
    Op.ADD: lambda x, y: x + y,
    Op.SUBTRACT: lambda x, y: x - y,
    Op.MULTIPLY: lambda x, y: x * y,
    Op.DIVIDE: lambda x, y: x / y,
    Op.POWER: math.pow,
    Op.ATAN2: math.atan2,
    Op.MOD: _modulo,
    Op.MIN: min,
    Op.MAX: max,
    Op.LESS: lambda x, y: float(x < y),
    Op.LESS_EQUAL: lambda x, y: float(x <= y),
    Op.EQUAL: lambda x, y: float(x == y),
    Op.AND: lambda x, y: float(x != 0.0 and y != 0.0),
    Op.OR: lambda x, y: float(x != 0.0 or y != 0.0),
}


def fold(op: Op, *arguments: float) -> float | None:
    """The value of `op`, or None where it is not a finite number (the node is kept, and fails at run time)."""
    try:
        result = SCALAR[op](*arguments)
    except (ValueError, ArithmeticError):
        return None
    infinite = any(math.isinf(x) for x in arguments) and not math.isnan(result)
    return result if infinite or math.isfinite(result) else None
