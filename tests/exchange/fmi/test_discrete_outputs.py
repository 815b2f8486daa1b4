"""Outputs that are discrete variables, against a closed form: a body at constant speed whose place is sampled."""

from __future__ import annotations

import xml.etree.ElementTree as ET
import zipfile
from functools import cache
from pathlib import Path

import fmpy
import numpy as np
import pytest

import lagdsl
from fmi.texts import export_text
from lagdsl.documents.plot.picture.recording import prepare, recorded
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.engines.backends.modelica.emit import ModelicaBackend
from lagdsl.engines.backends.start import start_of
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.motion.simulate.initialize import initial_state

SPEED, PERIOD, STOP = 2.0, 0.25, 1.1
TEXT = """
model Rig
  model Meter "Holds a place"
    input Length x;
    discrete output Length y(start = 0 m, min = 0 m) "sampled";
    discrete output Boolean far(start = false);
    discrete Integer ticks(start = 0);
    when sample(0 s, 0.25 s) then
      y = x;
      far = x > 1.2 m;
      ticks = pre(ticks) + 1;
    end when;
  end Meter;
  coordinate Length s(der(start = 2 m/s));
  kinetic 1/2*(1 kg)*der(s)^2;
  Meter meter(x = s);
  discrete output Integer n[2](start = {0, 10});
  output Length twice = 2*meter.y;
  when sample(0 s, 0.25 s) then
    n[1] = pre(n[1]) + 1;
    n[2] = pre(n[2]) - 1;
  end when;
  annotation(experiment(StopTime = 1.1));
end Rig;
"""
OUTPUTS = ["meter.y", "meter.far", "n[1]", "n[2]", "twice"]


@cache
def rig() -> lagdsl.Model:
    return lagdsl.compile(TEXT)


def held(t: np.ndarray) -> dict[str, np.ndarray]:
    """Values after the last tick, at times between ticks."""
    ticks = np.floor(t / PERIOD)
    place = SPEED * PERIOD * ticks
    return {"meter.y": place, "meter.far": place > 1.2, "n[1]": ticks + 1, "n[2]": 9 - ticks, "twice": 2 * place}


def test_they_are_outputs_and_columns_once() -> None:
    motion = rig().simulate(interval=0.1)
    assert rig().outputs == OUTPUTS
    assert motion.names == ("time", "s", "der(s)", "meter.ticks", *OUTPUTS)
    between = np.abs(motion.time / PERIOD - np.round(motion.time / PERIOD)) > 1e-9
    for name, values in held(motion.time).items():
        np.testing.assert_allclose(motion[name][between], values[between], atol=1e-12, err_msg=name)
    column = motion.column("meter.y")
    assert (column.lowest, column.highest) == (0.0, pytest.approx(2.0))
    assert motion.energy[-1] == pytest.approx(2.0)


def test_runs_of_a_sweep_have_the_columns_of_one_run() -> None:
    single = rig().simulate(interval=0.1)
    many = rig().simulate_many(start={"s": [0.0, 0.0]}, stop=STOP, interval=0.1)
    assert set(OUTPUTS) <= set(many.columns)
    grid = [k for k, t in enumerate(single.time) if k == 0 or t > single.time[k - 1]]
    for name in single.names[1:]:
        np.testing.assert_allclose(many[name][1][: len(grid)][-1], single[name][-1], atol=1e-9, err_msg=name)


def test_a_linearization_holds_them() -> None:
    found = rig().linearize()
    assert [each.name for each in found.outputs] == OUTPUTS
    assert not found.C.any()


@pytest.mark.parametrize("version", [2, 3])
def test_an_fmu_has_them_as_discrete_outputs(version: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "rig.fmu"
    export_text(TEXT, path, version)
    root = ET.fromstring(zipfile.ZipFile(path).read("modelDescription.xml"))
    told = {each.get("name"): each for each in root.iter() if each.get("causality") == "output"}
    arrays = ["n"] if version == 3 else ["n[1]", "n[2]"]
    assert list(told) == ["meter.y", "meter.far", *arrays, "twice"]
    assert [each.get("variability") for each in told.values()] == ["discrete"] * (len(told) - 1) + ["continuous"]
    assert [name for name, each in told.items() if each.get("intermediateUpdate")] == ["twice"] * (version == 3)
    for kind in ("CoSimulation", "ModelExchange"):
        rows = fmpy.simulate_fmu(str(path), fmi_type=kind, stop_time=STOP, output_interval=0.1, step_size=0.001)
        for name, values in held(np.array([STOP])).items():
            if name in rows.dtype.names:
                assert rows[name][-1] == pytest.approx(values[0], abs=1e-6), (kind, name)
        if version == 3:
            np.testing.assert_array_equal(rows["n"][-1], [5, 5])
    capsys.readouterr()


def test_modelica_has_them_as_discrete_outputs() -> None:
    compilation = rig()._compilation
    initial = initial_state(compilation.flat, engine_of(compilation.program, "tape"))
    start = start_of(compilation.flat, initial.t, initial.x.tolist())
    backend = ModelicaBackend(compilation.equations, compilation.structure, start)
    ((_, text),) = backend.emit(compilation.program).files.items()
    assert "discrete output Real 'meter.y'(start = 0, fixed = true" in text
    assert "output Boolean 'meter.far'(start = false" in text
    assert text.count("'meter.y' = ") == 1


def test_a_page_has_one_column_for_each() -> None:
    made = recorded(prepare(rig()._compilation.flat), Wishes(), rows=12)
    names = [column.name for column in made.motion.columns]
    assert [names.count(name) for name in OUTPUTS] == [1] * len(OUTPUTS)
    assert made.motion.columns[names.index("meter.y")].values[-1] == pytest.approx(2.0)
