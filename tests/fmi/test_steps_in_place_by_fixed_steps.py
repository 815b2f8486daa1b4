"""Steps of energy in place under `solver.step`: the motion has passed the place when a step of fixed length ends."""

from __future__ import annotations

from math import sqrt

import pytest

from fmi.importing import slave
from fmi.texts import exported_text

# Crosses with the energy that is left, or is thrown back where the energy does not suffice.
TEXT = """model PlaceOfAStep
  parameter Real speed = 0.9, push = 0;
  coordinate Real x(der(start = speed));
  kinetic 1/2*der(x)^2;
  potential if x < 0.3 then 0 else 0.5;
  force push on x;
  output Real v = der(x);
  annotation(units = "none", experiment(StopTime = 1));
end PlaceOfAStep;
"""
ACROSS = sqrt(1.2**2 - 2 * 0.5)
# From 0 at 0.5 under 1 it comes to 0.3 with sqrt(0.85) after 0.42195, and goes back with that.
BACK = sqrt(0.85)
LEFT = 1 - (BACK - 0.5)


@pytest.mark.parametrize("step", [1e-3, 3e-3, 0.01])
@pytest.mark.parametrize(
    ("speed", "push", "x", "v"),
    [
        (0.9, 0.0, -0.3, -0.9),
        (1.2, 0.0, 0.3 + (1 - 0.25) * ACROSS, ACROSS),
        (0.5, 1.0, 0.3 - BACK * LEFT + LEFT**2 / 2, -BACK + LEFT),
    ],
)
def test_fixed_steps_keep_the_energy_at_a_step_in_place(
    step: float, speed: float, push: float, x: float, v: float
) -> None:
    fmu = exported_text(TEXT, 2)
    with slave(fmu) as one:
        one.initialize({"speed": speed, "push": push, "solver.step": step}, stop=1.0)
        for k in range(10):
            one.step(k / 10, 0.1)
        found = one.get("x", "v")
    assert found == pytest.approx([x, v], abs=3 * step)
