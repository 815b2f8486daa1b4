"""A start that was found is told again where it is looked for from the same, and looked for anew from anything else."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.diagnostics import Sink

# The slider is the one place at which the rod reaches it from a crank that is written: its own start moves.
SLIDER = """model Slider
  parameter Length r = 0.3 m, l = 1 m;
  parameter Mass m = 1 kg;
  input Force F;
  coordinate Angle a(start = 30 deg, fixed = true);
  coordinate Length x(start = 1.0 m);
  mass m at r*{cos(a), sin(a)};
  mass m at {x, 0};
  constraint (x - r*cos(a))^2 + (r*sin(a))^2 = l^2;
  force F on x;
end Slider;
"""


@pytest.fixture
def model() -> lagdsl.Model:
    return lagdsl.compile(SLIDER, engine="tape")


def place(a: float, r: float) -> float:
    """r cos(a) + sqrt(l^2 - r^2 sin(a)^2)"""
    return r * np.cos(a) + np.sqrt(1.0 - (r * np.sin(a)) ** 2)


def test_what_it_is_found_from_decides(model: lagdsl.Model) -> None:
    a = np.pi / 6
    for r, angle in ((0.3, a), (0.3, a), (0.2, a), (0.3, a), (0.3, 0.2), (0.3, 0.2), (0.3, a)):
        start = None if angle == a else {"a": angle}
        found = model.initial_state(parameters={"r": r}, start=start)
        assert found.q == pytest.approx([angle, place(angle, r)], rel=1e-12)


def test_the_motion_is_the_same_to_the_bit(model: lagdsl.Model) -> None:
    motions = [model.simulate(stop=0.2, interval=0.05, inputs={"F": 2.0}) for _ in range(3)]
    other = lagdsl.compile(SLIDER, engine="tape").simulate(stop=0.2, interval=0.05, inputs={"F": 2.0})
    assert other.moved
    for motion in motions:
        assert motion.moved == other.moved
        assert motion.statistics == other.statistics
        for name in other:
            np.testing.assert_array_equal(motion[name], other[name])


def test_what_was_reported_is_reported_again(model: lagdsl.Model) -> None:
    told = []
    for _ in range(2):
        sink = Sink()
        model.simulate(stop=0.1, inputs={"F": 0.0}, sink=sink)
        told.append(sink.diagnostics)
    assert [each.code for each in told[0]] == ["W0814"]
    assert told[0] == told[1]


def test_nobody_changes_it_from_outside(model: lagdsl.Model) -> None:
    first = model.initial_state()
    known = first.x.copy()
    first.x[:] = np.nan
    again = model.initial_state()
    again.p[:] = np.nan
    np.testing.assert_array_equal(model.initial_state().x, known)
    np.testing.assert_array_equal(model.initial_state().p, model.defaults)
