"""Sides of relations behind an instant: their rates and accelerations along the motion."""

from __future__ import annotations

from math import ceil, cos, pi, sin
from typing import Any

import numpy as np
import pytest
from attack.rows import model

import lagdsl
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group

MOVING = model(
    "coordinate Real x(start = 1); input Real u; state Real z(start = 0); kinetic 1/2*der(x)^2; force u on x;",
    'der(z) = x*u; when sin(x) + z > u then terminate("a"); end when;when der(x)*x > 3 then terminate("b"); end when;',
)


def test_rates_and_accelerations_are_derivatives_along_the_motion() -> None:
    """g = sin x + z - u and h = x' x - 3; x'' and z' and u' are given, x''' and u'' taken as zero."""
    program = lagdsl.compile(MOVING)._compilation.program
    x, v, a, u, du, dz = 0.7, -1.3, 0.4, 0.9, 0.25, 3.5
    symbols = {Group.TIME: 0.0, Group.Q: [x], Group.QD: [v], Group.QDD: [a], Group.Z: [2.0], Group.U: [u]}
    rates = {Group.DIRECTION_Z: [dz], Group.DIRECTION_U: [du], Group.DIRECTION_QDD: [0.0]}
    along = {**rates, Group.W: np.zeros(9), Group.P: [], Group.LAMBDA: []}
    rate, acceleration = program.function("indicator_rate").results
    arrays = {group: value if group is Group.TIME else np.array(value) for group, value in (symbols | along).items()}
    found = evaluate(program.graph, [*rate.elements, *acceleration.elements], arrays)
    first = (cos(x) * v + dz - du, a * x + v * v)
    second = (-sin(x) * v * v + cos(x) * a + v * u + x * du, 3 * a * v)
    assert found == pytest.approx([*first, *second], rel=1e-14)


@pytest.mark.parametrize("a", [1e-13, 1e-7, 1.0, 1e6])
def test_what_starts_at_rest_on_its_border_goes_where_its_acceleration_leads(a: float) -> None:
    """However small it is: no look ahead decides, but the sign of x''."""
    text = model(
        f"coordinate Real x(start = 1), y(start = 1); kinetic 1/2*(der(x)^2 + der(y)^2);"
        f"force {a} on x; force {-a} on y; discrete Integer n(start = 0), m(start = 0);",
        "when x > 1 then n = pre(n) + 1; end when; when y > 1 then m = pre(m) + 1; end when;",
    )
    motion = lagdsl.compile(text).simulate(stop=1.0, interval=0.5)
    assert not motion.events
    assert (motion["n"][-1], motion["m"][-1]) == (1.0, 0.0)


def test_a_window_narrower_than_round_off_of_a_step_is_entered_and_left() -> None:
    text = model(
        "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; discrete Integer n(start = 0);",
        "when abs(x - 1/3) < 1e-12 then n = pre(n) + 1; end when;",
    )
    motion = lagdsl.compile(text).simulate(stop=1.0, interval=0.5)
    assert [event.kind for event in motion.events] == ["true", "false"]
    assert motion["n"][-1] == 1.0


SETTINGS = [
    *({"tolerance": tolerance} for tolerance in (1e-3, 1e-6, 1e-10)),
    {},
    {"solver": "radau"},
    {"solver": "rk4", "step": 0.01},
]


@pytest.mark.parametrize("settings", SETTINGS, ids=str)
@pytest.mark.parametrize("start", [0.0, 1e-6, 0.3, -7.1])
def test_a_relation_between_accelerations_turns_once_at_each_crossing(start: float, settings: dict[str, Any]) -> None:
    """cos(20 s) at s = start + t. Nothing gives the rate of an acceleration; at s = 0 its gradient is zero as well."""
    text = model(
        "coordinate Real s(der(start = 1)), x; kinetic 1/2*(der(s)^2 + der(x)^2); force 0.3*cos(20*s) on x;"
        "discrete Integer n(start = 0);",
        "when der(der(x)) < 0 then n = pre(n) + 1; end when;",
    )
    motion = lagdsl.compile(text, engine="tape").simulate(stop=10.0, start={"s": start}, **settings)
    first = ceil(20 * start / pi - 0.5)
    places = np.pi / 20 * (0.5 + np.arange(first, first + 80)) - start
    crossings = places[(places > 0) & (places < 10)]
    falling = cos(20 * (start + crossings[0]) + 1e-3) < 0
    assert [event.kind for event in motion.events][:2] == (["true", "false"] if falling else ["false", "true"])
    assert len(motion.events) == len(crossings)
    assert [event.time for event in motion.events] == pytest.approx(crossings, abs=1e-9)
    assert motion["n"][-1] == len(crossings[0 if falling else 1 :: 2])
