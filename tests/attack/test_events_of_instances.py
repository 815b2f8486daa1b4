"""Needles, corners, blows and settings of a class happen in each instance with its own values. References: free
flights, oscillators and blows by hand, one instance after the other."""

from __future__ import annotations

from math import cos, sin, sqrt

from attack.rows import Attack, check, rows
from attack.test_arrays_of_components import text

WHEEL = "coordinate Real phi(der(start = 1)); kinetic 1/2*der(phi)^2; discrete Integer n(start = 0);"
GATE = f"""Gate parameter Real a = 0, w = 1; {WHEEL}
  equation when abs(phi - a) < w then n = pre(n) + 1; end when;"""
TOOTHED = f"""Toothed parameter Real pitch = 1, w = 1; {WHEEL}
  equation when mod(phi, pitch) > pitch - w then n = pre(n) + 1; end when;"""
KICKED = """Kicked parameter Real a = 0, w = 1, p = 1; coordinate Real x(der(start = 2)), y;
  kinetic 1/2*(der(x)^2 + der(y)^2); force (if abs(x - a) < w then p/w else 0) on y;"""
CARRIED = """Carried parameter Real t0 = 1, v = 1; coordinate Real x; potential 1/2*9*x^2;
  mass 1 at {x + v*max(0, time - t0), 0};"""
BALL = """Ball parameter Real h0 = 1, e = 1; coordinate Real h(start = h0); kinetic 1/2*der(h)^2; potential h0*h;
  contact floor: h >= 0 with restitution = e; output Real part = h/h0;"""
CRAFT = """Craft parameter Real far = 0; coordinate Real a(start = far), b(start = far + 0.005, der(start = -0.01));
  kinetic 1/2*(der(a)^2 + der(b)^2); contact dock: b - a >= 0 with restitution = 0;"""
BEAD = """Bead parameter Real s = 1; coordinate Real x(start = -1, der(start = 1));
  mass 1 at {x, max(0, s*x)};"""
LOADED = """Loaded parameter Real t0 = 1, more = 1; discrete Real m(start = 1);
  coordinate Real x(der(start = 1)); kinetic 1/2*m*der(x)^2;
  equation when time > t0 then m = 1 + more; end when;"""
PUCK = """Puck parameter Real wall = 1, e = 1; coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2;
  equation when x > wall then reinit(der(x), -e*pre(der(x))); end when;"""


def carried(t0: float, v: float, t: float) -> dict[str, float]:
    """A slide on a spring, thrown back at t0 by the speed that its base takes."""
    return {"x": -v * sin(3 * (t - t0)) / 3, "der(x)": -v * cos(3 * (t - t0))}


def bounced(e: float, t: float) -> float:
    """A fall from 1 with the acceleration 1, after its first blow."""
    rest = t - sqrt(2)
    return e * sqrt(2) * rest - rest**2 / 2


INSTANCES = [
    Attack(
        "gates",
        text(GATE, "House Gate g[3](a = {23, 57, 91.3}, w = {1e-3, 1e-6, 1e-9});"),
        100.0,
        {f"g[{i}].n": 1.0 for i in (1, 2, 3)},
        tolerance=1e-6,
    ),
    Attack(
        "gates_of_two_rows",
        text(
            GATE,
            "Row parameter Real w[2]; Gate g[2](a = {31, 64.5}, w = w);",
            "House Row b(w = {1e-4, 1e-8}), c(w = {1e-9, 200});",
        ),
        100.0,
        {"b.g[1].n": 1.0, "b.g[2].n": 1.0, "c.g[1].n": 1.0, "c.g[2].n": 0.0},  # the last one is true from the start
        tolerance=1e-6,
    ),
    Attack(
        "teeth",
        text(TOOTHED, "House Toothed t[3](pitch = {6.25, 12.5, 7}, w = {1e-8, 1e-4, 1e-6});"),
        100.5,
        {"t[1].n": 16.0, "t[2].n": 8.0, "t[3].n": 14.0},
        tolerance=1e-6,
    ),
    Attack(
        "kicks",
        text(KICKED, "House Kicked k[3](a = {23, 57, 11.5}, w = {1e-2, 1e-4, 1e-6}, p = {1, 2, 3});"),
        40.0,
        {f"der(k[{i}].y)": float(i) for i in (1, 2, 3)},
    ),
    Attack(
        "bases",
        text(CARRIED, "House gravity = 0; Carried c[2](t0 = {1, 1.75}, v = {1, -3});"),
        3.0,
        {
            f"c[{i}].x" if column == "x" else f"der(c[{i}].x)": value
            for i, (t0, v) in enumerate(((1.0, 1.0), (1.75, -3.0)), 1)
            for column, value in carried(t0, v, 3.0).items()
        },
    ),
    Attack(
        "bases_that_start_together",
        text(CARRIED, "Late extends Carried(t0 = 1.5);", "House gravity = 0; Late a(v = 2), b(v = -1), c;"),
        3.0,
        {f"{n}.x": carried(1.5, v, 3.0)["x"] for n, v in (("a", 2.0), ("b", -1.0), ("c", 1.0))},
    ),
    Attack(
        "balls_of_all_sizes",
        text(BALL, "House Ball b[4](h0 = {1e-6, 1, 1e3, 1e6}, e = {0.9, 0.5, 0.7, 1});"),
        2.0,
        {f"b[{i}].part": bounced(e, 2.0) for i, e in enumerate((0.9, 0.5, 0.7, 1.0), 1)},
        counts={(f"b[{i}].floor", "impact"): 1 for i in (1, 2, 3, 4)},
    ),
    Attack(
        "craft_near_and_far",
        text(CRAFT, "House Craft c[3](far = {0, 1e3, 7e6});"),
        1.0,
        {f"der(c[{i}].{n})": -0.005 for i in (1, 2, 3) for n in "ab"},
        counts={(f"c[{i}].dock", "closed"): 1 for i in (1, 2, 3)},
        near=1e-7,
    ),
    Attack(
        "beads_on_ramps",
        text(BEAD, "House gravity = 0; Bead b[3](s = {0.5, 2, -1});"),
        2.0,
        {f"b[{i}].x": sqrt(1 + s * s) ** (1 if s < 0 else -1) for i, s in enumerate((0.5, 2.0, -1.0), 1)},
    ),
    Attack(
        "loads",
        text(LOADED, "House Loaded l[2](t0 = {1, 1.5}, more = {1, 3});"),
        3.0,
        {"l[1].x": 1 + 2 / 2, "l[2].x": 1.5 + 1.5 / 4, "der(l[1].x)": 0.5, "der(l[2].x)": 0.25},
    ),
    Attack(
        "pucks",
        text(PUCK, "House Puck p[3](wall = {0.5, 1, 2.25}, e = {1, 0.5, 0.25});"),
        3.0,
        {"p[1].x": 0.5 - 2.5, "p[2].x": 1 - 0.5 * 2, "p[3].x": 2.25 - 0.25 * 0.75},
    ),
    Attack(
        "pucks_and_gates",
        text(PUCK, GATE, "House Puck p(wall = 50, e = 0.5); Gate g(a = 50, w = 1e-7);"),
        100.0,
        {"p.x": 50 - 0.5 * 50, "g.n": 1.0},
        tolerance=1e-6,
    ),
]


@rows(INSTANCES)
def test_events_of_instances(row: Attack, engine: str) -> None:
    check(row, engine)
