"""The report of a model too large to be written out: its declared parts and the form of its equations."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.flat.model import FlatModel
from lagdsl.flat.quantity import Item
from lagdsl.report.boxes import (
    Box,
    Bracket,
    Derivative,
    Dotted,
    Name,
    Number,
    Operator,
    Power,
    Row,
    Subscript,
    Sum,
    Upright,
)
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
from lagdsl.report.instants import event_list
from lagdsl.report.names import statement
from lagdsl.report.notation import name_box
from lagdsl.textbook.extent import Extent

_MOST = 12


def outline(flat: FlatModel, extent: Extent) -> tuple[Block, ...]:
    """Every list is cut at a dozen entries, and says so."""
    reasons = "; ".join(extent.reasons)
    blocks: list[Block] = [
        Paragraph(
            text(
                f"This model is larger than what is written out term by term: {reasons}. Its parts and the form of its "
                "equations follow; the terms are formed all the same when the model is compiled."
            )
        )
    ]
    blocks += _coordinates(flat)
    blocks += _parts("Masses and bodies", [*flat.masses, *flat.bodies])
    blocks += _parts("Energies", flat.energies)
    blocks += _parts("Loads", flat.loads)
    blocks += _parts("Constraints", [each for each in flat.constraints if not each.contact])
    blocks += _parts("Contacts", flat.events.contacts)
    blocks += event_list(flat)
    return (*blocks, *_equations(flat))


def _coordinates(flat: FlatModel) -> list[Block]:
    shown = flat.coordinates[:_MOST]
    rows: list[tuple[Inline, ...]] = [
        ((Math(name_box(c.name)),), text("" if c.unit == "1" else c.unit), text(c.doc or "")) for c in shown
    ]
    more = len(flat.coordinates) - len(shown)
    blocks: list[Block] = [Heading("Coordinates"), Table(("coordinate", "unit", "meaning"), tuple(rows))]
    return [*blocks, Paragraph(text(f"… and {more} more."))] if more else blocks


def _parts(title: str, items: Sequence[Item]) -> list[Block]:
    """The user's own statements; a statement in a loop is shown once, with how often it stands for an item."""
    if not items:
        return []
    counts: dict[str, int] = {}
    for item in items:
        words = statement(item, type(item).__name__)
        counts[words] = counts.get(words, 0) + 1
    entries: list[Inline] = [
        (Code(words), Text(f" ({number} times)")) if number > 1 else (Code(words),)
        for words, number in list(counts.items())[:_MOST]
    ]
    more = len(counts) - len(entries)
    return [Heading(title), Bullets((*entries, text(f"… and {more} more.")) if more else tuple(entries))]


def _equations(flat: FlatModel) -> list[Block]:
    q, p, lagrangian = Name("q"), Name("p"), Name("L")
    qd, qdd = Dotted(q, 1), Dotted(q, 2)
    terms: list[tuple[str, Box]] = [("+", Row((Name("M"), qdd)))]
    if flat.constraints:
        terms.append(("-", Row((Power(Name("J"), Upright("T")), Name("λ")))))
    bias = Subscript(Bracket(Derivative("d", p, Name("t"))), Row((qdd, Operator("="), Number("0"))))
    drag, gradient = Derivative("∂", Name("D"), qd), Derivative("∂", lagrangian, q)
    force = Sum((("+", Name("Q")), ("-", drag), ("+", gradient), ("-", bias)))
    left = Sum(tuple(("-" if sign == "-" else "+", box) for sign, box in terms))
    lines = [
        Equation(left, Name("f"), final=True),
        Equation(p, Derivative("∂", lagrangian, qd)),
        Equation(Name("M"), Derivative("∂", p, qd)),
        Equation(Name("f"), force),
    ]
    if flat.constraints:
        lines.append(Equation(Row((Name("J"), qdd)), Name("γ"), final=True))
    return [Heading("Form of the equations"), Equations(tuple(lines))]
