"""Transfer functions, zeros, margins and frequency responses against closed forms, and against python-control."""

from __future__ import annotations

import sys
from pathlib import Path

import control
import numpy as np
import pytest

import lagdsl
from lagdsl import CompilationFailed, UnknownName
from lagdsl.interfaces.api.model import Model
from lagdsl.motion.analysis.control.zeros import invariant_zeros
from lagdsl.motion.analysis.linearization import Linearization

ROOT = Path(__file__).parents[3]
ARM = """model Arm "a motor drives an elastic load"
  input Torque u;
  parameter Inertia J1 = 2e-3 kg.m2, J2 = 5e-3 kg.m2;
  parameter RotationalStiffness k = 30 N.m/rad;
  parameter RotationalDamping c = {c} N.m.s/rad;
  coordinate Angle a, b;
  kinetic 1/2*J1*der(a)^2 + 1/2*J2*der(b)^2;
  potential 1/2*k*(a - b)^2;
  dissipation 1/2*c*(der(a) - der(b))^2;
  torque u on a;
  output Angle motor = a, load = b;
end Arm;
"""


def arm(c: str = "0") -> Model:
    return lagdsl.compile(ARM.format(c=c))


def test_a_two_mass_drive() -> None:
    """a/u = (J2 s^2 + k)/(s^2 (J1 J2 s^2 + k (J1 + J2))), b/u = k/(...)."""
    linear = arm().linearize()
    motor, load = (linear.transfer_function("u", name) for name in ("motor", "load"))
    pole, zero = np.sqrt(30 * 7e-3 / 1e-5), np.sqrt(30 / 5e-3)
    np.testing.assert_allclose(np.sort(motor.poles.imag), [-pole, 0, 0, pole], rtol=1e-12)
    assert np.count_nonzero(motor.poles == 0.0) == 2
    np.testing.assert_allclose(np.sort_complex(motor.zeros), [-1j * zero, 1j * zero], rtol=1e-12, atol=1e-9)
    assert motor.gain == pytest.approx(1 / 2e-3, rel=1e-12)
    assert (len(load.zeros), load.gain) == (0, pytest.approx(30 / 1e-5, rel=1e-12))
    np.testing.assert_allclose(load.denominator, [1, 0, pole**2, 0, 0], atol=1e-9)
    assert motor.static_gain == np.inf


def test_a_double_integrator_has_a_gain() -> None:
    """All poles are zero: nothing sets the size of s."""
    found = lagdsl.compile("model M input Force f; coordinate Length x; mass 2 kg at {x, 0}; force f on x; end M;")
    assert found.linearize().transfer_function("f", "x").gain == pytest.approx(0.5, rel=1e-14)
    assert found.linearize(every=0.1).transfer_function("f", "x").gain == pytest.approx(0.1**2 / 4, rel=1e-12)


def test_zeros_on_the_axis_stand_where_the_response_is_zero() -> None:
    found = arm().bode("u", "motor", frequencies=[np.sqrt(6000.0) / (2 * np.pi)])
    assert abs(found.response[0]) < 1e-12
    assert abs(found.transfer.zeros[0]) == pytest.approx(np.sqrt(6000.0), rel=1e-12)


def test_the_response_is_told_around_poles_on_the_axis_and_not_at_them() -> None:
    found = arm().bode("u", "motor")
    assert np.all(np.isfinite(found.response))
    assert np.max(found.magnitude[found.frequencies > 5]) > 1e3 * np.median(found.magnitude)
    assert np.min(found.magnitude) < 1e-9 * np.max(found.magnitude)


def test_zeros_of_two_inputs_and_two_outputs() -> None:
    """diag(1/(s+1), (s-3)/(s+2)^2), mixed by constant matrices and by units: the zero 3 alone is left."""
    a = np.array([[-1.0, 0, 0], [0, 0, 1], [0, -4, -4]])
    b, c = np.array([[1.0, 0], [0, 0], [0, 1]]), np.array([[1.0, 0, 0], [0, -3, 1]])
    mix, units = np.array([[1.0, 2.0], [3.0, 4.0]]), np.array([1e-6, 1e3, 1e5])
    a, b, c = a * units / units[:, None], b @ mix / units[:, None], mix @ c * units
    np.testing.assert_allclose(invariant_zeros(a, b, c, np.zeros((2, 2))), [3.0], rtol=1e-9)


def loop(numerator: list[float], denominator: list[float], every: float | None = None) -> Linearization:
    """The linear model of a made-up system, as our class."""
    system = control.ss(control.tf(numerator, denominator))
    found = arm().linearize()
    from dataclasses import replace

    states = tuple(replace(found.states[0], name=f"x{k}") for k in range(len(system.A)))
    return replace(
        found, states=states, outputs=found.outputs[:1], A=system.A, B=system.B, C=system.C, D=system.D, every=every
    )


def test_margins_of_three_equal_lags() -> None:
    """4/(s+1)^3: gain margin 2 at sqrt(3); |G| = 1 where 1 + w^2 = 4^(2/3)."""
    found = loop([4.0], [1.0, 3.0, 3.0, 1.0]).margins()
    omega = np.sqrt(4 ** (2 / 3) - 1)
    assert found.gain == pytest.approx(2.0, rel=1e-12)
    assert found.of_gain[0].omega == pytest.approx(np.sqrt(3.0), rel=1e-12)
    assert found.phase == pytest.approx(np.pi - 3 * np.arctan(omega), rel=1e-12)
    assert found.delay == pytest.approx(found.phase / omega, rel=1e-12)
    assert found.stable
    assert not loop([9.0], [1.0, 3.0, 3.0, 1.0]).margins().stable


