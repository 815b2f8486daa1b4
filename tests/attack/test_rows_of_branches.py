"""Constraints that repeat others in one branch, at one moment or for one value, and not in others."""

from __future__ import annotations

from math import cos, sin

import numpy as np
import pytest
from attack.rows import Attack, check, model, rows
from scipy.integrate import solve_ivp

# Discs of 1, 2 and 3 with the torques 3 and -1 on the first and the last. Two of them are one; a second row says the
# same up to 1 s, and ties the third one behind it. Before: a' = 3/3, c' = -1/3. At 1 s: (1 + 2 - 1)/6 = 1/3, as
# behind it: (3 - 1)/6. The rows carry 3 - 1/3 and 3 - 3/3 then; before, both carry half of 2, which is the least norm.
DISCS = (
    "coordinate Real a, b, c; kinetic 1/2*(der(a)^2 + 2*der(b)^2 + 3*der(c)^2); force 3 on a; force -1 on c;"
    "output Real one = multiplier(always); output Real two = multiplier(branch);"
)
BEHIND = {"der(a)": 2 / 3, "der(c)": 2 / 3, "a": 1.0, "c": -1 / 6 + 1 / 2, "one": -3 + 1 / 3, "two": -2.0}
ALWAYS = "constraint always: der(a) - der(b) = 0;"


def _both(name: str, branch: str, more: str = "", clauses: str = "", **options: object) -> list[Attack]:
    """The row that is always there as the first and as the last one."""
    switched = f"constraint branch: {branch} = 0;"
    return [
        Attack(f"{name}_{order}", model(DISCS + more + text, clauses), 2.0, BEHIND, **options)  # type: ignore[arg-type]
        for order, text in (("behind", ALWAYS + switched), ("before", switched + ALWAYS))
    ]


def _pushed(q: float, t: float) -> tuple[float, float]:
    """Angle and rate of a pendulum of length 1 at the time t from rest at the angle q."""
    found = solve_ivp(lambda _, x: (x[1], -9.81 * sin(x[0])), (0, t), (q, 0), rtol=1e-13, atol=1e-14, method="DOP853")
    return float(found.y[0, -1]), float(found.y[1, -1])


TURNED, TURNING = _pushed(1.0, 0.8)
NO_MOTION = {"a": 0.0, "der(a)": 0.0}

