"""The oracle of contacts and dry friction against closed forms: what judges others is judged first."""

from __future__ import annotations

import numpy as np
import pytest
from choice import ALL, chosen
from compiled_programs import program_of
from models.corpus import compiled
from models.references import REFERENCES
from stepping.friction_instant import JammedError
from stepping.friction_modes import (
    CLOSED,
    MINUS,
    OPEN,
    PLUS,
    STICK,
    AmbiguousError,
    Friction,
    Problem,
    reserve,
    solutions,
)
from stepping.friction_motion import FrictionMotion, friction_motion

GRAVITY = 9.81


def moved(body: str, stop: float) -> FrictionMotion:
    return friction_motion(program_of(f'model Judge\n{body}\nannotation(units = "none");\nend Judge;\n'), stop, [stop])


def told(motion: FrictionMotion) -> list[tuple[str, str]]:
    return [(each.name, each.kind) for each in motion.told]


EVERY = [
    *(
        "block_on_slope",
        "sliding_cube",
        "coulomb_oscillator",
        "stick_slip_belt",
        "flywheel_brake",
        "disc_starts_to_roll",
    ),
    *(
        "billiard_ball_with_draw",
        "wedge",
        "wedge_under_load",
        "stacked_blocks",
        "pinched_capsule",
        "gripper",
        "drum_brake",
    ),
    *("worm_gear", "freewheel", "ladder_with_friction", "painleve_rod", "tipping_box", "rocking_block"),
]


@pytest.mark.parametrize("name", chosen(EVERY, ["disc_starts_to_roll", "painleve_rod"]))
def test_models_with_scalar_friction_move_as_derived_by_hand(name: str) -> None:
    program, stop = compiled(name).graph, compiled(name).flat.experiment.stop_time
    found = friction_motion(program, stop, np.linspace(0, stop, 20)[1:].tolist())
    names = [each.name for each in program.layout.coordinates]
    parameters = dict(zip([each.name for each in program.layout.parameters], program.layout.defaults, strict=True))
    expected = REFERENCES[name](parameters, np.array([0.0, *found.times]))
    for place, coordinate in enumerate(names):
        if coordinate in expected:
            exact = expected[coordinate][1:]
            error = np.abs(np.array([s.q[place] for s in found.states]) - exact)
            assert np.max(error) <= 1e-9 * max(1e-3, float(np.max(np.abs(exact)))), coordinate


def test_what_slips_at_the_limit_of_rest_slides_with_the_lower_one() -> None:
    """A ramp of 1 N/s on 1 kg, 1.5 N at rest, 1 N sliding: x'' = t - 1 from t = 1.5."""
    motion = moved(
        "coordinate Real x; kinetic 1/2*der(x)^2; force time on x; friction f: der(x) with limit = 1, sticking = 1.5;",
        3.0,
    )
    assert told(motion) == [("f", "slips")]
    assert motion.told[0].time == pytest.approx(1.5, abs=1e-12)
    np.testing.assert_allclose(motion.states[-1].x, [1.5**2 / 4 + 1.5**3 / 6, 1.5 / 2 + 1.5**2 / 2], rtol=1e-11)


def test_a_bounce_with_friction() -> None:
    """e = 0.7, mu = 0.2 from 1 m at 3 m/s: mu (1 + e) u along, less than what rolls."""
    r, fall = 0.03, np.sqrt(2 * GRAVITY)
    motion = moved(
        "coordinate Real x(der(start = 20)), y(start = 1), a; kinetic 1/2*(der(x)^2 + der(y)^2) + 1/5*0.03^2*der(a)^2;"
        "potential 9.81*y; contact c: y >= 0 with restitution = 0.7, friction = 0.2, slip = der(x) + 0.03*der(a);",
        0.6,
    )
    along = 0.2 * 1.7 * fall
    x, _, a = motion.states[-1].v
    assert told(motion) == [("c", "impact")]
    np.testing.assert_allclose([x, a], [20 - along, -along / (0.4 * r)], rtol=1e-11)


