"""Inputs that are counted, switched or chosen hold between the rows of tables and refuse what has no meaning; numbers
are linear, or held on request. The same in files, in Python and in many runs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.interfaces.cli.main import lag

MODEL = """type Way = enumeration(off, left, right);

model Cart
  input Integer n(min = -2, max = 3) = 1;
  input Boolean on = true;
  input Way way = Way.right;
  input Force f = 0;
  coordinate Length x;
  state Real count, time_on, time_right, impulse;
  kinetic 1/2*(1 kg)*der(x)^2;
  force (if on then n*(1 N) else 0) + f on x;
equation
  der(count) = n/(1 s);
  der(time_on) = if on then 1/(1 s) else 0;
  der(time_right) = if way == Way.right then 1/(1 s) else 0;
  der(impulse) = f/(1 N.s);
  annotation(experiment(StopTime = 2));
end Cart;
"""
TIMES = [0.0, 0.3, 0.7, 0.7, 1.9, 2.0]
ROWS = {
    "n": [1.0, 3.0, -2.0, 2.0, 0.0, 3.0],
    "on": [1.0, 0.0, 1.0, 1.0, 0.0, 1.0],
    "way": [3.0, 1.0, 2.0, 3.0, 1.0, 1.0],
    "f": [0.0, 3.0, 1.0, -1.0, 0.5, 2.0],
}
SPANS = np.diff(TIMES)


@pytest.fixture(scope="module")
def model() -> lagdsl.Model:
    return lagdsl.compile(MODEL, engine="tape")


def held(column: str) -> float:
    return float(np.sum(np.array(ROWS[column])[:-1] * SPANS))


def linear(column: str) -> float:
    values = np.array(ROWS[column])
    return float(np.sum((values[:-1] + values[1:]) / 2 * SPANS))


def check(end: dict[str, float], impulse: float) -> None:
    """Integrals over the motion; the momentum is that of all forces."""
    assert end["count"] == pytest.approx(held("n"), abs=1e-10)
    assert end["time_on"] == pytest.approx(held("on"), abs=1e-10)
    assert end["time_right"] == pytest.approx(0.3 + 1.2, abs=1e-10)
    assert end["impulse"] == pytest.approx(impulse, abs=1e-9)
    pushed = float(np.sum(np.array(ROWS["n"])[:-1] * np.array(ROWS["on"])[:-1] * SPANS))
    assert end["der(x)"] == pytest.approx(pushed + impulse, abs=1e-9)


def end_of(motion: Any) -> dict[str, float]:
    return {name: float(motion[name][-1]) for name in ("count", "time_on", "time_right", "impulse", "der(x)")}


def file(tmp_path: Path) -> Path:
    """With the words that other programs write for truths."""
    words = {0.0: "False", 1.0: "true"}
    lines = ["time,n,on,way,f"]
    for k, t in enumerate(TIMES):
        n, on, way, f = (ROWS[name][k] for name in ("n", "on", "way", "f"))
        lines.append(f"{t},{n:g},{words[on]},{way:g},{f}")
    path = tmp_path / "rows.csv"
    path.write_text("\n".join(lines) + "\n")
    return path


def test_python(model: lagdsl.Model) -> None:
    tables: dict[str, Any] = {name: (TIMES, values) for name, values in ROWS.items()}
    check(end_of(model.simulate(inputs=tables)), linear("f"))
    check(end_of(model.simulate(inputs={**tables, "f": lagdsl.Hold(TIMES, ROWS["f"])})), held("f"))


def test_files(model: lagdsl.Model, tmp_path: Path) -> None:
    check(end_of(model.simulate(inputs=file(tmp_path))), linear("f"))


@pytest.mark.parametrize(("options", "impulse"), [((), linear("f")), (("--input-hold",), held("f"))])
def test_the_command_line(options: tuple[str, ...], impulse: float, tmp_path: Path) -> None:
    text, result = tmp_path / "cart.lag", tmp_path / "out.csv"
    text.write_text(MODEL)
    done = CliRunner().invoke(lag, ["run", str(text), "--input", str(file(tmp_path)), *options, "-o", str(result)])
    assert done.exit_code == 0, done.output
    rows = np.genfromtxt(result, delimiter=",", names=True, deletechars="", replace_space="")
    check({name: float(rows[name][-1]) for name in ("count", "time_on", "time_right", "impulse", "der(x)")}, impulse)


def test_many_runs(model: lagdsl.Model) -> None:
    tables: dict[str, Any] = {name: (TIMES, values) for name, values in ROWS.items()}
    tables["f"] = lagdsl.Hold(TIMES, ROWS["f"])
    runs = model.simulate_many(start={"x": [0.0, 1.0]}, inputs=tables)
    for run in range(2):
        end = {name: float(np.asarray(runs[name])[run, -1]) for name in ("count", "time_on", "impulse", "der(x)")}
        check({**end, "time_right": 1.5}, held("f"))


def test_a_row_is_an_event_at_its_time(model: lagdsl.Model) -> None:
    motion = model.simulate(inputs={"on": ([0.0, 1 / 3, 2.0], [1, 0, 0])}, interval=0.1)
    assert [(event.time, event.kind, event.name) for event in motion.events] == [(1 / 3, "false", "input on")]
    before, after = np.flatnonzero(motion.time == 1 / 3)
    assert (motion["der(x)"][before], motion["der(x)"][after]) == pytest.approx((1 / 3, 1 / 3), rel=1e-12)


@pytest.mark.parametrize(
    ("name", "values", "code"),
    [
        ("n", [0, 4], "E0885"),
        ("n", [-3, 0], "E0885"),
        ("n", [0, 0.5], "E0845"),
        ("on", [0, 2], "E0845"),
        ("on", [0.5, 1], "E0845"),
        ("on", [-1, 1], "E0845"),
        ("way", [0, 1], "E0885"),
        ("way", [1, 4], "E0885"),
    ],
)
def test_values_without_a_meaning(model: lagdsl.Model, name: str, values: list[float], code: str) -> None:
    signals: list[Any] = [([0.0, 2.0], values), next(v for v in values if v not in (0, 1) or (name, v) == ("way", 0))]
    for signal in signals:
        with pytest.raises(CompilationFailed) as failure:
            model.simulate(inputs={name: signal})
        assert [diagnostic.code for diagnostic in failure.value.diagnostics] == [code]


@pytest.mark.parametrize("cell", ["", " ", "nan", "inf", "1_0", "maybe"])
@pytest.mark.parametrize("column", ["n", "on", "f"])
def test_cells_without_a_value(model: lagdsl.Model, column: str, cell: str, tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    path.write_text(f"time,{column}\n0,1\n1,{cell}\n2,1\n")
    with pytest.raises(CompilationFailed) as failure:
        model.simulate(inputs=path)
    assert [diagnostic.code for diagnostic in failure.value.diagnostics] == ["E0823"]


def test_truths_are_no_numbers(model: lagdsl.Model, tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    path.write_text("time,n,on\n0,1,true\n2,true,false\n")
    with pytest.raises(CompilationFailed) as failure:
        model.simulate(inputs=path)
    assert [diagnostic.code for diagnostic in failure.value.diagnostics] == ["E0823"]
    assert failure.value.diagnostics[0].labels[0].span.text == "true"


def test_what_prescribes_a_position_cannot_be_held() -> None:
    text = """model Cart
  input Length road(smooth = 2);
  coordinate Length x;
  mass 1 kg at {x + road, 0};
  gravity = 0;
