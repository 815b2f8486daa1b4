"""Impacts, resting and leaving against closed forms; conserved quantities across impacts."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
from choice import engines
from scipy.optimize import brentq

import lagdsl

MODELS = Path(__file__).parents[2] / "models"
G = 9.80665
Engine = Literal["numpy", "c", "tape"]
BOTH = pytest.mark.parametrize("engine", engines(["numpy", "c"]))


@cache
def _model(source: str, engine: Engine) -> lagdsl.Model:
    """A file of models/ or a text."""
    return lagdsl.compile(source if " " in source else MODELS / f"{source}.lag", engine=engine)


def _times(motion: lagdsl.Trajectory, *kinds: str) -> list[float]:
    return [event.time for event in motion.events if event.kind in kinds]


def _rows_at(motion: lagdsl.Trajectory, time: float) -> tuple[int, int]:
    """The rows before and after an event."""
    first, second = np.flatnonzero(motion.time == time)
    return int(first), int(second)


# ---- a ball ----------------------------------------------------------------------------------------------------------


def _impacts(e: float, count: int) -> np.ndarray:
    """Dropped from 1 m: the first after sqrt(2/g), each flight lasts e times the one before."""
    first = math.sqrt(2 / G)
    return first * np.concatenate([[1.0], 1.0 + 2.0 * np.cumsum(e ** np.arange(1, count))])


def test_the_ball_bounces_on_time() -> None:
    """After 62 impacts less than a millionth of the 5 s is left; it rests at the accumulation point."""
    times = _times(_model("bouncing_ball", "c").simulate(), "impact", "closed")
    assert len(times) == 63
    np.testing.assert_allclose(times, [*_impacts(0.8, 62), 9.0 * math.sqrt(2.0 / G)], rtol=0, atol=1e-9)
    times = _times(_model("bouncing_ball_modelica", "c").simulate(), "reinit")
    np.testing.assert_allclose(times, _impacts(0.8, 6), rtol=0, atol=1e-9)


ZENO = """
model Zeno
  parameter Real e = 0.8;
  coordinate Length h(start = 1 m);
  gravity = -g_n*world.y;
  mass 0.1 kg at {0, h};
  contact floor: h >= 0 with restitution = e, v_stick = 0, t_eps = 10 us;
  output Force N = multiplier(floor);
end Zeno;
"""


@pytest.mark.parametrize("e", [0.3, 0.8])
def test_the_bounces_end_where_their_times_accumulate(e: float) -> None:
    """The last impact is the first after which less than `t_eps` is left to the accumulation point."""
    motion = _model(ZENO, "c").simulate(stop=6.0, parameters={"e": e})
    (closed,) = _times(motion, "closed")
    accumulation = math.sqrt(2 / G) * (1 + e) / (1 - e)
    times = _impacts(e, 200)
    last = int(np.argmax(accumulation - times < 1e-5))
    assert closed == pytest.approx(accumulation, abs=1e-10)
    assert len(_times(motion, "impact")) == last + 1
    resting = motion.time > closed
    assert np.max(np.abs(motion["h"][resting])) < 1e-12
    np.testing.assert_allclose(motion["N"][resting], 0.1 * G, rtol=1e-12)


PRESSED = """
model Pressed
  parameter Real d(unit = "s/m") = 0.3;
  parameter Velocity v = 2 m/s;
  coordinate Length h(start = 0.1 m, der(start = -v));
  gravity = 0;
  mass 0.5 kg at {0, h};
  contact floor: h >= 0 with compliance = 1e4 N/m, damping = d;
