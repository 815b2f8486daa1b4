"""A motion that takes the memory of the one before is as one of a model that nobody has moved yet, to the bit."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.motion.simulate.failure import SimulationFailed

# An invariant, an impact at 0.5 s, an assertion that the rate fails later, and an input.
TEXT = """
model Ball
  coordinate Length h(start = 1.225 m, min = 0 m);
  coordinate Length x;
  parameter Real e = 0.5;
  input Force F = 0;
  output Length twice = 2*h;
  state Real z(start = 1);
  equation der(z) = -z/(1 s);
  kinetic 1/2*(1 kg)*(der(h)^2 + der(x)^2);
  potential (1 kg)*(9.8 m/s^2)*h;
  force F on x;
  contact floor: h >= 0 with restitution = e;
    assert(der(x) < 5 m/s, "too fast");
end Ball;
"""
SWING = """
model Swing
  coordinate Angle a(start = 1);
  kinetic 1/2*(1 kg.m^2)*der(a)^2;
  potential -(9 J)*cos(a);
  invariant energy: (1 kg.m^2)/2*der(a)^2 - (9 J)*cos(a);
end Swing;
"""


def told(motion: lagdsl.Trajectory) -> tuple[object, ...]:
    columns = [(c.name, c.values.tobytes(), c.lowest, c.highest) for c in motion.columns]
    return columns, motion.energy.tobytes(), motion.events, motion.statistics, motion.invariants, motion.moved


OTHERS = [
    {"stop": 2.0, "interval": 0.5, "parameters": {"e": 0.9}},
    {"stop": 1.0, "start": {"h": 3.0, "der(x)": -1.0}, "inputs": {"F": np.sin}},
    {"stop": 1.0, "inputs": {"F": ([0.0, 0.4, 1.0], [0.0, 2.0, -1.0])}, "solver": "rk4", "step": 0.01},
    {"stop": 1.0, "control": [lagdsl.control("0.1 s", lambda now: now.t)]},
]


@pytest.mark.parametrize("other", OTHERS)
def test_nothing_is_left_of_the_motion_before(other: dict[str, object]) -> None:
    model = lagdsl.compile(TEXT, engine="tape")
    asked = {"stop": 0.8, "interval": 0.1, "inputs": {"F": 0.5}}
    first = told(model.simulate(**asked))  # type: ignore[arg-type]
    model.simulate(**other)  # type: ignore[arg-type]
    assert told(model.simulate(**asked)) == first  # type: ignore[arg-type]
    assert told(lagdsl.compile(TEXT, engine="tape").simulate(**asked)) == first  # type: ignore[arg-type]


def test_nothing_is_left_of_a_motion_that_failed() -> None:
    model = lagdsl.compile(TEXT, engine="tape")
    first = told(model.simulate(stop=0.8))
    with pytest.raises(SimulationFailed, match="too fast"):
        model.simulate(stop=3.0, inputs={"F": 4.0})
    assert told(model.simulate(stop=0.8)) == first


def test_a_motion_is_not_changed_by_the_next_one() -> None:
    model = lagdsl.compile(SWING, engine="tape")
    motion = model.simulate(stop=1.0)
    before = told(motion)
    state = model.initial_state()
    model.simulate(stop=2.0, start={"a": 2.0})
    assert told(motion) == before
    np.testing.assert_array_equal(state.x, [1.0, 0.0])
    assert 0.0 < motion.invariants[0].drift < 1e-6
