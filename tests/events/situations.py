"""Small machines in which something happens at an instant: all events, and values at the end, by closed forms.

Each names the file of the C runtime that decides, as docs/explanation/hybrid_model.md does. They have no units; g = 10.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import sqrt

Told = tuple[float, str, str]
"""Time, name and kind of an event."""


@dataclass(frozen=True)
class Situation:
    """`events` are all that happen; those of kinds in `besides` are not compared. `near` bounds errors of times and
    ends at every tolerance, `coarse` those at the tolerance 1e-3 where a limit of the page is met, `fixed` those with
    fixed steps, between which a cubic interpolates; `adaptive_only`: fixed steps do not find the instant."""

    name: str
    decides: str
    body: str
    stop: float
    events: tuple[Told, ...] = ()
    ends: Mapping[str, float] = field(default_factory=dict)
    clauses: str = ""
    besides: tuple[str, ...] = ()
    near: float = 1e-9
    coarse: float | None = None
    fixed: float | None = None
    adaptive_only: bool = False

    @property
    def text(self) -> str:
        equation = f"equation\n  {self.clauses}\n" if self.clauses else ""
        return f'model Situation\n  {self.body}\n  annotation(units = "none");\n{equation}end Situation;\n'


FALLS = "gravity = {0, -10, 0}; "


def mass(start: str = "") -> str:
    """A mass of 1 on a line, with its start."""
    return f"coordinate Real x({start}); kinetic 1/2*der(x)^2; "


def two(a: str, b: str) -> str:
    """Two masses or inertias of 1, with their starts."""
    return f"coordinate Real a({a}), b({b}); kinetic 1/2*(der(a)^2 + der(b)^2); "


def block(start: str = "") -> str:
    """A mass of 1 at the height h, under gravity."""
    return FALLS + f"coordinate Real x({start}), h; mass 1 at {{x, h}}; "


def belt(speed: str) -> str:
    """A mass slides with 3 - 2 t on a belt that has the speed t up to t = 1."""
    return mass("der(start = 3)") + f"friction f: der(x) - {speed} with limit = 2;"


# a mass at its stop and a rope from it to another one: P_s + P_r = 3, P_s + 2 P_r = 4
ROPE = (
    two("der(start = 2)", "start = 0.5, der(start = -1)") + "force -1 on b; "
    "contact stop: a <= 2 with restitution = 0.5; contact rope: a - b <= 3 with restitution = 0;"
)
CRADLE = (
    "coordinate Real x[5](start = {-1, -1, 0, 0, 0}, der(start = {1, 1, 0, 0, 0})); "
    "for i in 1:5 loop kinetic 1/2*der(x[i])^2; end for; "
    "for i in 1:4 loop contact c: x[i + 1] - x[i] >= 0 with restitution = 1; end for;"
)
BENCH = (
    FALLS + "coordinate Real x, h, p; mass 2 at {x, h}; kinetic 1/2*der(p)^2; force -5 on h; force -2.5 on p; "
    "force 2.5*time on x; "
    "contact left: h + p >= 0 with restitution = 0, friction = 0.5, slip = der(x); "
    "contact right: h - p >= 0 with restitution = 0, friction = 0.5, slip = der(x);"
)
RATCHET = mass() + "contact ratchet: der(x) >= 0; force min(abs(time - 3) - 2, 7 - time) on x;"
AGAIN = 1 + sqrt(2.0)  # the ratchet runs from rest by 1/2 + s - s^2/2 behind t = 6

GIVEN = [
    Situation(
        "two contacts close at one instant",
        "impulses/impulse_step.c",
        "coordinate Real h(start = 0.8), phi; kinetic 1/2*der(h)^2 + 1/2*der(phi)^2; force -10 on h; "
        "contact left: h - phi >= 0 with restitution = 0.5; contact right: h + 2*phi >= 0 with restitution = 0.5;",
        0.7,
        ((0.4, "left", "impact"), (0.4, "right", "impact")),
        {"h": 0.15, "der(h)": -1.0, "phi": 0.0, "der(phi)": 0.0},
    ),
    Situation(
        "a latch is set at its own zero",
        "events/event_sides.c",
        mass("der(start = 1)") + "discrete Boolean locked(start = false); discrete Integer n(start = 0); "
        "constraint latch: (if locked then x - 2 else 0) = 0;",
        5.0,
        ((2.0, "x > 2", "true"),),
        {"x": 2.0, "der(x)": 0.0, "n": 1.0},
        clauses="when x > 2 then locked = true; n = pre(n) + 1; end when;",
    ),
    Situation(
        "a belt has the speed of the block at a corner of time, and keeps it",
        "contacts/modes.c",
        belt("min(time, 1)"),
        2.0,
        ((1.0, "f", "sticks"),),
        {"x": 3.0, "der(x)": 1.0},
    ),
    Situation(
        "a rope becomes taut while a stop is hit",
        "contacts/contact_impacts.c",
        ROPE,
        2.0,
        ((1.0, "stop", "impact"), (1.0, "rope", "impact"), (1.0, "rope", "closed")),
        {"a": 0.75, "b": -2.25, "der(a)": -1.5, "der(b)": -1.5},
    ),
    Situation(
        "a clause switches a clutch on at a slip of 1e-13",
        "events/event_iteration.c",
        two("der(start = 2 + 1e-13)", "der(start = 1)") + "discrete Boolean on(start = false); "
        "torque (if on then 4 else -1) on a; friction clutch: der(a) - der(b) with limit = (if on then 5 else 0);",
        2.0,
        ((1.0, "time >= 1", "true"), (1.0, "clutch", "sticks")),
        {"a": 3.5, "b": 3.0, "der(a)": 3.0, "der(b)": 3.0},
        clauses="when time >= 1 then on = true; end when;",
    ),
    Situation(
        "a gap opens and closes within one step",
        "run/run_zero_crossings.c",
        # the force (s^2 - 1e-4) passes zero 0.01 before and behind t = 1; the flight takes four times that
        FALLS + "coordinate Real h; mass 1 at {0, h}; contact floor: h >= 0 with restitution = 0; "
        "force 10 + 1e-4 - (time - 1)^2 on h;",
        2.5,
        ((0.99, "floor", "opened"), (1.03, "floor", "impact"), (1.03, "floor", "closed")),
        {"h": 0.0, "der(h)": 0.0},
        fixed=1e-5,
    ),
    Situation(
        "an impact on a sticking box",
        "impulses/impulse.c",
        block() + "coordinate Real ball(start = -2, der(start = 2)); kinetic 1/2*der(ball)^2; "
        "contact hit: x - ball >= 0 with restitution = 0.5; "
        "contact floor: h >= 0 with restitution = 0, friction = 0.5, slip = der(x);",
        1.4,
        ((1.0, "hit", "impact"), (1.0, "floor.friction", "slips"), (1.3, "floor.friction", "sticks")),
        {"x": 0.225, "der(x)": 0.0, "ball": 0.2, "der(ball)": 0.5},
    ),
    Situation(
        "two feet of a bench share a push: their normal forces are known, their shares are not",
        "contacts/reserve.c",
        BENCH,
        6.0,
        tuple((5.0, f"{foot}.friction", "slips") for foot in ("left", "right")),
        {"x": 2.5 / 12, "der(x)": 0.625, "h": 0.0},
    ),
]
CHOSEN = [
    Situation(
        "a belt has the speed of the block at a corner of time, and brakes harder than friction",
        "contacts/modes.c",
        belt("min(time, 6 - 5*time)"),
        2.0,
        (),
        {"x": 2.0, "der(x)": -1.0},
    ),
    Situation(
        "a belt has the speed of the block at a corner of time, and outruns friction",
        "contacts/modes.c",
        belt("max(time, 5*time - 4)"),
        2.0,
        ((1.0, "f", "reverses"),),
        {"x": 4.0, "der(x)": 3.0},
    ),
    Situation(
        "Newton's cradle: two balls strike three",
        "contacts/contact_impacts.c",
        CRADLE,
        2.0,
        (*((1.0, f"c[{i}]", "impact") for i in range(1, 5)), (1.0, "c[2]", "closed"), (1.0, "c[3]", "opened")),
        {"x[1]": 0.0, "x[2]": 0.0, "x[3]": 0.0, "x[4]": 1.0, "x[5]": 1.0},
    ),
    Situation(
        "a static limit above the sliding one breaks loose",
        "contacts/modes.c",
        mass() + "force time on x; friction dry: der(x) with limit = 3, sticking = 5;",
        6.0,
        ((5.0, "dry", "slips"),),
        {"x": 7 / 6, "der(x)": 2.5},
    ),
    Situation(
        "a ratchet closes again",
        "contacts/modes.c",
        RATCHET,
        9.0,
        ((2.0, "ratchet", "closed"), (5.0, "ratchet", "opened"), (6 + AGAIN, "ratchet", "closed")),
        {"x": 5 / 6 + AGAIN / 2 + AGAIN**2 / 2 - AGAIN**3 / 6, "der(x)": 0.0},
    ),
    Situation(
        "an impact turns a condition on a rate",
        "events/event_sides.c",
        FALLS + "coordinate Real h(start = 0.8); mass 1 at {0, h}; contact floor: h >= 0 with restitution = 0.5; "
        "discrete Integer n(start = 0);",
        0.7,
        ((0.4, "floor", "impact"), (0.6, "der(h) > 0", "false")),  # nobody located the first
        {"n": 1.0, "h": 0.15},
        clauses="when der(h) > 0 then n = pre(n) + 1; end when;",
    ),
    Situation(
        "a clause turns the rate of a sliding block",
        "events/event_iteration.c",
        mass("der(start = 3)") + "friction dry: der(x) with limit = 1;",
        4.0,
        ((1.0, "time >= 1", "true"), (1.0, "der(x)", "reinit"), (1.0, "dry", "reverses"), (3.0, "dry", "sticks")),
        {"x": 0.5, "der(x)": 0.0},
        clauses="when time >= 1 then reinit(der(x), -2); end when;",
    ),
    Situation(
        "friction reverses without rest",
        "contacts/modes.c",
        mass("der(start = 2)") + "force -3 on x; friction dry: der(x) with limit = 1;",
        1.5,
        ((0.5, "dry", "reverses"),),
        {"x": -0.5, "der(x)": -2.0},
    ),
    Situation(
        "bounces accumulate, then the block sticks",
        "contacts/contact_impacts.c",
        FALLS + "coordinate Real x(der(start = 2)), h(start = 0.05); mass 1 at {x, h}; "
        "contact floor: h >= 0 with restitution = 0.5, friction = 0.5, slip = der(x);",
        1.0,
        ((0.3, "floor", "closed"), (0.4, "floor.friction", "sticks")),
        {"h": 0.0, "der(x)": 0.0},
        besides=("impact",),
        near=1e-6,
    ),
    Situation(
        "the force of a contact passes zero while friction under it slides",
        "contacts/modes.c",
        block("der(start = 2)") + "force 5*time on h; "
        "contact floor: h >= 0 with restitution = 0, friction = 0.1, slip = der(x);",
        3.0,
        ((2.0, "floor", "opened"),),
        {"x": 11 / 3, "der(x)": 1.0, "h": 5 / 6, "der(h)": 2.5},
    ),
    Situation(
        "a sticking block on a platform that accelerates ever more",
        "contacts/friction.c",
        mass() + "friction dry: der(x) - time^2/2 with limit = 2;",
        3.0,
        ((2.0, "dry", "slips"),),
        {"x": 13 / 3, "der(x)": 4.0},
    ),
    Situation(
        "a planar puck comes on a belt that runs across",
        "contacts/friction.c",
        # its slip has the direction (1, -1) until it sticks: a disc of forces, not a square
        "coordinate Real x(der(start = 1)), y; kinetic 1/2*(der(x)^2 + der(y)^2); "
        "friction pad: {der(x), der(y) - 1} with limit = 2*sqrt(2);",
        1.0,
        ((0.5, "pad", "sticks"),),
        {"x": 0.25, "y": 0.75, "der(x)": 0.0, "der(y)": 1.0},
        near=2e-6,
        coarse=1e-4,
        adaptive_only=True,
    ),
    Situation(
        "the force of a contact only touches zero",
        "events/noise.c",
        FALLS + "coordinate Real h; mass 1 at {0, h}; contact floor: h >= 0 with restitution = 0; "
        "force 10 - (time - 1.003)^2 on h;",
        2.5,
        (),
        {"h": 0.0, "der(h)": 0.0},
    ),
    Situation(
        "a blow on a clutch whose limit is known",
        "optimization/friction_problem.c",
        # the inertia a hits its stop: the clutch lets go, b goes on and is braked by 1
        two("der(start = 2)", "der(start = 2)") + "friction clutch: der(a) - der(b) with limit = 1; "
        "contact stop: a <= 2 with restitution = 0.5;",
        1.5,
        ((1.0, "stop", "impact"), (1.0, "clutch", "slips")),
        {"a": 2 - 0.5 + 0.125, "b": 2 + 1 - 0.125, "der(a)": -0.5, "der(b)": 1.5},
    ),
    Situation(
        "a mass climbs a step of its energy",
        "events/refraction.c",
        mass("der(start = 2)") + "potential if x <= 1 then 0 else 1.5;",
        1.5,
        ((0.5, "x <= 1", "false"),),
        {"x": 2.0, "der(x)": 1.0},
    ),
]
SITUATIONS = GIVEN + CHOSEN

# the mass matrix is ((1, -1/2), (-1/2, 1)): a normal force N with its friction lifts h by (1 - mu/2) N/0.75, so that
# wedging begins at mu = 2; the speed is large enough for the slip to last until then
WEDGING = Situation(
    "friction presses its own contact without bound",
    "equations/feedback.c",
    "coordinate Real x(der(start = 1000)), h; kinetic 1/2*(der(x)^2 + der(h)^2) - 1/2*der(x)*der(h); force -1 on h; "
    "contact floor: h >= 0 with restitution = 0, friction = time, slip = der(x);",
    3.0,
)
