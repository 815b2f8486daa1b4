"""Results of the derivation: equations, constraints, states, outputs, conserved quantities."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sympy import Expr

from lagdsl.derivation.textbook.reading import needed
from lagdsl.derivation.textbook.recipe import ConstraintRow, CoordinateStep
from lagdsl.derivation.textbook.tidy import size
from lagdsl.documents.report.boxes import EQUALS, Box, Number, Row, Subscript, Sum, Upright, row
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
from lagdsl.documents.report.intermediate import LONGEST
from lagdsl.documents.report.names import listed
from lagdsl.documents.report.notation import dotted, name_box
from lagdsl.documents.report.page import Page, partial
from lagdsl.documents.report.sections.left_side import definition_lines
from lagdsl.documents.report.unicode_math import line
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.model import Output

_LONGEST_MATRIX = 80
_LONGEST_ENTRY = 75
_LONGEST_MOMENTUM = 50
_ZERO = Number("0")
_IDLE = "holds whatever the motion is, and its multiplier enters no equation."
_IDLES = "hold whatever the motion is, and their multipliers enter no equation."
_LEVELS = {"position": "the configuration", "velocity": "the rates only"}
_TURNING = "Angles of cut joints are known up to whole turns; a recorded motion continues them."
_SIGN = "A positive multiplier pushes towards a larger left-hand side."
_DEFINITIONS = "Written out where they are differentiated, kept as symbols elsewhere."
_LONG_DEFINITIONS = "Short ones are written out where they are differentiated, all others are kept as symbols."
_BALANCED = (
    ": the equation is a balance of forces, which determines the place or the rate; its derivatives by time determine "
    "the acceleration."
)
_JACOBI = (
    "Time does not occur in the Lagrangian and no load or dashpot works: the Jacobi integral, the sum of each rate "
    "times its momentum less the Lagrangian, is constant. The energy is not: what moves the frames by prescription "
    "does work."
)


def equations(page: Page) -> list[Block]:
    d = page.derivation
    lines = []
    for j, step in enumerate(d.coordinates):
        left, right = (
            {term.value: term.sources for term in d.terms if term.equation == j and term.side == side}
            for side in ("left", "right")
        )
        lines.append(
            Equation(_left(page, step, left), page.typeset(d.rights[j], right), final=True, unit=_force(page, j))
        )
    return [Heading("Equations of motion"), Equations(tuple(lines)), *_balanced(page), *_matrix_form(page)]


def _balanced(page: Page) -> list[Block]:
    names = listed([page.notation.of(q) for q in page.derivation.balanced])
    return [Paragraph((Text("No inertia acts along "), *names, Text(_BALANCED)))] if names else []


def _force(page: Page, j: int) -> str | None:
    return page.unit(Units.force, j)


def _left(page: Page, step: CoordinateStep, sources: Mapping[Expr, tuple[int, ...]]) -> Box:
    """Collected by accelerations; the letters of the recipe where that is too long to print."""
    if size(step.left) <= LONGEST:
        return page.typeset(step.left, sources)
    rate = Row((page.by_time(), partial(page.lagrangian, page.rate(step.q))))
    return Sum((("+", rate), ("-", partial(page.lagrangian, page.notation.of(step.q)))))


def _matrix_form(page: Page) -> list[Block]:
    d = page.derivation
    n = len(d.coordinates)
    if not 2 <= n <= 4:
        return []
    mass = tuple(tuple(step.left.diff(x) for x in d.symbols.qdd) for step in d.coordinates)
    if any(size(element) > _LONGEST_ENTRY for entries in mass for element in entries):
        return []
    letter = page.notation.letter("M")
    whole = page.typeset.matrix(mass)
    if len(line(whole)) <= _LONGEST_MATRIX:
        return [Paragraph(text("The matrix of the accelerations, symmetric:")), Equations((Equation(letter, whole),))]
    entries = tuple(
        Equation(
            Subscript(letter, Number(f"{i + 1}{j + 1}")),
            page.typeset(mass[i][j]),
            unit=page.unit(Units.mass, i, j),
        )
        for i in range(n)
        for j in range(i, n)
    )
    return [Paragraph(text("The matrix of the accelerations, symmetric, entry by entry:")), Equations(entries)]


def constraints(page: Page) -> list[Block]:
    rows = tuple(row for row in page.derivation.constraints if row.is_lasting)
    if not rows:
        return []
    idle = [row.name for row in rows if not row.restricts]
    rows = tuple(row for row in rows if row.restricts)
    blocks: list[Block] = [Heading("Constraints")]
    if rows:
        conditions = tuple(
            Equation(page.typeset(row.residual), _ZERO, final=True, unit=page.unit(Units.row, row)) for row in rows
        )
        table = tuple(
            ((Code(row.name),), text(_LEVELS[row.level]), (Math(page.notation.of(row.multiplier)),)) for row in rows
        )
        blocks += [
            Table(("constraint", "restricts", "multiplier"), table),
            Equations(conditions),
            Paragraph(text(_SIGN)),
        ]
    if idle:
        blocks.append(Paragraph((*_codes(idle), Text(f" {_IDLES if len(idle) > 1 else _IDLE}"))))
    return [*blocks, *_accelerations(page, rows)]


def _codes(names: Sequence[str]) -> Inline:
    pieces: list[Code | Text] = []
    for number, name in enumerate(names):
        pieces += [Text(" and " if number == len(names) - 1 else ", ")] if number else []
        pieces.append(Code(name))
    return tuple(pieces)


def _accelerations(page: Page, rows: tuple[ConstraintRow, ...]) -> list[Block]:
    lines = tuple(
        Equation(
            page.typeset(row.acceleration),
            _ZERO,
            unit=page.unit(Units.row, row, 2 if row.level == "position" else 1),
        )
        for row in rows
        if row.acceleration != 0
    )
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
        Equation(
            dotted(page.notation.of(symbol), 1),
            page.typeset(value),
            final=True,
            unit=page.unit(Units.quantity, symbol.name, 1),
        )
        for symbol, value in page.derivation.states
    ]
    return [Heading("First-order states"), Equations(tuple(lines))]


def outputs(page: Page) -> list[Block]:
    if not page.derivation.outputs:
        return []
    items = {item.name: item for item in page.flat.outputs}
    from_names = [
        Equation(name_box(name), _output(page, value, items[name]), unit=page.unit(Units.quantity, name))
        for name, value in page.derivation.outputs
    ]
    turning = any(item.turn is not None for item in page.flat.outputs)
    words: list[Block] = [Paragraph(text(_TURNING))] if turning else []
    return [Heading("Outputs"), Equations(tuple(from_names)), *words]


def _output(page: Page, value: Expr, item: Output) -> Box:
    """Its value, or the words of the model where that fills pages."""
    if page.typeset.intermediates.reach(value):
        return page.typeset(value)
    return Upright(flat_expression_text(item.value))


def abbreviations(page: Page) -> list[Block]:
    d, used = page.derivation, page.typeset.intermediates.used
    wanted = used | {symbol for symbol, _ in d.abbreviations}
    shown = needed(d.definitions, wanted)
    if not shown:
        return []
    return [
        Heading("Definitions of the model"),
        Paragraph(text(_LONG_DEFINITIONS if used else _DEFINITIONS)),
        definition_lines(page, shown),
    ]


def conserved(page: Page) -> list[Block]:
    d = page.derivation
    items: list[Inline] = []
    for q in d.cyclic:
        words = " does not occur in the Lagrangian, and nothing acts on it: its momentum is constant, "
        momentum = d.coordinates[d.symbols.q.index(q)].momentum
        name, value = partial(page.lagrangian, page.rate(q)), page.typeset(momentum)
        shown = row(name, EQUALS, value) if len(line(value)) <= _LONGEST_MOMENTUM else name
        items.append((Math(page.notation.of(q)), Text(words), Math(shown)))
    if d.energy_conserved:
        items.append(text("Time occurs nowhere and no load or dashpot works: the energy is constant."))
    elif d.jacobi_conserved:
        items.append(text(_JACOBI))
    return [Heading("Conserved quantities"), Bullets(tuple(items))] if items else []
