"""A stop, or a tick, that is moved onto a crossing changes nothing but the end."""

from __future__ import annotations

from math import atan2, inf, nextafter, pi, sqrt

import numpy as np
import pytest

import lagdsl

TURN = """
model Turn
  coordinate Angle x(start = 0.1 rad, der(start = 1 rad/s));
  discrete Integer up(start = 0), down(start = 0), both(start = 0);
  kinetic 1/2*(1 kg.m2)*der(x)^2;
  torque -(37 N.m/rad)*x on x;
equation
  when x > 0 then up = pre(up) + 1; end when;
  when x < 0 then down = pre(down) + 1; end when;
  when {x > 0, x < 0} then both = pre(both) + 1; end when;
end Turn;
"""
RATE = sqrt(37.0)
PHASE = atan2(0.1, 1.0 / RATE)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-9, 1e-12])
def test_stops_around_crossings_count_each_once(tolerance: float) -> None:
    """The k-th zero of sin(w t + phase) is at (k pi - phase)/w; it has happened, or it comes at the stop."""
    model = lagdsl.compile(TURN, engine="tape")
    for k in range(1, 12):
        crossing = (k * pi - PHASE) / RATE
        for stop in (crossing, nextafter(crossing, -inf), nextafter(crossing, inf), crossing - 1e-13, crossing + 1e-13):
            motion = model.simulate(stop=stop, tolerance=tolerance)
            before = (k // 2, (k - 1) - (k - 1) // 2) if k % 2 else ((k - 1) // 2, k // 2)
            after = (k // 2, k - k // 2)
            counted = (motion["up"][-1], motion["down"][-1])
            assert counted in (before, after), (k, stop, counted)
            assert motion["both"][-1] == sum(counted)


@pytest.mark.parametrize("relation", [">", ">="])
@pytest.mark.parametrize("at", [1.0 / 3.0, 0.7, 4.0, 1e3 / 7.0])
def test_a_stop_at_a_crossing_of_a_straight_motion(relation: str, at: float) -> None:
    text = f"""
    model Straight
      parameter Length there = 1 m;
      coordinate Length x(der(start = 1 m/s));
      discrete Integer n(start = 0);
      kinetic 1/2*(1 kg)*der(x)^2;
    equation
      when x {relation} there then n = pre(n) + 1; end when;
    end Straight;
    """
    model = lagdsl.compile(text, engine="tape")
    for ulps in range(-6, 7):
        stop = at + ulps * np.spacing(at)
        motion = model.simulate(stop=stop, parameters={"there": at})
        assert motion["n"][-1] in ((1.0,) if ulps > 4 else (0.0, 1.0))
        assert len(motion.events) == motion["n"][-1]


def test_a_tick_at_a_crossing_is_one_event() -> None:
    text = """
    model Ticks
      parameter Length there = 1 m/3;
      coordinate Length x(der(start = 1 m/s));
      discrete Integer n(start = 0), ticks(start = 0), either(start = 0);
      kinetic 1/2*(1 kg)*der(x)^2;
    equation
      when x > there then n = pre(n) + 1; end when;
      when sample(1 s/3, 1 s/3) then ticks = pre(ticks) + 1; end when;
      when {x > there, sample(1 s/3, 1 s/3)} then either = pre(either) + 1; end when;
    end Ticks;
    """
    model = lagdsl.compile(text, engine="tape")
    for multiple in (1, 2, 3, 5):
        for ulps in (-3, -1, 0, 1, 3):
            there = multiple / 3.0 + ulps * np.spacing(multiple / 3.0)
            motion = model.simulate(stop=2.1, parameters={"there": there})
            assert (motion["n"][-1], motion["ticks"][-1]) == (1.0, 6.0)
            assert motion["either"][-1] in (6.0, 7.0)  # one event, or two that time can tell apart
