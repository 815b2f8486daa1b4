"""Steps of energy in place, and changes of momenta, of bodies whose momenta are not linear in the rates."""

from __future__ import annotations

from math import sqrt

import pytest
from attack.rows import Attack, check, model, rows
from scipy.optimize import brentq, minimize_scalar

import lagdsl


def momentum(v: float) -> float:
    """Of a mass of 1, where light has the speed 1."""
    return v / sqrt(1 - v * v)


def energy(v: float) -> float:
    return 1 / sqrt(1 - v * v)


def speed(p: float, mass: float = 1) -> float:
    return p / sqrt(mass**2 + p * p)


def speed_of_energy(h: float, mass: float = 1) -> float:
    return sqrt(1 - (mass / h) ** 2)


def behind(v: float, step: float, moving: float = 0.0) -> float:
    """The rate behind a step of the potential energy that moves, v > moving: p grows by mu, the energy by mu*moving."""
    p = momentum(v)
    rest = momentum(moving) - p  # where the body goes with the step

    def excess(mu: float, step: float) -> float:
        return sqrt(1 + (p + mu) ** 2) + step - energy(v) - mu * moving

    if excess(rest, step) <= 0:
        return speed(p + brentq(lambda mu: excess(mu, step), rest, 99, xtol=1e-15))
    return speed(p + brentq(lambda mu: excess(mu, 0), -99, rest, xtol=1e-15))


def parted(v: float, other: float, mass: float, step: float) -> tuple[float, float]:
    """Rates of a mass of 1 and another one where their distance leads over a step: momentum and energy are kept."""
    p, q = momentum(v), mass * momentum(other)
    start = energy(v) + mass * energy(other)

    def excess(mu: float, step: float) -> float:
        return sqrt(1 + (p - mu) ** 2) + sqrt(mass**2 + (q + mu) ** 2) + step - start

    least = minimize_scalar(lambda mu: excess(mu, 0), bracket=(0, 1), tol=1e-14).x
    if excess(least, step) <= 0:
        mu = brentq(lambda mu: excess(mu, step), -99, least, xtol=1e-15)
    else:
        mu = brentq(lambda mu: excess(mu, 0), least, 99, xtol=1e-15)
    return speed(p - mu), speed(q + mu, mass)


def refracted(step: float, along: tuple[float, float], shift: float = 0.0) -> tuple[float, float]:
    """Rates (0.6, 0.3) behind a step with this normal: the momentum across the normal stays, but for a shift in y."""
    h = 1 / sqrt(1 - 0.45)
    p, q = 0.6 * h, 0.3 * h - shift
    rest = h - step
    size = along[0] ** 2 + along[1] ** 2
    b = (p * along[0] + q * along[1]) / size
    mu = -b + sqrt(b * b - (p * p + q * q - rest**2 + 1) / size)
    return (p + mu * along[0]) / rest, (q + mu * along[1]) / rest


