"""Dry friction that sticks: constraints that clauses switch, exact instants of break-away, limits that are touched."""

from __future__ import annotations

from math import atan, cos, pi, sin, sqrt

from attack.rows import Attack, check, model, rows


def sticks(s: str, speed: str, row: str, limit: str, touch: str = "") -> str:
    """A clause: sticks where the sliding turns back, breaks away beyond the limit, or at it with `=` as `touch`."""
    return (
        f"when {s}*({speed}) < 0 then {s} = 0; elsewhen multiplier({row}) <{touch} -({limit}) then {s} = 1; "
        f"elsewhen multiplier({row}) >{touch} {limit} then {s} = -1; end when; "
    )


BLOCK = (
    "coordinate Real x; kinetic 1/2*der(x)^2; discrete Integer slip(start = 0); force -2*slip on x; "
    "constraint stick: (if slip == 0 then der(x) else 0) = 0; "
)
EQUAL = BLOCK.replace("-2*slip", "-3*slip")  # what it bears sliding and sticking is the same
ENDS = sticks("slip", "der(x)", "stick", "3")
TOUCHES = sticks("slip", "der(x)", "stick", "3", "=")
STACK = (
    "coordinate Real a, b; kinetic 1/2*der(a)^2 + 1/2*der(b)^2; discrete Integer p(start = 0), q(start = 0); "
    "constraint ground: (if p == 0 then der(a) else 0) = 0; "
    "constraint upper: (if q == 0 then der(b) - der(a) else 0) = 0; "
    "force time on b; force -p on a; force 2*q on a; force -2*q on b;"
)


def carried(limit: float, sliding: float, stop: float) -> dict[str, float]:
    """A mass of 1 on a spring of 2 and a belt with the speed 1/2: sticks up to the limit, swings back, sticks."""
    w, speed = sqrt(2.0), 0.5
    out = (limit - sliding) / w**2
    swing = 2 * (pi - atan(out * w / speed)) / w
    t, x = 0.0, 0.0
    while True:
        broken = t + (limit / w**2 - x) / speed
        if broken > stop:
            return {"x": x + speed * (stop - t), "der(x)": speed}
        s = min(swing, stop - broken)
        t, x = broken + s, sliding / w**2 + out * cos(w * s) + speed / w * sin(w * s)
        if s < swing:
            return {"x": x, "der(x)": speed * cos(w * s) - out * w * sin(w * s)}


BELT = BLOCK.replace("coordinate Real x;", "coordinate Real x(der(start = 0.5)); potential x^2;").replace(
    "then der(x) else", "then der(x) - 0.5 else"
)
BREAK_AWAY = [
    Attack("ramp", model(BLOCK + "force 2*time on x;", ENDS), 3.0, {"x": 2.25, "der(x)": 3.75}),
    *(
        Attack(
            f"ramp_of_{c}_equal",
            model(EQUAL + f"force {c}*time on x;", ENDS),
            5.0,
            {"der(x)": c / 2 * (5 - 3 / c) ** 2},
        )
        for c in (0.7, 1.0, 3.0)
    ),
    Attack(
        "stack",
        model(STACK, sticks("p", "der(a)", "ground", "1") + sticks("q", "der(b) - der(a)", "upper", "2")),
        5.0,
        # the lower breaks away at 1, both have (t - 1)/2, the upper at 3 with the speed 1
        {"der(a)": 3.0, "der(b)": 5.0},
    ),
    *(
        Attack(
            f"belt_{limit}",
            model(BELT.replace("-2*slip", "-slip"), sticks("slip", "der(x) - 0.5", "stick", str(limit))),
            20.0,
            carried(limit, 1.0, 20.0),
        )
        for limit in (1.5, 1.0)
    ),
    Attack(
        "three_blocks_equal",
        # all have (2 t - 3)/3, the top slips at 3.75 and has 3/2, the middle at 4.75 and has 5/2: differences of
        # accelerations are round-off there
        model(
            "coordinate Real a, b, c; kinetic 1/2*(der(a)^2 + der(b)^2 + der(c)^2); "
            "discrete Integer p(start = 0), q(start = 0), r(start = 0); force 2*time - 3*p + 4*q on a; "
            "force -4*q + 1.5*r on b; force -1.5*r on c; constraint ground: (if p == 0 then der(a) else 0) = 0; "
            "constraint middle: (if q == 0 then der(b) - der(a) else 0) = 0; "
            "constraint top: (if r == 0 then der(c) - der(b) else 0) = 0;",
            sticks("p", "der(a)", "ground", "3")
            + sticks("q", "der(b) - der(a)", "middle", "4")
            + sticks("r", "der(c) - der(b)", "top", "1.5"),
        ),
        6.0,
        {"der(a)": 8.375, "der(b)": 6.8125, "der(c)": 5.0625},
    ),
    Attack(
        "two_discs_stick_at_once",
        model(
            "coordinate Real a(der(start = 4)), b, c(der(start = -4)); kinetic 1/2*(der(a)^2 + der(b)^2 + der(c)^2); "
            "discrete Integer p(start = 1), q(start = -1); force -p on a; force p + q on b; force -q on c; "
            "constraint s: (if p == 0 then der(a) - der(b) else 0) = 0; "
            "constraint r: (if q == 0 then der(c) - der(b) else 0) = 0;",
            sticks("p", "der(a) - der(b)", "s", "1") + sticks("q", "der(c) - der(b)", "r", "1"),
        ),
        6.0,
        {"der(a)": 0.0, "der(b)": 0.0, "der(c)": 0.0, "a": 8.0, "c": -8.0},
    ),
]

