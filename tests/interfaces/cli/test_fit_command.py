"""`lag fit` and `lag sensitivity`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from click.testing import Result

import lagdsl

Invoke = Callable[..., Result]

BALL = """model Ball
  parameter Real e(min = 0.1, max = 0.99) = 0.75;
  coordinate Length h(start = 1 m);
  gravity = -9.81 m/s2*world.y;
  mass 0.1 kg at {0, h};
  contact floor: h >= 0 with restitution = e;
  annotation(experiment(StopTime = 2));
end Ball;
"""


@pytest.fixture
def swing(pendulum: Path) -> Path:
    """Readings of a pendulum of 70 cm, in degrees and milliseconds."""
    motion = lagdsl.compile(pendulum).simulate(stop=2.0, interval=0.05, parameters={"l": 0.7})
    read = np.degrees(motion["theta"]) + np.random.default_rng(0).normal(0.0, 0.1, len(motion))
    path = pendulum.parent / "swing.csv"
    table = np.column_stack([1e3 * motion.time, read, np.ones(len(motion))])
    np.savetxt(path, table, delimiter=",", header="time [ms],angle [deg],note", comments="")
    return path


COLUMNS = ("--column", "angle=theta", "--column", "note=")


def test_units_and_names_of_columns(invoke: Invoke, pendulum: Path, swing: Path) -> None:
    result = invoke("fit", pendulum, swing, "--free", "l", *COLUMNS)
    assert result.exit_code == 0, result.output
    line = next(each for each in result.stdout.splitlines() if each.startswith("  l "))
    value, half = (float(each) for each in line.split()[1:3])
    assert abs(value - 0.7) < 2.0 * half < 0.002


def test_files_of_the_result(invoke: Invoke, pendulum: Path, swing: Path) -> None:
    text, page = pendulum.parent / "fitted.lag", pendulum.parent / "fit.html"
    result = invoke("fit", pendulum, swing, "--free", "l", *COLUMNS, "-o", text, "--report", page)
    assert result.exit_code == 0, result.output
    old, new = pendulum.read_text().splitlines(), text.read_text().splitlines()
    changed = [b for a, b in zip(old, new, strict=True) if a != b]
    assert len(changed) == 1 and changed[0].startswith("  parameter Length l = 0.699")
    html = page.read_text(encoding="utf-8")
    assert html.count("<svg") == 2 and "<script" not in html and "http" not in html.replace("http-equiv", "")


def test_bounds_and_starts(invoke: Invoke, pendulum: Path, swing: Path) -> None:
    options = ("--bounds", "l=10:60 cm", "--starts", 3, "--loss", "huber", "--sigma", "theta=0.1 deg")
    result = invoke("fit", pendulum, swing, *COLUMNS, *options)
    assert result.exit_code == 0, result.output
    assert "W1111" in result.stderr and "at its bound" in result.stdout


def test_times_of_impacts(invoke: Invoke, tmp_path: Path) -> None:
    model, times = tmp_path / "ball.lag", tmp_path / "bounces.csv"
    model.write_text(BALL)
    first = np.sqrt(2.0 / 9.81)
    table = 1e3 * first * (1.0 + 2.0 * np.cumsum([0.0, 0.8, 0.64]))
    np.savetxt(times, table, header="floor [ms]", comments="")
    result = invoke("fit", model, times, "--free", "e")
    assert result.exit_code == 0, result.output
    assert "  e    0.8 " in result.stdout and "bounces.csv  floor" in result.stdout


@pytest.mark.parametrize(
    ("status", "words", "options"),
    [
        (1, "E1101", ["--free", "l"]),
        (1, "E1105", COLUMNS),
        (1, "E0874", [*COLUMNS, "--free", "length"]),
        (2, "LOW:HIGH", [*COLUMNS, "--bounds", "l=1 m"]),
        (2, "COLUMN=NAME", ["--free", "l", "--column", "note"]),
        (2, "write it with a unit", [*COLUMNS, "--free", "l", "--sigma", "theta=0.1"]),
        (2, "written as .lag", [*COLUMNS, "--free", "l", "-o", "fitted.txt"]),
        (2, "written as .html", [*COLUMNS, "--free", "l", "--report", "fit.pdf"]),
    ],
)
def test_refused(invoke: Invoke, pendulum: Path, swing: Path, status: int, words: str, options: list[str]) -> None:
    result = invoke("fit", pendulum, swing, *options)
    assert (result.exit_code, words in result.output) == (status, True), result.output


def test_a_file_that_is_missing_or_of_another_unit(invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
    assert invoke("fit", pendulum, tmp_path / "none.csv", "--free", "l").exit_code == 2
    wrong = tmp_path / "wrong.csv"
    wrong.write_text("time,theta [m]\n0,1\n1,2\n2,3\n")
    result = invoke("fit", pendulum, wrong, "--free", "l")
    assert result.exit_code == 1 and "E0878" in result.stderr
    wrong.write_text("time,theta\n0,1\n1,\n2,3\n")
    result = invoke("fit", pendulum, wrong, "--free", "l")
    assert result.exit_code == 1 and "E0823" in result.stderr


def test_sensitivity_ranks(invoke: Invoke, pendulum: Path) -> None:
    result = invoke("sensitivity", pendulum, "--of", "theta", "--by", "m, l, theta.start", "--stop", "1")
    assert result.exit_code == 0, result.output
    names = [line.split()[0] for line in result.stdout.splitlines()[2:]]
    assert names[-1] == "m" and set(names) == {"m", "l", "theta.start"}
    assert invoke("sensitivity", pendulum).exit_code == 0
    assert "E0874" in invoke("sensitivity", pendulum, "--of", "thta").output
    assert "E0874" in invoke("sensitivity", pendulum, "--by", "mass").output


def test_sensitivity_is_that_of_the_closed_form() -> None:
    text = 'model S\n  parameter Real w(unit = "rad/s") = 3;\n  coordinate Length x(start = 2 m);\n'
    text += "  kinetic 1/2*(1 kg)*der(x)^2;\n  potential 1/2*(1 kg)*w^2*x^2;\nend S;\n"
    found = lagdsl.compile(text).sensitivity("x, der(x)", ["w", "x.start", "der(x).start"], stop=1.5)
    s, c = np.sin(4.5), np.cos(4.5)
    exact = [[-3.0 * s, c, s / 3.0], [-2.0 * s - 9.0 * c, -3.0 * s, c]]
    assert np.allclose(found.derivatives, exact, atol=1e-5)
    assert np.allclose(found.effects, np.multiply(exact, [0.03, 0.02, 0.0]), atol=1e-6)
    assert "per SI unit" in str(found)
