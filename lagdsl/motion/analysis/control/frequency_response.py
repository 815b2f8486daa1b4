"""Frequency responses: from one input to one output, at frequencies that show what there is to see."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.control.margins import Margins
from lagdsl.motion.analysis.control.transfer import TransferFunction
from lagdsl.motion.analysis.eigen import Complexes
from lagdsl.motion.analysis.linearize import Named
from lagdsl.motion.analysis.point import Point
from lagdsl.motion.analysis.steady import Steadiness

_PER_DECADE = 60
_BESIDE = 10.0
# On each side of a resonance so many more, up to this part of its frequency away.
_AROUND = 24
_WIDE = 0.1
_LEAST_WIDTH = 1e-6
_MOST_DECADES = 12.0


@dataclass(frozen=True, slots=True, kw_only=True)
class FrequencyResponse:
    """`response` (k,) is y/u in SI units at `frequencies` [Hz] (k,), for sinusoids about `point`.

    `transfer` is the same as a quotient of polynomials, None for a model with delays. `margins` are those of the loop
    u = -y; None where there are none, for a sampled system with a pole at z = -1, and with delays.
    """

    model: str
    point: Point
    steadiness: Steadiness
    input: Named
    output: Named
    frequencies: Floats
    response: Complexes
    transfer: TransferFunction | None
    margins: Margins | None

    @property
    def every(self) -> float | None:
        """The period of a sampled system [s]."""
        return None if self.transfer is None else self.transfer.every

    @property
    def magnitude(self) -> Floats:
        """abs(y/u) (k,)."""
        return np.abs(self.response)

    @property
    def decibels(self) -> Floats:
        """20 log10 of the magnitude in SI units (k,)."""
        with np.errstate(divide="ignore"):
            return np.asarray(20.0 * np.log10(self.magnitude))

    @property
    def phase(self) -> Floats:
        """Continuous over the frequencies [rad] (k,); the first lies in (-pi, pi]."""
        angle = np.angle(self.response)
        sound = np.isfinite(angle)
        angle[sound] = np.unwrap(angle[sound])
        return angle


def frequencies_of(transfer: TransferFunction, margins: Margins | None) -> Floats:
    """Angular frequencies [rad/s], rising: from a decade below the slowest pole, zero or crossing to a decade above the
    fastest, denser around resonances; for sampled signals up to half the sampling rate."""
    poles, zeros = _exponents(transfer.poles, transfer.every), _exponents(transfer.zeros, transfer.every)
    crossings = [] if margins is None else [each.omega for each in (*margins.of_gain, *margins.of_phase)]
    sizes = [*(abs(each) for each in (*poles, *zeros)), *crossings]
    sizes = [size for size in sizes if size > 0.0] or [1.0 if transfer.every is None else np.pi / transfer.every]
    most = np.inf if transfer.every is None else np.pi / transfer.every
    high = min(max(sizes) * _BESIDE, most)
    low = max(min(*sizes, high) / _BESIDE, high / 10.0**_MOST_DECADES)
    count = int(np.ceil(np.log10(high / low) * _PER_DECADE)) + 1
    grid = [*np.geomspace(low, high, max(count, 2)).tolist(), *crossings]
    for each in (*poles, *zeros):
        if abs(each.imag) > 2.0 * abs(each.real):
            half = max(abs(each.real), _LEAST_WIDTH * abs(each))
            beside = np.geomspace(0.1 * half, max(_WIDE * abs(each), half), _AROUND)
            grid += [*(abs(each.imag) - beside).tolist(), *(abs(each.imag) + beside).tolist()]
            # At a pole on the axis there is no response.
            grid += [abs(each.imag)] if abs(each.real) > _LEAST_WIDTH * abs(each) or each in zeros else []
    values = np.unique(grid)
    return np.asarray(values[(values >= low) & (values <= high)])


def _exponents(found: Complexes, every: float | None) -> list[complex]:
    """Poles or zeros in s; those of sampled signals as s = log(z)/T, without those at z = 0."""
    if every is not None:
        found = found[np.abs(found) > 1e-12]
        found = np.asarray(np.log(found) / every, dtype=np.complex128)
        found = found[np.abs(found) > 1e-9 / every]
    return [complex(each) for each in found]
