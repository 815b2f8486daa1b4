"""The bound that saves most models the eigenvalues."""

from __future__ import annotations

import numpy as np
import pytest

from lagdsl.simulate.stiffness import Stiffness, fastest_decay, radius_bound


@pytest.mark.parametrize("size", [1, 3, 20])
@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_no_eigenvalue_is_beyond_the_bound_and_it_is_near(size: int, scale: float) -> None:
    generator = np.random.default_rng(size)
    matrix = generator.standard_normal((size, size)) * scale
    none, one = np.zeros((size, size)), np.eye(size)
    jacobian = np.block([[none, one], [-matrix @ matrix.T - one, -0.1 * one]])
    largest = np.max(np.abs(np.linalg.eigvals(jacobian)))
    assert largest * (1.0 - 1e-12) <= radius_bound(jacobian) <= 1.1 * largest


def test_matrices_without_a_radius() -> None:
    assert radius_bound(np.zeros((0, 0))) == 0.0
    assert radius_bound(np.array([[0.0, 1.0], [0.0, 0.0]])) == 0.0
    assert radius_bound(np.full((2, 2), np.nan)) == np.inf


@pytest.mark.parametrize("decay", [1.0, 30.0, 40.0, 1000.0])
def test_the_bound_changes_no_decision(decay: float) -> None:
    jacobian = np.array([[0.0, 1.0], [-decay, -decay - 1.0]])
    stiffness = Stiffness()
    asked = [stiffness.seems_stiff(0.1, lambda: jacobian) for _ in range(60)]
    assert asked[-1] == (0.1 * fastest_decay(jacobian) > 3.5)
    assert not any(asked[:-1])
