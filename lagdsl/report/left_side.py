"""Parameters, and steps 1 to 5 of the recipe: from the coordinates to the derivatives of the Lagrangian."""

from __future__ import annotations

from sympy import Expr

from lagdsl.flat.model import Parameter
from lagdsl.flat.quantity import Quantity
from lagdsl.report.boxes import Box, Name, Row, Subscript, Sum, Upright
from lagdsl.report.counting import count_blocks
from lagdsl.report.document import Block, Equation, Equations, Heading, Inline, Math, Paragraph, Table, Text, text
from lagdsl.report.names import indexed
from lagdsl.report.page import LAGRANGIAN, Page, by_time, partial
from lagdsl.textbook.reading import STANDARD_GRAVITY
from lagdsl.units.naming import to_display

_POSITIONS = "From the world origin, in world axes; of a body its mass centre."
_ENERGIES_BY_HAND = "No mass or body is declared: the energies are written by hand."


def parameters(page: Page) -> list[Block]:
    items = [p for p in page.flat.parameters if not p.structural]
    rows: list[tuple[Inline, ...]] = [
        ((Math(page.notation.of(symbol)),), text(value(item)), text(item.doc or ""))
        for symbol, item in zip(page.derivation.symbols.p, items, strict=True)
    ]
    if STANDARD_GRAVITY in page.derivation.lagrangian.free_symbols:
        rows.append(((Math(page.notation.of(STANDARD_GRAVITY)),), text("9.80665 m/s2"), text("standard gravity")))
    if not rows:
        return []
    blocks: list[Block] = [Heading("Parameters"), Table(("symbol", "value", "meaning"), tuple(rows))]
    if page.derivation.dependent_parameters:
        blocks += [Paragraph(text("Quantities that follow from them:"))]
        blocks += [definition_lines(page, page.derivation.dependent_parameters)]
    return blocks


def definition_lines(page: Page, pairs: tuple[tuple[Expr, Expr], ...]) -> Block:
    return Equations(tuple(Equation(page.notation.of(symbol), page.typeset(value)) for symbol, value in pairs))


def coordinates(page: Page) -> list[Block]:
    rows = tuple(
        ((Math(page.notation.of(symbol)),), text(unit(item)), text(item.doc or ""))
        for symbol, item in zip(page.derivation.symbols.q, page.flat.coordinates, strict=True)
    )
    return [
        Heading("Coordinates and their count", "1"),
        Table(("coordinate", "unit", "meaning"), rows),
        *count_blocks(page.derivation.count),
    ]


def positions(page: Page) -> list[Block]:
    lines = [Equation(indexed("r", label), page.vector(item.position)) for label, item in page.inertial_elements()]
    if not lines:
        return [Heading("Position vectors", "2"), Paragraph(text(_ENERGIES_BY_HAND))]
    return [Heading("Position vectors", "2"), Paragraph(text(_POSITIONS)), Equations(tuple(lines))]


def velocities(page: Page) -> list[Block]:
    lines = []
    for label, item in page.inertial_elements():
        lines.append(Equation(indexed("v", label), page.vector(item.velocity)))
        if item.frame is not None:
            lines.append(Equation(indexed("ω", label), page.typeset.vector(item.spin)))
    if not lines:
        return [Heading("Velocities", "3"), Paragraph(text("None are needed beyond the rates themselves."))]
    spins = any(item.frame is not None for _, item in page.inertial_elements())
    words = "Their time derivatives." + (" Angular velocities are in the axes of the body." if spins else "")
    return [Heading("Velocities", "3"), Paragraph(text(words)), Equations(tuple(lines))]


def energies(page: Page) -> list[Block]:
    d = page.derivation
    total: list[tuple[str, Box]] = [("+", Name("T")), ("-", Name("V"))]
    lines = [Equation(Name("T"), page.typeset(d.kinetic)), Equation(Name("V"), page.typeset(d.potential))]
    if d.extra != 0:
        extra = Subscript(LAGRANGIAN, Upright("x"))
        lines.append(Equation(extra, page.typeset(d.extra)))
        total.append(("+", extra))
    lines.append(Equation(LAGRANGIAN, Sum(tuple(("-" if sign == "-" else "+", box) for sign, box in total))))
    if d.dissipation != 0:
        lines.append(Equation(Name("D"), page.typeset(d.dissipation)))
    words = "Kinetic and potential energy, and the Lagrangian."
    if d.dissipation != 0:
        words = "Kinetic and potential energy, the Lagrangian, and the Rayleigh function of the dashpots."
    return [Heading("Energies", "4"), Paragraph(text(words)), Equations(tuple(lines))]


def derivatives(page: Page) -> list[Block]:
    blocks: list[Block] = [Heading("Lagrange's equations, term by term", "5")]
    for step in page.derivation.coordinates:
        q, qd = page.notation.of(step.q), page.rate(step.q)
        momentum = partial(LAGRANGIAN, qd)
        blocks.append(Paragraph((Text("Coordinate "), Math(q), Text(":"))))
        blocks.append(
            Equations(
                (
                    Equation(momentum, page.typeset(step.momentum)),
                    Equation(Row((by_time(), momentum)), page.typeset(step.momentum_rate)),
                    Equation(partial(LAGRANGIAN, q), page.typeset(step.gradient)),
                )
            )
        )
    return blocks


def unit(item: Quantity) -> str:
    return "" if item.unit == "1" else item.unit


def value(item: Parameter) -> str:
    """The number in the unit that the model shows it in."""
    if item.kind == "Boolean":
        return "true" if item.value else "false"
    shown = item.display_unit or item.unit
    return f"{to_display(item.value, item.display_unit):.6g} {'' if shown == '1' else shown}".rstrip()
