"""Random models with dry friction: an engine carries out the motion of the independent formulation that tries all modes."""

from __future__ import annotations

from collections import Counter

import pytest
from attack.rows import ENGINES
from choice import ALL, EXPLORE
from fuzz.friction_models import STOP, friction_model
from fuzz.independent import compare_friction

COUNT = 1000 if EXPLORE else 12 if ALL else 1
MOST_GRAZING = 0.1


@pytest.mark.parametrize("engine", ENGINES)
def test_engine_agrees_with_all_modes(engine: str, capsys: pytest.CaptureFixture[str]) -> None:
    reports = {seed: compare_friction(friction_model(seed), engine, STOP) for seed in range(1, COUNT + 1)}  # type: ignore[arg-type]
    wrong = {seed: report for seed, report in reports.items() if report.verdict not in ("same", "grazing")}
    grazing = {seed: report.why for seed, report in reports.items() if report.verdict == "grazing"}
    with capsys.disabled():
        counts = Counter(report.verdict for report in reports.values())
        print(f"\n{engine}: {dict(counts)}", *(f"grazing {seed}: {why}" for seed, why in grazing.items()), sep="\n")
    assert wrong == {}
    assert len(grazing) <= MOST_GRAZING * max(COUNT, 10)


def test_a_seed_is_one_model() -> None:
    assert friction_model(7) == friction_model(7)
    assert len({friction_model(seed) for seed in range(50)}) == 50
