"""One machine in two texts: a coordinate or a constraint, a drive or an input, a clause or a table, `reinit` or a
contact, an expression or a block of the library. All texts of a machine have one reference, or one error."""

from __future__ import annotations

from dataclasses import replace
from math import cosh, sin, sqrt

import pytest
from attack.rows import FIRST, Attack, check, model, rows


def texts(name: str, ways: dict[str, str], stop: float, ends: dict[str, float], **more: object) -> list[Attack]:
    """Rows of one machine."""
    return [Attack(f"{name}_{way}", text, stop, ends, **more) for way, text in ways.items()]  # type: ignore[arg-type]


def of_blocks(body: str) -> str:
    """With units, as blocks of the library have them."""
    return f"model Attacked\nimport Lag.Blocks.*;\n{body}\nend Attacked;\n"


# ---- tracks: level up to x = 0, then rising by 45 degrees; or up by one and level again ------------------------------

ON_TRACK = "coordinate Length x(start = -1 m, der(start = 1 m/s)); gravity = 0; {}; mass 1 kg at {{x, {}.y*(1 m)}};"
TIED = (
    "coordinate Length x(start = -1 m, der(start = 1 m/s)), y; kinetic 1/2*(1 kg)*(der(x)^2 + der(y)^2); {};"
    "constraint c: y = {}.y*(1 m);"
)
RISING = {
    "limiter": "Limiter b(u = x/(1 m), low = 0, high = 99)",
    "table": "Table b(u = x/(1 m), at = {-9, 0, 9}, v = {0, 0, 9})",
}
UP = {
    "limiter": "Limiter b(u = x/(1 m), low = 0, high = 1)",
    "table": "Table b(u = x/(1 m), at = {-9, 0, 1, 9}, v = {0, 0, 1, 1})",
}
TRACKS = [
    row
    for how, text in {"mass_on": ON_TRACK, "constraint": TIED}.items()
    for machine, blocks, ends in (
        ("rising", RISING, {"x": sqrt(2), "der(x)": sqrt(0.5)}),
        ("up", UP, {"x": 3 - sqrt(2), "der(x)": 1.0}),
    )
    for row in texts(f"{how}_{machine}", {n: of_blocks(text.format(b, "b")) for n, b in blocks.items()}, 3.0, ends)
]

# With the weight 8 a track that rises by 45 degrees pushes with 8/sqrt(2) across, 4 and 4 along the axes.
WEIGHT = "gravity = {0, -8, 0}; mass 1 at {x, y}; "
PUSHED = "coordinate Real x(start = -1, der(start = 3)), y; " + WEIGHT + "output Real across = sqrt(2)*multiplier(c); "
FORCES = texts(
    "force_of_a_track",
    {
        "coordinate": model(
            "coordinate Real x(start = -1, der(start = 3)); gravity = {0, -8, 0}; point P = {x, max(0, x)}; "
            "mass 1 at P; output Real across = reaction(P, along = {-1, 1, 0}/sqrt(2));"
        ),
        "constraint": model(PUSHED + "constraint c: y = max(0, x);"),
        "rates": model(PUSHED + "constraint c: der(y) = (if x > 0 then 1 else 0)*der(x);"),
        "contact": model(
            PUSHED.replace("y;", "y(start = 1);", 1) + "contact c: y - max(0, x) >= 0 with restitution = 0;"
        ),
    },
    0.5,
    {"across": 8 / sqrt(2)},
)

# ---- prescribed motion ----------------------------------------------------------------------------------------------

