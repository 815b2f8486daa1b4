"""Steps 6 to 8 of the recipe: what acts, how its place moves with one coordinate at a time, whether that is work."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import assert_never

from sympy import Expr, Symbol

from lagdsl.derivation.textbook import geometry
from lagdsl.derivation.textbook.contributions import (
    Applied,
    AppliedForce,
    AppliedGeneralizedForce,
    AppliedRateForce,
    AppliedTorque,
    admissible_variation,
    work,
)
from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.geometry import Vector
from lagdsl.derivation.textbook.reading import Reading
from lagdsl.derivation.textbook.tidy import size

_LONGEST_PLACE = 60
"""Nodes of a coordinate of a place that is compared with others by value."""


class Contribution(StrEnum):
    """Effect of an action: it contributes to the equations, or the reason why it does not."""

    CONTRIBUTES = "contributes"
    PLACE_HELD = "no admissible motion moves its place"
    PERPENDICULAR = "perpendicular to every admissible motion of its place"
    ZERO = "zero"


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionStep:
    """One thing that acts: `load` is the index of the load in the flat model, `back` marks the reaction at `from`.
    `carrier` is the index of the mass or body whose centre a force acts on, or on whose frame a torque does.

    `variations` and `works` have one entry per coordinate: dr/dq_j (or domega/dqd_j, dx/dq_j) and F . dr/dq_j.
    """

    load: int
    back: bool
    action: Applied
    variations: tuple[Vector | Expr, ...]
    works: tuple[Expr, ...]
    contribution: Contribution
    carrier: int | None


def action_steps(reading: Reading) -> tuple[ActionStep, ...]:
    """Actions in the order of the loads."""
    return tuple(_action(reading, *each) for each in _numbered(reading))


def _numbered(reading: Reading) -> list[tuple[int, bool, Applied]]:
    return [
        (load, position > 0, action)
        for load, actions in enumerate(reading.parts.actions)
        for position, action in enumerate(actions)
    ]


def _action(reading: Reading, load: int, back: bool, action: Applied) -> ActionStep:
    tidy, table, converter = reading.tidy, reading.symbols, reading.parts.converter
    variations = []
    for q, qd in zip(table.q, table.qd, strict=True):
        variation = admissible_variation(action, converter, q, qd)
        variations.append(geometry.each(tidy, variation) if isinstance(variation, tuple) else tidy(variation))
    works = tuple(tidy(work(action, variation)) for variation in variations)
    return ActionStep(
        load=load,
        back=back,
        action=action,
        variations=tuple(variations),
        works=works,
        contribution=_contribution(action, variations, works),
        carrier=_carrier(reading, action, variations),
    )


def _carrier(reading: Reading, action: Applied, variations: Sequence[Vector | Expr]) -> int | None:
    """The first mass or body there. A material point that its frame takes elsewhere is another one."""
    inertials = reading.parts.inertials
    match action:
        case AppliedForce(position=position, frame=frame):
            moved = (_moved(reading, position, q) for q in reading.symbols.q)
            if frame is not None and tuple(moved) != tuple(variations):
                return None
            return next((k for k, each in enumerate(inertials) if _same(reading, each.position, position)), None)
        case AppliedTorque(frame=frame):
            return next((k for k, each in enumerate(inertials) if each.frame == frame), None)
        case AppliedGeneralizedForce() | AppliedRateForce():
            return None
        case _:
            assert_never(action)


def _moved(reading: Reading, position: Vector, q: Symbol) -> Vector:
    return geometry.each(lambda x: reading.tidy(partial(x, q)), position)


def _same(reading: Reading, one: Vector, other: Vector) -> bool:
    if one == other:
        return True
    short = all(size(each) < _LONGEST_PLACE for each in (*one, *other))
    return short and all(reading.tidy(a - b) == 0 for a, b in zip(one, other, strict=True))


def _contribution(action: Applied, variations: Sequence[Vector | Expr], works: Sequence[Expr]) -> Contribution:
    if any(value != 0 for value in works):
        return Contribution.CONTRIBUTES
    if not any(component != 0 for variation in variations for component in _components(variation)):
        return Contribution.PLACE_HELD
    amounts = work(action, (Symbol("x"), Symbol("y"), Symbol("z")) if _is_vector(variations[0]) else Symbol("x"))
    return Contribution.PERPENDICULAR if amounts != 0 else Contribution.ZERO


def _components(value: Vector | Expr) -> tuple[Expr, ...]:
    return value if isinstance(value, tuple) else (value,)


def _is_vector(value: Vector | Expr) -> bool:
    return isinstance(value, tuple)
