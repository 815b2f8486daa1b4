"""Linear algebra with rank decisions."""

from __future__ import annotations

import numpy as np
import pytest
from choice import examples
from hypothesis import given, settings
from hypothesis import strategies as st

from lagdsl.foundation.numerics.levenberg_marquardt import descend
from lagdsl.foundation.numerics.rank import independent_rows, minimum_norm, minimum_norms, null_space, rank
from lagdsl.foundation.numerics.sparse_matrix import sparse
from lagdsl.foundation.numerics.sparse_pivots import independent, regular


@st.composite
def low_rank(draw: st.DrawFn) -> tuple[np.ndarray, int]:
    """A random matrix of known rank."""
    rows, columns = draw(st.integers(1, 6)), draw(st.integers(1, 6))
    r = draw(st.integers(0, min(rows, columns)))
    generator = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    return generator.standard_normal((rows, r)) @ generator.standard_normal((r, columns)), r


@settings(max_examples=examples(60), deadline=None)
@given(low_rank())
def test_rank_null_space_and_pseudo_inverse_agree(sample: tuple[np.ndarray, int]) -> None:
    matrix, expected = sample
    assert rank(matrix) == expected
    free = null_space(matrix)
    assert free.shape == (matrix.shape[1], matrix.shape[1] - expected)
    assert np.allclose(matrix @ free, 0.0, atol=1e-12 * (1.0 + np.abs(matrix).max()))
    assert np.allclose(free.T @ free, np.eye(free.shape[1]))
    right = np.arange(1.0, matrix.shape[0] + 1.0)
    assert np.allclose(minimum_norm(matrix, right), np.linalg.pinv(matrix, rcond=1e-9) @ right, atol=1e-7)


@settings(max_examples=examples(60), deadline=None)
@given(low_rank())
def test_as_many_rows_are_kept_as_the_rank_says(sample: tuple[np.ndarray, int]) -> None:
    matrix, expected = sample
    kept = independent_rows(matrix, list(range(matrix.shape[0])), expected)
    assert sum(kept) == expected
    assert rank(matrix[kept]) == expected


def test_rows_are_kept_in_the_order_given() -> None:
    same, other = np.array([[1.0, 0.0], [2.0, 0.0]]), np.array([[1.0, 0.0], [2.0, 1.0]])
    assert independent_rows(same, [0, 1], 1) == [True, False]
    assert independent_rows(same, [1, 0], 1) == [False, True]
    assert independent_rows(other, [0, 1], 2) == [True, True]
    assert independent_rows(other, [0, 1], 1) == [True, False]
    assert independent_rows(np.zeros((0, 2)), [], 0) == []


def test_well_conditioned_rows_are_preferred() -> None:
    matrix = np.array([[1.0, 0.0], [1.0, 1e-8], [0.0, 1.0]])
    assert independent_rows(matrix, [0, 1, 2], 2) == [True, False, True]


def test_empty_matrices() -> None:
    empty = np.zeros((0, 3))
    assert rank(empty) == 0
    assert np.array_equal(null_space(empty), np.eye(3))
    assert np.array_equal(null_space(np.zeros((2, 3))), np.eye(3))
    assert rank(np.zeros((2, 3))) == 0
    assert np.array_equal(minimum_norm(empty, np.zeros(0)), np.zeros(3))
    assert np.array_equal(minimum_norm(np.zeros((2, 3)), np.ones(2)), np.zeros(3))


def test_damping_shortens() -> None:
    matrix = np.diag([1.0, 1e-3])
    (damped,) = minimum_norms(matrix[None], np.ones((1, 2)), damping=0.1)
    assert np.linalg.norm(damped) < np.linalg.norm(np.linalg.solve(matrix, np.ones(2)))


def test_descend_finds_a_root_to_round_off() -> None:
    found = descend(lambda x: (np.array([x[0] ** 2 - 2.0]), np.array([[2.0 * x[0]]])), np.array([1.0]))
    assert found.point[0] == pytest.approx(np.sqrt(2.0), abs=1e-15)


def test_descend_needs_its_damping_on_a_curved_valley() -> None:
    """Rosenbrock's valley, where whole Gauss-Newton steps overshoot first."""
    found = descend(
        lambda x: (np.array([10.0 * (x[1] - x[0] ** 2), 1.0 - x[0]]), np.array([[-20.0 * x[0], 10.0], [-1.0, 0.0]])),
        np.array([-1.2, 1.0]),
    )
    assert np.allclose(found.point, 1.0, atol=1e-12)


def test_descend_goes_on_from_undefined_trials() -> None:
    """sqrt(x) = 0.1 from x = 9: the first whole step leaves the domain."""

    def equations(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        with np.errstate(all="ignore"):
            root = np.sqrt(x)
        return root - 0.1, np.array([[0.5 / root[0]]])

    assert descend(equations, np.array([9.0])).point[0] == pytest.approx(0.01, abs=1e-14)


def test_descend_without_root_ends_at_the_smallest_residual() -> None:
    found = descend(lambda x: (x**2 + 1.0, 2.0 * x[None, :]), np.array([3.0]), iterations=200)
    assert found.size == pytest.approx(1.0, abs=1e-6)


def test_descend_from_nothing_defined() -> None:
    found = descend(lambda x: (np.array([np.nan]), np.array([[1.0]])), np.array([3.0]))
    assert found.size == np.inf


@settings(max_examples=examples(60), deadline=None)
@given(low_rank())
def test_elimination_tells_no_dependent_rows_for_independent(sample: tuple[np.ndarray, int]) -> None:
    matrix, expected = sample
    assert not independent(sparse(matrix)) or expected == len(matrix)


@settings(max_examples=examples(60), deadline=None)
@given(low_rank(), st.integers(0, 2**31))
def test_elimination_tells_no_singular_matrix_for_regular(sample: tuple[np.ndarray, int], seed: int) -> None:
    matrix, expected = sample
    n = min(matrix.shape)
    sizes = 10.0 ** np.random.default_rng(seed).uniform(-6.0, 6.0, 2 * n)
    scaled = sizes[:n, None] * matrix[:n, :n] * sizes[n:]
    assert not regular(sparse(scaled)) or expected >= n


def test_elimination_shows_that_a_chain_is_regular_in_any_units() -> None:
    n = 200
    chain = 2.0 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    sizes = 10.0 ** np.random.default_rng(7).uniform(-6.0, 6.0, (2, n))
    assert regular(sparse(sizes[0][:, None] * chain * sizes[1]))
    chain[[0, -1], [0, -1]] = 1.0  # free at both ends
    assert not regular(sparse(sizes[0][:, None] * chain * sizes[1]))


@pytest.mark.parametrize("n", [40, 400])
def test_elimination_shows_that_the_laws_of_a_ladder_are_independent(n: int) -> None:
    """Node i has the coils i and i + 1 and a capacitor; the ground has all capacitors and a wire that no other has."""
    laws = np.zeros((n + 1, 2 * n + 2))
    for i in range(n):
        laws[i, [i, i + 1, n + 1 + i]] = 1.0, -1.0, -1.0
        laws[n, n + 1 + i] = 1.0
    laws[n, [0, n]] = -1.0, 1.0
    assert not independent(sparse(laws))
    laws[n, -1] = 1.0
    assert independent(sparse(laws))
