"""Random models with events: an engine carries out the motion of an independent formulation, mode by mode."""

from __future__ import annotations

import os
from collections import Counter

import pytest
from attack.rows import ENGINES
from fuzz.event_models import STOP, event_model
from fuzz.independent import compare

EXPLORE = bool(os.environ.get("LAGDSL_EXPLORE"))
COUNT = 1000 if EXPLORE else 12
MOST_GRAZING = 0.1


@pytest.mark.parametrize("engine", ENGINES)
def test_engine_agrees_with_the_oracle(engine: str, capsys: pytest.CaptureFixture[str]) -> None:
    reports = {seed: compare(event_model(seed), engine, STOP) for seed in range(COUNT)}  # type: ignore[arg-type]
    wrong = {seed: report for seed, report in reports.items() if report.verdict not in ("same", "grazing")}
    grazing = {seed: report.why for seed, report in reports.items() if report.verdict == "grazing"}
    with capsys.disabled():
        counts = Counter(report.verdict for report in reports.values())
        print(f"\n{engine}: {dict(counts)}", *(f"grazing {seed}: {why}" for seed, why in grazing.items()), sep="\n")
    assert wrong == {}
    assert len(grazing) <= MOST_GRAZING * COUNT
