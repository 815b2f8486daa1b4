"""The same names for the same things: starts, parameters and inputs near a state and along a motion; frames."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import lagdsl

PENDULUM = """model Driven
  parameter Length l = 0.5 m;
  parameter Mass m = 1 kg;
  input Torque u = 0.2 N.m;
  coordinate Angle a(start = 30 deg);
  gravity = {0, -9.81 m/s2};
  mass m at l*{sin(a), -cos(a)};
  torque u on a;
end Driven;
"""
G = 9.81


@pytest.fixture(scope="module")
def model() -> lagdsl.Model:
    return lagdsl.compile(PENDULUM, engine="tape")


def stiffness(a: float, length: float) -> float:
    """-g/l cos(a), the derivative of the acceleration by the angle."""
    return -G / length * np.cos(a)


def test_long_names_are_those_of_simulate(model: lagdsl.Model) -> None:
    found = model.linearize(start={"a": "20 deg"}, parameters={"l": "0.7 m"}, inputs={"u": "0.5 N.m"})
    assert found.A[1, 0] == pytest.approx(stiffness(np.radians(20.0), 0.7), rel=1e-12)
    same = model.linearize(q=[np.radians(20.0)], p={"l": 0.7}, u=[0.5])
    np.testing.assert_array_equal(found.A, same.A)
    np.testing.assert_array_equal(found.B, same.B)
    frequency = np.sqrt(G / 0.3 * np.cos(0.1)) / (2 * np.pi)
    assert model.modes(start={"a": 0.1}, parameters={"l": 0.3}).frequencies[0] == pytest.approx(frequency, rel=1e-12)
    torque = 1.0 * G * 0.5 * np.sin(0.2)
    assert model.trim(start={"a": 0.1}, inputs={"u": torque}).point.q[0] == pytest.approx(0.2, rel=1e-9)
    varied = model.vary("l", [0.3, 0.4], start={"a": 0.0}, inputs={"u": 0.0})
    expected = [np.sqrt(G / length) for length in (0.3, 0.4)]
    np.testing.assert_allclose(np.abs(varied.eigenvalues.imag).max(axis=1), expected, rtol=1e-9)


def test_inputs_of_all_forms_count_at_the_time_of_the_state(model: lagdsl.Model, tmp_path: Path) -> None:
    table = tmp_path / "u.csv"
    table.write_text("time,u\n0,0.1\n2,0.5\n")
    for inputs in ({"u": lambda t: 0.1 + 0.2 * t}, {"u": ([0.0, 2.0], [0.1, 0.5])}, table):
        assert model.linearize(t=1.0, inputs=inputs).point.u[0] == pytest.approx(0.3, rel=1e-12)


def test_a_rate_of_the_start_is_one_of_the_state(model: lagdsl.Model) -> None:
    assert model.linearize(start={"der(a)": 2.0}).point.qd[0] == 2.0


def test_what_is_given_twice_is_told(model: lagdsl.Model) -> None:
    for named, words in (
        ({"u": [1.0], "inputs": {"u": 1.0}}, "u and inputs are two names"),
        ({"p": {"l": 1.0}, "parameters": {"l": 1.0}}, "p and parameters are two names"),
        ({"q": [0.1], "start": {"a": 0.2}}, "the start of `a` is given twice"),
    ):
        with pytest.raises(ValueError, match=words):
            model.linearize(**named)


def test_unknown_names_are_told_with_the_nearest_one(model: lagdsl.Model) -> None:
    for named, name in (({"start": {"b": 0.1}}, "b"), ({"parameters": {"ll": 1}}, "ll"), ({"inputs": {"v": 1}}, "v")):
        with pytest.raises(lagdsl.CompilationFailed, match=f"`{name}`"):
            model.linearize(**named)


def test_functions_take_the_state_of_a_start(model: lagdsl.Model) -> None:
    """m l^2, m l^2 w^2/2 - m g l cos(a), u/(m l^2) - g/l sin(a) and their derivatives."""
    a, rate, length, mass = np.radians(20.0), 2.0, 0.7, 3.0
    named = {"start": {"a": "20 deg", "der(a)": rate}, "parameters": {"l": "70 cm", "m": mass}}
    torque = {"u": lambda t: 0.1 + 0.4 * t}
    inertia = mass * length**2
    assert model.mass_matrix(**named) == pytest.approx(np.array([[inertia]]), rel=1e-12)
    energy = 0.5 * inertia * rate**2 - mass * G * length * np.cos(a)
    assert model.energy(**named) == pytest.approx(energy, rel=1e-12)
    for t, u in ((0.0, 0.1), (1.0, 0.5)):
        found = model.forward_dynamics(t, **named, inputs=torque)
        assert found == pytest.approx([u / inertia - G / length * np.sin(a)], rel=1e-12)
        wanted = model.inverse_dynamics(t, qdd=[1.5], **named, inputs=torque)
        assert wanted == pytest.approx([1.5 * inertia + mass * G * length * np.sin(a) - u], rel=1e-12)
    assert model.state_jacobian(**named)[1, 0] == pytest.approx(stiffness(a, length), rel=1e-12)
    start = model.initial_state()
    assert model.forward_dynamics() == pytest.approx(model.forward_dynamics(start.t, start.q, start.qd), rel=1e-15)


def test_the_state_of_a_start_is_on_the_constraints() -> None:
    bar = lagdsl.compile("models/four_bar.lag", engine="tape")
    known = bar.initial_state(start={"A.q": "50 deg"}, parameters={"coupler.m": 3.0})
    named = {"start": {"A.q": "50 deg"}, "parameters": {"coupler.m": 3.0}}
    np.testing.assert_array_equal(bar.mass_matrix(**named), bar.mass_matrix(known.t, known.q, p=known.p))
    frame = bar.frame("coupler.frame_b")
    np.testing.assert_array_equal(frame.jacobian(**named), frame.jacobian(known.t, known.q, known.qd))
    joint = np.array([frame.position(**named)[:2], bar.frame("rocker.frame_a").position(**named)[:2]])
    np.testing.assert_allclose(joint[0], joint[1], atol=1e-9)
    cut = bar.mass_matrix(start={"D.q": "100 deg"})  # the coordinate of a joint at which the loop is cut
    assert cut.shape == (len(bar.coordinates),) * 2


def test_a_state_that_is_given_twice_or_in_part_is_told(model: lagdsl.Model) -> None:
    frame = lagdsl.compile("models/four_bar.lag", engine="tape").frame("coupler.frame_b")
    for call, named, words in (
        (model.mass_matrix, {"t": 0.0, "q": [0.1], "start": {"a": 0.2}}, "q and start are two ways"),
        (model.energy, {"qd": [0.1]}, "qd is given without q"),
        (model.energy, {"parameters": {"l": 1.0}, "p": {"l": 1.0}}, "p and parameters are two names"),
        (model.energy, {"t": [0.0, 1.0]}, "one state has one time"),
        (model.inverse_dynamics, {"start": {"a": 0.2}}, "qdd must be made of real numbers"),
        (frame.position, {"t": 0.0, "q": [0.1, 0.1, 0.1], "start": {"A.q": 0.2}}, "q and start are two ways"),
    ):
        with pytest.raises(ValueError, match=words):
            call(**named)
    for named, name in (({"start": {"b": 0.1}}, "b"), ({"parameters": {"ll": 1}}, "ll"), ({"inputs": {"v": 1}}, "v")):
        with pytest.raises(lagdsl.CompilationFailed, match=f"`{name}`"):
            model.forward_dynamics(**named)
    with pytest.raises(ValueError, match="mass"):
        model.mass_matrix(start={"a": "3 kg"})


def test_a_component_names_its_only_frame() -> None:
    panda = lagdsl.compile("models/robots/panda.lag", engine="tape")
    q = np.linspace(0.1, 0.9, len(panda.coordinates))
    flange = panda.frame("panda_link7")
    assert flange.name == "panda_link7.frame_a"
    np.testing.assert_array_equal(flange.position(0.0, q), panda.frame("panda_link7.frame_a").position(0.0, q))
    with pytest.raises(lagdsl.CompilationFailed, match=r"panda_joint1\.frame_a.*panda_joint1\.frame_b") as several:
        panda.frame("panda_joint1")
    assert isinstance(several.value, KeyError)
