"""Steps of energy in place: refraction and reflection, by hand; and corners that several things share."""

from __future__ import annotations

from math import pi, sqrt

import pytest
from attack.rows import Attack, check, model, rows
from choice import engines

FREE = "coordinate Real x(der(start = {})); kinetic 1/2*der(x)^2; "

STEPS = [
    # sum of both velocities: (3 + 1)/sqrt(2) across, (3 - 1)/sqrt(2) along; 8 - 2*2.5 = 3 is left across
    Attack(
        "refraction_in_a_plane",
        model(
            "coordinate Real x(der(start = 3)), y(der(start = 1)); kinetic 1/2*(der(x)^2 + der(y)^2); "
            "potential if x + y < 1 then 0 else 2.5;"
        ),
        2.0,
        {"der(x)": 1 + sqrt(3 / 2), "der(y)": -1 + sqrt(3 / 2)},
    ),
    # reduced mass 2*1/3; relative speed 3: 1/2*(2/3)*9 = 3, 5/3 of it are left, center at 1
    Attack(
        "between_two_masses",
        model(
            "coordinate Real x(der(start = 2)), y(start = 1, der(start = -1)); "
            "kinetic 1/2*2*der(x)^2 + 1/2*der(y)^2; potential if y - x > 0.5 then 0 else 4/3;"
        ),
        0.25,
        {"der(x)": 1 + sqrt(5) / 3, "der(y)": 1 - 2 * sqrt(5) / 3},
    ),
    # in the frame of the step, which moves at 1: 2^2 - 2*1.5 = 1
    Attack("moving_step", model(FREE.format(3) + "potential if x - time < 1 then 0 else 1.5;"), 2.0, {"der(x)": 2}),
    Attack(
        "moving_step_that_throws_back",
        model(FREE.format(3) + "potential if x - time < 1 then 0 else 2.5;"),
        2.0,
        {"der(x)": -1, "x": 1.5 - 1.5},
    ),
    Attack(
        "total_derivative",
        model(FREE.format(3) + "lagrangian (if x < 1 then 0 else 2)*der(x);"),
        2.0,
        {"der(x)": 3, "x": 6},
    ),
    # through the well at the speed 4
    Attack(
        "well",
        model(FREE.format(3) + "potential if x > 1 and x < 3.5 then -3.5 else 0;"),
        2.0,
        {"der(x)": 3, "x": 3.5 + 3 * (2 - 1 / 3 - 2.5 / 4)},
    ),
    Attack(
        # 30 is 7 rounds of 4 and 2: it is in the middle, on the way back
        "box",
        model(FREE.format(3) + "potential if x > -1 and x < 1 then 0 else 10;"),
        10.0,
        {"x": 0.0, "der(x)": -3.0},
    ),
    Attack(
        # both move at 2 on the line: 2*1/2*4 = 4; 3 is left
        "on_a_line_by_a_constraint",
        model(
            "coordinate Real x(der(start = 2)), y(der(start = 2)); kinetic 1/2*(der(x)^2 + der(y)^2); "
            "constraint line: y = x; potential if x < 1 then 0 else 1;"
        ),
        1.0,
        {"der(x)": sqrt(3), "der(y)": sqrt(3)},
    ),
    Attack(
        # the inertia of a wheel that takes something along from one radian on keeps its energy
        "inertia_in_place",
        model("coordinate Real a(der(start = 3)); kinetic 1/2*(if a < 1 then 1 else 9)*der(a)^2;"),
        2.0,
        {"der(a)": 1.0, "a": 1 + 2 - 1 / 3},
    ),
    Attack(
        "potential_that_meets_itself",
        model(FREE.format(1) + "potential if x < 1 then 0 else 1/2*4*(x - 1)^2;"),
        1 + pi / 4,
        {"x": 1.5, "der(x)": 0.0},
    ),
    Attack(
        # 16 - 2*3.5 = 9, 9 - 2*2.5 = 4
        "stairs",
        model(FREE.format(4) + "potential (if x < 1 then 0 else 3.5) + (if x < 2 then 0 else 2.5);"),
        1.0,
        {"der(x)": 2, "x": 2 + 2 * (1 - 1 / 4 - 1 / 3)},
    ),
]

