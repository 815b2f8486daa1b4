"""Digits that are left where a body is carried along fast: docs/explanation/mechanics.md, section 2."""

from __future__ import annotations

import numpy as np
import pytest
from maximal_coordinates import spin_of, turned

import lagdsl

TEXT = """model Carried
  import Lag.Spatial.*;
  RevoluteDrive orbit(angle = 1e-3*time/(1 s));
  FixedTranslation arm(r = {%s m, 0, 0});
  Spherical attitude;
  Body satellite(m = 500, I = {100, 120, 80});
  gravity = 0;
  connect(world, orbit, arm, attitude, satellite);
end Carried;
"""


@pytest.mark.parametrize("radius", [1.0, 1e4, 7e6])
def test_carried_satellite_turns_as_a_free_one(radius):
    """Euler's equations, to the digits that m v^2 leaves."""
    model = lagdsl.compile(TEXT % radius)
    e, carried, w = np.array([0.8, 0.2, 0.4, 0.4]), np.array([0, 0, 1e-3]), np.array([0.01, 0.02, 0.03])
    rate = np.linalg.pinv(np.column_stack([spin_of(e, unit) for unit in np.eye(4)])) @ w
    I, spin = turned(e) @ np.diag([100.0, 120, 80]) @ turned(e).T, carried + w
    expected = np.linalg.solve(I, -np.cross(spin, I @ spin)) - np.cross(carried, w)
    left = 2.3e-16 * 500 * (1e-3 * radius) ** 2 / 80
    found = spin_of(e, model.forward_dynamics(0.0, e, rate))
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-14 + 2 * left)
