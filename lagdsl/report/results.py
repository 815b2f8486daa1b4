"""Results of the derivation: equations, constraints, states, outputs, conserved quantities."""

from __future__ import annotations

from sympy import Add

from lagdsl.report.boxes import EQUALS, Box, Name, Number, Row, Sum, row
from lagdsl.report.document import (
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
from lagdsl.report.left_side import definition_lines
from lagdsl.report.notation import dotted, name_box
from lagdsl.report.page import LAGRANGIAN, Page, by_time, partial
from lagdsl.report.typeset import LONGEST
from lagdsl.textbook.recipe import ConstraintRow, CoordinateStep
from lagdsl.textbook.tidy import size

_ZERO = Number("0")
_LEVELS = {"position": "the configuration", "velocity": "the rates only"}
_SIGN = "A positive multiplier pushes towards a larger left-hand side."
_JACOBI = (
    "Time does not occur in L and no load or dashpot works: the Jacobi integral, the sum of q̇ ∂L/∂q̇ over all "
    "coordinates less L, is constant. The energy T + V is not: what moves the frames by prescription does work."
)


def equations(page: Page) -> list[Block]:
    d = page.derivation
    lines = []
    for j, step in enumerate(d.coordinates):
        upheld = [r.multiplier * r.forces[j] for r in d.constraints if r.forces[j] != 0]
        right = Add(d.generalized_forces[j], d.drags[j], *upheld)
        lines.append(Equation(_left(page, step), page.typeset(right), final=True))
    return [Heading("Equations of motion"), Equations(tuple(lines)), *_matrix_form(page)]


def _left(page: Page, step: CoordinateStep) -> Box:
    """Collected by accelerations; the letters of the recipe where that is too long to print."""
    if size(step.left) <= LONGEST:
        return page.typeset(step.left)
    rate = Row((by_time(), partial(LAGRANGIAN, page.rate(step.q))))
    return Sum((("+", rate), ("-", partial(LAGRANGIAN, page.notation.of(step.q)))))


def _matrix_form(page: Page) -> list[Block]:
    d = page.derivation
    n = len(d.coordinates)
    if not 2 <= n <= 4:
        return []
    mass = tuple(tuple(step.left.diff(x) for x in d.symbols.qdd) for step in d.coordinates)
    if any(size(element) > LONGEST // 4 for line in mass for element in line):
        return []
    return [
        Paragraph(text("The matrix of the accelerations, symmetric:")),
        Equations((Equation(Name("M"), page.typeset.matrix(mass)),)),
    ]


def constraints(page: Page) -> list[Block]:
    rows = tuple(row for row in page.derivation.constraints if not row.contact)
    if not rows:
        return []
    conditions = tuple(Equation(page.typeset(row.residual), _ZERO, final=True) for row in rows)
    table = tuple(
        ((Code(row.name),), text(_LEVELS[row.level]), (Math(page.notation.of(row.multiplier)),)) for row in rows
    )
    return [
        Heading("Constraints"),
        Table(("constraint", "restricts", "multiplier"), table),
        Equations(conditions),
        Paragraph(text(_SIGN)),
        *_accelerations(page, rows),
    ]


def _accelerations(page: Page, rows: tuple[ConstraintRow, ...]) -> list[Block]:
    lines = tuple(Equation(page.typeset(row.acceleration), _ZERO) for row in rows if row.acceleration != 0)
    if not lines:
        return []
    return [
        Paragraph(text("Differentiated until accelerations appear, they complete the equations:")),
        Equations(lines),
    ]


def states(page: Page) -> list[Block]:
    if not page.derivation.states:
        return []
    lines = [
        Equation(dotted(page.notation.of(symbol), 1), page.typeset(value), final=True)
        for symbol, value in page.derivation.states
    ]
    return [Heading("First-order states"), Equations(tuple(lines))]


def outputs(page: Page) -> list[Block]:
    if not page.derivation.outputs:
        return []
    from_names = [Equation(name_box(name), page.typeset(value)) for name, value in page.derivation.outputs]
    return [Heading("Outputs"), Equations(tuple(from_names))]


def abbreviations(page: Page) -> list[Block]:
    if not page.derivation.abbreviations:
        return []
    return [
        Heading("Definitions of the model"),
        Paragraph(text("Written out where they are differentiated, kept as symbols elsewhere.")),
        definition_lines(page, page.derivation.abbreviations),
    ]


def conserved(page: Page) -> list[Block]:
    d = page.derivation
    items: list[Inline] = []
    for q in d.cyclic:
        words = " does not occur in L, and nothing acts on it: its momentum is constant, "
        momentum = d.coordinates[d.symbols.q.index(q)].momentum
        items.append(
            (
                Math(page.notation.of(q)),
                Text(words),
                Math(row(partial(LAGRANGIAN, page.rate(q)), EQUALS, page.typeset(momentum))),
            )
        )
    if d.energy_conserved:
        items.append(text("Time occurs nowhere and no load or dashpot works: the energy T + V is constant."))
    elif d.jacobi_conserved:
        items.append(text(_JACOBI))
    return [Heading("Conserved quantities"), Bullets(tuple(items))] if items else []