# A slide of 1 on a base that starts to run at 1 s with the speed 1; the spring (9) is between them.
CARRIED = {"seen": -sin(6) / 3}
SLIDE = "coordinate Length x; output Real seen = x/(1 m); potential 1/2*(9 N/m)*x^2; gravity = 0; "
BASES = texts(
    "base",
    {
        "ramp": of_blocks(
            SLIDE + "Ramp r(start = 1 s, duration = 50 s, height = 50); mass 1 kg at {x + r.y*(1 m), 0};"
        ),
        "time_table": of_blocks(
            SLIDE + "TimeTable r(at = {0 s, 1 s, 9 s}, v = {0, 0, 8}); mass 1 kg at {x + r.y*(1 m), 0};"
        ),
        "limiter_of_time": of_blocks(
            SLIDE + "Limiter r(u = time/(1 s) - 1, low = 0, high = 9); mass 1 kg at {x + r.y*(1 m), 0};"
        ),
        "step_of_the_speed": of_blocks(
            SLIDE
            + "coordinate Length s; mass 1 kg at {s + x, 0}; Step v(start = 1 s); constraint c: der(s) = v.y*(1 m/s);"
        ),
        "boolean_input": of_blocks(
            SLIDE + "coordinate Length s; mass 1 kg at {s + x, 0}; input Boolean on; "
            "constraint c: der(s) = if on then 1 m/s else 0 m/s;"
        ),
        "integer_input": of_blocks(
            SLIDE + "coordinate Length s; mass 1 kg at {s + x, 0}; input Integer on; "
            "constraint c: der(s) = if on > 0 then 1 m/s else 0 m/s;"
        ),
        "clause": of_blocks(
            SLIDE + "coordinate Length s; mass 1 kg at {s + x, 0}; discrete Velocity v(start = 0); "
            "constraint c: der(s) = v; equation when time > 1 s then v = 1 m/s; end when;"
        ),
        "pulse": of_blocks(
            SLIDE + "coordinate Length s; mass 1 kg at {s + x, 0}; Pulse v(period = 9 s, start = 1 s); "
            "constraint c: der(s) = v.y*(1 m/s);"
        ),
    },
    3.0,
    CARRIED,
)
BASES = [replace(row, inputs={"on": ((0.0, 1.0, 9.0), (0, 1, 1))}) if "input" in row.name else row for row in BASES]
# A slide on an arm that turns at 2 rad/s from 1 s on: r'' = 4 r.
ARM = "coordinate Real s(start = 1); gravity = 0; "
TURNED = texts(
    "arm",
    {
        "frame": model(ARM + "frame A = world.rotz(max(0, 2*(time - 1))); mass 1 at A.point({s, 0, 0});"),
        "constraint": model(
            ARM + "coordinate Real a; frame A = world.rotz(a); mass 1 at A.point({s, 0, 0}); kinetic 1/2*3*der(a)^2;"
            "constraint c: a = max(0, 2*(time - 1));"
        ),
        "rates": model(
            ARM + "coordinate Real a; frame A = world.rotz(a); mass 1 at A.point({s, 0, 0}); kinetic 1/2*3*der(a)^2;"
            "constraint c: der(a) = if time < 1 then 0 else 2;"
        ),
        "cartesian": model(
            "coordinate Real x(start = 1), y; gravity = 0; mass 1 at {x, y}; output Real s = sqrt(x^2 + y^2); "
            "constraint c: y*cos(max(0, 2*(time - 1))) = x*sin(max(0, 2*(time - 1)));"
        ),
    },
    2.0,
    {"s": cosh(2.0)},
)

# ---- blows ----------------------------------------------------------------------------------------------------------

# A wall at 1 throws a mass back at half of its speed, which a rod shares with a second one: y = 2 x.
FLYING = "coordinate Real x(der(start = 2)); kinetic 1/2*der(x)^2; "
RODS = "coordinate Real x(der(start = 2)), y(der(start = 4)); kinetic 1/2*der(x)^2 + 1/2*3*der(y)^2; "
RODS += "constraint rod: y = 2*x; "
WALLS = {
    "contact": ("contact w: x <= 1 with restitution = 0.5;", ""),
    "reinit": ("", "when x >= 1 then reinit(der(x), -0.5*pre(der(x))); end when;"),
    "impact": ("", "when x >= 1 then impact(1 - x, 0.5); end when;"),
}
BLOWS = [
    *texts("wall", {n: model(FLYING + b, c) for n, (b, c) in WALLS.items()}, 1.0, {"x": 0.5, "der(x)": -1.0}),
    *texts("wall_and_rod", {n: model(RODS + b, c) for n, (b, c) in WALLS.items()}, 1.0, {"x": 0.5, "der(y)": -2.0}),
]
# Between walls at 0 and 1 without loss, from the middle at 3: after 2 s it has been 6 ways.
BOX = (
    "coordinate Length x(start = 0.5 m, der(start = 3 m/s)); kinetic 1/2*(1 kg)*der(x)^2; output Real seen = x/(1 m); "
)
STOPS = texts(
    "stops",
    {
        "contacts": of_blocks(
            BOX + "contact a: x >= 0 with restitution = 1; contact b: x <= 1 m with restitution = 1;"
        ),
        "potential": of_blocks(BOX + "potential if x > 0 and x < 1 m then 0 J else 99 J;"),
        "clauses": of_blocks(BOX + "equation when {x < 0, x > 1 m} then reinit(der(x), -pre(der(x))); end when;"),
        "end_stop": "model Attacked import Lag.Translational.*; SlidingMass load(m = 1 kg, s(start = 0.5 m, "
        "der(start = 3 m/s))); EndStop stop(s_min = 0, s_max = 1 m, e = 1); connect(load.s, stop.s); "
        "output Real seen = load.s/(1 m); end Attacked;",
    },
    2.0,
    {"seen": 0.5},
)
# A rope of 1 becomes taut at the speed 2 and is slack again where something pulls back by 4.
ROPES = texts(
    "rope",
    {
        "contact": model(
            "coordinate Real x(der(start = 2)); kinetic 1/2*der(x)^2; contact c: x <= 1 with restitution = 0; "
            "force (if time > 1 then -4 else 0) on x;"
        ),
        "constraint": model(
            "coordinate Real x(der(start = 2)); kinetic 1/2*der(x)^2; discrete Boolean taut(start = false); "
            "constraint c: (if taut then der(x) else 0) = 0; force (if time > 1 then -4 else 0) on x;",
            "when x >= 1 then taut = true; elsewhen time > 1 then taut = false; end when;",
        ),
        "reinit": model(
            "coordinate Real x(der(start = 2)); kinetic 1/2*der(x)^2; force (if time > 1 then -4 else 0) on x;",
            "when x >= 1 then reinit(der(x), 0); end when;",
        ),
    },
    2.0,
    {"x": -1.0, "der(x)": -4.0},
)
# A mass of 2 becomes one of 1 at 1 s: 4 becomes 8.
SWITCHED = "coordinate Real x(der(start = 4)); kinetic 1/2*{}*der(x)^2; "
MASSES = texts(
    "mass",
    {
        "if": model(SWITCHED.format("(if time < 1 then 2 else 1)")),
        "clause": model(SWITCHED.format("m") + "discrete Real m(start = 2);", "when time >= 1 then m = 1; end when;"),
        "tick": model(SWITCHED.format("m") + "discrete Real m(start = 2);", "when sample(1, 9) then m = 1; end when;"),
        "input": model(SWITCHED.format("(if light then 1 else 2)") + "input Boolean light;"),
        "floor": model(SWITCHED.format("(2 - min(1, floor(time)))")),
    },
    2.0,
    {"der(x)": 8.0, "x": 12.0},
)
MASSES = [
    replace(row, inputs={"light": ((0.0, 1.0, 9.0), (0, 1, 1))}) if "input" in row.name else row for row in MASSES
]