end Pressed;
"""


@BOTH
@pytest.mark.parametrize("d", [0.05, 0.3])
def test_a_damped_contact_gives_back_what_its_first_integral_says(engine: Engine, d: float) -> None:
    """v dv/(1 + d v) = -k x dx/m: v/d - ln(1 + d v)/d^2 is the same before and after (Hunt, Crossley 1975)."""
    motion = _model(PRESSED, engine).simulate(stop=0.5, parameters={"d": d}, tolerance=1e-11)

    def integral(v: float) -> float:
        return v / d - math.log1p(d * v) / d**2

    expected = brentq(lambda v: integral(-v) - integral(2.0), 1e-3, 2.0, xtol=1e-14)
    assert motion["der(h)"][-1] == pytest.approx(expected, rel=1e-8)


@BOTH
def test_the_ball_leaves_the_table_where_it_falls_with_g(engine: Engine) -> None:
    motion = _model("ball_on_moving_table", engine).simulate()
    first, second = _times(motion, "opened")[:2]
    leave = math.asin(G / (0.02 * 25**2)) / 25
    assert first == pytest.approx(leave, abs=1e-9)
    assert second == pytest.approx(leave + 2 * math.pi / 25, abs=1e-9)


# ---- chains of balls -------------------------------------------------------------------------------------------------


@BOTH
@pytest.mark.parametrize("lifted", [1, 2, 3, 4])
def test_as_many_balls_leave_the_cradle_as_struck_it(engine: Engine, lifted: int) -> None:
    """Speed at the bottom: v^2 = 2 g l (1 - cos 30 deg)."""
    start = {f"theta[{i}]": math.radians(-30) for i in range(1, lifted + 1)}
    motion = _model("newtons_cradle", engine).simulate(stop=0.4, start=start, tolerance=1e-12)
    before, after = _rows_at(motion, next(event.time for event in motion.events if event.kind != "opened"))
    rates = np.array([motion[f"der(theta[{i}])"] for i in range(1, 6)])
    speed = math.sqrt(2 * G / 0.2 * (1 - math.cos(math.radians(30))))
    np.testing.assert_allclose(rates[:, after], [0.0] * (5 - lifted) + [speed] * lifted, atol=1e-9)
    assert np.sum(rates[:, after]) == pytest.approx(np.sum(rates[:, before]), rel=1e-10)
    assert motion.energy[after] == pytest.approx(motion.energy[before], abs=1e-10 * 0.05 * G * 0.2)


CHAIN = """
model Chain
  structural parameter Integer N = 6;
  parameter Mass m[N] = {1 kg, 3 kg, 0.5 kg, 2 kg, 0.7 kg, 5 kg};
  parameter Real e = 1;
  coordinate Length x[N](start = {0, 1, 1.5, 2.5, 3.1, 4}, der(start = {3, 0, -0.3, 0.4, 0, -1}));
  gravity = 0;
  for i in 1:N loop
    mass m[i] at {x[i], 0};
  end for;
  for i in 1:N - 1 loop
    contact c: x[i+1] >= x[i] with restitution = e;
  end for;
end Chain;
"""


def _free_masses(e: float, stop: float) -> tuple[np.ndarray, np.ndarray, list[tuple[float, int]]]:
    """Points on a line from one impact of two neighbors to the next, each with Newton's law."""
    m = np.array([1.0, 3.0, 0.5, 2.0, 0.7, 5.0])
    x, v = np.array([0.0, 1.0, 1.5, 2.5, 3.1, 4.0]), np.array([3.0, 0.0, -0.3, 0.4, 0.0, -1.0])
    impacts: list[tuple[float, int]] = []
    now, last = 0.0, -1
    while True:
        closing = v[:-1] - v[1:]
        left = np.where(closing > 1e-12, np.diff(x) / np.where(closing > 1e-12, closing, 1.0), np.inf)
        if last >= 0:
            left[last] = np.inf
        last = int(np.argmin(left))
        if now + left[last] > stop:
            return x + v * (stop - now), v, impacts
        x, now = x + v * left[last], now + float(left[last])
        i, j = last, last + 1
        p = (1 + e) * (v[i] - v[j]) * m[i] * m[j] / (m[i] + m[j])
        v = v.copy()
        v[i], v[j] = v[i] - p / m[i], v[j] + p / m[j]
        impacts.append((now, last + 1))


