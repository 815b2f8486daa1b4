"""Events that come and go inside one step: relations bound the step, as states do."""

from __future__ import annotations

from math import acos, floor, log, pi, sin

from attack.rows import Attack, check, model, rows

TURNING = "coordinate Real phi(der(start = {})); kinetic 1/2*der(phi)^2; discrete Integer n(start = 0);"


def counter(name: str, rate: float, condition: str, count: int, stop: float, **more: float) -> Attack:
    """A wheel that turns at `rate` rad/s and is counted whenever the condition becomes true."""
    body = TURNING.format(repr(rate))
    return Attack(name, model(body, f"when {condition} then n = pre(n) + 1; end when;"), stop, {"n": count}, **more)  # type: ignore[arg-type]


def _rising(rate: float, stop: float, phase: float) -> int:
    """Number of times that rate*t passes phase + 2 pi k, in 0 < t < stop."""
    return floor((rate * stop - phase) / (2 * pi)) + (1 if phase > 0 else 0)


COUNTERS = [
    # that of the start is true from the first moment and does not become true
    counter("teeth", 20 * pi, "sin(phi) > 0.1", 1000, 100.0, tolerance=1e-6),
    counter("teeth_fine", 20 * pi, "sin(phi) > 0.1", 1000, 100.0),
    counter("teeth_at_noon", 7.3, "cos(phi) < 0", _rising(7.3, 100, pi / 2), 100.0, tolerance=1e-6),
    counter("narrow_teeth", 20 * pi, "sin(phi) > 0.999", 200, 20.0, tolerance=1e-6),
    counter("very_narrow_teeth", 20 * pi, "sin(phi) > 0.999999", 200, 20.0, tolerance=1e-6),
    counter("narrow_gaps", 20 * pi, "sin(phi) > -0.9999", 200, 20.0, tolerance=1e-6),
    counter("fast_wheel", 2000 * pi, "sin(phi) > 0.5", 1000, 1.0, tolerance=1e-6),
    counter(
        "slow_then_fast", 31.0, "sin(phi*phi) > 0.3", floor(((31.0 * 2) ** 2 - 0.3046926540153975) / (2 * pi)) + 1, 2.0
    ),
    # looks are to be as dense as the events have become, whatever length was right at first
    *(
        counter(
            f"faster_{rate:g}_at_{tolerance:g}",
            rate,
            "sin(phi*phi) > 0.3",
            floor(((rate * stop) ** 2 - 0.3046926540153975) / (2 * pi)) + 1,
            stop,
            tolerance=tolerance,
        )
        for rate, stop, tolerance in ((20.0, 2.0, 1e-9), (31.0, 2.0, 7e-10), (47.0, 1.5, 1e-8), (47.0, 1.5, 1e-11))
    ),
    counter("two_teeth", 20 * pi, "sin(phi) > 0.5 and sin(phi) < 0.6", 400, 20.0, tolerance=1e-6),
    counter("either_of_two", 20 * pi, "{sin(phi) > 0.9, cos(phi) > 0.9}", 400, 20.0, tolerance=1e-6),
    counter("teeth_by_mod", 20 * pi, "mod(phi, 2*pi) > 6.28", 200, 20.0, tolerance=1e-6),
    counter("teeth_of_time", 1.0, "sin(62.83185307179586*time) > 0.5", 1000, 100.0, tolerance=1e-6),
    counter("narrow_teeth_of_time", 1.0, "sin(62.83185307179586*time) > 0.99999", 200, 20.0, tolerance=1e-6),
    counter("a_pulse_of_time", 1.0, "abs(time - 57) < 1e-4", 1, 100.0, tolerance=1e-6),
    # the relation turns where its terms are round again, long behind the instant that is found
    *(
        counter(f"time_beside_{far:g}", 1.0, f"{far!r} + time > {far!r} + 0.5", 1, 1.0, tolerance=1e-6)
        for far in (1e3, 1e6, 1e9)
    ),
    counter("a_pulse_of_place", 1.0, "abs(phi - 57) < 1e-4", 1, 100.0, tolerance=1e-6),
    counter("a_pulse_of_a_product", 1.0, "(phi - 57)*(phi - 57.0002) < 0", 1, 100.0, tolerance=1e-6),
]

