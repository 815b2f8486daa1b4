"""Inputs of each run: a mass that forces push has closed forms; a run of many has the bits of the same run alone."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lagdsl
from lagdsl.motion.sweep import ensemble
from lagdsl.motion.sweep.plan import Axis, Plan
from lagdsl.motion.sweep.run import Options, SweptModel
from lagdsl.motion.sweep.sweep import Unfinished, Work, journal_path, sweep
from lagdsl.motion.sweep.values import labels_of

TEXT = """model Pushed
  type Gear = enumeration(reverse, forward);
  input Force f = 0; input Force g = 0; input Gear gear = Gear.forward; input Integer n(min = 0, max = 3) = 1;
  parameter Mass m = 1 kg;
  coordinate Length x;
  kinetic 1/2*m*der(x)^2;
  force (f + g)*n*(if gear == Gear.forward then 1 else -1) on x;
end Pushed;
"""
RAMP = ([0.0, 1.0], [0.0, 6.0])  # x(1 s) = 1 m
SHORT: dict[str, Any] = {"stop": 1.0, "interval": 0.5, "tolerance": 1e-10}


@pytest.fixture(scope="module")
def pushed() -> lagdsl.Model:
    return lagdsl.compile(TEXT, engine="tape")


SIGNALS: list[Any] = [2.0, "2 N", RAMP, np.array(RAMP), lagdsl.Hold([0.0, 0.5, 1.0], [0.0, 8.0, 8.0]), lambda t: 6 * t]


def test_signals_of_every_form(pushed: lagdsl.Model) -> None:
    many = pushed.simulate_many(inputs={"f": SIGNALS, "g": ([0.0, 1.0], [0.0, 3.0])}, start={"x": 1.0}, **SHORT)
    assert many.failures == {}
    np.testing.assert_allclose(many["x"][:, -1], 1.5 + np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0]), rtol=1e-9)
    for k, signal in enumerate(SIGNALS):
        one = pushed.simulate(inputs={"f": signal, "g": ([0.0, 1.0], [0.0, 3.0])}, start={"x": 1.0}, **SHORT)
        alone = one["x"][np.searchsorted(one.time, many.time, side="right") - 1]  # of two rows at a jump the later one
        assert many["x"][k].tobytes() == alone.tobytes()


def test_numbers_are_made_in_one_call(pushed: lagdsl.Model, monkeypatch: pytest.MonkeyPatch) -> None:
    """Beside the parameters and the starts of the same runs."""
    calls: list[int] = []
    own = ensemble.Ensemble._run
    monkeypatch.setattr(ensemble.Ensemble, "_run", lambda *a: calls.append(len(a[1])) or own(*a))  # type: ignore[func-returns-value]
    forces, masses, starts = np.linspace(1, 4, 64), np.linspace(1, 2, 64), np.linspace(0, 1, 64)
    many = pushed.simulate_many(inputs={"f": forces}, parameters={"m": masses}, start={"x": starts}, threads=1, **SHORT)
    np.testing.assert_allclose(many["x"][:, -1], starts + forces / masses / 2, rtol=1e-12)
    assert sum(calls) == 64 and max(calls) >= 16


def test_whole_inputs_and_names_of_values(pushed: lagdsl.Model) -> None:
    runs = [{"f": 1.0, "gear": "forward", "n": 2}, {"f": 4.0, "gear": "reverse", "n": 1}]
    many = pushed.simulate_many(inputs=runs, **SHORT)
    np.testing.assert_allclose(many["x"][:, -1], [1.0, -2.0], rtol=1e-12)
    own = pushed.simulate_many(inputs={"n": [0, 3, 4, 1.5, 1], "f": 2.0}, **SHORT)
    np.testing.assert_allclose(own["x"][[0, 1, 4], -1], [0.0, 3.0, 1.0], atol=1e-12)
    assert {k: text[:5] for k, text in own.failures.items()} == {2: "E0885", 3: "E0845"}


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        ({"ff": [1.0]}, "did you mean `f`|there are f"),
        ({"ff": 1.0, "f": [1.0, 2.0]}, "no input `ff`"),
        ({"f": [1.0, [1.0, 2.0, 3.0]]}, "entry 1 of input `f` must be a number, a function"),
        ({"f": ["1 N", "2 m"]}, "this is a length"),
        ({"f": ["1 N", "2"]}, "write the text with a unit"),
        ({"f": [1.0, np.inf]}, "finite"),
        ({"f": [1.0, 2.0], "g": [RAMP, RAMP, RAMP]}, "`f` has 2, `g` has 3"),
        ([{"f": 1.0}, {"g": 1.0}], "`f` is missing in run 1"),
        ([{"f": 1.0}, {"f": 1.0, "g": 1.0}], "`g` is missing in run 0"),
        ([], "`inputs` is empty"),
        ({"f": 1.0}, "there is none"),
    ],
)
def test_what_does_not_fit(pushed: lagdsl.Model, inputs: Any, words: str) -> None:
    with pytest.raises((KeyError, ValueError), match=words):
        pushed.simulate_many(inputs=inputs, **SHORT)


def _files(folder: Path) -> list[Path]:
    texts = {"a.csv": "time [ms],f [kN]\n0,0\n1000,0.006\n", "b.csv": "time,f\n0,2\n1,2\n"}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    return [folder / name for name in texts]


def test_a_file_for_each_run(pushed: lagdsl.Model, tmp_path: Path) -> None:
    many = pushed.simulate_many(inputs=_files(tmp_path), **SHORT)
    np.testing.assert_allclose(many["x"][:, -1], [1.0, 1.0], rtol=1e-9)
    np.testing.assert_allclose(many["x"][:, 1], [0.125, 0.25], rtol=1e-9)


def test_names_of_files() -> None:
    assert labels_of([Path("runs/a.csv"), Path("runs/b.csv")]) == ("a.csv", "b.csv")
    assert labels_of([Path("runs/1/a.csv"), Path("runs/2/a.csv")]) == ("1/a.csv", "2/a.csv")


class TestSweep:
    def test_axes(self, pushed: lagdsl.Model, tmp_path: Path) -> None:
        pytest.importorskip("xarray")
        data = pushed.sweep({"m": [1.0, 2.0]}, inputs={"f": "1, 2, 3 N", "g": 1.0}, **SHORT)
        assert data["x"].dims == ("m", "f", "time") and float(data["g"]) == 1.0
        assert data["f"].attrs["units"] == data["g"].attrs["units"] == "N"
        expected = np.array([2.0, 3.0, 4.0]) / np.array([[1.0], [2.0]]) / 2
        np.testing.assert_allclose(data["x"].values[..., -1], expected, rtol=1e-12)
        tables = pushed.sweep({}, inputs={"f": [RAMP, 4.0], "g": [0.0, 2.0]}, **SHORT)
        assert list(tables["f"].values) == ["entry 0", "entry 1"]
        np.testing.assert_allclose(tables["x"].values[..., -1], [[1.0, 2.0], [2.0, 3.0]], rtol=1e-9)
        files = pushed.sweep({}, inputs=_files(tmp_path), **SHORT)
        assert list(files["input"].values) == ["a.csv", "b.csv"] and files["x"].dims == ("input", "time")

    def test_functions_are_called_by_one_thread(self, pushed: lagdsl.Model) -> None:
        pytest.importorskip("xarray")
        callers: set[int] = set()

        def force(t: float) -> float:
            callers.add(threading.get_ident())
            return 6 * t

        data = pushed.sweep({"m": [1.0, 2.0]}, inputs={"f": [force, lambda t: force(t) + 2]}, jobs=4, **SHORT)
        np.testing.assert_allclose(data["x"].values[..., -1], [[1.0, 2.0], [0.5, 1.0]], rtol=1e-8)
        assert len(callers) == 1

    def test_samples(self, pushed: lagdsl.Model) -> None:
        pytest.importorskip("xarray")
        data = pushed.sweep({"m": [1.0, 2.0]}, samples={"f": [1.0, 2.0, 4.0]}, **SHORT)
        assert data["x"].dims == ("m", "sample", "time")
        np.testing.assert_allclose(data["x"].values[1, :, -1], [0.25, 0.5, 1.0], rtol=1e-12)

    def test_a_page_shows_each_run_with_its_input(self, pushed: lagdsl.Model, tmp_path: Path) -> None:
        pytest.importorskip("xarray")
        data = pushed.sweep({}, inputs={"f": [1.0, 2.0]}, **SHORT)
        text = pushed.show(tmp_path / "runs.html", browser=False, sweep=data, stop=1.0).read_text(encoding="utf-8")
        assert '"live":false' in text.replace(" ", "") and "f = 2 N" in text
        tables = pushed.sweep({}, inputs={"f": [RAMP, 1.0]}, **SHORT)
        with pytest.raises(ValueError, match="no tables of `f`"):
            pushed.show(tmp_path / "none.html", browser=False, sweep=tables)

    @pytest.mark.parametrize("given", [{"f": [1.0, 1.0]}, {"f": "1, 1 N"}, {"f": "1, 2"}, {"f": []}, {"f": "1 m"}])
    def test_no_axis(self, pushed: lagdsl.Model, given: Any) -> None:
        pytest.importorskip("xarray")
        with pytest.raises(ValueError, match=r"same value twice|with a unit|has no unit|no values|this is a length"):
            pushed.sweep({}, inputs=given, **SHORT)


@pytest.mark.parametrize("change", [lambda row: row + 1e-12, lambda row: row])
def test_other_tables_are_another_sweep(pushed: lagdsl.Model, tmp_path: Path, change: Callable[[Any], Any]) -> None:
    """Also where long tables differ in the last digits only, which the short text of an array does not tell."""
    pytest.importorskip("xarray")
    compilation = pushed._compilation
    subjects = [SweptModel(flat=compilation.flat, program=compilation.program)]
    times, forces = np.linspace(0, 1, 3000), np.ones(3000)
    options = Options(stop=1.0, interval=0.5, tolerance=None, solver="auto", engine="tape", inputs={})
    plan = Plan(axes=(Axis(name="m", key="m", target="parameter", unit="kg", values=(1.0, 2.0, 3.0)),))

    def stop(part: float) -> None:
        raise KeyboardInterrupt

    work = Work(jobs=1, output=tmp_path / "out.csv")
    with pytest.raises(KeyboardInterrupt):
        sweep(plan, [{}], subjects, replace(options, inputs={"f": (times, forces)}), work, stop)
    assert journal_path(tmp_path / "out.csv").exists()
    forces = forces.copy()
    forces[1500] = change(forces[1500])
    again = replace(options, inputs={"f": (times, forces)})
    if forces[1500] == 1.0:
        assert sweep(plan, [{}], subjects, again, replace(work, resume=True))["x"].shape == (3, 3)
    else:
        with pytest.raises(Unfinished, match="another sweep"):
            sweep(plan, [{}], subjects, again, replace(work, resume=True))
