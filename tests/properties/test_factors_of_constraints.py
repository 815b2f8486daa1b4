"""A factor of a constraint or of the gap of a contact changes no motion of the models of models/."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from choice import EXPLORE
from properties.test_same_motion import NAMES, ROOT

import lagdsl
import lagdsl.api.compile
from lagdsl.flat.expression import Binary, FlatExpression, Number
from lagdsl.flat.model import FlatModel
from lagdsl.pipeline import compile_flat

CLAUSES_OF_MULTIPLIERS = {"clutch"}
SOME = ["library/driven_shafts", "newtons_cradle", "rolling_coin", "andrews_squeezer"]
TOLERANCE, NEAR = 1e-9, 1e-6


def _scaled(flat: FlatModel, first: int, factor: float) -> FlatModel:
    """Every other constraint, from the first or the second on; a gap as its row."""

    def by(value: FlatExpression) -> FlatExpression:
        return Binary("*", Number(factor), value)

    chosen = {each.name for each in flat.constraints[first::2]}
    constraints = [
        replace(each, residuals=tuple(map(by, each.residuals))) if each.name in chosen else each
        for each in flat.constraints
    ]
    contacts = [
        replace(each, gap=by(each.gap), capture_speed=each.capture_speed and by(each.capture_speed))
        if each.name in chosen
        else each
        for each in flat.events.contacts
    ]
    return replace(flat, constraints=tuple(constraints), events=replace(flat.events, contacts=tuple(contacts)))


@pytest.mark.parametrize("factor", [1e-10, 1e10])
@pytest.mark.parametrize("name", [n for n in (NAMES if EXPLORE else SOME) if n not in CLAUSES_OF_MULTIPLIERS])
def test_factors_change_no_motion(name: str, factor: float, monkeypatch: pytest.MonkeyPatch) -> None:
    path = ROOT / "models" / f"{name}.lag"
    model = lagdsl.compile(path)
    original = model.simulate(tolerance=TOLERANCE)
    for first in range(min(2, len(model._compilation.flat.constraints))):

        def compiled(flat: FlatModel, *more: Any, first: int = first) -> Any:
            return compile_flat(_scaled(flat, first, factor), *more)

        monkeypatch.setattr(lagdsl.api.compile, "compile_flat", compiled)
        motion = lagdsl.compile(path).simulate(tolerance=TOLERANCE)
        assert [(e.name, e.kind) for e in motion.events] == [(e.name, e.kind) for e in original.events]
        for column in model.coordinates:
            limit = NEAR * max(1.0, float(np.max(np.abs(original[column]))))
            assert abs(motion[column][-1] - original[column][-1]) <= limit, column
