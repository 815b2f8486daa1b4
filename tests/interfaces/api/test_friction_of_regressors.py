"""Columns of friction in the regressor."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import lagdsl

ARM = """model Arm "Two links with damping of a joint, a damper between both, and a joint that rubs"
  parameter Torque rub = 0.4 N.m;
  parameter Real d(unit = "N.m.s") = 0.7 N.m.s, e(unit = "N.m.s") = 0.2 N.m.s;
  coordinate Angle a, b;
  frame upper = world.rotz(a);
  frame lower = upper.move({0.7 m, 0, 0}).rotz(b);
  body first(m = 2 kg, com = {0.3 m, 0, 0}, I = {0, 0, 0.11 kg.m2}) on upper;
  body second(m = 1.5 kg, com = {0.25 m, 0, 0}, I = {0, 0, 0.05 kg.m2}) on lower;
  gravity = -g_n*world.y;
  dissipation 1/2*d*der(a)^2;
  dissipation 1/2*e*(der(a) - 2*der(b))^2;
  friction brake: der(b) with limit = rub;
end Arm;
"""
SLIDER = """model Slider "What has no coefficient: damping that depends on the place, a limit that depends on it"
  coordinate Length x(start = 1 m), y;
  mass 2 kg at {x, y};
  dissipation 1/2*(3 N.s/m2)*x*der(x)^2;
  dissipation 1/2*(5 N.s/m)*der(y)^2;
  friction track: der(x) with limit = 2 N/m*sqrt(x^2 + 1 m2);
end Slider;
"""


@cache
def model(source: str, engine: str = "tape") -> lagdsl.Model:
    return lagdsl.compile(source, engine=engine)


def states(rows: int = 5) -> tuple[np.ndarray, ...]:
    return tuple(np.random.default_rng(2).normal(size=(3, rows, 2)))


@pytest.mark.parametrize("engine", ["tape", "numpy"])
def test_damping_and_dry_friction_have_columns(engine: str) -> None:
    arm = model(ARM, engine)
    assert arm.inertial_parameter_names[20:] == ["damping(a)", "damping(a, b)", "damping(b)", "limit(brake)"]
    np.testing.assert_allclose(arm.inertial_parameters()[20:], [0.7 + 0.2, -0.4, 0.8, 0.4], rtol=1e-15)
    np.testing.assert_allclose(arm.inertial_parameters(parameters={"rub": 3.0, "d": 1.0})[20:], [1.2, -0.4, 0.8, 3.0])
    q, qd, qdd = states()
    columns = arm.regressor(0.0, q, qd, qdd)[..., 20:]
    zero = 0 * qd[:, 0]
    first = np.stack([qd[:, 0], qd[:, 1], zero, zero], -1)
    second = np.stack([zero, qd[:, 0], qd[:, 1], np.sign(qd[:, 1])], -1)
    np.testing.assert_array_equal(columns, np.stack([first, second], axis=1))


def test_regressor_and_parameters_are_the_whole_of_inverse_dynamics() -> None:
    """With the mode of sliding and the sense of each slip in w."""
    arm = model(ARM)
    q, qd, qdd = states()
    w = np.stack([0 * qd[:, 1], np.sign(qd[:, 1])], -1)  # sticks, direction
    product = arm.regressor(0.0, q, qd, qdd) @ arm.inertial_parameters()
    np.testing.assert_allclose(product, arm.inverse_dynamics(0.0, q, qd, qdd, w=w), atol=1e-12)


def test_coefficients_of_friction_are_base_parameters() -> None:
    """Six of the bodies, as in `test_by_name`, and each of friction for itself."""
    base = model(ARM).base_parameters
    assert len(base.names) == 6 + 4
    assert base.names[6:] == ("damping(a)", "damping(a, b)", "damping(b)", "limit(brake)")


def test_least_squares_finds_the_coefficients() -> None:
    """From efforts that another model makes: the base parameters of this one with its own."""
    arm, base = model(ARM), model(ARM).base_parameters
    other = {"rub": 0.9, "d": 0.1, "e": 0.6}
    q, qd, qdd = states(40)
    w = np.stack([0 * qd[:, 1], np.sign(qd[:, 1])], -1)
    efforts = arm.inverse_dynamics(0.0, q, qd, qdd, w=w, p=other)
    stacked = arm.regressor(0.0, q, qd, qdd)[..., list(base.columns)].reshape(-1, len(base.columns))
    found = np.linalg.lstsq(stacked, efforts.ravel(), rcond=None)[0]
    np.testing.assert_allclose(found[6:], [0.1 + 0.6, -1.2, 2.4, 0.9], atol=1e-10)


def test_what_depends_on_the_place_has_no_column() -> None:
    slider = model(SLIDER)
    assert slider.inertial_parameter_names == ["mass[1].m", "damping(y)"]
    rest = slider.inverse_dynamics(0.0, [2.0, 0.0], [1.5, 4.0], [0.0, 0.0], w=[0.0, 1.0])
    rest = rest - slider.regressor(0.0, [2.0, 0.0], [1.5, 4.0], [0.0, 0.0]) @ slider.inertial_parameters()
    np.testing.assert_allclose(rest, [3 * 2.0 * 1.5 + 2 * np.sqrt(5.0), 0.0], rtol=1e-14)