FROM = "coordinate Real x(start = {}, der(start = {})); kinetic 1/2*der(x)^2; "
ON_BORDERS = [
    # at the start the text says on which side of the step it is
    Attack(
        "start_on_a_border", model(FROM.format(1, 2) + "potential if x <= 1 then 0 else 1.5;"), 1.0, {"der(x)": 1.0}
    ),
    Attack("start_behind_it", model(FROM.format(1, 2) + "potential if x < 1 then 0 else 1.5;"), 1.0, {"der(x)": 2.0}),
    Attack(
        "start_down_a_step",
        model(FROM.format(1, -2) + "potential if x < 1 then 0 else 1.5;"),
        1.0,
        {"der(x)": -sqrt(7), "x": 1 - sqrt(7)},
    ),
    Attack(
        "start_of_inertia_on_a_border",
        model("coordinate Real a(der(start = 3)); kinetic 1/2*(if a <= 0 then 1 else 9)*der(a)^2;"),
        1.0,
        {"der(a)": 1.0},
    ),
    Attack(
        "falls_from_rest",
        model(FROM.format(1, 0) + "force -2 on x; potential if x < 1 then 0 else 1.5;"),
        1.0,
        {"der(x)": -2 - sqrt(3), "x": -sqrt(3)},
    ),
    Attack(
        "pressed_against_a_step",
        model(FROM.format(1, 0) + "force 2 on x; potential if x <= 1 then 0 else 1.5;"),
        1.0,
        {"x": 1.0},
        refused=("E0833", "E0908"),
    ),
    Attack(
        # 2 is 1 on the step, half of it comes back, and down it goes
        "contact_on_a_step",
        model(FROM.format(0, 2) + "potential if x < 1 then 0 else 1.5; contact w: x <= 1 with restitution = 0.5;"),
        1.5,
        {"der(x)": -sqrt(3.25), "x": 1 - sqrt(3.25)},
    ),
    Attack(
        "clause_on_a_step",
        model(
            FROM.format(0, 2) + "potential if x < 1 then 0 else 1.5;",
            "when x >= 1 then impact(1 - x, 0.5); end when;",
        ),
        1.5,
        {"der(x)": -sqrt(3.25)},
    ),
    Attack(
        # 1/2 v^2 = 3.5 is enough for three stairs
        "many_stairs",
        model(FROM.format(0, sqrt(7)) + "potential floor(x);"),
        2 * (1 / sqrt(7) + 1 / sqrt(5) + 1 / sqrt(3) + 1) - 0.5 / sqrt(7),
        {"x": 0.5, "der(x)": -sqrt(7)},
    ),
    Attack(
        "height_that_another_coordinate_gives",
        # across at y = 1.5: 2^2 - 2*1.5 = 1; then the force -1 along y
        model(
            "coordinate Real x(der(start = 2)), y(start = 0.5, der(start = 1)); kinetic 1/2*(der(x)^2 + der(y)^2);"
            "potential if x < 2 then 0 else y;"
        ),
        2.0,
        {"der(x)": 1.0, "der(y)": 0.0, "y": 2.0},
    ),
    Attack(
        # 2 t is at 1 at 0.5 s; in the frame of the wall 2^2 - 2*1
        "swept_by_a_step",
        model(FROM.format(1, 0) + "potential if x < 2*time then 1 else 0;"),
        2.0,
        {"der(x)": 2 - sqrt(2), "x": 1 + 1.5 * (2 - sqrt(2))},
    ),
    Attack(
        # the wall t^2 throws it at 1, 3 and 5 s: 4, 8 and 12
        "thrown_by_a_wall_that_gains_speed",
        model(FROM.format(1, 0) + "potential if x < time^2 then 1e6 else 0;"),
        6.0,
        {"der(x)": 12.0, "x": 37.0},
    ),
]