# They are true for so short a time that no step sees them; their corners are located.
NARROW = [(1e-3, 1e-5), (1e-5, 1e-10), (1e-7, 1e-5), (1e-9, 1e-10)]
NEEDLES = [
    *(
        counter(f"{name}_of_{width:g}", 1.0, condition.format(width), count, 100.0, tolerance=tolerance)
        for width, tolerance in NARROW
        for name, condition, count in (
            ("needle", "abs(phi - 23) < {}", 1),
            ("needle_at_the_stop", "abs(phi - 100) < {}", 1),
            ("gap", "abs(phi - 23) > {}", 1),
            ("larger_of_two", "max(phi - 23, 23 - phi) < {}", 1),
            ("needle_of_a_square", "abs(phi*phi - 529) < 40*{}", 1),
            ("zeros", "abs(sin(phi)) < {}", 31),
            ("before_a_jump", "mod(phi, 6.25) > 6.25 - {}", 16),
            ("behind_a_jump", "mod(phi, 6.25) < {}", 16),
        )
    ),
    counter("needle_in_a_needle", 1.0, "abs(phi - 23) < 1e-5 and abs(phi - 23) < 1e-7", 1, 100.0, tolerance=1e-6),
    counter(
        "needles_side_by_side", 1.0, "{abs(phi - 23) < 1e-5, abs(phi - 23.00001) < 1e-7}", 2, 100.0, tolerance=1e-6
    ),
    *(
        Attack(
            f"wide_square_{name}_behind_an_event",  # at 10 the square has another round-off than at its zero
            model(
                TURNING.format("1.0") + "discrete Integer k(start = 0); discrete Real at(start = 0);",
                "when phi > 10 then k = 1; end when; "
                f"when (phi - 23)^2 {sign} 1e-16 then n = pre(n) + 1; at = time; end when;",
            ),
            100.0,
            {"n": 1, "at": 23 - 1e-8},
            tolerance=1e-6,
        )
        for name, sign in (("less", "<"), ("touched", "<="))
    ),
    counter("needle_of_a_wide_square", 1.0, "(phi - 23)^2 < 1e-16", 1, 100.0, tolerance=1e-6),
    # narrower than round-off can tell: it may be missed, and the run goes on
    Attack(
        "needle_within_round_off",
        model(TURNING.format("1.0"), "when abs(phi - 23) < 1e-14 then n = pre(n) + 1; end when;"),
        100.0,
        {"phi": 100.0},
        tolerance=1e-6,
    ),
    Attack(
        "needle_of_an_oscillator",
        model(
            "coordinate Real x(start = 1), y; kinetic 1/2*(der(x)^2 + der(y)^2); potential 1/2*4*pi^2*x^2; "
            "discrete Integer n(start = 0); force (if abs(x) < 1e-6 then 1e5 else 0) on y;",
            "when abs(x - 0.5) < 1e-7 then n = pre(n) + 1; end when;",
        ),
        10.1,
        {"n": 20, "der(y)": 20 * 1e5 * 2e-6 / (2 * pi)},
        tolerance=1e-11,
        near=1e-7,
    ),
]

# Of the cam: the angle before its tip, the slope there, the impulse of an elastic blow.
FLANK = acos(1 - log(2) / 100)
SLOPE = 5 * sin(FLANK)
BLOW = 2 * 100 * SLOPE / (1 + SLOPE**2)

# The cosine is near to one for so many radians on each side of whole turns.
NEAR = acos(0.9999)
PEAKS = "coordinate Real a(start = -1, der(start = 2)), b(start = -1, der(start = 2)), y; "
PEAKS += "kinetic 1/2*(der(a)^2 + der(b)^2 + der(y)^2); discrete Integer n(start = 0); "


def _between_peaks(time: float) -> float:
    """An angle that is thrown back near 0 and near -2 pi, from -1 upward at 2 rad/s."""
    span = 2 * pi - 2 * NEAR
    way = (2 * time - 1 + 2 * pi - NEAR) % (2 * span)
    return -2 * pi + NEAR + min(way, 2 * span - way)


TOGETHER = [
    # a change at the first look hides one that comes and goes before it
    Attack(
        "a_tooth_on_a_peak",
        model(
            PEAKS + "force if cos(a) > 0.9999 then 1 else 0 on y;", "when sin(5*a) > 0 then n = pre(n) + 1; end when;"
        ),
        60.0,
        {"der(y)": 19 * NEAR, "n": floor(595 / (2 * pi)) + 1},
        tolerance=1e-8,
    ),
    # two that come and go between the same looks: the first one is a contact, the second a relation
    Attack(
        "a_blow_before_a_peak",
        model(
            PEAKS + "force if cos(a) > 0.9999 then 1 else 0 on y; contact c: cos(b) <= 0.9999 with restitution = 1;",
            "when sin(5*a) > 0 then n = pre(n) + 1; end when;",
        ),
        60.0,
        {"der(y)": 19 * NEAR, "n": floor(595 / (2 * pi)) + 1, "b": _between_peaks(60.0)},
        counts={("c", "impact"): 20},
        tolerance=1e-8,
    ),
    # at the last two, samples of a step over two turns see nothing of the turns
    *(
        Attack(
            f"a_blow_before_a_corner_at_{tolerance:g}",
            model(
                PEAKS + "force max(0, cos(a) - 0.9999) on y; contact c: cos(b) <= 0.9999 with restitution = 1;",
                "when sin(5*a) > 0 then n = pre(n) + 1; end when;",
            ),
            60.0,
            {"der(y)": 19 * (sin(NEAR) - 0.9999 * NEAR), "b": _between_peaks(60.0)},
            tolerance=tolerance,
            near=1e-9,
            counts={("c", "impact"): 20},
        )
        for tolerance in (1e-6, 1e-9, 1e-10)
    ),
    # the step that meets the tooth has crossed the corner behind it, too
    *(
        Attack(
            f"a_tooth_within_a_corner_at_{tolerance:g}",
            model(PEAKS + "force max(0, cos(a) - 0.9999) on y;", "when sin(5*a) > 0 then n = pre(n) + 1; end when;"),
            60.0,
            {"der(y)": 19 * (sin(NEAR) - 0.9999 * NEAR), "n": floor(595 / (2 * pi)) + 1},
            tolerance=tolerance,
            near=1e-9,
        )
        for tolerance in (1e-6, 1e-8, 1e-12)
    ),
    Attack(
        "three_peaks_one_after_the_other",
        model(
            PEAKS + "force (if cos(a) > 0.9999 then 1 else 0) + (if cos(a + 0.05) > 0.9999 then 2 else 0) on y;",
            "when cos(a - 0.05) > 0.9999 then n = pre(n) + 1; end when;",
        ),
        60.0,
        {"der(y)": 19 * 3 * NEAR, "n": 19},
        tolerance=1e-8,
    ),
]

