"""Two exported models, coupled through a force and a displacement, against the one model of both.

A trolley on a spring hands its displacement `x` to a pendulum on a sliding foot, which hands back the force `F` of the
spring between them.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from choice import chosen
from scipy.integrate import solve_ivp

import lagdsl
from fmi.exported import VERSIONS
from fmi.importing import Floats, Model, Slave, exchanged, slave
from fmi.texts import exported_text

TROLLEY = """
model Trolley
  parameter Mass m = 2 kg;
  parameter Stiffness k = 50 N/m;
  input Force F;
  coordinate Length s(start = 0.1 m);
  mass m at {s, 0};
  potential 1/2*k*s^2;
  force F on s;
  output Length x = s;
  annotation(experiment(StopTime = 2));
end Trolley;
"""
SWING = """
model Swing
  parameter Mass m = 0.5 kg;
  parameter Length l = 0.4 m;
  parameter Stiffness c = 80 N/m;
  input Length x;
  coordinate Length r(start = 0.05 m);
  coordinate Angle a(start = 30 deg);
  gravity = {0, -g_n};
  mass m at {r, 0};
  mass m at {r + l*sin(a), -l*cos(a)};
  force c*(x - r) on r;
  output Force F = c*(r - x);
  annotation(experiment(StopTime = 2));
end Swing;
"""
BOTH_IN_ONE = """
model TrolleyAndSwing
  coordinate Length s(start = 0.1 m), r(start = 0.05 m);
  coordinate Angle a(start = 30 deg);
  gravity = {0, -g_n};
  mass 2 kg at {s, 0};
  mass 0.5 kg at {r, 0};
  mass 0.5 kg at {r + 0.4 m*sin(a), -0.4 m*cos(a)};
  potential 1/2*50 N/m*s^2 + 1/2*80 N/m*(s - r)^2;
  annotation(experiment(StopTime = 2));
