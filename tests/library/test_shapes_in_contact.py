"""Contacts of balls, boxes and wheels: rolling, sliding, blows with friction, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from choice import chosen
from models.corpus import path_of
from models.references import REFERENCES
from models.references.integrate import G_N, Floats, solve

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName

NAMES = [
    "ball_on_an_incline",
    "balls_in_contact",
    "boxes_in_contact",
    "cylinder_on_an_incline",
    "wheels_in_contact",
]


@pytest.mark.parametrize("engine", chosen(["tape", "c", "numpy"], ["tape"]))
@pytest.mark.parametrize("name", NAMES)
def test_bodies_roll_slide_and_strike_as_derived(name: str, engine: EngineName) -> None:
    model = lagdsl.compile(path_of(f"library/{name}"), engine=engine)
    motion = model.simulate(tolerance=1e-10)
    p = dict(zip(model.parameters, model.defaults, strict=True))
    for column, expected in REFERENCES[name](p, motion.time).items():
        size = max(1e-3, np.max(np.abs(expected)))
        np.testing.assert_allclose(motion[column], expected, rtol=0, atol=1e-9 * size, err_msg=column)


def test_a_ball_without_enough_friction_slides() -> None:
    model = lagdsl.compile(path_of("library/ball_on_an_incline"), engine="tape")
    motion = model.simulate(parameters={"mu": 0.1}, tolerance=1e-10)
    p = dict(zip(model.parameters, model.defaults, strict=True)) | {"mu": 0.1}
    for column, expected in REFERENCES["ball_on_an_incline"](p, motion.time).items():
        np.testing.assert_allclose(motion[column], expected, rtol=0, atol=1e-9, err_msg=column)


DROPPED = """model Dropped
  import Lag.Planar.*;
  FreeMotion free(y(start = 0.5 m), x(der(start = 2 m/s)), q(der(start = {spin} rad/s)));
  Disc wheel(R = 0.1 m, m = 1 kg);
  DiscOnLine road(R = 0.1 m, e = 0.6, mu = 0.1);
  gravity = -g_n*world.y;
  connect(world, free, wheel);
  connect(free.frame_b, road.frame_a);
end Dropped;
"""


@pytest.mark.parametrize("spin", [0.0, -16.0])
def test_a_wheel_that_is_dropped_is_braked_by_its_bounce(spin: float) -> None:
    """The impulse (1 + e) m v rubs mu times that, or as much as ends the slip."""
    motion = lagdsl.compile(DROPPED.format(spin=spin), engine="tape").simulate(stop=0.4, tolerance=1e-11)
    approach = np.sqrt(2 * G_N * 0.4)
    slip = 2.0 + 0.1 * spin
    rub = min(0.1 * 1.6 * approach, slip / 3)
    assert (rub == slip / 3) == (spin != 0.0)
    assert motion["der(free.x)"][-1] == pytest.approx(2.0 - rub, rel=1e-10)
    assert motion["der(free.q)"][-1] == pytest.approx(spin - rub * 0.1 / 0.005, rel=1e-10)
    assert motion["der(free.y)"][-1] == pytest.approx(0.6 * approach - G_N * (0.4 - approach / G_N), rel=1e-9)


TILTED = """model Tilted
  import Lag.Planar.*;
  frame slope = world.rotz({angle} deg);
  FreeMotion stands(y(start = 0.2 m));
  Body box(m = 3 kg, Izz = 0.1 kg.m2);
  BoxOnLine ground(length = 0.2 m, height = 0.4 m, mu = {mu}, road = slope);
  gravity = -g_n*world.y;
  connect(slope, stands, box);
  connect(stands.frame_b, ground.frame_a);
end Tilted;
"""


@pytest.mark.parametrize(("angle", "mu", "what"), [(20, 0.5, "stays"), (30, 0.7, "tips"), (20, 0.3, "slides")])
def test_a_box_on_a_slope_stays_slides_or_tips(angle: float, mu: float, what: str) -> None:
    """It slides where tan(slope) > mu, and tips where length/height < tan(slope), 26.6 deg, and mu holds it."""
    motion = lagdsl.compile(TILTED.format(angle=angle, mu=mu), engine="tape").simulate(stop=0.2, tolerance=1e-10)
    slope = np.radians(angle)
    moved, turned = motion["stands.x"][-1], motion["stands.q"][-1]
    match what:
        case "stays":
            assert abs(moved) <= 1e-12 and abs(turned) <= 1e-12
        case "slides":
            share = np.sin(slope) - mu * np.cos(slope)
            assert moved == pytest.approx(-G_N * share * 0.2**2 / 2, rel=1e-9)
            assert abs(turned) <= 1e-12
        case _:

            def rates(_: float, x: Floats) -> list[float]:
                """About the lower corner: I + m (l^2 + h^2)/4 and the weight."""
                lever = 0.2 * np.sin(slope + x[0]) - 0.1 * np.cos(slope + x[0])
                return [x[1], 3 * G_N * lever / (0.1 + 3 * (0.1**2 + 0.2**2))]

            assert turned == pytest.approx(solve(rates, [0.0, 0.0], motion.time)[0, -1], rel=1e-8)


def test_a_box_rests_on_four_corners_and_on_none() -> None:
    """Eight contacts; the four below share the weight."""
    text = """model Cube
  import Lag.Spatial.*;
  FreeQuaternion free(r(start = {0, 0.1 m, 0}));
  Body cube(m = 4 kg, I = {1, 1, 1});
  BoxOnPlane ground(length = 0.4 m, height = 0.2 m, width = 0.3 m, mu = 0.5);
  gravity = -g_n*world.y;
  connect(world, free, cube);
  connect(free.frame_b, ground.frame_a);
  output Force N[8] = {multiplier(ground.corner[i].touch) for i in 1:8};
end Cube;
"""
    motion = lagdsl.compile(text, engine="tape").simulate(stop=5.0)
    loads = np.array([motion[f"N[{i}]"][-1] for i in range(1, 9)])
    np.testing.assert_allclose(loads, [4 * G_N / 4] * 4 + [0.0] * 4, rtol=1e-9, atol=1e-12)
    for column in ("free.r[1]", "free.r[3]", "free.e[2]"):
        assert np.max(np.abs(motion[column])) <= 1e-12
