"""Changes that no motion of the models of models/ may notice.

A factor of a constraint or of a gap, another unit of mass, other directions and units of coordinates, a later start,
and the rate of a function of coordinates and time in the Lagrangian (Landau and Lifshitz, Mechanics, section 2).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from choice import EXPLORE
from properties.test_same_motion import NAMES, ROOT

import lagdsl
import lagdsl.interfaces.api.compile
from lagdsl.language.flat.events import Reset
from lagdsl.language.flat.expression import (
    AdmissibleMotion,
    Binary,
    Derivative,
    FlatExpression,
    Function,
    GeneralizedMomentum,
    Mechanical,
    Number,
    Variable,
)
from lagdsl.language.flat.model import EnergyTerm, FlatModel, FrameTorque, GeneralizedForce, Load, PointForce
from lagdsl.language.flat.traversal import records, substituted
from lagdsl.motion.pipeline import compile_flat

CLAUSES_OF_MULTIPLIERS = {"clutch"}
# Balls that touch at the start: their gaps are round-off, which an angle in other units has elsewhere.
TOUCHING = {"newtons_cradle"}
SMOOTH = ["library/driven_shafts", "library/coupled_circuits"]
SOME = ["library/driven_shafts", "newtons_cradle"]
TOLERANCE, NEAR = 1e-9, 1e-6


def _times(factor: float) -> Callable[[FlatExpression], FlatExpression]:
    return lambda value: Binary("*", Number(factor), value)


def _scaled(flat: FlatModel, first: int, factor: float) -> FlatModel:
    """Every other constraint, from the first or the second on; a gap as its row."""
    by = _times(factor)
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
    by = _times(factor)

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
    """True where an expression names forces, energies or momenta: it is not proportional to them."""
    parts = (flat.loads, flat.events, flat.energies, flat.states, flat.assertions, flat.named)
    return any(isinstance(each, Mechanical) for part in parts for each in records(part))


@pytest.mark.parametrize("factor", [1e-10, 1e10])
@pytest.mark.parametrize("name", NAMES if EXPLORE else SMOOTH)
def test_the_unit_of_mass_changes_no_motion(name: str, factor: float, monkeypatch: pytest.MonkeyPatch) -> None:
    path = ROOT / "models" / f"{name}.lag"
    model = lagdsl.compile(path)
    if not _reads_forces(model._compilation.flat):
        assert_moves_alike(path, lambda flat: _in_units_of_mass(flat, factor), monkeypatch)


def _in_units_of_coordinates(flat: FlatModel, unit: float, sizes: Mapping[str, float]) -> FlatModel:
    """x = unit*x'; a negative one turns the directions around."""
    values = {each.name: Binary("*", Number(unit), Variable(each.name)) for each in flat.coordinates}

    def bound(value: float | None) -> float | None:
        return None if value is None else value / unit

    coordinates = [
        replace(
            each,
            start=Binary("/", each.start, Number(unit)),
            rate_start=Binary("/", each.rate_start, Number(unit)),
            nominal=(each.nominal or sizes[each.name]) / abs(unit),
            minimum=bound(each.minimum if unit > 0 else each.maximum),
            maximum=bound(each.maximum if unit > 0 else each.minimum),
        )
        for each in flat.coordinates
    ]
    return replace(substituted(replace(flat, coordinates=()), values), coordinates=tuple(coordinates))


def _names_coordinates(flat: FlatModel) -> bool:
    """Such items would have to be changed, too."""
    named = (GeneralizedMomentum, AdmissibleMotion, Reset)
    return any(isinstance(each, named) for each in records(flat))


