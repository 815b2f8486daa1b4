"""Rates after an instant at which a prescribed motion, a mass, a Lagrangian or a constraint changes: momenta balance.

Each motion stands against a closed form, or against another formulation of the same machine.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import lagdsl
from lagdsl.motion.signals.trajectory import Trajectory

G = 9.81


@cache
def run(text: str) -> Trajectory:
    return lagdsl.compile(text, engine="tape").simulate()


def last(motion: Trajectory, *names: str) -> list[float]:
    return [float(motion[name][-1]) for name in names]


def free(body: str, speed: float = 1.0) -> Trajectory:
    """One coordinate x, from 0 at this speed."""
    return run(f"""
model Free
  coordinate Length x(start = 0, fixed = true, der(start = {speed}, fixed = true));
  {body}
  annotation(experiment(StopTime = 3));
end Free;
""")


# ---- masses and Lagrangians ------------------------------------------------------------------------------------------


def test_a_mass_that_changes_with_time_keeps_momentum() -> None:
    motion = free("kinetic 1/2*(if time < 1 s then 1 kg else 4 kg)*der(x)^2;")
    assert last(motion, "x", "der(x)") == pytest.approx([1.5, 0.25], abs=1e-9)


def test_a_mass_that_a_clause_changes_keeps_momentum() -> None:
    motion = free(
        "discrete Mass m(start = 1 kg); kinetic 1/2*m*der(x)^2; equation when time >= 1 s then m = 4 kg; end when;"
    )
    assert last(motion, "x", "der(x)") == pytest.approx([1.5, 0.25], abs=1e-9)


def test_a_rate_that_the_same_clause_sets_is_what_it_sets() -> None:
    motion = free(
        "discrete Mass m(start = 1 kg); kinetic 1/2*m*der(x)^2; equation "
        "when time >= 1 s then m = 4 kg; reinit(der(x), 1 m/s); end when;"
    )
    assert last(motion, "x", "der(x)") == pytest.approx([3.0, 1.0], abs=1e-9)


def test_a_term_of_the_lagrangian_that_begins_is_an_impulse() -> None:
    motion = free("kinetic 1/2*(2 kg)*der(x)^2; lagrangian (if time < 1 s then 0 N.s else 1 N.s)*der(x);")
    assert last(motion, "x", "der(x)") == pytest.approx([2.0, 0.5], abs=1e-9)


def test_a_lagrangian_that_is_not_quadratic() -> None:
    """p = gamma m v with c = 1 m/s: v = 0.6 has gamma v = 3/4, a quarter of it afterwards."""
    motion = free(
        "lagrangian -(if time < 1 s then 1 kg else 4 kg)*(1 m/s)^2*sqrt(1 - (der(x)/(1 m/s))^2);",
        speed=0.6,
    )
    v = 0.1875 / np.sqrt(1 + 0.1875**2)
    assert last(motion, "x", "der(x)") == pytest.approx([0.6 + 2 * v, v], abs=1e-9)


def test_the_whole_mechanism_shares_the_momentum() -> None:
    """p_x = x' + m (x' + y') and p_y = m (x' + y') are kept: x' stays, x' + y' becomes a third."""
    motion = run("""
model Coupled
  coordinate Length x(start = 0, fixed = true), y(start = 0, fixed = true);
  discrete Mass m(start = 1 kg);
initial equation
  der(x) = 1 m/s;
  der(y) = 0;
equation
  kinetic 1/2*(1 kg)*der(x)^2 + 1/2*m*(der(x) + der(y))^2;
  when time >= 1 s then
    m = 3 kg;
  end when;
  annotation(experiment(StopTime = 2));
end Coupled;
""")
    assert last(motion, "der(x)", "der(y)", "y") == pytest.approx([1.0, -2 / 3, -2 / 3], abs=1e-9)


def test_rates_jump_with_rows_before_and_after() -> None:
    motion = free("kinetic 1/2*(if time < 1 s then 1 kg else 4 kg)*der(x)^2;")
    first = int(np.searchsorted(motion.time, 1.0))
    assert motion.time[first : first + 2].tolist() == [1.0, 1.0]
    assert motion["der(x)"][first : first + 2] == pytest.approx([1.0, 0.25], abs=1e-9)


# ---- prescribed motion and constraints -------------------------------------------------------------------------------

SPRING = """
model Pulled
  import Lag.Blocks.*;
  import Lag.Translational.*;
  Ramp r(start = 1 s, duration = 10 s, height = 1);
  PositionSource hand(s_ref = (1 m)*r.y);
  Spring spring(k = 4 N/m);
  SlidingMass block(m = 1 kg);
  connect(hand.s, spring.s_a);
  connect(spring.s_b, block.s);
  annotation(experiment(StopTime = 3));