@BOTH
@pytest.mark.parametrize("e", [1.0, 0.6])
def test_a_chain_of_unequal_masses_goes_from_impact_to_impact(engine: Engine, e: float) -> None:
    motion = _model(CHAIN, engine).simulate(stop=3.0, parameters={"e": e}, tolerance=1e-12)
    x, v, impacts = _free_masses(e, 3.0)
    assert len(impacts) >= 8
    assert [event.name for event in motion.events] == [f"c[{pair}]" for _, pair in impacts]
    np.testing.assert_allclose(_times(motion, "impact"), [time for time, _ in impacts], rtol=0, atol=1e-9)
    np.testing.assert_allclose([motion[f"x[{i}]"][-1] for i in range(1, 7)], x, atol=1e-10)
    rates = np.array([motion[f"der(x[{i}])"] for i in range(1, 7)])
    np.testing.assert_allclose(rates[:, -1], v, atol=1e-10)
    momentum = np.array([1.0, 3.0, 0.5, 2.0, 0.7, 5.0]) @ rates
    np.testing.assert_allclose(momentum, momentum[0], atol=1e-10)
    if e == 1.0:
        np.testing.assert_allclose(motion.energy, motion.energy[0], rtol=1e-10)


# ---- leaving ---------------------------------------------------------------------------------------------------------


@BOTH
@pytest.mark.parametrize("angle", [1e-4, 0.3])
@pytest.mark.parametrize("speed", [0.0, 0.8])
def test_the_particle_leaves_the_sphere_at_two_thirds(engine: Engine, angle: float, speed: float) -> None:
    """cos = 2/3 cos(theta0) + v0^2/(3 g R)."""
    start = {"der(x)": speed * math.cos(angle), "der(y)": -speed * math.sin(angle)}
    motion = _model("particle_on_sphere", engine).simulate(start=start, parameters={"theta0": angle}, tolerance=1e-11)
    (left,) = _times(motion, "opened")
    row, _ = _rows_at(motion, left)
    expected = 2 / 3 * math.cos(angle) + speed**2 / (3 * G * 0.5)
    assert motion["height"][row] == pytest.approx(expected, abs=1e-8)


@BOTH
@pytest.mark.parametrize("lean", [80.0, 55.0])
def test_the_ladder_leaves_the_wall_at_two_thirds_of_its_height(engine: Engine, lean: float) -> None:
    angle = math.radians(lean)
    motion = _model("ladder_leaving_wall", engine).simulate(parameters={"lean": angle}, stop=0.9, tolerance=1e-11)
    (left,) = _times(motion, "opened")
    row, _ = _rows_at(motion, left)
    assert math.sin(motion["phi"][row]) == pytest.approx(2 / 3 * math.sin(angle), abs=1e-8)


# ---- a box -----------------------------------------------------------------------------------------------------------

BOX = """
model Box
  parameter Length a = 0.2 m, b = 0.1 m;
  parameter Angle tilt = 0;
  parameter Real e = 0.3;
  coordinate Length x, y(start = 0.5 m);
  coordinate Angle th(start = tilt);
  frame box = world.at({x, y, 0}).rotz(th);
  gravity = -g_n*world.y;
  body B(m = 2 kg, Izz = 0.01 kg.m2) on box;
  point L = box - a/2*box.x - b/2*box.y;
  point R = box + a/2*box.x - b/2*box.y;
  contact left: L.y >= 0 with restitution = e;
  contact right: R.y >= 0 with restitution = e;
  output Force N[2] = {multiplier(left), multiplier(right)};
end Box;
"""


