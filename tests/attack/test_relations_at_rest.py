"""A relation that a lock holds at its own zero has turned once, whatever round-off and the method's error do there."""

from __future__ import annotations

from functools import cache
from math import cos, sin, sqrt

import numpy as np
import pytest
from attack.rows import Attack, Later, check, model, rows
from scipy.integrate import solve_ivp

import lagdsl
from lagdsl.foundation.diagnostics.sink import Sink

UNTIL = "locked = true; n = pre(n) + 1; elsewhen time > {opened} then locked = false; end when;"
LOCK = """discrete Boolean locked(start = false); discrete Integer n(start = 0);
constraint k: (if locked then {rate} else 0) = 0;
"""
TOLERANCES = (1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3)


def near(tolerance: float) -> float:
    """So close is an end at a tolerance: methods bound the error of a step, not that of the motion."""
    return max(1e-8, 1e3 * tolerance)


# ---- a slider-crank: crank 0.3 and 0.2 kg.m2, rod 1 without mass, piston 3 kg, torque 1 N.m ----

SLIDER_CRANK = """import Lag.Planar.*;
Revolute main(q(start = 1, der(start = 2), fixed = true)), big, wrist;
BodyShape crank(r = {0.3, 0}, com = {0, 0}, m = 1, Izz = 0.2);
FixedTranslation rod(r = {1, 0});
Prismatic guide(s(start = 1)); Body piston(m = 3);
connect(world, main, crank, big, rod, wrist, guide.frame_b, piston); connect(world, guide.frame_a);
torque 1 on main.q; gravity = 0;
"""


def _stroke(q: float) -> tuple[float, float, float]:
    """Place of the piston s(q) = r cos q + sqrt(1 - r^2 sin^2 q), and its first and second derivative."""
    r = 0.3
    root = sqrt(1 - (r * sin(q)) ** 2)
    slope = -(r**2) * sin(q) * cos(q) / root
    bend = -(r**2) * cos(2 * q) / root - (r**2 * sin(q) * cos(q)) ** 2 / root**3
    return r * cos(q) + root, -r * sin(q) + slope, -r * cos(q) + bend


def _crank(t: float, x: np.ndarray, torque: float = 1.0) -> list[float]:
    """J q'' + J' q'^2/2 = torque with J = 0.2 + 3 s'(q)^2."""
    _, first, second = _stroke(x[0])
    return [x[1], (torque - 3 * first * second * x[1] ** 2) / (0.2 + 3 * first**2)]


@cache
def _crank_angle(after: float) -> float:
    """So long after a start from rest at q = 2."""
    return float(solve_ivp(_crank, (0, after), [2.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-13).y[0, -1])


def _cranks(rate: str, opened: float) -> list[Attack]:
    text = model(SLIDER_CRANK + LOCK.format(rate=rate), "when main.q > 2 then " + UNTIL.format(opened=opened))
    return [
        Attack(
            f"crank_by_{rate[4:-1]}_until_{opened:g}_at_{tolerance:g}",
            text,
            opened + 0.5,
            Later(lambda: {"main.q": _crank_angle(0.5), "n": 1.0}),
            {("main.q > 2", "true"): 1, ("main.q > 2", "false"): 0},
            tolerance=tolerance,
            near=near(tolerance),
        )
        for tolerance in TOLERANCES
    ]


CRANKS = [row for rate in ("der(guide.s)", "der(main.q)") for opened in (3.0, 40.0) for row in _cranks(rate, opened)]


@rows(CRANKS)
def test_a_machine_that_a_lock_holds_rests_at_the_zero_of_its_relation(row: Attack, engine: str) -> None:
    check(row, engine)


# ---- locks at speeds, and two relations of one value ----


def _turning_crank() -> float:
    """Torque -1 turns the crank back; it is held where its speed is zero, and goes on from rest for 0.5 s."""
    options = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-13, "args": (-1.0,)}
    rising = solve_ivp(_crank, (0, 5), [1.0, 2.0], events=lambda t, x, torque: x[1], **options)
    top = float(rising.y_events[0][0][0])
    return float(solve_ivp(_crank, (0, 0.5), [top, 0.0], **options).y[0, -1])


