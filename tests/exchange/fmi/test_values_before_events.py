"""`pre`, `edge` and `change` of inputs and of names that read nothing else: counts that are known beforehand, in `lag
run` and in FMUs fed by FMPy. tests/engines/backends/test_modelica.py has those of Rumoca."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from choice import engines
from fmpy import simulate_fmu

import lagdsl
from fmi.exported import VERSIONS
from fmi.texts import exported_text
from lagdsl.language.flat.text import flat_text

SHIFTS = """
type Mode = enumeration(off, slow, fast);
model Shifts
  input Integer gear(min = 0, max = 9) = 2;
  input Mode mode = Mode.off;
  input Boolean brake = false;
  input Integer teeth[2] = {10, 20};
  Integer twice = 2*gear;
  discrete Integer shifts(start = 0), last(start = 0), doubled(start = 0), wheel(start = 0);
  discrete Integer switches(start = 0), presses(start = 0), releases(start = 0);
  coordinate Length x(start = 1 m);
  mass 1 kg at {x, 0};
  force 1 N on x;
  gravity = {0, 0};
equation
  when change(gear) then
    shifts = pre(shifts) + 1;
    last = pre(gear);
  end when;
  when change(twice) then
    doubled = pre(twice);
  end when;
  when change(teeth[2]) then
    wheel = pre(teeth[2]);
  end when;
  when change(mode) then
    switches = pre(switches) + 1;
  end when;
  when edge(brake) then
    presses = pre(presses) + 1;
  end when;
  when not brake and pre(brake) then
    releases = pre(releases) + 1;
    reinit(der(x), 0);
  end when;
end Shifts;
"""
NAMES = ("gear", "mode", "brake", "teeth[1]", "teeth[2]")
ROWS = [
    (0.0, 2, 1, 0, 10, 20),
    (0.2, 2, 1, 1, 10, 20),
    (0.3, 5, 1, 1, 11, 20),  # the other wheel has no clause
    (0.5, 5, 3, 0, 11, 24),  # three at once; the brake lets go
    (0.6, 5, 3, 1, 11, 24),
    (0.9, 7, 3, 1, 11, 24),
    (1.0, 7, 3, 1, 11, 24),
]
COUNTS = {"shifts": 2, "last": 5, "doubled": 10, "wheel": 20, "switches": 1, "presses": 2, "releases": 1}
DISTANCE = 1 + 0.5**2 / 2 + 0.5**2 / 2  # the mass stands when the brake lets go


def counts(rows: Any) -> dict[str, int]:
    return {name: int(rows[name][-1]) for name in COUNTS}


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))
def test_lag_run(engine: Any) -> None:
    times, *values = map(list, zip(*ROWS, strict=True))
    given = {name: (times, column) for name, column in zip(NAMES, values, strict=True)}
    motion = lagdsl.compile(SHIFTS, engine=engine).simulate(stop=1.0, interval=0.05, inputs=given)
    assert counts(motion) == COUNTS
    assert motion["x"][-1] == pytest.approx(DISTANCE, rel=1e-9)
    at = {name: float(motion.time[np.flatnonzero(np.diff(motion[name]))[-1] + 1]) for name in COUNTS}
    assert at == pytest.approx(
        {"shifts": 0.9, "last": 0.9, "doubled": 0.9, "wheel": 0.5, "switches": 0.5, "presses": 0.6, "releases": 0.5}
    )


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("kind", ["ModelExchange", "CoSimulation"])
def test_an_fmu_fed_by_fmpy(version: int, kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    fmu = exported_text(SHIFTS, version, scalar=True)  # FMPy changes no array of Integers
    types = {"brake": bool}
    table = np.array(ROWS, dtype=[("time", float), *((name, types.get(name, int)) for name in NAMES)])
    rows = simulate_fmu(
        str(fmu.folder),
        validate=False,
        model_description=fmu.description,
        fmi_type=kind,
        stop_time=1.0,
        output_interval=0.05,
        relative_tolerance=1e-8,
        input=table,
        output=[*COUNTS, "x"],
    )
    capsys.readouterr()
    assert counts(rows) == COUNTS
    assert rows["x"][-1] == pytest.approx(DISTANCE, rel=1e-6)


def test_texts_name_what_is_read() -> None:
    compilation = lagdsl.compile(SHIFTS)._compilation
    text = flat_text(compilation.flat)
    assert "value gear: gear" in text
    assert "last = pre(gear)" in text and "when gear <> pre(gear) then" in text