end Cart;
"""
    with pytest.raises(CompilationFailed) as failure:
        lagdsl.compile(text, engine="tape").simulate(stop=1, inputs={"road": lagdsl.Hold([0, 0.5, 1], [0, 1, 1])})
    assert {diagnostic.code for diagnostic in failure.value.diagnostics} == {"E0847"}


def test_an_enumeration_that_nobody_gives_is_its_first_literal() -> None:
    model = lagdsl.compile(MODEL.replace(" = Way.right", ""), engine="tape")
    assert model.simulate()["time_right"][-1] == 0.0
    text = MODEL.replace("way == Way.right", "way == Way.off").replace(" = Way.right", "")
    assert lagdsl.compile(text, engine="tape").simulate()["time_right"][-1] == pytest.approx(2.0)


PRESSED = """model Pressed
  input Force f = -10 N;
  coordinate Length y;
  kinetic 1/2*(1 kg)*der(y)^2;
  force f on y;
  contact ground: y >= 0 with restitution = 0;
  annotation(experiment(StopTime = 2));
end Pressed;
"""


@pytest.mark.parametrize("many", [False, True])
@pytest.mark.parametrize("held", [False, True])
def test_a_contact_opens_where_an_input_jumps_to_a_pull(held: bool, many: bool) -> None:
    """y = 1/2 a (t - 1 s)^2 after the jump; the ground held the mass down with -10 N."""
    times, values = (
        ([0.0, 1.0, 2.0], [-10.0, 10.0, 10.0]) if held else ([0.0, 1.0, 1.0, 2.0], [-10.0, -10.0, 10.0, 10.0])
    )
    given = {"f": lagdsl.Hold(times, values) if held else (times, values)}
    model = lagdsl.compile(PRESSED, engine="tape")
    motion = (
        model.simulate_many(parameters={}, start={"y": [0.0]}, inputs=given) if many else model.simulate(inputs=given)
    )
    y = motion["y"][0] if many else motion["y"]
    assert y == pytest.approx(5.0 * np.maximum(motion.time - 1.0, 0.0) ** 2, abs=1e-9)
