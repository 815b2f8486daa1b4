"""`lag fmu` and `Model.export_fmu`: what reaches the export, and how its failures are told; FMUs are in tests/fmi."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import Result

import lagdsl
from lagdsl.engines.runtime.building.platforms import PLATFORMS
from lagdsl.foundation.diagnostics import Sink

Invoke = Callable[..., Result]

ARRAY = """model Beads
  structural parameter Integer N = 2;
  parameter Mass m = 1 kg;
  coordinate Length x[N];
  gravity = 0;
  for i in 1:N loop
    mass m at {x[i], 0};
    force -1 N/m*x[i] on x[i];
  end for;
end Beads;
"""


class Asked:
    """In the place of the export: keeps what it is asked for, writes a file."""

    def __init__(self) -> None:
        self.arguments: dict[str, Any] = {}
        self.failure: Exception | None = None

    def __call__(self, compilation: Any, path: Path, *, sink: Sink, **arguments: Any) -> None:
        self.arguments = {"compilation": compilation, "path": path, **arguments}
        if self.failure is not None:
            raise self.failure
        path.write_bytes(b"PK")


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Asked:
    asked = Asked()
    monkeypatch.setattr("lagdsl.interfaces.api.fmu.export", asked)
    return asked


def failed(code: str, *, notes: tuple[str, ...] = (), **arguments: str) -> lagdsl.CompilationFailed:
    sink = Sink()
    sink.report(code, None, notes=notes, **arguments)
    return lagdsl.CompilationFailed(sink.diagnostics)


def test_defaults(invoke: Invoke, asked: Asked, pendulum: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(pendulum.parent)
    result = invoke("fmu", pendulum)
    assert (result.exit_code, result.stdout, result.stderr) == (0, "Pendulum.fmu\n", "")
    given = asked.arguments
    assert given["path"] == Path("Pendulum.fmu")
    assert (given["version"], given["kinds"], given["platforms"]) == (2, ("me", "cs"), ())
    assert (given["parameters"], given["start"], given["source"]) == ({}, {}, None)


@pytest.mark.parametrize(("kind", "kinds"), [("me", ("me",)), ("cs", ("cs",)), ("both", ("me", "cs"))])
def test_options(invoke: Invoke, asked: Asked, pendulum: Path, tmp_path: Path, kind: str, kinds: tuple[str]) -> None:
    out = tmp_path / "p.fmu"
    machines = ["--platform", "linux-aarch64", "--platform", "windows-x86_64", "--platform", "linux-aarch64"]
    result = invoke("fmu", pendulum, "--fmi", "3", "--kind", kind, *machines, "--with-source", "-o", out)
    assert result.exit_code == 0, result.stderr
    given = asked.arguments
    assert (given["path"], given["version"], given["kinds"]) == (out, 3, kinds)
    assert given["platforms"] == ("linux-aarch64", "windows-x86_64")
    assert given["source"].text == pendulum.read_text()


def test_all_platforms(invoke: Invoke, asked: Asked, pendulum: Path, tmp_path: Path) -> None:
    assert invoke("fmu", pendulum, "--platform", "all", "-o", tmp_path / "p.fmu").exit_code == 0
    assert asked.arguments["platforms"] == PLATFORMS


def test_values_that_are_set_become_defaults(invoke: Invoke, asked: Asked, pendulum: Path, tmp_path: Path) -> None:
    out = tmp_path / "p.fmu"
    values = ("--set", "l=70 cm", "--set", "theta.start=30 deg", "--set", "der(theta).start=1 rad/s")
    assert invoke("fmu", pendulum, *values, "-o", out).exit_code == 0
    assert asked.arguments["parameters"] == {"l": 0.7}
    assert asked.arguments["start"] == {"theta": math.radians(30), "der(theta)": 1.0}


def test_structural_parameters_recompile(invoke: Invoke, asked: Asked, tmp_path: Path) -> None:
    path = tmp_path / "beads.lag"
    path.write_text(ARRAY)
    assert invoke("fmu", path, "--set", "N=3", "--set", "m=2 kg", "-o", tmp_path / "b.fmu").exit_code == 0
    assert len(asked.arguments["compilation"].flat.coordinates) == 3
    assert asked.arguments["parameters"] == {"m": 2.0}


@pytest.mark.parametrize(
    "arguments",
    [
        ["--fmi", "1"],
        ["--kind", "se"],
        ["--platform", "amiga"],
        ["--set", "length=1 m"],
        ["-o", "nowhere/p.fmu"],
        ["-o", "."],
        ["--clocks"],
        ["--fmi", "2", "--clocks"],
        ["--output", "theta", "--hide", "theta"],
    ],
)
def test_wrong_usage(
    invoke: Invoke, asked: Asked, pendulum: Path, arguments: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(pendulum.parent)
    result = invoke("fmu", pendulum, *arguments)
    assert result.exit_code == 2
    assert asked.arguments == {}
    assert "Error" in result.stderr


def test_a_model_that_is_wrong(invoke: Invoke, asked: Asked, broken: Path, tmp_path: Path) -> None:
    result = invoke("fmu", broken, "-o", tmp_path / "p.fmu")
    assert result.exit_code == 1
    assert "thta" in result.stderr
    assert asked.arguments == {}


def test_a_full_disk(invoke: Invoke, asked: Asked, pendulum: Path, tmp_path: Path) -> None:
    asked.failure = OSError(28, "No space left on device", "p.fmu")
    result = invoke("fmu", pendulum, "-o", tmp_path / "p.fmu")
    assert result.exit_code == 2
    assert "No space left on device" in result.stderr


@pytest.mark.parametrize(
    ("failure", "said"),
    [
        (failed("E0904", package="fmpy"), ["`fmpy`", "pip install fmpy"]),
        (failed("E0905", platform="macos-aarch64"), ["macos-aarch64", "ziglang"]),
        (failed("E0906", platform="linux-x86_64", compiler="cc", notes=("x.c:1: no",)), ["`cc`", "x.c:1: no"]),
        (failed("E0907", notes=("start of `x` is missing",)), ["standard", "start of `x` is missing"]),
        (failed("E0908", reason="the step from 0 s failed"), ["does not run", "the step from 0 s failed", "lag run"]),
    ],
    ids=lambda value: value.diagnostics[0].code if isinstance(value, lagdsl.CompilationFailed) else None,
)
def test_failures_of_the_export(
    invoke: Invoke, asked: Asked, pendulum: Path, tmp_path: Path, failure: Exception, said: list[str]
) -> None:
    asked.failure = failure
    out = tmp_path / "p.fmu"
    result = invoke("fmu", pendulum, "-o", out)
    assert result.exit_code == 1
    assert result.stdout == ""
    assert all(words in result.stderr for words in said)
    assert not out.exists()
    result = invoke("fmu", pendulum, "-o", out, "--format", "json")
    (told,) = json.loads(result.stderr)
    assert told["code"] == failure.diagnostics[0].code  # type: ignore[attr-defined]


# ---- the same from Python --------------------------------------------------------------------------------------------


def test_from_python(asked: Asked, tmp_path: Path) -> None:
    model = lagdsl.compile(ARRAY)
    out = tmp_path / "beads.fmu"
    fractions: list[float] = []
    model.export_fmu(
        str(out),
        fmi=3,
        kind="cs",
        platforms=["windows-x86_64"],
        parameters={"m": 3.0},
        start={"x[2]": 0.5},
        with_source=True,
        progress=fractions.append,
    )
    given = asked.arguments
    assert (given["path"], given["version"], given["kinds"]) == (out, 3, ("cs",))
    assert (given["platforms"], given["parameters"], given["start"]) == (("windows-x86_64",), {"m": 3.0}, {"x[2]": 0.5})
    assert given["source"].text == ARRAY
    assert out.exists()
    given["progress"](0.5)
    assert fractions == [0.5]


@pytest.mark.parametrize(
    ("arguments", "fault"),
    [
        ({"fmi": 1}, ValueError),
        ({"kind": "se"}, ValueError),
        ({"parameters": {"mass": 1.0}}, KeyError),
        ({"parameters": {"m": math.inf}}, ValueError),
        ({"start": {"x": 1.0}}, KeyError),
    ],
)
def test_arguments_that_do_not_fit(
    asked: Asked, tmp_path: Path, arguments: dict[str, Any], fault: type[Exception]
) -> None:
    with pytest.raises(fault):
        lagdsl.compile(ARRAY).export_fmu(tmp_path / "p.fmu", **arguments)
    assert asked.arguments == {}
