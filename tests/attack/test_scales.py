"""Nearness and smallness are judged by the numbers that enter, not by the rest of the model."""

from __future__ import annotations

from math import cos, exp, sin, sqrt

from attack.rows import Attack, check, model, rows

G = 9.81


def fall(name: str, height: float, odometer: str, stop: float, e: float = 1.0) -> Attack:
    """A ball dropped from a height, one bounce within `stop`; beside it something else in another scale."""
    first = sqrt(2 * height / G)
    speed = G * first
    rest = stop - first
    assert 0 < rest < 2 * e * speed / G
    text = model(
        f"coordinate Real h(start = {height!r}); kinetic 1/2*der(h)^2; potential 9.81*h; "
        f"contact floor: h >= 0 with restitution = {e}; {odometer}"
    )
    ends = {"h": e * speed * rest - G * rest**2 / 2, "der(h)": e * speed - G * rest}
    return Attack(name, text, stop, ends, counts={("floor", "impact"): 1})


def far(start: float, rate: float = 0.0, mass: float = 1.0) -> str:
    return f"coordinate Real odo(start = {start!r}, der(start = {rate!r})); kinetic 1/2*{mass!r}*der(odo)^2;"


def tiny(height: float) -> Attack:
    """A fall from next to nothing in its own time: heights and rates relative to their own size."""
    first = sqrt(2 * height / G)
    stop = 2.0 * first
    scale = repr(1 / height)
    text = model(
        f"coordinate Real h(start = {height!r}, nominal = {height!r}); kinetic 1/2*der(h)^2; potential 9.81*h;"
        f"contact floor: h >= 0 with restitution = 1; output Real part = {scale}*h;"
    )
    return Attack(f"fall_from_{height:g}", text, stop, {"part": 1.0}, counts={("floor", "impact"): 1})


FALLS = [
    fall("alone", 0.01, "", 0.08),
    *(fall(f"beside_an_odometer_at_{x:g}", 0.01, far(x), 0.08) for x in (1e-9, 1e3, 1e5, 1e7, 1e9)),
    *(fall(f"beside_one_that_runs_at_{v:g}", 0.01, far(0.0, v), 0.08) for v in (1e-9, 1e3, 1e6, 1e9)),
    *(fall(f"beside_a_mass_of_{m:g}", 0.01, far(1.0, 1.0, m), 0.08) for m in (1e-18, 1e-9, 1e9, 1e18)),
    *(tiny(h) for h in (1e-12, 1e-9, 1e-6, 1e-3, 1e3, 1e9)),
]

