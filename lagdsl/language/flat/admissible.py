"""Admissible values of parameters, start values and inputs."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.model import Coordinate, Input, Parameter, State
from lagdsl.language.flat.spans import around, place

Bounded: TypeAlias = Coordinate | State | Input

# Whole numbers below this size are exact, and each is read as itself.
EXACT_INTEGERS = 2.0**53


def require_value(parameter: Parameter, value: float) -> None:
    """Raise ValueError where `value`, in SI units, is none that the parameter may have."""
    name, unit = parameter.name, "" if parameter.unit in ("", "1") else f" {parameter.unit}"
    if parameter.kind == "Integer" and not value.is_integer():
        raise ValueError(f"`{name}` is a whole number, not {value:g}")
    if parameter.kind == "Integer" and abs(value) >= EXACT_INTEGERS:
        raise ValueError(f"`{name}` is exact up to 2^53 - 1 = 9007199254740991, not at {value:.17g}")
    if parameter.kind == "Boolean" and value not in (0.0, 1.0):
        raise ValueError(f"`{name}` is true (1) or false (0), not {value:g}")
    if parameter.minimum is not None and value < parameter.minimum:
        raise ValueError(f"`{name}` must be at least {parameter.minimum:g}{unit}, not {value:g}{unit}")
    if parameter.maximum is not None and value > parameter.maximum:
        raise ValueError(f"`{name}` must be at most {parameter.maximum:g}{unit}, not {value:g}{unit}")


def certainly_allowed(parameter: Parameter, values: NDArray[np.float64]) -> NDArray[np.bool_] | bool:
    """True of those `values` (runs,) with which `require_value` raises nothing; of whole numbers and truths nothing is
    known."""
    low = -np.inf if parameter.minimum is None else parameter.minimum
    high = np.inf if parameter.maximum is None else parameter.maximum
    return parameter.kind == "Real" and (values >= low) & (values <= high)


def report_outside(item: Bounded, name: str, value: float, sink: Sink) -> None:
    """W0328 where `value`, in SI units, of what is called `name` lies outside of `min` or `max`: the motion may lead
    there."""
    for word, bound, outside in (
        ("min", item.minimum, item.minimum is not None and value < item.minimum),
        ("max", item.maximum, item.maximum is not None and value > item.maximum),
    ):
        if outside and bound is not None:
            shown, limit = _shown(value, item.unit), _shown(bound, item.unit)
            sink.report("W0328", place(item), *around(item), name=name, value=shown, which=word, limit=limit)


def _shown(number: float, unit: str) -> str:
    return f"{number:g}" if unit == "1" else f"{number:g} {unit}"
