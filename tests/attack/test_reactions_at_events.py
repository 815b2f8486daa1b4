"""Reactions in relations and clauses: a rod falls from the horizontal about a pin, in a time that is an integral."""

from __future__ import annotations

from math import atan, cos, sin, sqrt

import numpy as np
from attack.rows import Attack, check, rows

# Rod of 1 m and 2 kg under 10 m/s2, at the angle q below the horizontal: w^2 = 30 sin q, w' = 15 cos q. The pin bears
# 2 (10 - 15/2 cos(q)^2 + 15 sin(q)^2) upward and 2*22.5 sin(q) cos(q) along.
ANGLE = atan(sqrt(0.5))  # the pin bears the weight


def _time_to(angle: float) -> float:
    """Integral of dq/w, with q = s^2 for the root at the start; Gauss and Legendre."""
    s, weight = np.polynomial.legendre.leggauss(40)
    s = sqrt(angle) * (s + 1) / 2
    return float(sqrt(angle) / 2 * np.sum(weight * 2 * s / np.sqrt(30 * np.sin(s**2))))


BORNE = _time_to(ANGLE)
UPWARD = 20 - 15 * cos(0.5) ** 2 + 30 * sin(0.5) ** 2
FORCE = sqrt(UPWARD**2 + (45 * sin(0.5) * cos(0.5)) ** 2)


def falling(body: str, clauses: str) -> str:
    return (
        "model Falling\n  import Lag.Planar.*;\n  Revolute pin;\n  Link rod(l = 1 m, m = 2 kg);\n"
        f"  gravity = {{0, -10 m/s2}};\n  connect(world, pin, rod);\n  {body}\nequation\n  {clauses}\nend Falling;\n"
    )


SHOWN = "discrete Real n(start = 0); "
ROWS = [
    Attack(
        "relation",
        falling(SHOWN, "when reaction(pin).force[2] > 20 N then n = time/(1 s); end when;"),
        0.6,
        {"n": BORNE},
    ),
    Attack(
        "value_of_a_clause",
        falling(SHOWN, "when pin.q < -0.5 rad then n = norm(reaction(pin).force)/(1 N); end when;"),
        0.6,
        {"n": FORCE},
    ),
    Attack(
        "branch_of_a_state",
        falling("state Real y;", "der(y) = if reaction(pin).force[2] > 20 N then 1 /s else 0;"),
        0.6,
        {"y": 0.6 - BORNE},
    ),
]


@rows(ROWS)
def test_reactions_at_events(row: Attack, engine: str) -> None:
    check(row, engine)
