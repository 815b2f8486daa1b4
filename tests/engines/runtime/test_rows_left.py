"""Multipliers of rows that elimination left to run time, against the dense solution of the whole system."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lagdsl.engines.backends.python.support.delassus import solve_kept
from lagdsl.engines.backends.python.support.linear import solve_system

Arrays = tuple[np.ndarray, ...]


def _draw(seed: int, n: int, m: int) -> Arrays:
    draw = np.random.default_rng(seed)
    b = draw.normal(size=(n, n))
    return b.T @ b + 0.1 * np.eye(n), draw.normal(size=n), draw.normal(size=(m, n)), draw.normal(size=m)


def _left(system: Arrays, kept: tuple[int, ...]) -> Arrays:
    """Results of elimination that solves for all multipliers but those of `kept`: a, l, Y, K, J, g."""
    mass, force, rows, bias = system
    others = [i for i in range(len(bias)) if i not in kept]

    def solution(f: np.ndarray, g: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        a, of_others, _ = solve_system(mass, f, rows[others], g, len(others))
        lam = np.zeros(len(bias))
        lam[others] = of_others
        return a, lam

    a, lam = solution(force, bias[others])
    adds = [solution(rows[i], np.zeros(len(others))) for i in kept]
    response = np.array([y for y, _ in adds]).reshape(len(kept), len(a))
    return a, lam, response, np.array([k for _, k in adds]).reshape(len(kept), len(lam)), rows[[*kept]], bias[[*kept]]


def _independent(rows: np.ndarray, rank: int) -> list[int]:
    """Any as many as are independent, those of zeros last."""
    return sorted(range(rows.shape[-2]), key=lambda row: not rows[..., row, :].any())[:rank]


def _solve(left: Sequence[np.ndarray], kept: tuple[int, ...], rank: int) -> Arrays:
    a, lam, response, adds, rows, bias = left
    independent = _independent(rows, rank)
    flags = tuple(row in independent for row in range(len(kept)))
    return solve_kept(a, lam, response, adds, rows, bias, kept, flags)


def _rest(system: Arrays, a: np.ndarray, lam: np.ndarray) -> float:
    """Residual that a and lam leave in both rows, as a part of the terms that stand there."""
    mass, force, rows, bias = system
    motion = np.abs(mass @ a - force - rows.T @ lam)
    terms = np.abs(mass) @ np.abs(a) + np.abs(force) + np.abs(rows.T) @ np.abs(lam)
    left = np.abs(rows @ a - bias) / np.maximum(np.abs(rows) @ np.abs(a) + np.abs(bias), 1e-300)
    return float(max(np.max(motion / terms), np.max(left, initial=0.0)))


@settings(deadline=None)
@given(st.integers(0, 10**6), st.integers(2, 12), st.integers(1, 5), st.data())
def test_any_rows_may_be_left(seed: int, n: int, m: int, data: st.DataObject) -> None:
    m = min(m, n // 2)
    kept = tuple(i for i in range(m) if data.draw(st.booleans()) or i == 0)
    system = _draw(seed, n, m)
    a, lam, sound = _solve(_left(system, kept), kept, len(kept))
    assert sound
    assert _rest(system, a, lam) < 1e-12


@settings(deadline=None)
@given(st.integers(0, 10**6), st.integers(1, 3), st.sampled_from([(0, 1, 2, 3), (1, 2, 3), (2, 3), ()]))
def test_dependent_rows_share_as_in_the_dense_solution(seed: int, more: int, left: tuple[int, ...]) -> None:
    mass, force, rows, bias = _draw(seed, 8, 4)
    mix = np.random.default_rng(seed + 1).normal(size=(more, 2)) * 10.0 ** np.arange(more)[:, None]
    system = mass, force, np.vstack([rows, mix @ rows[2:]]), np.concatenate([bias, mix @ bias[2:]])
    kept = (*left, *range(4, 4 + more))
    a, lam, sound = _solve(_left(system, kept), kept, len(left))
    assert sound
    assert _rest(system, a, lam) < 1e-12
    a0, lam0, _ = solve_system(*system, 4)
    np.testing.assert_allclose(a, a0, rtol=1e-9, atol=1e-9 * np.abs(a0).max())
    np.testing.assert_allclose(lam, lam0, rtol=1e-8, atol=1e-8 * np.abs(lam0).max())


@pytest.mark.parametrize("power", range(1, 12))
def test_nearly_dependent_rows_are_solved_well_or_left_to_the_dense_solution(power: int) -> None:
    mass, force, rows, bias = _draw(power, 6, 3)
    rows[2] = rows[0] + 10.0**-power * rows[2]
    system = mass, force, rows, bias
    a, lam, sound = _solve(_left(system, (0, 1, 2)), (0, 1, 2), 3)
    assert sound == (power <= 2) or power == 3
    if sound:
        assert _rest(system, a, lam) < 1e-12


def test_rows_that_are_not_dependent_after_all_are_left_to_the_dense_solution() -> None:
    mass, force, rows, bias = _draw(3, 6, 3)
    rows[2] = rows[0] + rows[1]
    rows[2, 0] += 1e-3
    *_, sound = _solve(_left((mass, force, rows, bias), (0, 1, 2)), (0, 1, 2), 2)
    assert not sound


def test_rows_of_zeros() -> None:
    system = np.diag([2.0, 3.0]), np.array([1.0, 5.0]), np.array([[0.0, 0.0], [1.0, 1.0]]), np.zeros(2)
    a, lam, sound = _solve(_left(system, (0, 1)), (0, 1), 1)
    assert sound
    assert lam[0] == 0.0
    np.testing.assert_allclose(a, [-0.8, 0.8], rtol=1e-15)
    np.testing.assert_allclose(lam[1], -2.6, rtol=1e-15)
    open_contact = _solve(_left(system, (0, 1)), (0, 1), 2)
    assert open_contact[2]
    np.testing.assert_allclose(open_contact[0], a, rtol=1e-15)
    np.testing.assert_allclose(open_contact[1], lam, rtol=1e-15)
    nothing = system[0], system[1], np.zeros((2, 2)), np.zeros(2)
    a, lam, sound = _solve(_left(nothing, (0, 1)), (0, 1), 0)
    assert sound
    np.testing.assert_array_equal(lam, [0.0, 0.0])


def test_states_stand_beside_each_other() -> None:
    """One is singular, one no number: they say so, and the others are what they are alone."""
    parts = [_left(_draw(seed, 5, 2), (0, 1)) for seed in range(4)]
    parts[1][4][1], parts[1][2][1] = parts[1][4][0], parts[1][2][0]
    parts[2][2][0, 0] = np.nan
    stacked = [np.stack([part[i] for part in parts]) for i in range(6)]
    a, lam, sound = _solve(stacked, (0, 1), 2)
    np.testing.assert_array_equal(sound, [True, False, False, True])
    for i in (0, 3):
        alone = _solve(parts[i], (0, 1), 2)
        np.testing.assert_allclose(a[i], alone[0], rtol=1e-13)
        np.testing.assert_allclose(lam[i], alone[1], rtol=1e-13)
