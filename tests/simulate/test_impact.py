"""The law of impact: its conditions hold for any mechanism, and no energy is gained."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.simulate.events.impact import collide


@pytest.mark.parametrize("seed", range(40))
def test_impulses_push_and_obey_the_law_of_restitution(seed: int) -> None:
    random = np.random.default_rng(seed)
    n, contacts, rows = 6, int(random.integers(1, 6)), int(random.integers(0, 3))
    root = random.normal(size=(n, n))
    mass = root @ root.T + 0.1 * np.eye(n)
    jacobian, normal = random.normal(size=(rows, n)), random.normal(size=(contacts, n))
    if contacts > 2:
        normal[-1] = 0.5 * normal[0] + 0.5 * normal[1]  # a leg too many
    rates = random.normal(size=n)
    rates -= np.linalg.lstsq(jacobian, jacobian @ rates, rcond=None)[0]
    restitution = np.full(contacts, random.uniform(0.0, 1.0))
    after = collide(mass, jacobian, rows, rates, normal, normal @ rates, restitution)

    assert np.allclose(jacobian @ after, 0.0, atol=1e-10)
    left = normal @ after + restitution * (normal @ rates)
    assert np.min(left) > -1e-9
    # what pushes is met: the impulse is that of contacts with left = 0 alone
    active = np.flatnonzero(left < 1e-9)
    forces = np.concatenate([normal[active], jacobian]).T
    impulse = mass @ (after - rates)
    parts = np.linalg.lstsq(forces, impulse, rcond=None)[0]
    assert np.allclose(forces @ parts, impulse, atol=1e-8)
    if len(active) and contacts < 3:
        assert np.min(parts[: len(active)]) > -1e-8
    assert after @ mass @ after <= rates @ mass @ rates * (1.0 + 1e-12)


@pytest.mark.parametrize("exponent", [1.0, 1.5])
def test_a_compliant_contact_loses_two_thirds_of_c_v(exponent: float) -> None:
    """Hunt, Crossley (1975): e = 1 - 2/3 c v for small c v, whatever the stiffness and the exponent."""
    text = f"""
    model Bumper
      coordinate Length x(start = 1 cm, der(start = -0.5 m/s));
      kinetic 1/2*(2 kg)*der(x)^2;
      contact wall: x >= 0 with compliance = 3e4, damping = 0.02 s/m, exponent = {exponent};
    end Bumper;
    """
    motion = lagdsl.compile(text).simulate(stop=0.5, tolerance=1e-11)
    assert motion["der(x)"][-1] / 0.5 == pytest.approx(1.0 - 2.0 / 3.0 * 0.01, abs=0.01**2)


def test_what_friction_would_hold_creeps_by_the_speed_of_regularization() -> None:
    text = """
    model Block
      parameter Real mu = 0.5;
      parameter Angle slope = 20 deg;
      parameter Velocity v_0 = 1 mm/s;
      coordinate Length s;
      gravity = -g_n*world.y;
      mass 1 kg at {s*cos(slope), -s*sin(slope)};
      force -mu*(1 kg)*g_n*cos(slope)*tanh(der(s)/v_0) on s;
    end Block;
    """
    motion = lagdsl.compile(text).simulate(stop=1.0)
    assert motion["der(s)"][-1] == pytest.approx(1e-3 * np.arctanh(np.tan(np.radians(20.0)) / 0.5), rel=1e-6)
