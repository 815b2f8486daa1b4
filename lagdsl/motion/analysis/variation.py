"""Eigenvalues over a parameter, and the thresholds at which they cross the imaginary axis.

A threshold is bracketed by two values with different numbers of growing modes and bisected. If eigenvalues leave the
axis by colliding on it (no damping), real parts begin as a square root, and a bound of 1e-7 of the magnitude places the
threshold to 1e-14. If they cross it with finite slope, secants find the root of the real part.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np

from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.border import on_both_sides
from lagdsl.motion.analysis.eigen import Complexes, eigen
from lagdsl.motion.analysis.held import sampled
from lagdsl.motion.analysis.linearize import Named, Reduced, reduce
from lagdsl.motion.analysis.modes import AXIS
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.analysis.sampled.modes import loop_modes
from lagdsl.motion.analysis.sampled.verdict import SampledModes
from lagdsl.motion.analysis.steady import in_turning_axes

Place: TypeAlias = Callable[[float], Point]

_ROUNDING = 1e-12
_WIDTH = 2e-13
_HALVINGS = 100
_MOST = 8
_LEAST = 1e-300
# The part of a step between values at which a crossing eigenvalue is looked at.
_BESIDE = 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class Threshold:
    """The value at which an eigenvalue crosses the imaginary axis: through zero (divergence) or as a pair (flutter).

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
class Variation:
    """`eigenvalues` (k, n) [1/s], each column a branch, nan where there is no linearization; `unstable` (k,) numbers
    of growing modes, -1 there. `of_loop`: clocks close a loop, and the eigenvalues are those of the samples,
    log(multiplier)/period, and thresholds those of the loop: there a multiplier crosses the unit circle. `held`: see
    `Modes`; where it names signals, the loop has no linearization, and all are those of the plant."""

    model: str
    varied: Named
    values: Floats
    eigenvalues: Complexes
    unstable: tuple[int, ...]
    thresholds: tuple[Threshold, ...]
    held: tuple[str, ...] = ()
    of_loop: bool = False


def variation(system: System, varied: Named, values: Sequence[float], place: Place, held: Sequence[int]) -> Variation:
    """Eigenvalues at `place(value)` for each value, and the thresholds between neighbors. Raises CompilationFailed
    where no value has a linearization."""
    spectrum = _Spectrum(system, place, tuple(held), _closes(system, place, values))
    found = [spectrum(value) for value in values]
    if all(each is None for each in found) and len(values):
        spectrum.explain(values[0])
    counts = tuple(-1 if each is None else _growing(each, AXIS) for each in found)
    thresholds: list[Threshold] = []
    for i in range(len(values) - 1):
        if min(counts[i], counts[i + 1]) >= 0 and counts[i] != counts[i + 1]:
            thresholds += _between(spectrum, (values[i], counts[i]), (values[i + 1], counts[i + 1]))
    return Variation(
        model=system.flat.name,
        varied=varied,
        values=np.array(values, dtype=np.float64),
        eigenvalues=_branches(found),
        unstable=counts,
        thresholds=tuple(thresholds),
        held=() if spectrum.of_loop else sampled(system),
        of_loop=spectrum.of_loop,
    )


@dataclass(frozen=True, slots=True)
class _Spectrum:
    """Eigenvalues as a function of the varied value; None where there is no linearization."""

    system: System
    place: Place
    held: tuple[int, ...]
    of_loop: bool

    def __call__(self, value: float) -> Complexes | None:
        try:
            if self.of_loop:
                loop = loop_modes(self.system, self.place(value), Sink())
                return None if loop is None else _of_samples(loop)
            at = self._reduced(value, Sink())
        except CompilationFailed:
            return None
        return None if at is None else eigen(in_turning_axes(self.system, at).a)[0]

    def explain(self, value: float) -> None:
        """Raise what is wrong at `value`."""
        sink = Sink()
        if self.of_loop:
            loop_modes(self.system, self.place(value), sink)
        else:
            self._reduced(value, sink)
        sink.raise_if_errors()

    def _reduced(self, value: float, sink: Sink) -> Reduced | None:
        at = reduce(self.system, self.place(value), self.held, sink, outputs=False)
        return None if at is None else on_both_sides(self.system, at, sink, of_modes=True)


