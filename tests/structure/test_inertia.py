"""E0503 in networks: which coordinates move without kinetic energy, and what to do."""

from __future__ import annotations

import lagdsl
from lagdsl.diagnostics import Diagnostic

RING = """
model Ring
  parameter Resistance R = 1 kOhm;
  parameter Capacitance C = 1 uF;
  parameter Inductance L = {inductance};
  coordinate Charge capacitor(start = 1 uC), resistor, coil;
  potential capacitor^2/(2*C);
  dissipation 1/2*R*der(resistor)^2;
  kinetic 1/2*L*der(coil)^2;
  constraint first: capacitor + resistor = 1 uC;
  constraint second: {second};
end Ring;
"""


def _errors(text: str) -> list[Diagnostic]:
    return [d for d in lagdsl.check(text) if d.severity == "error"]


def test_a_loop_with_an_inductance_is_sound() -> None:
    assert not _errors(RING.format(inductance="1 mH", second="coil = resistor"))


def test_a_loop_without_one_is_told_with_all_its_charges_once() -> None:
    (error,) = _errors(RING.format(inductance="1 mH", second="coil = 0"))
    assert error.code == "E0503"
    assert error.notes == ("der(capacitor) and der(resistor) can change together without kinetic energy",)
    assert error.help is not None and "inductance" in error.help


def test_a_loose_flange_is_told_with_its_component() -> None:
    (error,) = _errors(
        """
        model Shafts
          import Lag.Rotational.{Rotor, Damper};
          Rotor rotor(J = 2 kg.m2);
          Damper oil(c = 1 N.m.s/rad);
          constraint joined: rotor.phi = oil.phi_a;
        end Shafts;
        """
    )
    assert error.code == "E0503" and error.message == "`oil.phi_b` has no inertia"
    assert [label.span.text for label in error.labels] == ["phi_b", "oil"]
    assert error.help is not None and error.help.startswith("connect it")
