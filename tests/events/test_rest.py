"""Contacts come to rest where the times of their bounces accumulate: closed forms of the sums. Oscillations do so at
corners."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest

import lagdsl

G = 9.80665
BALL = """
model Ball
  parameter Real e = 0.5;
  parameter Length height = 1 m, ground = 0 m;
  parameter Mass m = 1 kg;
  coordinate Length h(start = ground + height), s(der(start = 2 m/s));
  gravity = -g_n*world.y;
  mass m at {s, h};
  contact floor: h >= ground with restitution = e;
end Ball;
"""


def closing(motion: lagdsl.Trajectory, name: str = "floor") -> float:
    (time,) = (event.time for event in motion.events if event.kind == "closed" and event.name == name)
    return time


@pytest.mark.parametrize("e", [0.0, 0.05, 0.3, 0.5, 0.8, 0.9, 0.95])
def test_rest_is_the_sum_of_the_flights(e: float) -> None:
    """A drop of t takes t + 2 t (e + e^2 + ...) = t (1 + e)/(1 - e)."""
    exact = sqrt(2.0 / G) * (1.0 + e) / (1.0 - e)
    motion = lagdsl.compile(BALL, engine="tape").simulate(stop=1.2 * exact, parameters={"e": e})
    assert closing(motion) == pytest.approx(exact, rel=1e-10)
    assert abs(motion["h"][-1]) < 1e-15
    assert motion["s"][-1] == pytest.approx(2.0 * 1.2 * exact, rel=1e-12)


@pytest.mark.parametrize("height", [1e-9, 1e-4, 1e3, 1e7])
@pytest.mark.parametrize("mass", [1e-18, 1e20])
def test_rest_knows_no_scale(height: float, mass: float) -> None:
    exact = 3.0 * sqrt(2.0 * height / G)
    motion = lagdsl.compile(BALL, engine="tape").simulate(stop=1.2 * exact, parameters={"height": height, "m": mass})
    assert closing(motion) == pytest.approx(exact, rel=1e-9)
    assert abs(motion["h"][-1]) < 1e-12 * height


@pytest.mark.parametrize("ground", [-3.0, 1.0, 1e5, 1e9])
def test_rest_far_from_zero(ground: float) -> None:
    """Bounces end where they are lower than round-off of the position: a fall through that is the error of the time."""
    exact = 3.0 * sqrt(2.0 / G)
    motion = lagdsl.compile(BALL, engine="tape").simulate(stop=2.0, parameters={"ground": ground})
    assert closing(motion) == pytest.approx(exact, abs=1e-9 + sqrt(2.0 * np.spacing(abs(ground)) / G))
    assert motion["h"][-1] == pytest.approx(ground, rel=1e-15)


def test_what_nothing_presses_parts_however_slowly() -> None:
    """Without gravity a rebound of 1e-6 of the approach is a rebound: no threshold of speed glues the two."""
    text = """
    model Apart
      coordinate Length a(start = -1 m, der(start = 1 m/s)), b(start = 0 m);
      gravity = 0;
      mass 1 kg at {a, 0};
      mass 1 kg at {b, 0};
      contact c: b - a >= 0 with restitution = 1e-6;
    end Apart;
    """
    motion = lagdsl.compile(text, engine="tape").simulate(stop=3.0)
    assert [event.kind for event in motion.events] == ["impact"]
    assert motion["der(b)"][-1] - motion["der(a)"][-1] == pytest.approx(1e-6, rel=1e-8)
    assert motion["b"][-1] - motion["a"][-1] == pytest.approx(2e-6, rel=1e-8)


def test_two_balls_rest_each_in_its_time() -> None:
    text = """
    model Two
      coordinate Length a(start = 1 m), b(start = 1 mm);
      gravity = -g_n*world.y;
      mass 1 kg at {0, a};
      mass 1e-12 kg at {1 m, b};
      contact high: a >= 0 with restitution = 0.7;
      contact low: b >= 0 with restitution = 0.6;
    end Two;
    """
    motion = lagdsl.compile(text, engine="tape").simulate(stop=4.0)
    assert closing(motion, "high") == pytest.approx(sqrt(2.0 / G) * 1.7 / 0.3, rel=1e-10)
    assert closing(motion, "low") == pytest.approx(sqrt(2e-3 / G) * 1.6 / 0.4, rel=1e-9)


def test_a_ball_in_an_elevator_rests_by_the_gravity_that_it_feels() -> None:
    """The floor accelerates upward at 5 m/s2 from rest: flights are those under g + 5."""
    text = BALL.replace("h >= ground", "h >= ground + 1/2*(5 m/s2)*time^2")
    motion = lagdsl.compile(text, engine="tape").simulate(stop=2.0)
    exact = sqrt(2.0 / (G + 5.0)) * 3.0
    assert closing(motion) == pytest.approx(exact, rel=1e-9)
    assert motion["h"][-1] == pytest.approx(10.0, rel=1e-12)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-8])
@pytest.mark.parametrize("spring", ["x + max(x, 0 m)", "x + 0.1*abs(x)"])
def test_an_oscillation_that_dies_away_at_a_corner_rests(spring: str, tolerance: float) -> None:
    """It passes the corner of its spring ever more weakly. Below the tolerance no step ends there."""
    text = f"""
    model Bilinear
      coordinate Length x(start = 1 m, fixed = true);
      kinetic 1/2*(1 kg)*der(x)^2;
      force -(100 N/m)*({spring}) - (2 N.s/m)*der(x) on x;
    end Bilinear;
    """
    motion = lagdsl.compile(text, engine="tape").simulate(stop=100.0, tolerance=tolerance)
    assert abs(motion["x"][-1]) < tolerance
    assert motion.statistics.steps < 1500