end Pulled;
"""


def test_a_ramp_as_the_way_of_a_source() -> None:
    motion = run(SPRING)
    after = np.maximum(motion.time - 1, 0)
    assert motion["spring.s_b"] == pytest.approx(0.1 * (after - np.sin(2 * after) / 2), abs=1e-9)
    rate = np.where(np.arange(len(motion.time)) > np.searchsorted(motion.time, 1.0), 0.1, 0.0)
    assert motion["der(hand.s)"] == pytest.approx(rate, abs=1e-9)


def test_a_smooth_step_into_a_source() -> None:
    """x'' = 4 (s - x) with the quintic step s from 5 s on in 0.2 s; its convolution with 2 sin 2t."""
    text = SPRING.replace("Ramp r(start = 1 s, duration = 10 s", "SmoothStep r(start = 5 s, duration = 0.2 s")
    motion = run(text.replace("StopTime = 3", "StopTime = 10"))
    nodes, weights = np.polynomial.legendre.leggauss(30)
    times, u = 5.1 + 0.1 * nodes, (1 + nodes) / 2
    during = np.sum(0.1 * weights * 2 * np.sin(2 * (10 - times)) * u**3 * (10 - 15 * u + 6 * u**2))
    assert last(motion, "spring.s_b") == pytest.approx([during + 1 - np.cos(2 * 4.8)], abs=1e-8)


def pendulum(t: np.ndarray, speed: float) -> np.ndarray:
    """A pendulum of 1 m that hangs still and gets the rate -speed at 1 s."""
    found = solve_ivp(
        lambda _, y: [y[1], -G * np.sin(y[0])],
        (0, 2),
        [0.0, -speed],
        "DOP853",
        rtol=1e-12,
        atol=1e-13,
        dense_output=True,
    )
    return np.where(t > 1, found.sol(np.maximum(t - 1, 0))[0], 0.0)


PENDULUMS = {
    "prescribed": """
model Cart
  coordinate Angle th(start = 0, fixed = true);
  gravity = {0, -9.81 m/s2};
  mass 1 kg at {max(0 m, (0.5 m/s)*(time - 1 s)) + (1 m)*sin(th), -(1 m)*cos(th)};
  annotation(experiment(StopTime = 3));
end Cart;
""",
    "constraint": """
model Cart
  coordinate Length X(start = 0);
  coordinate Angle th(start = 0, fixed = true);
  gravity = {0, -9.81 m/s2};
  mass 3 kg at {X, 0};
  mass 1 kg at {X + (1 m)*sin(th), -(1 m)*cos(th)};
  constraint drive: X = table(time, {0, 1, 3}*(1 s), {0, 0, 1}*(1 m));
  annotation(experiment(StopTime = 3));
end Cart;
""",
    "speed": """
model Cart
  coordinate Length X(start = 0, fixed = true);
  coordinate Angle th(start = 0, fixed = true);
  gravity = {0, -9.81 m/s2};
  mass 3 kg at {X, 0};
  mass 1 kg at {X + (1 m)*sin(th), -(1 m)*cos(th)};
  constraint drive: der(X) = (if time < 1 s then 0 m/s else 0.5 m/s);
  annotation(experiment(StopTime = 3));
end Cart;
""",
    "drive": """
model Cart
  import Lag.Planar.*;
  import Lag.Blocks.*;
  Ramp r(start = 1 s, duration = 4 s, height = 2);
  PrismaticDrive cart(way = (1 m)*r.y);
  Revolute th(q(start = 0, fixed = true));
  Body bob(m = 1 kg, com = {0, -1});
  gravity = {0, -9.81 m/s2};
  connect(world, cart, th, bob);
  annotation(experiment(StopTime = 3));
end Cart;
""",
    "reversed drive": """
model Cart
  coordinate Angle th(start = 0, fixed = true);
  Length way = (0.25 m/s)*(abs(time - 1 s) + time - 1 s);
  frame carriage = world.move({way, 0, 0});
  gravity = {0, -9.81 m/s2};
  mass 1 kg at carriage.point({(1 m)*sin(th), -(1 m)*cos(th), 0});
  annotation(experiment(StopTime = 3));
end Cart;
""",
}


@pytest.mark.parametrize("name", PENDULUMS)
def test_a_cart_that_starts_suddenly_swings_its_pendulum(name: str) -> None:
    motion = run(PENDULUMS[name])
    angle = motion["th.q" if name == "drive" else "th"]
    assert angle == pytest.approx(pendulum(motion.time, 0.5), abs=1e-8)


ARMS = {
    "geometry": """
model Arm
  coordinate Length s(start = 1 m, fixed = true);
  Angle turn = (1 rad/s)*max(0 s, time - 1 s);
  mass 1 kg at {s*cos(turn) - (0.5 m)*sin(turn), s*sin(turn) + (0.5 m)*cos(turn)};
  potential 1/2*(5 N/m)*(s - 1 m)^2;
  annotation(experiment(StopTime = 3));
end Arm;
""",
    "drive": """
model Arm
  import Lag.Planar.*;
  RevoluteDrive arm(angle = table(time, {0, 1, 3}*(1 s), {0, 0, 2}));
  Prismatic slide(s(start = 1 m, fixed = true));
  Body bead(m = 1 kg, com = {0, 0.5});
  gravity = 0;
  potential 1/2*(5 N/m)*(slide.s - 1 m)^2;
  connect(world, arm, slide, bead);
  annotation(experiment(StopTime = 3));
