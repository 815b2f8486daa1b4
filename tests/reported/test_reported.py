"""Faults that users reported, each as the smallest input that shows it, with the value that is right.

The value is a closed form or follows from another formulation, never from our own output. A section holds one report;
texts that are longer than a screen, and files of other tools, lie in `texts` beside this file.
"""

from __future__ import annotations

from math import asin, sqrt

import numpy as np
import pytest

import lagdsl

# ---- bounces: a contact that is located as closing strikes -------------------------------------------------------------

BOB = """
model Bob "A bob on a rod strikes a floor: its height is no coordinate that a projection leaves alone"
  coordinate Length x(start = 0.8 m), y(start = 0.6 m);
  gravity = -9.81 m/s2*world.y;
  mass 1 kg at {x, y};
  constraint rod: x^2 + y^2 = 1 m2;
  contact floor: y >= 0.1 m with restitution = 0.6;
  annotation(experiment(StopTime = 1));
end Bob;
"""


def test_a_bounce_is_not_lost() -> None:
    """The first blow at sqrt(2 g (y0 - 0.1)) sqrt(1 - 0.1^2), and 0.6 times that behind it, from sixty starts."""
    model = lagdsl.compile(BOB, engine="tape")
    for x in np.linspace(0.5, 0.95, 60):
        y = sqrt(1 - x**2)
        motion = model.simulate(start={"x": x, "y": y})
        row = int(np.searchsorted(motion.time, motion.events[0].time))
        speed = sqrt(2 * 9.81 * (y - 0.1)) * sqrt(0.99)
        assert motion.events[0].kind == "impact"
        assert motion["der(y)"][row : row + 2] == pytest.approx([-speed, 0.6 * speed], rel=1e-6)


# ---- fixed steps after bounces -----------------------------------------------------------------------------------------

ARM = """
model Arm "A pendulum bounces on a stop until it rests"
  coordinate Angle a(start = 0.6);
  gravity = -9.80665 m/s2*world.y;
  mass 1 kg at {cos(a), sin(a)}*(1 m);
  contact floor: (1 m)*sin(a) >= 0.1 m with restitution = 0.6;
  annotation(experiment(StopTime = 1.5));
end Arm;
"""


@pytest.mark.parametrize("solver", ["ros2", "rk4", "leapfrog"])
def test_bounces_end_with_steps_of_fixed_length(solver: str) -> None:
    model = lagdsl.compile(ARM, engine="tape")
    for step in (0.002, 0.005, 0.01, 0.02, 0.03):
        motion = model.simulate(solver=solver, step=step)
        assert motion.events[-1].kind == "closed"
        assert motion["a"][-1] == pytest.approx(asin(0.1), abs=1e-9)
        assert motion["der(a)"][-1] == pytest.approx(0.0, abs=1e-9)


# ---- angles of cut joints: whole turns ---------------------------------------------------------------------------------

# ---- a ball joint that closes a loop half a turn from its start --------------------------------------------------------

# ---- starts: guesses choose branches, explicit values hold -------------------------------------------------------------

# ---- names of connected variables --------------------------------------------------------------------------------------

# ---- models in which nothing is free to move ---------------------------------------------------------------------------

# ---- certificates of statics -------------------------------------------------------------------------------------------

# ---- linearization of circuits, verdicts on sampled loops --------------------------------------------------------------

# ---- lowest and highest of outputs -------------------------------------------------------------------------------------

# ---- derivations: stability and equilibria -----------------------------------------------------------------------------

# ---- derivations: names and letters ------------------------------------------------------------------------------------

# ---- derivations: what is printed is short -----------------------------------------------------------------------------

# ---- pictures: springs and bars ----------------------------------------------------------------------------------------

# ---- robots: URDF ------------------------------------------------------------------------------------------------------

# ---- robots: MJCF ------------------------------------------------------------------------------------------------------