end TrolleyAndSwing;
"""
STOP = 2.0
BOTH = pytest.mark.parametrize("version", chosen(VERSIONS, [3]))  # the same functions stand behind both


def monolithic() -> Floats:
    """s, r, a at the end."""
    motion = lagdsl.compile(BOTH_IN_ONE, engine="tape").simulate(stop=STOP, tolerance=1e-11)
    return np.array([motion[name][-1] for name in ("s", "r", "a")])


def final(trolley: Slave | Model, swing: Slave | Model) -> Floats:
    return np.concatenate([trolley.get("s"), swing.get("r", "a")])


@BOTH
def test_model_exchange_of_both_in_one_integrator(version: int) -> None:
    with exchanged(exported_text(TROLLEY, version)) as trolley, exchanged(exported_text(SWING, version)) as swing:
        for one in (trolley, swing):
            one.initialize()
            assert one.update() == np.inf

        def slopes(t: float, x: Floats) -> Floats:
            trolley.move(t, x[:2])
            swing.move(t, x[2:])
            swing.set({"x": trolley.get("x")})
            trolley.set({"F": swing.get("F")})
            return np.concatenate([trolley.derivatives, swing.derivatives])

        begin = np.concatenate([trolley.states, swing.states])
        end = solve_ivp(slopes, (0.0, STOP), begin, method="DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
        slopes(STOP, end)
        np.testing.assert_allclose(final(trolley, swing), monolithic(), rtol=0, atol=1e-9)


def coupled(version: int, count: int) -> Floats:
    """Both step at once with what the other one had at the beginning of the step."""
    h = STOP / count
    with slave(exported_text(TROLLEY, version)) as trolley, slave(exported_text(SWING, version)) as swing:
        for one in (trolley, swing):
            one.initialize(stop=STOP, tolerance=1e-11)
        for k in range(count):
            swing.set({"x": trolley.get("x")})
            trolley.set({"F": swing.get("F")})
            trolley.step(k * h, h)
            swing.step(k * h, h)
        return final(trolley, swing)


@BOTH
def test_co_simulation_converges_with_the_step_of_the_master(version: int) -> None:
    """Held inputs make an error of first order in the step, which four steps extrapolate to 1e-6."""
    results = [coupled(version, count) for count in (400, 800, 1600, 3200)]
    expected = monolithic()
    errors = [np.max(np.abs(result - expected)) for result in results]
    orders = np.log2(errors[:-1]) - np.log2(errors[1:])
    assert np.all(np.abs(orders - 1.0) < [0.1, 0.05, 0.025])
    for order in range(1, 4):
        results = [(2**order * fine - coarse) / (2**order - 1) for coarse, fine in pairwise(results)]
    np.testing.assert_allclose(results[0], expected, rtol=0, atol=1e-6)


def value_and_slope(one: Slave, name: str) -> tuple[float, float]:
    reference = [one.fmu.variables[name].valueReference]
    return float(one.get(name)[0]), float(one.raw.getRealOutputDerivatives(reference, [1])[0])


def hermite(begin: tuple[float, float], end: tuple[float, float], h: float) -> list[float]:
    """Value and derivatives at the beginning of the cubic with these values and slopes at both ends."""
    jump = end[0] - begin[0]
    second = (6 * jump / h - 4 * begin[1] - 2 * end[1]) / h
    third = (6 * (begin[1] + end[1]) - 12 * jump / h) / h**2
    return [*begin, second, third]


def give(one: Slave, name: str, polynomial: list[float]) -> None:
    one.set({name: polynomial[0]})
    reference = one.fmu.variables[name].valueReference
    one.raw.setRealInputDerivatives([reference] * 3, [1, 2, 3], polynomial[1:])


def iterated(count: int) -> Floats:
    """Waveform iteration: steps are repeated until the cubics that the two hand to each other no longer change."""
    h = STOP / count
    with slave(exported_text(TROLLEY, 2)) as trolley, slave(exported_text(SWING, 2)) as swing:
        for one in (trolley, swing):
            one.initialize(stop=STOP, tolerance=1e-11)
        give(swing, "x", [*value_and_slope(trolley, "x"), 0.0, 0.0])
        give(trolley, "F", [*value_and_slope(swing, "F"), 0.0, 0.0])
        for k in range(count):
            at = k * h
            kept = [(one, one.raw.getFMUState()) for one in (trolley, swing)]
            x = x_begin = value_and_slope(trolley, "x")
            f = f_begin = value_and_slope(swing, "F")
            for _ in range(30):
                give(trolley, "F", hermite(f_begin, f, h))
                trolley.step(at, h, final=False)
                x_new = value_and_slope(trolley, "x")
                give(swing, "x", hermite(x_begin, x_new, h))
                swing.step(at, h, final=False)
                f_new = value_and_slope(swing, "F")
                change = max(np.max(np.abs(np.subtract(x_new, x))), np.max(np.abs(np.subtract(f_new, f))))
                x, f = x_new, f_new
                if change < 1e-8:
                    break
                for one, state in kept:
                    one.raw.setFMUState(state)
            else:
                raise AssertionError(f"no convergence at {at} s")
            for one, state in kept:
                one.raw.freeFMUState(state)
        return final(trolley, swing)


def test_waveform_iteration_with_rollback_is_the_one_model() -> None:
    """FMI 2: input polynomials, derivatives of outputs, steps taken back; cubics make an error of fourth order."""
    expected = monolithic()
    coarse, fine = (np.max(np.abs(iterated(count) - expected)) for count in (100, 200))
    assert fine < 1e-6
    assert np.log2(coarse / fine) > 3.5


def test_both_versions_are_the_same_motion_to_the_last_bit() -> None:
    """One instance behind two shells."""
    np.testing.assert_array_equal(coupled(2, 50), coupled(3, 50))


def test_the_derivatives_of_outputs_are_those_of_the_motion() -> None:
    with slave(exported_text(TROLLEY, 2)) as trolley:
        trolley.initialize(stop=STOP, tolerance=1e-10)
        trolley.step(0.0, 0.3)
        assert value_and_slope(trolley, "x")[1] == pytest.approx(trolley.get("der(s)")[0], rel=1e-12)