BRANCHES = [
    *_both("by_time", "(if time < 1 then der(a) - der(b) else der(b) - der(c))"),
    *_both(
        "by_an_integer_input",
        "(if gear == 1 then der(a) - der(b) else der(b) - der(c))",
        "input Integer gear(start = 1);",
        inputs={"gear": ((0.0, 1.0, 1.0, 3.0), (1.0, 1.0, 2.0, 2.0))},
    ),
    *_both(
        "by_a_boolean_input",
        "(if apart then der(b) - der(c) else der(a) - der(b))",
        "input Boolean apart;",
        inputs={"apart": ((0.0, 1.0, 1.0, 3.0), (0.0, 0.0, 1.0, 1.0))},
    ),
    *_both(
        "in_places",
        "(if apart then b - c - off else a - b)",
        "discrete Boolean apart(start = false); discrete Real off(start = 0);",
        "when time >= 1 then apart = true; off = b - c; end when;",
    ),
    Attack(
        "pendulum_that_is_held_at_the_start",
        # both of its coordinates are held, and the rod as well
        model(
            "coordinate Real x(start = sin(1)), y(start = -cos(1)); gravity = {0, -9.81, 0}; mass 1.5 at {x, y};"
            "discrete Boolean held(start = true); constraint across: (if held then x - sin(1) else 0) = 0;"
            "constraint along: (if held then y + cos(1) else 0) = 0; constraint rod: x^2 + y^2 = 1;",
            "when time >= 0.5 then held = false; end when;",
        ),
        1.3,
        {"x": sin(TURNED), "y": -cos(TURNED), "der(x)": TURNING * cos(TURNED)},
    ),
    # at the start rows say the same, a moment later they leave no motion: no branch is determined
    *[
        Attack(
            f"ratio_that_{how}_{order}",
            model(DISCS + more + text, clauses),
            2.0,
            NO_MOTION,
            refused=("E0830",),
        )
        for how, more, clauses in (
            ("grows", "Real ratio = 1 + time;", ""),
            ("follows", "state Real ratio(start = 1);", "der(ratio) = 1;"),
        )
        for order, text in (
            ("behind", ALWAYS + "constraint branch: der(a) - ratio*der(b) = 0;"),
            ("before", "constraint branch: der(a) - ratio*der(b) = 0;" + ALWAYS),
        )
    ],
    Attack(
        "ratio_that_a_clause_sets",
        # nothing of the first two moves from 1 s on
        model(
            DISCS + "discrete Real ratio(start = 1); constraint branch: der(a) - ratio*der(b) = 0;" + ALWAYS,
            "when time >= 1 then ratio = 2; end when;",
        ),
        2.0,
        {"der(a)": 0.0, "a": 0.5, "der(c)": -2 / 3},
    ),
    Attack(
        "ratio_with_a_late_corner",
        # where the row does not follow any more the run ends: its multiplier has no part in the solution
        model(DISCS + ALWAYS + "Real ratio = max(1, time - 8); constraint branch: der(a) - ratio*der(b) = 0;"),
        9.9,
        NO_MOTION,
        refused=("E0811",),
    ),
    *[
        Attack(
            f"ratio_of_a_parameter_{order}",
            model(DISCS + "parameter Real ratio = 1;" + text),
            1.0,
            NO_MOTION,
            parameters={"ratio": 2.0},
            refused=("E0831",),
        )
        for order, text in (
            ("behind", ALWAYS + "constraint branch: der(a) - ratio*der(b) = 0;"),
            ("before", "constraint branch: der(a) - ratio*der(b) = 0;" + ALWAYS),
        )
    ],
    Attack(
        "row_that_is_round_off_beside_another",
        model(
            "coordinate Real a, b, c; kinetic 1/2*(der(a)^2 + 2*der(b)^2 + 3*der(c)^2); force 3 on a;"
            "constraint large: (if time < 1 then 0 else 1e12*(der(a) - der(b))) = 0;"
            "constraint small: (if time < 1 then 0 else 1e-6*(der(b) - der(c))) = 0;"
        ),
        2.0,
        {"der(a)": 1.0, "der(b)": 1.0, "der(c)": 1.0},
        refused=("E0811",),
    ),
]


@rows(BRANCHES)
def test_rows_of_branches(row: Attack, engine: str) -> None:
    check(row, engine)


@pytest.mark.parametrize("engine", ["tape", "c"])
@pytest.mark.parametrize("masses", [(1.0, 2.0, 3.0), (0.1, 0.7, 0.3), (3.0, 1e-6, 7.0)])
def test_rows_that_repeat_one_share_its_force(masses: tuple[float, float, float], engine: str) -> None:
    """Least norm, also where one of them is left to run time and what the other leaves of it is round-off."""
    a, b, c = masses
    text = model(
        f"coordinate Real a, b, c; kinetic 1/2*({a}*der(a)^2 + {b}*der(b)^2 + {c}*der(c)^2); force 3 on a;"
        "output Real one = multiplier(always); output Real two = multiplier(branch);"
        "constraint branch: (if time < 1 then 3*der(a) - 3*der(b) else der(b) - der(c)) = 0;" + ALWAYS
    )
    force = 3 * a / (a + b) - 3
    least = np.linalg.pinv(np.array([[1.0, 3.0]])) @ [force]
    check(Attack("shared", text, 0.9, {"one": float(least[0]), "two": float(least[1])}, near=1e-12), engine)
