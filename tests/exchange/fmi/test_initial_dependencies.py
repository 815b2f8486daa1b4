"""The description lists every dependency on values that are known before initialization."""

from __future__ import annotations

import os

import numpy as np
import pytest
from models.corpus import MODELS

from fmi.exported import Exported, exported
from fmi.importing import exchanged

NAMES = ("cart_double_pendulum", "four_bar", "clutch", "newtons_cradle")
EVERY = tuple(MODELS) if os.environ.get("LAGDSL_EXPLORE") else NAMES


def started(fmu: Exported, values: dict[str, float], unknowns: list[str]) -> dict[str, float] | None:
    """Unknowns after initialization; None where nothing starts from the values, or not by one way."""
    try:
        with exchanged(fmu) as instance:
            instance.initialize(values)
            return dict(zip(unknowns, instance.get(*unknowns).tolist(), strict=True))
    except Exception:
        return None


@pytest.mark.parametrize("name", EVERY)
def test_nothing_moves_that_is_not_told(name: str) -> None:
    fmu = exported(name, 2)
    told = {
        unknown.variable.name: {other.name for other in unknown.dependencies}
        for unknown in fmu.description.initialUnknowns
    }
    unknowns = list(told)
    before = started(fmu, {}, unknowns)
    assert before is not None
    known = [
        v
        for v in fmu.description.modelVariables
        if v.type == "Real" and (v.causality == "input" or (v.initial == "exact" and v.variability != "constant"))
    ]
    moved = 0
    for variable in known if len(known) <= 40 else np.random.default_rng(3).permutation(known)[:40]:
        value = float(variable.start)
        if variable.name.startswith("solver") or not np.isfinite(value):
            continue
        after = started(fmu, {variable.name: value * 1.01 + 1e-3}, unknowns)
        if after is None:
            continue
        for unknown in unknowns:
            size = max(abs(before[unknown]), abs(after[unknown]), 1.0)
            if abs(after[unknown] - before[unknown]) > 1e-7 * size:
                moved += 1
                assert variable.name in told[unknown], f"{unknown} follows {variable.name}"
    assert moved or name not in NAMES  # of some nothing but what is given enters
