"""Eigenvalues of a state matrix with its zeros split off exactly.

Motions along ignorable coordinates give zeros with Jordan chains, which a plain eigenvalue routine smears over the
square root of the round-off. The null space of A is split off by an orthogonal transformation, then that of what is
left, until nothing is singular (the staircase of Kublanovskaya; Golub and Van Loan, Matrix Computations, 4th ed.,
section 7.6). The QR algorithm solves the rest.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.numerics.rank import Floats

Complexes = NDArray[np.complex128]

# Singular values of the balanced matrix below this part of the largest are zeros.
_ZERO = 3e-12


def eigen(a: Floats) -> tuple[Complexes, Complexes]:
    """Eigenvalues (n,) and right eigenvectors (n, n) as columns; zeros come last, exact, with generalized vectors."""
    from scipy.linalg import matrix_balance

    if not a.size:
        return np.zeros(0, dtype=np.complex128), np.zeros((0, 0), dtype=np.complex128)
    balanced, (scale, _) = matrix_balance(a, permute=False, separate=True)
    values, vectors = _split(np.asarray(balanced, dtype=np.float64), float(np.linalg.norm(balanced, 2)))
    vectors = vectors * scale[:, None]
    order = sorted(range(len(values)), key=lambda i: _rank(complex(values[i])))
    return values[order], vectors[:, order]


def _split(a: Floats, size: float) -> tuple[Complexes, Complexes]:
    n = len(a)
    if n == 0:
        return np.zeros(0, dtype=np.complex128), np.zeros((0, 0), dtype=np.complex128)
    _, singular, rows = np.linalg.svd(a)
    count = int(np.count_nonzero(singular > _ZERO * size))
    if count == n:
        values, vectors = np.linalg.eig(a)
        return values.astype(np.complex128), vectors.astype(np.complex128)
    null, rest = rows[count:].T, rows[:count].T
    values, inner = _split(rest.T @ a @ rest, size)
    vectors = (rest @ inner).astype(np.complex128)
    coupling = null.T @ a @ vectors
    nonzero = np.abs(values) > 0.0
    vectors[:, nonzero] += null @ (coupling[:, nonzero] / values[nonzero])
    return np.concatenate([values, np.zeros(n - count)]), np.hstack([vectors, null.astype(np.complex128)])


def _rank(value: complex) -> tuple[bool, float, float, float]:
    """Slow before fast, zeros last, the member with positive imaginary part first."""
    rounded = float(f"{abs(value):.9e}")
    return (value == 0.0, rounded, float(f"{value.real:.9e}"), -value.imag)
