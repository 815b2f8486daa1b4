"""`lag linearize`, `lag modes`, `lag trim`."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from choice import spread
from click.testing import Result

Invoke = Callable[..., Result]
ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs" / "explanation" / "oscillations.md").read_text(encoding="utf-8")
MODELS = ROOT / "models"


@pytest.mark.parametrize(("command", "shown"), re.findall(r"```console\n\$ lag ([^\n]*)\n(.*?)\n```", PAGE, re.DOTALL))
def test_outputs_of_the_page(invoke: Invoke, monkeypatch: pytest.MonkeyPatch, command: str, shown: str) -> None:
    monkeypatch.chdir(ROOT)
    result = invoke(*shlex.split(command))
    assert result.exit_code == 0, result.stderr
    assert result.stdout.rstrip() == shown


def test_python_of_the_page(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(ROOT)
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    exec(code, {})
    assert "(6, 6) (6, 1)" in capsys.readouterr().out


def test_modes_as_json(invoke: Invoke) -> None:
    result = invoke("modes", MODELS / "three_masses.lag", "--trim", "--to", "json")
    data = json.loads(result.stdout)
    assert data["places"] == ["x[1]", "x[2]", "x[3]"]
    assert data["eigenvalues"][0][1] == pytest.approx(2 * np.sqrt(75) * np.sin(np.pi / 8))
    assert data["time_constants"] == [None] * 6


@pytest.mark.parametrize("form", ["json", "csv", "npz"])
def test_matrices_in_a_file(invoke: Invoke, tmp_path: Path, form: str) -> None:
    out = tmp_path / f"out.{form}"
    result = invoke("linearize", MODELS / "three_masses.lag", "-o", out)
    assert (result.exit_code, result.stdout) == (0, ""), result.stderr
    match form:
        case "json":
            b = json.loads(out.read_text())["B"]
        case "npz":
            b = np.load(out)["B"].tolist()
        case _:
            header, *rows = [line.split(",") for line in out.read_text().splitlines()]
            assert header[-1] == "f"
            b = [[float(row[-1])] for row in rows]
    assert b == [[0], [0], [0], [2.5], [0], [0]]


@pytest.mark.parametrize(
    "arguments", [("modes", "--vary", "k=linspace(10, 20, 3) N/m"), ("modes", "--trim"), ("trim",)]
)
def test_tables_in_a_file(invoke: Invoke, tmp_path: Path, arguments: tuple[str, ...]) -> None:
    out = tmp_path / "out.csv"
    command, *options = arguments
    result = invoke(command, MODELS / "three_masses.lag", *options, "-o", out)
    assert result.exit_code == 0, result.stderr
    widths = {line.count(",") for line in out.read_text().splitlines()}
    assert len(widths) == 1


@pytest.mark.parametrize(
    "options", spread([("--trim",), ("--set", "x[1].start=0", "--vary", "k=linspace(-10, 20, 7) N/m")], 1)
)
def test_figures(invoke: Invoke, tmp_path: Path, options: tuple[str, ...]) -> None:
    out = tmp_path / "out.png"
    result = invoke("modes", MODELS / "three_masses.lag", *options, "--plot", out)
    assert result.exit_code == 0, result.stderr
    assert out.read_bytes()[1:4] == b"PNG"


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("modes", "--vary", "k"), "expected name=value"),
        (("modes", "--vary", "kk=1:2"), "has no parameter `kk`; what can be set: m, k, gap"),
        (("modes", "--vary", "k=linspace(1, 2, 1) N/m"), "two values at least"),
        (("modes", "--vary", "k=1:1"), "is empty"),
        (("modes", "--vary", "k=1 m:2 m"), "`k` is"),
        (("modes", "--input", "g=1"), "has no input `g`"),
        (("modes", "-o", "out.txt"), "results are written as"),
        (("linearize", "--set", "kk=1"), "what can be set: m, k, gap"),
        (("modes", "--plot", "out.txt"), "figures are written as"),
    ],
)
def test_usage(invoke: Invoke, options: tuple[str, ...], words: str) -> None:
    command, *rest = options
    result = invoke(command, MODELS / "three_masses.lag", *rest)
    assert result.exit_code == 2
    assert words in result.stderr


def test_diagnostics_leave_with_status_one(invoke: Invoke) -> None:
    result = invoke("trim", MODELS / "four_bar_angles.lag")
    assert (result.exit_code, result.stdout) == (1, "")
    assert "error[E0852]" in result.stderr
    assert "not free: `a`" in result.stderr
    result = invoke("modes", MODELS / "pendulum.lag", "--engine", "numpy")
    assert result.exit_code == 0
    assert "warning[W0854]" in result.stderr
    result = invoke("trim", MODELS / "pendulum.lag", "--free", "q")
    assert (result.exit_code, "error[E0853]" in result.stderr) == (1, True)


def test_integrable_rows_are_told(invoke: Invoke, tmp_path: Path) -> None:
    path = tmp_path / "coupled.lag"
    path.write_text(
        """model Coupled
             coordinate Length x[2];
             gravity = 0;
             mass 1 kg at {x[1], 0};
             mass 2 kg at {x[2], 1 m};
             potential 1/2*(12 N/m)*x[1]^2;
             constraint same: der(x[1]) = der(x[2]);
           end Coupled;
        """
    )
    result = invoke("modes", path)
    assert "1 zero eigenvalue(s) left out: velocity constraint same is integrable" in result.stdout


def test_inputs_and_held_coordinates(invoke: Invoke) -> None:
    result = invoke("trim", MODELS / "three_masses.lag", "--free", "f", "--hold", "x[1]", "--to", "json")
    data = json.loads(result.stdout)
    values = dict(zip(data["names"], data["values"], strict=True))
    assert values["x[1]"] == 0.05
    assert values["f"] == pytest.approx(30 * 0.05 * 4 / 3)
    assert values["x[3]"] == pytest.approx(0.05 / 3)


SERVO = """model Servo
  parameter Time h = 10 ms;
  coordinate Length x;
  discrete Force u(start = 0);
  input Force f = 0 N;
  kinetic 1/2*(2 kg)*der(x)^2;
  force u + f on x;
  output Length place = x;
