"""Eigenvalues over a parameter, and the thresholds at which they cross the imaginary axis.

A threshold is bracketed by two values with different numbers of growing modes and bisected. Where eigenvalues leave
the axis by colliding on it (no damping), real parts begin as a square root, and a bound of 1e-7 of the magnitude
places the threshold to 1e-14; where they cross it with finite speed the bound is taken down to the round-off.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np

from lagdsl.analysis.eigen import Complexes, eigen
from lagdsl.analysis.linearize import Named, reduce
from lagdsl.analysis.modes import AXIS
from lagdsl.analysis.point import Point, Subject
from lagdsl.diagnostics import CompilationFailed, Sink
from lagdsl.mechanics.rank import Floats

Place: TypeAlias = Callable[[float], Point]

_ROUNDING = 1e-13
_WIDTH = 2e-13
_HALVINGS = 100


@dataclass(frozen=True, slots=True, kw_only=True)
class Threshold:
    """Where an eigenvalue crosses the imaginary axis: through zero (divergence) or as a pair (flutter).

    `eigenvalue` [1/s] is the crossing one of non-negative frequency; `unstable_above`: the side that grows.
    """

    value: float
    kind: Literal["divergence", "flutter"]
    eigenvalue: complex
    unstable_above: bool

    @property
    def frequency(self) -> float:
        """[Hz]; 0 for divergence."""
        return abs(self.eigenvalue.imag) / (2.0 * np.pi)


@dataclass(frozen=True, slots=True, kw_only=True)
class Sweep:
    """`eigenvalues` (k, n) [1/s], each column a branch, nan where there is no linearization; `unstable` (k,) numbers
    of growing modes, -1 there."""

    model: str
    varied: Named
    values: Floats
    eigenvalues: Complexes
    unstable: tuple[int, ...]
    thresholds: tuple[Threshold, ...]


def sweep(subject: Subject, varied: Named, values: Sequence[float], place: Place, held: Sequence[int]) -> Sweep:
    """Eigenvalues at `place(value)` for each value, and the thresholds between neighbors. Raises CompilationFailed
    where no value has a linearization."""
    spectrum = _Spectrum(subject, place, tuple(held))
    found = [spectrum(value) for value in values]
    if all(each is None for each in found) and len(values):
        spectrum.explain(values[0])
    counts = tuple(-1 if each is None else _growing(each, AXIS) for each in found)
    thresholds: list[Threshold] = []
    for i in range(len(values) - 1):
        if min(counts[i], counts[i + 1]) >= 0 and counts[i] != counts[i + 1]:
            thresholds += _between(spectrum, (values[i], counts[i]), (values[i + 1], counts[i + 1]))
    return Sweep(
        model=subject.flat.name,
        varied=varied,
        values=np.array(values, dtype=np.float64),
        eigenvalues=_branches(found),
        unstable=counts,
        thresholds=tuple(thresholds),
    )


@dataclass(frozen=True, slots=True)
class _Spectrum:
    """Eigenvalues as a function of the varied value; None where there is no linearization."""

    subject: Subject
    place: Place
    held: tuple[int, ...]

    def __call__(self, value: float) -> Complexes | None:
        try:
            at = reduce(self.subject, self.place(value), self.held, Sink())
        except CompilationFailed:
            return None
        return None if at is None else eigen(at.a)[0]

    def explain(self, value: float) -> None:
        """Raise what is wrong at `value`."""
        sink = Sink()
        reduce(self.subject, self.place(value), self.held, sink)
        sink.raise_if_errors()


def _growing(values: Complexes, bound: float) -> int:
    return int(np.count_nonzero(values.real > bound * np.abs(values)))


def _between(spectrum: _Spectrum, low: tuple[float, int], high: tuple[float, int]) -> list[Threshold]:
    """Thresholds between two values, from the lower on."""
    result: list[Threshold] = []
    while low[1] != high[1] and len(result) < 8:
        inner, outer = _bisect(spectrum, low, high, AXIS)
        step = 1e-5 * abs(high[0] - low[0])
        inner, outer = _sharpened(spectrum, low, inner, outer, step)
        result.append(_threshold(spectrum, inner, outer))
        low = outer
    return result


def _bisect(
    spectrum: _Spectrum, low: tuple[float, int], high: tuple[float, int], bound: float
) -> tuple[tuple[float, int], tuple[float, int]]:
    """Two values next to each other between which the count leaves that of `low`."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (low[0] + high[0])
        if abs(high[0] - low[0]) <= _WIDTH * max(abs(low[0]), abs(high[0])) or middle in (low[0], high[0]):
            break
        values = spectrum(middle)
        count = low[1] if values is None else _growing(values, bound)
        if count == low[1]:
            low = (middle, count)
        else:
            high = (middle, count)
    return low, high


