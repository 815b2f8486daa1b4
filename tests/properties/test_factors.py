"""No motion of the models of models/ changes with a factor of a constraint or a gap, nor with the unit of mass."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from choice import EXPLORE
from properties.test_same_motion import NAMES, ROOT

import lagdsl
import lagdsl.api.compile
from lagdsl.flat.expression import Binary, FlatExpression, Mechanical, Number
from lagdsl.flat.model import FlatModel, FrameTorque, GeneralizedForce, Load, PointForce
from lagdsl.flat.traversal import records
from lagdsl.pipeline import compile_flat

CLAUSES_OF_MULTIPLIERS = {"clutch"}
SMOOTH = ["library/driven_shafts", "library/coupled_circuits"]
SOME = ["library/driven_shafts", "newtons_cradle"]
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


def _in_units_of_mass(flat: FlatModel, factor: float) -> FlatModel:
    """All that forces are proportional to."""

    def by(value: FlatExpression) -> FlatExpression:
        return Binary("*", Number(factor), value)

    def load(one: Load) -> Load:
        match one:
            case PointForce():
                return replace(one, force=by(one.force))
            case FrameTorque():
                return replace(one, torque=by(one.torque))
            case GeneralizedForce():
                return replace(one, value=by(one.value))

    return replace(
        flat,
        energies=tuple(replace(each, value=by(each.value)) for each in flat.energies),
        masses=tuple(replace(each, mass=by(each.mass)) for each in flat.masses),
        bodies=tuple(replace(b, mass=by(b.mass), inertia=tuple(map(by, b.inertia))) for b in flat.bodies),  # type: ignore[arg-type]
        loads=tuple(map(load, flat.loads)),
    )


def _reads_forces(flat: FlatModel) -> bool:
    """What reads forces, energies or momenta is not proportional to them."""
    parts = (flat.loads, flat.events, flat.energies, flat.states, flat.assertions, flat.named)
    return any(isinstance(each, Mechanical) for part in parts for each in records(part))


@pytest.mark.parametrize("factor", [1e-10, 1e10])
@pytest.mark.parametrize("name", NAMES if EXPLORE else SMOOTH)
def test_the_unit_of_mass_changes_no_motion(name: str, factor: float, monkeypatch: pytest.MonkeyPatch) -> None:
    path = ROOT / "models" / f"{name}.lag"
    model = lagdsl.compile(path)
    if not _reads_forces(model._compilation.flat):
        assert_moves_alike(path, lambda flat: _in_units_of_mass(flat, factor), monkeypatch)


@pytest.mark.parametrize("factor", [1e-10, 1e10])
@pytest.mark.parametrize("name", [n for n in (NAMES if EXPLORE else SOME) if n not in CLAUSES_OF_MULTIPLIERS])
def test_factors_change_no_motion(name: str, factor: float, monkeypatch: pytest.MonkeyPatch) -> None:
    path = ROOT / "models" / f"{name}.lag"
    for first in range(min(2, len(lagdsl.compile(path)._compilation.flat.constraints))):
        assert_moves_alike(path, lambda flat, first=first: _scaled(flat, first, factor), monkeypatch)  # type: ignore[misc]


def assert_moves_alike(path: Path, change: Callable[[FlatModel], FlatModel], monkeypatch: pytest.MonkeyPatch) -> None:
    model = lagdsl.compile(path)
    original = model.simulate(tolerance=TOLERANCE)
    with monkeypatch.context() as patch:
        patch.setattr(lagdsl.api.compile, "compile_flat", lambda flat, *more: compile_flat(change(flat), *more))
        motion = lagdsl.compile(path).simulate(tolerance=TOLERANCE)
    assert [(e.name, e.kind) for e in motion.events] == [(e.name, e.kind) for e in original.events]
    for column in model.coordinates:
        limit = NEAR * max(1.0, float(np.max(np.abs(original[column]))))
        assert abs(motion[column][-1] - original[column][-1]) <= limit, column
