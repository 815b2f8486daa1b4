"""Parameters that become numbers of the model: `compile(fix=...)` and `lag build --fix`."""

import runpy
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from choice import spread

import lagdsl

TEXT = """
model Swing "Pendulum on a spring; closed form below"
  parameter Mass m(min = 0 kg) = 2 kg;
  parameter Length l = 0.5 m;
  parameter Stiffness k = 30 N/m;
  parameter Length twice = 2*l;
  coordinate Length x;
  coordinate Angle theta(start = 0.4 rad);
  gravity = {0, -9.81 m/s2};
  mass m at {x + l*sin(theta), -l*cos(theta)};
  mass 1 kg at {x, 0};
  potential 1/2*k*x^2 + (1 N/m)*twice*x;
end Swing;
"""


def accelerations(m: float, l: float, k: float, x: float, theta: float, rate: float) -> np.ndarray:
    """Cart of 1 kg with spring k and pendulum m, l: Newton's second law, written out by hand."""
    matrix = np.array([[1 + m, m * l * np.cos(theta)], [m * l * np.cos(theta), m * l**2]])
    force = np.array([m * l * rate**2 * np.sin(theta) - k * x - 2 * l, -m * 9.81 * l * np.sin(theta)])
    return np.linalg.solve(matrix, force)


STATE = (0.0, [0.1, 0.4], [0.2, -0.7])


def test_all_parameters_become_numbers() -> None:
    model = lagdsl.compile(TEXT, fix=True)
    assert model.parameters == [] and len(model.defaults) == 0
    expected = accelerations(2, 0.5, 30, 0.1, 0.4, -0.7)
    np.testing.assert_allclose(model.forward_dynamics(*STATE), expected, rtol=1e-13)


def test_some_parameters_take_other_values() -> None:
    model = lagdsl.compile(TEXT, fix={"l": 0.7, "k": 12.0})
    assert model.parameters == ["m"]
    expected = accelerations(3, 0.7, 12, 0.1, 0.4, -0.7)
    np.testing.assert_allclose(model.forward_dynamics(*STATE, p=[3.0]), expected, rtol=1e-13)


def test_a_pattern_names_the_parameters_of_a_component() -> None:
    text = (
        TEXT.replace("Swing", "Part").replace("  gravity = {0, -9.81 m/s2};\n", "")
        + "model Two Part left, right(m = 5 kg); gravity = {0, -9.81 m/s2}; end Two;"
    )
    model = lagdsl.compile(text, fix=["left.*", "right.m"])
    assert model.parameters == ["right.l", "right.k"]
    qdd = model.forward_dynamics(0.0, [0.1, 0.4, 0.1, 0.4], [0.2, -0.7, 0.2, -0.7])
    expected = [*accelerations(2, 0.5, 30, 0.1, 0.4, -0.7), *accelerations(5, 0.5, 30, 0.1, 0.4, -0.7)]
    np.testing.assert_allclose(qdd, expected, rtol=1e-13)


def test_fixed_parameters_shorten_the_equations() -> None:
    def size(model: lagdsl.Model) -> int:
        program = model._compilation.program
        return len(program.graph.live([n for b in program.function("dynamics").results for n in b.elements]))

    assert size(lagdsl.compile(TEXT, fix=True)) < size(lagdsl.compile(TEXT))


@pytest.mark.parametrize(
    ("fix", "error", "words"),
    [
        ({"mm": 1.0}, KeyError, "no parameter `mm`"),
        (["leg.*"], KeyError, "no independent parameter"),
        ({"m": -1.0}, ValueError, "must be at least 0"),
        ({"m": float("nan")}, ValueError, "finite"),
        ("m", TypeError, "list of names"),
    ],
)
def test_what_cannot_be_fixed_is_refused(fix: object, error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words.replace("(", r"\(")):
        lagdsl.compile(TEXT, fix=fix)  # type: ignore[arg-type]


def build(folder: Path, *fix: str) -> subprocess.CompletedProcess[str]:
    (folder / "swing.lag").write_text(TEXT)
    options = [word for each in fix for word in ("--fix", each)]
    command = [sys.executable, "-m", "lagdsl", "build", "swing.lag", "--target", "numpy", "-o", "out", *options]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def test_a_built_module_does_not_ask_for_fixed_parameters(tmp_path: Path) -> None:
    assert build(tmp_path, "m=3000 g", "l*").returncode == 0
    module = runpy.run_path(str(tmp_path / "out" / "Swing.py"))
    qdd = module["forward_dynamics"](STATE[0], np.array(STATE[1]), np.array(STATE[2]))
    np.testing.assert_allclose(qdd, accelerations(3, 0.5, 30, 0.1, 0.4, -0.7), rtol=1e-13)


@pytest.mark.parametrize(
    ("fix", "words"),
    spread(
        [
            ("m=3 m", "this is a length"),
            ("x.start=1 m", "is a start value"),
            ("mm=2 kg", "no parameter `mm`"),
            ("q*", "--fix"),
        ],
        2,
    ),
)
def test_wrong_options_are_refused(tmp_path: Path, fix: str, words: str) -> None:
    result = build(tmp_path, fix)
    assert result.returncode == 2 and words in result.stderr
    assert not (tmp_path / "out").exists()
