"""Tracks with corners: one track, whatever function writes it, is one motion. References by the balance of energy."""

from __future__ import annotations

from math import sqrt

import pytest
from attack.rows import Attack, check, model, rows

import lagdsl

# A track that is level up to x = 0 and rises by 45 degrees from there on.
RAMPS = {
    "if": "(if x > 0 then x else 0)",
    "max": "max(0, x)",
    "min": "-min(0, -x)",
    "abs": "(x + abs(x))/2",
    "limit": "limit(x, 0, 99)",
    "table": "table(x, {-9, 0, 9}, {0, 0, 9})",
}
START = "coordinate Real x(start = -1, der(start = 1)); "
# Level, up by one, level: the speed along the track stays one.
STEPS = {
    "if": "(if x < 0 then 0 elseif x < 1 then x else 1)",
    "limit": "limit(x, 0, 1)",
    "min_max": "min(1, max(0, x))",
    "table": "table(x, {-9, 0, 1, 9}, {0, 0, 1, 1})",
}
TRACKS = [
    *(
        Attack(f"{how}_{name}", model(START + text.format(track)), 3.0, {"x": sqrt(2), "der(x)": sqrt(0.5)})
        for name, track in RAMPS.items()
        for how, text in {
            "mass_on": "gravity = 0; mass 1 at {{x, {}}};",
            "energy_of": "Real y = {}; kinetic 1/2*(der(x)^2 + der(y)^2);",
            "body_on": "gravity = 0; frame A = world.move({{x, {}, 0}}); body B(m = 1, Izz = 1) on A;",
        }.items()
    ),
    *(
        Attack(
            f"over_two_corners_{name}",
            model(START + f"gravity = 0; mass 1 at {{x, {track}}};"),
            3.0,
            {"x": 3 - sqrt(2), "der(x)": 1.0},
        )
        for name, track in STEPS.items()
    ),
    # down one side of a roof that stands on its head, and up the other: at rest after four times 1/sqrt(g)
    *(
        Attack(
            f"valley_{name}",
            model(f"coordinate Real x(start = -1); gravity = {{0, -9, 0}}; mass 1 at {{x, {track}}};"),
            4 / 3,
            {"x": 1.0, "der(x)": 0.0},
            near=1e-7,
        )
        for name, track in {"abs": "abs(x)", "if": "(if x < 0 then -x else x)", "max": "max(x, -x)"}.items()
    ),
    # the impulse of a constraint is normal to the new direction: half of the speed in x is left
    *(
        Attack(
            f"constraint_{name}",
            model(START + f"coordinate Real y; kinetic 1/2*(der(x)^2 + der(y)^2); constraint c: y = {track};"),
            3.0,
            {"x": 1.0, "y": 1.0, "der(x)": 0.5, "der(y)": 0.5},
        )
        for name, track in RAMPS.items()
    ),
]


@rows(TRACKS)
def test_track_corners(row: Attack, engine: str) -> None:
    check(row, engine)


@pytest.mark.parametrize("name", RAMPS)
@pytest.mark.parametrize(
    "way",
    [
        START + "gravity = 0; mass 1 at {{x, {}}};",
        START + "coordinate Real y; kinetic 1/2*(der(x)^2 + der(y)^2); constraint c: y = {};",
    ],
)
def test_every_form_of_a_corner_is_told(way: str, name: str) -> None:
    told = lagdsl.compile(model(way.format(RAMPS[name]))).diagnostics
    assert {each.code for each in told} >= {"W0520"}


def test_a_rope_that_becomes_taut_is_no_corner() -> None:
    body = "coordinate Real l(start = 0.5, der(start = 1)); kinetic 1/2*der(l)^2; "
    told = lagdsl.compile(model(body + "constraint rope: (if l > 1 then l - 1 else 0) = 0;")).diagnostics
    assert "W0520" not in {each.code for each in told}