UP = "kinetic 1/2*der(x)^2; potential 10*x;"
CRANK_BACK = SLIDER_CRANK.replace("torque 1", "torque -1")
HELD = [
    Attack(  # x = 2 t - 5 t^2 to 0.2, then -5 (t - 3)^2
        "caught_at_the_top",
        model(
            "coordinate Real x(der(start = 2));" + UP + LOCK.format(rate="der(x)"),
            "when der(x) < 0 then " + UNTIL.format(opened=3),
        ),
        3.5,
        {"x": 0.2 - 1.25, "n": 1.0},
    ),
    Attack(
        "caught_by_another_coordinate",
        model(
            "coordinate Real x(der(start = 2)), y(start = 1); constraint c: y = 1 + 2*x;"
            + UP
            + LOCK.format(rate="der(y)"),
            "when der(y) < 0 then " + UNTIL.format(opened=3),
        ),
        3.5,
        {"x": 0.2 - 1.25, "n": 1.0},
    ),
    *(
        Attack(
            f"crank_that_turns_back_by_{rate[4:-1]}_{solver}",
            model(CRANK_BACK + LOCK.format(rate=rate), f"when {condition} then " + UNTIL.format(opened=10)),
            10.5,
            Later(lambda: {"main.q": _turning_crank(), "n": 1.0}),
            solver=solver,
            **within,
        )
        for rate, condition in (("der(guide.s)", "der(main.q) < 0"), ("der(main.q)", "der(guide.s) > 0"))
        for solver, within in (("auto", {}), ("radau", {"tolerance": 1e-6, "near": 1e-4}))
    ),
    Attack(  # a spring without force holds it where it is opened
        "held_without_a_force",
        model(
            "coordinate Real x(start = 1); kinetic 1/2*der(x)^2; potential 1/2*x^2;" + LOCK.format(rate="der(x)"),
            "when x < 0 then " + UNTIL.format(opened=3),
        ),
        4.0,
        {"x": 0.0, "n": 1.0},
    ),
    Attack(
        "two_relations_of_one_value",
        model(
            "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; force 1 on x; discrete Integer m(start = 0);"
            + LOCK.format(rate="der(x)"),
            "when x > 1 then " + UNTIL.format(opened=3) + " when x >= 1 then m = pre(m) + 1; end when;",
        ),
        3.5,
        {"x": 1.125, "n": 1.0, "m": 1.0},
    ),
]


@rows(HELD)
def test_a_lock_at_a_speed_holds_its_relation(row: Attack, engine: str) -> None:
    check(row, engine)


# ---- three links of length 1, masses 1, 2, 1, of which a lock holds the height of the end ----

PENDULUM = """
coordinate Real a(start = 0.2, der(start = 2)), b(start = 1), c(start = 0.3);
Real h = cos(a) + cos(b) + cos(c);
point p = {sin(a), -cos(a)}; point r = p + {sin(b), -cos(b)}; point s = r + {sin(c), -cos(c)};
mass 1 at p; mass 2 at r; mass 1 at s; gravity = {0, -9.81};
"""
BELOW = np.array([4.0, 3.0, 1.0])  # mass that a link carries
SHARED = np.minimum.outer(BELOW, BELOW)


def _rates(x: np.ndarray, held: bool) -> np.ndarray:
    """M q'' = f, or with the multiplier of (h)' = 0."""
    q, v = x[:3], x[3:]
    difference = q[:, None] - q
    mass = SHARED * np.cos(difference)
    force = -(SHARED * np.sin(difference)) @ v**2 - 9.81 * BELOW * np.sin(q)
    if not held:
        return np.concatenate([v, np.linalg.solve(mass, force)])
    row = -np.sin(q)
    system = np.block([[mass, -row[:, None]], [row[None, :], np.zeros((1, 1))]])
    return np.concatenate([v, np.linalg.solve(system, np.append(force, np.cos(q) @ v**2))[:3]])


