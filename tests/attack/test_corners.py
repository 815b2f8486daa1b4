"""Terms that are flat before they act: steps end at corners of time, the runtime locates corners of the state."""

from __future__ import annotations

from math import acos, pi, sin, sqrt

from attack.rows import Attack, check, model, rows
from scipy.integrate import quad

MASS = "coordinate Real x; kinetic 1/2*der(x)^2; force {} on x;"


def pushed(name: str, force: str, pulses: list[tuple[float, float]], stop: float = 10.0, **more: object) -> Attack:
    """A mass of 1 at rest, pushed by pulses of (center of area, area)."""
    speed = sum(area for _, area in pulses)
    way = sum(area * (stop - center) for center, area in pulses)
    return Attack(name, model(MASS.format(force)), stop, {"x": way, "der(x)": speed}, **more)  # type: ignore[arg-type]


def _narrow_sines() -> list[tuple[float, float]]:
    """max(0, sin(50 t) - c): each peak by its exact area."""
    c, omega = 0.9999, 50.0
    half = acos(c) / omega
    area = 2 / omega * (sqrt(1 - c * c) - c * acos(c))
    centers = [(pi / 2 + 2 * pi * k) / omega for k in range(200)]
    return [(center, area) for center in centers if center + half < 10.0]


def _wrapped(stop: float) -> float:
    """The integral of wrap(t)."""
    rest = stop - 2 * pi * round(stop / (2 * pi))
    return rest**2 / 2


PULSES = [
    pushed("table", "table(time, {0, 4.95, 5, 5.05, 10}, {0, 0, 1, 0, 0})", [(5, 0.05)]),
    pushed("max_of_abs", "max(0, 1 - abs(time - 5)/0.05)", [(5, 0.05)]),
    pushed("narrow", "max(0, 1 - abs(time - 5)/1e-5)", [(5, 1e-5)], near=1e-10),
    pushed("trapezoid_by_min", "min(1, max(0, 2 - abs(time - 3)/0.01))", [(3, 0.03)]),
    pushed("limits", "limit((time - 2)/0.001, 0, 1) - limit((time - 2.01)/0.001, 0, 1)", [(2.0055, 0.01)]),
    pushed("comb_by_mod", "max(0, 1 - abs(mod(time, 1) - 0.5)/0.001)", [(k + 0.5, 0.001) for k in range(10)]),
    pushed("comb_by_floor", "max(0, 1 - abs(time - floor(time) - 0.5)/0.001)", [(k + 0.5, 0.001) for k in range(10)]),
    pushed("comb_by_ceil", "max(0, 1 - abs(ceil(time) - time - 0.25)/0.002)", [(k + 0.75, 0.002) for k in range(10)]),
    pushed("peaks_of_a_sine", "max(0, sin(50*time) - 0.9999)", _narrow_sines(), near=1e-10),
    pushed("if_inside_abs", "if abs(time - 6) < 0.004 then 1 else 0", [(6, 0.008)]),
    pushed("if_of_time", "if time > 4 and time < 4.001 then 1 else 0", [(4.0005, 0.001)]),
    pushed("sign_of_time", "(sign(time - 3) - sign(time - 3.01))/2", [(3.005, 0.01)]),
    pushed(
        "two_close_together",
        "max(0, 1 - abs(time - 5)/0.01) - max(0, 1 - abs(time - 5.03)/0.01)",
        [(5, 0.01), (5.03, -0.01)],
    ),
    pushed("far_from_zero", "max(0, 1 - abs(time - 900)/0.05)", [(900, 0.05)], stop=1000.0),
    pushed("at_the_end", "max(0, 1 - abs(time - 9.99)/0.01)", [(9.99, 0.01)]),
    pushed("at_the_start", "max(0, 1 - time/0.01)", [(0.01 / 3, 0.005)]),
    pushed("corner_of_a_corner", "max(0, 0.01 - abs(abs(time - 5) - 1))", [(4, 1e-4), (6, 1e-4)]),
    pushed("a_root_in_time", "max(0, 0.001 - abs(sqrt(time) - 2))", [(4 + 5e-7, 4e-6)]),
    pushed("table_as_a_clock", "max(0, 1 - abs(table(time, {0, 5, 10}, {0, 1, 3}) - 2)/0.004)", [(7.5, 0.01)]),
    pushed("min_of_three", "max(0, min(min((time - 2)/0.01, 1), (2.05 - time)/0.01))", [(2.025, 0.04)]),
]

