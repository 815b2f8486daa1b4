"""Inputs of a simulation as functions of time: constants, functions, tables; and the times at which they are not
smooth."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias, cast

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.diagnostics.suggest import nearest
from lagdsl.flat.model import FlatModel, Input
from lagdsl.mechanics.rank import Floats

# A pair is (times, values), or an array of these two rows, straight lines between them. Two equal times are a jump.
Signal: TypeAlias = "float | Callable[[float], float] | tuple[Sequence[float], Sequence[float]] | Floats"
# (t, before) -> value; `before` asks for the limit from the left.
_Function: TypeAlias = Callable[[float, bool], float]


_NONE = np.zeros(0)
_KINDS = "a number, a function of time or a pair (times, values)"


@dataclass(frozen=True, slots=True)
class Signals:
    """The input vector at any time; `breaks` are the times at which a step must end."""

    functions: tuple[_Function, ...]
    breaks: tuple[float, ...]

    @property
    def constant(self) -> bool:
        """Whether no input changes."""
        return all(isinstance(function, _Constant) for function in self.functions)

    def at(self, t: float, *, before: bool = False) -> Floats:
        """u (nu,); at a jump the value after it, or before it."""
        return np.array([function(t, before) for function in self.functions]) if self.functions else _NONE


def steady(values: Floats) -> Signals:
    """Inputs that keep their values."""
    return Signals(tuple(_Constant(value) for value in values.tolist()), ())


def signals(
    flat: FlatModel, defaults: Floats, inputs: Mapping[str, Signal], span: tuple[float, float], sink: Sink
) -> Signals:
    """Every input of the model: given ones, derivatives of given tables and constants, defaults.

    Errors go to `sink`: unknown names (E0819), a table that does not cover `span` (E0817), a function whose
    derivative the model needs and nobody gave (E0818). Raises ValueError for what is no signal at all.
    """
    names = [item.name for item in flat.inputs]
    for name in inputs:
        if name not in names:
            likely = nearest(name, names)
            help = f"did you mean `{likely}`?" if likely else None
            sink.report("E0819", None, help=help, name=name, known=", ".join(names) or "none")
    functions: list[_Function] = []
    breaks: set[float] = set()
    for item, default in zip(flat.inputs, defaults.tolist(), strict=True):
        base, order = _base(item.name)
        if item.name in inputs:
            smooth = item.smooth > 0 and f"der({item.name})" not in inputs
            functions.append(_function(item, inputs[item.name], 0, smooth, span, breaks, sink))
        elif order and base in inputs:
            functions.append(_function(item, inputs[base], order, True, span, breaks, sink))
        else:
            functions.append(_Constant(default))
    return Signals(tuple(functions), tuple(sorted(b for b in breaks if span[0] < b < span[1])))


def _base(name: str) -> tuple[str, int]:
    """`der(der(road))` is (`road`, 2)."""
    order = 0
    while name.startswith("der(") and name.endswith(")"):
        name, order = name[4:-1], order + 1
    return name, order


def _function(
    item: Input, signal: Signal, order: int, smooth: bool, span: tuple[float, float], breaks: set[float], sink: Sink
) -> _Function:
    """The derivative of the given order of one signal."""
    if callable(signal):
        given = signal
        if order:
            sink.report("E0818", item.spans[0] if item.spans else None, name=_base(item.name)[0], derivative=item.name)
        return lambda t, before: float(given(t))
    if isinstance(signal, (tuple, list)) or np.ndim(signal) > 0:
        times, values = _columns(item.name, signal, smooth)
        if times[0] > span[0] or times[-1] < span[1]:
            sink.report(
                "E0817", None, name=_base(item.name)[0], first=times[0], last=times[-1], start=span[0], stop=span[1]
            )
            return _Constant(0.0)
        if smooth:
            return _spline(times, values, order)
        breaks.update(_kinks(times, values))
        return _lines(times.tolist(), values.tolist())
    try:
        constant = float(cast(float, signal))
    except (TypeError, ValueError) as error:
        raise ValueError(f"input `{item.name}` must be {_KINDS}") from error
    return _Constant(constant if order == 0 else 0.0)


def _columns(name: str, signal: Any, smooth: bool) -> tuple[Floats, Floats]:
    """Times and values of a table. Raises ValueError where it is none."""
    try:
        times, values = (np.asarray(column, dtype=np.float64) for column in signal)
    except (TypeError, ValueError) as error:
        raise ValueError(f"input `{name}` must be {_KINDS}") from error
    if times.ndim != 1 or times.shape != values.shape or len(times) < 2:
        raise ValueError(
            f"the table of input `{name}` needs as many values as times, two at least; "
            f"their shapes are {times.shape} and {values.shape}"
        )
    if not (np.isfinite(times).all() and np.isfinite(values).all()):
        raise ValueError(f"the table of input `{name}` holds entries that are not numbers")
    steps = np.diff(times)
    if (steps < 0.0).any():
        raise ValueError(f"time runs backward in the table of input `{name}`")
    if smooth and (steps == 0.0).any():
        raise ValueError(f"the table of input `{name}` jumps, and the model needs its derivative")
    return times, values


@dataclass(frozen=True, slots=True)
class _Constant:
    value: float

    def __call__(self, t: float, before: bool) -> float:
        return self.value


def _lines(times: list[float], values: list[float]) -> _Function:
    """Straight lines between the points; at equal times a jump."""

    def value(t: float, before: bool) -> float:
        index = (bisect_left if before else bisect_right)(times, t)
        index = min(max(index, 1), len(times) - 1)
        t0, t1 = times[index - 1], times[index]
        part = (t - t0) / (t1 - t0) if t1 > t0 else 1.0
        return values[index - 1] + part * (values[index] - values[index - 1])

    return value


def _spline(times: Floats, values: Floats, order: int) -> _Function:
    """A cubic spline, where the model needs derivatives of the signal."""
    from scipy.interpolate import CubicSpline

    curve: Any = CubicSpline(times, values).derivative(order) if order else CubicSpline(times, values)
    return lambda t, before: float(curve(t))


def _kinks(times: Floats, values: Floats) -> list[float]:
    """Times at which the value jumps or the slope changes."""
    spans = np.diff(times)
    jump = spans <= 0.0
    slopes = np.diff(values) / np.where(jump, 1.0, spans)
    size = float(np.max(np.abs(slopes), initial=0.0))
    changed = np.abs(np.diff(slopes)) > 1e-9 * size
    return [float(t) for t in times[1:-1][changed | jump[1:] | jump[:-1]]]
