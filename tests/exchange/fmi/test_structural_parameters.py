"""Structural parameters in FMUs: parameters where they shape nothing, else numbers, which a note tells."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from choice import chosen
from fmpy import read_model_description, simulate_fmu

import lagdsl
from fmi.exported import VERSIONS, Exported, exported
from fmi.texts import exported_text
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.fmi.structural_parameters import with_structural_parameters
from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.api.model import Model

ROOT = Path(__file__).parents[3]
WHEEL = "rimless_wheel"

PLANT = """
model Plant
  structural parameter Integer N = 2 "a size";
  structural parameter Integer power = 2 "an exponent";
  structural parameter Boolean heavy = true "decides what there is";
  structural parameter Real half = 0.5 "of another structural parameter";
  structural parameter Real quarter = half/2 "stands as a number";
  structural parameter Real least = -3 "the minimum of an input";
  structural parameter Real A[2, 2] = {{0, 1}, {-4, -0.4}} "numbers of linear equations";
  structural parameter Integer teeth = 12 "counts";
  structural parameter Length place = 2 m "of the start";
  constant Real two = 2;
  input Real u(min = least) = 1;
  coordinate Length x[N](start = {place, 1 m});
  state Real z[2](start = {1, 0});
  for i in 1:N loop
    mass teeth*quarter/3*(1 kg) at {x[i], 0};
    force -(1 N)*u*(x[i]/(1 m))^power on x[i];
  end for;
  mass 1 kg at {x[1], 0} if heavy;
  gravity = {0, 0};
equation
  der(z[1]) = (A[1, 1]*z[1] + A[1, 2]*z[2])/(1 s);
  der(z[2]) = (A[2, 1]*z[1] + A[2, 2]*z[2])/(1 s);
  annotation(experiment(StopTime = 1));
end Plant;
"""
LOOSE = {"quarter", "A[1,1]", "A[1,2]", "A[2,1]", "A[2,2]", "teeth", "place"}
FOLDED = {"N", "power", "heavy", "half", "least"}


def steps(rows: Any) -> list[float]:
    return [float(rows[name][-1]) for name in ("theta", "der(theta)", "steps")]


@cache
def walked(spokes: int) -> list[float]:
    """By a compiler that has folded the number into the equations."""
    model = lagdsl.compile(ROOT / "models" / f"{WHEEL}.lag", structural={"n": spokes}, engine="tape")
    return steps(model.simulate(tolerance=1e-10))


@pytest.mark.parametrize(
    ("version", "kind"),
    chosen(
        [(version, kind) for version in VERSIONS for kind in ("ModelExchange", "CoSimulation")],
        [(2, "CoSimulation"), (3, "ModelExchange")],
    ),
)
def test_a_wheel_with_another_number_of_spokes(version: int, kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    fmu: Exported = exported(WHEEL, version)
    n = fmu.variables["n"]
    assert (n.causality, n.variability, float(n.start)) == ("parameter", "tunable", 8.0)
    found = {}
    for spokes in (9, 8):
        rows = simulate_fmu(
            str(fmu.folder),
            validate=False,
            model_description=fmu.description,
            fmi_type=kind,
            stop_time=6.0,
            output_interval=0.1,
            relative_tolerance=1e-10,
            start_values={"n": spokes},
            output=["theta", "der(theta)", "steps"],
        )
        found[spokes] = steps(rows)
        assert found[spokes] == pytest.approx(walked(spokes), rel=1e-6)
    capsys.readouterr()
    assert found[9][2] > found[8][2]


@pytest.mark.parametrize("version", VERSIONS)
def test_what_shapes_the_model_stays_a_number(version: int) -> None:
    fmu = exported_text(PLANT, version, scalar=True)
    kinds = {name: (each.causality, each.variability) for name, each in fmu.variables.items()}
    assert {name for name in kinds if kinds[name][0] == "parameter"} - {"solver.step"} == LOOSE
    assert {name for name, kind in kinds.items() if kind[1] == "constant"} == {*FOLDED, "two"}
    assert kinds["teeth"] == ("parameter", "tunable") and kinds["place"] == ("parameter", "fixed")


def test_numbers_are_told() -> None:
    sink = Sink()
    compilation = lagdsl.compile(PLANT)._compilation
    changed = with_structural_parameters(compilation, sink)
    (note,) = sink.diagnostics
    assert note.code == "N0928"
    assert note.message == "fixed numbers of the FMU, not parameters of it: `N`, `power`, `heavy`, `half`, `least`"
    assert {each.name for each in changed.flat.parameters if not each.structural} == LOOSE


def test_the_equations_are_the_same() -> None:
    """Accelerations and rates at random states, as of the model with folded numbers."""
    compilation = lagdsl.compile(PLANT)._compilation
    changed = with_structural_parameters(compilation, Sink())
    random = np.random.default_rng(2)
    folded, loose = (Model(each, engine_of(each.program, "tape")) for each in (compilation, changed))
    for _ in range(5):
        q, qd, z = random.normal(size=(3, 2))
        found = [model.forward_dynamics(0.0, q, qd, z=z, u=[1.5]) for model in (folded, loose)]
        np.testing.assert_allclose(found[0], found[1], rtol=1e-14)


def test_other_numbers_and_starts_are_defaults(tmp_path: Path) -> None:
    """A size and a start of `--set`, a structural parameter of the FMU with another value."""
    model = lagdsl.compile(
        PLANT.replace("start = {place, 1 m}", "each start = place"), structural={"N": 3, "teeth": 24}
    )
    model.export_fmu(tmp_path / "Plant.fmu", start={"x[2]": 5.0})
    variables = {each.name: each for each in read_model_description(str(tmp_path / "Plant.fmu")).modelVariables}
    assert float(variables["teeth"].start) == 24 and variables["teeth"].causality == "parameter"
    assert float(variables["x[2]"].start) == 5.0 and float(variables["x[3]"].start) == 2.0