end Arm;
""",
    "constraint": """
model Arm
  coordinate Length s(start = 1 m, fixed = true);
  coordinate Angle turn;
  mass 1 kg at {s*cos(turn) - (0.5 m)*sin(turn), s*sin(turn) + (0.5 m)*cos(turn)};
  potential 1/2*(5 N/m)*(s - 1 m)^2;
  constraint turn = (if time > 1 s then (1 rad/s)*(time - 1 s) else 0);
  annotation(experiment(StopTime = 3));
end Arm;
""",
}


@pytest.mark.parametrize("name", ARMS)
def test_an_arm_that_starts_to_turn_kicks_its_bead(name: str) -> None:
    """p_s = s' - e omega is kept; afterwards s'' = omega^2 s - 5 (s - 1)."""
    motion = run(ARMS[name])
    t = np.maximum(motion.time - 1, 0)
    exact = np.where(motion.time > 1, 1.25 - 0.25 * np.cos(2 * t) + 0.25 * np.sin(2 * t), 1.0)
    assert motion["slide.s" if name == "drive" else "s"] == pytest.approx(exact, abs=1e-8)


def test_a_radius_that_begins_to_grow_keeps_the_rate_of_the_angle() -> None:
    motion = run("""
model Swing
  coordinate Angle phi(start = 0, fixed = true);
  Length r = 1 m + max(0 m, (0.5 m/s)*(time - 1 s));
initial equation
  der(phi) = 1 rad/s;
equation
  mass 2 kg at {r*cos(phi), r*sin(phi)};
  annotation(experiment(StopTime = 3));
end Swing;
""")
    t = motion.time
    exact = np.where(t > 1, 1 + 2 * (1 - 1 / (1 + 0.5 * np.maximum(t - 1, 0))), t)
    assert motion["phi"] == pytest.approx(exact, abs=1e-8)


def test_a_way_whose_rate_is_continuous_brings_no_impulse() -> None:
    motion = free(
        "mass 1 kg at {x + (1 m/s2)*max(0 s, time - 1 s)^2, 0}; potential 1/2*(4 N/m)*x^2;",
        speed=0.0,
    )
    t = np.maximum(motion.time - 1, 0)
    assert motion["x"] == pytest.approx(-0.5 * (1 - np.cos(2 * t)), abs=1e-8)
    assert motion.events == ()


def test_a_clutch_that_time_closes() -> None:
    motion = run("""
model Clutch
  coordinate Angle a, b;
  kinetic 1/2*(1 kg.m2)*der(a)^2 + 1/2*(2 kg.m2)*der(b)^2;
  torque 1 N.m on a;
  constraint clutch: (if time < 0.5 s then 0 rad/s else der(a) - der(b)) = 0;
  annotation(experiment(StopTime = 1));
end Clutch;
""")
    assert last(motion, "der(a)", "der(b)") == pytest.approx([1 / 3, 1 / 3], abs=1e-10)
    assert last(motion, "a", "b") == pytest.approx([0.125 + 1 / 12 + 1 / 24, 1 / 12 + 1 / 24], abs=1e-10)


# ---- contacts --------------------------------------------------------------------------------------------------------

WALLS = {
    "max": "max(0 m, (0.5 m/s)*(time - 1 s))",
    "table": "table(time, {0, 1, 5}*(1 s), {0, 0, 2}*(1 m))",
    "limit": "limit((0.5 m/s)*(time - 1 s), 0 m, 2 m)",
}


@pytest.mark.parametrize("name", WALLS)
def test_a_wall_that_starts_to_move_strikes_a_ball(name: str) -> None:
    """It meets the ball, 0.2 m away, at 1.4 s with 0.5 m/s; without loss the ball leaves with 1 m/s."""
    motion = run(f"""
model Wall
  coordinate Length x(start = 0.2 m, fixed = true);
  Length wall = {WALLS[name]};
  kinetic 1/2*(1 kg)*der(x)^2;
  contact hit: x >= wall with restitution = 1;
  annotation(experiment(StopTime = 3));
end Wall;
""")
    assert last(motion, "x", "der(x)") == pytest.approx([0.2 + 1.6, 1.0], abs=1e-9)


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_a_floor_that_starts_to_rise_takes_along_what_rests_on_it(restitution: float) -> None:
    """Closed contacts take part in an impact without restitution."""
    motion = run(f"""
model Lift
  coordinate Length h(start = 0, fixed = true);
  gravity = {{0, -9.81 m/s2}};
  mass 1 kg at {{0, h}};
  contact floor: h >= max(0 m, (0.5 m/s)*(time - 1 s)) with restitution = {restitution};
  annotation(experiment(StopTime = 3));
end Lift;
""")
    assert last(motion, "h", "der(h)") == pytest.approx([1.0, 0.5], abs=1e-9)
