"""Steps 6 to 9 of the recipe: the generalized forces."""

from __future__ import annotations

from typing import assert_never

from sympy import Symbol

from lagdsl.derivation.textbook.contributions import (
    Applied,
    AppliedForce,
    AppliedGeneralizedForce,
    AppliedRateForce,
    AppliedTorque,
)
from lagdsl.derivation.textbook.steps.actions import ActionStep, Contribution
from lagdsl.documents.report.boxes import EQUALS, Box, Number, Operator, Row, Subscript, Sum
from lagdsl.documents.report.dimensions import Units
from lagdsl.documents.report.document import (
    Block,
    Bullets,
    Code,
    Equation,
    Equations,
    Heading,
    Inline,
    Math,
    Paragraph,
    Table,
    Text,
    text,
)
from lagdsl.documents.report.names import owned_statement
from lagdsl.documents.report.page import Page, added, partial, vector_lines
from lagdsl.documents.report.sections.places import Place, places_of
from lagdsl.documents.report.unicode_math import line
from lagdsl.foundation.units.dimension import DIMENSIONLESS, LENGTH

_NO_LOADS = (
    "No loads are declared: weights and springs are in the potential energy, and the forces that uphold what is built "
    "into the coordinates do no work on any admissible motion."
)
_VARIATIONS = "How the place of each load moves with one coordinate at a time, time held still; zeros are left out."
_WORLD_AXES = " All vectors are in world axes."
_BUILT_IN = (
    "The forces that uphold what is built into the coordinates (rods, guides, joints): they are perpendicular to every "
    "admissible motion, so they are never needed."
)
_DECLARED = "The forces of the declared constraints are kept: each enters with its multiplier."
_WIDEST_CELL = 50
_REASONS = {
    Contribution.PLACE_HELD: "no admissible motion moves the place it acts on: no work, it drops out.",
    Contribution.PERPENDICULAR: "it is perpendicular to every admissible motion of its place: no work, it drops out.",
    Contribution.ZERO: "it is zero.",
}


def loads(page: Page) -> list[Block]:
    d = page.derivation
    if not d.actions:
        blocks: list[Block] = [Heading("Generalized forces", "6–9"), Paragraph(text(_NO_LOADS))]
        return [*blocks, *_generalized_forces(page)] if d.dissipation != 0 else blocks
    return [
        Heading("Loads and their places", "6"),
        *_load_list(page),
        Heading("Admissible variations", "7"),
        *_variations(page),
        Heading("Forces that do no work", "8"),
        *_workless(page),
        Heading("Generalized forces", "9"),
        *_generalized_forces(page),
    ]


def _load_list(page: Page) -> list[Block]:
    rows: list[tuple[Inline, ...]] = []
    below: list[Equation] = []
    for number, (step, place) in enumerate(zip(page.derivation.actions, places_of(page), strict=True), start=1):
        load = page.flat.loads[step.load]
        words = owned_statement(load, load.label or type(load).__name__)
        side: Inline = (Text(" (the opposite one)"),) if step.back else ()
        name = _load_name(page, step, number)
        amount = _in_cell(name, _amount(page, step), below)
        rows.append(((Math(name),), (Code(words), *side), amount, _place(page, step, place, below)))
    blocks: list[Block] = [Table(("load", "in the model", "value", "acts on"), tuple(rows))]
    return [*blocks, Equations(tuple(below))]


def _in_cell(name: Box, value: Box, below: list[Equation]) -> Inline:
    """The value in a cell of the table, a long one by its name, which an equation below the table has."""
    if len(line(value)) <= _WIDEST_CELL:
        return (Math(value),)
    below += vector_lines(name, value, None)
    return (Text("below"),)


def _place(page: Page, step: ActionStep, place: Place, below: list[Equation]) -> Inline:
    """The place by its name, with its value where the report does not have it yet."""
    match step.action:
        case AppliedForce(position=position, frame=None):
            return (Text("point "), *_named(place, page.vector(position), below))
        case AppliedForce(position=position, frame=frame):
            return (Text(f"material point of {frame} at "), *_named(place, page.vector(position), below))
        case AppliedTorque(frame=frame):
            return (Text(f"frame {frame}, which turns with "), Math(place.name))
        case AppliedGeneralizedForce(target=target):
            return _named(place, page.typeset(target), below)
        case AppliedRateForce(rate=rate):
            return (Text("speed "), *_named(place, page.typeset(rate), below))


