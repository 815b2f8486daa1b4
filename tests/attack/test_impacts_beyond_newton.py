"""Impacts of bodies whose momenta are not linear in the rates: momenta are balanced, rates of gaps follow the law of
restitution."""

from __future__ import annotations

from math import sqrt

from attack.rows import Attack, check, model, rows
from scipy.optimize import brentq


def momentum(v: float) -> float:
    """Of a mass of 1, where light has the speed 1."""
    return v / sqrt(1 - v * v)


def speed(p: float) -> float:
    return p / sqrt(1 + p * p)


def struck(v: float, other: float, e: float, mass: float) -> tuple[float, float]:
    """Rates of a mass of 1 and another one after they have met."""
    total, apart = momentum(v) + mass * momentum(other), e * (v - other)
    a = brentq(lambda a: momentum(a) + mass * momentum(a + apart) - total, -0.9999, 0.9999 - apart, xtol=1e-15)
    return a, a + apart


PAIR = (
    "coordinate Real a(der(start = 0.8)), b(start = 0.7, der(start = 0.1));"
    "lagrangian -sqrt(1 - der(a)^2) - 2*sqrt(1 - der(b)^2);"
)
A, B = struck(0.8, 0.1, 0.5, 2)
FAST, SLOW = struck(0.999, 0.0, 0.9, 3)
FIRST, BOTH = struck(0.9, 0.0, 0.5, 6)
TOGETHER = speed((momentum(0.8) + 2 * momentum(0.1)) / 3)
BEYOND_NEWTON = [
    Attack(
        "relativistic",
        model(PAIR + "contact c: b >= a with restitution = 0.5;"),
        2.0,
        {"der(a)": A, "der(b)": B, "a": 0.8 + A, "b": 0.8 + B},
    ),
    Attack(
        "relativistic_plastic",
        model(PAIR + "contact c: b >= a with restitution = 0;"),
        2.0,
        {"der(a)": TOGETHER, "der(b)": TOGETHER},
    ),
    Attack(
        "relativistic_by_a_clause",
        model(PAIR, "when a >= b then impact(b - a, 0.5); end when;"),
        2.0,
        {"der(a)": A, "der(b)": B},
    ),
    Attack(
        "near_the_speed_of_light",
        model(
            "coordinate Real a(der(start = 0.999)), b(start = 0.999); contact c: b >= a with restitution = 0.9;"
            "lagrangian -sqrt(1 - der(a)^2) - 3*sqrt(1 - der(b)^2);"
        ),
        2.0,
        {"der(a)": FAST, "der(b)": SLOW},
    ),
    Attack(
        "relativistic_on_a_rope",
        model(
            "coordinate Real a(der(start = 0.9)), b(start = 0.9), c; constraint rope: b - 0.9 = c;"
            "lagrangian -sqrt(1 - der(a)^2) - 3*sqrt(1 - der(b)^2) - 3*sqrt(1 - der(c)^2);"
            "contact k: b >= a with restitution = 0.5;"
        ),
        2.0,
        {"der(a)": FIRST, "der(b)": BOTH, "der(c)": BOTH},
    ),
    Attack(
        # p = v^3 + v: 1.5^3 + 1.5 = 1 + 1 + 23/11 (1 + 1.5/4)
        "quartic",
        model(
            "coordinate Real a(der(start = 1.5)), b(start = 0.75); contact c: b >= a with restitution = 0.25;"
            "lagrangian 1/4*der(a)^4 + 1/2*der(a)^2 + 23/22*der(b)^2;"
        ),
        1.0,
        {"der(a)": 1.0, "der(b)": 1.375, "a": 1.25},
    ),
]


@rows(BEYOND_NEWTON)
def test_impacts_beyond_newton(row: Attack, engine: str) -> None:
    check(row, engine)
