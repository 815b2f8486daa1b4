"""Is M regular where it is not written out? Eliminations tell, without forming it: M of a long chain is full."""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix, beside, stack
from lagdsl.foundation.numerics.sparse_pivots import regular

# Subtraction must leave this part of every pivot to show that M is positive definite.
_SAFE_PIVOT = 1e-6


def shows_regular_mass(functions: ProgramFunctions, state: tuple[Floats | float, ...], rows: SparseMatrix) -> bool:
    """True if M is regular, and on the null space of `rows` (nc, nq) of J, too; False where that does not show.

    The program's own elimination shows it where no pivot loses its digits, else one by the steps of M times a vector.
    """
    if functions.program.has("elimination"):
        found = functions.evaluate("elimination", *state)
        if np.all(np.isfinite(found[0])) and found[-1] > _SAFE_PIVOT:
            return True
    steps = functions.momentum_steps(*state)
    return steps is not None and regular(steps) and regular(_with_rows(steps, rows))


def _with_rows(steps: SparseMatrix, rows: SparseMatrix) -> SparseMatrix:
    """`[M, A'; A, 0]` by the steps of M (k + n, n + k), A (m, n) being the rows that are not zero: where it is regular,
    M is regular on the null space of A."""
    tied = rows.nonzero()
    tied = tied.taken(np.flatnonzero(tied.counts()))
    (m, n), count = tied.shape, len(steps)
    pulled = SparseMatrix((count, m), count - n + tied.columns, tied.rows, tied.values)
    return stack(beside([steps, pulled]), SparseMatrix((m, count + m), tied.rows, tied.columns, tied.values))
