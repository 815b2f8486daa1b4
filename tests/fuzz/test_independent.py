"""Random models with events: an engine carries out the motion of an independent formulation, mode by mode."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from attack.rows import ENGINES
from choice import ALL, EXPLORE
from fuzz.agreement import MOST_GRAZING, Report, told
from fuzz.event_models import STOP, event_model
from fuzz.harder_models import harder_model
from fuzz.independent import compare

COUNT = 1000 if EXPLORE else 5 if ALL else 1


def of_events(seed: int, engine: str) -> Report:
    return compare(event_model(seed), engine, STOP)  # type: ignore[arg-type]


def of_what_is_hard(seed: int, engine: str) -> Report:
    hard = harder_model(seed)
    return compare(hard.text, engine, hard.stop, hard.known, hard.scales)  # type: ignore[arg-type]


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("kind", [of_events, of_what_is_hard], ids=lambda kind: kind.__name__)
def test_engine_agrees_with_the_oracle(
    kind: Callable[[int, str], Report], engine: str, capsys: pytest.CaptureFixture[str]
) -> None:
    reports = {seed: kind(seed, engine) for seed in range(COUNT)}
    wrong, grazing = told(engine, reports, capsys)
    assert wrong == {}
    assert len(grazing) <= MOST_GRAZING * COUNT


def test_a_seed_is_one_model() -> None:
    assert harder_model(7) == harder_model(7)
    assert len({harder_model(seed).text for seed in range(50)}) == 50