# ---- forces in time -------------------------------------------------------------------------------------------------

# 2 in the second second, 5 from 2 s on: the speed is 2 + 5, the way 1 + 2 + 2.5.
STAIRS = texts(
    "stairs",
    {
        "if": model(FLYING.replace("2", "0", 1) + "force if time < 1 then 0 elseif time < 2 then 2 else 5 on x;"),
        "floor": model(FLYING.replace("2", "0", 1) + "force 2*min(1, floor(time)) + 3*floor(time/2) on x;"),
        "clause": model(
            FLYING.replace("2", "0", 1) + "discrete Real f(start = 0); force f on x;",
            "when sample(1, 9) then f = 2; elsewhen sample(2, 9) then f = 5; end when;",
        ),
        "table_of_whole_numbers": model(FLYING.replace("2", "0", 1) + "input Integer f; force f on x;"),
        "table_with_jumps": model(FLYING.replace("2", "0", 1) + "input Real f; force f on x;"),
    },
    3.0,
    {"der(x)": 7.0, "x": 5.5},
)
HELD = {"f": ((0.0, 1.0, 2.0, 9.0), (0, 2, 5, 5))}
JUMPS = {"f": ((0.0, 1.0, 1.0, 2.0, 2.0, 9.0), (0.0, 0.0, 2.0, 2.0, 5.0, 5.0))}
STAIRS = [replace(row, inputs=HELD if "whole" in row.name else JUMPS) if "table" in row.name else row for row in STAIRS]


@rows([*TRACKS, *FORCES, *BASES, *TURNED, *BLOWS, *STOPS, *ROPES, *MASSES, *STAIRS])
def test_two_formulations(row: Attack, engine: str) -> None:
    check(row, engine)


# A block that jumps is no place of a mass, as its expression is none.
JUMPING = {
    "step": "Step b(start = 0.5 s)",
    "pulse": "Pulse b(period = 9 s, start = 0.5 s)",
    "relay": "Relay b(u = x/(1 m), high = 0.5)",
    "hold": "ZeroOrderHold b(u = x/(1 m), period = 0.5 s)",
    "sampler": "Sampler b(u = x/(1 m), period = 0.5 s)",
}


@pytest.mark.parametrize("name", JUMPING)
@pytest.mark.parametrize(("way", "code"), [(ON_TRACK, "E0836"), (TIED, "E0835")], ids=["mass", "constraint"])
def test_blocks_that_jump_are_no_places(way: str, code: str, name: str) -> None:
    text = of_blocks(way.replace("-1 m, der", "0.1 m, der").format(JUMPING[name], "b"))
    check(Attack(name, text, 3.0, {"x": 99.0}, refused=(code,)), FIRST)
