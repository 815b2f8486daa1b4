"""The oracle against closed forms: what judges others is judged first."""

from __future__ import annotations

from math import cos, pi, sin, sqrt

import numpy as np
import pytest
from choice import ALL, chosen, repeats, spread
from compiled_programs import program_of
from scipy.special import ellipk
from stepping.balance import Balance, impact
from stepping.motion import Motion, motion


def moved(body: str, stop: float, clauses: str = "", known: tuple[float, ...] = ()) -> Motion:
    section = f"equation {clauses}" if clauses else ""
    text = f'model Judge\n{body}\nannotation(units = "none");\n{section}\nend Judge;\n'
    return motion(program_of(text), stop, [stop], known)


def test_period_of_a_pendulum() -> None:
    """Four times K(sin 45 deg) sqrt(l/g) for an amplitude of 90 deg."""
    period = 4 * ellipk(0.5) / sqrt(9.81)
    s = moved(
        "coordinate Real a(start = 1.5707963267948966); kinetic 1/2*der(a)^2; potential -9.81*cos(a);", period
    ).states[-1]
    np.testing.assert_allclose(s.x, [pi / 2, 0.0], atol=1e-10)


@repeats("test_period_of_a_pendulum")
def test_pendulum_by_a_constraint() -> None:
    period = 4 * ellipk(0.5) / sqrt(9.81)
    body = (
        "coordinate Real x(start = 1), y; kinetic 1/2*(der(x)^2 + der(y)^2);potential 9.81*y; constraint x^2 + y^2 = 1;"
    )
    np.testing.assert_allclose(moved(body, period).states[-1].x, [1, 0, 0, 0], atol=1e-9)


def test_ball_bounces_and_rests() -> None:
    """Bounces with flights of 2 v/g that are halved each time, in all sqrt(2 h/g)*(1 + e)/(1 - e); it is at rest where
    the rest of them is shorter than a millionth of the run, and closed at the end of the series."""
    body = (
        "coordinate Real h(start = 1); kinetic 1/2*der(h)^2; potential 9.81*h;contact c: h >= 0 with restitution = 0.5;"
    )
    found = moved(body, 2.0)
    fall = sqrt(2 / 9.81)
    count = next(n for n in range(99) if 4 * fall * 0.5 ** (n + 1) < 2e-6) + 1
    times = [fall * (1 + 2 * sum(0.5**k for k in range(1, n + 1))) for n in range(count)]
    np.testing.assert_allclose([each.time for each in found.told], [*times, 3 * fall], atol=1e-11)
    assert [each.kind for each in found.told] == ["impact"] * count + ["closed"]
    np.testing.assert_allclose(found.states[-1].x, 0.0, atol=1e-12)


@repeats("test_ball_bounces_and_rests")
def test_ball_rests_on_a_moving_table() -> None:
    """Flights become as short as the round-off of the gap is deep; at the end it moves with the table."""
    body = (
        "coordinate Real h(start = 1.37, der(start = -1.703)); kinetic 1/2*der(h)^2; potential 9.81*h;"
        "contact c: h >= 0.03106*sin(6.044*time) with restitution = 0.5;"
    )
    w, b = 6.044, 0.03106
    np.testing.assert_allclose(moved(body, 2.0).states[-1].x, [b * sin(2 * w), b * w * cos(2 * w)], atol=1e-10)


@pytest.mark.skipif(not ALL, reason="hundreds of blows")
def test_plank_rocks_to_rest() -> None:
    """Each end throws the other up, ever less."""
    body = (
        "coordinate Real y(start = 2e-5), a(start = 1e-4); kinetic 1/2*der(y)^2 + 1/2*0.02634*der(a)^2;"
        "potential 9.81*y;"
        "contact l: y + 0.1036*sin(a) >= 0 with restitution = 0.6;"
        "contact r: y - 0.1036*sin(a) >= 0 with restitution = 0.6;"
    )
    np.testing.assert_allclose(moved(body, 0.1).states[-1].x, 0.0, atol=1e-12)


@repeats("test_cradle")
def test_balls_that_go_on_together() -> None:
    """Three inelastic balls in a row share their momentum; nothing presses them, and round-off parts nothing."""
    body = (
        "coordinate Real a(start = -0.5, der(start = 1.862)), b(start = -0.3308), c(start = -0.2308);"
        "kinetic 1/2*0.6305*der(a)^2 + 1/2*der(b)^2 + 1/2*der(c)^2;"
        "contact f: b - a >= 0.1 with restitution = 0; contact g: c - b >= 0.1 with restitution = 0;"
    )
    speed = 0.6305 * 1.862 / 2.6305
    np.testing.assert_allclose(moved(body, 2.0).states[-1].v, [speed] * 3, atol=1e-10)


