"""Corners and jumps of time alone, against closed forms: nothing is stepped over, however short it is.

References are integrals of the prescribed functions, found by hand or by quadrature between the corners.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from choice import spread

import lagdsl
from lagdsl.interfaces.api.model import Model
from lagdsl.motion.signals.trajectory import Trajectory

CLOSE = 1e-8
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(40)


@cache
def _model(text: str) -> Model:
    return lagdsl.compile(text, engine="tape")


def run(text: str, **values: float) -> Trajectory:
    return _model(text).simulate(parameters=values)


def last(motion: Trajectory, name: str) -> float:
    return float(motion[name][-1])


# ---- forces that act for a short time --------------------------------------------------------------------------------


def pushed(force: str, declarations: str = "", stop: float = 10.0) -> str:
    return f"""
model Pushed
  import Lag.Blocks.*;
  {declarations}
  coordinate Length x(start = 0, fixed = true);
  kinetic 1/2*(1 kg)*der(x)^2;
  force (1 N)*({force}) on x;
  annotation(experiment(StopTime = {stop}));
end Pushed;
"""


def moments(force: Callable[[float], float], *corners: float, stop: float = 10.0) -> tuple[float, float]:
    """Velocity and place of a unit mass at the end, smooth between the corners."""
    velocity = place = 0.0
    for a, b in pairwise([0.0, *corners, stop]):
        times = 0.5 * (a + b) + 0.5 * (b - a) * _NODES
        values = 0.5 * (b - a) * _WEIGHTS * np.array([force(float(t)) for t in times])
        velocity += float(np.sum(values))
        place += float(np.sum(values * (stop - times)))
    return velocity, place


def bessel(t: float) -> float:
    """Hermite's cubic through (4.9, 0), (4.95, 1), (5, 0) with Bessel's slopes 40, 0, -40, straight outside."""
    if t < 4.9 or t >= 5.0:
        return 40.0 * (t - 4.9) if t < 4.9 else -40.0 * (t - 5.0)
    return 1.0 - (t - 4.95) ** 2 / 0.05**2


SHORT = {
    "tent": ("max(0, 1 - abs(time - 5 s)/(0.05 s))", (0.05, 0.25)),
    "table": ("table(time, {0, 4.95, 5, 5.05, 10}*(1 s), {0, 0, 1, 0, 0})", (0.05, 0.25)),
    "window": ("if time > 4.999 s and time < 5.001 s then 1 else 0", (0.002, 0.01)),
    "narrow window": ("if time > 5 s and time < 5.000001 s then 1 else 0", (1e-6, 1e-6 * (5 - 0.5e-6))),
    "staircase": ("floor(time/(0.7 s))", moments(lambda t: t // 0.7, *(0.7 * k for k in range(1, 15)))),
    "ceiling": ("ceil(time/(0.7 s))", moments(lambda t: t // 0.7 + 1, *(0.7 * k for k in range(1, 15)))),
    "teeth": (
        "max(0, 1 - mod(time - 0.5 s, 1 s)/(0.001 s))",
        (10 * 0.0005, sum(0.0005 * (9.5 - k) - 0.001**2 / 6 for k in range(10))),
    ),
    "wrapped": (
        "wrap((1 rad/s)*time)",
        moments(lambda t: (t + np.pi) % (2 * np.pi) - np.pi, np.pi, 3 * np.pi),
    ),
    "rectified": (
        "abs(sin((1 rad/s)*time))",
        moments(lambda t: abs(np.sin(t)), np.pi, 2 * np.pi, 3 * np.pi),
    ),
    "crests": (
        "max(0, sin((7 rad/s)*time) - 0.99999)",
        moments(
            lambda t: max(0.0, np.sin(7 * t) - 0.99999),
            *sorted(
                float((angle + 2 * np.pi * k) / 7)
                for k in range(11)
                for angle in (np.arcsin(0.99999), np.pi - np.arcsin(0.99999))
            ),
        ),
    ),
    "limited table": (
        "limit(table(time, {2, 4, 6}*(1 s), {0, 1, 0}), 1/5, 4/5)",
        moments(lambda t: min(max(min(t / 2 - 1, 3 - t / 2), 0.2), 0.8), 2.4, 3.6, 4.4, 5.6),
    ),
    "sign": ("sign(time - 5 s)", (0.0, -25.0)),
    "cubic table": (
        'max(0, table(time, {4.9, 4.95, 5}*(1 s), {0, 1, 0}, "cubic"))',
        moments(lambda t: max(0.0, bessel(t)), 4.9, 4.95, 5.0),
    ),
    "ramps": (
        "up.y - down.y",
        moments(lambda t: min(max((t - 5) / 0.1, 0), 1) - min(max((t - 5.2) / 0.1, 0), 1), 5.0, 5.1, 5.2, 5.3),
    ),
    "exponential corner": ("max(0, exp(-time/(1 s)) - 1/2)", moments(lambda t: max(0.0, np.exp(-t) - 0.5), np.log(2))),
}
BLOCKS = "Ramp up(start = 5 s, duration = 0.1 s), down(start = 5.2 s, duration = 0.1 s);"


@pytest.mark.parametrize("name", spread(SHORT, 8))
def test_short_forces_are_felt(name: str) -> None:
    force, (velocity, place) = SHORT[name]
    motion = run(pushed(force, BLOCKS))
    assert last(motion, "der(x)") == pytest.approx(velocity, rel=CLOSE, abs=1e-12)
    assert last(motion, "x") == pytest.approx(place, rel=CLOSE, abs=1e-11)


def test_corners_follow_parameters() -> None:
    text = pushed("max(0, 1 - abs(time - t0)/w)", "parameter Time t0 = 5 s, w = 0.05 s;")
    for t0, width in ((1.0, 1e-3), (7.3, 0.2), (9.99, 1e-5)):
        assert last(run(text, t0=t0, w=width), "der(x)") == pytest.approx(width, rel=CLOSE)


def test_corners_that_depend_on_discretes_are_found_anew_after_an_event() -> None:
    text = pushed(
        "max(0, 1 - abs(time - t0)/(0.01 s))",
        "discrete Time t0(start = 2 s); equation when time > 3 s then t0 = 6 s; end when; equation",
    )
    assert last(run(text), "der(x)") == pytest.approx(0.02, rel=CLOSE)


def test_a_ramp_without_duration_is_a_step() -> None:
    """A division by zero on either side of it: no time is spent on a search where everything is infinite."""
    text = pushed("r.y", "Ramp r(start = 4 s, duration = 0 s);")
    before = time.process_time()
    assert last(run(text), "der(x)") == pytest.approx(6.0, rel=CLOSE)
    assert time.process_time() - before < 5


def test_continuous_corners_are_no_events_to_be_told() -> None:
    motion = run(pushed("max(0, time - 5 s)/(1 s)"))
    assert motion.events == ()
    assert len(motion.time) == len(np.unique(motion.time))


def test_jumps_are_told() -> None:
    motion = run(pushed("floor(time/(4 s))"))
    assert [(event.time, event.name, event.kind) for event in motion.events] == [
        (4.0, "floor(time/(4 s))", "jump"),
        (8.0, "floor(time/(4 s))", "jump"),
    ]


# ---- ways that have corners ------------------------------------------------------------------------------------------

K = 4.0  # N/m of a spring with 1 kg: 2 rad/s


def driven(way: str, declarations: str = "", stop: float = 3.0) -> str:
    """A mass at `x + way`, with a spring on x."""
    return f"""
