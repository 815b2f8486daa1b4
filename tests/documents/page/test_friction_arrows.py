"""Arrows of dry friction: where they are, how large, and the mode that the legend tells."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from named_models import compiled
from page.pages import MODELS

from lagdsl.derivation.scene.rubbing import Rubbing
from lagdsl.derivation.scene.shapes import Shape
from lagdsl.derivation.scene.vectors import with_vectors
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.motion.pipeline import compile_flat
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.simulate import simulate

OPEN, SLIDES, STICKS = 0.0, 1.0, 2.0
G = 9.80665


@record()
class Rubbed:
    """A friction, and its numbers along the motion by role."""

    shape: Shape
    numbers: dict[str, Floats]


@cache
def moved(source: str | Path) -> tuple[Trajectory, tuple[Rubbed, ...]]:
    pointed = with_vectors(compiled(source).flat)
    made = compile_flat(pointed.flat, Sink())
    assert made is not None
    motion, scene = simulate(engine_of(made.program, "tape"), made.flat, interval=0.01), pointed.scene
    rows = np.stack([motion[f"scene[{k + 1}]"] for k in range(len(scene.columns))], axis=-1)
    shapes = (shape for shape in scene.shapes if shape.kind == "friction")
    return motion, tuple(
        Rubbed(each, {role: scene.values(rows, value) for role, value in each.numbers.items()}) for each in shapes
    )


def test_the_force_on_a_block_that_slides_and_sticks() -> None:
    """Up the slope it slides until v0/(g (sin + mu cos)), then it is held by m g sin."""
    motion, (arrow,) = moved(MODELS / "block_on_slope.lag")
    angle, mu, stops = np.deg2rad(20.0), 0.5, 2.0 / (G * (np.sin(np.deg2rad(20.0)) + 0.5 * np.cos(np.deg2rad(20.0))))
    before, behind = motion.time < stops - 1e-6, motion.time > stops + 1e-6
    up = np.array([np.cos(angle), np.sin(angle), 0.0])
    force = arrow.numbers["vector"]
    assert force[before] == pytest.approx(np.tile(-mu * G * np.cos(angle) * up, (before.sum(), 1)), abs=1e-9)
    assert force[behind] == pytest.approx(np.tile(G * np.sin(angle) * up, (behind.sum(), 1)), abs=1e-9)
    mode = arrow.numbers["mode"]
    assert set(mode[before]) == {SLIDES}
    assert set(mode[behind]) == {STICKS}
    at = arrow.numbers["at"]
    assert at == pytest.approx(motion["s"][:, None] * up, abs=1e-9)


def test_a_clutch_has_a_value_and_no_arrow() -> None:
    _, (shape,) = moved(MODELS / "clutch.lag")
    assert "vector" not in shape.numbers
    assert shape.shape.texts["unit"] == "N.m"
    sticks = shape.numbers["mode"] == STICKS
    assert np.abs(shape.numbers["value"])[~sticks] == pytest.approx(40.0)
    assert shape.numbers["value"][-1] == pytest.approx(-18.0)  # drive less J1 times the common acceleration


def test_friction_under_an_open_contact_is_open() -> None:
    motion, shapes = moved(MODELS / "ladder_with_friction.lag")
    wall = next(shape for shape in shapes if shape.shape.name == "wall.friction")
    left = motion.events[-1]
    assert (left.name, left.kind) == ("wall", "opened")
    away = motion.time > left.time + 1e-6
    assert set(wall.numbers["mode"][away]) == {OPEN}
    assert not wall.numbers["vector"][away].any()


def places_of(source: str | Path, name: str) -> list[tuple[object, ...]]:
    flat = compiled(source).flat
    (friction,) = [each for each in flat.events.frictions if each.name == name]
    return [(place.at, *place.directions) for place in Rubbing(flat).places(friction)]


def test_places() -> None:
    along = fx.Vector(fx.ONE, fx.ZERO, fx.ZERO)
    assert places_of(MODELS / "ladder_with_friction.lag", "ground.friction") == [(fx.PointReference("foot"), along)]
    # The foot of a disc that rolls is the lowest point of its rim.
    ((rim, sense),) = places_of(MODELS / "disc_starts_to_roll.lag", "road.friction")
    assert rim != fx.FrameOrigin("disc")
    assert sense == along
    # Two bodies that rub on each other: the frame of the face gives the direction, wherever its angle is.
    one, other = places_of(MODELS / "wedge.lag", "ramp.friction")
    assert one[0] == fx.PointReference("P")
    assert other == (fx.FrameOrigin("wedge"), fx.Unary("-", one[1]))
    # A plane has two directions.
    assert len(places_of(MODELS / "puck_with_side_force.lag", "ice")[0]) == 3


LEVER = """model Lever
  parameter Length r = 0.1 m;
  coordinate Angle phi(der(start = 1 rad/s));
  point P = {0.5 m*cos(phi), 0.5 m*sin(phi)};
  mass 1 kg at P;
  friction pin: r*der(phi) with limit = 1 N;
end Lever;
"""


def test_a_slip_of_no_point_has_no_place() -> None:
    """The point moves in proportion to the slip, but not as fast: the force on it is another one."""
    assert places_of(LEVER, "pin") == []


TURNED = """model Turned
  parameter Angle a = 30 deg;
  coordinate Length x(der(start = 1 m/s)), y;
  mass 1 kg at {x, y};
  friction face: der(x)*cos(a) + der(y)*sin(a) with limit = 1 N;
end Turned;
"""


def test_a_direction_that_follows_a_parameter_is_not_taken_for_a_fixed_one() -> None:
    assert places_of(TURNED, "face") == []