@pytest.mark.parametrize("e", chosen([0.0, 0.5, 1.0], [0.5]))
def test_two_balls(e: float) -> None:
    """Momentum and Newton's law: masses 1 and 3, speed 2."""
    body = (
        "coordinate Real a(start = -1, der(start = 2)), b; kinetic 1/2*der(a)^2 + 1/2*3*der(b)^2;"
        f"contact c: b >= a with restitution = {e};"
    )
    s = moved(body, 1.0).states[-1]
    common = 2 / 4
    exact = [common - 3 / 4 * e * 2, common + 1 / 4 * e * 2]
    np.testing.assert_allclose(s.v, exact, atol=1e-12)
    np.testing.assert_allclose(s.q, [0.5 * x for x in exact], atol=1e-11)


def test_cradle() -> None:
    body = (
        "coordinate Real x[3](start = {-0.3, 0, 0.1}, der(start = {2, 0, 0})); kinetic 1/2*der(x)*der(x);"
        "contact a: x[2] - x[1] >= 0.1 with restitution = 1; contact b: x[3] - x[2] >= 0.1 with restitution = 1;"
    )
    np.testing.assert_allclose(moved(body, 0.5).states[-1].v, [0, 0, 2], atol=1e-12)


def test_impact_of_a_rod() -> None:
    """One end of a free rod meets the ground: textbook values."""
    m, inertia, half, speed = 2.0, 0.3, 0.5, 4.0
    jump, p = impact(np.diag([m, inertia]), np.zeros((0, 2)), np.array([[1.0, half]]), np.array([-speed]), [0.5])
    impulse = 1.5 * speed / (1 / m + half**2 / inertia)
    np.testing.assert_allclose(p, [impulse])
    np.testing.assert_allclose(jump, [impulse / m, impulse * half / inertia])


def test_clutch_closes_and_opens() -> None:
    body = (
        "coordinate Real a, b; kinetic 1/2*der(a)^2 + 1/2*der(b)^2; torque 1 on a;"
        "constraint c: (if sin(3.141592653589793*time) > 0 then der(a) - der(b) else 0) = 0;"
    )
    np.testing.assert_allclose(moved(body, 4.0).states[-1].x, [4.5, 3.5, 2.5, 1.5], atol=1e-10)


@pytest.mark.parametrize(
    "ramp",
    spread(["max(0, time - 1)", "(if time < 1 then 0 else time - 1)", "table(time, {0, 1, 9}, {0, 0, 8})"], 2),
)
@repeats("test_ball_rests_on_a_moving_table")
def test_base_that_starts_to_move(ramp: str) -> None:
    s = moved(f"coordinate Real x; potential 1/2*9*x^2; gravity = 0; mass 1 at {{x + {ramp}, 0}};", 3.0).states[-1]
    np.testing.assert_allclose(s.x, [-sin(6) / 3, -cos(6)], atol=1e-11)


def test_pulses() -> None:
    body = "coordinate Real x; kinetic 1/2*der(x)^2; force max(0, 1 - abs(time - 5)/1e-3) on x;"
    s = moved(body, 10.0, known=(5.0,)).states[-1]
    np.testing.assert_allclose(s.x, [5e-3, 1e-3], rtol=1e-11)


def test_clauses_and_clocks() -> None:
    """A sampled force, an integrator of ticks, a reset by a clause."""
    body = (
        "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; discrete Real u(start = 0); "
        "discrete Integer n(start = 0);"
        "force u on x;"
    )
    clauses = (
        "when sample(0, 0.25) then u = 2 - pre(u); n = pre(n) + 1; end when;"
        "when x > 10 then reinit(der(x), -1); end when;"
    )
    found = moved(body, 1.0, clauses)
    # forces 2, 0, 2, 0 for a quarter each; the tick at the end is one more
    np.testing.assert_allclose(found.states[-1].v, [2.0], atol=1e-12)
    assert len([each for each in found.told if each.kind == "tick"]) == 5


def test_least_impulse_with_dependent_rows() -> None:
    rows = np.array([[1.0, -1.0], [2.0, -2.0]])
    x, y = Balance(np.diag([1.0, 2.0]), rows).solve(np.array([3.0, 0.0]), np.zeros(2))
    np.testing.assert_allclose(x, [1.0, 1.0])
    np.testing.assert_allclose(rows.T @ y, [-2.0, 2.0], atol=1e-12)