def _named(place: Place, value: Box, below: list[Equation]) -> Inline:
    if place.is_known:
        return (Math(place.name),)
    if len(line(value)) <= _WIDEST_CELL:
        return (Math(Row((place.name, EQUALS, value))),)
    below += vector_lines(place.name, value, None)
    return (Math(place.name), Text(" below"))


def _amount(page: Page, step: ActionStep) -> Box:
    match step.action:
        case AppliedForce(force=vector) | AppliedTorque(torque=vector):
            return page.vector(vector)
        case AppliedGeneralizedForce(value=value) | AppliedRateForce(value=value):
            return page.typeset(value)


def _variations(page: Page) -> list[Block]:
    lines = []
    for place, step in zip(places_of(page), page.derivation.actions, strict=True):
        for j, (q, variation) in enumerate(zip(page.derivation.symbols.q, step.variations, strict=True)):
            if not any(component != 0 for component in (variation if isinstance(variation, tuple) else (variation,))):
                continue
            value = page.vector(variation) if isinstance(variation, tuple) else page.typeset(variation)
            unit = page.unit(_variation_unit, step.action, j)
            lines += [
                each for each in vector_lines(_variation_name(page, step, place, q), value, unit) if each not in lines
            ]
    if not lines:
        return [Paragraph(text("No admissible motion moves the place of any load."))]
    turned = any(isinstance(step.action, AppliedTorque) for step in page.derivation.actions)
    return [Paragraph(text(_VARIATIONS + (_WORLD_AXES if turned else ""))), Equations(tuple(lines))]


def _variation_name(page: Page, step: ActionStep, place: Place, q: Symbol) -> Box:
    by_rate = isinstance(step.action, AppliedTorque | AppliedRateForce)
    return partial(place.name, page.rate(q) if by_rate else page.notation.of(q))


def _variation_unit(units: Units, action: Applied, j: int) -> str | None:
    """None for a scalar that is moved: its dimension is not declared."""
    match action:
        case AppliedForce():
            return units.per_coordinate(LENGTH, j)
        case AppliedTorque():
            return units.per_coordinate(DIMENSIONLESS, j)
        case AppliedGeneralizedForce() | AppliedRateForce():
            return None
        case _:
            assert_never(action)


def _workless(page: Page) -> list[Block]:
    items: list[Inline] = []
    for number, step in enumerate(page.derivation.actions, start=1):
        if step.contribution is not Contribution.CONTRIBUTES:
            items.append((Math(_load_name(page, step, number)), Text(f": {_REASONS[step.contribution]}")))
    items.append(text(_BUILT_IN))
    if page.derivation.constraints:
        items.append(text(_DECLARED))
    return [Bullets(tuple(items))]


def _generalized_forces(page: Page) -> list[Block]:
    lines, places = [], places_of(page)
    for j, step in enumerate(page.derivation.coordinates):
        works = [
            (number, a, place)
            for number, (a, place) in enumerate(zip(page.derivation.actions, places, strict=True), start=1)
            if a.works[j] != 0
        ]
        sources = [_work_of(page, a, number, _variation_name(page, a, place, step.q)) for number, a, place in works]
        total = page.derivation.generalized_forces[j] + page.derivation.drags[j]
        if page.derivation.drags[j] != 0:
            sources.append(Sum((("-", partial(page.notation.letter("D"), page.rate(step.q))),)))
        name = Subscript(page.notation.letter("Q", indexed=True), page.notation.of(step.q))
        value = page.typeset(total)
        right = Row((added(sources), EQUALS, value)) if sources and total != 0 else value
        lines.append(Equation(name, right, unit=page.unit(Units.force, j)))
    return [Equations(tuple(lines))]


def _load_name(page: Page, step: ActionStep, number: int) -> Box:
    is_vector = isinstance(step.action, AppliedForce | AppliedTorque)
    letter = "M" if isinstance(step.action, AppliedTorque) else "F"
    return Subscript(page.vector_letter(letter) if is_vector else page.notation.letter(letter), Number(str(number)))


def _work_of(page: Page, step: ActionStep, number: int, variation: Box) -> Box:
    """F . dr/dq, a plain product where the load is a scalar."""
    name = _load_name(page, step, number)
    if isinstance(step.action, AppliedGeneralizedForce | AppliedRateForce):
        return Row((name, variation))
    return Row((name, Operator("·"), variation))
