"""Grounds that stop or brake at a corner of time, forces and inputs that jump: what rests flies on, what is pulled
opens, and clauses for accelerations and multipliers act. Everything falls with 8."""

from __future__ import annotations

from math import acos, cos, sin, sqrt

from attack.rows import Attack, check, model, rows

FALLING = "coordinate Real y{}; gravity = {{0, -8, 0}}; mass 1 at {{0, y}}; contact c: y >= {} with restitution = 0.5;"
OPENS = {("c", "opened"): 1}
# A ground that rises with 1 from 1 to 2, as four functions.
LIFTS = {
    "limit": "limit(time - 1, 0, 1)",
    "min_and_max": "min(1, max(0, time - 1))",
    "table": "table(time, {0, 1, 2, 9}, {0, 0, 1, 1})",
    "abs": "(1 + abs(time - 1) - abs(time - 2))/2",
}
THROWN = {"y": 1 + 0.2 - 4 * 0.04, "der(y)": 1 - 8 * 0.2}
ANGLE = acos(0.8 - 0.15)  # of a mass on a rod, where its ground stops


def swung(stop: float, steps: int = 20000) -> float:
    """An angle under 9 sin(a), from that angle at the rate that the ground gave it: Runge and Kutta's method."""
    a, v, h = ANGLE, 0.3 / sin(ANGLE), stop / steps
    for _ in range(steps):
        k1 = -9 * sin(a)
        k2 = -9 * sin(a + h / 2 * v)
        k3 = -9 * sin(a + h / 2 * v + h * h / 4 * k1)
        k4 = -9 * sin(a + h * v + h * h / 2 * k2)
        a, v = a + h * v + h * h / 6 * (k1 + k2 + k3), v + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return a


GROUNDS = [
    *(
        Attack(f"ground_that_stops_by_{n}", model(FALLING.format("", way)), 2.2, THROWN, OPENS)
        for n, way in LIFTS.items()
    ),
    *(
        Attack(f"ground_that_brakes_by_{n}", model(FALLING.format("(der(start = 1))", way)), 1.3, ends, OPENS)
        for ends in [{"y": 1.3 - 4 * 0.09, "der(y)": 1 - 8 * 0.3}]
        for n, way in {"max": "time - 6*max(0, time - 1)^2", "limit": "time - 6*limit(time - 1, 0, 9)^2"}.items()
    ),
    Attack(
        "stack_on_a_ground_that_stops",
        model(
            FALLING.format("", LIFTS["limit"])
            + "coordinate Real z; mass 2 at {0, z}; contact d: z >= y with restitution = 0.7;"
        ),
        2.2,
        THROWN | {"z": THROWN["y"], "der(z)": THROWN["der(y)"]},
        OPENS,
    ),
    Attack(
        "grounds_that_stop_in_components",
        "model Ball input Real ground; parameter Real e = 0; coordinate Real y; mass 1 at {0, y};"
        ' contact c: y >= ground with restitution = e; annotation(units = "none"); end Ball;'
        " model Pair input Real ground; replaceable model Part = Ball;"
        " Part part[2](each ground = ground, e = {0.5, 0.2});"
        ' annotation(units = "none"); end Pair;'
        " model House gravity = {0, -8, 0}; Real way = table(time, {0, 1, 2, 9}, {0, 0, 1, 1});"
        ' Pair one(ground = way), two(ground = 2*way); annotation(units = "none"); end House;',
        2.3,
        {  # in the first pair both are back after 1/4 at -1, and leave with 1/2 and 1/5
            "one.part[1].y": 1 + 0.5 * 0.05 - 4 * 0.0025,
            "one.part[2].y": 1.0,
            "two.part[1].y": 2 + 2 * 0.3 - 4 * 0.09,
            "two.part[2].y": 2 + 2 * 0.3 - 4 * 0.09,
        },
    ),
    Attack(
        "ground_that_stops_under_a_mass_on_a_rod",
        model(
            "coordinate Real x(start = 0.6), y(start = -0.8); gravity = {0, -9, 0}; mass 1 at {x, y};"
            "constraint rod: x^2 + y^2 = 1;"
            "contact c: y >= -0.8 + 0.3*limit(time - 0.2, 0, 0.5) with restitution = 0.4;"
        ),
        0.72,
        {"x": sin(swung(0.02)), "y": -cos(swung(0.02))},
        OPENS,
    ),
]