@BOTH
def test_a_box_lands_on_two_corners_at_once(engine: Engine) -> None:
    """It bounces like a ball, never turns, and both corners carry half of it."""
    motion = _model(BOX, engine).simulate(stop=2.0)
    first = math.sqrt(2 * 0.45 / G)
    times = _times(motion, "impact")
    assert [event.name for event in motion.events[:2]] == ["left", "right"]
    assert times[0] == times[1] == pytest.approx(first, abs=1e-9)
    assert times[2] == pytest.approx(1.6 * first, abs=1e-9)
    before, after = _rows_at(motion, times[0])
    assert motion["der(y)"][after] == pytest.approx(-0.3 * motion["der(y)"][before], rel=1e-10)
    assert np.max(np.abs(motion["th"])) < 1e-10
    np.testing.assert_allclose([motion["N[1]"][-1], motion["N[2]"][-1]], G, rtol=1e-9)


@BOTH
@pytest.mark.parametrize("tilt", [20.0, -30.0])
def test_a_tilted_box_strikes_with_one_corner_and_rests_on_both(engine: Engine, tilt: float) -> None:
    """The blow of one corner: p = (1 + e) v/(1/m + s^2/I), s its arm."""
    motion = _model(BOX, engine).simulate(stop=6.0, parameters={"tilt": math.radians(tilt)})
    before, after = _rows_at(motion, _times(motion, "impact")[0])
    angle, side = math.radians(tilt), -1.0 if tilt > 0 else 1.0
    arm = side * 0.1 * math.cos(angle) + 0.05 * math.sin(angle)
    blow = -1.3 * motion["der(y)"][before] / (1 / 2.0 + arm**2 / 0.01)
    assert motion["der(y)"][after] - motion["der(y)"][before] == pytest.approx(blow / 2.0, rel=1e-9)
    assert motion["der(th)"][after] == pytest.approx(blow * arm / 0.01, rel=1e-9)
    assert motion["y"][-1] == pytest.approx(0.05, abs=1e-10)
    assert abs(motion["th"][-1]) < 1e-10
    np.testing.assert_allclose([motion["N[1]"][-1], motion["N[2]"][-1]], G, rtol=1e-9)


# ---- walking, slipping, sampling -------------------------------------------------------------------------------------


@BOTH
def test_the_wheel_of_spokes_reaches_the_speed_that_replaces_what_a_step_loses(engine: Engine) -> None:
    """w^2 (1 - k^2) (J + m l^2) = 4 m g l sin(slope) sin(alpha) before landing, the part k of w is kept:
    k = (J + m l^2 cos 2 alpha)/(J + m l^2)."""
    motion = _model("rimless_wheel", engine).simulate(stop=28.0)
    alpha, inertia = math.pi / 8, 1.2
    kept = (0.2 + math.cos(2 * alpha)) / inertia
    speed = math.sqrt(4 * G * math.sin(math.radians(6)) * math.sin(alpha) / inertia / (1 - kept**2))
    landings = np.flatnonzero(np.diff(motion["steps"]) > 0)
    assert motion["speed"][landings[-1]] == pytest.approx(speed, rel=1e-9)
    assert motion["speed"][landings[-1] + 1] == pytest.approx(kept * speed, rel=1e-9)


@BOTH
def test_the_block_stops_and_creeps_as_friction_says(engine: Engine) -> None:
    """dv/(a + b tanh(v/v0)) integrated: (a v - b v0 ln(cosh + b/a sinh))/(a^2 - b^2) is -t but for a constant; at the
    end it creeps at v0 artanh(tan(slope)/mu)."""
    motion = _model("block_on_incline", engine).simulate(tolerance=1e-11)
    a, b, v0 = G * math.sin(math.radians(20)), 0.4 * G * math.cos(math.radians(20)), 1e-3
    v = motion["der(s)"]
    moving = v > 1e-4
    r = v[moving] / v0
    logarithm = r + np.log((1 + np.exp(-2 * r)) / 2 + b / a * (1 - np.exp(-2 * r)) / 2)
    elapsed = (a * v[moving] - b * v0 * logarithm) / (a**2 - b**2)
    np.testing.assert_allclose(elapsed[0] - elapsed, motion.time[moving], atol=1e-9)
    assert v[-1] == pytest.approx(-v0 * math.atanh(a / b), rel=1e-9)


