"""Derivatives of motions in steps of fixed length are those of what the formulas compute; starts and positions that
have none are told."""

from __future__ import annotations

from math import sqrt
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import lagdsl

MODELS = Path(__file__).parents[3] / "models"

COUPLED = """
model Coupled "Nonlinear, damped, with a state of first order and an input"
  parameter Mass m = 2 kg;
  parameter Real c = 0.3, a = 2;
  input Force u = 0.5 N;
  coordinate Length x(start = 0.3 m, der(start = 0.1 m/s)), y(start = 1 m);
  state Real z(start = 0.2);
  mass m at {x, y};
  potential (8 N/m)*(x^2/2 + sin(y/(1 m))*x*(1 m));
  force u - c*der(x)*(1 N.s/m) on x;
  output Force pull = (8 N/m)*x;
equation
  der(z) = (a*x/(1 m) - z^3)/(1 s);
end Coupled;
"""
BALL = """
model Ball
  parameter Real e = 0.8;
  coordinate Length h(start = 1 m);
  mass 1 kg at {0, h};
  gravity = {0, -9.81 m/s2};
  contact floor: h >= 0 with restitution = e;
end Ball;
"""
VALUES = {"m": 2.0, "c": 0.3, "a": 2.0, "u": 0.5, "x.start": 0.3, "y.start": 1.0, "z.start": 0.2}
COLUMNS = ("x", "der(y)", "z", "pull")


def _moved(model: lagdsl.Model, name: str, value: float, solver: str) -> NDArray[np.float64]:
    """(columns, rows): the motion in coarse steps, with rows within them."""
    given = {"start": {}, "inputs": {}, "parameters": {}}
    kind = "start" if name.endswith(".start") else "inputs" if name == "u" else "parameters"
    given[kind] = {name.removesuffix(".start"): value}
    motion = model.simulate(stop=1.0, interval=0.07, solver=solver, step=0.1, **given)  # type: ignore[arg-type]
    return np.array([motion[of] for of in COLUMNS])


@pytest.mark.parametrize("solver", ["rk4", "leapfrog", "ros2", "dop853", "radau"])
def test_a_column_does_not_depend_on_how_many_there_are(solver: str) -> None:
    """Blocks of eight columns, the last of 1, 2, 4 or 8; steps of fixed length give the same bits."""
    more = [f"k{i}" for i in range(1, 8)]
    text = COUPLED.replace(
        "input Force", f"parameter Real {', '.join(f'{name} = 0.1' for name in more)};\n  input Force"
    )
    text = text.replace("  force u", "  force delay(x, 0.15 s)*(k1 N/m) + (k2 N)*sin(y/(1 m)) on y;\n  force u", 1)
    text = text.replace("der(z) = (", f"der(z) = ({' + '.join(f'{name}*z' for name in more[2:])} + ").replace(
        "(k1 N/m)", "k1*(1 N/m)"
    )
    model = lagdsl.compile(text.replace("(k2 N)", "k2*(1 N)"), engine="tape")
    names = [*VALUES, *more]
    fixed = solver in ("rk4", "leapfrog", "ros2")
    options = {"step": 0.1} if fixed else {"tolerance": 1e-10}
    alone = {name: model.simulate(stop=0.5, interval=0.07, solver=solver, tangents=[name], **options) for name in names}
    for count in (9, 10, 12, 14):
        motion = model.simulate(stop=0.5, interval=0.07, solver=solver, tangents=names[:count], **options)
        for name in names[:count]:
            for of in COLUMNS:
                found, exact = motion.derivative(of, name), alone[name].derivative(of, name)
                np.testing.assert_allclose(found, exact, rtol=0.0 if fixed else 1e-8, atol=0.0 if fixed else 1e-9)


@pytest.mark.parametrize("solver", ["rk4", "leapfrog", "ros2"])
def test_a_column_is_the_derivative_of_the_computed_motion(solver: str) -> None:
    model = lagdsl.compile(COUPLED, engine="tape")
    motion = model.simulate(stop=1.0, interval=0.07, solver=solver, step=0.1, tangents=list(VALUES))
    for name, here in VALUES.items():
        sums = [weight * (_moved(model, name, here + k * 1e-3, solver) - _moved(model, name, here - k * 1e-3, solver))
                for k, weight in ((1, 45.0), (2, -9.0), (3, 1.0))]  # fmt: skip
        found = np.array([motion.derivative(of, name) for of in COLUMNS])
        assert found == pytest.approx(sum(sums) / 60e-3, abs=1e-11)


@pytest.mark.parametrize("solver", ["rk4", "leapfrog"])
def test_a_bouncing_ball_is_exact_in_any_steps(solver: str) -> None:
    """Flights are parabolas, which both methods follow exactly; after one bounce h = e v t - g t^2/2, v = sqrt(2 g)."""
    model = lagdsl.compile(BALL, engine="tape")
    fall, v, e, g = sqrt(2.0 / 9.81), sqrt(2.0 * 9.81), 0.8, 9.81
    stop = 1.5 * fall
    since = stop - fall
    motion = model.simulate(stop=stop, solver=solver, step=0.05, tangents=["h.start", "e"])
    assert motion.derivative("h", "e")[-1] == pytest.approx(v * since, abs=1e-10)
    # dv/dh0 = g/v, d(since)/dh0 = -1/v
    by_start = e * g / v * since - (e * v - g * since) / v
    assert motion.derivative("h", "h.start")[-1] == pytest.approx(by_start, abs=1e-10)


def test_loops_stay_closed_to_first_order() -> None:
    """Columns in steps of RK4 approach those of steps with error control as the fourth power of their length."""
    model = lagdsl.compile(MODELS / "four_bar.lag", engine="tape")
    exact = model.simulate(stop=0.3, tolerance=1e-11, tangents="crank.l").derivative("B.q", "crank.l")[-1]

    def error(step: float) -> float:
        motion = model.simulate(stop=0.3, solver="rk4", step=step, tangents="crank.l")
        return abs(float(motion.derivative("B.q", "crank.l")[-1] - exact))

    assert error(0.005) < 1e-3 * abs(exact)
    assert error(0.0025) < 0.15 * error(0.005)


@pytest.mark.parametrize("name", ["e[1].start", "e[3].start"])
def test_a_start_that_turns_a_corner_is_told(name: str) -> None:
    """A quaternion of length one has no entry beyond 1, and one that is given moves others or not."""
    model = lagdsl.compile(MODELS / "free_rigid_body.lag", engine="tape")
    with pytest.raises(lagdsl.CallRefused, match="E0882") as refused:
        model.simulate(stop=0.1, tangents=["A", name])
    assert name in str(refused.value)


def test_a_singular_position_is_told() -> None:
    model = lagdsl.compile(MODELS / "parallelogram.lag", engine="tape")
    with pytest.raises(lagdsl.SimulationFailed, match="E0882"):
        model.simulate(stop=0.5, tangents=["m"])
