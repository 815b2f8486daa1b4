"""Delayed values against closed forms: motions piece by piece, growth of characteristic roots, shifted signals."""

from __future__ import annotations

import cmath
import math
from functools import cache

import numpy as np
import pytest
from choice import engines, together

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.interfaces.api.model import Model
from lagdsl.motion.simulate.failure import SimulationFailed

DECAY = """
model Decay
  parameter Real a = 1;
  state Real y(start = 1);
equation
  der(y) = -a*delay(y, 1 s)/(1 s);
end Decay;
"""
# The clock strikes on every tenth; the second delay is one of a delayed value.
SQUARE = """
model Square
  discrete Real q(start = 0);
  discrete Integer n(start = 0);
  state Length h(start = 0);
  output Real once = delay(q, 0.25 s);
  output Real twice = delay(once, 0.1 s);
equation
  der(h) = once*(1 m/s);
  when sample(0.1 s, 0.5 s) then
    q = 1 - pre(q);
  end when;
  when once > 0.5 then
    n = pre(n) + 1;
  end when;
end Square;
"""
OSCILLATOR = """
model Oscillator
  parameter Time T = 6 s;
  input Real u = 0;
  coordinate Length x(start = 1 m);
  discrete Time last(start = 0);
  output Length late[2] = delay({x, x^2/(1 m)}, T);
  output Real shifted = delay(u, 0.3 s);
  state Length sum(start = 0);
  kinetic 1/2*(1 kg)*der(x)^2;
  potential 1/2*(4 N/m)*x^2;
equation
  der(sum) = delay(der(x), T);
  when delay(x, T) < 0.2 m then
    last = time;
  end when;
end Oscillator;
"""
PD = """
model Cart
  parameter Time T = 0.5 s;
  coordinate Length x(start = 0.1 m);
  mass 1 kg at {x, 0};
  force (-delay(x, T)*(1 N/m) - delay(der(x), T)*(1 N.s/m))*world.x at {x, 0};
end Cart;
"""


@cache
def _model(text: str, engine: str = "tape") -> Model:
    return lagdsl.compile(text, engine=engine)


def _by_steps(t: Floats) -> Floats:
    """y' = -y(t - 1) with y = 1 before: the sum of (-1)^k (t - k + 1)^k / k! over k with t > k - 1."""
    terms = ((-1.0) ** k * np.maximum(t - k + 1.0, 0.0) ** k / math.factorial(k) for k in range(1, 8))
    return 1.0 + np.sum(list(terms), axis=0)


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))
def test_a_decay_is_a_polynomial_in_each_piece(engine: str) -> None:
    motion = _model(DECAY, engine).simulate(stop=5.5, tolerance=1e-3)
    assert np.max(np.abs(motion["y"] - _by_steps(motion["time"]))) < 1e-13


def test_a_step_may_end_anywhere() -> None:
    motion = _model(DECAY).simulate(stop=math.pi, tolerance=1e-10)
    assert motion["y"][-1] == pytest.approx(float(_by_steps(np.array([math.pi]))[0]), abs=1e-13)


@together("part", [0.95, 1.0, 1.05])
def test_the_loop_grows_as_its_characteristic_root(part: float) -> None:
    a = part * math.pi / 2.0
    root = 1.6j
    for _ in range(20):  # s + a exp(-s) = 0; at a = pi/2 it is i pi/2
        root -= (root + a * cmath.exp(-root)) / (1.0 - a * cmath.exp(-root))
    period = 2.0 * math.pi / root.imag

    def end(stop: float) -> float:
        return float(_model(DECAY).simulate(stop=stop, tolerance=1e-9, parameters={"a": a})["y"][-1])

    assert end(40.0 + period) / end(40.0) == pytest.approx(math.exp(root.real * period), rel=1e-6)


def test_a_force_with_a_delay_is_stable_up_to_the_critical_one() -> None:
    # s^2 + (s + 1) exp(-sT) = 0 has the root i w at w^4 = w^2 + 1, w T = atan w.
    w = math.sqrt((1.0 + math.sqrt(5.0)) / 2.0)
    critical = math.atan(w) / w
    for part in (0.97, 1.0, 1.03):
        motion = _model(PD).simulate(stop=120, tolerance=1e-9, parameters={"T": part * critical})
        before, after = (
            np.max(np.abs(motion["x"][(motion["time"] > at) & (motion["time"] < at + 5)])) for at in (50, 110)
        )
        growth = math.log(after / before) / 60.0
        assert abs(growth) < 1e-4 if part == 1.0 else growth * (part - 1.0) > 1e-4


def test_a_delayed_input_is_shifted() -> None:
    motion = _model(OSCILLATOR).simulate(stop=4, inputs={"u": lambda t: math.sin(3.0 * t)})
    t = motion["time"]
    assert np.max(np.abs(motion["shifted"] - np.sin(3.0 * np.maximum(t - 0.3, 0.0)))) < 1e-9