FAST = "coordinate Real a(der(start = 0.8)); lagrangian -sqrt(1 - der(a)^2); "
PLANE = "coordinate Real x(der(start = 0.6)), y(der(start = 0.3)); lagrangian -sqrt(1 - der(x)^2 - der(y)^2); "
PAIR = (
    "coordinate Real a(der(start = 0.8)), b(start = 0.7, der(start = 0.1));"
    "lagrangian -sqrt(1 - der(a)^2) - 2*sqrt(1 - der(b)^2); "
)
QUARTIC = "coordinate Real a(der(start = 2)); lagrangian der(a)^4/4; "
UP, DOWN = refracted(0.2, (1, 1)), refracted(-2, (1, 2))
TURNED = refracted(0, (1, 0), 0.5)
SLOW, PUSHED = parted(0.8, 0.1, 2, 0.1)
THROWN, HIT = parted(0.8, 0.1, 2, 0.9)
TOGETHER = brentq(lambda v: 3 * energy(v) + 0.4 - 3 * energy(0.6), 0, 0.9, xtol=1e-16)
STEPS_BEYOND_NEWTON = [
    Attack("up", model(FAST + "potential if a < 0.8 then 0 else 0.3;"), 2.0, {"der(a)": behind(0.8, 0.3)}),
    Attack("down", model(FAST + "potential if a < 0.8 then 0 else -3;"), 2.0, {"der(a)": behind(0.8, -3)}),
    Attack("back", model(FAST + "potential if a < 0.8 then 0 else 0.7;"), 2.0, {"der(a)": -0.8, "a": 0.0}),
    Attack(
        "mass_that_falls_in_place",
        model("coordinate Real a(der(start = 0.8)); lagrangian -(if a < 0.8 then 1 else 0.2)*sqrt(1 - der(a)^2);"),
        2.0,
        {"der(a)": speed_of_energy(energy(0.8), 0.2)},
    ),
    Attack(
        # the momentum 4/3 of a fifth of the mass: Newton's first step leads past the speed of light
        "mass_that_falls_in_time",
        model("coordinate Real a(der(start = 0.8)); lagrangian -(if time < 1 then 1 else 0.2)*sqrt(1 - der(a)^2);"),
        2.0,
        {"der(a)": speed(4 / 3, 0.2)},
    ),
    Attack(
        "carriage_that_starts",
        # 1.3 is beyond the speed of light, so Newton's method begins with less
        model(
            "coordinate Real a(der(start = 0.8)); Real v = 0.5*max(0, time - 1);"
            "lagrangian -sqrt(1 - (der(a) + der(v))^2);"
        ),
        2.0,
        {"der(a)": 0.3},
    ),
    Attack(
        "refraction",
        model(PLANE + "potential if x + y < 0.9 then 0 else 0.2;"),
        2.0,
        {"der(x)": UP[0], "der(y)": UP[1], "x": 0.6 + UP[0], "y": 0.3 + UP[1]},
    ),
    Attack(
        "refraction_downward",
        model(PLANE + "potential if x + 2*y < 1.2 then 0 else -2;"),
        2.0,
        {"der(x)": DOWN[0], "der(y)": DOWN[1]},
    ),
    Attack(
        "reflection",
        model(PLANE + "potential if x + y < 0.9 then 0 else 5;"),
        2.0,
        {"der(x)": -0.3, "der(y)": -0.6},
    ),
    Attack(
        "vector_potential",
        model(PLANE + "lagrangian (if x < 0.6 then 0 else 0.5)*der(y);"),
        2.0,
        {"der(x)": TURNED[0], "der(y)": TURNED[1]},
    ),
    Attack("total_derivative", model(FAST + "lagrangian (if a < 0.8 then 0 else 5)*der(a);"), 2.0, {"der(a)": 0.8}),
    Attack(
        "moving_step",
        model(FAST + "potential if a - 0.3*time < 0.5 then 0 else 0.2;"),
        2.0,
        {"der(a)": behind(0.8, 0.2, 0.3)},
    ),
    Attack(
        "moving_step_that_throws_back",
        model(FAST + "potential if a - 0.3*time < 0.5 then 0 else 0.9;"),
        2.0,
        {"der(a)": behind(0.8, 0.9, 0.3), "a": 0.8 + behind(0.8, 0.9, 0.3)},
    ),
    Attack(
        "on_a_rope",
        model(
            "coordinate Real a(der(start = 0.6)), b(der(start = 0.6)); constraint rope: a = b;"
            "lagrangian -sqrt(1 - der(a)^2) - 2*sqrt(1 - der(b)^2); potential if a < 0.6 then 0 else 0.4;"
        ),
        2.0,
        {"der(a)": TOGETHER, "der(b)": TOGETHER},
    ),
    Attack(
        "between_two",
        model(PAIR + "potential if b > a then 0 else 0.1;"),
        2.0,
        {"der(a)": SLOW, "der(b)": PUSHED, "a": 0.8 + SLOW, "b": 0.8 + PUSHED},
    ),
    Attack(
        "between_two_thrown_back",
        model(PAIR + "potential if b > a then 0 else 0.9;"),
        2.0,
        {"der(a)": THROWN, "der(b)": HIT},
    ),
    Attack(
        # h = 3/4 v^4
        "quartic",
        model(QUARTIC + "potential if a < 2 then 0 else 6;"),
        2.0,
        {"der(a)": 8**0.25},
    ),
    # the mass 3 v^2 vanishes where the motion turns back
    Attack("quartic_back", model(QUARTIC + "potential if a < 2 then 0 else 13;"), 2.0, {"der(a)": -2.0, "a": 0.0}),
    Attack(
        "near_the_speed_of_light",
        model(
            "coordinate Real a(der(start = 0.999999)); lagrangian -sqrt(1 - der(a)^2);"
            "potential if a < 0.999999 then 0 else 700;"
        ),
        2.0,
        {"der(a)": speed_of_energy(energy(0.999999) - 700)},
    ),
    Attack(
        "up_to_the_speed_of_light",
        model(
            "coordinate Real a(der(start = 0.001)); lagrangian -sqrt(1 - der(a)^2);"
            "potential if a < 0.001 then 0 else -1000;"
        ),
        2.0,
        {"der(a)": speed_of_energy(energy(0.001) + 1000)},
    ),
]


@rows(STEPS_BEYOND_NEWTON)
def test_steps_beyond_newton(row: Attack, engine: str) -> None:
    check(row, engine)


@pytest.mark.parametrize(
    "text",
    [
        "lagrangian (if time < 1 then 1 else 0.5)*sqrt(1 + der(a)^2);",
        "lagrangian sqrt(1 + der(a)^2); potential if a < 3 then 0 else -2;",
    ],
    ids=["in_time", "in_place"],
)
def test_momenta_that_no_rate_has(text: str) -> None:
    """The momentum v/sqrt(1 + v^2) is less than one, and h = -1/sqrt(1 + v^2) than zero."""
    with pytest.raises(lagdsl.SimulationFailed) as failed:
        lagdsl.compile(model("coordinate Real a(der(start = 3)); " + text)).simulate(stop=2.0)
    assert (
        failed.value.diagnostic.code == "E0840" and failed.value.name == "a" and failed.value.time == pytest.approx(1)
    )