DOCKING = [
    Attack(
        "craft_far_from_the_origin",
        model(
            "coordinate Real a(start = 7e6), b(start = 7000000.005, der(start = -0.01)); "
            "kinetic 1/2*(der(a)^2 + der(b)^2);"
            "contact dock: b - a >= 0 with restitution = 0; output Real gap = b - a;"
        ),
        1.0,
        {"a": 7e6 - 0.5 * 0.005, "der(a)": -0.005, "der(b)": -0.005},
        counts={("dock", "closed"): 1},
        near=1e-9,
    ),
    Attack(
        "craft_far_from_the_origin_bounce",
        model(
            "coordinate Real a(start = 7e6), b(start = 7000000.005, der(start = -0.01)); "
            "kinetic 1/2*(der(a)^2 + der(b)^2);"
            "contact dock: b - a >= 0 with restitution = 1;"
        ),
        1.0,
        {"der(a)": -0.01, "der(b)": 0.0},
        counts={("dock", "impact"): 1},
    ),
    Attack(
        "relation_far_from_the_origin",
        model(
            "coordinate Real a(start = 7e6), b(start = 7000000.005, der(start = -0.01)); "
            "kinetic 1/2*(der(a)^2 + der(b)^2);"
            "discrete Integer n(start = 0); discrete Real at(start = 0);",
            "when b - a < 0 then n = pre(n) + 1; at = time; end when;",
        ),
        1.0,
        {"n": 1, "at": 0.5},
        near=1e-6,
    ),
    Attack(
        "relation_of_something_small",
        model(
            "coordinate Real x(der(start = 1e-9)), odo(start = 1e9, der(start = 1)); "
            "kinetic 1/2*(der(x)^2 + der(odo)^2);"
            "discrete Real at(start = 0);",
            "when x > 1e-9 then at = time; end when;",
        ),
        2.0,
        {"at": 1.0},
    ),
    Attack(
        "light_beside_heavy",
        # a gnat meets a planet
        model(
            "coordinate Real x(start = -1, der(start = 1)), y; kinetic 1/2*1e-18*der(x)^2 + 1/2*1e20*der(y)^2;"
            "contact c: y >= x with restitution = 0.5;"
        ),
        2.0,
        {"x": -0.5, "der(x)": -0.5, "der(y)": 0.0},
        counts={("c", "impact"): 1},
    ),
    Attack(
        "light_on_a_rod",
        # a pendulum of 1e-12 kg beside an oscillator of 1e12 kg
        model(
            "coordinate Real x(start = 0.6), y(start = -0.8), s(start = 1);"
            "kinetic 1/2*1e-12*(der(x)^2 + der(y)^2) + 1/2*1e12*der(s)^2; potential 1e-12*9.81*y + 1/2*4e12*s^2;"
            "constraint rod: x^2 + y^2 = 1; output Real E = 1/2*(der(x)^2 + der(y)^2) + 9.81*y;"
        ),
        2.0,
        {"s": cos(4.0), "der(s)": -2 * sin(4.0), "E": -0.8 * 9.81},
    ),
    Attack(
        "constraint_in_micrometres",
        model(
            "coordinate Real x(start = 6e-7, nominal = 1e-6), y(start = -8e-7, nominal = 1e-6), odo(start = 1e7, "
            "der(start = 1)); kinetic 1/2*(der(x)^2 + der(y)^2 + der(odo)^2);"
            "potential 9.81e-6*y; constraint rod: x^2 + y^2 = 1e-12; output Real r = (x^2 + y^2)*1e12;"
            "output Real E = (1/2*(der(x)^2 + der(y)^2) + 9.81e-6*y)*1e12;"
        ),
        2.0,
        {"r": 1.0, "E": -0.8 * 9.81},
        near=1e-7,
    ),
    Attack(
        "bounces_of_a_giant",
        # 19 bounces from 1e9: the time scale is 1e4.5
        model(
            "coordinate Real h(start = 1e9); kinetic 1/2*der(h)^2; potential 9.81*h; "
            "contact floor: h >= 0 with restitution = 0.8;"
        ),
        sqrt(2e9 / G) * (1 + 2 * sum(0.8**k for k in range(1, 19)) + 0.8**19),
        {"der(h)": 0.0},
        counts={("floor", "impact"): 19},
        near=1e-3,
    ),
    Attack(
        "two_floors_of_two_scales",
        model(
            "coordinate Real h(start = 1), g(start = 1e-6, nominal = 1e-6); kinetic 1/2*(der(h)^2 + 1e12*der(g)^2); "
            "potential 9.81*h + 9.81e6*g;"
            "contact one: h >= 0 with restitution = 1; contact two: g >= 0 with restitution = 1; "
            "output Real part = 1e6*g - h;"
        ),
        1.0,
        {"part": 0.0},
        counts={("one", "impact"): 1, ("two", "impact"): 1},
    ),
]

# Two circles of two sizes, in which nothing couples one with the other.
CIRCLES = (
    "coordinate Real x(start = 6e-7, nominal = 1e-6), y(start = -8e-7, nominal = 1e-6);"
    "coordinate Real p(start = 6e5, nominal = 1e6), q(start = -8e5, nominal = 1e6);"
    "kinetic 1/2*(der(x)^2 + der(y)^2 + der(p)^2 + der(q)^2); potential 9.81e-6*y + 9.81e6*q;"
    "constraint small: x^2 + y^2 = 1e-12; constraint large: p^2 + q^2 = 1e12;"
)

BESIDE = [
    Attack(
        "micrometres_beside_a_thousand_kilometres",
        # both swing like a pendulum of length 1 under 9.81
        model(CIRCLES + "output Real off = 1e6*x - 1e-6*p; output Real r = (x^2 + y^2)*1e12;"),
        2.0,
        {"off": 0.0, "r": 1.0},
        near=1e-7,
    ),
    Attack(
        "micrometres_beside_a_thousand_kilometres_by_rough_steps",
        # the small one stays on its circle though the large one alone decides the steps
        model(CIRCLES + "output Real r = (x^2 + y^2)*1e12; output Real big = (p^2 + q^2)*1e-12;"),
        20.0,
        {"r": 1.0, "big": 1.0},
        tolerance=1e-3,
        near=1e-12,
    ),
    Attack(
        "contradiction_beside_something_fast",
        model(
            "coordinate Real x, y; kinetic 1/2*(der(x)^2 + der(y)^2); constraint one: der(x) = 1;"
            "constraint other: der(x) = 1.001; constraint fast: der(y) = 1e9;"
        ),
        1.0,
        {"x": -1.0},
        refused=("E0603", "E0803"),
    ),
    Attack(
        "contradiction_beside_something_far",
        model(
            "coordinate Real x, y; kinetic 1/2*(der(x)^2 + der(y)^2); constraint one: der(x) = 1e-6;"
            "constraint other: der(x) = 2e-6; constraint fast: der(y) = 1e3;"
        ),
        1.0,
        {"x": -1.0},
        refused=("E0603",),
    ),
]

