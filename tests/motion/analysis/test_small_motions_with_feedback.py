"""Small motions of models with loads that depend on the accelerations that they cause, and of friction that sticks."""

from __future__ import annotations

import numpy as np
import pytest
from friction_texts import GEAR, SLOPE

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed


def test_the_loss_of_a_gear_damps_it() -> None:
    """2 a'' = drive + lam - 0.2 |lam| tanh(a') and 3 a''/4 = -4 lam: at rest lam = -3/35 drive."""
    found = lagdsl.compile(GEAR).linearize()
    np.testing.assert_allclose(found.A, [[0.0, 1.0], [0.0, -16.0 / 35.0 * 0.2 * 3.0 / 35.0]], rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(found.B[1], [16.0 / 35.0], rtol=1e-12)


def test_friction_that_sticks_is_a_constraint() -> None:
    found = lagdsl.compile(SLOPE).linearize()
    assert [each.name for each in found.states] == ["x"]
    np.testing.assert_array_equal(found.A, [[0.0]])


def test_a_load_without_a_derivative_is_told() -> None:
    """A point mass that is let go beside its pin does not pull at it for an instant."""
    model = lagdsl.compile("""
        model Released
          coordinate Angle phi(start = 0 rad);
          gravity = {0, -g_n, 0};
          frame arm = world.rotz(phi);
          mass 2 kg at arm.origin + 0.5 m*arm.x;
          torque -0.1 m*norm(reaction(arm).force) on phi;
        end Released;
    """)
    with pytest.raises(CompilationFailed) as raised:
        model.linearize()
    assert "E0855" in str(raised.value)