@together("tolerance", [1e-3, 1e-5, 1e-7, 1e-10])
def test_the_error_follows_the_tolerance(tolerance: float) -> None:
    motion = _model(OSCILLATOR).simulate(stop=20, tolerance=tolerance)
    ago = np.maximum(motion["time"] - 6.0, 0.0)
    exact = np.cos(2.0 * ago)
    scale = 2.0 * tolerance
    assert np.max(np.abs(motion["late[1]"] - exact)) < scale
    assert np.max(np.abs(motion["late[2]"] - exact**2)) < 2.0 * scale
    assert np.max(np.abs(motion["sum"] - (exact - 1.0))) < scale
    passed = [6.0 + k * math.pi + math.acos(0.2) / 2.0 for k in range(5)]
    assert motion["last"][-1] == pytest.approx(max(each for each in passed if each < 20.0), abs=scale)


def test_jumps_come_back_after_the_delay() -> None:
    motion = _model(SQUARE).simulate(stop=2.3)
    ups = [event.time for event in motion.events if event.name == "once > 0.5" and event.kind == "true"]
    assert ups == pytest.approx([0.35, 1.35], abs=1e-14)
    assert motion["n"][-1] == 2
    for name, by in (("once", 0.25), ("twice", 0.35)):
        t = motion["time"] - by
        near = np.abs((t - 0.1) / 0.5 - np.round((t - 0.1) / 0.5)) < 1e-9
        square = np.where(t > 0.1, np.floor((t - 0.1) / 0.5) % 2 == 0, False)
        assert np.array_equal(motion[name][~near], square[~near].astype(float))
        assert set(motion[name][near]) <= {0.0, 1.0}
    assert motion["h"][-1] == pytest.approx(1.0, abs=1e-13)


def test_a_relay_with_a_delay_swings() -> None:
    text = """
model Relay
  state Real x(start = 0.5);
  discrete Integer n(start = 0);
equation
  der(x) = (if delay(x, 1 s) > 0 then -1 else 1)/(1 s);
  when delay(x, 1 s) > 0 then
    n = pre(n) + 1;
  end when;
end Relay;
"""
    motion = _model(text).simulate(stop=40, tolerance=1e-4)
    t = motion["time"]
    swing = np.where(t < 1.5, 0.5 - t, 1.0 - np.abs((t - 1.5) % 4.0 - 2.0))
    assert np.max(np.abs(motion["x"] - swing)) < 1e-12
    assert motion["n"][-1] == 10


def test_a_variable_follows_its_own_past() -> None:
    text = """
model Echo
  Length y = u + 2 m - 0.5*delay(y, 1 s);
  input Length u = 1 m;
  output Length o = y;
end Echo;
"""
    run = _model(text).session()
    values = [run["o"]]
    for _ in range(3):
        run.step(1.0, {"u": 4.0})
        values.append(run["o"])
    # at the start as it would stay: y = 3 - y/2; then by one delay after the other
    assert values == pytest.approx([2.0, 5.0, 3.5, 4.25], abs=1e-12)


def test_a_session_goes_on_to_the_bit() -> None:
    model = _model(OSCILLATOR)
    kept: list[list[float]] = []
    run = model.session(parameters={"T": 0.7})
    for step in range(90):
        run.step(0.03, {"u": float(step % 4)})
        if step == 40:
            saved = run.save()
    kept.append([run.t, run["x"], run["sum"], run["shifted"], run["last"]])
    other = model.session(parameters={"T": 0.7})
    other.restore(saved)
    for step in range(41, 90):
        other.step(0.03, {"u": float(step % 4)})
    assert [other.t, other["x"], other["sum"], other["shifted"], other["last"]] == kept[0]


def test_many_steps_in_one_delay_become_few_pieces() -> None:
    run = _model(OSCILLATOR).session(parameters={"T": 6.0}, inputs={"u": 0.0})
    for _ in range(9000):
        run.step(0.001)
    assert run["late[1]"] == pytest.approx(math.cos(2.0 * (run.t - 6.0)), abs=1e-9)


def test_many_runs_have_delays_of_their_own() -> None:
    delays = [0.2, 0.5, 1.3]
    many = _model(PD).simulate_many(parameters={"T": delays}, stop=2)
    for place, delay in enumerate(delays):
        alone = _model(PD).simulate(stop=2, parameters={"T": delay})
        assert many["x"][place, -1] == alone["x"][-1]


def test_a_delay_is_positive_for_all_parameters() -> None:
    with pytest.raises(CompilationFailed, match="E0334"):
        _model(PD).simulate(stop=1, parameters={"T": 0.0})


def test_the_past_has_a_bound() -> None:
    text = SQUARE.replace("sample(0.1 s, 0.5 s)", "sample(0 s, 1 ms)").replace("0.25 s", "10 s")
    with pytest.raises(SimulationFailed, match="E0898"):
        _model(text).simulate(stop=6)
