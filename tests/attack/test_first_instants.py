"""The first instant, by closed forms: the solution of initial equations; conditions that time makes true at once."""

from __future__ import annotations

from math import acos, asin, sqrt

from attack.rows import Attack, check, model, rows

FREE = 'annotation(units = "none");'
CONE = (
    "coordinate Real a(start = 0.5), b(der(start = 4)); "
    "kinetic 1/2*(der(a)^2 + sin(a)^2*der(b)^2); potential -9.81*cos(a);"
)

# At the starts the equations hardly change: Newton's first step leads far away, where they have a solution, too.
NEAREST = [
    Attack(
        # sin(a) (16 cos(a) - 9.81) is largest at a = 0.502; the next zeros are 0.91 and 0
        "steady_rotation_on_a_cone",
        f"model Attacked {CONE} {FREE} initial equation der(b) = 4; der(a) = 0; der(der(a)) = 0; end Attacked;",
        1.0,
        {"a": acos(9.81 / 16), "der(b)": 4.0},
    ),
    Attack(
        "steady_rotation_beside_a_pair_that_is_not_far",
        f"model Attacked {CONE} coordinate Real c, d(start = 1); kinetic 1/2*(der(c)^2 + der(d)^2); {FREE}"
        "initial equation der(b) = 4; der(a) = 0; der(der(a)) = 0; c + d = 1.5; c - d = -0.25; end Attacked;",
        1.0,
        {"a": acos(9.81 / 16), "c": 0.625, "d": 0.875},
    ),
    Attack(
        # sin(x) = 0.3 about its maximum: 0.305 and pi - 0.305 are the next
        "angle_of_a_sine",
        f"model Attacked coordinate Real x(start = 1.57); kinetic 1/2*der(x)^2; {FREE}"
        "initial equation sin(x) = 0.3; der(x) = 0; end Attacked;",
        1.0,
        {"x": asin(0.3)},
    ),
    Attack(
        "state_of_a_cubic",
        # z^3 - 3 z = 1 about the minimum at 1: 1.879... and -0.347... are the next, 2 cos(pi/9) and -2 cos(4 pi/9)
        f"model Attacked state Real z(start = 0.999); {FREE} equation der(z) = 0;"
        "initial equation z^3 - 3*z = 1; end Attacked;",
        1.0,
        {"z": 1.8793852415718169},
    ),
    Attack(
        "root_that_is_alone",
        f"model Attacked coordinate Real x(start = 1); kinetic 1/2*der(x)^2; {FREE}"
        "initial equation x^3 = 1e6; end Attacked;",
        1.0,
        {"x": 100.0},
    ),
    Attack(
        "radius_that_is_far",
        f"model Attacked coordinate Real x(start = 0.1, der(start = 3)); kinetic 1/2*der(x)^2; {FREE}"
        "initial equation x^2 = 50; end Attacked;",
        1.0,
        {"x": sqrt(50) + 3},
    ),
]


@rows(NEAREST)
def test_the_nearest_solution_is_found(row: Attack, engine: str) -> None:
    check(row, engine)


MASS = "coordinate Real x; kinetic 1/2*der(x)^2; discrete Integer n(start = 0);"
ALSO = "discrete Integer m(start = 0);"


def counted(name: str, condition: str, count: int, stop: float = 0.9, items: str = "") -> Attack:
    """Counts the instants at which the condition becomes true."""
    return Attack(name, model(MASS + items, f"when {condition} then n = pre(n) + 1; end when;"), stop, {"n": count})


# A condition that is true at the start does not become true; one that time makes true from the start on does.
AT_ONCE = [
    counted("later_than_the_start", "time > 0", 1),
    counted("not_earlier_than_the_start", "time >= 0", 0),
    counted("first_and_second_half_of_a_sine", "sin(time) > 0", 2, 6.9),
    counted("stairs_that_rise_at_once", "change(stairs)", 4, items="Real stairs = ceil(4*time);"),
    counted("later_than_a_start_that_is_given", "time > start", 1, items="parameter Real start = 0;"),
    Attack(
        "rate_that_is_set",
        model("coordinate Real x; kinetic 1/2*der(x)^2;", "when time > 0 then reinit(der(x), 3); end when;"),
        1.0,
        {"x": 3.0},
    ),
    Attack(
        "beside_the_first_clause",
        model(MASS + ALSO, "when initial() then m = 3; end when; when time > 0 then n = m + 1; end when;"),
        1.0,
        {"m": 3, "n": 4},
    ),
    Attack(
        "acceleration_that_begins_at_once",
        model(MASS + "force if time > 0 then 4 else 0 on x;", "when der(der(x)) > 1 then n = 7; end when;"),
        1.0,
        {"n": 7, "x": 2.0},
    ),
    Attack(
        "start_that_is_not_zero",
        model(
            MASS + ALSO + "annotation(experiment(StartTime = 5));",
            "when time > 5 then n = 1; end when; when time >= 5 then m = 1; end when;",
        ),
        6.0,
        {"n": 1, "m": 0},
    ),
]


@rows(AT_ONCE)
def test_conditions_of_time_at_the_start(row: Attack, engine: str) -> None:
    check(row, engine)
