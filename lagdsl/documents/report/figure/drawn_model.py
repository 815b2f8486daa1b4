"""A model that is drawn and the boxes of its symbols, with a derivation that is written out or without."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from sympy import Symbol

from lagdsl.derivation.textbook.contributions import AppliedForce
from lagdsl.documents.report.boxes import Box, Name, Number, Row, Subscript
from lagdsl.documents.report.names import carrier_labels
from lagdsl.documents.report.notation import Notation
from lagdsl.documents.report.page import Page
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm


@dataclass(frozen=True, slots=True)
class Force:
    place: fx.FlatExpression
    force: fx.FlatExpression
    label: Box | None


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawnModel:
    """`carriers` and `weights` belong to masses, then bodies. `in_full`: with weights and admissible motions."""

    flat: fm.FlatModel
    letter: Callable[[str], Box]
    coordinates: tuple[Box, ...]
    carriers: tuple[Box, ...]
    weights: tuple[Box | None, ...]
    forces: tuple[Force, ...]
    in_full: bool


def derived(page: Page) -> DrawnModel:
    """Forces are numbered as in the table of loads."""
    forces = []
    for number, step in enumerate(page.derivation.actions, start=1):
        load = page.flat.loads[step.load]
        if not isinstance(step.action, AppliedForce) or not isinstance(load, fm.PointForce):
            continue
        label = Subscript(page.vector_letter("F"), Number(str(number)))
        place = load.origin if step.back and load.origin is not None else load.point
        forces.append(Force(place, fx.Unary("-", load.force) if step.back else load.force, label))
    masses = [inertial.mass for inertial in page.derivation.inertials]
    return DrawnModel(
        flat=page.flat,
        letter=page.notation.letter,
        coordinates=tuple(page.notation.of(q) for q in page.derivation.symbols.q),
        carriers=tuple(carrier_labels(page.flat)),
        weights=tuple(Row((page.typeset(mass), Name("𝐠"))) if mass.is_Symbol else None for mass in masses),
        forces=tuple(forces),
        in_full=True,
    )


def outlined(flat: fm.FlatModel, notation: Notation) -> DrawnModel:
    """A machine that is told by chapters."""
    forces = [
        Force(place, force, None)
        for load in flat.loads
        if isinstance(load, fm.PointForce)
        for place, force in ((load.point, load.force), (load.origin, fx.Unary("-", load.force)))
        if place is not None
    ]
    return DrawnModel(
        flat=flat,
        letter=notation.letter,
        coordinates=tuple(notation.of(Symbol(item.name)) for item in flat.coordinates),
        carriers=tuple(carrier_labels(flat)),
        weights=(None,) * (len(flat.masses) + len(flat.bodies)),
        forces=tuple(forces),
        in_full=False,
    )
