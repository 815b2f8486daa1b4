"""Derivatives of motions with delayed values: closed forms by the method of steps, differences of whole runs, and to
the bit in sessions."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest

import lagdsl

# x' = -k x(t - T): x = 1 - k t up to T, then 1 - k t + k^2 (t - T)^2/2 up to 2 T.
STEPS = """
model Steps
  parameter Real k = 1.3;
  parameter Time T = 0.4 s;
  state Real x(start = 1);
  output Real late = delay(x, T);
equation
  der(x) = -k*delay(x, T)/(1 s);
end Steps;
"""

# The delayed speed of a ball that bounces drives s: its jump comes back, at a time that moves with that of the impact.
BALL = """
model Ball
  parameter Real e = 0.7;
  parameter Time T = 0.25 s;
  coordinate Length h(start = 1 m);
  state Length s(start = 0);
  mass 1 kg at {0, h};
  gravity = {0, -10 m/s2};
  contact floor: h >= 0 with restitution = e;
equation
  der(s) = delay(der(h), T);
end Ball;
"""

# Delayed inputs and discretes, a delayed value in a product, one delay within another.
MIXED = """
model Mixed
  parameter Real k = 1.3;
  parameter Time T = 0.4 s, every = 0.33 s;
  input Real u = 0.2;
  state Real x(start = 1), v(start = 0);
  discrete Real n(start = 0);
  output Real y = delay(x^2, 2*T) + delay(n, T);
equation
  der(x) = (-k*delay(x, T) + u)/(1 s);
  der(v) = (delay(n, T) + x*delay(x*delay(u*x, T), 0.3 s))/(1 s);
  when sample(every, every) then
    n = pre(n) + x;
  end when;
end Mixed;
"""


@pytest.mark.parametrize(("solver", "step"), [("dop853", None), ("radau", None), ("rk4", 0.02)])
def test_a_delay_is_differentiated_as_the_method_of_steps(solver: str, step: float | None) -> None:
    model = lagdsl.compile(STEPS, engine="tape")
    motion = model.simulate(stop=0.7, interval=0.1, solver=solver, step=step, tangents=["k", "T", "x.start"])
    k, T, t = 1.3, 0.4, 0.7
    assert motion.derivative("x", "k")[-1] == pytest.approx(-t + k * (t - T) ** 2, abs=1e-11)
    assert motion.derivative("x", "T")[-1] == pytest.approx(-(k**2) * (t - T), abs=1e-11)
    assert motion.derivative("x", "x.start")[-1] == pytest.approx(motion["x"][-1], abs=1e-11)
    # late = x(t - T) = 1 - k (t - T)
    assert motion.derivative("late", "k")[-1] == pytest.approx(-(t - T), abs=1e-11)
    assert motion.derivative("late", "T")[-1] == pytest.approx(k, abs=1e-11)


def test_a_jump_comes_back_at_a_time_that_moves() -> None:
    """s(t) = h(t - T) - 1 behind T; one bounce at sqrt(2 h/g): h = e v since - g since^2/2."""
    model = lagdsl.compile(BALL, engine="tape")
    motion = model.simulate(stop=0.85, tolerance=1e-10, tangents=["e", "T", "h.start"])
    v, fall = sqrt(20.0), sqrt(0.2)
    since = 0.85 - 0.25 - fall
    assert since > 0.0
    behind = 0.7 * v - 10.0 * since
    assert motion["s"][-1] == pytest.approx(0.7 * v * since - 5.0 * since**2 - 1.0, abs=1e-9)
    assert motion.derivative("s", "e")[-1] == pytest.approx(v * since, abs=1e-9)
    assert motion.derivative("s", "T")[-1] == pytest.approx(-behind, abs=1e-9)
    by_height = 0.7 * 10.0 / v * since - behind / v - 1.0
    assert motion.derivative("s", "h.start")[-1] == pytest.approx(by_height, abs=1e-9)


def test_derivatives_are_those_of_differences() -> None:
    model = lagdsl.compile(MIXED, engine="tape")
    values = {"k": 1.3, "T": 0.4, "every": 0.33, "x.start": 1.0, "u": 0.2}
    options = {"stop": 1.57, "interval": 0.785, "tolerance": 1e-11}
    motion = model.simulate(**options, tangents=list(values))  # type: ignore[arg-type]

    def moved(name: str, by: float) -> np.ndarray:
        kind = "start" if name.endswith(".start") else "inputs" if name == "u" else "parameters"
        given = {kind: {name.removesuffix(".start"): values[name] + by}}
        found = model.simulate(**options, **given)  # type: ignore[arg-type]
        return np.array([found[of][-1] for of in ("x", "v", "y")])

    for name in values:
        near, far = moved(name, 1e-4) - moved(name, -1e-4), moved(name, 2e-4) - moved(name, -2e-4)
        found = [motion.derivative(of, name)[-1] for of in ("x", "v", "y")]
        assert found == pytest.approx((8.0 * near - far) / 12e-4, abs=1e-9)


def test_a_session_goes_on_to_the_bit() -> None:
    model = lagdsl.compile(MIXED, engine="tape")
    run = model.session(tangents=["k", "T", "u"], record=False)

    def on() -> np.ndarray:
        for k in range(5):
            run.step(0.13, u=0.1 * k)
        return run.jacobian(["x", "v", "y"])

    on()
    saved = run.save()
    later = on()
    run.restore(saved)
    assert np.array_equal(on(), later)


def test_a_jump_that_turns_a_relation_is_told() -> None:
    model = lagdsl.compile(
        """
model Turns
  parameter Time a = 0.3 s;
  discrete Real n(start = 0);
  state Real x(start = 0);
equation
  der(x) = (if delay(n, 0.2 s) > 0.5 then 2 else 1)/(1 s);
  when time > a then
    n = 1;
  end when;
end Turns;
""",
        engine="tape",
    )
    with pytest.raises(lagdsl.SimulationFailed, match="E0882"):
        model.simulate(stop=1.0, tangents=["a"])
