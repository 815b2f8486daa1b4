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


def test_a_component_names_its_only_frame() -> None:
    panda = lagdsl.compile("models/robots/panda.lag", engine="tape")
    q = np.linspace(0.1, 0.9, len(panda.coordinates))
    flange = panda.frame("panda_link7")
    assert flange.name == "panda_link7.frame_a"
    np.testing.assert_array_equal(flange.position(0.0, q), panda.frame("panda_link7.frame_a").position(0.0, q))
    with pytest.raises(lagdsl.CompilationFailed, match=r"panda_joint1\.frame_a.*panda_joint1\.frame_b") as several:
        panda.frame("panda_joint1")
    assert isinstance(several.value, KeyError)
