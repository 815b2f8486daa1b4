"""Tables that jump for inputs which prescribe speeds are blows: momenta are kept, contacts open and strike."""

from __future__ import annotations

from math import cos, sin

import numpy as np
import pytest
from attack.rows import Attack, check, model, rows

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed

STARTED = ((0.0, 1.0, 1.0, 2.0), (0.0, 0.0, 1.0, 1.0))
LOWERED = ((0.0, 1.0, 1.0, 2.0), (0.0, 0.0, -1.0, -1.0))
SPEED = "input Real w(smooth = 1); "
PLATE = SPEED + "coordinate Real x{start}, p; kinetic 1/2*der(p)^2; constraint drive: der(p) = w; "

JUMPS = [
    Attack(
        "free_mass_on_a_carriage_that_starts",
        model("coordinate Real x; state Real p; " + SPEED + "gravity = 0; mass 1 at {x + p, 0};", "der(p) = w;"),
        2.0,
        {"x": -1.0, "der(x)": -1.0, "p": 1.0},
        inputs={"w": STARTED},
    ),
    Attack(
        # the carriage is at s itself: its speed is given beside it
        "free_mass_on_a_carriage_whose_speed_is_given",
        model("coordinate Real x; input Real s(smooth = 2); gravity = 0; mass 1 at {x + s, 0};"),
        2.0,
        {"x": -1.0, "der(x)": -1.0},
        inputs={"s": ((0.0, 1.0, 2.0), (0.0, 0.0, 1.0)), "der(s)": STARTED, "der(der(s))": 0.0},
    ),
    Attack(
        "free_mass_on_a_carriage_whose_speed_is_differentiated",
        model("coordinate Real x; input Real s(smooth = 2); gravity = 0; mass 1 at {x + s, 0};"),
        2.0,
        {"x": -1.0, "der(x)": -1.0},
        inputs={"s": ((0.0, 1.0, 2.0), (0.0, 0.0, 1.0)), "der(s)": STARTED},
    ),
    Attack(
        "mass_on_a_spring_on_a_carriage_that_starts",
        model(
            "coordinate Real x; state Real p; " + SPEED + "gravity = 0; mass 1 at {x + p, 0}; potential 2*x^2;",
            "der(p) = w;",
        ),
        2.0,
        {"x": -sin(2) / 2, "der(x)": -cos(2)},
        inputs={"w": STARTED},
    ),
    Attack(
        # b' - a' is kept
        "disc_that_a_shaft_drags",
        model(SPEED + "coordinate Real a, b; kinetic der(a)^2 + 1/2*(der(b) - der(a))^2; constraint d: der(a) = w;"),
        2.0,
        {"der(a)": 1.0, "der(b)": 1.0, "a": 1.0, "b": 1.0},
        inputs={"w": STARTED},
    ),
    Attack(
        "ball_that_a_plate_hits",
        model(PLATE.format(start="(start = 0.5)") + "kinetic 1/2*der(x)^2; contact c: x >= p with restitution = 1;"),
        2.0,
        {"x": 1.5, "der(x)": 2.0},
        {("c", "impact"): 1},
        inputs={"w": STARTED},
    ),
    Attack(
        "block_that_a_plate_leaves",
        model(PLATE.format(start="") + "gravity = {0, -1}; mass 1 at {0, x}; contact c: x >= p with restitution = 0;"),
        2.0,
        {"x": -0.5, "der(x)": -1.0},
        {("c", "opened"): 1},
        inputs={"w": LOWERED},
    ),
    Attack(
        # x' falls from 0.1 to -0.9, which the relation sees at once
        "relation_that_a_blow_turns",
        model(
            "coordinate Real x(der(start = 0.1)); state Real p, z; " + SPEED + "gravity = 0; mass 1 at {x + p, 0};",
            "der(p) = w; der(z) = if der(x) > -0.5 then 1 else 0;",
        ),
        2.0,
        {"z": 1.0, "x": 0.1 - 0.9},
        inputs={"w": STARTED},
    ),
]


@rows(JUMPS)
def test_jumps_of_speeds_are_blows(row: Attack, engine: str) -> None:
    check(row, engine)


def test_rows_of_the_motion_show_a_blow() -> None:
    """The state just before and just after it."""
    motion = lagdsl.compile(JUMPS[0].text).simulate(stop=2.0, inputs={"w": STARTED})
    at = np.flatnonzero(motion.time == 1.0)
    assert motion["der(x)"][at].tolist() == pytest.approx([0.0, -1.0])


def test_motions_in_threads_have_the_blow() -> None:
    text = model(
        "parameter Real c = 2; coordinate Real x; state Real p; gravity = 0; mass 1 at {x + p, 0}; potential c*x^2;"
        + SPEED,
        "der(p) = w;",
    )
    found = lagdsl.compile(text).simulate_many(parameters={"c": [0.5, 2.0]}, stop=2.0, inputs={"w": STARTED})
    ends = [float(row[-1]) for row in found["x"]]
    assert ends == pytest.approx([-sin(1), -sin(2) / 2], abs=1e-6)


READ = {
    "damper": "coordinate Real x; kinetic 1/2*der(x)^2; dissipation 1/2*(der(x) - der(w))^2;",
    "load": "coordinate Real x, p; kinetic 1/2*der(x)^2 + 1/2*der(p)^2; constraint d: der(p) = w; force der(w) on x;",
    "state": "coordinate Real p; state Real z; kinetic der(p)^2; constraint d: der(p) = w; equation der(z) = der(w);",
}


@pytest.mark.parametrize("name", READ)
def test_what_reads_the_derivative_of_a_jump_is_refused(name: str) -> None:
    """An impulse would be lost."""
    with pytest.raises(CompilationFailed) as failure:
        lagdsl.compile(f'model M annotation(units = "none"); {SPEED} {READ[name]} end M;').simulate(
            stop=2.0, inputs={"w": STARTED}
        )
    assert [diagnostic.code for diagnostic in failure.value.diagnostics] == ["E0847"]


# The input and the term of time change at 1.5, by one each.
BOTH = (0.0, 1.5, 1.5, 3.0)
TERM = "(if time < 1.5 then 1 else 0)"


@pytest.mark.parametrize(
    ("relation", "u", "count"),
    [
        (f"u + {TERM} > 1.5", (0, 0, 1, 1), 0),  # 1 before and behind
        (f"u*{TERM} > 0.5", (0, 0, 1, 1), 0),
        (f"u + {TERM} < 0.5", (0, 0, 1, 1), 0),
        (f"u + {TERM} < 0.5", (1, 1, 0, 0), 1),  # from 2 to 0
        (f"u - {TERM} > 0.5", (0, 0, 1, 1), 1),  # from -1 to 1
        ("u > 0.5", (0, 0, 1, 1), 1),
    ],
)
def test_inputs_jump_together_with_time(relation: str, u: tuple[float, ...], count: int) -> None:
    body = f"input Real u; coordinate Real x; discrete Real n; kinetic 1/2*der(x)^2; force {TERM} on x;"
    attacked = lagdsl.compile(model(body, f"when {relation} then n = pre(n) + 1; end when;"))
    motion = attacked.simulate(stop=3.0, inputs={"u": (BOTH, u)})
    assert motion["n"][-1] == count
    told = [(event.name, event.kind) for event in motion.events]
    assert told == [("time < 1.5", "false"), *[(relation, "true")] * count]
    assert motion["der(x)"][-1] == pytest.approx(1.5, abs=1e-12)
