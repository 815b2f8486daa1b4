"""Independent parts of systems of equations, and descents that treat each as if it were alone."""

from __future__ import annotations

import numpy as np
from choice import examples
from hypothesis import given, settings
from hypothesis import strategies as st

from lagdsl.foundation.numerics.connected_blocks import connected_blocks
from lagdsl.foundation.numerics.levenberg_marquardt import descend
from lagdsl.foundation.numerics.part_by_part import is_positive_definite
from lagdsl.foundation.numerics.sparse_matrix import beside, product, sparse, stack


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


@settings(max_examples=examples(20), deadline=None)
@given(st.integers(0, 5), st.integers(0, 5), st.integers(0, 5), st.integers(0, 2**31))
def test_sparse_matrices_do_as_dense_ones(m: int, n: int, k: int, seed: int) -> None:
    generator = np.random.default_rng(seed)
    a, b, c = (generator.standard_normal(shape) * (generator.random(shape) < 0.4) for shape in ((m, n), (n, k), (k, n)))
    assert np.allclose(product(sparse(a), sparse(b)).dense(), a @ b)
    assert np.array_equal(stack(sparse(a), sparse(c)).dense(), np.vstack([a, c]))
    assert np.array_equal(beside([sparse(b), sparse(c.T)]).dense(), np.hstack([b, c.T]))


def test_rows_make_up_for_the_directions_that_a_matrix_lacks() -> None:
    """Two blocks, each singular along one vector: both have to be in a row, and not only nearly across it."""
    generator = np.random.default_rng(3)
    lacking = generator.standard_normal((2, 4))
    blocks = [np.eye(4) - np.outer(e, e) / (e @ e) for e in lacking]
    zero = np.zeros((4, 4))
    matrix = sparse(np.block([[blocks[0], zero], [zero, blocks[1]]]))
    along = np.block([[lacking[:1], zero[:1]], [zero[:1], 7.0 * lacking[1:]]])
    across = generator.standard_normal((2, 8)) @ matrix.dense()
    assert not is_positive_definite(matrix)
    assert is_positive_definite(matrix, sparse(along))
    assert not is_positive_definite(matrix, sparse(along[:1]))
    assert not is_positive_definite(matrix, sparse(across))
