"""Gain, phase and delay margins of a loop, from the matrices alone.

Where |G| = 1, s is a zero of G(s) G(-s) - 1; where G is real, it is a zero of G(s) - G(-s). Both are linear systems of
twice the order, so that all crossings are found, however narrow a resonance is, and none is missed between points of a
grid. Each is polished on the frequency response itself. Sampled loops are mapped by z = (1 + s)/(1 - s) first.
Sources: Boyd, Balakrishnan and Kabamba, A bisection method for computing the H-infinity norm of a transfer matrix and
related problems, Mathematics of Control, Signals and Systems 2 (1989) 207-219 (crossings by eigenvalues); Franklin,
Powell and Emami-Naeini, Feedback Control of Dynamic Systems, section 6.4 (margins).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.control.zeros import Matrices, invariant_zeros
from lagdsl.motion.analysis.eigen import Complexes, eigen

Response = Callable[[Floats], Complexes]

# Zeros so near to the imaginary axis, as a part of their magnitude, are tried as crossings.
_NEAR = 1e-3
# The function whose zero a crossing is, there.
_HOLDS = 1e-7
_STABLE = 1e-9
_LEAST = 1e-300


@dataclass(frozen=True, slots=True)
class Crossing:
    """A frequency `omega` [rad/s] at which the gain is one or the phase half a turn, and the `value` of G there."""

    omega: float
    value: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Margins:
    """Of the loop that u = -y closes. `of_gain` are the crossings of half a turn, `of_phase` those of gain one, by
    frequency. `closed` are the poles of the closed loop; `stable`: none of them and no hidden one grows or stays."""

    of_gain: tuple[Crossing, ...]
    of_phase: tuple[Crossing, ...]
    closed: Complexes
    stable: bool

    @property
    def gain(self) -> float:
        """The factor on G nearest to one at which the loop reaches the border of stability; inf without one."""
        factors = [1.0 / abs(each.value) for each in self.of_gain]
        return min(factors, key=lambda factor: abs(math.log(factor)), default=math.inf)

    @property
    def phase(self) -> float:
        """The least angle [rad] of G to the border of stability, positive for a lag; inf without one."""
        return min((lag(each.value) for each in self.of_phase), key=abs, default=math.inf)

    @property
    def delay(self) -> float:
        """The least further delay [s] that leads to the border of stability; inf without one."""
        return min(((lag(each.value) % (2.0 * math.pi)) / each.omega for each in self.of_phase), default=math.inf)


def margins_of(matrices: Matrices, hidden: Complexes, every: float | None, response: Response) -> Margins:
    """All crossings above zero and, where signals are sampled, below half the sampling rate. `hidden` are poles off the
    way. Raises ValueError for a sampled system with the pole z = -1."""
    a, b, c, d = matrices if every is None else _mapped(matrices)
    zero, one = np.zeros((len(a), len(a))), np.ones((1, 1))
    # G(-s) is (-A, -B, C, D): beside G for the imaginary part, behind it for the square of the magnitude.
    imaginary = (np.block([[a, zero], [zero, -a]]), np.vstack([b, -b]), np.hstack([c, -c]), 0.0 * one)
    square = (np.block([[a, b @ c], [zero, -a]]), np.vstack([b @ d, -b]), np.hstack([c, d @ c]), d @ d - one)
    half = [each for each in _crossings(imaginary, every, response, _sine) if each.value.real < 0.0]
    closed = _closed(matrices)
    poles = np.concatenate([closed, hidden[hidden != (0.0 if every is None else 1.0)]])
    bound = -_STABLE * np.abs(poles) if every is None else 1.0 - _STABLE
    grows = (poles.real if every is None else np.abs(poles)) >= bound
    return Margins(
        of_gain=tuple(half),
        of_phase=tuple(_crossings(square, every, response, _log)),
        closed=closed,
        stable=not bool(np.any(grows)) and bool(np.all(np.isfinite(closed))),
    )


def lag(value: complex) -> float:
    """The angle from -1 to G, in (-pi, pi]: the lag that leads there."""
    return math.atan2(-value.imag, -value.real)


def _sine(values: Complexes) -> Floats:
    return np.asarray(values.imag / np.maximum(np.abs(values), _LEAST))


def _log(values: Complexes) -> Floats:
    return np.asarray(np.log(np.maximum(np.abs(values), _LEAST)))


def _closed(matrices: Matrices) -> Complexes:
    """Poles with u = -y; nan where y = -D y has no solution."""
    a, b, c, d = matrices
    if abs(1.0 + d[0, 0]) <= 1e-14:
        return np.full(len(a), np.nan + 0j)
    return eigen(a - b @ c / (1.0 + d[0, 0]))[0]


def _mapped(matrices: Matrices) -> Matrices:
    """In w of z = (1 + w)/(1 - w), which takes the unit circle to the imaginary axis."""
    a, b, c, d = matrices
    try:
        inverse = np.linalg.inv(a + np.eye(len(a)))
    except np.linalg.LinAlgError:
        raise ValueError("a sampled system with a pole at z = -1 has no margins") from None
    return inverse @ (a - np.eye(len(a))), inverse @ b, 2.0 * c @ inverse, d - c @ inverse @ b


def _crossings(
    matrices: Matrices, every: float | None, response: Response, distance: Callable[[Complexes], Floats]
) -> list[Crossing]:
    """Zeros of `distance` of G among the zeros of a system that are next to the imaginary axis."""
    zeros = invariant_zeros(*matrices)
    near = zeros[(np.abs(zeros.real) <= _NEAR * np.abs(zeros)) & (zeros.imag > 0.0)]
    candidates = np.sort(near.imag if every is None else 2.0 * np.arctan(near.imag) / every)
    found: list[Crossing] = []
    for omega in candidates.tolist():
        exact = _polished(omega, lambda at: float(distance(response(np.array([at])))[0]))
        if exact is not None and not any(abs(exact - each.omega) <= 1e-9 * exact for each in found):
            found.append(Crossing(exact, complex(response(np.array([exact]))[0])))
    return found


def _polished(omega: float, distance: Callable[[float], float]) -> float | None:
    """The zero of `distance` next to `omega`; None if there is none. One that only touches zero is taken as it is."""
    from scipy.optimize import brentq

    width = 1e-12
    while width < _NEAR:
        low, high = omega * (1.0 - width), omega * (1.0 + width)
        if distance(low) * distance(high) < 0.0:
            omega = float(brentq(distance, low, high, xtol=1e-15 * omega, rtol=1e-14))
            break
        width *= 10.0
    return omega if abs(distance(omega)) <= _HOLDS else None
