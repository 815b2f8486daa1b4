"""Sections of the report on events: contacts and their impacts, dry friction, clocks, located relations, clauses."""

from __future__ import annotations

from sympy import Symbol

from lagdsl.derivation.textbook.recipe import ConstraintRow
from lagdsl.documents.report.boxes import (
    Box,
    Bracket,
    Dotted,
    Number,
    Operator,
    Power,
    Row,
    Subscript,
    Sum,
    Upright,
    row,
)
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
from lagdsl.documents.report.names import statement
from lagdsl.documents.report.page import Page
from lagdsl.documents.report.unicode_math import line
from lagdsl.documents.report.unit_text import unit_of
from lagdsl.language.flat.event_text import action_text
from lagdsl.language.flat.events import Branch, Clock, Contact, Friction, When
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.model import FlatModel

_MOST = 12
_OPEN = (
    "A contact is a gap that cannot become negative. While it is open its multiplier is 0 and its row is not there; "
    "closed, the row holds like a constraint, and it opens where its multiplier would become negative."
)
_FRICTION = (
    "Dry friction sticks or slides. While it sticks the slip is zero, its row holds like a constraint, and the "
    "multiplier is the force, at most as large as the limit at rest. While it slides the multiplier is 0, and the "
    "force is as large as the limit and opposes the slip. Both stand in the equations: a slip of zero has no sense."
)
_FEEDBACK = "They depend on multipliers, reactions or accelerations, with which they are found together:"
_LAW = (
    "Where a gap closes, the rates jump and the impulses p push only; the constraints, with impulses P, hold before "
    "and after. M is the matrix of the accelerations; J and J with index c hold the derivatives of the constraints and "
    "of the gaps by the coordinates:"
)
_SLOW = "Slow rebounds, and series of impacts whose rest is short, end with the contact closed."
_PASS = (
    "At an event the clauses are gone through in the order of their data until nothing changes. A clause acts where "
    "one of its conditions becomes true; `pre(v)` is the value before."
)
_PROJECTED = (
    "After a clause has acted, the rates are moved onto the constraints by the smallest impulse (in the metric of M)."
)


def contacts(page: Page) -> list[Block]:
    """Gaps with their factors in the equations, and the law of impact."""
    rows = [each for each in page.derivation.constraints if each.contact]
    if not rows:
        return []
    known = {each.name: each for each in page.flat.events.contacts}
    table = tuple(_contact(page, each, known[each.name]) for each in rows)
    return [
        Heading("Contacts"),
        Paragraph(text(_OPEN)),
        Table(("contact", "gap", f"restitution {line(page.notation.letter('e'))}", "multiplier"), table),
        *_impacts(page),
    ]


def _contact(page: Page, found: ConstraintRow, contact: Contact) -> tuple[Inline, ...]:
    restitution = text(flat_expression_text(contact.restitution))
    gap = page.typeset(found.residual)
    return (Code(found.name),), (Math(gap),), restitution, (Math(page.notation.of(found.multiplier)),)


def frictions(page: Page) -> list[Block]:
    """Slips with their limits and the multipliers of their rows."""
    rows = [each for each in page.derivation.constraints if each.friction]
    if not rows:
        return []
    known = {name: each for each in page.flat.events.frictions for name in each.rows}
    table = tuple(_friction(page, each, known[each.name]) for each in rows)
    return [
        Heading("Dry friction"),
        Paragraph(text(_FRICTION)),
        Table(("friction", "slip", "limit", "limit at rest", "multiplier"), table),
    ]


def absent_rows(page: Page) -> str | None:
    """Sentence on rows that are not there while contacts are open and friction slides; None where all always are."""
    rows = page.derivation.constraints
    contacts = ["all contacts are open"] if any(row.contact for row in rows) else []
    frictions = ["all friction slides"] if any(row.friction for row in rows) else []
    found = " and ".join([*contacts, *frictions])
    return f"While {found}, so that their multipliers are zero:" if found else None


def feedbacks(page: Page) -> list[Block]:
    """Loads that stand in the equations by their names."""
    found = page.flat.events.feedbacks
    if not found:
        return []
    table = tuple(((Code(each.name),), text(flat_expression_text(each.value))) for each in found)
    return [
        Heading("Loads found with the accelerations"),
        Paragraph(text(_FEEDBACK)),
        Table(("load", "value"), table),
    ]


