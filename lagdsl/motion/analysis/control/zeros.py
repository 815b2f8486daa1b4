"""Invariant zeros of a linear system: the s at which [A - s 1, B; C, D] loses rank.

Zeros at infinity are split off by orthogonal transformations, so that they do not appear as large numbers: states that
outputs which are held at zero hold at zero are taken away, until D has full rank; then the same for the dual system.
Source: Emami-Naeini and Van Dooren, Computation of zeros of linear multivariable systems, Automatica 18 (1982) 415-430.
"""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.eigen import Complexes

# Singular values below this part of the norm of the balanced matrices are zeros.
_ZERO = 1e-13

Matrices = tuple[Floats, Floats, Floats, Floats]


def invariant_zeros(a: Floats, b: Floats, c: Floats, d: Floats) -> Complexes:
    """Finite zeros [1/s] (k,) of A (nx, nx), B (nx, nu), C (ny, nx), D (ny, nu); none where it has no full rank."""
    from scipy.linalg import eig, qr

    if not b.size or not c.size:
        return np.zeros(0, dtype=np.complex128)
    system = _balanced(a, b, c, d)
    whole = np.block([[system[0], system[1]], [system[2], system[3]]])
    size = max(float(np.linalg.norm(whole, 2)), 1e-300)
    for _ in range(2):  # the system, then its dual
        a, b, c, d = _with_full_rank(system, _ZERO * size)
        system = (a.T, c.T, b.T, d.T)
    a, b, c, d = system
    states = len(a)
    if not states or d.shape[0] != d.shape[1]:
        return np.zeros(0, dtype=np.complex128)
    # Columns that [C, D] does not see: the motions with outputs that are zero.
    unseen = qr(np.hstack([c, d]).T, mode="full")[0][:, len(c) :]
    moved, seen = np.hstack([a, b]) @ unseen, unseen[:states]
    found = eig(moved, seen, right=False)
    finite = np.asarray(found[np.isfinite(found)], dtype=np.complex128)
    finite = finite[np.argsort(np.abs(finite))]
    finite[: _multiplicity_of_zero(np.asarray(np.linalg.solve(seen, moved), dtype=np.float64))] = 0.0
    return finite[np.lexsort((-finite.imag, finite.real, np.abs(finite).round(12)))]


def _multiplicity_of_zero(a: Floats) -> int:
    """The multiplicity of the eigenvalue zero of A (n, n). A double one is lost in eigenvalues of the size of the root
    of round-off; null spaces that are split off in turn count it.

    Source: Golub and Van Loan, Matrix Computations, 4th ed., section 7.6.
    """
    count = 0
    size = float(np.linalg.norm(a, 2))
    while len(a):
        _, sizes, rows = np.linalg.svd(a)
        rank = int(np.count_nonzero(sizes > _ZERO * size))
        if rank == len(a):
            break
        count += len(a) - rank
        a = rows[:rank] @ a @ rows[:rank].T
    return count


def _balanced(a: Floats, b: Floats, c: Floats, d: Floats) -> Matrices:
    """The same zeros, with states, inputs and outputs in units in which the entries have similar sizes."""
    from scipy.linalg import matrix_balance

    inputs, outputs = b.shape[1], len(c)
    whole = np.block([[a, b], [c, d]])
    square = np.zeros((len(a) + max(inputs, outputs),) * 2)
    square[: len(whole), : whole.shape[1]] = whole
    _, (scale, _) = matrix_balance(square, permute=False, separate=True)
    states = scale[: len(a)]
    a = a * states / states[:, None]
    # One factor for each input and each output: its own length.
    b, c = b / states[:, None], c * states
    into = _lengths(np.vstack([b, d]).T)
    b, d = b / into, d / into
    out = _lengths(np.hstack([c, d]))[:, None]
    pace = max(float(np.linalg.norm(a, 2)), 1e-300) if a.size else 1.0
    return a, b * pace, c / out, d / out * pace


def _lengths(rows: Floats) -> Floats:
    lengths = np.linalg.norm(rows, axis=1)
    return np.where(lengths > 0.0, lengths, 1.0)


def _with_full_rank(system: Matrices, tolerance: float) -> Matrices:
    """The system with the same finite zeros whose D has full row rank."""
    a, b, c, d = system
    while True:
        left, sizes, _ = np.linalg.svd(d, full_matrices=True)
        rank = int(np.count_nonzero(sizes > tolerance))
        c, d = left.T @ c, left.T @ d
        if rank == len(d):
            return a, b, c, d
        c, d, silent = c[:rank], d[:rank], c[rank:]
        _, sizes, rows = np.linalg.svd(silent, full_matrices=True)
        held = int(np.count_nonzero(sizes > tolerance))
        if not held:
            return a, b, c, d
        # States in the first `held` directions are zero, as these outputs are; that they stay there are new outputs.
        fixed, free = rows[:held].T, rows[held:].T
        c, d = np.vstack([c @ free, fixed.T @ a @ free]), np.vstack([d, fixed.T @ b])
        a, b = free.T @ a @ free, free.T @ b
