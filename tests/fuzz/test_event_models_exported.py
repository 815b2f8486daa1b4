"""Random models with events in model exchange, with the exact importer: the motion of `lag run`."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import fmpy
import pytest
from attack.rows import in_bounded_time
from choice import ALL, EXPLORE
from fmi.exact_importer import ends_exactly
from fmi.exported import Exported
from fmi.texts import export_text
from fuzz.event_models import STOP, event_model
from fuzz.harder_models import harder_model

import lagdsl
from lagdsl.motion.simulate.failure import SimulationFailed

COUNT = 300 if EXPLORE else 24 if ALL else 1
SECONDS = 30
# Impacts enlarge differences: two runs at 1e-10 and 1e-11 differ by as much.
NEAR = 1e-6
# Importers step across forces of short ways, not of short times.
NEEDLE = "max(0, 1 - abs(x"
MODELS = {
    **{f"events_{seed}": (event_model(seed), STOP) for seed in range(COUNT)},
    **{
        f"harder_{seed}": (hard.text, hard.stop)
        for seed in range(COUNT)
        for hard in (harder_model(seed),)
        if NEEDLE not in hard.text
    },
}


@pytest.mark.parametrize("name", MODELS)
def test_random_models_move_as_in_a_run(name: str, tmp_path: Path) -> None:
    text, stop = MODELS[name]
    model = lagdsl.compile(text, engine="tape")
    try:
        run = model.simulate(stop=stop, tolerance=1e-11)
    except SimulationFailed as failed:
        assert failed.diagnostics[0].code == "E0834"  # two mechanisms drawn into each other
        return
    export_text(text, tmp_path / "random.fmu", 2 + len(name) % 2)
    fmpy.extract(str(tmp_path / "random.fmu"), str(tmp_path / "unpacked"))
    exported = Exported(tmp_path / "random.fmu", tmp_path / "unpacked")
    names = [*model.coordinates, *(f"der({q})" for q in model.coordinates), *model.states]
    ends = in_bounded_time(partial(ends_exactly, exported, stop, names, {}), SECONDS)
    wrong = {n: (ends[n], run[n][-1]) for n in names if abs(ends[n] - run[n][-1]) > NEAR * max(1.0, abs(run[n][-1]))}
    assert not wrong, text