STAIRS = [
    Attack(
        "stairs_by_floor", model(MASS.format("floor(time/3)")), 10.0, {"x": 49 / 2 + 16 / 2 + 1 / 2, "der(x)": 12.0}
    ),
    Attack("stairs_by_ceil", model(MASS.format("ceil(time - 9.995)")), 9.999, {"der(x)": -9 * 0.995 - 36 + 0.004}),
    Attack("saw", model(MASS.format("wrap(time)")), 10.0, {"der(x)": _wrapped(10.0)}),
    Attack("saw_by_mod", model(MASS.format("mod(time, 0.7)")), 10.0, {"der(x)": 14 * 0.245 + 0.2**2 / 2}),
    Attack(
        "fast_saw", model(MASS.format("mod(100*time, 1) - 0.5")), 10.0, {"der(x)": 0.0, "x": -10.0 * (1 / 12) / 100}
    ),
]

PASSED = [  # a mass coasts through what is narrow: the energy tells its speed
    Attack(
        "narrow_hill_of_force",
        model("coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; force -100*max(0, 1 - abs(x - 1)/0.001) on x;"),
        3.0,
        {"der(x)": sqrt(1 - 2 * 0.1)},
    ),
    Attack(
        "hill_of_potential",
        model("coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; potential 0.3*max(0, 1 - abs(x - 1)/0.01);"),
        3.0,
        {"der(x)": 1.0, "x": 3.0 - (2 * 0.02 / (1 + sqrt(0.4)) - 0.02)},
    ),
    Attack(
        "strip_of_damping",
        model(
            "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; "
            "force -30*max(0, 1 - abs(x - 1)/0.01)*der(x) on x;"
        ),
        3.0,
        {"der(x)": 0.7},
    ),
    Attack(
        "table_of_place",
        model(
            "coordinate Real x(der(start = 2)); kinetic 1/2*der(x)^2; "
            "force table(x, {0, 3, 3.001, 3.002, 9}, {0, 0, 500, 0, 0}) on x;"
        ),
        4.0,
        {"der(x)": sqrt(4 + 2 * 0.5)},
    ),
    Attack(
        "limit_of_place",
        model(
            "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; "
            "force 10*(limit((x - 1)/0.001, 0, 1) - limit((x - 1.01)/0.001, 0, 1)) on x;"
        ),
        3.0,
        {"der(x)": sqrt(1 + 2 * 0.1)},
    ),
    Attack(
        "through_a_state",
        model(
            "state Real z; coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2;",
            "der(z) = max(0, 1 - abs(x - 1.5)/0.01);",
        ),
        3.0,
        {"z": 0.01},
    ),
    Attack(
        "teeth_of_a_wheel",
        model(
            "coordinate Real x(der(start = 1)); state Real z; kinetic 1/2*der(x)^2;",
            "der(z) = max(0, 1 - abs(mod(x, 1) - 0.5)/0.002);",
        ),
        10.0,
        {"z": 10 * 0.002},
    ),
    Attack(
        "angle_of_a_cam",
        model(
            "coordinate Real a(der(start = 2)); state Real z; kinetic 1/2*der(a)^2;",
            "der(z) = max(0, cos(a) - 0.9999);",
        ),
        10.0,
        {"z": (0.5 + 3) * 2 * (sqrt(1 - 0.9999**2) - 0.9999 * acos(0.9999)) / 2},
        near=1e-10,
    ),
]


def _smooth_step_into_spring() -> float:
    """u'' = -k (u - s(t)), k = 100, from rest, to t = 10: Duhamel's integral."""

    def s(t: float) -> float:
        r = min(max((t - 5) / 0.2, 0.0), 1.0)
        return r**3 * (10 - 15 * r + 6 * r**2)

    return quad(lambda t: 10 * sin(10 * (7 - t)) * s(t), 5, 7, points=[5.2], epsabs=1e-13, limit=200)[0]  # type: ignore[no-any-return]


