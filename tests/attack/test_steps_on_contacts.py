"""Steps of energy that closed contacts share, and their normals where coordinates are of very different sizes."""

from __future__ import annotations

from math import sqrt

from attack.rows import Attack, check, model, rows

import lagdsl

SLIDES = (
    "coordinate Real x(der(start = 3)), y; kinetic 1/2*(der(x)^2 + der(y)^2); force -10 on y;"
    "contact ground: y >= 0 with restitution = 0.5;"
)
# A pushes B: together they have the speed sqrt(5) after 1 m.
PUSHES = (
    "coordinate Real a(der(start = 2)), b(start = 1, der(start = 2)); kinetic 1/2*(der(a)^2 + der(b)^2);"
    "force 1 on a; contact c: b - a >= 1 with restitution = 0.5;"
)
AT = 2 * (sqrt(5) - 2)
# A bar on two legs at -1 and 1, m = 1, I = 1/3.
BAR = (
    "coordinate Real x(der(start = 3)), y, p; kinetic 1/2*(der(x)^2 + der(y)^2 + der(p)^2/3); force -10 on y;"
    "contact left: y - p >= 0 with restitution = 0.5; contact right: y + p >= 0 with restitution = 0.5;"
)
# The impulse mu (1, 1, 3/2) of a step outside of the legs; the right leg pushes with -11/8 mu (0, 1, 1):
# 19/16 mu^2 + 6 mu + 5 = 0.
TILTED = (sqrt(9 - 5 * 19 / 16) - 3) * 16 / 19

ON_CONTACTS = [
    # the step pushes the mass to the ground: x alone is left, 9 - 5 = 4
    Attack(
        "pushed_to_the_ground",
        model(SLIDES + "potential if x + y < 1 then 0 else 2.5;"),
        1.0,
        {"der(x)": 2.0, "x": 7 / 3},
    ),
    Attack(
        "thrown_back_on_the_ground",
        model(SLIDES + "potential if x + y < 1 then 0 else 6;"),
        1.0,
        {"der(x)": -3.0, "x": -1.0},
    ),
    Attack(
        # across (3 sqrt(2)/2)^2 + 5 = 9.5, along 3 sqrt(2)/2
        "thrown_off_the_ground",
        model(SLIDES + "potential if x + y < 1 then 0 else -2.5;"),
        1 / 3 + 0.1,
        {"der(x)": 1.5 + sqrt(19) / 2, "der(y)": sqrt(19) / 2 - 1.5 - 1},
        {("ground", "opened"): 1},
    ),
    # the ground goes on, and the mass with it, whatever the step takes
    Attack(
        "lift_through_a_step",
        model(
            "coordinate Real y(der(start = 1)); kinetic 1/2*der(y)^2; force -10 on y;"
            "contact c: y >= time with restitution = 0.5; potential if y < 1 then 0 else 50;"
        ),
        2.0,
        {"y": 2.0},
        {("c", "opened"): 0},
    ),
    Attack(
        "pushed_up_a_step",
        model(PUSHES + "potential if b < 2 then 0 else 1.5;"),
        AT + 0.1,
        {"der(a)": sqrt(3.5) + 0.05, "der(b)": sqrt(3.5) + 0.05},
    ),
    Attack(
        "pusher_on_a_step",
        model(PUSHES + "potential if a < 1 then 0 else 1.5;"),
        AT + 0.1,
        {"der(a)": sqrt(2) + 0.1, "der(b)": sqrt(5)},
    ),
    Attack("pushed_back", model(PUSHES + "potential if b < 2 then 0 else 7;"), AT + 0.1, {"der(a)": 0.05 - sqrt(5)}),
    Attack(
        "three_that_push",
        model(
            "coordinate Real a[3](start = {0, 1, 2}, each der(start = 2)); force 1 on a[1];"
            "kinetic 1/2*(der(a[1])^2 + 2*der(a[2])^2 + 3*der(a[3])^2);"
            "for i in 1:2 loop contact p: a[i + 1] - a[i] >= 1 with restitution = 0.2; end for;"
            "potential if a[2] < 2 then 0 else 1.5;"
        ),
        6 * (sqrt(13 / 3) - 2) + 0.1,
        {"der(a[1])": sqrt(10 / 3) + 0.1 / 3, "der(a[3])": sqrt(13 / 3)},
    ),
    Attack(
        "bar_on_two_legs",
        model(BAR + "potential if x + y + p < 1 then 0 else 2.5;"),
        1.0,
        {"der(x)": 2.0, "y": 0.0, "p": 0.0},
    ),
    Attack(
        "bar_between_its_legs",
        model(BAR + "potential if x + y + p/2 < 1 then 0 else 2.5;"),
        1.0,
        {"der(x)": 2.0, "p": 0.0},
    ),
    Attack(
        "bar_outside_its_legs",
        model(BAR + "potential if x + y + 1.5*p < 1 then 0 else 2.5;"),
        1 / 3 + 1e-6,  # on the right leg, y = -p, its weight turns it back at 10/(1 + 1/3)
        {"der(x)": 3 + TILTED, "der(p)": 3 / 8 * TILTED + 7.5e-6},
    ),
]

PLANE = "coordinate Real x(der(start = 3)), y(start = {}); kinetic 1/2*(der(x)^2 + der(y)^2);"
# A circle of 0.1 mm at 1 m, met at 30 degrees above its middle: the square of the normal rate falls from 27/4 by 2.
NORMAL = 3 * sqrt(0.75) - sqrt(27 / 4 - 2)
NORMALS = [
    *(
        # (1, 1) with 3: 2 mu^2 + 6 mu + 4 = 0
        Attack(
            f"beside_{start}",
            model(PLANE.format(start) + "potential if x + y < 1 then 0 else 2;"),
            1.0,
            {"der(x)": 2.0, "der(y)": -1.0},
        )
        for start in ("1e-3", "1e-6", "1e-9", "1e-13", "1e-20", "1e-100")
    ),
    Attack(
        "small_circle",
        model(PLANE.format(0.5e-4) + "potential if norm({x - 1, y}) > 1e-4 then 0 else 1;"),
        1 / 3,
        {"der(x)": 3 - NORMAL * sqrt(0.75), "der(y)": NORMAL * 0.5},
        near=1e-9,
    ),
    Attack(
        # met at 1 s, where it moves at 0.5: 2.5^2 - 2 is left in its frame
        "wall_that_shakes",
        model(
            "coordinate Real x(der(start = 3)); kinetic 1/2*der(x)^2;"
            "potential if x < 3 + 1e-5*sin(50000*(time - 1)) then 0 else 1;"
        ),
        15.0,
        {"der(x)": 0.5 + sqrt(4.25)},
    ),
]


@rows([*ON_CONTACTS, *NORMALS])
def test_steps_on_contacts(row: Attack, engine: str) -> None:
    check(row, engine)


def test_steps_in_place_have_an_effect() -> None:
    """W0514 told to delete a step of energy."""
    body = "coordinate Real x(der(start = 3)); kinetic 1/2*der(x)^2; potential if {} < 1 then 0 else 2.5;"
    codes = {
        place: {each.code for each in lagdsl.compile(model(body.format(place))).diagnostics} for place in ("x", "time")
    }
    assert "W0514" not in codes["x"] and "W0514" in codes["time"]
