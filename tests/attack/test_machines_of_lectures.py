"""Machines of lectures and laboratories in which several things meet: prescribed motion and contact, rolling and
quaternions, loops under sampled control, redundancy and friction. References by hand."""

from __future__ import annotations

from math import cos, exp, pi, sin

from attack.rows import Attack, check, model, rows


def sampled_pd(steps: int, h: float = 0.1, k: float = 4.0, d: float = 2.0) -> tuple[float, float]:
    """A mass of 1 from 1 at rest: x and v after so many periods of a force that is held."""
    x, v = 1.0, 0.0
    for _ in range(steps):
        u = -k * x - d * v
        x, v = x + v * h + u * h * h / 2, v + u * h
    return x, v


def switched_current(periods: int, period: float = 0.2, part: float = 0.25) -> float:
    """i' = u - 2 i with u = 5 for a part of each period."""
    i = 0.0
    for _ in range(periods):
        i = 2.5 + (i - 2.5) * exp(-2 * part * period)
        i *= exp(-2 * (1 - part) * period)
    return i


BEHIND = 1.0 - cos(1.0)
ROLLING = (
    "coordinate Real x, y; coordinate Quaternion e; parameter Real R = 0.5; frame S = world.at({x, y, R}).quat(e); "
    "gravity = {0, 0, -9}; body ball(m = 2, I = {0.2, 0.2, 0.2}) on S; "
    "constraint rolling: der(S.origin) + cross(omega(S), {0, 0, -R}) = {0, 0, 0}; "
)
TRAMMEL = (
    "coordinate Real x, y(start = 1); kinetic 1/2*(der(x)^2 + der(y)^2); constraint bar: x^2 + y^2 = 1; "
    "input Real f; discrete Real u(start = 0); force u*y on x; force -u*x on y;"
)
MACHINES = [
    Attack(
        "lift_that_starts_below_a_mass",
        model(
            "coordinate Real y; gravity = {0, -8, 0}; mass 1 at {0, y}; "
            "contact floor: y >= max(0, time - 1) with restitution = 0;"
        ),
        2.0,
        {"y": 1.0, "der(y)": 1.0},
    ),
    Attack(
        # what rests on the floor is held by it, whatever its restitution
        "lift_that_starts_below_an_elastic_mass",
        model(
            "coordinate Real y; gravity = {0, -8, 0}; mass 1 at {0, y}; "
            "contact floor: y >= max(0, time - 1) with restitution = 1;"
        ),
        1.2,
        {"y": 0.2, "der(y)": 1.0},
    ),
    Attack(
        "pendulum_in_a_falling_lift",
        model(
            "coordinate Real a(start = 0.3, der(start = 2)); gravity = {0, -9, 0}; "
            "mass 1 at {0.5*sin(a), -4.5*time^2 - 0.5*cos(a)};"
        ),
        2.0,
        {"a": 4.3, "der(a)": 2.0},
    ),
    Attack(
        "bead_at_rest_on_a_turning_hoop",
        # cos(a) = g/(R omega^2) = 1/2
        model(
            "coordinate Real a(start = pi/3); frame hoop = world.roty(6*time); gravity = {0, -9, 0}; "
            "mass 1 at 0.5*(sin(a)*hoop.x - cos(a)*hoop.y);"
        ),
        1.0,
        {"a": pi / 3, "der(a)": 0.0},
        near=1e-7,
    ),
    Attack(
        "free_mass_seen_from_a_turntable",
        model(
            "coordinate Real x(start = 1), y; gravity = 0; frame T = world.rotz(2*time); mass 1 at T.point({x, y, 0}); "
            "initial equation der(x) = 0; der(y) = -2;"
        ),
        1.0,
        {"x": cos(2.0), "y": -sin(2.0)},
    ),
    Attack(
        "ball_that_is_pushed_rolls",
        # 1/2 (m + J/R^2) v^2 with J = 0.2: 2 + 0.8
        model(ROLLING + "force {7, 0, 0} at S.origin;"),
        2.0,
        {"der(x)": 5.0, "x": 5.0, "y": 0.0},
    ),
    Attack(
        "ball_that_is_pushed_for_a_while_by_a_table",
        model(ROLLING + "force {7*table(time, {0, 1, 1.5, 2, 9}, {0, 0, 1, 0, 0}), 0, 0} at S.origin;"),
        3.0,
        {"der(x)": 1.25, "x": 1.25 * 1.5},
    ),
    Attack(
        "ball_that_is_stopped_by_a_wall",
        # the wall acts at the centre: rolling goes on, back at half of the speed
        model(ROLLING.replace("x, y;", "x(der(start = 2)), y;") + "contact wall: x <= 1 with restitution = 0.5;"),
        1.0,
        {"x": 0.5, "der(x)": -1.0},
    ),
    Attack(
        "trammel_under_sampled_control",
        # u = 0, 0.5, 1, 1.5 for half a second each
        model(TRAMMEL, "when sample(0, 0.5) then u = f; end when;"),
        2.0,
        {"x": sin(0.875), "y": cos(0.875), "der(x)": 1.5 * cos(0.875)},
        inputs={"f": ((0.0, 9.0), (0.0, 9.0))},
    ),
    Attack(
        "rail_stated_twice_with_friction",
        model(
            "coordinate Real x(der(start = 3)), y; gravity = {0, -8, 0}; mass 2 at {x, y}; constraint a: y = 0; "
            "constraint b: 2*y = 0; output Real normal = multiplier(a) + 2*multiplier(b); "
            "force -0.25*2*8*sign(der(x)) on x;"
        ),
        1.0,
        {"x": 2.0, "der(x)": 1.0, "normal": 16.0},
    ),
    Attack(
        "rates_that_are_set_on_a_rope",
        model(
            "coordinate Real x, y; kinetic 1/2*der(x)^2 + 1/2*5*der(y)^2; constraint rope: x + y = 0;",
            "when time > 1 then reinit(der(x), 3); end when;",
        ),
        2.0,
        {"x": 3.0, "y": -3.0, "der(y)": -3.0},
    ),
    Attack(
        "force_of_a_drive_that_is_loaded",
        model(
            "coordinate Real x; kinetic 1/2*der(x)^2; constraint d: x = time^2; force if time < 1 then 0 else -5 on x; "
            "output Real f = multiplier(d);"
        ),
        2.0,
        {"x": 4.0, "f": 7.0},
    ),
    Attack(
        "force_of_a_drive_seen_at_an_event",
        model(
            "coordinate Real x; kinetic 1/2*der(x)^2; constraint d: x = time^2; force -3*time on x; "
            "Real f = multiplier(d); output Real g = f; discrete Real seen(start = 0);",
            "when sample(0.5, 9) then seen = g; end when;",
        ),
        2.0,
        {"seen": 3.5},
    ),
    Attack(
        "cooling_in_celsius",
        "model Attacked state Temperature T(start = 80 degC); equation der(T) = (20 degC - T)/(10 s); end Attacked;",
        10.0,
        {"T": 293.15 + 60 / exp(1)},
    ),
    Attack(
        "switch_of_a_thermostat",
        # 30 s at 1 K/s from -5 degC on, then held
        "model Attacked state Temperature T(start = -5 degC); "
        "equation der(T) = if T < 25 degC then 1 K/s else 0 K/s; end Attacked;",
        60.0,
        {"T": 298.15},
    ),
    Attack(
        "double_atwood",
        # M = [[6, -1], [-1, 3]], V = 17 b: the accelerations are -1 and -6
        model(
            "coordinate Real a, b; kinetic 1/2*3*der(a)^2 + 1/2*(der(a) + der(b))^2 + 1/2*2*(der(b) - der(a))^2; "
            "potential 17*(3*a - (a + b) - 2*(a - b));"
        ),
        1.0,
        {"a": -0.5, "b": -3.0},
    ),
    Attack(
        "disc_down_an_incline",
        model(
            "coordinate Real x, phi; kinetic 1/2*2*der(x)^2 + 1/2*0.25*der(phi)^2; force 2*9*0.5 on x; "
            "constraint roll: der(x) = 0.5*der(phi); output Real grip = multiplier(roll);"
        ),
        1.0,
        {"x": 1.5, "grip": -3.0},
    ),
    Attack(
        "rocket_that_drops_a_stage",
        # the velocity stays, as the stage takes its momentum along
        model(
            "coordinate Real x; discrete Real m(start = 4); kinetic 1/2*m*der(x)^2; force 8 on x;",
            "when time > 1 then m = 1; reinit(der(x), pre(der(x))); end when;",
        ),
        2.0,
        {"der(x)": 10.0, "x": 1 + 2 + 4.0},
    ),
    Attack(
        "cradle_of_unequal_balls",
        # 4 strikes 2 at 3: 1 and 4; 2 strikes 1: 4/3 and 16/3
        model(
            "coordinate Real a(der(start = 3)), b(start = 1), c(start = 2); "
            "kinetic 1/2*(4*der(a)^2 + 2*der(b)^2 + der(c)^2); contact p: b - a >= 0.5 with restitution = 1; "
            "contact q: c - b >= 0.5 with restitution = 1;"
        ),
        0.5,
        {"der(a)": 1.0, "der(b)": 4 / 3, "der(c)": 16 / 3},
    ),
    Attack(
        "bounces_that_are_counted",
        # flights of 2, 1, 1/2 ... after 1: five impacts by 2.9
        model(
            "coordinate Real h(start = 4); discrete Integer n(start = 0); gravity = {0, -8, 0}; mass 1 at {0, h}; "
            "contact floor: h >= 0 with restitution = 0.5;",
            "when impacts(floor) > pre(n) then n = impacts(floor); end when;",
        ),
        2.9,
        {"n": 5},
    ),
    Attack(
        "pulses_into_a_coil",
        "model Attacked import Lag.Blocks.*; Pulse u(period = 0.2 s, width = 0.25, height = 5); state Current i; "
        "equation der(i) = u.y*(1 A/s) - i/(0.5 s); end Attacked;",
        2.0 - 1e-9,
        {"i": switched_current(10)},
        near=1e-7,
    ),
    Attack(
        "sampled_position_control",
        model(
            "coordinate Real x(start = 1); kinetic 1/2*der(x)^2; discrete Real u(start = 0); force u on x;",
            "when sample(0, 0.1) then u = -4*x - 2*der(x); end when;",
        ),
        2.0,
        {"x": sampled_pd(20)[0], "der(x)": sampled_pd(20)[1]},
    ),
    Attack(
        "teeth_with_play",
        # 1 at 3 crosses the play of 0.5, then both at 1 (2 rests): plastic
        model(
            "coordinate Real a(der(start = 3)), b; kinetic 1/2*der(a)^2 + 1/2*2*der(b)^2; "
            "contact ahead: b - a >= -0.5 with restitution = 0; contact back: a - b >= -0.5 with restitution = 0;"
        ),
        1.0,
        {"der(a)": 1.0, "a": 0.5 + 5 / 6, "b": 5 / 6},
    ),
    Attack(
        "spring_with_a_stop",
        # half a swing to the stop in the middle, thrown back at half: a half swing of half the way, in time pi
        model(
            "coordinate Real x(start = 1); kinetic 1/2*der(x)^2; potential 1/2*x^2; "
            "contact stop: x >= 0 with restitution = 0.5;"
        ),
        pi / 2 + pi / 2,
        {"x": 0.5, "der(x)": 0.0},
        near=1e-7,
    ),
    Attack(
        "top_without_torques",
        # the angular velocity turns in the body at (I3/I1 - 1) w3 = 3
        model(
            "coordinate Quaternion e(omega(start = {1, 0, 3})); frame B = world.quat(e); gravity = 0; "
            "body top(m = 1, I = {1, 1, 2}) on B; Real w[3] = omega(B); "
            "output Real one = w*B.x, two = w*B.y, three = w*B.z;"
        ),
        1.0,
        {"one": cos(3.0), "two": sin(3.0), "three": 3.0},
    ),
    Attack(
        "sleigh_on_a_circle",
        model(
            "coordinate Real x(der(start = 2)), y, a(der(start = 1)); "
            "kinetic 1/2*(der(x)^2 + der(y)^2) + 1/2*3*der(a)^2; constraint edge: der(y)*cos(a) = der(x)*sin(a);"
        ),
        1.0,
        {"x": 2 * sin(1.0), "y": 2 * BEHIND, "a": 1.0},
    ),
    Attack(
        "pendulum_of_equal_times",
        # on a cycloid of R = 1 with g = 4 the way is 4 sin(a/2), and swings with w = sqrt(g/4R) = 1
        model(
            "coordinate Real a(start = 1); gravity = {0, -4, 0}; mass 1 at {a + sin(a), -cos(a)}; "
            "output Real s = 4*sin(a/2);"
        ),
        2.0,
        {"s": 4 * sin(0.5) * cos(2.0)},
    ),
    Attack(
        "charge_in_a_magnetic_field",
        model(
            "coordinate Real x(der(start = 1)), y; kinetic 1/2*(der(x)^2 + der(y)^2); lagrangian 2*x*der(y);",
        ),
        1.0,
        {"x": sin(2.0) / 2, "y": -(1 - cos(2.0)) / 2},
    ),
    Attack(
        "wall_that_meets_a_mass_on_a_rod",
        # rod of 1 with masses 1 at its ends, struck across at one end: 2 at that end, 0 at the other
        model(
            "coordinate Real x, y, a; kinetic 1/2*2*(der(x)^2 + der(y)^2) + 1/2*0.5*der(a)^2; "
            "contact wall: x + 0.5*sin(a) + 0.5 >= max(0, time - 0.25) with restitution = 1;"
        ),
        1.0,
        {"der(x)": 1.0, "der(a)": 2.0, "x": 0.25, "a": 0.5},
    ),
    Attack(
        "driven_slide_that_meets_a_wall_it_cannot_pass",
        model(
            "coordinate Real x; kinetic 1/2*der(x)^2; constraint d: x = time; contact w: x <= 1 with restitution = 0;"
        ),
        2.0,
        {"x": 99.0},
        refused=("E0804",),
    ),
]


@rows(MACHINES)
def test_machines_of_lectures(row: Attack, engine: str) -> None:
    check(row, engine)
