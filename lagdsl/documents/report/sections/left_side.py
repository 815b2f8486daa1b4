"""Parameters, and steps 1 to 5 of the recipe: from the coordinates to the derivatives of the Lagrangian."""

from __future__ import annotations

from typing import Literal

from sympy import Expr

from lagdsl.derivation.textbook.contributions import Inertial
from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY
from lagdsl.derivation.textbook.tidy import size
from lagdsl.documents.report.boxes import Box, Number, Operator, Row, Subscript, Sum, Upright
from lagdsl.documents.report.broken import lines as broken_lines
from lagdsl.documents.report.dimensions import Units
from lagdsl.documents.report.document import (
    Block,
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
from lagdsl.documents.report.named_rates import spin as plane_spin
from lagdsl.documents.report.named_rates import velocity
from lagdsl.documents.report.names import gathered, indexed, listed, own_name
from lagdsl.documents.report.page import Page, vector_lines
from lagdsl.documents.report.sections.by_parts import is_by_parts
from lagdsl.documents.report.sections.counting import count_blocks
from lagdsl.documents.report.unicode_math import line
from lagdsl.documents.report.unit_text import readable_unit, unit_of, value_and_unit
from lagdsl.language.flat.expression import Variable
from lagdsl.language.flat.model import Parameter
from lagdsl.language.flat.quantity import Quantity
from lagdsl.language.flat.traversal import records

_LONGEST_LINE = 80
_POSITIONS = "From the world origin, in world axes; of a body its mass centre."
_ENERGIES_BY_HAND = "No mass or body is declared: the energies are written by hand."


def parameters(page: Page) -> list[Block]:
    items = [p for p in page.flat.parameters if not p.structural]
    pairs = list(zip(page.derivation.symbols.p, items, strict=True))
    times = {
        each.name for delay in page.flat.events.delays for each in records(delay.time) if isinstance(each, Variable)
    }
    shown = {*(symbol.name for symbol in page.derivation.occurring), *times}
    rows: list[tuple[Inline, ...]] = [
        ((Math(page.notation.of(symbol)),), text(value(item)), text(item.doc or ""))
        for symbol, item in pairs
        if symbol.name in shown
    ]
    if STANDARD_GRAVITY in page.derivation.occurring and STANDARD_GRAVITY not in page.derivation.symbols.p:
        rows.append(((Math(page.notation.of(STANDARD_GRAVITY)),), text("9.80665 m/s²"), text("standard gravity")))
    if not rows:
        return []
    blocks: list[Block] = [Heading("Parameters"), Table(("symbol", "value", "meaning"), tuple(rows))]
    blocks += _left_out(page, tuple(item.name for _, item in pairs if item.name not in shown))
    if page.derivation.dependent_parameters:
        blocks += [Paragraph(text("Quantities that follow from them:"))]
        blocks += [definition_lines(page, page.derivation.dependent_parameters)]
    return blocks


def symbols_and_units(page: Page) -> list[Block]:
    """Each symbol that occurs, then the letters of the derivation itself; nothing where units are not asked for."""
    if page.units is None:
        return []
    d, letter = page.derivation, page.notation.letter
    quantities = [*page.flat.coordinates, *page.flat.parameters, *page.flat.states, *page.flat.inputs, *page.flat.named]
    words = {STANDARD_GRAVITY.name: "standard gravity"}
    words |= {item.name: item.doc or "" for item in quantities if isinstance(item, Quantity)}
    moving = {*d.symbols.q, *d.symbols.qd, *d.symbols.qdd, *d.symbols.lam}
    rows: list[tuple[Inline, ...]] = [
        ((Math(page.notation.of(symbol)),), text(readable_unit(unit)), text(words.get(symbol.name, "")))
        for symbol, unit in page.units.of_symbols(d).items()
        if symbol in d.occurring or symbol in moving
    ]
    own = [("T", "J", "kinetic energy"), ("V", "J", "potential energy"), ("L", "J", "Lagrangian")]
    own += [("D", "W", "Rayleigh function")] if d.dissipation != 0 else []
    rows += [((Math(letter(name)),), text(unit), text(meaning)) for name, unit, meaning in own]
    for j, q in enumerate(d.symbols.q):
        force = Subscript(letter("Q", indexed=True), page.notation.of(q))
        rows.append(((Math(force),), text(readable_unit(page.units.force(j))), text("generalized force")))
    return [Heading("Symbols and units", units=True), Table(("symbol", "unit", "meaning"), tuple(rows))]


def _left_out(page: Page, idle: tuple[str, ...]) -> list[Block]:
    """Parameters that the formulas do not show."""
    blocks: list[Block] = []
    if idle:
        blocks.append(Paragraph(text(f"In no formula: {gathered(idle)}.")))
    zeros, twins = page.familiar.zeros, page.familiar.twins
    if zeros:
        blocks.append(Paragraph(text(f"Zero in this model, and left out of the formulas: {gathered(zeros)}.")))
    if twins:
        pairs = ", ".join(f"{one} = {other}" for one, other in twins)
        blocks.append(Paragraph(text(f"Equal in this model, and written as one: {pairs}.")))
    return blocks


def definition_lines(page: Page, pairs: tuple[tuple[Expr, Expr], ...]) -> Block:
    units = {} if page.units is None else page.units.of_symbols(page.derivation)
    return Equations(
        tuple(
            Equation(page.notation.of(symbol), page.typeset(value), unit=units.get(symbol)) for symbol, value in pairs
        )
    )


def coordinates(page: Page) -> list[Block]:
    rows = tuple(
        (
            (Math(page.notation.of(symbol)),),
            own_name(page.notation.of(symbol), item.name),
            text(unit_of(item)),
            text(item.doc or ""),
        )
        for symbol, item in zip(page.derivation.symbols.q, page.flat.coordinates, strict=True)
    )
    return [
        Heading("Coordinates and their count", "1"),
        Table(("coordinate", "in the model", "unit", "meaning"), rows),
        *count_blocks(page.derivation.count, page.notation.letter),
        *_balances(page),
    ]


def _balances(page: Page) -> list[Block]:
    """Without a number: where rows tie directions without inertia, equations do not show how many there are."""
    names = listed([page.notation.of(q) for q in page.derivation.balanced])
    words = " hold no inertia: as balances of forces they leave fewer degrees of freedom than are counted here."
    if len(page.derivation.balanced) == 1:
        words = " holds no inertia: as a balance of forces it leaves fewer degrees of freedom than are counted here."
    equations = "equation" if len(page.derivation.balanced) == 1 else "equations"
    return [Paragraph((Text(f"The {equations} of "), *names, Text(words)))] if names else []


def positions(page: Page) -> list[Block]:
    carriers = page.inertial_elements()
    if not carriers:
        return [Heading("Position vectors", "2"), Paragraph(text(_ENERGIES_BY_HAND))]
    letter = page.vector_letter("r")
    resting = [indexed(letter, label) for label, item in carriers if not any(item.position)]
    moved = [(label, item) for label, item in carriers if any(item.position)]
    blocks: list[Block] = [Heading("Position vectors", "2"), Paragraph(text(_POSITIONS))]
    if resting:
        blocks.append(
            Paragraph(
                (
                    *listed(resting),
                    Text(
                        " vanish: they lie at the world origin."
                        if len(resting) > 1
                        else " vanishes: it lies at the world origin."
                    ),
                )
            )
        )
    unit = page.unit(Units.plain, "m")
    lines = tuple(
        each for label, item in moved for each in vector_lines(indexed(letter, label), page.vector(item.position), unit)
    )
    return [*blocks, Equations(lines)] if lines else blocks


def velocities(page: Page) -> list[Block]:
    carriers = page.inertial_elements()
    if not carriers:
        return [Heading("Velocities", "3"), Paragraph(text("None are needed beyond the rates themselves."))]
    speed, spin = page.vector_letter("v"), page.vector_letter("ω")
    lines, resting, straight = [], [], []
    for label, item in carriers:
        if any(item.velocity):
            shown = page.vector(velocity(page, item.position, item.velocity))
            lines += vector_lines(indexed(speed, label), shown, page.unit(Units.plain, "m/s"))
        else:
            resting.append(indexed(speed, label))
        if item.frame is not None and any(item.spin):
            flat = page.planar and not any(item.spin[:2])
            own_spin = page.typeset(plane_spin(page, item.spin[2])) if flat else page.typeset.vector(item.spin)
            lines += vector_lines(indexed(spin, label), own_spin, page.unit(Units.plain, "rad/s"))
        elif item.frame is not None:
            straight.append(indexed(spin, label))
    turning = any(item.frame is not None for _, item in carriers)
    words = "Their time derivatives."
    if turning and page.planar:
        words += " Angular velocities are about the normal of the plane."
    elif turning:
        words += " Angular velocities are in the axes of the body."
    blocks: list[Block] = [Heading("Velocities", "3"), Paragraph(text(words))]
    for names, verb in ((resting, "the mass center stays where it is"), (straight, "the body does not turn")):
        if names:
            blocks.append(Paragraph((*listed(names), Text(f" vanish{'es' if len(names) == 1 else ''}: {verb}."))))
    return [*blocks, Equations(tuple(lines))] if lines else blocks


def energies(page: Page) -> list[Block]:
    d, letter = page.derivation, page.notation.letter
    kinetic, potential = letter("T"), letter("V")
    lines = _own_energies(page)
    unit = page.unit(Units.plain, "J")
    lines += [
        Equation(kinetic, _kinetic(page), unit=unit),
        Equation(potential, page.typeset(d.potential), unit=unit),
    ]
    total: list[tuple[Literal["+", "-"], Box]] = [("+", kinetic), ("-", potential)]
    if d.extra != 0:
        extra = Subscript(page.lagrangian, Upright("x"))
        lines.append(Equation(extra, page.typeset(d.extra), unit=unit))
        total.append(("+", extra))
    lines.append(Equation(page.lagrangian, Sum(tuple(total)), unit=unit))
    if size(d.lagrangian) <= LONGEST and d.lagrangian != 0:
        lines.append(Equation(page.lagrangian, page.typeset(d.lagrangian), unit=unit))
    if d.dissipation != 0:
        lines.append(Equation(letter("D"), page.typeset(d.dissipation), unit=page.unit(Units.plain, "W")))
    words = "Kinetic and potential energy, and the Lagrangian."
    if d.dissipation != 0:
        words = "Kinetic and potential energy, the Lagrangian, and the Rayleigh function of the dashpots."
    return [Heading("Energies", "4"), Paragraph(text(words)), Equations(tuple(lines))]


def _own_energies(page: Page) -> list[Equation]:
    """T of each mass and body, where there are several."""
    carriers = page.inertial_elements()
    if len(carriers) < 2:
        return []
    letter = page.notation.letter("T")
    pairs = zip(carriers, page.derivation.own_kinetic, strict=True)
    unit = page.unit(Units.plain, "J")
    return [
        Equation(indexed(letter, label), _own_energy(page, label, item, own), unit=unit)
        for (label, item), own in pairs
        if own != 0
    ]


def _own_energy(page: Page, label: Box, item: Inertial, own: Expr) -> Box:
    """Written out, or by the velocities above where squares of these cannot be broken into lines."""
    if size(own) <= LONGEST:
        shown = page.typeset(own)
        parts = broken_lines(Equation(shown, shown), _LONGEST_LINE)
        if max(len(line(part.right)) for part in parts) <= 2 * _LONGEST_LINE:
            return shown
    half, dot = Number("½"), Operator("·")
    velocity, spin = (indexed(page.vector_letter(letter), label) for letter in ("v", "ω"))
    terms: list[tuple[Literal["+", "-"], Box]] = []
    if any(item.velocity):
        terms.append(("+", Row((half, page.typeset(item.mass), velocity, dot, velocity))))
    if item.frame is not None and any(item.spin):
        terms.append(("+", Row((half, spin, dot, indexed(page.notation.letter("I", indexed=True), label), spin))))
    return Sum(tuple(terms))


def _kinetic(page: Page) -> Box:
    """Written out, or as the sum of those of masses and bodies."""
    d = page.derivation
    if len(d.inertials) == 1 or not is_by_parts(page, d.kinetic):
        return page.typeset(d.kinetic)
    pairs = zip(page.inertial_elements(), d.own_kinetic, strict=True)
    letter = page.notation.letter("T")
    return Sum(tuple(("+", indexed(letter, label)) for (label, _), own in pairs if own != 0))


def value(item: Parameter) -> str:
    """The number in the unit that the model shows it in."""
    if item.kind == "Boolean":
        return "true" if item.value else "false"
    return " ".join(value_and_unit(item.value, item)).rstrip()