equation
  when sample(0, h) then
    u = limit((60 N/m)*(0.5 m - x) - (15 N.s/m)*der(x), -20 N, 20 N);
  end when;
end Servo;
"""


@pytest.fixture
def servo(tmp_path: Path) -> Path:
    path = tmp_path / "servo.lag"
    path.write_text(SERVO)
    return path


def test_a_sampled_loop_as_json(invoke: Invoke, servo: Path) -> None:
    """z^2 - trace z + det with h = 10 ms, k/m = 30, d/m = 7.5."""
    data = json.loads(invoke("modes", servo, "--trim", "--to", "json").stdout)
    trace, det = 2 - 0.075 - 30e-4 / 2, 1 - 0.075 + 30e-4 / 2
    found = [complex(*z) for z in data["multipliers"]]
    assert (sum(found), found[0] * found[1]) == (pytest.approx(trace), pytest.approx(det))
    assert (data["period"], data["fixed_point"], data["held"]) == (0.01, True, ["u"])
    assert data["without"][0].startswith("limit(")


def test_matrices_of_a_sampled_loop(invoke: Invoke, servo: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.json"
    shown = invoke("linearize", servo, "--every", "20 ms", "--trim")
    assert "sampled every 20 ms" in shown.stdout
    assert "Left out: `u`; nothing at the next instant depends on these." in shown.stdout
    assert invoke("linearize", servo, "--every", "20 ms", "--trim", "-o", out).exit_code == 0
    data = json.loads(out.read_text())
    one = np.array([[1 - 30e-4 / 2, 0.01 - 7.5e-4 / 2], [-0.3, 1 - 0.075]])
    np.testing.assert_allclose(data["A"], one @ one, rtol=1e-12)
    assert (data["every"], data["states"], data["left_out"]) == (0.02, ["x", "der(x)"], ["u"])


def test_a_frequency_response_as_table_and_picture(invoke: Invoke, servo: Path, tmp_path: Path) -> None:
    """The plant alone: 1/(2 kg s^2)."""
    picture = tmp_path / "bode.png"
    asked = ("bode", servo, "--from", "f", "--to", "place", "--band", "1:2 rad/s")
    result = invoke(*asked, "--form", "csv", "--plot", picture)
    header, first, *_ = result.stdout.splitlines()
    assert header.startswith("frequency [Hz],re,im,magnitude")
    assert [float(x) for x in first.split(",")] == pytest.approx([1 / (2 * np.pi), -0.5, 0, 0.5, np.pi])
    assert picture.read_bytes()[:4] == b"\x89PNG"
    text = invoke("bode", servo, "--from", "f", "--to", "place", "--every", "10 ms", "--trim").stdout
    assert "sampled every 10 ms" in text and "with u = -y in SI units the loop is stable" in text


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["bode", "--band", "1:2"], "expected first:last with a unit"),
        (["bode", "--band", "2:1 Hz"], "have to rise"),
        (["linearize", "--every", "0 s"], "longer than zero"),
    ],
)
def test_periods_and_bands_that_mean_nothing(invoke: Invoke, servo: Path, options: list[str], message: str) -> None:
    result = invoke(options[0], servo, *options[1:])
    assert result.exit_code == 2
    assert message in result.stderr
