"""Bodies that only a relation ties move as they do alone: blows, modes and reserves are those of what rows tie."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl

BODIES = """
model Bodies
  structural parameter Integer N = 3;
  coordinate Length h[N](start = {(1 + 0.1*i)*(1 cm) for i in 1:N}), x[N], y[N];
  discrete Integer n(start = 0);
  gravity = -g_n*world.y;
  for i in 1:N loop
    mass 1 kg at {0, h[i], 0};
    contact bounces: h[i] >= 0 with restitution = 0.2 + 0.1*i;
    mass 2 kg at {x[i], y[i], 0};
    contact floor: y[i] >= 0 with restitution = 0, friction = 0.3, slip = der(x[i]);
    force (3 + i)*(2 N)*sin(time*(3 rad/s)) on x[i];
  end for;
  annotation(experiment(StopTime = 1));
equation
  RELATION
end Bodies;
"""
RELATIONS = [f"when {read} then\n    n = 1;\n  end when;" for read in ("sum(h) + sum(x) > 1 km", "time > 1 h")]


def test_a_relation_changes_no_motion_that_it_reads() -> None:
    tied, alone = (lagdsl.compile(BODIES.replace("RELATION", text), engine="tape").simulate() for text in RELATIONS)
    for name in ("h[1]", "h[3]", "x[1]", "x[2]", "x[3]"):
        assert tied[name][-1] == pytest.approx(alone[name][-1], rel=1e-9, abs=1e-12)
    kinds = ("impact", "slips")
    times = [sorted(event.time for event in found.events if event.kind in kinds) for found in (tied, alone)]
    assert len(times[0]) > 10
    assert np.allclose(*times, rtol=0.0, atol=1e-8)
