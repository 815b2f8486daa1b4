"""Independent parts of systems of equations, and descents that treat each as if it were alone."""

from __future__ import annotations

import numpy as np
from choice import examples
from hypothesis import given, settings
from hypothesis import strategies as st

from lagdsl.foundation.numerics.connected_blocks import connected_blocks
from lagdsl.foundation.numerics.levenberg_marquardt import descend
from lagdsl.foundation.numerics.sparse_matrix import sparse


@settings(max_examples=examples(50), deadline=None)
@given(st.integers(0, 6), st.integers(0, 6), st.integers(0, 2**31))
def test_no_entry_joins_two_parts(m: int, n: int, seed: int) -> None:
    pattern = np.random.default_rng(seed).random((m, n)) < 0.25
    split = connected_blocks(sparse(pattern))
    rows, columns = np.nonzero(pattern)
    assert np.array_equal(split.row_labels[rows], split.column_labels[columns])
    both = {int(label) for parts in split.parts for label in parts.labels}
    assert both == set(split.row_labels.tolist()) & set(split.column_labels.tolist())
    assert split.count == len({*split.row_labels.tolist(), *split.column_labels.tolist()})


def test_a_part_without_solution_does_not_disturb_the_others() -> None:
    """x^2 = 2 beside y^2 = -1, which stalls."""

    def equations(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.array([x[0] ** 2 - 2.0, x[1] ** 2 + 1.0]), np.diag(2.0 * x)

    found = descend(equations, np.array([1.0, 0.7]), connected_blocks=connected_blocks(sparse(np.eye(2))))
    assert abs(found.point[0] - np.sqrt(2.0)) < 1e-15
    assert abs(found.point[1]) < 1e-3 and abs(found.residual[1] - 1.0) < 1e-6


def test_parts_take_the_steps_that_they_take_alone() -> None:
    def one(x: np.ndarray, c: float) -> tuple[np.ndarray, np.ndarray]:
        return np.array([x[0] ** 2 + x[1] ** 2 - c, x[0] - x[1] ** 3]), np.array(
            [[2 * x[0], 2 * x[1]], [1.0, -3 * x[1] ** 2]]
        )

    def both(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        (r, j), (s, k) = one(x[:2], 1.0), one(x[2:], 5.0)
        zero = np.zeros((2, 2))
        return np.concatenate([r, s]), np.block([[j, zero], [zero, k]])

    start = np.array([0.3, 2.0, -4.0, 0.1])
    pattern = np.kron(np.eye(2), np.ones((2, 2))) > 0.0
    together = descend(both, start, connected_blocks=connected_blocks(sparse(pattern))).point
    alone = [descend(lambda x, c=c: one(x, c), start[i : i + 2]).point for i, c in ((0, 1.0), (2, 5.0))]
    assert np.allclose(together, np.concatenate(alone), atol=1e-13)
