"""Operations on floats, arrays, complex numbers and numbers of any precision."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from lagdsl.algebra.graph.operation import ELEMENTARY_NAMES, Op

Value = Any  # np.float64, array of float or complex, or mpmath.mpf: whatever the table below computes with
Table = dict[Op, Callable[..., Value]]


def _real(x: Value) -> Value:
    return np.real(x)


def _absolute(x: Value) -> Value:
    """|x| that a complex step passes through: the sign is that of the real part."""
    return _choose(_real(x) < 0, -x, x) if np.iscomplexobj(x) else np.abs(x)


def _atan2(y: Value, x: Value) -> Value:
    """The angle; for complex arguments exact to first order in the imaginary parts, as a complex step needs."""
    angle = np.arctan2(_real(y), _real(x))
    if not (np.iscomplexobj(x) or np.iscomplexobj(y)):
        return angle
    square = _real(x) ** 2 + _real(y) ** 2
    return angle + 1j * (_real(x) * np.imag(y) - _real(y) * np.imag(x)) / square


def _truth(condition: Value) -> Value:
    return np.asarray(condition, dtype=np.float64)[()]


def _choose(condition: Value, value: Value, otherwise: Value) -> Value:
    chosen: Value = np.where(condition, value, otherwise)
    return chosen[()]


NUMPY: Table = {
    Op.NEGATE: np.negative,
    Op.SIN: np.sin,
    Op.COS: np.cos,
    Op.TAN: np.tan,
    Op.ASIN: np.arcsin,
    Op.ACOS: np.arccos,
    Op.ATAN: np.arctan,
    Op.SINH: np.sinh,
    Op.COSH: np.cosh,
    Op.TANH: np.tanh,
    Op.EXP: np.exp,
    Op.LOG: np.log,
    Op.SQRT: np.sqrt,
    Op.ABS: _absolute,
    Op.SIGN: lambda x: np.sign(_real(x)),
    Op.FLOOR: lambda x: np.floor(_real(x)),
    Op.CEIL: lambda x: np.ceil(_real(x)),
    Op.NOT: lambda x: _truth(x == 0),
    Op.ADD: np.add,
    Op.SUBTRACT: np.subtract,
    Op.MULTIPLY: np.multiply,
    Op.DIVIDE: np.divide,
    Op.POWER: np.power,
    Op.ATAN2: _atan2,
    Op.MOD: lambda x, y: x - np.floor(_real(x / y)) * y,
    Op.MIN: lambda x, y: _choose(_real(x) <= _real(y), x, y),
    Op.MAX: lambda x, y: _choose(_real(x) >= _real(y), x, y),
    Op.LESS: lambda x, y: _truth(_real(x) < _real(y)),
    Op.LESS_EQUAL: lambda x, y: _truth(_real(x) <= _real(y)),
    Op.EQUAL: lambda x, y: _truth(_real(x) == _real(y)),
    Op.AND: lambda x, y: _truth((x != 0) & (y != 0)),
    Op.OR: lambda x, y: _truth((x != 0) | (y != 0)),
    Op.SELECT: lambda condition, value, otherwise: _choose(condition != 0, value, otherwise),
}


def precise() -> Table:
    """The same on mpmath numbers, at mpmath's working precision."""
    import mpmath  # type: ignore[import-untyped]

    return {op: getattr(mpmath, name) for op, name in ELEMENTARY_NAMES.items()} | {
        Op.SIGN: mpmath.sign,
        Op.NEGATE: lambda x: -x,
        Op.ABS: abs,
        Op.NOT: lambda x: mpmath.mpf(x == 0),
        Op.ADD: lambda x, y: x + y,
        Op.SUBTRACT: lambda x, y: x - y,
        Op.MULTIPLY: lambda x, y: x * y,
        Op.DIVIDE: lambda x, y: x / y,
        Op.POWER: lambda x, y: x**y,
        Op.MOD: lambda x, y: x - mpmath.floor(x / y) * y,
        Op.MIN: min,
        Op.MAX: max,
        Op.LESS: lambda x, y: mpmath.mpf(x < y),
        Op.LESS_EQUAL: lambda x, y: mpmath.mpf(x <= y),
        Op.EQUAL: lambda x, y: mpmath.mpf(x == y),
        Op.AND: lambda x, y: mpmath.mpf(x != 0 and y != 0),
        Op.OR: lambda x, y: mpmath.mpf(x != 0 or y != 0),
        Op.SELECT: lambda condition, value, otherwise: value if condition != 0 else otherwise,
    }