OSCILLATORS = [
    Attack(
        "tips_of_an_oscillator",
        model(
            "coordinate Real x(start = 1); discrete Integer n(start = 0); kinetic 1/2*der(x)^2; "
            "potential 1/2*400*pi^2*x^2;",
            "when x > 0.9999 then n = pre(n) + 1; end when;",
        ),
        10.05,
        {"n": 100},
        tolerance=1e-8,
    ),
    Attack(
        "fast_state",
        model(
            "state Real z; discrete Integer n(start = 0);",
            "der(z) = 200; when sin(z) > 0.99 then n = pre(n) + 1; end when;",
        ),
        10.0,
        {"n": floor((2000 - 1.429256853470469) / (2 * pi)) + 1},
        tolerance=1e-6,
    ),
    Attack(
        "fast_turn_slow_mass",
        model(
            "coordinate Real phi(der(start = 62.83185307179586)), x; kinetic 1/2*(der(phi)^2 + der(x)^2); "
            "force (if sin(phi) > 0 then 1 else 0) on x;"
        ),
        100.0,
        {"der(x)": 50.0, "x": 2500.0 + 1000 * 0.05 * 0.05 / 2},
        tolerance=1e-8,
        near=1e-7,
    ),
    Attack(
        "force_on_a_narrow_tooth",
        model(
            "coordinate Real phi(der(start = 62.83185307179586)), x; kinetic 1/2*(der(phi)^2 + der(x)^2); "
            "force (if cos(phi) > 0.9999 then 1 else 0) on x;"
        ),
        20.025,
        {"der(x)": 200.5 * 2 * 0.014142253479665764 / 62.83185307179586},
    ),
    Attack(
        "rotating_arm_hits_a_pin",
        # each turn the arm takes 1 from the speed of a slide that it meets
        model(
            "coordinate Real phi(der(start = 62.83185307179586)), x(der(start = 50)); "
            "kinetic 1/2*(der(phi)^2 + der(x)^2);",
            "when sin(phi) > 0.9999 then reinit(der(x), pre(der(x)) - 1); end when;",
        ),
        4.01,
        {"der(x)": 10.0},
        tolerance=1e-8,
    ),
    Attack(
        "contact_with_a_fast_cam",
        # the flank of the cam meets the resting ball where it is half as high as its tip; both share the blow
        model(
            "coordinate Real h(start = 0.05), phi(start = 3.141592653589793, der(start = 100));"
            "kinetic 1/2*(der(h)^2 + der(phi)^2);"
            "contact c: h >= 0.1*exp(100*(cos(phi) - 1)) with restitution = 1;"
        ),
        0.035,
        {"der(h)": BLOW, "der(phi)": 100 - BLOW * SLOPE, "h": 0.05 + BLOW * (0.035 - (pi - FLANK) / 100)},
        counts={("c", "impact"): 1},
    ),
    Attack(
        "ball_between_near_walls",
        model(
            "coordinate Real x(der(start = 1000)); kinetic 1/2*der(x)^2; contact l: x >= -0.5 with restitution = 1; "
            "contact r: x <= 0.5 with restitution = 1;"
        ),
        0.1002,
        {"der(x)": 1000.0, "x": 0.2},
        counts={("l", "impact"): 50, ("r", "impact"): 50},
    ),
]


# Thrown back by a clause, times become a geometric series: the model says nothing beyond its sum, where the run ends.
THROWN_BACK = [
    Attack(
        f"bounces_of_{e}_by_a_clause",
        model(
            "coordinate Real h(start = 1); kinetic 1/2*der(h)^2; potential 9.81*h;",
            f"when h < 0 then reinit(der(h), -{e}*pre(der(h))); end when;",
        ),
        3.0,
        {"h": 0.0},
        refused=("E0833",),
    )
    for e in (0.05, 0.2, 0.35, 0.6)
]


@rows([*COUNTERS, *NEEDLES, *TOGETHER, *OSCILLATORS, *THROWN_BACK])
def test_missed_events(row: Attack, engine: str) -> None:
    check(row, engine)
