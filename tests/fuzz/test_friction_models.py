"""Random models with dry friction: an engine carries out the motion of the formulation that tries all modes."""

from __future__ import annotations

import pytest
from attack.rows import ENGINES
from choice import ALL, EXPLORE
from fuzz.agreement import MOST_GRAZING, Report, told
from fuzz.friction_models import STOP, friction_model
from fuzz.independent import compare_friction

COUNT = 1000 if EXPLORE else 12 if ALL else 1


def _report(seed: int, engine: str) -> Report:
    return compare_friction(friction_model(seed), engine, STOP)  # type: ignore[arg-type]


@pytest.mark.parametrize("engine", ENGINES)
def test_engine_agrees_with_all_modes(engine: str, capsys: pytest.CaptureFixture[str]) -> None:
    reports = {seed: _report(seed, engine) for seed in range(1, COUNT + 1)}
    wrong, grazing = told(engine, reports, capsys)
    assert wrong == {}
    assert len(grazing) <= MOST_GRAZING * max(COUNT, 10)


def test_a_seed_is_one_model() -> None:
    assert friction_model(7) == friction_model(7)
    assert len({friction_model(seed) for seed in range(50)}) == 50