def _sharpened(
    spectrum: _Spectrum, first: tuple[float, int], inner: tuple[float, int], outer: tuple[float, int], step: float
) -> tuple[tuple[float, int], tuple[float, int]]:
    """Bisect again with the bound at the round-off if real parts grow in proportion to the distance."""
    more = outer[1] > inner[1]
    sign = np.sign(outer[0] - first[0]) * (1.0 if more else -1.0)
    growth = []
    for distance in (step, 4.0 * step):
        values = spectrum(outer[0] + sign * distance)
        growth.append(0.0 if values is None else float(np.max(values.real, initial=0.0)))
    if not growth[0] > 0.0 or growth[1] < 2.8 * growth[0]:
        return inner, outer
    reach = 10.0 * step * float(np.sign(outer[0] - first[0]))
    near, far = outer[0] - reach, outer[0] + reach
    at_near, at_far = spectrum(near), spectrum(far)
    if at_near is None or at_far is None:
        return inner, outer
    low, high = (near, _growing(at_near, _ROUNDING)), (far, _growing(at_far, _ROUNDING))
    if low[1] == high[1]:
        return inner, outer
    return _bisect(spectrum, low, high, _ROUNDING)


def _threshold(spectrum: _Spectrum, inner: tuple[float, int], outer: tuple[float, int]) -> Threshold:
    value = 0.5 * (inner[0] + outer[0])
    grown = max(inner, outer, key=lambda each: each[1])
    distance = 1e-8 * max(abs(value), 1e-300) * (1.0 if grown[0] >= value else -1.0)
    values = spectrum(grown[0] + distance)
    values = spectrum(grown[0]) if values is None else values
    assert values is not None
    size = float(np.max(np.abs(values), initial=0.0))
    growing = values[values.real > 1e-12 * size]
    # of several growing modes the one that has just begun to
    crossing = complex(growing[int(np.argmin(growing.real))]) if len(growing) else 0j
    oscillates = abs(crossing.imag) > 1e-3 * abs(crossing.real) and abs(crossing.imag) > 1e-6 * size
    return Threshold(
        value=value,
        kind="flutter" if oscillates else "divergence",
        eigenvalue=complex(0.0, abs(crossing.imag)) if oscillates else 0j,
        unstable_above=grown[0] > min(inner[0], outer[0]),
    )


def _branches(found: Sequence[Complexes | None]) -> Complexes:
    """Rows ordered so that columns are continuous: each eigenvalue follows the nearest of the row before."""
    from scipy.optimize import linear_sum_assignment

    width = max((len(each) for each in found if each is not None), default=0)
    rows = np.full((len(found), width), np.nan + 0j, dtype=np.complex128)
    last: Complexes | None = None
    for i, values in enumerate(found):
        if values is None:
            continue
        ordered = values
        if last is not None and len(last) == len(values):
            ordered = values[linear_sum_assignment(np.abs(last[:, None] - values))[1]]
        rows[i, : len(values)] = ordered
        last = ordered
    return rows
