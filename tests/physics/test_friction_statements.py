"""Loads that depend on what they cause, friction under a contact and a freewheel: closed forms."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl

G = 9.80665  # m/s2

GUIDED = """model Guided
  parameter Real mu = 0.25;
  coordinate Length x, y;
  gravity = 0;
  mass 2 kg at {x, y};
  constraint guide: y = 0;
  force {3 N, -4 N} at {x, y};
  force drag = -mu*multiplier(guide) on x;
  force -(1 kg)*der(der(x)) on x;
  output Force f = drag;
end Guided;
"""

SKIDDING = """model Skidding
  parameter Real mu = 0.3;
  coordinate Length s(der(start = 2 m/s)), h(start = 0.1 m);
  gravity = -g_n*world.y;
  mass 1 kg at {s, h};
  contact floor: h >= 0 with restitution = {e}, friction = mu, slip = der(s);
  output Boolean stuck = sticks(floor);
end Skidding;
"""

FREEWHEEL = """model Freewheel
  coordinate Angle a(der(start = 4 rad/s)), b(der(start = 1 rad/s));
  kinetic 1/2*(1 kg.m2)*der(a)^2 + 1/2*(2 kg.m2)*der(b)^2;
  torque -2 N.m on a;
  contact free: der(a) - der(b) >= 0;
  output Torque drives = multiplier(free);
end Freewheel;
"""


def test_drag_of_a_guide_and_added_mass() -> None:
    # (2 + 1) a = 3 - 0.25 * 4
    motion = lagdsl.compile(GUIDED, engine="tape").simulate(stop=1.0)
    assert motion["der(x)"][-1] == pytest.approx(2.0 / 3.0, rel=1e-12)
    np.testing.assert_allclose(motion["f"], -1.0, rtol=1e-12)


@pytest.mark.parametrize(("e", "error"), [(0.0, 1e-9), (0.2, 1e-6)])  # bounces shorter than a millionth are left out
def test_block_that_bounces_skids_as_long_as_one_that_slides(e: float, error: float) -> None:
    # from rest to rest of the height the impulse of the ground is m g t, so that the slip ends at v/(mu g)
    motion = lagdsl.compile(SKIDDING.replace("{e}", str(e)), engine="tape").simulate(stop=1.0)
    (event,) = [each for each in motion.events if each.name == "floor.friction"]
    assert event.kind == "sticks"
    assert event.time == pytest.approx(2.0 / (0.3 * G), rel=error)
    assert motion["stuck"][-1] == 1.0
    assert motion["der(s)"][-1] == pytest.approx(0.0, abs=1e-15)


def test_freewheel_engages_and_carries_along() -> None:
    # a runs down at 2 rad/s2 from 4 to 1 rad/s in 1.5 s; then both at 2/3 rad/s2: b keeps a up with 4/3 N.m
    motion = lagdsl.compile(FREEWHEEL, engine="tape").simulate(stop=3.0)
    (event,) = motion.events
    assert (event.name, event.kind) == ("free", "closed")
    assert event.time == pytest.approx(1.5, rel=1e-9)
    np.testing.assert_allclose([motion["der(a)"][-1], motion["der(b)"][-1]], [0.0, 0.0], atol=1e-9)
    assert motion["drives"][-1] == pytest.approx(4.0 / 3.0, rel=1e-9)