@BOTH
def test_the_clutch_sticks_when_it_has_made_the_speeds_equal(engine: Engine) -> None:
    """The difference of speeds goes down by (sliding - drive)/J1 + (sliding - brake)/J2."""
    motion = _model("clutch", engine).simulate()
    sticks = [event.time for event in motion.events if event.kind == "sticks"]
    assert sticks[0] == pytest.approx(100 / (20 / 0.5 + 30 / 2), abs=1e-9)
    assert sticks[1] == pytest.approx(4.2 + 0.2 * (210 - 40 - 80) / 2 / 55, abs=1e-9)
    stuck = ((motion.time > sticks[0]) & (motion.time < 4.0)) | (motion.time > sticks[1])
    np.testing.assert_allclose(motion["der(a)"][stuck], motion["der(b)"][stuck], atol=1e-9)


def _beat(rate: float) -> tuple[float, float]:
    """Foliot's rate when the next tooth slips off, and the time until then: free flight over the drop, a plastic blow
    that keeps the angular momentum of both, then the wheel pushes."""
    inertia, wheel, weight, ratio, release, drop = 2e-3, 5e-3, 0.1, 8 / 30, 0.35, 0.5 / 30
    a, b = weight / wheel / 2, 2 * ratio * rate
    flight = 2 * drop / (b + math.sqrt(b**2 + 4 * a * drop))
    both = inertia + wheel * ratio**2
    after = (inertia * rate - wheel * ratio * (ratio * rate + 2 * a * flight)) / both
    push = weight * ratio / both
    slipped = math.sqrt(after**2 + 2 * push * (2 * release + rate * flight))
    return slipped, flight + (after + slipped) / push


@BOTH
def test_the_escapement_keeps_time(engine: Engine) -> None:
    """Its beats approach the one that repeats itself."""
    motion = _model("escapement", engine).simulate(stop=40.0, tolerance=1e-11)
    rate = brentq(lambda w: _beat(w)[0] - w, 1.0, 50.0, xtol=1e-14)
    slips = _times(motion, "opened")
    assert np.diff(slips)[-1] == pytest.approx(_beat(rate)[1], abs=1e-9)
    assert abs(motion["der(foliot)"][_rows_at(motion, slips[-1])[0]]) == pytest.approx(rate, rel=1e-9)


def test_the_pendulum_is_swung_up_and_stands() -> None:
    motion = _model("furuta_swing_up", "c").simulate()
    upright = np.abs(np.angle(np.exp(1j * motion["theta"]))) < math.radians(1)
    assert not upright[motion.time < 0.5].any() and upright[motion.time > 8.0].all()


def test_the_arm_puts_its_load_where_it_should() -> None:
    """While it is held it does not move against the hand. (That both engines do the same, tests/models tell.)"""
    motion = _model("pick_and_place", "c").simulate()
    held = motion["held"] > 0
    for column, hand in (("x", "hand_at[1]"), ("y", "hand_at[2]")):
        assert np.ptp((motion[hand] - motion[column])[held]) < 1e-10
    assert motion["y"][held].max() > 0.15
    assert motion["x"][-1] == pytest.approx(0.3, abs=2e-3)
    assert abs(motion["y"][-1]) < 1e-12 and abs(motion["der(x)"][-1]) < 1e-6


@BOTH
def test_a_sampled_controller_does_not_see_the_rows(engine: Engine) -> None:
    model = _model("furuta_swing_up", engine)
    ends = [model.simulate(stop=0.5, interval=interval) for interval in (0.5, 0.1, 0.0137)]
    names = [name for name in ends[0].names if name != "time"]
    assert len({tuple(float(end[name][-1]) for name in names) for end in ends}) == 1