LIFTED = {"y": 1.0, "der(y)": 4.0}
FORCES = [
    Attack(
        "lifted_by_an_input_that_jumps",
        model("input Real u; force u on y;" + FALLING.format("", "0")),
        1.5,
        LIFTED,
        OPENS,
        inputs={"u": ((0.0, 1.0, 1.0, 9.0), (0.0, 0.0, 16.0, 16.0))},
    ),
    *(
        Attack(
            f"lifted_by_a_slope_of_{n}",
            model(FALLING.format("", "0") + f"Real s = {s}; force 16*der(s) on y;"),
            1.5,
            LIFTED,
            OPENS,
        )
        for n, s in {"max": "max(0, time - 1)", "table": "table(time, {0, 1, 9}, {0, 0, 8})"}.items()
    ),
    Attack(
        "lifted_by_an_acceleration",
        model(FALLING.format("", "0") + "Real s = max(0, time - 1)^2; force 8*der(der(s)) on y;"),
        1.5,
        LIFTED,
        OPENS,
    ),
    Attack(
        # the force is zero but for round-off of the time where its first piece begins
        "pushed_by_a_pulse_from_rest_in_contact",
        model(
            "coordinate Real a(start = -0.5, der(start = 1.5)), b; kinetic 1/2*der(a)^2 + der(b)^2;"
            "contact c: b - a >= 0.1 with restitution = 0; force 1e5*max(0, 1 - abs(time - 0.4942)/1e-05) on a;"
        ),
        1.0,
        {"b": (0.4942 - 4 / 15) / 2 + 5 / 6 * 0.5058, "der(a)": 5 / 6, "der(b)": 5 / 6},
        {("c", "closed"): 1, ("c", "opened"): 0, ("c", "impact"): 1},
    ),
    Attack(
        "clause_for_an_acceleration",
        model(
            "coordinate Real x; kinetic 1/2*der(x)^2; Real s = limit(time - 1, 0, 9); force 4*der(s) on x;"
            "discrete Real at(start = -1);",
            "when der(der(x)) > 2 then at = time; end when;",
        ),
        2.0,
        {"at": 1.0, "x": 2.0},
    ),
    Attack(
        "clause_for_a_multiplier",
        model(
            "coordinate Real x, y; kinetic 1/2*(der(x)^2 + der(y)^2); constraint j: x = y; Real s = max(0, time - 1);"
            "force 4*der(s) on x; discrete Real at(start = -1);",
            "when multiplier(j) < -1 then at = time; end when;",
        ),
        2.0,
        {"at": 1.0, "x": 1.0},
    ),
    Attack(
        # by its line a jump comes at a time at which the sum, rounded, is still below the next whole number
        "stairs_far_from_zero",
        model("coordinate Real x; kinetic 1/2*der(x)^2; force floor((time + 10000)/0.1) - 100000 on x;"),
        1.0,
        {"der(x)": 4.5, "x": 1.425},
    ),
]

# Energies that rise steeply: no step leads over the jump of the force.
HILLS = [
    Attack(
        f"two_that_pass_a_hill_{width:g}_wide_at_{tolerance:g}",
        model(
            "coordinate Real x(start = -1, der(start = 1)), y(start = 1, der(start = -1)); "
            "kinetic 1/2*(der(x)^2 + der(y)^2); "
            f"potential 0.3*max(0, 1 - abs(y - x)/{width});"
        ),
        3.0,
        {"der(x)": 1.0, "x": 2.0 + width * (1 - 2 / (1 + sqrt(0.7)))},
        tolerance=tolerance,
    )
    for width, tolerance in ((1e-4, 1e-10), (1e-5, 1e-10), (1e-3, 1e-12))
]


@rows([*GROUNDS, *FORCES, *HILLS])
def test_forces_that_jump(row: Attack, engine: str) -> None:
    check(row, engine)