# a force that rises to the limit and stays there breaks nothing away, unless the limit itself does
RISES = {
    "min": "min(2*time, 3)",
    "if": "(if time < 1.5 then 2*time else 3)",
    "table": "table(time, {0, 1.5, 9}, {0, 3, 3})",
}
GIVEN = {"F": ((0.0, 1.5, 9.0), (0.0, 3.0, 3.0))}
TOUCHED = [
    *(
        Attack(
            f"{n}_{'touches' if touch else 'stays'}", model(BLOCK + f"force {f} on x;", ends), 3.0, {"der(x)": speed}
        )
        for n, f in RISES.items()
        for touch, ends, speed in ((0, ENDS, 0.0), (1, TOUCHES, 1.5))
    ),
    Attack("input_stays", model(BLOCK + "input Real F; force F on x;", ENDS), 3.0, {"der(x)": 0.0}, inputs=GIVEN),
    Attack(
        "input_touches_a_third",
        model(
            BLOCK.replace("1/2", "1/6") + "input Real F; force F on x;", sticks("slip", "der(x)", "stick", "2.1", "=")
        ),
        5.0,
        {"der(x)": 0.6},
        inputs={"F": ((0.0, 3.0, 9.0), (0.0, 2.1, 2.1))},
    ),
    Attack("input_touches", model(BLOCK + "input Real F; force F on x;", TOUCHES), 3.0, {"der(x)": 1.5}, inputs=GIVEN),
]

# an input has a row at the instant at which the force touches the limit: what acts with it from then on decides
AT_ROWS = [
    Attack(
        f"{n}_at_a_row_to_{after:g}",
        model(BLOCK + f"force {RISES[n]} on x; input Real G; force G on {c};" + other, TOUCHES),
        3.0,
        {"der(x)": speed},
        inputs={"G": ((0.0, 1.5, 1.5, 9.0), (0.0, 0.0, after, after))},
    )
    for n in ("min", "table")
    for c, other, after, speed in (
        ("y", "coordinate Real y; kinetic 1/2*der(y)^2;", 1.0, 1.5),
        ("x", "", 0.5, 2.25),
        ("x", "", -0.5, 0.0),
        ("x", "", -7.0, -3.0),
    )
]

LIFTED = (
    "coordinate Real y; gravity = {0, -10, 0}; mass 1 at {0, y}; contact floor: y >= 0 with restitution = 0; "
    "discrete Integer n(start = 0); "
)
# the force of a contact only pushes: at the instant at which it opens it is zero and not less
PULLS = [
    Attack(
        f"{n}_{c}",
        model(LIFTED + f"force {f} on y;", f"when multiplier(floor) {c} 0 then n = pre(n) + 1; end when;"),
        3.0,
        {"n": 0.0 if c == "<" else 1.0},
        {("floor", "opened"): 1},
    )
    for n, f in {
        "lifted": "4*time",
        "torn": "(if time < 1 then 0 else 12)",
        "at_a_corner": "(if time < 2.5 then 4*time else 10 + 5*(time - 2.5))",
    }.items()
    for c in ("<", "<=")
]

SWINGS = "coordinate Real x; kinetic 1/2*der(x)^2; force cos(time) on x; discrete Integer n(start = 0);"
# a value that comes to its border and stays there: 2 sin(t) above 1 at pi/6, and so on
SATURATED = [
    Attack(
        name,
        model(SWINGS, f"when {condition} then n = pre(n) + 1; end when;"),
        20.0,
        {"n": 4.0},
    )
    for name, condition in {
        "limit": "limit(2*der(x), -1, 1) >= 1",
        "not_below": "not limit(2*der(x), -1, 1) < 1",
        "max": "max(0.5 - der(x), 0) <= 0",
        "squared": "max(0.1 - der(x), 0)^2 <= 0",
        "thirds": "limit(der(x)/0.3, -1/3, 1/3) >= 1/3",
    }.items()
]


@rows(BREAK_AWAY)
def test_break_away(row: Attack, engine: str) -> None:
    check(row, engine)


@rows([*TOUCHED, *AT_ROWS])
def test_touched_limits(row: Attack, engine: str) -> None:
    check(row, engine)


@rows(PULLS)
def test_contacts_only_push(row: Attack, engine: str) -> None:
    check(row, engine)


@rows(SATURATED)
def test_values_that_end_at_their_borders(row: Attack, engine: str) -> None:
    check(row, engine)