SOURCES = [
    Attack(
        "smooth_step_moves_a_spring",
        """model Moved
  import Lag.Translational.*;
  import Lag.Blocks.SmoothStep;
  SmoothStep way(start = 5 s, duration = 0.2 s);
  PositionSource source(s_ref = way.y*(1 m));
  Spring spring(k = 100 N/m);
  SlidingMass load(m = 1 kg);
  connect(source.s, spring.s_a);
  connect(spring.s_b, load.s);
  output Length seen = load.s;
end Moved;
""",
        7.0,
        {"seen": _smooth_step_into_spring()},
    ),
    Attack(
        "wall_moved_by_max",
        model(
            "coordinate Real x(start = 0.5); kinetic 1/2*der(x)^2; "
            "contact wall: x >= max(0, 1 - abs(time - 5)/0.5) with restitution = 1;"
        ),
        6.0,
        # the wall (speed 2) meets the resting mass at 4.75; it flies off at twice the speed of the wall
        {"der(x)": 4.0, "x": 0.5 + 4 * 1.25},
    ),
    Attack(
        "wall_moved_by_table",
        model(
            "coordinate Real x(start = 0.5); kinetic 1/2*der(x)^2; "
            "contact wall: x >= table(time, {0, 5, 5.1, 5.2, 9}, {0, 0, 1, 0, 0}) with restitution = 0.5;"
        ),
        6.0,
        {"der(x)": 15.0, "x": 0.5 + 15 * 0.95},
    ),
]


PARAMETERS = [
    Attack(
        f"pulse_at_a_parameter_{at:g}",
        model("parameter Real at = 5, width = 0.1; " + MASS.format("max(0, 1 - abs(time - at)/width)")),
        10.0,
        {"der(x)": 5e-4, "x": 5e-4 * (10 - at)},
        parameters={"at": at, "width": 5e-4},
    )
    for at in (1e-3, 1.0, 4.9999, 10 / 3)
]


# A spring of 90 that begins at a place, met at 1.5; the place is known to its own round-off only.
FAR_AWAY = [
    Attack(
        f"spring_that_begins_at_{at:g}_by_{name}",
        model(
            f"coordinate Real u(start = {at} - 0.02, der(start = 1.5)); kinetic 1/2*der(u)^2; "
            f"force {text.format(f'(u - ({at}))')} on u;"
        ),
        0.1,
        {"u": at + 1.5 / sqrt(90) * sin(sqrt(90) * (0.1 - 0.02 / 1.5))},
    )
    for at in (-50.0, -100.0, 333.3, 1e4)
    for name, text in (("max", "-90*max(0, {})"), ("table", "-table({}, {{-1, 0, 1}}, {{0, 0, 90}})"))
]
REST = "coordinate Real x; kinetic 1/2*der(x)^2; "
COUNT = REST + "discrete Integer n(start = 0); Real f = {}; "
# A function of time whose line changes where a relation is zero: it touches, or stays.
TOUCHED = [
    Attack(
        "top_of_a_tent",
        model(COUNT.format("min(time, 2 - time)"), "when f > 1 then n = pre(n) + 1; end when;"),
        2.0,
        {"n": 0},
    ),
    Attack(
        "top_of_a_tent_far_away",
        model(COUNT.format("min(time - 1e5, 1e5 + 2 - time)"), "when f > 1 then n = pre(n) + 1; end when;"),
        1.5e5,
        {"n": 0},
    ),
    Attack(
        "just_below_the_top",
        model(COUNT.format("table(time, {0, 1, 2}, {0, 1, 0})"), "when f > 1 - 1e-9 then n = pre(n) + 1; end when;"),
        2.0,
        {"n": 1},
    ),
    Attack(
        "saw_below_its_top",
        model(COUNT.format("mod(time, 1)"), "when f >= 1 then n = pre(n) + 1; end when;"),
        3.25,
        {"n": 0},
    ),
    Attack(
        "limit_that_is_not_passed",
        model(REST + "Real f = min(3*time, 3); force if f > 3 then 5 else 1 on x;"),
        2.0,
        {"der(x)": 2.0},
    ),
    Attack(
        "limit_that_is_reached",
        model(REST + "Real f = min(3*time, 3); force if f >= 3 then 5 else 1 on x;"),
        2.0,
        {"der(x)": 6.0},
    ),
    Attack(
        "stairs_of_a_tent",
        model(REST + "state Real z; Real f = 3*min(time, 2 - time);", "der(z) = floor(f);"),
        2.0,
        {"z": 2.0},
    ),
    Attack(
        "needle_at_a_corner_of_time",
        model(
            "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; discrete Integer n(start = 0); state Real z;",
            "der(z) = max(0, time - 1); when abs(x - 1) < 1e-6 then n = pre(n) + 1; end when;",
        ),
        3.0,
        {"n": 1, "z": 2.0},
    ),
]


@rows([*PULSES, *STAIRS, *PASSED, *SOURCES, *PARAMETERS, *FAR_AWAY, *TOUCHED])
def test_corners(row: Attack, engine: str) -> None:
    check(row, engine)
