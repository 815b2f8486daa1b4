"""Random problems of contacts with friction: the runtime's solver satisfies the law, finds what trying all modes finds,
and gains no energy."""

from __future__ import annotations

import numpy as np
import pytest
from choice import ALL
from stepping.friction_in_c import solved_in_c
from stepping.friction_problems import (
    Floats,
    RandomProblem,
    Solver,
    bounced,
    energy_gained,
    enumerated,
    random_problem,
    residual,
)

COUNT = 1000 if ALL else 100
# Contacts of problems of which all modes are tried: 4^n.
MOST = 6 if ALL else 4
EXACT = 1e-12

SOLVERS = pytest.mark.parametrize("solve", [solved_in_c])


def _problems(planar: bool, most: int = 12, count: int = COUNT) -> list[tuple[int, RandomProblem]]:
    return [(seed, random_problem(seed, planar, most)) for seed in range(count)]


@SOLVERS
@pytest.mark.parametrize("planar", [False, True], ids=["scalar", "planar"])
def test_forces_satisfy_the_law(solve: Solver, planar: bool) -> None:
    found = {seed: (problem, solve(problem)) for seed, problem in _problems(planar)}
    assert [seed for seed, (_, f) in found.items() if f is None] == []
    left = {seed: residual(problem, f) for seed, (problem, f) in found.items() if f is not None}
    assert {seed: each for seed, each in left.items() if not each <= EXACT} == {}


@SOLVERS
def test_rates_are_those_of_the_only_mode(solve: Solver) -> None:
    """It finds one of several modes that hold."""
    wrong = {}
    for seed, problem in _problems(planar=False, most=MOST, count=COUNT // 4):
        f = solve(problem)
        assert f is not None, seed
        g = problem.G @ f + problem.c
        apart = min((np.max(np.abs(g - other)) for other in enumerated(problem)), default=np.inf)
        if apart > 1e-8 * np.max(np.abs(problem.c)):
            wrong[seed] = apart
    assert wrong == {}


@SOLVERS
@pytest.mark.parametrize("planar", [False, True], ids=["scalar", "planar"])
@pytest.mark.parametrize("e", [0.0, 0.7, 1.0])
def test_blows_gain_no_energy(solve: Solver, planar: bool, e: float) -> None:
    for seed, problem in _problems(planar, count=COUNT // 5):
        if "impulses" not in problem.kind:
            continue
        blow = bounced(problem, e, solve)
        assert blow is not None, seed
        assert energy_gained(problem, *blow) <= EXACT, seed
        assert np.min(blow[1][: problem.contacts]) >= -1e-10 * np.max(np.abs(problem.c)), seed


# ---- the measure is one ----------------------------------------------------------------------------------------------


def _slides() -> RandomProblem:
    """A block of 2 kg, pushed by 9 N on a floor with mu = 0.2, g = 10: N = 20, friction 4 N against the push."""
    none = np.zeros(1)
    return RandomProblem("accelerations", np.eye(2) / 2, np.array([-10.0, 4.5]), 1, (1,), none, np.array([[0.2]]))


def test_a_block_that_slides() -> None:
    (g,) = enumerated(_slides())
    np.testing.assert_allclose(g, [0.0, 2.5], atol=1e-12)
    assert residual(_slides(), np.array([20.0, -4.0])) < 1e-15


@pytest.mark.parametrize(
    "wrong", [[20.0, 4.0], [20.0, -9.0], [20.0, -3.9], [20.0, 0.0], [21.0, -4.2], [19.0, -3.8], [0.0, 0.0], [-1.0, 0.2]]
)
def test_wrong_forces_leave_a_residual(wrong: list[float]) -> None:
    assert residual(_slides(), np.array(wrong)) > 1e-4


def test_a_force_that_is_slightly_wrong_is_seen() -> None:
    problem = random_problem(5, planar=True, most=6)
    f = solved_in_c(problem)
    assert f is not None
    for row in np.flatnonzero(np.abs(f) > 1e-3):
        changed: Floats = f.copy()
        changed[row] *= 1 + 1e-7
        assert residual(problem, changed) > 1e-10


def test_a_seed_is_one_problem() -> None:
    first, again, other = (random_problem(seed, planar=True) for seed in (3, 3, 7))
    np.testing.assert_array_equal(first.G, again.G)
    assert first.G.shape != other.G.shape or not np.array_equal(first.G, other.G)
