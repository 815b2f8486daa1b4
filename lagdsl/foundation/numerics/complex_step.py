"""Functions of complex numbers next to the real line, for derivatives by a complex step: of one number, or of an array
of numbers, entry by entry. Outside their domain, where cmath would go on into the complex plane, they are nan.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Complexes: TypeAlias = NDArray[np.complex128]
Number: TypeAlias = "complex | Complexes"

NAN = complex(math.nan)


def truth(value: Any) -> Number:
    """1 for true and 0 for false, of a bool or of an array of them."""
    return value.astype(np.complex128) if isinstance(value, np.ndarray) else 1 + 0j if value else 0j


def compared(operator: str, left: Number, right: Number) -> Number:
    """The truth of a relation, or of truths combined by `and` or `or`."""
    return truth(_RELATIONS[operator](left.real, right.real))


def chosen(condition: Number, then: Number, otherwise: Number) -> Number:
    """`then` where the condition is true; the last axis of a vector is that of the condition."""
    if isinstance(condition, np.ndarray):
        return np.asarray(np.where(condition.real != 0.0, then, otherwise))
    return then if condition.real != 0.0 else otherwise


def divided(left: Number, right: Number) -> Number:
    if isinstance(right, np.ndarray):
        return np.asarray(np.where(right != 0.0, left / right, NAN))
    return left / right if right != 0 else left * NAN


def power(base: Number, exponent: Number) -> Number:
    if not isinstance(exponent, np.ndarray) and exponent.imag == 0.0 and _is_small_integer(exponent.real):
        return _computed(lambda: base ** int(exponent.real))
    if isinstance(base, np.ndarray) or isinstance(exponent, np.ndarray):
        return np.asarray(np.where(np.asarray(base).real >= 0.0, base**exponent, NAN))
    return _computed(lambda: base**exponent) if base.real >= 0.0 else NAN


def _is_small_integer(value: float) -> bool:
    return math.isfinite(value) and value == int(value) and abs(value) <= 1024


def applied(name: str, arguments: list[Number]) -> Number:
    """The value of a function of the language."""
    if any(isinstance(argument, np.ndarray) for argument in arguments):
        return np.asarray(_OF_ARRAYS[name](*map(np.asarray, arguments)), dtype=np.complex128)
    return _computed(lambda: complex(_OF_NUMBERS[name](*arguments)))


def _computed(value: Callable[[], Number]) -> Number:
    try:
        return value()
    except (ArithmeticError, ValueError):
        return NAN


_RELATIONS: dict[str, Callable[[Any, Any], Any]] = {
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
    "==": lambda a, b: a == b,
    "<>": lambda a, b: a != b,
    "and": lambda a, b: (a != 0.0) & (b != 0.0),
    "or": lambda a, b: (a != 0.0) | (b != 0.0),
}


def _atan2(y: complex, x: complex) -> complex:
    squared = x.real**2 + y.real**2
    return complex(math.atan2(y.real, x.real), (x.real * y.imag - y.real * x.imag) / squared if squared else 0.0)


def _atan2_of_arrays(y: Complexes, x: Complexes) -> Complexes:
    squared = x.real**2 + y.real**2
    slope = np.where(squared > 0.0, (x.real * y.imag - y.real * x.imag) / squared, 0.0)
    return np.asarray(np.arctan2(y.real, x.real) + 1j * slope)


def _on(low: float, high: float, function: Callable[[complex], complex]) -> Callable[[complex], complex]:
    return lambda x: function(x) if low <= x.real <= high else NAN


def _on_arrays(low: float, high: float, function: Callable[[Complexes], Complexes]) -> Callable[[Complexes], Complexes]:
    return lambda x: np.where((low <= x.real) & (x.real <= high), function(x), NAN)


_OF_NUMBERS: dict[str, Callable[..., complex]] = {
    "sin": cmath.sin,
    "cos": cmath.cos,
    "tan": cmath.tan,
    "asin": _on(-1.0, 1.0, cmath.asin),
    "acos": _on(-1.0, 1.0, cmath.acos),
    "atan": cmath.atan,
    "atan2": _atan2,
    "sinh": cmath.sinh,
    "cosh": cmath.cosh,
    "tanh": cmath.tanh,
    "exp": cmath.exp,
    "log": _on(0.0, math.inf, cmath.log),
    "sqrt": _on(0.0, math.inf, cmath.sqrt),
    "abs": lambda x: -x if x.real < 0.0 else x,
    "sign": lambda x: complex((x.real > 0.0) - (x.real < 0.0)),
    "floor": lambda x: complex(math.floor(x.real)),
    "ceil": lambda x: complex(math.ceil(x.real)),
    "mod": lambda x, y: x - y * math.floor(x.real / y.real),
    "min": lambda x, y: x if x.real <= y.real else y,
    "max": lambda x, y: x if x.real >= y.real else y,
}

_OF_ARRAYS: dict[str, Callable[..., Any]] = {
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "asin": _on_arrays(-1.0, 1.0, np.arcsin),
    "acos": _on_arrays(-1.0, 1.0, np.arccos),
    "atan": np.arctan,
    "atan2": _atan2_of_arrays,
    "sinh": np.sinh,
    "cosh": np.cosh,
    "tanh": np.tanh,
    "exp": np.exp,
    "log": _on_arrays(0.0, math.inf, np.log),
    "sqrt": _on_arrays(0.0, math.inf, np.sqrt),
    "abs": lambda x: np.where(x.real < 0.0, -x, x),
    "sign": lambda x: np.sign(x.real),
    "floor": lambda x: np.floor(x.real),
    "ceil": lambda x: np.ceil(x.real),
    "mod": lambda x, y: x - y * np.floor(x.real / y.real),
    "min": lambda x, y: np.where(x.real <= y.real, x, y),
    "max": lambda x, y: np.where(x.real >= y.real, x, y),
}
