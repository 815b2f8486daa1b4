"""Events against closed forms: impacts, resting, leaving, clocks, clauses."""

from __future__ import annotations

import math
from functools import partial

import numpy as np
import pytest
from choice import engines

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.motion.simulate.failure import SimulationFailed

G = 9.80665
BALL = """
model Ball
  constant Real e = 0.8;
  coordinate Length h(start = 1 m);
  {declarations}
  gravity = -g_n*world.y;
  mass 0.1 kg at {{0, h}};
  {items}
equation
  {equations}
end Ball;
"""


@pytest.fixture(autouse=True, params=engines(["numpy", "c"]))
def engine(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> EngineName:
    """Everything here holds for both engines, which know of each other's rules nothing."""
    monkeypatch.setattr(lagdsl, "compile", partial(lagdsl.compile, engine=request.param))
    name: EngineName = request.param
    return name


def ball(declarations: str = "", items: str = "", equations: str = "") -> lagdsl.Model:
    return lagdsl.compile(BALL.format(declarations=declarations, items=items, equations=equations))


def impact_times(e: float, count: int) -> np.ndarray:
    """Of a ball dropped from 1 m: the first after sqrt(2/g), each flight lasts e times the one before."""
    first = math.sqrt(2.0 / G)
    return first + np.concatenate([[0.0], np.cumsum(2.0 * first * e ** np.arange(1, count))])


def test_ball_with_a_contact_bounces_on_time_and_comes_to_rest(engine: EngineName) -> None:
    motion = ball(items="contact floor: h >= 0 with restitution = e; output Force N = multiplier(floor);").simulate(
        stop=5.0, interval=0.5
    )
    times = np.array([event.time for event in motion.events if event.kind == "impact"])
    assert len(times) >= 20
    np.testing.assert_allclose(times, impact_times(0.8, len(times)), rtol=0, atol=1e-9)
    accumulation = impact_times(0.8, 400)[-1]
    (closed,) = (event.time for event in motion.events if event.kind == "closed")
    if engine == "c":
        assert closed == pytest.approx(accumulation, abs=1e-9)
    assert motion["N"][-1] == pytest.approx(0.1 * G, rel=1e-12)
    assert abs(motion["h"][-1]) < 1e-12


def test_ball_with_reinit_counts_its_bounces() -> None:
    text = "when h <= 0 then reinit(der(h), -e*pre(der(h))); n = pre(n) + 1; end when;"
    motion = ball("discrete Integer n(start = 0);", equations=text).simulate(stop=3.0, interval=1.0)
    times = [event.time for event in motion.events if event.kind == "reinit"]
    np.testing.assert_allclose(times, impact_times(0.8, 6), rtol=0, atol=1e-9)
    assert motion["n"].tolist()[-1] == 6.0
    twice = np.flatnonzero(np.diff(motion.time) == 0.0)
    np.testing.assert_allclose(motion.time[twice], times)
    np.testing.assert_allclose(motion["der(h)"][twice + 1], -0.8 * motion["der(h)"][twice])


def test_rebound_is_slower_than_v_stick() -> None:
    motion = ball(items="contact floor: h >= 0 with restitution = e, v_stick = 3 m/s;").simulate(stop=3.0)
    kinds = [event.kind for event in motion.events]
    assert kinds == ["impact", "impact", "closed"]  # 4.43 m/s come back as 3.54, then as 2.83
    assert motion.events[-1].time == pytest.approx(impact_times(0.8, 2)[1], abs=1e-9)


CRADLE = """
model Cradle
  parameter Length R = 1 cm;
  coordinate Length x[4](start = {-0.1 m, 0.02 m, 0.04 m, 0.06 m}, der(start = {1 m/s, 0, 0, 0}));
  gravity = {0, 0, 0};
  for i in 1:4 loop
    mass 0.2 kg at {x[i], 0};
  end for;
  for i in 1:3 loop
    contact c: x[i+1] - x[i] >= 2*R with restitution = 1;
  end for;
end Cradle;
"""


def test_touching_balls_hand_the_blow_on() -> None:
    motion = lagdsl.compile(CRADLE).simulate(stop=1.0)
    rates = [motion[f"der(x[{i}])"][-1] for i in range(1, 5)]
    np.testing.assert_allclose(rates, [0.0, 0.0, 0.0, 1.0], atol=1e-10)
    np.testing.assert_allclose(motion.energy, 0.1, rtol=1e-10)
    assert [event.time for event in motion.events if event.kind == "impact"] == pytest.approx([0.1] * 3, abs=1e-9)


BOX = """
model Box
  parameter Length a = 0.2 m, b = 0.1 m;
  parameter Angle tilt = 20 deg;
  coordinate Length x, y(start = 0.5 m);
  coordinate Angle th(start = tilt);
  frame box = world.at({x, y, 0}).rotz(th);
  gravity = -g_n*world.y;
  body B(m = 1 kg, Izz = 0.01 kg.m2) on box;
  point L = box - a/2*box.x - b/2*box.y;
  point R = box + a/2*box.x - b/2*box.y;
  contact left: L.y >= 0 with restitution = 0.3;
  contact right: R.y >= 0 with restitution = 0.3;
  output Force N[2] = {multiplier(left), multiplier(right)};
end Box;
"""


@pytest.mark.parametrize("tilt", [0.0, 20.0, -30.0])
def test_box_comes_to_rest_on_two_corners(tilt: float) -> None:
    motion = lagdsl.compile(BOX).simulate(stop=6.0, parameters={"tilt": math.radians(tilt)})
    assert motion["y"][-1] == pytest.approx(0.05, abs=1e-9)
    assert motion["N[1]"][-1] + motion["N[2]"][-1] == pytest.approx(G, rel=1e-9)


def test_particle_leaves_the_sphere_at_two_thirds() -> None:
    text = """
    model Sphere
      parameter Length R = 0.5 m;
      coordinate Length x(start = 1 mm), y(start = sqrt(0.25 - 1e-6) m);
      gravity = -g_n*world.y;
      mass 1 kg at {x, y};
      contact surface: sqrt(x^2 + y^2) >= R with restitution = 0;
    end Sphere;
    """.replace("sqrt(0.25 - 1e-6) m", "0.499998999999 m")
    motion = lagdsl.compile(text).simulate(stop=2.0, tolerance=1e-11)
    (left,) = (event for event in motion.events if event.kind == "opened")
    row = int(np.flatnonzero(motion.time == left.time)[0])
    start = motion["y"][0] / 0.5
    assert motion["y"][row] / 0.5 == pytest.approx(2.0 / 3.0 * start, abs=1e-8)


TABLE = """
model BallOnMovingTable
  parameter Length A = 5 cm;
  parameter AngularVelocity w = 20 rad/s;
  coordinate Length h(der(start = 1 m/s));
  Length table = A*sin(w*time);
  gravity = -g_n*world.y;
  mass 0.1 kg at {0, h};
  contact surface: h >= table with restitution = 0.6;
end BallOnMovingTable;
"""


def test_ball_leaves_a_falling_table_without_an_impact() -> None:
    motion = lagdsl.compile(TABLE).simulate(stop=0.3)
    leaving = math.asin(G / (0.05 * 20.0**2)) / 20.0
    assert [event.kind for event in motion.events] == ["opened", "impact"]
    assert motion.events[0].time == pytest.approx(leaving, abs=1e-9)


SAMPLED = """
model Sampled
  coordinate Length x(start = 1 m);
  discrete Force F(start = 0);
  kinetic 1/2*(1 kg)*der(x)^2;
  force F on x;
equation
  when sample(0, 0.1 s) then
    F = -(4 N/m)*x - (2 N.s/m)*der(x);
  end when;
end Sampled;
"""


def test_sampled_controller_does_not_depend_on_the_output_grid() -> None:
    model = lagdsl.compile(SAMPLED)
    coarse, fine = model.simulate(stop=1.0, interval=0.5), model.simulate(stop=1.0, interval=0.0137)
    assert coarse["x"][-1] == fine["x"][-1]
    assert coarse["F"][-1] == fine["F"][-1]
    x, v = 1.0, 0.0
    for _ in range(10):  # exact between samples: constant force
        force = -4.0 * x - 2.0 * v
        x, v = x + 0.1 * v + 0.005 * force, v + 0.1 * force
    assert coarse["x"][-1] == pytest.approx(x, abs=1e-12)


def test_initial_and_terminal_and_terminate() -> None:
    text = """
    when initial() then n = 10; end when;
    when h <= 0.5 m then terminate("half way"); end when;
    when terminal() then m = n + 1; end when;
    """
    motion = ball("discrete Integer n(start = 0), m(start = 0);", equations=text).simulate(stop=3.0)
    assert motion["n"][0] == 10.0 and motion["m"][-1] == 11.0
    assert motion.time[-1] == pytest.approx(math.sqrt(1.0 / G), abs=1e-9)
    assert motion.events[-1].kind == "terminate" and motion.events[-1].name == "half way"


def test_flow_of_data_at_one_event() -> None:
    text = "when h <= 0.5 m then b = a + 1; a = pre(a) + 10; end when;"
    motion = ball("discrete Real a(start = 1), b(start = 0);", equations=text).simulate(stop=1.0)
    assert (motion["a"][-1], motion["b"][-1]) == (11.0, 12.0)


def test_events_tell_what_brought_them() -> None:
    text = """
    when sample(0.1 s, 0.2 s) then n = pre(n) + 1; end when;
    when {h <= 0.5 m, der(h) < -4 m/s} then reinit(der(h), 0); end when;
    """
    motion = ball("discrete Integer n(start = 0);", equations=text).simulate(stop=0.75)
    half = math.sqrt(1.0 / G)
    fast = half + 4.0 / G
    assert [(e.kind, e.name) for e in motion.events] == [
        ("tick", "sample(0.1 s, 0.2 s)"),
        ("tick", "sample(0.1 s, 0.2 s)"),
        ("true", "h <= 0.5 m"),
        ("reinit", "der(h)"),
        ("tick", "sample(0.1 s, 0.2 s)"),
        ("tick", "sample(0.1 s, 0.2 s)"),
        ("true", "der(h) < -4 m/s"),
        ("reinit", "der(h)"),
    ]
    times = [0.1, 0.3, half, half, 0.5, 0.7, fast, fast]
    assert [e.time for e in motion.events] == pytest.approx(times, abs=1e-9)
    assert repr(motion.events[0]) == "<Event 0.1 s: sample(0.1 s, 0.2 s) tick>"


def test_reinit_keeps_the_constraints() -> None:
    text = """
    model Pendulum
      parameter Length l = 1 m;
      coordinate Length x(start = 1 m), y(start = 0 m);
      gravity = -g_n*world.y;
      mass 1 kg at {x, y};
      constraint x^2 + y^2 = l^2;
    equation
      when x <= 0.5 m then
        reinit(der(x), -1 m/s);
      end when;
    end Pendulum;
    """
    motion = lagdsl.compile(text).simulate(stop=0.6)
    (_, event) = motion.events
    after = int(np.flatnonzero(motion.time == event.time)[-1])
    assert motion["der(x)"][after] == pytest.approx(-1.0)
    assert motion["der(y)"][after] == pytest.approx(-0.5 / math.sqrt(0.75), rel=1e-7)
    assert np.max(motion.velocity_residual) < 1e-9


def test_chattering_ends_with_a_diagnostic() -> None:
    text = """
    model Slider
      coordinate Length x(der(start = 1 m/s));
      kinetic 1/2*(1 kg)*der(x)^2;
      force -(3 N)*sign(der(x)) on x;
    end Slider;
    """
    with pytest.raises(SimulationFailed) as failure:
        lagdsl.compile(text).simulate(stop=1.0)
    assert failure.value.diagnostic.code == "E0804"
    assert failure.value.time == pytest.approx(1.0 / 3.0, abs=1e-9)


def test_two_resets_at_one_instant() -> None:
    text = "when h <= 0 then reinit(der(h), 1 m/s); end when; when h <= 0 then reinit(der(h), 2 m/s); end when;"
    with pytest.raises(SimulationFailed) as failure:
        ball(equations=text).simulate(stop=1.0)
    assert failure.value.diagnostic.code == "E0832"


def test_impact_in_a_clause_balances_momentum() -> None:
    text = """
    model Two
      coordinate Length x(der(start = 3 m/s)), y(start = 1 m);
      kinetic 1/2*(2 kg)*der(x)^2 + 1/2*(1 kg)*der(y)^2;
    equation
      when x >= y then
        impact(y - x, 0.5);
      end when;
    end Two;
    """
    motion = lagdsl.compile(text).simulate(stop=1.0)
    # m1 v1 + m2 v2 kept, relative velocity -0.5 of what it was
    assert motion["der(x)"][-1] == pytest.approx(1.5, abs=1e-12)
    assert motion["der(y)"][-1] == pytest.approx(3.0, abs=1e-12)


def test_compliant_contact_without_damping_is_elastic() -> None:
    motion = ball(items="contact floor: h >= 0 with compliance = 1e4 N/m;").simulate(stop=2.0, tolerance=1e-11)
    assert float(np.max(motion["h"][motion.time > 0.6])) == pytest.approx(1.0, abs=1e-4)
    speed = math.sqrt(2.0 * G)
    assert float(np.min(motion["der(h)"])) == pytest.approx(-speed, rel=1e-3)


def test_bouncing_by_reinit_ends_where_the_bounces_accumulate() -> None:
    with pytest.raises(SimulationFailed) as failure:
        ball(equations="when h <= 0 then reinit(der(h), -e*pre(der(h))); end when;").simulate(stop=6.0)
    assert failure.value.diagnostic.code == "E0833"
    assert failure.value.time == pytest.approx(impact_times(0.8, 400)[-1], abs=1e-4)


def test_a_contact_that_starts_inside_is_refused() -> None:
    with pytest.raises(SimulationFailed) as failure:
        ball(items="contact ceiling: 0.5 m - h >= 0 with restitution = e;").simulate(stop=6.0)
    assert failure.value.diagnostic.code == "E0834"
