"""Linearization of circuits: charges that nothing depends on are left out, and what is zero is zero to the bit."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.motion.analysis.linearization import Linearization

TWO_LOOPS = """model TwoLoops "v - r - l - (c parallel to l2 - r2)"
  import Lag.Electrical.*;
  input Voltage v = 0 V;
  parameter Resistance R = 1 kOhm, R2 = 300 Ohm;
  parameter Inductance L = 1 mH, L2 = 3 mH;
  parameter Capacitance C = 1 uF;
  Resistor r(R = R), r2(R = R2);
  Inductor l(L = L), l2(L = L2);
  Capacitor c(C = C);
  VoltageSource s(v = v);
  Ground g;
  connect(s.p, r.p);
  connect(r.n, l.p);
  connect(l.n, c.p, l2.p);
  connect(l2.n, r2.p);
  connect(s.n, c.n, r2.n, g.p);
  output Voltage across = c.q/C;
  output Current through = l2.p.i;
  {more}
end TwoLoops;
"""


def linear(more: str = "") -> Linearization:
    return lagdsl.compile(TWO_LOOPS.format(more=more)).linearize()


def test_states_are_those_of_capacitors_and_inductors() -> None:
    """L i' = v - R i - q/C, L2 i2' = q/C - R2 i2, q' = i - i2; each entry is one product, or zero."""
    found = linear()
    names = [each.name for each in found.states]
    assert names[0] == "c.q"
    assert len(names) == 3
    assert [each.name for each in found.left_out] == ["r.q", "r2.q", "l.q", "l2.q", "s.q", "g.q"]
    one, two = (names.index(name) for name in ("der(l.q)", "der(r2.q)"))
    a, b = np.zeros((3, 3)), np.zeros((3, 1))
    a[0, [one, two]] = 1.0, -1.0
    a[one, [0, one]] = -1e9, -1e6
    a[two, [0, two]] = 1e9 / 3.0, -1e5
    b[one] = 1e3
    np.testing.assert_allclose(found.A, a, rtol=1e-12)
    np.testing.assert_allclose(found.B, b, rtol=1e-12)
    assert np.count_nonzero(found.A) == 6
    assert found.rate.shape == (3,)


@pytest.mark.parametrize(
    ("more", "kept"),
    [
        ("output Charge drawn = s.q;", {"s.q"}),
        ("output Real high = if r2.q > 1 C then 1 else 0;", {"r2.q"}),
        ("potential (1 V/C3)*r.q^4;", {"r.q"}),  # of which the derivative at zero is zero by chance
    ],
)
def test_charges_that_something_depends_on_stay(more: str, kept: set[str]) -> None:
    found = linear(more)
    every = {"r.q", "r2.q", "l.q", "l2.q", "s.q", "g.q"}
    assert {each.name for each in found.left_out} == every - kept
    assert kept <= {each.name for each in found.states}
    assert found.A.shape == (4, 4)


def test_mechanical_coordinates_stay() -> None:
    """The angle of a free wheel is no charge: a state, though nothing depends on it."""
    text = "model A coordinate Angle a; kinetic 1/2*(1 kg.m2)*der(a)^2; output AngularVelocity w = der(a); end A;"
    found = lagdsl.compile(text).linearize()
    assert [each.name for each in found.states] == ["a", "der(a)"]
    assert found.left_out == ()