@pytest.mark.parametrize("unit", [-0.37, 1e-6])
@pytest.mark.parametrize("name", NAMES if EXPLORE else ["double_pendulum", "library/planar_trammel"])
def test_units_and_directions_of_coordinates_change_no_motion(
    name: str, unit: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = ROOT / "models" / f"{name}.lag"
    model = lagdsl.compile(path)
    flat, sizes = model._compilation.flat, model._compilation.structure.space.sizes
    if not _names_coordinates(flat) and name not in TOUCHING:
        named = dict(zip(model.coordinates, sizes.tolist(), strict=True))
        assert_moves_alike(path, lambda flat: _in_units_of_coordinates(flat, unit, named), monkeypatch, unit)


def _later(flat: FlatModel, by: float) -> FlatModel:
    new = substituted(flat, {"time": Binary("-", Variable("time"), Number(by))})
    clocks = tuple(replace(each, start=Binary("+", each.start, Number(by))) for each in new.events.clocks)
    experiment = flat.experiment
    times = {"start_time": experiment.start_time + by, "stop_time": experiment.stop_time + by}
    return replace(new, events=replace(new.events, clocks=clocks), experiment=replace(experiment, **times))


@pytest.mark.parametrize("by", [64.0, -1024.0])
@pytest.mark.parametrize("name", NAMES if EXPLORE else ["kapitza_pendulum", "valve_train"])
def test_a_later_start_changes_no_motion(name: str, by: float, monkeypatch: pytest.MonkeyPatch) -> None:
    assert_moves_alike(ROOT / "models" / f"{name}.lag", lambda flat: _later(flat, by), monkeypatch)


def _gauged(flat: FlatModel) -> FlatModel:
    """With dF/dt of F = 0.3 (sin(x) y + x t), x the first coordinate and y the last."""
    x, y = (Variable(each.name) for each in (flat.coordinates[0], flat.coordinates[-1]))
    turned = Binary("*", Binary("*", Function("cos", (x,)), Derivative(x)), y)
    along = Binary("*", Function("sin", (x,)), Derivative(y))
    moved = Binary("+", x, Binary("*", Derivative(x), Variable("time")))
    rate = Binary("*", Number(0.3), Binary("+", Binary("+", turned, along), moved))
    term = EnergyTerm(kind="lagrangian", label=None, value=rate, spans=flat.coordinates[0].spans)
    return replace(flat, energies=(*flat.energies, term), invariants=())


@pytest.mark.parametrize("name", NAMES if EXPLORE else ["newtons_cradle", "rolling_coin"])
def test_the_rate_of_a_function_in_the_lagrangian_changes_no_motion(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    path = ROOT / "models" / f"{name}.lag"
    flat = lagdsl.compile(path)._compilation.flat
    if flat.coordinates and not _reads_forces(flat):
        assert_moves_alike(path, _gauged, monkeypatch)


@pytest.mark.parametrize("factor", [1e-10, 1e10])
@pytest.mark.parametrize("name", [n for n in (NAMES if EXPLORE else SOME) if n not in CLAUSES_OF_MULTIPLIERS])
def test_factors_change_no_motion(name: str, factor: float, monkeypatch: pytest.MonkeyPatch) -> None:
    path = ROOT / "models" / f"{name}.lag"
    for first in range(min(2, len(lagdsl.compile(path)._compilation.flat.constraints))):
        assert_moves_alike(path, lambda flat, first=first: _scaled(flat, first, factor), monkeypatch)  # type: ignore[misc]


def assert_moves_alike(
    path: Path, change: Callable[[FlatModel], FlatModel], monkeypatch: pytest.MonkeyPatch, unit: float = 1.0
) -> None:
    model = lagdsl.compile(path)
    original = model.simulate(tolerance=TOLERANCE)
    with monkeypatch.context() as patch:
        changed = lambda flat, *more: compile_flat(change(flat), *more)  # noqa: E731
        patch.setattr(lagdsl.interfaces.api.compile, "compile_flat", changed)
        motion = lagdsl.compile(path).simulate(tolerance=TOLERANCE)
    assert [(e.name, e.kind) for e in motion.events] == [(e.name, e.kind) for e in original.events]
    for column in model.coordinates:
        limit = NEAR * max(1.0, float(np.max(np.abs(original[column]))))
        assert abs(unit * motion[column][-1] - original[column][-1]) <= limit, column