# A torque of 1e-6 drives the inertia 1e-9 and, by a worm of 1e-6, one of 1e3, up to a stop at 1e-3 after 2 s with the
# rate 1000.
WORM = (
    "coordinate Real a, b; kinetic 1/2*1e3*der(a)^2 + 1/2*1e-9*der(b)^2; force 1e-6 on b; constraint worm: {};"
    "contact stop: a <= 1e-3 with restitution = 0.5; output Real part = 1e6*a; output Real force = {}*multiplier(worm);"
)
WORMS = [
    Attack(
        f"worm_in_units_of_{name}",
        model(WORM.format(row, scale)),
        2.5,
        {"part": 1000 - 250 + 62.5, "der(b)": -250.0, "force": 0.5},
        counts={("stop", "impact"): 1},
    )
    for name, row, scale in (
        ("the_slow_side", "a = 1e-6*b", "1"),
        ("the_fast_side", "1e6*a = b", "1e6"),
        ("none", "1e9*a = 1e3*b", "1e9"),
        ("rates", "der(a) = 1e-6*der(b)", "1"),
    )
]
CHAINS = [
    Attack(
        f"discs_of_{s:g}_and_its_inverse_that_clutches_join",
        # their common rate is that of the heavy ones; with 1e9 the light one between them has no digits left
        model(
            f"coordinate Real x[5](der(start = {{1, 2, 3, 4, 5}})); kinetic 1/2*{s}*(der(x[2])^2 + der(x[4])^2) + "
            f"1/2*{1 / s}*(der(x[1])^2 + der(x[3])^2 + der(x[5])^2);"
            + "".join(
                f"constraint c{i}: (if time < 1 then 0 else der(x[{i}]) - der(x[{i + 1}])) = 0;" for i in range(1, 5)
            )
        ),
        2.0,
        {f"der(x[{i}])": 3.0 for i in range(1, 6)},
        refused=("E0811",) if s > 1e8 else (),
    )
    for s in (1e3, 1e6, 1e9)
]

# Three masses of 1, pushed by 1, of which two rows hold the rates together: the second row from the start, or from 1 s
# on. A factor of a row changes nothing.
ROWS = "coordinate Real x, y, z; kinetic 1/2*(der(x)^2 + der(y)^2 + der(z)^2); force 1 on x;"
HELD = {"der(x)": 2 / 3, "x": 2 / 3, "z": 2 / 3, "force": 1 / 3}
JOINED = {"der(x)": 2 / 3, "der(z)": 2 / 3, "x": 1 / 4 + 1 / 3 + 1 / 6, "z": 1 / 3 + 1 / 6, "force": 1 / 3}
SMALL = [
    Attack(
        f"{name}_of_{small:g}_beside_one_of_{large:g}",
        model(
            f"{ROWS} constraint big: {large:g}*der(x) = {large:g}*der(y); constraint small: {row.format(f'{small:g}')};"
            f"output Real force = -{small:g}*multiplier(small);"
        ),
        2.0,
        ends,
    )
    for large, small in ((1, 1e-12), (1, 1e-30), (1e9, 1e-9))
    for name, row, ends in (
        ("places", "{0}*y = {0}*z", HELD),
        ("rates", "{0}*der(y) = {0}*der(z)", HELD),
        ("a_clutch", "(if time < 1 then 0 else {0}*(der(y) - der(z))) = 0", JOINED),
        ("a_clutch_that_held_another", "(if time < 1 then {0}*der(z) else {0}*(der(y) - der(z))) = 0", JOINED),
    )
]
LANDED = [
    Attack(
        f"contact_of_{small:g}_under_one_of_1",
        model(
            "coordinate Real y(start = 1), z(start = 1.5); kinetic 1/2*(der(y)^2 + der(z)^2);"
            f"force -8 on y; force -8 on z; contact low: {small:g}*y >= 0 with restitution = 0;"
            "contact high: z >= y with restitution = 0;"
        ),
        0.9,
        {"y": 0.0, "z": 0.0, "der(z)": 0.0},
    )
    for small in (1e-12, 1e-30, 1e12)
]

# A belt without mass runs with 3 and drags a mass m by a damper 0.4 m.
DRAGGED = [
    Attack(
        f"belt_of_{factor:g}_that_drags_{mass:g}",
        model(
            f"coordinate Real belt, x; kinetic 1/2*{mass:g}*der(x)^2;"
            f"dissipation 0.2*{mass:g}*(der(belt) - der(x))^2;"
            f"constraint drive: {factor:g}*der(belt) = {factor:g}*3;"
            f"output Real pull = -{factor / mass:g}*multiplier(drive);"
        ),
        2.0,
        {"belt": 6.0, "x": 6 - 7.5 * (1 - exp(-0.8)), "pull": -1.2 * exp(-0.8)},
    )
    for mass, factor in ((1e10, 1.0), (1e-10, 1.0), (1.0, 1e-10), (1.0, 1e10), (1e10, 1e-10))
]


@rows([*FALLS, *DOCKING, *BESIDE, *WORMS, *CHAINS, *SMALL, *LANDED, *DRAGGED])
def test_scales(row: Attack, engine: str) -> None:
    check(row, engine)
