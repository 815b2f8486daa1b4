"""Arguments and outputs of functions by the names of their entries, in a model and in its module for NumPy."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lagdsl
from lagdsl.engines.backends.registry import BACKENDS

SOURCE = """
model Arm
  parameter Length l = 0.5 m;
  input Torque tau[2](start = {0.1, 0.2}), brake;
  coordinate Angle q[2];
  coordinate Length s;
  state Real z;
  point tool = {l*sin(q[1]), -l*cos(q[1])};
  mass 1 kg at tool;
  mass 2 kg at tool + {l*sin(q[2]), -l*cos(q[2])};
  mass 1 kg at {0, 0, s};
  torque tau[1] - brake on q[1];
  torque tau[2] on q[2];
  gravity = -g_n*world.y;
  output Torque doubled[2] = 2*tau;
  output Length height = tool.y;
  output Real grid[2, 3] = {{q[1]/(1 rad), 2, 3}, {4, 5, z}};
equation
  der(z) = -z/(1 s);
end Arm;
"""
Q, QD = [0.3, -0.2, 0.1], [1.0, 2.0, 3.0]


@pytest.fixture(scope="module")
def model() -> lagdsl.Model:
    return lagdsl.compile(SOURCE, engine="tape")


@pytest.fixture(scope="module", params=["model", "module"])
def functions(request: pytest.FixtureRequest, model: lagdsl.Model, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """The model, and the module that needs no lagdsl."""
    if request.param == "model":
        return model
    ((name, text),) = BACKENDS["numpy"].emit(model._compilation.program).files.items()
    path: Path = tmp_path_factory.mktemp("module") / name
    path.write_text(text)
    module = runpy.run_path(str(path))
    return type("Module", (), {key: staticmethod(value) for key, value in module.items() if callable(value)})


def test_an_array_by_its_name_is_its_elements(functions: Any) -> None:
    expected = functions.forward_dynamics(0.0, Q, QD, u=[3.0, 4.0, 0.5])
    by_array = functions.forward_dynamics(0.0, Q, QD, u={"tau": [3.0, 4.0], "brake": 0.5})
    by_element = functions.forward_dynamics(0.0, Q, QD, u={"tau[2]": 4.0, "brake": 0.5, "tau[1]": 3.0})
    np.testing.assert_array_equal(by_array, expected)
    np.testing.assert_array_equal(by_element, expected)


def test_entries_that_are_left_out_have_their_defaults(functions: Any) -> None:
    expected = functions.forward_dynamics(0.0, Q, QD, u=[0.1, 7.0, 0.0], p=[0.6])
    found = functions.forward_dynamics(0.0, Q, QD, u={"tau[2]": 7.0}, p={"l": 0.6})
    np.testing.assert_array_equal(found, expected)


def test_coordinates_and_rates_by_name(functions: Any) -> None:
    found = functions.mass_matrix(0.0, {"s": 0.1, "q": [0.3, -0.2]}, {"q": [1.0, 2.0], "s": 3.0})
    np.testing.assert_array_equal(found, functions.mass_matrix(0.0, Q, QD))


def test_leading_axes_broadcast(functions: Any) -> None:
    torques = np.arange(8.0).reshape(4, 2)
    found = functions.forward_dynamics(np.zeros((3, 1)), Q, QD, u={"tau": torques, "brake": [[0.0], [1.0], [2.0]]})
    assert found.shape == (3, 4, 3)
    np.testing.assert_array_equal(found[2, 3], functions.forward_dynamics(0.0, Q, QD, u=[6.0, 7.0, 2.0]))


def test_outputs_by_name_have_the_axes_of_their_arrays(functions: Any) -> None:
    found = functions.named_outputs(np.zeros(5), Q, QD, z=[0.7], u={"tau": [1.0, 2.0]})
    assert list(found) == ["doubled", "height", "grid"]
    assert [found[name].shape for name in found] == [(5, 2), (5,), (5, 2, 3)]
    np.testing.assert_allclose(found["doubled"][4], [2.0, 4.0])
    np.testing.assert_allclose(found["grid"][4], [[0.3, 2, 3], [4, 5, 0.7]])
    np.testing.assert_allclose(found["height"], -0.5 * np.cos(0.3))
    other = functions.named_outputs(0.0, Q, QD, z=[0.7], inputs={"tau": [3.0, 4.0]})
    np.testing.assert_allclose(other["doubled"], [6.0, 8.0])


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"tau": [1.0, 2.0, 3.0]}, "`tau` has 2 elements along its last axes"),
        ({"tau": 1.0}, "`tau` has 2 elements along its last axes"),
        ({"tau": [1.0, 2.0], "tau[1]": 3.0}, "`tau[1]` is given twice"),
    ],
)
def test_values_that_do_not_fit_are_told(functions: Any, given: Any, words: str) -> None:
    with pytest.raises(ValueError) as caught:
        functions.forward_dynamics(0.0, Q, QD, u=given)
    assert words in str(caught.value)


def test_vectors_without_names_are_numbers(functions: Any) -> None:
    for ask in (
        lambda: functions.mass_matrix("0 s", [0.1, 0.2, 0.3]),
        lambda: functions.mass_matrix(0.0, ["1 deg", "2 deg", "1 m"]),
        lambda: functions.mass_matrix(0.0, [1j, 0.0, 0.0]),
    ):
        with pytest.raises(ValueError, match=r"^[tq] must be made of real numbers in SI units: "):
            ask()


def test_missing_coordinates_are_told(functions: Any) -> None:
    with pytest.raises(ValueError, match=r"q: there is no value for q\[2\], s"):
        functions.mass_matrix(0.0, {"q[1]": 0.3})


def test_unknown_names_are_told_with_the_nearest(model: lagdsl.Model) -> None:
    with pytest.raises(lagdsl.UnknownName) as caught:
        model.forward_dynamics(0.0, Q, QD, u={"brakes": 1.0})
    assert "input" in str(caught.value) and "brake" in str(caught.value)


def test_quantities_are_texts(model: lagdsl.Model) -> None:
    found = model.forward_dynamics(
        0.0, {"q": ["30 deg", 0.2], "s": "10 cm"}, {"q": [1.0, "60 rpm"], "s": 0}, p={"l": "70 cm"}
    )
    q, qd = [np.pi / 6, 0.2, 0.1], [1.0, 2 * np.pi, 0.0]
    np.testing.assert_allclose(found, model.forward_dynamics(0.0, q, qd, p=[0.7]), rtol=1e-15)
    with pytest.raises(ValueError, match="force"):
        model.forward_dynamics(0.0, Q, QD, u={"brake": "1 N"})
    with pytest.raises(ValueError, match="unit"):
        model.forward_dynamics(0.0, Q, QD, u={"tau": ["1", "2 N.m"]})
