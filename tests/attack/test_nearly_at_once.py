"""Events that are near to each other and not one, and events of one instant that are told apart by round-off only."""

from __future__ import annotations

from math import nextafter, sqrt

from attack.rows import Attack, check, model, rows

BALL = "contact under_{0}: {0} >= 0 with restitution = 1; mass 1 at {{{1}, {0}}};"
FALL = "gravity = {0, -2}; "


def _falls(height: float, time: float) -> float:
    """Height of a ball that falls with 2 from rest and bounces without loss."""
    period = 2 * sqrt(height)
    since = (time + period / 2) % period - period / 2
    return height - since**2


def _rocks(tilt: float, restitution: float, time: float) -> tuple[float, float]:
    """Height and turn of a bar of mass 1 and inertia 1/3 that falls from 1 with 2 on two legs, at y - a and y + a."""
    t, y, a, v, w = 0.0, 1.0, tilt, 0.0, 0.0
    while True:
        times = []
        for sign in (-1, 1):
            gap, rate = max(0.0, y + sign * a), v + sign * w
            times.append(0.5 * (rate + sqrt(rate**2 + 4 * gap)) if gap > 1e-12 or rate > 0 else 1e300)
        first = min(times)
        step = min(first, time - t)
        t, y, a, v = t + step, y + v * step - step**2, a + w * step, v - 2 * step
        if step < first:
            return y, a
        sign = (-1, 1)[times.index(first)]
        impulse = -(1 + restitution) * (v + sign * w) / 4
        v, w = v + impulse, w + 3 * sign * impulse
        y = max(y, -sign * a)


BAR = "coordinate Real y(start = 1), a(start = {tilt}); kinetic 1/2*der(y)^2 + 1/6*der(a)^2; potential 2*y; "
BAR += "contact left: y - a >= 0 with restitution = {e}; contact right: y + a >= 0 with restitution = {e};"

NEAR = [
    *(
        Attack(
            f"two_balls_{apart:g}_apart",
            model(
                f"coordinate Real h(start = 4), g(start = 4 + {apart}); {FALL}"
                + BALL.format("h", 0)
                + BALL.format("g", 9)
            ),
            7.0,
            {"h": _falls(4.0, 7.0), "g": _falls(4.0 + apart, 7.0)},
            counts={("under_h", "impact"): 2, ("under_g", "impact"): 2},
            near=1e-10,
        )
        for apart in (1e-6, 1e-7, 1e-8)
    ),
    *(
        Attack(
            f"relation_{depth:g}_before_a_blow",
            model(
                f"coordinate Real h(start = 4); discrete Integer n(start = 0); {FALL}" + BALL.format("h", 0),
                f"when h < {depth} then n = pre(n) + 1; end when;",
            ),
            7.0,
            {"h": 3.0, "n": 2.0},
            counts={("under_h", "impact"): 2},
            near=1e-10,
        )
        for depth in (1e-7, 1e-8)
    ),
    *(
        Attack(
            f"bar_that_is_tilted_by_{tilt:g}",
            model(BAR.format(tilt=tilt, e=0.5)),
            1.25,
            dict(zip(("y", "a"), _rocks(tilt, 0.5, 1.25), strict=True)),
            near=1e-9,
        )
        for tilt in (1e-6, 1e-7, 1e-8)
    ),
]

CLOCK = "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; discrete Integer a(start = 0), b(start = 0); "
TICKS = "when sample(0, 0.1) then b = pre(b) + a + 100*pre(a); end when;"
# The third tick sees what is set at 0.3, and not what was before it.
COUNT = "discrete Integer a(start = 0), b(start = 0);"
PLACES = [
    Attack(  # y = 3 x, so that neither condition holds at any time
        "one_falls_as_the_other_rises",
        model(
            "coordinate Real x(der(start = 1)), y(der(start = 3)); kinetic 1/2*(der(x)^2 + der(y)^2);" + COUNT,
            "when x < 2.1 and y > 6.3 then a = pre(a) + 1; end when;"
            "when x > 2.1 or y < 6.3 then b = pre(b) + 1; end when;",
        ),
        4.0,
        {"a": 0, "b": 0},
    ),
    Attack(
        "places_that_read_each_other",
        model(
            "coordinate Real x(der(start = 1)), y(start = -3, der(start = 3)); kinetic 1/2*(der(x)^2 + der(y)^2);"
            + COUNT,
            "when x > 1.7 then a = pre(a) + 1; end when; when y >= 2.1 then b = pre(b) + a + 10*pre(a); end when;",
        ),
        4.0,
        {"a": 1, "b": 1},
    ),
    Attack(
        "three_places",
        model(
            "coordinate Real x(der(start = 1)), y(der(start = 7)), z(start = 1, der(start = -2));"
            "kinetic 1/2*(der(x)^2 + der(y)^2 + der(z)^2);" + COUNT,
            "when x > 0.3 and y < 2.1 then a = pre(a) + 1; end when;"
            "when z < 0.4 and x < 0.3 then b = pre(b) + 1; end when;",
        ),
        1.0,
        {"a": 0, "b": 0},
    ),
]


@rows(PLACES)
def test_places_of_one_instant(row: Attack, engine: str) -> None:
    check(row, engine)


TOGETHER = [
    Attack(
        f"third_tick_and_{condition.replace(' ', '')}",
        model(CLOCK, f"when {condition} then a = pre(a) + 1; end when; {TICKS}"),
        0.55,
        {"a": 1.0, "b": 3.0 + 200.0},
    )
    for condition in ("time >= 0.1*3", "time > 0.1 + 0.2", "time >= 0.3", "x >= 0.3", "10*x > 3")
]


@rows([*NEAR, *TOGETHER])
def test_nearly_at_once(row: Attack, engine: str) -> None:
    check(row, engine)


TWO = "coordinate Real x(der(start = 1)), y(start = -3, der(start = 3)); kinetic 1/2*(der(x)^2 + der(y)^2); "
TWO += "discrete Integer a(start = 0), b(start = 0); input Real u; output Real seen = u;"
READ = "when x > 1.7 then a = pre(a) + 1; end when; when y >= 2.1 then b = pre(b) + a + 10*pre(a); end when;"
LAST = 1.6999999999999993  # both pass here, as the run finds it


def _rows_of_an_input(name: str, times: tuple[float, ...]) -> Attack:
    """The run stops at each row, and goes on."""
    given = ((0.0, *times, 4.0), tuple(float(k % 2) for k in range(2 + len(times))))
    return Attack(name, model(TWO, READ), 4.0, {"a": 1, "b": 1}, inputs={"u": given})


STOPPED = [
    _rows_of_an_input("stop_where_two_pass_at_once", (LAST,)),
    _rows_of_an_input("stop_behind_two_that_pass_at_once", (nextafter(LAST, 2.0),)),
    _rows_of_an_input("stops_within_round_off", (LAST * (1 - 4e-16), LAST, LAST * (1 + 1e-15), LAST + 1e-12)),
]


@rows(STOPPED)
def test_stops_within_round_off(row: Attack, engine: str) -> None:
    check(row, engine)
