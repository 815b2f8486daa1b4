"""Faults that users reported, each as the smallest input that shows it, with the value that is right.

The value is a closed form or follows from another formulation, never from our own output. A section holds one report; texts
that are longer than a screen, and files of other tools, lie in `texts` beside this file.
"""

from __future__ import annotations

import numpy as np
import pytest
from choice import engines

import lagdsl
from lagdsl.runtime.engines.engine import EngineName

# ---- bounces: a contact that is located as closing strikes -------------------------------------------------------------

# ---- fixed steps after bounces -----------------------------------------------------------------------------------------

# ---- angles of cut joints: whole turns ---------------------------------------------------------------------------------

# ---- a ball joint that closes a loop half a turn from its start --------------------------------------------------------

# ---- starts: guesses choose branches, explicit values hold -------------------------------------------------------------

# ---- names of connected variables --------------------------------------------------------------------------------------

# ---- models in which nothing is free to move ---------------------------------------------------------------------------

# ---- certificates of statics -------------------------------------------------------------------------------------------


def test_a_mechanism_that_cannot_move_has_a_certificate() -> None:
    """A shelf on two consoles, one row too many: it stays where it is, and no momentum is called one of symmetry."""
    text = """
    model Shelf
      coordinate Length x, y(start = 1.2 m);
      coordinate Angle q;
      frame board = world.at({x, y, 0}).rotz(q);
      body b(m = 4 kg, com = {0.05 m, 0}, Izz = 0.3 kg.m2) on board;
      gravity = -g_n*world.y;
      point L = board.point({-0.3 m, 0, 0}), R = board.point({0.5 m, 0, 0});
      constraint left: {L.x, L.y} = {-0.3 m, 1.2 m};
      constraint right: {R.x, R.y} = {0.5 m, 1.2 m};
      output Force F[2] = multiplier(left);
      annotation(experiment(StopTime = 1));
    end Shelf;
    """
    certificate = lagdsl.compile(text).verify()
    assert certificate.holds
    assert not any("ignorable" in line.says for line in certificate.lines)


# ---- linearization of circuits, verdicts on sampled loops --------------------------------------------------------------


def test_a_motor_has_no_states_of_charges_that_nothing_depends_on() -> None:
    """w/v = k/(L J s^2 + R J s + k^2), of order 2: no charge is a state, and no entry is round-off."""
    text = """
    model Drive
      import Lag.Electrical.*;
      input Voltage v;
      DCMotor m(R = 2, L = 2 mH, k = 0.1, J = 4e-5 kg.m2);
      VoltageSource s(v = v);
      Ground g;
      connect(s.p, m.p);
      connect(s.n, m.n, g.p);
      output AngularVelocity w = der(m.phi);
    end Drive;
    """
    found = lagdsl.compile(text).linearize()
    assert [each.name for each in found.states] == ["m.phi", "der(m.q)", "der(m.phi)"]
    assert [each.name for each in found.left_out] == ["m.q", "s.q", "g.q"]
    assert found.A == pytest.approx(np.array([[0.0, 0.0, 1.0], [0.0, -1000.0, -50.0], [0.0, 2500.0, 0.0]]), rel=1e-12)
    assert np.count_nonzero(found.A) == 4
    steps = np.hstack([np.linalg.matrix_power(found.A, k) @ found.B for k in range(3)])
    seen = np.vstack([found.C @ np.linalg.matrix_power(found.A, k) for k in range(3)])
    assert np.linalg.matrix_rank(seen @ steps) == 2
    s = 30.0 + 200.0j
    gain = found.C @ np.linalg.solve(s * np.eye(3) - found.A, found.B) + found.D
    assert gain[0, 0] == pytest.approx(0.1 / (2e-3 * 4e-5 * s**2 + 2 * 4e-5 * s + 0.01), rel=1e-12)


def test_a_plant_with_a_held_controller_is_not_the_loop() -> None:
    """An inverted rod under a sampled law falls if the law is held, and stays up in the loop."""
    text = """
    model Upright
      coordinate Angle a(start = 0);
      kinetic 1/2*(1 kg.m2)*der(a)^2;
      potential -1/2*(9 N.m/rad2)*a^2;
      discrete Torque u(start = 0);
      torque u on a;
    equation
      when sample(0, 5 ms) then
        u = -(30 N.m/rad)*a - (8 N.m.s/rad)*der(a);
      end when;
      annotation(experiment(StopTime = 5));
    end Upright;
    """
    model = lagdsl.compile(text)
    assert "sampled controller is held" in model.modes().stability
    assert "stable equilibrium" not in model.modes().stability
    assert abs(model.simulate(start={"a": 0.1})["a"][-1]) < 1e-4


# ---- lowest and highest of outputs -------------------------------------------------------------------------------------


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))
def test_the_highest_of_an_output_lies_between_rows(engine: EngineName) -> None:
    """x = cos 10 t passes zero at pi/20 s, where the output is 1; outside of 4 cm it is nothing."""
    text = """
    model Flash
      coordinate Length x(start = 1 m);
      kinetic 1/2*(1 kg)*der(x)^2;
      potential 1/2*(100 N/m)*x^2;
      output Real flash = exp(-(x/(5 mm))^2);
      output Length twice = 2*x;
    end Flash;
    """
    motion = lagdsl.compile(text, engine=engine).simulate(stop=3.0, interval=0.5)
    assert motion.column("flash").highest == pytest.approx(1.0, rel=1e-6)
    assert motion.column("flash").lowest == 0.0
    assert motion.column("twice").lowest == pytest.approx(-2.0, rel=1e-7)


# ---- derivations: stability and equilibria -----------------------------------------------------------------------------

# ---- derivations: names and letters ------------------------------------------------------------------------------------

# ---- derivations: what is printed is short -----------------------------------------------------------------------------

# ---- pictures: springs and bars ----------------------------------------------------------------------------------------

# ---- robots: URDF ------------------------------------------------------------------------------------------------------

# ---- robots: MJCF ------------------------------------------------------------------------------------------------------