def _flow(x: np.ndarray, span: float, held: bool, height: float | None = None) -> tuple[float, np.ndarray]:
    """The state after `span`, or, earlier, where the end comes to `height`; and the time."""

    def reached(t: float, x: np.ndarray) -> float:
        return float(np.cos(x[:3]).sum()) - (height or 0.0)

    reached.terminal = True  # type: ignore[attr-defined]
    events = reached if height is not None else None
    found = solve_ivp(
        lambda t, x: _rates(x, held), (0, span), x, method="DOP853", rtol=1e-13, atol=1e-13, events=events
    )
    return float(found.t[-1]), found.y[:, -1]


@cache
def _angles(height: float) -> tuple[float, ...]:
    """At 3.2: the lock holds from where the end comes to the height until 3; it takes hold by the smallest impulse."""
    begun, x = _flow(np.array([0.2, 1.0, 0.3, 2.0, 0.0, 0.0]), 3.0, held=False, height=height)
    q, v = x[:3], x[3:]
    row = -np.sin(q)
    inverse = np.linalg.solve(SHARED * np.cos(q[:, None] - q), row)
    v = v - inverse * (row @ v) / (row @ inverse)
    _, x = _flow(np.concatenate([q, v]), 3.0 - begun, held=True)
    return tuple(_flow(x, 0.2, held=False)[1][:3])


def _pendulums(height: float) -> list[Attack]:
    text = model(PENDULUM + LOCK.format(rate="der(h)"), f"when h < {height:g} then " + UNTIL.format(opened=3))
    return [
        Attack(
            f"pendulum_at_{height:g}_at_{tolerance:g}",
            text,
            3.2,
            Later(lambda: dict(zip(("a", "b", "c"), _angles(height), strict=True)) | {"n": 1.0}),
            {(f"h < {height:g}", "true"): 1},
            tolerance=tolerance,
            near=near(tolerance),
        )
        for tolerance in TOLERANCES
    ]


PENDULUMS = [row for height in (2.3, 2.4) for row in _pendulums(height)]


@rows(PENDULUMS)
def test_a_machine_that_moves_on_keeps_the_zero_that_a_lock_holds(row: Attack, engine: str) -> None:
    check(row, engine)


# ---- relations that turn by the method's error are told ----

DECAY = "coordinate Real x(start = 1, der(start = -1)); kinetic 1/2*der(x)^2; potential 1/2*x^2; dissipation der(x)^2;"


@pytest.mark.parametrize(("tolerance", "told"), [(1e-4, True), (1e-6, False), (1e-10, False)])
def test_a_relation_that_turns_by_the_error_of_the_motion_is_told(tolerance: float, told: bool) -> None:
    """x = exp(-t) falls below 1e-9 once. At a tolerance of 1e-4 an error of 1e-9 turns the relation again and again."""
    counting = lagdsl.compile(model(DECAY + "discrete Integer n;", "when x < 1e-9 then n = pre(n) + 1; end when;"))
    sink = Sink()
    motion = counting.simulate(stop=40, tolerance=tolerance, sink=sink)
    assert [each.code for each in sink.diagnostics] == ["W0886"] * told
    assert (motion["n"][-1] == 1) is not told


def test_needles_at_speed_are_not_told() -> None:
    """They are narrower than the error of the place, but the motion passes them for certain."""
    passing = lagdsl.compile(
        model(
            "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; discrete Integer n;",
            "when abs(x - 3) < 1e-7 then n = pre(n) + 1; end when;",
        )
    )
    sink = Sink()
    assert passing.simulate(stop=5, tolerance=1e-5, sink=sink)["n"][-1] == 1
    assert not sink.diagnostics
