"""Combinations that data show, in words: products, quotients, and sums of base parameters."""

import numpy as np
import pytest
from fit.measured_models import DAMPED, compiled

from lagdsl.motion.fit.combinations import visible_sums

# Two links in a vertical plane: I1 and I2 about the joints, h1 and h2 first moments, m2 the mass of the second link.
ARM = """model Arm
  parameter Length l1 = 0.5 m;
  parameter Inertia I1 = 0.2 kg.m2, I2 = 0.07 kg.m2;
  parameter Real h1(unit = "kg.m") = 0.5, h2(unit = "kg.m") = 0.2;
  parameter Mass m2 = 1 kg;
  coordinate Angle a(start = 20 deg), b(start = 30 deg);
  input Torque u1, u2;
  AngularVelocity wa = der(a), wb = der(a) + der(b);
  kinetic 1/2*(I1 + m2*l1^2)*wa^2 + 1/2*I2*wb^2 + l1*h2*cos(b)*wa*wb;
  potential -g_n*((h1 + m2*l1)*cos(a) + h2*cos(a + b));
  torque u1 on a;
  torque u2 on b;
end Arm;
"""


def driven():
    times = np.linspace(0.0, 2.0, 81)
    inputs = {"u1": (times, 3.0 * np.sin(4.0 * times)), "u2": (times, np.sin(7.0 * times + 1.0))}
    motion = compiled(ARM).simulate(times=times, inputs=inputs)
    random = np.random.default_rng(0)
    noise = random.normal(0.0, 1e-4, (2, len(times)))
    return {
        "run": {"data": {"time": times, "a": motion["a"] + noise[0], "b": motion["b"] + noise[1]}, "inputs": inputs}
    }


def test_base_parameters_of_two_links():
    found = compiled(ARM).fit(driven(), "I1, I2, h1, h2, m2")
    (hidden,) = found.hidden
    assert hidden.names == ("I1", "h1", "m2") and hidden.exact
    assert hidden.visible == ("I1 + 0.25*m2", "h1 + 0.5*m2")
    assert np.isfinite([found.intervals["I2"], found.intervals["h2"]]).all()
    assert found["I1"] + 0.25 * found["m2"] == pytest.approx(0.45, rel=1e-2)


def test_quotient_of_damping_and_mass():
    times = np.linspace(0.0, 3.0, 60)
    seen = {"time": times, "theta": compiled(DAMPED).simulate(times=times, parameters={"c": 0.03, "l": 0.6})["theta"]}
    found = compiled(DAMPED).fit(seen, "m, l, c")
    assert [str(each) for each in found.hidden] == ["of m and c only m/c is visible in the data"]
    assert [each.code for each in found.notes if each.code == "W1113"] == ["W1113"]
    assert found["l"] == pytest.approx(0.6, rel=1e-6)


def test_what_has_no_effect():
    text = DAMPED.replace("start = 40 deg", "start = 0 deg")
    times = np.linspace(0.0, 3.0, 30)
    seen = {"time": times, "theta": 1e-3 * np.sin(times)}
    found = compiled(text).fit(seen, "l")
    assert [str(each) for each in found.hidden] == ["the data do not depend on l"]


# Two links with masses, mass centres and inertias: what their motion shows (Gautier and Khalil), with l1 = 1/2.
LINKS = ["m1", "c1", "I1", "m2", "c2", "I2"]


def links_shown(x):
    """Gradients of the base parameters at x."""
    m1, c1, _, m2, c2, _ = x
    return np.array([
        [c1**2, 2.0 * m1 * c1, 1.0, 0.25, 0.0, 0.0],
        [c1, m1, 0.0, 0.5, 0.0, 0.0],
        [0.0, 0.0, 0.0, c2, m2, 0.0],
        [0.0, 0.0, 0.0, c2**2, 2.0 * m2 * c2, 1.0],
    ])  # fmt: skip


def test_base_parameters_of_masses_and_centres():
    x = np.array([2.0, 0.25, 0.05, 1.0, 0.2, 0.03])
    noise = np.random.default_rng(0)

    def unseen(there):
        found = np.linalg.svd(links_shown(there) * x)[2][4:].T
        return found + noise.normal(0.0, 1e-7, found.shape)

    found = visible_sums(LINKS, x, x, unseen, 4)
    assert sorted(found) == ["0.5*m2 + m1*c1", "I1 + 0.25*m2 + m1*c1^2", "I2 + m2*c2^2", "m2*c2"]


def test_no_sum_is_made_up():
    x = np.array([2.0, 0.5, 0.7])

    def unseen(there):
        shown = np.array([[np.cos(there[0]), there[1] ** 3, np.exp(there[2])]])
        return np.linalg.svd(shown * x)[2][1:].T

    assert visible_sums(["a", "b", "c"], x, x, unseen, 1) is None
