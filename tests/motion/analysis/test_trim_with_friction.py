"""Equilibria that dry friction holds: inside its cone, with force, limit and margin, by closed forms."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from choice import repeats
from click.testing import CliRunner

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.interfaces.cli.main import lag
from lagdsl.motion.analysis.trim import Equilibrium

MODELS = Path(__file__).parents[3] / "models"
G = 9.80665


def test_a_block_on_a_slope() -> None:
    """It is held by m g sin, with mu m g cos at most."""
    found = lagdsl.compile(MODELS / "block_on_slope.lag").trim()
    (friction,) = found.frictions
    slope, mu = np.deg2rad(20.0), 0.5
    assert found.steadiness.kind == "equilibrium"
    assert (friction.name, friction.mode, friction.unit, friction.shared) == ("ground.friction", "sticks", "N", False)
    assert friction.force == pytest.approx([G * np.sin(slope)], rel=1e-13)
    assert friction.limit == pytest.approx(mu * G * np.cos(slope), rel=1e-13)
    assert friction.margin == pytest.approx(1.0 - np.tan(slope) / mu, rel=1e-12)


SMOOTH_WALL = """model Ladder
  parameter Angle lean = 60 deg;
  parameter Length l = 2 m;
  parameter Real mu = 0.4;
  coordinate Length x(start = l/2*cos(lean)), y(start = l/2*sin(lean));
  coordinate Angle phi(start = pi - lean);
  frame ladder = world.at({x, y, 0}).rotz(phi);
  point foot = ladder - l/2*ladder.x;
  point head = ladder + l/2*ladder.x;
  gravity = -g_n*world.y;
  body rod(m = 10 kg, Izz = 10 kg*l^2/12) on ladder;
  contact ground: foot.y >= 0 with restitution = 0, friction = mu, slip = der(foot.x);
  contact wall: head.x >= 0 with restitution = 0;
end Ladder;
"""


def test_a_ladder_at_a_smooth_wall() -> None:
    """The wall pushes by m g cot(lean)/2, which the floor bears up to mu m g."""
    found = lagdsl.compile(SMOOTH_WALL).trim()
    (friction,) = found.frictions
    push = 10.0 * G / (2.0 * np.tan(np.deg2rad(60.0)))
    assert friction.mode == "sticks"
    assert friction.force == pytest.approx([-push], rel=1e-12)
    assert friction.margin == pytest.approx(1.0 - push / (0.4 * 10.0 * G), rel=1e-12)
    assert found.point.q[2] == pytest.approx(np.pi - np.deg2rad(60.0), abs=1e-14)  # it stays where it stands


LIMIT = math.atan((1.0 - 0.4 * 0.3) / (2.0 * 0.4))  # of the ladder with friction at both ends


def leaning(lean: float) -> Equilibrium:
    text = (MODELS / "ladder_with_friction.lag").read_text().replace("lean = 45 deg", f"lean = {lean!r} rad")
    return lagdsl.compile(text).trim()


def test_a_ladder_with_friction_at_both_ends() -> None:
    """Four forces of three equations: they are shared, and some within the limits exist from LIMIT on."""
    steep = leaning(LIMIT + 1e-6)
    assert steep.point.q[2] == pytest.approx(np.pi - LIMIT - 1e-6, abs=1e-12)
    assert all(each.mode == "sticks" and each.shared for each in steep.frictions)
    assert all(0.0 < each.margin < 1e-4 for each in steep.frictions)
    # One that would slide has its nearest equilibrium where friction just holds it.
    slid = leaning(math.radians(45.0))
    assert slid.point.q[2] == pytest.approx(np.pi - LIMIT, abs=1e-9)
    assert [each.margin for each in slid.frictions] == pytest.approx([0.0, 0.0], abs=1e-9)


WEDGE = """model SelfLocking
  parameter Angle alpha = 20 deg;
  parameter Real mu = 0.5;
  coordinate Length X, Y;
  coordinate Length s, h;
  frame wedge = world.at({X, Y, 0});
  frame face = wedge.rotz(-alpha);
  gravity = -g_n*world.y;
  mass 3 kg at wedge;
  mass 1 kg at face.point({s, h, 0});
  contact floor: Y >= 0 with restitution = 0, friction = 0.1, slip = der(X);
  contact ramp: h >= 0 with restitution = 0, friction = mu, slip = der(s);
end SelfLocking;
"""


def test_a_wedge() -> None:
    """The block is held on the face; the floor has nothing to hold."""
    floor, ramp = lagdsl.compile(WEDGE).trim().frictions
    alpha = np.deg2rad(20.0)
    assert floor.size == pytest.approx(0.0, abs=1e-12)
    assert floor.limit == pytest.approx(0.1 * 4.0 * G, rel=1e-12)
    assert floor.margin == pytest.approx(1.0, abs=1e-12)
    assert ramp.margin == pytest.approx(1.0 - np.tan(alpha) / 0.5, rel=1e-12)


def test_a_wedge_that_slides_has_no_equilibrium_and_says_why() -> None:
    with pytest.raises(CompilationFailed) as raised:
        lagdsl.compile(MODELS / "wedge.lag").trim()
    force, limit = G * np.sin(np.deg2rad(40.0)), 0.15 * G * np.cos(np.deg2rad(40.0))
    assert f"`ramp.friction` would have to hold {force:.4g} N and bears {limit:.4g} N" in str(raised.value)


def test_legs_share_a_push_with_the_largest_least_reserve() -> None:
    """Four legs, a push of P along a diagonal at their height: what is left, mu m g - P, is the same for all."""
    text = (MODELS / "table_on_four_legs.lag").read_text()
    text = text.replace("der(start = 1.2 m/s)", "").replace("x(), y(der(start = -0.5 m/s))", "x, y")
    text = text.replace("  point foot[4];", "  force {6 N, 8 N, 0} at table.point({0, 0, -h});\n  point foot[4];")
    found = lagdsl.compile(text).trim()
    assert all(each.mode == "sticks" and each.shared for each in found.frictions)
    reserves = [each.limit - each.size for each in found.frictions]
    assert reserves == pytest.approx([(0.3 * 12.0 * G - 10.0) / 4.0] * 4, rel=1e-6)
    total = np.sum([each.force for each in found.frictions], axis=0)
    assert total == pytest.approx([-6.0, -8.0], abs=1e-9)


PULLED = """model Pulled
  parameter Stiffness k = 20 N/m;
  coordinate Length a(start = 0.3 m), b(start = 0.4 m);
  kinetic 1/2*(1 kg)*der(a)^2 + 1/2*(1 kg)*der(b)^2;
  potential 1/2*k*(b - a)^2;
  force 6 N on b;
  friction floor: der(a) with limit = 8 N;
