"""Tracks with corners: one track, whatever function writes it, is one motion. References by the balance of energy."""

from __future__ import annotations

from math import sqrt

import pytest
from attack.rows import Attack, check, model, rows
from choice import spread

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
# after 2 s the corner is below the mass, which moves at 1/2 beside it, before and after
MOVED = {"x": 1.0 + (0.5 + 0.5 * sqrt(0.5)) * 2.0, "der(x)": 0.5 + 0.5 * sqrt(0.5)}
# down a slope of 45 degrees with x' = 1 + t/2
SLIDING = (
    "coordinate Real x(start = -1, der(start = 1)), y(start = 1, der(start = -1)); "
    "gravity = {0, -1, 0}; mass 1 at {x, y}; "
)
DOWN = 2 * sqrt(2) - 2
UP = 1 + DOWN / 2
# up the slope with x' = 2 - t/2 to the top, where it is sqrt(3)
OFF = 2 - (4 - 2 * sqrt(3))
JUMPS = {
    "floor": "floor(x)",
    "ceil": "ceil(x)",
    "mod": "mod(x, 1)",
    "wrap": "wrap(3*x)",
    "if": "(if x > 0.5 then 1 else 0)",
    "time": "(if time > 0.5 then 1 else 0)",
    "stairs": "floor(2*time)",
    "clause": "n",
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
    # the constraint does no work: the speed along the track is one, as on a track by a coordinate
    *(
        Attack(
            f"constraint_{name}",
            model(START + f"coordinate Real y; kinetic 1/2*(der(x)^2 + der(y)^2); constraint c: y = {track};"),
            3.0,
            {"x": sqrt(2), "y": sqrt(2), "der(x)": sqrt(0.5), "der(y)": sqrt(0.5)},
        )
        for name, track in RAMPS.items()
    ),
    *(
        Attack(
            f"{how}_of_a_saw",
            # slopes 1/2, -1, 1/2 with the speed sqrt(5/4) along: corners at 2 and at 3, where `mod` jumps
            model(text.format("min(mod(x, 3)/2, mod(-x, 3))")),
            4.0,
            {"x": 3 + (4 - 1.8 - sqrt(1.6)), "der(x)": 1.0},
        )
        for how, text in {
            "mass_on": "coordinate Real x(start = 0.2, der(start = 1)); gravity = 0; mass 1 at {{x, {}}};",
            "constraint": "coordinate Real x(start = 0.2, der(start = 1)), y(start = 0.1, der(start = 0.5)); "
            "kinetic 1/2*(der(x)^2 + der(y)^2); constraint c: y = {};",
            "rates": "coordinate Real x(start = 0.2, der(start = 1)), y(start = 0.1, der(start = 0.5)); "
            "kinetic 1/2*(der(x)^2 + der(y)^2); constraint c: der(y) = "
            "(if mod(x, 3) < 2 then 1/2 else -1)*der(x);",
        }.items()
    ),
    *(
        Attack(
            f"{how}_that_moves",
            # beside the corner, which moves at 1/2, the mass moves at 1/2 along the track
            model(START + text.format("(if x > time/2 then x - time/2 else 0)")),
            4.0,
            MOVED,
        )
        for how, text in {
            "mass_on": "gravity = 0; mass 1 at {{x, {}}};",
            "constraint": "coordinate Real y; kinetic 1/2*(der(x)^2 + der(y)^2); constraint c: y = {};",
        }.items()
    ),
    # a gap with a corner: down the left side, and thrown back along it by the right side with half of the speed
    *(
        Attack(
            f"valley_of_a_gap_{name}",
            model(SLIDING + f"contact c: {text};"),
            2.0,
            {"x": -(0.5 * UP * (2 - DOWN) - (2 - DOWN) ** 2 / 4), "der(x)": -(0.5 * UP - (2 - DOWN) / 2)},
        )
        for name, text in {
            "abs": "y - abs(x) >= 0 with restitution = 0.5",
            "if": "y - (if x > 0 then x else -x) >= 0 with restitution = 0.5",
            "two": "y - x >= 0 with restitution = 0.5; contact d: y + x >= 0 with restitution = 0.5",
        }.items()
    ),
    *(
        Attack(
            f"roof_of_a_gap_{name}",
            # up to the top, with 3 = 4 - 1 along x and y there, and free from there on
            model(
                "coordinate Real x(start = -1, der(start = 2)), y(start = -1, der(start = 2)); gravity = {0, -1, 0}; "
                f"mass 1 at {{x, y}}; contact c: y + {text} >= 0 with restitution = 0;"
            ),
            2.0,
            {"x": sqrt(3) * OFF, "y": sqrt(3) * OFF - OFF**2 / 2, "der(x)": sqrt(3)},
        )
        for name, text in {"abs": "abs(x)", "if": "(if x > 0 then x else -x)"}.items()
    ),
    Attack(
        # at the start it is on the stair below: 9 is 7 at once
        "stairs_of_energy_ceil",
        model("coordinate Real x(der(start = 3)); kinetic 1/2*der(x)^2; potential ceil(x - 1);"),
        2.0,
        {"der(x)": 1.0, "x": 3 + 2 - 1 / sqrt(7) - 1 / sqrt(5) - 1 / sqrt(3)},
    ),
    *(
        Attack(
            f"stairs_of_energy_{name}",
            # 9, 7, 5, 3, 1 are twice the kinetic energies
            model(f"coordinate Real x(der(start = 3)); kinetic 1/2*der(x)^2; potential {text};"),
            2.0,
            {"der(x)": 1.0, "x": 4 + 2 - 1 / 3 - 1 / sqrt(7) - 1 / sqrt(5) - 1 / sqrt(3)},
        )
        for name, text in {
            "floor": "floor(x)",
            "mod": "x - mod(x, 1)",
            "if": "(if x < 1 then 0 elseif x < 2 then 1 elseif x < 3 then 2 elseif x < 4 then 3 else 4)",
        }.items()
    ),
    *(
        Attack(
            f"step_on_a_moving_line_{name}",
            # beside the line, which moves at 2, the speed is 5: 25 - 3 = 22
            model(text),
            2.0,
            {"der(x)": sqrt(22) - 2, "x": 0.6 + 1.8 * (sqrt(22) - 2)},
        )
        for name, text in {
            "place": "coordinate Real x(der(start = 3)); kinetic 1/2*der(x)^2; "
            "potential if x + 2*time < 1 then 0 else 1.5;",
            "constraint": "coordinate Real x(der(start = 3)), y; kinetic 1/2*(der(x)^2 + der(y)^2); "
            "constraint c: y = 2*time; potential if x + y < 1 then 0 else 1.5;",
        }.items()
    ),
    Attack(
        "driven_over_a_step",
        model("coordinate Real x; kinetic 1/2*der(x)^2; constraint c: x = time; potential if x < 1 then 0 else 1.5;"),
        2.0,
        {"der(x)": 1.0, "x": 2.0},
    ),
    Attack(
        "angle_that_wraps",
        model("coordinate Real a(der(start = 2)); Real b = wrap(a); kinetic 1/2*der(b)^2;"),
        9.0,
        {"der(a)": 2.0, "a": 18.0},
    ),
    # the gap of stairs that lead down jumps up: the ball falls from each
    Attack(
        "stairs_down",
        model(
            "coordinate Real x(der(start = 1)), y(start = 1); gravity = {0, -8, 0}; mass 1 at {x, y}; "
            "contact c: y + floor(x) >= 1 with restitution = 0;"
        ),
        2.25,
        {"x": 2.25, "y": -0.25, "der(y)": -2.0},
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


@pytest.mark.parametrize("name", spread(JUMPS, 12))
@pytest.mark.parametrize(
    ("way", "code"),
    [
        ("gravity = 0; mass 1 at {{x, {}}};", "E0836"),
        ("gravity = 0; frame A = world.move({{x, {}, 0}}); body B(m = 1, Izz = 1) on A;", "E0836"),
        ("coordinate Real y; kinetic 1/2*(der(x)^2 + der(y)^2); constraint c: y = {};", "E0835"),
    ],
    ids=["mass", "body", "constraint"],
)
def test_positions_do_not_jump(way: str, code: str, name: str) -> None:
    start = "discrete Real n(start = 0); coordinate Real x(start = 0.1, der(start = 1)); "
    attacked = lagdsl.compile(model(start + way.format(JUMPS[name]), "when time > 0.5 then n = 1; end when;"))
    with pytest.raises(lagdsl.SimulationFailed) as failed:
        attacked.simulate(stop=3.0)
    assert failed.value.diagnostic.code == code


@pytest.mark.parametrize("y", [0.0, 0.5])
def test_a_gap_does_not_jump_into_the_ground(y: float) -> None:
    body = f"coordinate Real x(der(start = 1)), y(start = {y}); gravity = {{0, -1, 0}}; mass 1 at {{x, y}}; "
    attacked = lagdsl.compile(model(body + "contact c: y >= floor(x) with restitution = 0;"))
    with pytest.raises(lagdsl.SimulationFailed) as failed:
        attacked.simulate(stop=3.0)
    assert failed.value.diagnostic.code == "E0834"
    assert failed.value.diagnostic.labels


FALLING = "gravity = {0, -1, 0}; mass 1 at {x, y}; "


@pytest.mark.parametrize("tolerance", spread([1e-3, 1e-7, 1e-12], 2))
@pytest.mark.parametrize(
    ("text", "rest"),
    [
        # slides down with x' = 1 + t/2, and loses all at the other side, which is perpendicular
        (SLIDING + "contact c: y - abs(x) >= 0 with restitution = 0;", DOWN),
        (SLIDING + "contact c: y - (if x > 0 then x else -x) >= 0 with restitution = 0;", DOWN),
        (SLIDING + "contact c: y - table(x, {-9, 0, 9}, {9, 0, 9}) >= 0 with restitution = 0;", DOWN),
        # half of UP*sqrt(2) is left each time, decelerated by sqrt(1/2) along the side: 2*UP, UP, UP/2 ... to the next
        (SLIDING + "contact c: y - abs(x) >= 0 with restitution = 0.5;", DOWN + 4 * UP),
        # sides that rise by 1/2 turn by an angle whose cosine is 3/5; x' is multiplied by that, and decelerated by 2/5
        (
            "coordinate Real x(start = -1, der(start = 1)), y(start = 0.5, der(start = -0.5)); " + FALLING
            + "contact c: y - abs(x)/2 >= 0 with restitution = 0;",
            (sqrt(1.8) - 1) / 0.4 + 0.6 * sqrt(1.8) / 0.4 * 2 / 0.4,
        ),
        # at rest from the start on
        ("coordinate Real x, y; " + FALLING + "contact c: y - 2*abs(x) >= 0 with restitution = 0;", 0.0),
    ],
    ids=["abs", "if", "table", "bounces", "gentle", "start"],
)  # fmt: skip
def test_rest_in_a_valley_of_one_gap_is_told(text: str, rest: float, tolerance: float) -> None:
    attacked = lagdsl.compile(model(text))
    with pytest.raises(lagdsl.SimulationFailed) as failed:
        attacked.simulate(stop=20.0, tolerance=tolerance)
    diagnostic = failed.value.diagnostic
    assert diagnostic.code in ("E0804", "E0833") and "one contact for each side" in diagnostic.help.replace(
        "write ", ""
    )
    assert failed.value.time == pytest.approx(rest, abs=1e-4)
    assert diagnostic.labels


@pytest.mark.parametrize(
    ("start", "track", "force", "x"),
    [
        # at rest in the corner, and pulled up the right side
        ("coordinate Real x, y; ", "abs(x)", 2, 0.25 * 3**2),
        # down the left side with x'' = 0.9; 0.4 of x' is left along the right one, with x'' = 0.24
        (
            "coordinate Real x(start = -0.45), y(start = 0.45); ",
            "(if x > 0 then x/2 else -x)",
            0.8,
            0.36 * 2 + 0.12 * 2**2,
        ),
    ],
)
def test_a_mass_that_is_pulled_out_of_a_valley_goes_on(start: str, track: str, force: float, x: float) -> None:
    body = f"{start} force {force} on x; {FALLING} contact c: y - {track} >= 0 with restitution = 0;"
    motion = lagdsl.compile(model(body)).simulate(stop=3.0, tolerance=1e-10)
    assert motion["x"][-1] == pytest.approx(x, abs=1e-7)
