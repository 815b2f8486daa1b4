"""Loads that depend on the accelerations and multipliers that they cause, in the functions that users call."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from choice import engines
from friction_texts import BEARING, GEAR
from scipy.optimize import brentq

import lagdsl
from lagdsl.engines.backends.registry import BACKENDS

M, L, G, MU = 2.0, 0.5, 9.80665, 0.01
SLIDING = {"direction(journal)": 1.0}
EVERY = pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))


def acceleration(phi: float, rate: float) -> float:
    """Of the pendulum whose pin rubs, which is held by M (a_P - g) with a_P of the point mass."""

    def missing(alpha: float) -> float:
        along = M * (-L * rate**2 + G * np.sin(phi))
        across = M * (L * alpha + G * np.cos(phi))
        return float(M * L**2 * alpha + M * G * L * np.cos(phi) + MU * np.hypot(along, across))

    return float(brentq(missing, -100.0, 100.0, xtol=1e-15, rtol=1e-15))


@EVERY
def test_accelerations_are_those_of_the_loads_that_they_cause(engine: Any) -> None:
    model = lagdsl.compile(BEARING, engine=engine)
    phi, rate = np.array([[0.3], [-0.5], [2.0]]), np.array([[3.0], [0.5], [4.0]])
    found = model.forward_dynamics(0.0, phi, rate, w=SLIDING)
    expected = [acceleration(a, b) for a, b in zip(phi[:, 0], rate[:, 0], strict=True)]
    np.testing.assert_allclose(found[:, 0], expected, rtol=1e-12)
    pin, torque = model.output(0.0, phi, rate, w=SLIDING).T
    np.testing.assert_allclose(torque, -MU * pin, rtol=1e-12)
    free = model.forward_dynamics(0.0, phi, rate)  # it neither sticks nor slides in a sense
    np.testing.assert_allclose(free[:, 0], -G / L * np.cos(phi[:, 0]), rtol=1e-13)


@EVERY
def test_derivatives_follow_the_loads(engine: Any) -> None:
    model = lagdsl.compile(BEARING, engine=engine)
    phi, rate, h = 0.3, 3.0, 1e-5
    found = model.state_jacobian(0.0, [phi], [rate], w=SLIDING)[1]
    expected = [
        (acceleration(phi + h, rate) - acceleration(phi - h, rate)) / (2 * h),
        (acceleration(phi, rate + h) - acceleration(phi, rate - h)) / (2 * h),
    ]
    np.testing.assert_allclose(found, expected, rtol=1e-8)
    outputs = model.output_jacobian(0.0, [phi], [rate], w=SLIDING)
    np.testing.assert_allclose(outputs[1], -MU * outputs[0], rtol=1e-12)


@EVERY
def test_a_gear_that_loses_a_part_of_its_force(engine: Any) -> None:
    model = lagdsl.compile(GEAR, engine=engine)
    rate = 2.0
    loss = 0.2 * np.tanh(rate)
    lam = -1.0 / (1.0 + 32.0 / 3.0 + loss)  # 2 alpha = drive + lam - loss |lam|, 3 alpha/4 = -4 lam
    state = (0.0, [0.4, 0.1], [rate, rate / 4.0])
    np.testing.assert_allclose(model.multipliers(*state), [lam], rtol=1e-12)
    np.testing.assert_allclose(model.forward_dynamics(*state), np.array([1.0, 0.25]) * -16.0 / 3.0 * lam, rtol=1e-12)
    by_drive = model.input_jacobian(*state)[2:, 0]
    np.testing.assert_allclose(by_drive, np.array([1.0, 0.25]) * -16.0 / 3.0 * lam, rtol=1e-12)  # it is proportional


def test_the_numpy_module_finds_them_too() -> None:
    program = lagdsl.compile(BEARING)._compilation.program
    (text,) = BACKENDS["numpy"].emit(program).files.values()
    module: dict[str, Any] = {}
    exec(compile(text, "generated", "exec", dont_inherit=True), module)
    found = module["forward_dynamics"](0.0, [0.3], [3.0], w=SLIDING)
    np.testing.assert_allclose(found, [acceleration(0.3, 3.0)], rtol=1e-12)


def test_no_loads_are_an_error() -> None:
    """With the force lam = -3/35 (1 N.m + L) between the wheels, L = 140 lam^2/(1 N.m) has no solution."""
    text = GEAR.replace("-0.2*abs(multiplier(mesh))*tanh(der(a)/(1 rad/s))", "140/(1 N.m)*multiplier(mesh)^2")
    with pytest.raises(ArithmeticError, match="not found"):
        lagdsl.compile(text).forward_dynamics(0.0, [0.0, 0.0], [0.0, 0.0])
