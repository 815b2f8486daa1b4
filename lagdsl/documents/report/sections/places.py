"""One name for each place that a load acts on: that of the mass or body that is there, else its own."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sympy import Symbol

from lagdsl.derivation.textbook.contributions import (
    AppliedForce,
    AppliedGeneralizedForce,
    AppliedRateForce,
    AppliedTorque,
)
from lagdsl.derivation.textbook.steps.actions import ActionStep
from lagdsl.documents.report.boxes import Box, Number, Subscript
from lagdsl.documents.report.names import indexed
from lagdsl.documents.report.notation import name_box
from lagdsl.documents.report.page import Page
from lagdsl.language.flat.expression import FlatExpression, FrameOrigin, PointReference
from lagdsl.language.flat.model import FrameTorque, Load, PointForce


@dataclass(frozen=True, slots=True)
class Place:
    """`name` is a position, an angular velocity, or the scalar that is moved; `is_known` if an earlier line has it."""

    name: Box
    is_known: bool


def places_of(page: Page) -> list[Place]:
    """One for each action, in order; the same name for the same place that moves in the same way."""
    labels = [label for label, _ in page.inertial_elements()]
    letters = {letter: [indexed(_letter(page, letter), label) for label in labels] for letter in "rω"}
    taken: dict[Box, object] = {}
    found = []
    what: tuple[object, ...]
    for step in page.derivation.actions:
        match step.action:
            case AppliedGeneralizedForce(target=target) if isinstance(target, Symbol):
                found.append(Place(page.notation.of(target), True))
                continue
            case AppliedForce(position=position):
                letter, what = "r", (position, step.variations)
            case AppliedTorque(frame=frame):
                letter, what = "ω", (frame,)
            case AppliedGeneralizedForce(target=target):
                letter, what = "x", (target,)
            case AppliedRateForce(rate=rate):
                letter, what = "v", (rate,)
        if step.carrier is not None:
            found.append(Place(letters[letter][step.carrier], True))
            continue
        others = letters.get(letter, [])
        names = (name for name in _names(page, step, letter) if name not in others and taken.get(name, what) == what)
        name = next(names)
        found.append(Place(name, name in taken))
        taken[name] = what
    return found


def _letter(page: Page, letter: str) -> Box:
    return page.notation.letter(letter, indexed=True) if letter == "x" else page.vector_letter(letter)


def _names(page: Page, step: ActionStep, letter: str) -> Iterator[Box]:
    """That of the point or frame in the model, then numbers."""
    base, name = _letter(page, letter), _name(page.flat.loads[step.load], step.back)
    if name is not None:
        yield indexed(base, name_box(name))
    for number in range(1, len(page.derivation.inertials) + len(page.derivation.actions) + 1):
        yield Subscript(base, Number(str(number)))


def _name(load: Load, back: bool) -> str | None:
    if isinstance(load, PointForce):
        return _of_point(load.origin if back else load.point)
    if isinstance(load, FrameTorque):
        return load.origin if back else load.frame
    return None


def _of_point(place: FlatExpression | None) -> str | None:
    if isinstance(place, PointReference):
        return place.name
    return place.frame if isinstance(place, FrameOrigin) else None