def test_bounces_end_in_rolling() -> None:
    """It keeps 5/7 of its speed: friction moves along the table, about which the angular momentum stays."""
    motion = moved(
        "coordinate Real x(der(start = 2)), y(start = 0.2), a; kinetic 1/2*(der(x)^2 + der(y)^2) + 1/5*0.03^2*der(a)^2;"
        "potential 9.81*y; contact c: y >= 0 with restitution = 0.3, friction = 0.4, slip = der(x) + 0.03*der(a);",
        2.0,
    )
    np.testing.assert_allclose(motion.states[-1].v, [10 / 7, 0, -10 / 7 / 0.03], atol=1e-9)
    assert ("c", "closed") in told(motion)


def test_a_wheel_that_is_overtaken_is_taken_along() -> None:
    """der(b) >= der(a) from equal rates: 3 N m on a moves both inertias, 1 and 2."""
    motion = moved(
        "coordinate Real a, b; kinetic 1/2*der(a)^2 + der(b)^2; force 3 on a; contact c: der(b) - der(a) >= 0;", 2.0
    )
    np.testing.assert_allclose(motion.states[-1].x, [2, 2, 2, 2], rtol=1e-12)


@pytest.mark.skipif(not ALL, reason="a motion into a singular point")
def test_painleves_rod_is_jammed_at_its_angle() -> None:
    with pytest.raises(JammedError) as found:
        friction_motion(compiled("painleve_rod").graph, 0.4, [0.4])
    assert found.value.time == pytest.approx(0.286987, abs=1e-5)


def test_a_rod_that_is_pushed_at_a_jamming_angle_has_no_motion() -> None:
    """G = 1 + 3 cos(cos - mu sin) < 0 with friction towards the tip, as it slides."""
    with pytest.raises(AmbiguousError, match="0 solutions"):
        moved(
            "coordinate Real x(der(start = -1)), y(start = 0.7833269096), a(start = 0.9);"
            "kinetic 1/2*(der(x)^2 + der(y)^2) + 1/6*der(a)^2; potential 9.81*y;"
            "contact c: y - sin(a) >= sin(0.9) - sin(0.9) with restitution = 0, friction = 1.6,"
            " slip = der(x) + sin(a)*der(a);",
            0.1,
        )


# ---- one problem -----------------------------------------------------------------------------------------------------


def test_modes_of_a_block() -> None:
    """On a floor with g = 10, mu = 0.3: pulled by 2 N it sticks, by 4 N it slides, lifted it flies."""
    law = (Friction(1, 0, 0.3),)
    modes = {
        (-10.0, 2.0): (CLOSED, STICK),
        (-10.0, 4.0): (CLOSED, PLUS),
        (-10.0, -4.0): (CLOSED, MINUS),
        (1.0, 4.0): (OPEN, 5),
    }
    for c, mode in modes.items():
        (found,) = solutions(Problem(np.eye(2), np.array(c), (0,), law))
        assert found.mode == mode


def test_more_than_one_motion_is_found() -> None:
    """A tip that friction presses down may slide off, or jam: G_nn - mu G_nt < 0."""
    problem = Problem(np.array([[1.0, 0.9], [0.9, 1.0]]), np.array([0.1, -0.02]), (0,), (Friction(1, 0, 1.5),))
    assert len(solutions(problem)) > 1


def test_forces_that_the_motion_does_not_determine() -> None:
    """Two legs share 10 N at mu = 0.5 with a pull of 4 N: 1 N to spare in all, a half of it each at best."""
    J = np.array([[1.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 1.0]])
    problem = Problem(J @ J.T, J @ np.array([-10.0, 4.0]), (0, 1), (Friction(2, 0, 0.5), Friction(3, 1, 0.5)))
    (found,) = solutions(problem)
    assert found.mode == (CLOSED, CLOSED, STICK, STICK)
    spare, f = reserve(problem, found.mode)
    assert spare == pytest.approx(0.5)
    assert f[2] + f[3] == pytest.approx(-4.0)