def _closes(system: System, place: Place, values: Sequence[float]) -> bool:
    """True if clocks close a loop that has a linearization at one of the values."""
    return bool(sampled(system)) and any(_has_loop(system, place, value) for value in values)


def _has_loop(system: System, place: Place, value: float) -> bool:
    try:
        return loop_modes(system, place(value), Sink()) is not None
    except CompilationFailed:
        return False


def _of_samples(loop: SampledModes) -> Complexes:
    """Exponents of the multipliers [1/s]; that of zero is finite."""
    size = np.maximum(np.abs(loop.multipliers), _LEAST)
    return np.asarray((np.log(size) + 1j * np.angle(loop.multipliers)) / loop.period)


def _growing(values: Complexes, bound: float) -> int:
    return int(np.count_nonzero(values.real > bound * np.abs(values)))


def _between(spectrum: _Spectrum, low: tuple[float, int], high: tuple[float, int]) -> list[Threshold]:
    """Thresholds between two values, from the first on."""
    result: list[Threshold] = []
    step = abs(high[0] - low[0])
    while low[1] != high[1] and len(result) < _MOST:
        inner, outer = _bisect(spectrum, low, high)
        result.append(_threshold(spectrum, inner, outer, step))
        low = outer
    return result


def _bisect(
    spectrum: _Spectrum, low: tuple[float, int], high: tuple[float, int]
) -> tuple[tuple[float, int], tuple[float, int]]:
    """Two values next to each other between which the number of growing modes leaves that of `low`."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (low[0] + high[0])
        if abs(high[0] - low[0]) <= _WIDTH * max(abs(low[0]), abs(high[0])) or middle in (low[0], high[0]):
            break
        values = spectrum(middle)
        count = low[1] if values is None else _growing(values, AXIS)
        if count == low[1]:
            low = (middle, count)
        else:
            high = (middle, count)
    return low, high


def _threshold(spectrum: _Spectrum, inner: tuple[float, int], outer: tuple[float, int], step: float) -> Threshold:
    """Between neighboring values; where the real part crosses zero with finite slope, its root by the secant."""
    value = 0.5 * (inner[0] + outer[0])
    above = (inner[1] < outer[1]) == (inner[0] < outer[0])
    side = 1.0 if above else -1.0
    near = 100.0 * _BESIDE * step * side
    crossing = _crossing(spectrum, value, near)
    if crossing is None:
        return Threshold(value=value, kind="divergence", eigenvalue=0j, unstable_above=above)
    further = _crossing(spectrum, value, 4.0 * near)
    if further is not None and further.real > 2.8 * crossing.real:  # in proportion to the distance, no square root
        value = _root(spectrum, value, near, crossing)
        value = _root(spectrum, value, side * _BESIDE * step, crossing)
    crossing = _crossing(spectrum, value, side * _BESIDE * step) or crossing
    oscillates = abs(crossing.imag) > 1e-2 * abs(crossing.real)
    return Threshold(
        value=value,
        kind="flutter" if oscillates else "divergence",
        eigenvalue=complex(0.0, abs(crossing.imag)) if oscillates else 0j,
        unstable_above=above,
    )


def _crossing(spectrum: _Spectrum, value: float, distance: float) -> complex | None:
    """The mode that has just begun to grow at `distance` beyond the threshold."""
    values = spectrum(value + distance)
    growing = [] if values is None else [complex(v) for v in values if v.real > _ROUNDING * abs(v)]
    return min(growing, key=lambda v: v.real, default=None)


def _root(spectrum: _Spectrum, value: float, distance: float, crossing: complex) -> float:
    """The zero of the line through the real parts on both sides."""
    beyond, before = spectrum(value + distance), spectrum(value - distance)
    if beyond is None or before is None:
        return value
    # zeros of ignorable coordinates lie nearer than the eigenvalue on the other side
    moving = [each[each != 0.0] for each in (beyond, before)]
    if not all(len(each) for each in moving):
        return value
    a, b = (complex(each[int(np.argmin(np.abs(each - crossing)))]).real for each in moving)
    return value - distance * (a + b) / (a - b) if a > 0.0 > b else value


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
