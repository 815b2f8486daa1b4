"""Parameters that are found with the start of the motion, against closed forms, in every engine."""

from __future__ import annotations

import math

import numpy as np
import pytest
from choice import engines

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed

ENGINES = engines(("tape", "c", "numpy"))
G = 9.80665

CLOCK = """
model Clock
  parameter Length l(fixed = false, start = 0.5 m);
  parameter Time period = 2 s;
  parameter Mass m = 1 kg;
  coordinate Angle theta(start = 1 deg);
  gravity = -g_n*world.y;
  mass m at {l*sin(theta), -l*cos(theta)};
  output Length twice = 2*l;
initial equation
  der(der(theta)) = -(2*pi/period)^2*sin(theta);
end Clock;
"""
# The preload at which a mass hangs at rest where it was put: F0 + k x = m g.
PRELOAD = """
model Hanging
  parameter Force F0(fixed = false, start = 1 N);
  parameter Mass m = 2 kg;
  coordinate Length x(start = 0.1 m);
  kinetic 1/2*m*der(x)^2;
  force m*g_n - (50 N/m)*x - F0 on x;
initial equation
  der(der(x)) = 0;
end Hanging;
"""
# A four-bar whose coupler is as long as the pose asks: crank at 60 deg, rocker upright.
POSE = """
model Pose
  parameter Length coupler(fixed = false, start = 2 m);
  coordinate Angle a(start = 60 deg, fixed = true), b(start = 100 deg);
  point A = {(1 m)*cos(a), (1 m)*sin(a)};
  point B = {3 m + (2 m)*cos(b), (2 m)*sin(b)};
  gravity = 0;
  mass 1 kg at A;
  mass 1 kg at B;
  constraint rod: norm(B - A) = coupler;
initial equation
  b = 90 deg;
end Pose;
"""


@pytest.mark.parametrize("engine", ENGINES)
def test_length_of_a_period(engine: str) -> None:
    model = lagdsl.compile(CLOCK, engine=engine)
    state = model.initial_state()
    length = G / math.pi**2
    assert state.p[model.parameters.index("l")] == pytest.approx(length, rel=1e-9)
    assert state.q[0] == math.radians(1.0)
    motion = model.simulate(stop=2.0, tolerance=1e-11)
    assert motion.found == pytest.approx({"l": length}, rel=1e-9)
    assert motion["twice"][-1] == pytest.approx(2.0 * length, rel=1e-9)
    # large swings last longer: 1 + theta^2/16
    assert motion["theta"][-1] == pytest.approx(math.radians(1.0), rel=1e-7)


@pytest.mark.parametrize("engine", ENGINES)
def test_other_parameters_and_guesses(engine: str) -> None:
    model = lagdsl.compile(CLOCK, engine=engine)
    for guess in (0.3, 5.0):
        motion = model.simulate(stop=0.1, parameters={"period": 1.0, "l": guess})
        assert motion.found["l"] == pytest.approx(G / (2.0 * math.pi) ** 2, rel=1e-9)


