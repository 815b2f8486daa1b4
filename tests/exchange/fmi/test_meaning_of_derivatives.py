"""Directional derivatives of FMUs are partial ones of the equations where it stands; importers integrate them."""

from __future__ import annotations

from math import cos, sin

import numpy as np
import pytest
from fmpy.simulation import FMICallException
from scipy.integrate import solve_ivp

from fmi.importing import Floats, exchanged, slave
from fmi.texts import exported_text

G, L = 9.81, 0.5
PENDULUM = """
model Swung "With a torque; x is where the mass is"
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 1 rad);
  input Torque u;
  gravity = {0, -9.81 m/s2};
  mass 1 kg at {l*sin(theta), -l*cos(theta)};
  torque u on theta;
  output Length x = l*sin(theta);
end Swung;
"""
BALL = """
model Thrown
  parameter Real e = 0.8;
  coordinate Length h(start = 1 m);
  gravity = {0, -10 m/s2};
  mass 1 kg at {0, h};
  contact floor: h >= 0 with restitution = e;
  output Velocity v = der(h);
end Thrown;
"""
VERSIONS = pytest.mark.parametrize("version", [2, 3])


@VERSIONS
def test_at_a_communication_point_they_are_partial_ones_with_the_states_held(version: int) -> None:
    fmu = exported_text(PENDULUM, version)
    with slave(fmu) as one:
        one.initialize()
        for k in range(4):
            one.step(0.1 * k, 0.1)
        theta, x = one.get("theta", "x")
        assert x == pytest.approx(L * sin(theta), abs=1e-14)
        unknowns, knowns = ["x", "der(theta,2)"], ["theta", "l", "u"]
        found = np.array([one.directional(unknowns, knowns, unit) for unit in np.eye(3)]).T
        exact = [[L * cos(theta), sin(theta), 0.0], [-G / L * cos(theta), G / L**2 * sin(theta), 1 / L**2]]
        np.testing.assert_allclose(found, exact, rtol=1e-12, atol=1e-14)


@VERSIONS
def test_what_a_step_does_is_no_part_of_them(version: int) -> None:
    """x depends on u through the step, but not in the equations: the description does not list u, and says with that
    that the derivative is zero (FMI 3.0.1, 2.4.8; FMI 2.0.5, 2.2.8)."""
    fmu = exported_text(PENDULUM, version)
    ends = []
    for torque in (0.0, 1e-3):
        with slave(fmu) as one:
            one.initialize({"u": torque})
            one.step(0.0, 0.5)
            ends.append(one.get("x")[0])
            assert one.directional(["x"], ["u"], np.ones(1)) == [0.0]
    assert abs(ends[1] - ends[0]) > 1e-4
    (item,) = (each for each in fmu.description.outputs if each.variable.name == "x")
    assert [each.name for each in item.dependencies if each.name in ("theta", "u")] == ["theta"]


def test_behind_an_impact_the_restitution_changes_nothing_at_a_held_state() -> None:
    with slave(exported_text(BALL, 2)) as one:
        one.initialize()
        one.step(0.0, 0.6)  # t1 = sqrt(2 h/g) = 0.447 s
        assert one.get("v")[0] == pytest.approx(0.8 * 20**0.5 - 10 * (0.6 - 0.2**0.5), abs=1e-8)
        found = one.directional(["v", "der(h,2)"], ["der(h)", "h", "e"], np.array([1.0, 1.0, 1.0]))
        np.testing.assert_array_equal(found, [1.0, 0.0])


def test_an_importer_integrates_them_along_a_smooth_motion() -> None:
    """s' = f_x s + f_l. From rest theta = f(t sqrt(g/l)), so l dtheta/dl = -t der(theta)/2."""
    with exchanged(exported_text(PENDULUM, 3)) as one:
        one.initialize()
        one.update()
        rates = [item.variable.name for item in one.fmu.description.derivatives]
        states = [item.variable.derivative.name for item in one.fmu.description.derivatives]

        def f(t: float, y: Floats) -> Floats:
            one.move(t, y[:2])
            return np.concatenate([one.derivatives, one.directional(rates, [*states, "l"], np.append(y[2:], 1.0))])

        first = np.concatenate([one.states, np.zeros(2)])
        end = solve_ivp(f, (0.0, 2.0), first, method="DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
    assert end[2] == pytest.approx(-end[1] / L, abs=1e-9)


@VERSIONS
def test_initialization_has_those_of_the_start(version: int) -> None:
    with slave(exported_text(PENDULUM, version)) as one:
        if version == 2:
            one.raw.setupExperiment()
        one.raw.enterInitializationMode()
        found = one.directional(["x", "der(theta,2)"], ["theta", "l"], np.array([1.0, 0.0]))
        np.testing.assert_allclose(found, [L * cos(1.0), -G / L * cos(1.0)], rtol=1e-12)


@VERSIONS
def test_before_initialization_and_for_what_is_no_known_they_are_errors(version: int) -> None:
    with slave(exported_text(PENDULUM, version)) as one, pytest.raises(FMICallException):
        one.directional(["x"], ["theta"], np.ones(1))
    with slave(exported_text(PENDULUM, version)) as one:
        one.initialize()
        with pytest.raises(FMICallException):
            one.directional(["x"], ["der(theta,2)"], np.ones(1))
        one.step(0.0, 0.1)  # the instance is as it was
        assert one.directional(["x"], ["l"], np.ones(1))[0] == pytest.approx(sin(one.get("theta")[0]), rel=1e-12)