end Pulled;
"""


def test_what_friction_holds_stays_in_its_place() -> None:
    """Only b moves, to where the spring balances the force; a stays, though any place of both would do."""
    found = lagdsl.compile(PULLED).trim()
    assert found.point.q == pytest.approx([0.3, 0.3 + 6.0 / 20.0], abs=1e-12)
    assert found.frictions[0].margin == pytest.approx(1.0 - 6.0 / 8.0, rel=1e-12)


def test_the_limit_at_rest_holds_what_has_stopped() -> None:
    """A spring pulls a mass to where sliding friction balances it; there it would bear half as much again."""
    text = """model Oscillator
      coordinate Length x(start = 3.3 m);
      kinetic 1/2*(1 kg)*der(x)^2;
      potential 1/2*(4 N/m)*x^2;
      friction floor: der(x) with limit = 1 N, sticking = 1.5 N;
    end Oscillator;
    """
    found = lagdsl.compile(text).trim()
    assert found.point.q == pytest.approx([0.25], abs=1e-12)
    assert (found.frictions[0].mode, found.frictions[0].limit) == ("sticks", 1.5)
    assert found.frictions[0].margin == pytest.approx(1.0 / 3.0, rel=1e-12)


def test_friction_on_a_belt_slides_at_an_equilibrium() -> None:
    found = lagdsl.compile(MODELS / "stick_slip_belt.lag").trim()
    assert found.point.q == pytest.approx([0.5], abs=1e-12)
    assert (found.frictions[0].mode, found.frictions[0].margin) == ("slides", 0.0)


@repeats("test_a_wedge_that_slides_has_no_equilibrium_and_says_why")
def test_a_body_that_would_roll_has_no_equilibrium() -> None:
    """Rates of rounding errors gave friction a sense, and with it any force."""
    text = """model Rolling
      coordinate Length x, y(start = 0.1 m), z;
      coordinate Angle a, b;
      frame road = world.rotz(-25 deg);
      gravity = -g_n*world.y;
      mass 1 kg at road.point({x, y, z});
      kinetic 1/2*(0.004 kg.m2)*(der(a)^2 + der(b)^2);
      contact touch: y >= 0.1 m
          with restitution = 0, friction = 0.2, slip = {der(x) + 0.1 m*der(a), der(z) + 0.1 m*der(b)};
    end Rolling;
    """
    with pytest.raises(CompilationFailed, match="E0852"):
        lagdsl.compile(text).trim()


def test_the_command_tells_forces_limits_and_margins(tmp_path: Path) -> None:
    done = CliRunner().invoke(lag, ["trim", str(MODELS / "block_on_slope.lag")])
    assert done.exit_code == 0, done.output
    assert done.output.splitlines()[-1].split() == ["ground.friction", "sticks", "3.35407", "4.60762", "N", "0.27206"]
    target = tmp_path / "found.json"
    CliRunner().invoke(lag, ["trim", str(MODELS / "block_on_slope.lag"), "-o", str(target)])
    told = json.loads(target.read_text())
    assert (told["frictions"], told["modes"], told["shared"]) == (["ground.friction"], ["sticks"], [False])
    assert told["margins"] == pytest.approx([1.0 - told["forces"][0] / told["limits"][0]])


def test_what_friction_holds_is_linearized_where_it_stands() -> None:
    """The wedge is held by two faces whose rows depend on each other; opening one lets the load fall."""
    found = lagdsl.compile(MODELS / "wedge_under_load.lag").linearize()
    assert [each.name for each in found.states] == ["x"]
    np.testing.assert_array_equal(found.A, [[0.0]])


def test_modes_on_a_base_that_friction_holds() -> None:
    """A mass on a spring on a block that sticks to the floor: sqrt(k/m), not that of two masses."""
    text = """model Held
      parameter Stiffness k = 40 N/m;
      coordinate Length x, y, b(start = 0.1 m);
      gravity = -g_n*world.y;
      mass 3 kg at {x, y};
      mass 0.4 kg at {x + b, y};
      potential 1/2*k*(b - 0.1 m)^2;
      contact floor: y >= 0 with restitution = 0, friction = 0.5, slip = der(x);
    end Held;
    """
    found = lagdsl.compile(text).modes(trim=True).frequencies
    assert found[found > 0.0] == pytest.approx([10.0 / (2.0 * math.pi)] * np.sum(found > 0.0), rel=1e-9)
    assert np.any(found > 0.0)
