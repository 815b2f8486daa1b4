"""Contacts that touch at the start are closed from the start, whatever other parts of the model do there."""

from __future__ import annotations

import lagdsl

TEXT = """model SlidesBesideRest
  parameter Mass m = 1 kg;
  parameter Real mu = 0.5;
  coordinate Length x(der(start = 3 m/s)), y, h;
  gravity = -g_n*world.y;
  mass m at {x, y};
  mass m at {1 m, h};
  contact road: y >= 0 with restitution = 0, friction = mu, slip = der(x);
  contact table: h >= 0 with restitution = 0;
  annotation(experiment(StopTime = 1));
end SlidesBesideRest;
"""


def test_what_rests_beside_friction_that_slides_tells_nothing() -> None:
    """Motions with tangents have one instant for all; the others are islands."""
    model = lagdsl.compile(TEXT)
    for tangents in ((), ("m",)):
        motion = model.simulate(tangents=tangents)
        assert [(event.kind, event.name) for event in motion.events] == [("sticks", "road.friction")]
