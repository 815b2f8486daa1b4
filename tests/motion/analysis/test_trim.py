"""Equilibria and steady motions, and what is said where there are none."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import repeats

import lagdsl

MODELS = Path(__file__).parents[3] / "models"
G_N = 9.80665


def test_governor_at_constant_speed() -> None:
    """cos(theta) = g/(l w^2): the arms of a governor that turns, from elsewhere."""
    text = """model Governor
      parameter AngularVelocity w = 6 rad/s;
      coordinate Angle theta(start = 30 deg);
      frame arm = world.rotz(w*time).roty(-theta);
      gravity = -g_n*world.z;
      mass 1 kg at -(0.5 m)*arm.z;
    end Governor;
    """
    found = lagdsl.compile(text).trim()
    assert abs(found.point.q[0]) == pytest.approx(np.arccos(G_N / (0.5 * 36)), abs=1e-12)
    assert found.steadiness.kind == "equilibrium"
    assert found.residual < 1e-12


def test_an_input_that_balances() -> None:
    text = """model Arm
      input Torque tau;
      coordinate Angle theta(start = 0.5 rad);
      gravity = -g_n*world.y;
      mass 2 kg at {sin(theta), -cos(theta)}*(1 m);
      torque tau on theta;
    end Arm;
    """
    model = lagdsl.compile(text)
    found = model.trim(free=["tau"], hold=["theta"])
    assert found.point.u[0] == pytest.approx(2 * G_N * np.sin(0.5), rel=1e-12)
    assert found.unknowns == ("tau",)
    np.testing.assert_allclose(found.point.q, [0.5])


def test_states_come_to_rest() -> None:
    text = """model Tank
      coordinate Length x;
      state Real z(start = 0.2);
      gravity = 0;
      mass 1 kg at {x, 0};
      potential 1/2*(4 N/m)*x^2;
      force (2 N)*z on x;
    equation
      der(z) = (1 - z)/(1 s);
    end Tank;
    """
    found = lagdsl.compile(text).trim()
    np.testing.assert_allclose([found.point.q[0], found.point.z[0]], [0.5, 1.0], atol=1e-12)


def test_a_coin_rolls_in_a_circle() -> None:
    """Lean, turning and spinning rates of a disc in a steady turn, one equation between three numbers."""
    model = lagdsl.compile(MODELS / "rolling_hoop.lag")
    found = model.trim(
        free=["der(psi)"], hold=["lean"], steady=True, q={"lean": 0.2}, qd={"psi": 1.0, "spin": 6.0, "lean": 0.0}
    )
    _, _, _, lean, _ = found.point.q
    turn, reroll = found.point.qd[2], found.point.qd[4]
    assert found.steadiness.kind == "steady motion"
    assert set(found.steadiness.running) == {"x", "psi", "spin"}  # y is about to
    a, c, radius = 0.25, 0.5, 0.3  # of m R^2
    spin = reroll + turn * np.sin(lean)
    # (C + m R^2) w_spin w_turn cos - A w_turn^2 sin cos + m g R sin = 0
    balance = (c + 1) * spin * turn * np.cos(lean) - a * turn**2 * np.sin(lean) * np.cos(lean)
    assert balance + G_N / radius * np.sin(lean) == pytest.approx(0, abs=1e-10)
    modes = model.modes(q=found.point.q, qd=found.point.qd)
    assert modes.steadiness.kind == "steady motion"


def test_e0852_of_a_mass_in_free_fall() -> None:
    text = """model Falls
      coordinate Length x, y;
      gravity = -g_n*world.y;
      mass 1 kg at {x, y};
      potential 1/2*(3 N/m)*x^2;
    end Falls;
    """
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        lagdsl.compile(text).trim()
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.code == "E0852"
    assert "der(der(y)) = -9.807 m/s2" in diagnostic.notes[0]
    assert "closest configuration" in diagnostic.notes[1]


@repeats("test_diagnostics_leave_with_status_one in tests/interfaces/cli")
def test_e0852_names_what_was_not_free() -> None:
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        lagdsl.compile(MODELS / "four_bar_angles.lag").trim()
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.notes[-1] == "not free: `a`"


def test_e0853_of_a_name_that_is_none() -> None:
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        lagdsl.compile(MODELS / "pendulum.lag").trim(free=["q"])
    assert [d.code for d in failure.value.diagnostics] == ["E0853"]