def delays(page: Page) -> list[Block]:
    """Values of the past."""
    found = page.flat.events.delays
    if not found:
        return []
    rows: list[tuple[Inline, ...]] = [
        (
            (Code(each.name),),
            (Math(page.notation.of(Symbol(each.name))),),
            text(flat_expression_text(each.value)),
            text(f"{flat_expression_text(each.time)} s"),
        )
        for each in found
    ]
    return [
        Heading("Delayed values"),
        Paragraph(text("They are what they were some time ago; before the start, what they are there:")),
        Table(("in the model", "here", "value", "so long ago"), tuple(rows)),
    ]


def _friction(page: Page, found: ConstraintRow, friction: Friction) -> tuple[Inline, ...]:
    limit = flat_expression_text(friction.limit)
    at_rest = limit if friction.sticking is None else flat_expression_text(friction.sticking)
    slip, force = page.typeset(found.residual), page.notation.of(found.multiplier)
    return (Code(found.name),), (Math(slip),), text(limit), text(at_rest), (Math(force),)


def _impacts(page: Page) -> list[Block]:
    letter = page.notation.letter
    after, before = (Power(Dotted(letter("q"), 1), Upright(sign)) for sign in ("+", "−"))
    mass, gaps, rows = letter("M"), Subscript(letter("J"), Upright("c")), letter("J")
    change = Row((mass, Bracket(Sum((("+", after), ("-", before))))))
    impulses = Sum((("+", Row((_transposed(gaps), letter("p")))), ("+", Row((_transposed(rows), letter("P"))))))
    rebound = Sum((("-", Row((letter("e"), gaps, before))),))
    return [
        Paragraph(text(_LAW)),
        Equations(
            (
                Equation(change, impulses, final=True),
                Equation(Row((gaps, after)), rebound, final=True),
            )
        ),
        Paragraph((Text("with "), Math(row(letter("p"), Operator("≥"), Number("0"))), Text(". " + _SLOW))),
    ]


def _transposed(matrix: Box) -> Box:
    return Power(matrix, Upright("T"))


def events(page: Page) -> list[Block]:
    return event_list(page.flat)


def event_list(flat: FlatModel) -> list[Block]:
    """Discrete variables, clocks and clauses; long lists are cut at a dozen."""
    found = flat.events
    acting = [each for each in found.whens if any(branch.actions for branch in each.branches)]
    if not (found.discretes or found.relations or acting):
        return []
    blocks: list[Block] = [Heading("Events")]
    if found.discretes:
        rows: list[tuple[Inline, ...]] = [
            (
                (Code(each.name),),
                text(unit_of(each)),
                text(flat_expression_text(each.start)),
                text(each.doc or ""),
            )
            for each in found.discretes[:_MOST]
        ]
        blocks.append(Table(("constant between events", "unit", "at the start", "meaning"), tuple(rows)))
    if found.clocks:
        blocks.append(Bullets(tuple(_clock(each) for each in found.clocks[:_MOST])))
    if found.relations:
        names: list[Inline] = [(Code(each.name),) for each in found.relations[:_MOST]]
        more = len(found.relations) - len(names)
        tail = [text(f"… and {more} more.")] if more else []
        blocks += [
            Paragraph(text("Each of these is located where it changes, and held in between:")),
            Bullets((*names, *tail)),
        ]
    if acting:
        blocks += [Paragraph(_spoken(_PASS)), Bullets(tuple(line for each in acting[:_MOST] for line in _clause(each)))]
        if flat.constraints:
            blocks.append(Paragraph(text(_PROJECTED)))
    return blocks


def _spoken(words: str) -> Inline:
    """Plain words with pieces of the language between back-quotes."""
    return tuple(Code(part) if number % 2 else Text(part) for number, part in enumerate(words.split("`")))


def _clock(clock: Clock) -> Inline:
    first, period = flat_expression_text(clock.start), flat_expression_text(clock.period)
    return (Code(clock.name), Text(" ticks at "), Code(f"{first} s + k*({period} s)"), Text(", k = 0, 1, 2 …"))


def _clause(when: When) -> list[Inline]:
    return [_branch("when", when.branches[0]), *(_branch("else when", branch) for branch in when.branches[1:])]


def _branch(word: str, branch: Branch) -> Inline:
    parts: list[Text | Code | Math] = [Text(f"{word} "), Code(statement(branch, "its condition")), Text(": ")]
    for number, action in enumerate(branch.actions):
        guard = "" if action.guard is None else f"if {flat_expression_text(action.guard)}: "
        parts += [Text("; " if number else ""), Code(f"{guard}{action_text(action)}")]
    return tuple(parts)