@pytest.mark.parametrize("engine", ENGINES)
def test_preload_of_a_rest(engine: str) -> None:
    model = lagdsl.compile(PRELOAD, engine=engine)
    motion = model.simulate(stop=1.0, tolerance=1e-10)
    assert motion.found["F0"] == pytest.approx(2.0 * G - 5.0, rel=1e-10)
    assert np.allclose(motion["x"], 0.1, rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("engine", ENGINES)
def test_link_of_a_pose(engine: str) -> None:
    model = lagdsl.compile(POSE, engine=engine)
    state = model.initial_state()
    length = math.hypot(3.0 - 0.5, 2.0 - math.sqrt(0.75))
    assert state.p[model.parameters.index("coupler")] == pytest.approx(length, rel=1e-10)
    assert state.q == pytest.approx([math.radians(60.0), math.radians(90.0)], rel=1e-10)


def test_written_starts_give_way_last() -> None:
    """The rocker's start is written: it stays, and the link gives way; without the equation it moves."""
    text = POSE.replace("b = 90 deg;", "coupler = 2.5 m;")
    state = lagdsl.compile(text).initial_state()
    assert state.p[0] == pytest.approx(2.5, rel=1e-12)
    a, b = state.q
    assert a == pytest.approx(math.radians(60.0), rel=1e-12)
    span = math.hypot(3.0 + 2.0 * math.cos(b) - math.cos(a), 2.0 * math.sin(b) - math.sin(a))
    assert span == pytest.approx(2.5, rel=1e-10)


def test_an_array_of_free_parameters() -> None:
    text = """
    model Springs
      parameter Real k[2](each unit = "N/m", each fixed = false, start = {1, 2}, each min = 0);
      coordinate Length x[2](start = {0.1 m, 0.2 m});
      for i in 1:2 loop
        kinetic 1/2*(1 kg)*der(x[i])^2;
        potential 1/2*k[i]*x[i]^2;
      end for;
    initial equation
      for i in 1:2 loop
        der(der(x[i])) = -i*(1 m/s2);
      end for;
    end Springs;
    """
    found = lagdsl.compile(text).simulate(stop=0.01).found
    assert found == pytest.approx({"k[1]": 10.0, "k[2]": 10.0}, rel=1e-9)


def test_freed_in_an_instance() -> None:
    """The value of the class makes room for the guess."""
    text = """
    model Swing
      parameter Length l = 1 m;
      coordinate Angle theta(start = 1 deg);
      mass 1 kg at {l*sin(theta), -l*cos(theta)};
    end Swing;
    model Two
      Swing fixed_one, free_one(l(fixed = false, start = 0.7 m));
      gravity = -g_n*world.y;
    initial equation
      der(der(free_one.theta)) = 2*der(der(fixed_one.theta));
    end Two;
    """
    found = lagdsl.compile(text, model="Two").simulate(stop=0.01).found
    assert found == pytest.approx({"free_one.l": 0.5}, rel=1e-9)


def test_what_follows_the_start_has_the_value() -> None:
    """Discrete starts, contacts and clocks that depend on the parameter."""
    text = """
    model Drop
      parameter Length floor(fixed = false, start = -3 m);
      coordinate Length h(start = 1 m);
      discrete Length last(start = floor);
      kinetic 1/2*(1 kg)*der(h)^2;
      force -(10 N) on h;
      contact c: h >= floor with restitution = 0;
    equation
      when time > 100 s then
        last = 0 m;
      end when;
    initial equation
      2*floor = -1 m;
    end Drop;
    """
    motion = lagdsl.compile(text).simulate(stop=1.0)
    assert motion.found["floor"] == pytest.approx(-0.5, rel=1e-12)
    assert motion["last"][0] == pytest.approx(-0.5, rel=1e-12)
    assert motion["h"][-1] == pytest.approx(-0.5, abs=1e-9)
    impacts = [event.time for event in motion.events if event.kind in ("impact", "closed")]
    assert impacts[0] == pytest.approx(math.sqrt(0.3), rel=1e-7)


def test_linearized_with_what_was_found() -> None:
    """About the state that is given, with the length that the model's own start asks for."""
    model = lagdsl.compile(CLOCK)
    found = model.linearize(q={"theta": 0.0}, qd={"theta": 0.0})
    assert pytest.approx(np.array([[0.0, 1.0], [-(math.pi**2), 0.0]]), rel=1e-9) == found.A
    assert model.modes().frequencies[0] == pytest.approx(0.5 * math.sqrt(math.cos(math.radians(1.0))), rel=1e-9)


def test_crowds() -> None:
    periods = np.linspace(0.5, 3.0, 6)
    motions = lagdsl.compile(CLOCK).simulate_many(parameters={"period": periods}, stop=0.1, interval=0.05)
    assert motions["twice"][:, -1] == pytest.approx(2.0 * G * (periods / (2.0 * math.pi)) ** 2, rel=1e-8)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (CLOCK.replace("der(der(theta)) = -(2*pi/period)^2*sin(theta);", ""), "E0349"),
        (CLOCK.replace("der(der(theta)) = -(2*pi/period)^2*sin(theta);", "der(theta) = 0;"), "E0837"),
        (CLOCK.replace("start = 0.5 m", "start = 0.5 m, min = 2 m"), "E0838"),
        (CLOCK.replace("start = 1 deg", "start = l/(1 m)*(1 deg), fixed = true"), "E0350"),
        (CLOCK.replace("(fixed = false, start = 0.5 m)", "(fixed = false)"), "E0346"),
        (CLOCK.replace("(fixed = false, start = 0.5 m)", "(fixed = false, start = 0.5 m) = 1 m"), "E0347"),
        (CLOCK.replace("Length l(fixed = false, start = 0.5 m)", "Length l(start = 0.5 m) = 1 m"), "E0213"),
        (CLOCK.replace("parameter Mass m = 1 kg", "parameter Integer n(fixed = false, start = 1), m = 1"), "E0348"),
        (CLOCK.replace("initial equation", "initial equation l = 1 m; l = 2 m;"), "E0839"),
    ],
)
def test_diagnostics(text: str, code: str) -> None:
    with pytest.raises(CompilationFailed) as failure:
        lagdsl.compile(text).simulate(stop=0.01)
    assert code in [diagnostic.code for diagnostic in failure.value.diagnostics]


def test_the_summary_tells_the_value() -> None:
    text = str(lagdsl.compile(CLOCK).initial_state())
    assert "1 parameter found" in text
    assert "0.50 m -> 0.99 m  found parameter" in text


def test_a_fixed_number_takes_its_place() -> None:
    """`--fix`: the equation then moves the start instead."""
    model = lagdsl.compile(PRELOAD, fix={"F0": 10.0})
    assert model.initial_state().q[0] == pytest.approx((2.0 * G - 10.0) / 50.0, rel=1e-9)