model Driven
  import Lag.Blocks.*;
  {declarations}
  coordinate Length x(start = 0, fixed = true, der(start = 0, fixed = true));
  Length way = {way};
  mass 1 kg at {{x + way, 0, 0}};
  potential 1/2*(4 N/m)*x^2;
  annotation(experiment(StopTime = {stop}));
end Driven;
"""


def swing(*jumps: tuple[float, float]) -> Callable[[np.ndarray], np.ndarray]:
    """The motion of x after the way has changed its speed at these times by so much."""
    return lambda t: sum(np.where(t > t0, -v / 2 * np.sin(2 * (t - t0)), 0.0) for t0, v in jumps)


WAYS = {
    "max": ("max(0 m, (0.1 m/s)*(time - 1 s))", "", swing((1.0, 0.1))),
    "if": ("if time < 1 s then 0 m else (0.1 m/s)*(time - 1 s)", "", swing((1.0, 0.1))),
    "abs": ("(0.05 m/s)*abs(time - 1 s) + (0.05 m/s)*(time - 1 s)", "", swing((1.0, 0.1))),
    "table": ("table(time, {0, 1, 2}*(1 s), {0, 0, 0.1}*(1 m))", "", swing((1.0, 0.1))),
    "ramp": ("(1 m)*r.y", "Ramp r(start = 1 s, duration = 0.5 s, height = 0.05);", swing((1.0, 0.1), (1.5, -0.1))),
    "triangle": ("(0.1 m/s)*abs(mod(time, 1 s) - 1/2*(1 s))", "", None),
    "corner of a sine": ("(1 m)*max(0, sin((2 rad/s)*time))", "", None),
}


@pytest.mark.parametrize("name", [name for name in WAYS if WAYS[name][2] is not None])
def test_a_corner_in_the_way_of_a_mass_is_an_impulse(name: str) -> None:
    way, declarations, exact = WAYS[name]
    motion = run(driven(way, declarations))
    assert exact is not None
    assert motion["x"] == pytest.approx(exact(motion.time), abs=1e-9)


@pytest.mark.parametrize("name", WAYS)
def test_relative_and_absolute_coordinates_move_alike(name: str) -> None:
    """X = x + way is pulled by a spring whose other end moves: its velocity is continuous, no impulse is needed."""
    way, declarations, _ = WAYS[name]
    place, speed = {"triangle": (0.05, -0.1), "corner of a sine": (0.0, 2.0)}.get(name, (0.0, 0.0))
    relative = run(driven(way, declarations + "output Length X = x + way;"))
    absolute = run(
        driven(way, declarations + f"parameter Length x0 = {place}; parameter Velocity v0 = {speed};")
        .replace("mass 1 kg at {x + way, 0, 0}", "kinetic 1/2*(1 kg)*der(x)^2")
        .replace("*x^2;", "*(x - way)^2;")
        .replace("x(start = 0, fixed = true, der(start = 0", "x(start = x0, fixed = true, der(start = v0")
    )
    times = np.linspace(0.0, 3.0, 501)
    assert at(absolute, "x", times) == pytest.approx(at(relative, "X", times), abs=1e-8)


def at(motion: Trajectory, name: str, times: np.ndarray) -> np.ndarray:
    """Values at times that are rows."""
    rows = np.searchsorted(motion.time, times - 1e-9)
    assert motion.time[rows] == pytest.approx(times, abs=1e-9)
    return np.asarray(motion[name][rows])


# ---- forces that jump at a corner ------------------------------------------------------------------------------------

FALLING = """
model Falling
  parameter Acceleration drop = 30 m/s2;
  Length floor = -1/2*drop*max(0, time - 1 s)^2;
  coordinate Length y;
  kinetic 1/2*(2 kg)*der(y)^2;
  force -20 N on y;
  {held}
  output Force N = multiplier(c);
