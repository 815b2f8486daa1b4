"""Modes of dry friction against closed forms: groups that share a load, jumps of rates and slips, slips in a plane."""

from __future__ import annotations

from itertools import product
from math import sqrt

import pytest
from choice import chosen

import lagdsl

FEET = """gravity = {0, -10, 0}; coordinate Real x, h, p; mass 2 at {x, h, 0}; kinetic 1/2*der(p)^2; force 2*time on x;
contact a: h - p >= 0 with restitution = 0, friction = 0.5, slip = der(x);
contact b: h >= 0 with restitution = 0, friction = 0.5, slip = der(x);
contact c: h + p >= 0 with restitution = 0, friction = 0.5, slip = der(x);"""
# The limit on the floor follows the force of the wall, and the other way round.
CORNER = """gravity = {0, -10, 0}; coordinate Real x, y; mass 1 at {x, y, 0}; force time on x;
contact floor: y >= 0 with restitution = 0, friction = 0.4, slip = der(x);
contact wall: x >= 0 with restitution = 0, friction = 0.4, slip = der(y);"""
BLOCK = "coordinate Real x; kinetic 1/2*der(x)^2;"
MOVING = "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2;"
PUCK = "coordinate Real x, y; kinetic 1/2*(der(x)^2 + der(y)^2);"
SLIDING_PUCK = "coordinate Real x(der(start = 1)), y; kinetic 1/2*(der(x)^2 + der(y)^2);"
ROLLER = """coordinate Real y, z, s; gravity = {2, -9, 0}; mass 2 at {y, 0, z}; kinetic 1/2*0.01*der(s)^2;
discrete Integer n(start = 0); friction two: {der(y) + 0.1*der(s), der(z)} with limit = 3;"""
# It rests from the start, so that its slips have no terms but the round-off of forces that balance.
TRAIN = """coordinate Real a, b, c; kinetic 1/2*1.7*(der(a) + 0.3*der(b))^2 + 1/2*0.9*(der(b) - 0.7*der(c))^2;
kinetic 1/2*(der(c) + 0.1*der(a))^2; potential 1/2*31.7*(a - 0.3*b)^2 + 1/2*11.3*(b - 0.77*c - 0.01)^2;
force if time < 1.1 then 3.7 else 5.9 on a; force 3*sin(3*time) on b; force 17.7*cos(2*time) on c;
discrete Integer n(start = 0); friction first: der(a) + 0.31*der(b) with limit = 1e5;
friction second: 1.37*der(b) - 0.2*der(c) with limit = 1e4; friction third: der(c) + der(a)/2 with limit = 1e5;"""

# name, body, clauses, stop, end values, modes of friction that are told
CASES = [
    ("three feet slip together", FEET, "", 6.0, {"der(x)": 0.5, "x": 1 / 6}, [(5.0, "slips")] * 3),
    (
        "a block beside a wall that it touches",
        CORNER,
        "",
        8.0,
        {"x": 4.0**3 / 6, "y": 0.0},
        [(4.0, "slips")],
    ),
    (
        "a blow by a clause",
        BLOCK + "friction dry: der(x) with limit = 5;",
        "when time >= 1 then reinit(der(x), 2); end when;",
        2.0,
        {"x": 0.4},
        [(1.0, "slips"), (1.4, "sticks")],
    ),
    (
        "a belt that stops at once",
        MOVING + "friction dry: der(x) - (if time < 1 then 1 else 0) with limit = 5;",
        "",
        2.0,
        {"x": 1.1},
        [(1.0, "slips"), (1.2, "sticks")],
    ),
    (
        "a belt that turns at once",
        SLIDING_PUCK
        + "friction pad: {der(x) - (if time < 1 then 1 else 0), der(y) - (if time < 1 then 0 else 1)}"
        + " with limit = 2*sqrt(2);",
        "",
        2.0,
        {"x": 1.25, "y": 0.75},
        [(1.0, "slips"), (1.5, "sticks")],
    ),
    (
        "a slip in a plane begins where the limit falls",
        PUCK + "force 5 on x; force 1 on y; friction dry: {der(x), der(y)} with limit = 9 - 5*time;",
        "",
        1.0,
        # along (5, 1) with sqrt(26) - 9 + 5 t = 5 (t - t0)
        {"der(x)": 5 / sqrt(26) * 2.5 * (1 - (9 - sqrt(26)) / 5) ** 2},
        [((9 - sqrt(26)) / 5, "slips")],
    ),
    (
        "a slip in a plane begins where the force grows",
        PUCK + "force 5*time on x; force 1 on y; friction dry: {der(x), der(y)} with limit = 4;",
        "",
        0.775,
        {},
        [(sqrt(15) / 5, "slips")],
    ),
    # the roller pulls 2 y'' = 4 + F, s'' = 10 F, y'' = -0.1 s''
    ("rest when forces jump", TRAIN, "when time > 0.77 then n = 1; end when;", 3.0, {"a": 0.0, "b": 0.0}, []),
    ("an instant of another thing", ROLLER, "when time > 0.5 then n = 1; end when;", 3.0, {"y": 6.0, "z": 0.0}, []),
]
# The direction of a slip that begins turns faster than an explicit method likes: four seconds for each of them.
STIFF = ("a slip in a plane begins where the limit falls", "a slip in a plane begins where the force grows")
BOTH = chosen(
    product(CASES, ["dop853", "radau"]),
    [(case, "radau" if case[0] in STIFF or i % 2 else "dop853") for i, case in enumerate(CASES)],
)


@pytest.mark.parametrize(("case", "solver"), BOTH, ids=lambda each: each if isinstance(each, str) else each[0])
def test_motion_and_modes_are_the_known_ones(case: tuple, solver: str) -> None:
    _, body, clauses, stop, ends, modes = case
    section = f"equation {clauses}\n" if clauses else ""
    text = f'model Case\n{body}\nannotation(units = "none");\n{section}end Case;\n'
    motion = lagdsl.compile(text, engine="tape").simulate(stop=stop, solver=solver)
    told = [(event.time, event.kind) for event in motion.events if event.kind in ("slips", "sticks", "reverses")]
    assert [kind for _, kind in told] == [kind for _, kind in modes]
    assert [time for time, _ in told] == pytest.approx([time for time, _ in modes], abs=1e-7)
    for name, value in ends.items():
        assert motion[name][-1] == pytest.approx(value, abs=1e-7), name
