"""Stiff models, in rows and at events between the ends of steps."""

from __future__ import annotations

from math import acos, atan, cos, floor, pi, sqrt

import numpy as np
import pytest
from attack.rows import Attack, check, model, rows

import lagdsl

FOLLOWS = "der(z) = -{rate}*(z - cos(time)); "


def _above(rate: float, level: float, stop: float) -> int:
    """Number of times that cos(t - d)/sqrt(1 + 1/rate^2), with tan d = 1/rate, passes the level upward."""
    half, late = acos(level * sqrt(1 + rate**-2)), atan(1 / rate)
    return floor((stop - late + half) / (2 * pi))


TOPS = [
    Attack(
        f"follower_of_{rate:g}_at_its_top_at_{tolerance:g}",
        model(
            "state Real z(start = 1); discrete Integer n(start = 0);",
            FOLLOWS.format(rate=rate) + "when z > 0.99999 then n = pre(n) + 1; end when;",
        ),
        300.0,
        {"n": _above(rate, 0.99999, 300.0)},
        counts={("z > 0.99999", "true"): _above(rate, 0.99999, 300.0)},
        tolerance=tolerance,
        solver=solver,
    )
    for rate, tolerance, solver in (
        (1e6, 1e-6, "auto"),
        (1e6, 1e-8, "auto"),
        (1e5, 1e-10, "auto"),
        (1e6, 1e-8, "radau"),
    )
]


@rows(TOPS)
def test_events_of_stiff_states(row: Attack, engine: str) -> None:
    check(row, engine)


@pytest.mark.parametrize("solver", ["auto", "radau"])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8, 1e-10])
def test_rows_between_long_steps(tolerance: float, solver: str) -> None:
    """A state is in equilibrium at the nodes of a step, however long that is; rows are between them."""
    rate = 1e6
    text = model("state Real z(start = 1);", FOLLOWS.format(rate=rate))
    motion = lagdsl.compile(text).simulate(stop=100.0, tolerance=tolerance, interval=0.1, solver=solver)
    exact = (np.cos(motion.time) + np.sin(motion.time) / rate) / (1 + rate**-2)
    assert np.max(np.abs(motion["z"][1:] - exact[1:])) < 3 * tolerance
    assert abs(motion["z"][-1] - cos(100.0)) < 3 * tolerance + 1 / rate


@pytest.mark.parametrize("width", [0.3, 0.2, 0.1])
def test_rows_where_an_equilibrium_bends(width: float) -> None:
    """Steps that a bend makes doubtful are looked at between their nodes. The state is late by 1/rate."""
    tolerance, rate = 1e-4, 1e6
    text = model(
        "state Real z(start = -1);",
        f"der(z) = -{rate}*(z - tanh((time - 0.5 s)/({width} s)) - exp(-((time - 2 s)/({width} s))^2));".replace(
            " s", ""
        ),
    )
    motion = lagdsl.compile(text).simulate(stop=3.0, tolerance=tolerance, interval=1e-3, solver="radau")
    t = motion.time[1:] - 1 / rate
    exact = np.tanh((t - 0.5) / width) + np.exp(-(((t - 2.0) / width) ** 2))
    assert np.max(np.abs(motion["z"][1:] - exact)) < 3 * tolerance
