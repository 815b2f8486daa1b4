"""The linear solver of the dynamics: both implementations, on systems with and without full rank."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lagdsl.engines.backends.python.support.linear import factorize, solve_system

Arrays = tuple[np.ndarray, ...]


def _rest(
    mass: np.ndarray, force: np.ndarray, rows: np.ndarray, bias: np.ndarray, a: np.ndarray, lam: np.ndarray
) -> float:
    """Residual that a and lam leave in both rows, as a part of the terms that stand there."""
    motion = np.abs(mass @ a - force - rows.T @ lam)
    terms = np.abs(mass) @ np.abs(a) + np.abs(force) + np.abs(rows.T) @ np.abs(lam)
    left = np.abs(rows @ a - bias)
    size = np.abs(rows) @ np.abs(a) + np.abs(bias)
    return float(max(np.max(motion / np.maximum(terms, 1e-300)), np.max(left / np.maximum(size, 1e-300), initial=0.0)))


def _draw(seed: int, n: int, m: int, rank: int, spread: float = 1.0) -> Arrays:
    draw = np.random.default_rng(seed)
    units = spread ** np.arange(n)
    b = draw.normal(size=(rank, n)) * units
    return b.T @ b, draw.normal(size=n) * units, draw.normal(size=(m, n)) * units, draw.normal(size=m)


@settings(deadline=None)
@given(st.integers(0, 10**6), st.integers(1, 12), st.integers(0, 4), st.booleans(), st.sampled_from([1.0, 10.0, 0.1]))
def test_little_is_left_whether_m_is_singular_or_not(seed: int, n: int, m: int, full: bool, spread: float) -> None:
    m = min(m, n // 2)
    system = _draw(seed, n, m, n if full else n - m, spread)
    a, lam, undetermined = solve_system(*system, m)
    assert undetermined == -1
    assert _rest(*system, a, lam) < 1e-13


@settings(deadline=None)
@given(st.integers(0, 10**6), st.integers(1, 3))
def test_dependent_rows_change_nothing_and_share_the_multipliers(seed: int, more: int) -> None:
    mass, force, rows, bias = _draw(seed, 6, 2, 6)
    mix = np.random.default_rng(seed + 1).normal(size=(more, 2)) * 10.0 ** np.arange(more)[:, None]
    all_rows, all_bias = np.vstack([rows, mix @ rows]), np.concatenate([bias, mix @ bias])
    a0, lam0, _ = solve_system(mass, force, rows, bias, 2)
    for bound in (2, 2 + more):
        a, lam, undetermined = solve_system(mass, force, all_rows, all_bias, bound)
        assert undetermined == -1
        assert _rest(mass, force, all_rows, all_bias, a, lam) < 1e-12
        np.testing.assert_allclose(a, a0, rtol=1e-8, atol=1e-8 * np.abs(a0).max())
        least = np.linalg.pinv(all_rows.T, rcond=1e-10) @ (rows.T @ lam0)
        np.testing.assert_allclose(lam, least, rtol=1e-7, atol=1e-7 * np.abs(least).max())


def test_a_zero_row_has_multiplier_zero() -> None:
    a, lam, _ = solve_system(
        np.diag([2.0, 3.0]), np.array([1.0, 5.0]), np.array([[0.0, 0.0], [1.0, 1.0]]), np.zeros(2), 2
    )
    assert lam[0] == 0.0
    np.testing.assert_allclose(a, [-0.8, 0.8], rtol=1e-15)
    np.testing.assert_allclose(lam[1], -2.6, rtol=1e-15)


def test_rows_that_all_vanish_hold_nothing() -> None:
    a, lam, undetermined = solve_system(np.eye(2), np.ones(2), np.zeros((1, 2)), np.zeros(1), 1)
    np.testing.assert_array_equal(a, [1.0, 1.0])
    assert lam[0] == 0.0
    assert undetermined == -1


def test_indefinite_mass() -> None:
    a, _, undetermined = solve_system(
        np.array([[1.0, 2.0], [2.0, -3.0]]), np.array([5.0, -4.0]), np.zeros((0, 2)), np.zeros(0), 0
    )
    np.testing.assert_allclose(a, [1.0, 2.0], rtol=1e-15)
    assert undetermined == -1


def test_rank_may_differ_from_state_to_state() -> None:
    mass = np.broadcast_to(np.eye(3), (3, 3, 3))
    rows = np.array([[[1.0, 0, 0], [0, 1.0, 0]], [[1.0, 1.0, 0], [2.0, 2.0, 0]], [[0, 0, 0], [0, 0, 1.0]]])
    a, lam, _ = solve_system(mass, np.tile([1.0, 3.0, 5.0], (3, 1)), rows, np.zeros((3, 2)), 2)
    np.testing.assert_allclose(a, [[0, 0, 5], [-1, 1, 5], [1, 3, 0]], atol=1e-14)
    np.testing.assert_allclose(lam, [[-1, -3], [-0.4, -0.8], [0, -5]], atol=1e-14)


@pytest.mark.parametrize(
    ("mass", "rows", "coordinate"),
    [
        (np.diag([1.0, 2.0, 0.0]), np.array([[1.0, 1.0, 0.0]]), 2),
        (np.zeros((2, 2)), np.zeros((0, 2)), 0),
        (np.array([[3.0, 0, 3], [0, 1, 0], [3, 0, 3]]), np.zeros((0, 3)), 0),
        (np.array([[1.0]]) * 0, np.zeros((1, 1)), 0),
    ],
)
def test_the_undetermined_coordinate_is_named(mass: np.ndarray, rows: np.ndarray, coordinate: int) -> None:
    n, m = mass.shape[0], rows.shape[0]
    _, _, undetermined = solve_system(mass, np.ones(n), rows, np.zeros(m), m)
    assert undetermined == coordinate


def test_what_is_no_number_stays_with_its_state() -> None:
    mass = np.array([[[2.0]], [[np.nan]], [[4.0]], [[1e200]]])
    a, lam, undetermined = solve_system(mass, np.full((4, 1), 8.0), np.zeros((4, 0, 1)), np.zeros((4, 0)), 0)
    np.testing.assert_array_equal(a, [[4.0], [np.nan], [2.0], [np.nan]])
    np.testing.assert_array_equal(undetermined, [-1, -1, -1, -1])
    assert lam.shape == (4, 0)


def test_no_unknowns() -> None:
    a, lam, undetermined = solve_system(np.zeros((0, 0)), np.zeros(0), np.zeros((1, 0)), np.zeros(1), 1)
    assert a.shape == (0,)
    np.testing.assert_array_equal(lam, [0.0])
    assert undetermined == -1


def test_many_right_hand_sides_are_solved_like_one() -> None:
    mass, _, rows, _ = _draw(5, 5, 2, 5)
    draw = np.random.default_rng(6)
    force, bias = draw.normal(size=(5, 4)), draw.normal(size=(2, 4))
    factors, finite = factorize(mass, rows, 2)
    a, lam = factors.solve(force, bias)
    assert finite
    for k in range(4):
        one = solve_system(mass, force[:, k], rows, bias[:, k], 2)
        np.testing.assert_allclose(a[:, k], one[0], rtol=1e-13)
        np.testing.assert_allclose(lam[:, k], one[1], rtol=1e-13)