# Rest on the border of a relation: accelerations tell the side, at once.
FROM_REST = [
    Attack("rest_on_a_border", model(FROM.format(1, 0) + "force if x < 1 then -1 else -3 on x;"), 1.0, {"x": 0.5}),
    Attack(
        "rest_on_a_border_but_for_rounding",
        model(FROM.format(0.1 + 0.2, 0) + "force if x < 0.3 then -1 else -3 on x;"),
        1.0,
        {"der(x)": -1.0},
    ),
    Attack(
        "rest_on_a_border_beside_an_odometer",
        model(
            FROM.format(1, 0) + "force if x > 1 then 1 else 3 on x;"
            "coordinate Real y(start = 1e9, der(start = 1e8)); kinetic 1/2*der(y)^2;"
        ),
        1.0,
        {"der(x)": 1.0},
    ),
    Attack(
        "rest_side_by_side",
        model(
            "coordinate Real x, y; kinetic 1/2*(der(x)^2 + der(y)^2);"
            "force 1 on x; force if x > y then 0.7 else 0.5 on y;"
        ),
        1.0,
        {"der(y)": 0.7},
    ),
]

CORNERS = [
    Attack(
        # 1/2 v^2 is the integral of sqrt(x) from 0 to 1
        "guarded_root",
        model("coordinate Real x(start = 1); kinetic 1/2*der(x)^2; force -sqrt(max(x, 0)) on x;"),
        3.0,
        {"der(x)": -sqrt(4 / 3)},
    ),
    Attack(
        "corner_of_an_input",
        model("coordinate Real x; input Real u; kinetic 1/2*der(x)^2; force max(0, u - 0.999) on x;"),
        2.0,
        {"der(x)": 0.001**2},
        inputs={"u": ((0.0, 1.0, 2.0), (0.0, 1.0, 0.0))},
        near=1e-10,
    ),
    Attack(
        # both are in their strips from 1 to 1.01 s: a tent
        "where_two_meet",
        model(
            "coordinate Real x(der(start = 1)), y(der(start = 2)); state Real z; kinetic 1/2*(der(x)^2 + der(y)^2);",
            "der(z) = min(max(0, 0.005 - abs(x - 1.005)), max(0, 0.01 - abs(y - 2.01)));",
        ),
        3.0,
        {"z": 0.005**2},
        near=1e-12,
    ),
    Attack(
        "saw_of_an_angle",
        model("coordinate Real a(der(start = 10)); state Real z; kinetic 1/2*der(a)^2;", "der(z) = wrap(a);"),
        10.0,
        # 100 rad are 16 turns but for 0.531
        {"z": (100 - 32 * pi) ** 2 / 20},
    ),
    Attack(
        "stairs_of_place",
        model("coordinate Real x(der(start = 2)); state Real z; kinetic 1/2*der(x)^2;", "der(z) = ceil(10*x);"),
        1.02,
        {"z": sum(range(1, 21)) * 0.05 + 21 * 0.02},
    ),
    Attack(
        "damped_to_rest",
        model("coordinate Real x(start = 1); kinetic 1/2*der(x)^2; force -4*der(x) - 4*x - 1e-3*max(0, x)^2 on x;"),
        60.0,
        {"x": 0.0},
    ),
    Attack(
        # x'' = -x for x > 0, -4 x below: half periods of pi and pi/2
        "one_sided_spring",
        model("coordinate Real x(start = 1); kinetic 1/2*der(x)^2; potential 1/2*(max(0, x)^2 + 4*min(0, x)^2);"),
        15 * pi,
        {"x": 1.0, "der(x)": 0.0},
        near=1e-7,
    ),
    Attack(
        # v' = -v |v|: v = 1/(1 + t)
        "quadratic_drag",
        model("coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; force -der(x)*abs(der(x)) on x;"),
        9.0,
        {"der(x)": 0.1},
    ),
]

TIME_AND_PLACE = model(
    "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; "
    "force -100*max(0, 1 - abs(x - 1)/0.001) + max(0, 1 - abs(time - 2.5)/1e-3) on x;"
)
AFTER = sqrt(1 - 2 * 0.1) + 1e-3


@rows([*STEPS, *ON_BORDERS, *FROM_REST, *CORNERS])
def test_steps_in_place(row: Attack, engine: str) -> None:
    check(row, engine)


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))
def test_every_engine_ends_steps_at_corners(engine: str) -> None:
    check(Attack("time_and_place", TIME_AND_PLACE, 3.0, {"der(x)": AFTER}), engine)
