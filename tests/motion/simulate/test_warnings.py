"""Assertions of the level of warnings: Modelica 3.6, 8.3.7."""

from __future__ import annotations

from functools import cache

import pytest

import lagdsl
from lagdsl.foundation.diagnostics import Sink

OMEGA = 40**0.5


@cache
def _swing() -> lagdsl.Model:
    return lagdsl.compile("""
model Swing
  model Mass1
    coordinate Length x(start = 1 m);
    mass 1 kg at {x, 0};
    potential 1/2*(40 N/m)*x^2;
  equation
    assert(x < 0.9 m, "far out", level = AssertionLevel.warning);
    assert(x < 2 m, "never told", AssertionLevel.warning);
    assert(x > -2 m, "an error", AssertionLevel.error);
    when x < 0 m then
      assert(der(x) > 0, "to the left", AssertionLevel.warning);
    end when;
  end Mass1;
  Mass1 ball;
  gravity = 0;
  annotation(experiment(StopTime = 2.2, Interval = 1 ms));
end Swing;
""")


def test_the_motion_goes_on_and_tells_each_entering() -> None:
    sink = Sink()
    motion = _swing().simulate(sink=sink)
    far = [event.time for event in motion.events if event.name == "ball: far out"]
    left = [event.time for event in motion.events if event.name == "ball: to the left"]
    period = 2 * 3.141592653589793 / OMEGA
    entered = period - 0.4510268117962624 / OMEGA  # arccos(0.9)
    assert far == pytest.approx([0, entered, entered + period], abs=1.1e-3)
    assert left == pytest.approx([period / 4, 5 * period / 4], abs=1e-6)
    assert {event.kind for event in motion.events if event.time in (*far, *left)} >= {"warning"}
    told = {d.message for d in sink.diagnostics if d.code == "W0888"}
    assert len(told) == 2
    assert any("the first of 3 times" in text and "ball: far out" in text for text in told)
    assert motion.time[-1] == 2.2


def test_something_else_is_no_level() -> None:
    found = lagdsl.check("""
model M
  coordinate Length x;
  mass 1 kg at {x, 0};
  gravity = 0;
equation
  assert(x < 1 m, "a", 3);
end M;
""")
    assert [d.code for d in found if d.severity == "error"] == ["E0312"]
    assert "AssertionLevel.warning" in found[0].message
