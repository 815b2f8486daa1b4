"""Transfer functions from one input to one output: poles, zeros, gain, polynomials, frequency response, margins."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.control.margins import Margins, margins_of
from lagdsl.motion.analysis.control.package import python_control, signal_name
from lagdsl.motion.analysis.control.zeros import Matrices, invariant_zeros
from lagdsl.motion.analysis.eigen import Complexes, eigen
from lagdsl.motion.analysis.linearize import Named

if TYPE_CHECKING:
    import control

_TEST_POINTS = (1.7, 2.9, 0.37)


@dataclass(frozen=True, slots=True, kw_only=True)
class TransferFunction:
    """G of y = G u in SI units, for continuous time in s [1/s], with `every` [s] for sampled signals in z.

    `matrices` are A (n, n), B (n, 1), C (1, n), D (1, 1) on states that the input reaches and that reach the output;
    `hidden` (k,) are the poles of all others.
    """

    input: Named
    output: Named
    matrices: Matrices
    hidden: Complexes
    every: float | None = None

    @property
    def poles(self) -> Complexes:
        """(n,), in 1/s or numbers of z; zeros last, exact."""
        return eigen(self.matrices[0])[0]

    @property
    def zeros(self) -> Complexes:
        """Finite zeros (k,)."""
        return invariant_zeros(*self.matrices)

    @property
    def gain(self) -> float:
        """k of G = k prod(s - zeros)/prod(s - poles); 0 where nothing is transmitted."""
        poles, zeros = self.poles, self.zeros
        pace = float(np.max(np.abs(np.concatenate([poles, zeros])), initial=0.0)) or 1.0
        found = []
        for part in _TEST_POINTS:  # beyond all of them: nothing cancels
            at = complex(0.0, (1.0 + part) * pace)
            found.append((self(at) * _ratio(at - poles, at - zeros)).real)
        return float(np.median(found))

    @property
    def numerator(self) -> Floats:
        """Coefficients of powers of s or z, the highest first."""
        return np.atleast_1d(self.gain * np.real(np.poly(self.zeros)))

    @property
    def denominator(self) -> Floats:
        """As `numerator`; the first is 1."""
        return np.atleast_1d(np.real(np.poly(self.poles)))

    @property
    def static_gain(self) -> float:
        """G at rest: at s = 0 or z = 1; infinite where a pole lies there."""
        at = 0.0 if self.every is None else 1.0
        if np.any(np.abs(self.poles - at) <= 1e-12):
            return float("inf") if self.gain else 0.0
        return self(complex(at)).real

    def __call__(self, at: complex) -> complex:
        """G at one s or z; infinite or nan at a pole."""
        a, b, c, d = self.matrices
        with np.errstate(all="ignore"):  # products of small matrices of both kinds raise flags without a reason
            pencil = np.asarray(at * np.eye(len(a)) - a, dtype=np.complex128)
            return complex((d + c @ _solved(pencil, b))[0, 0])

    def response(self, omega: ArrayLike) -> Complexes:
        """G at the angular frequencies `omega` [rad/s]; infinite or nan at a pole."""
        a, b, c, d = self.matrices
        values = np.asarray(omega, dtype=np.float64)
        points = 1j * values if self.every is None else np.exp(1j * values * self.every)
        pencils = np.asarray(points[..., None, None] * np.eye(len(a)) - a, dtype=np.complex128)
        with np.errstate(all="ignore"):
            return np.asarray((d + c @ _solved(pencils, b))[..., 0, 0])

    @property
    def margins(self) -> Margins:
        """Of the loop that is closed by u = -y, in SI units."""
        return margins_of(self.matrices, self.hidden, self.every, self.response)

    def to_control(self) -> control.TransferFunction:
        """As a `TransferFunction` of python-control. Raises ModuleNotFoundError without that package."""
        package = python_control()
        return package.TransferFunction(
            self.numerator,
            self.denominator,
            0 if self.every is None else self.every,
            inputs=[signal_name(self.input.name)],
            outputs=[signal_name(self.output.name)],
        )


def transfer_function(
    matrices: Matrices, source: tuple[int, Named], target: tuple[int, Named], every: float | None
) -> TransferFunction:
    """From one input to one output of A, B, C, D, each with its place."""
    a, b, c, d = matrices
    linked = a != 0.0
    on_the_way = _closure(linked, b[:, source[0]] != 0.0) & _closure(linked.T, c[target[0]] != 0.0)
    kept, others = np.flatnonzero(on_the_way), np.flatnonzero(~on_the_way)
    return TransferFunction(
        input=source[1],
        output=target[1],
        matrices=(
            a[np.ix_(kept, kept)],
            b[kept][:, [source[0]]],
            c[[target[0]]][:, kept],
            d[[target[0]]][:, [source[0]]],
        ),
        hidden=eigen(a[np.ix_(others, others)])[0],
        every=every,
    )


def _closure(linked: Flags, start: Flags) -> Flags:
    """All that `start` leads to; linked[i, j]: from j to i."""
    found = start.copy()
    while True:
        more = found | np.any(linked[:, found], axis=1)
        if np.array_equal(more, found):
            return found
        found = more


def _ratio(above: Complexes, below: Complexes) -> complex:
    """prod(above)/prod(below), factor by factor: the products alone overflow."""
    count = max(len(above), len(below))
    one, two = (np.concatenate([each, np.ones(count - len(each))]) for each in (above, below))
    return complex(np.prod(one / two))


def _solved(pencils: Complexes, right: Floats) -> Complexes:
    """Solutions of many equations; nan where one is singular."""
    try:
        return np.asarray(np.linalg.solve(pencils, right.astype(np.complex128)))
    except np.linalg.LinAlgError:
        found = np.full((*pencils.shape[:-2], *right.shape), np.nan + 0j)
        for place in np.ndindex(pencils.shape[:-2]):
            try:
                found[place] = np.linalg.solve(pencils[place], right)
            except np.linalg.LinAlgError:
                continue
        return found