equation
  when {when} then
    n = pre(n) + 1;
  end when;
  annotation(experiment(StopTime = 2.5));
end Falling;
"""


def test_a_contact_opens_where_its_floor_begins_to_fall_faster_than_the_mass() -> None:
    """The force of the floor jumps from 20 N to -40 N: the mass falls freely."""
    contact = "contact c: y >= floor with restitution = 0; discrete Integer n(start = 0);"
    motion = run(FALLING.format(held=contact, when="not closed(c)"))
    assert [(event.time, event.kind, event.name) for event in motion.events][:1] == [(1.0, "opened", "c")]
    assert motion["y"] == pytest.approx(-5.0 * np.maximum(motion.time - 1.0, 0.0) ** 2, abs=1e-9)
    assert np.min(motion["N"]) == 0.0 and last(motion, "n") == 1
    slower = run(FALLING.format(held=contact, when="not closed(c)"), drop=8.0)
    assert not slower.events and last(slower, "N") == pytest.approx(4.0)


def test_a_relation_changes_where_the_force_that_it_asks_for_jumps() -> None:
    held = "constraint c: y = floor + drop*max(0, time - 2 s)^2; discrete Integer n(start = 0);"
    motion = run(FALLING.format(held=held, when="multiplier(c) < 0"))
    told = [(event.time, event.kind) for event in motion.events]
    assert told == [(1.0, "true"), (2.0, "false")]  # 20 N, -40 N, 80 N
    assert last(motion, "n") == 1 and last(motion, "N") == pytest.approx(80.0)