def test_a_narrow_resonance_is_not_missed() -> None:
    """1e-3/(s^2 + 1e-6 s + 1): the gain is above one within 5e-4 of the resonance only."""
    found = loop([1e-3], [1.0, 1e-6, 1.0]).margins()
    np.testing.assert_allclose([c.omega for c in found.of_phase], np.sqrt([1 - 1e-3, 1 + 1e-3]), rtol=1e-8)


def test_margins_of_a_sampled_loop() -> None:
    sampled = control.c2d(control.tf([1.0], [1.0, 1.0, 0.0]), 0.5)
    found = loop(list(sampled.num[0][0]), list(sampled.den[0][0]), 0.5).margins()
    gain, phase, _, half, one, _ = control.stability_margins(sampled)
    assert (found.gain, np.degrees(found.phase)) == (pytest.approx(gain), pytest.approx(phase))
    assert (found.of_gain[0].omega, found.of_phase[0].omega) == (pytest.approx(half), pytest.approx(one))


RUBBING = """model Rubbing "a bead on an ellipse, with drag that grows with the force of the wire"
  input Force f;
  coordinate Length x(start = 0.3 m), y(start = -0.9 m);
  gravity = -g_n*world.y;
  mass 1 kg at {x, y};
  constraint wire: (x/(1 m))^2 + (y/(1 m))^2/2 = 1;
  force f - 0.2*(0.1 N.s/m + (0.01 s/m)*multiplier(wire)/(1 m))*der(x) on x;
  output Force press = multiplier(wire)/(1 m);
end Rubbing;
"""


@pytest.mark.parametrize(
    ("text", "source", "target", "q"),
    [
        ("four_bar.lag", "tau", "B.q", {}),
        ("slider_crank.lag", "load", "speed", {"th": 0.4}),
        (RUBBING, "f", "press", {}),
    ],
)
def test_the_descriptor_form_agrees_with_the_state_space(
    text: str, source: str, target: str, q: dict[str, float]
) -> None:
    model = lagdsl.compile(text if "model" in text else ROOT / "models" / text)
    found = model.bode(source, target, q=q)
    expected = found.transfer.response(2 * np.pi * found.frequencies)
    np.testing.assert_allclose(found.response, expected, rtol=1e-9)
    assert len(found.frequencies) > 50


CIRCUIT = """model Drive "a motor in a circuit, with a recorder of the charge that is drawn"
  import Lag.Electrical.*;
  input Voltage v = 0 V;
  parameter Inertia J = 1e-3 kg.m2;
  coordinate Angle phi;
  coordinate Charge q "drawn";
  kinetic 1/2*J*der(phi)^2 + 1/2*(2 mH)*der(q)^2 + {more};
  dissipation 1/2*(1 Ohm)*der(q)^2;
  force v on q;
  force -(0.1 V.s/rad)*der(phi) on q;
  torque (0.1 V.s/rad)*der(q) on phi;
  output AngularVelocity w = der(phi);
end Drive;
"""


def test_python_control_gets_names_and_units_and_no_idle_charge() -> None:
    """A factor that is one at the point to second order leaves the structure and no entry: exact zeros are left out."""
    text = CIRCUIT.format(more="(1e-3 H/C2)*q^2*der(q)^2")
    linear = lagdsl.compile(text).linearize()
    system = linear.to_control()
    assert [each.name for each in linear.states] == ["phi", "q", "der(phi)", "der(q)"]
    assert system.state_labels == ["phi", "der(phi)", "der(q)"]
    assert (system.input_labels, system.output_labels, system.name) == (["v"], ["w"], "Drive")
    assert system.left_out == ("q",)
    assert system.units == {"phi": "rad", "der(phi)": "rad/s", "der(q)": "A", "v": "V", "w": "rad/s"}
    s = 3.0 + 2.0j
    expected = 0.1 / (1e-3 * s * (2e-3 * s + 1.0) + 0.01)
    assert system(s) == pytest.approx(expected, rel=1e-12)
    assert linear.to_control(full_state=True).output_labels == system.state_labels
    function = linear.transfer_function().to_control()
    assert function(s) == pytest.approx(expected, rel=1e-9)


def test_dots_of_names_become_underscores() -> None:
    """python-control parts systems from signals by dots."""
    system = lagdsl.compile(ROOT / "models" / "four_bar.lag").linearize().to_control()
    assert system.state_labels == ["B_q", "der(B_q)"]


def test_without_python_control(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "control", None)
    with pytest.raises(ModuleNotFoundError, match="pip install control"):
        arm().linearize().to_control()


def test_names_that_are_missing_or_unknown() -> None:
    linear = arm().linearize()
    with pytest.raises(CompilationFailed, match=r"E0861.*\n.*`motor`, `load`"):
        linear.transfer_function("u")
    with pytest.raises(UnknownName, match="`torque` cannot be the input"):
        linear.transfer_function("torque", "load")
    assert linear.transfer_function(target="der(b)").output.unit == "rad/s"
