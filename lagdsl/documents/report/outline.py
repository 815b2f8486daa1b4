"""The report of a model too large to be written out: its declared parts and the form of its equations."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sympy import Symbol

from lagdsl.derivation.textbook.recipe import Recipe
from lagdsl.derivation.textbook.steps.assembled import assembled
from lagdsl.derivation.textbook.symbols import symbols
from lagdsl.documents.report.boxes import (
    Box,
    Bracket,
    Derivative,
    Dotted,
    Number,
    Operator,
    Power,
    Row,
    Subscript,
    Sum,
    Upright,
)
from lagdsl.documents.report.chapters import at_the_start, energies, kinematics
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
from lagdsl.documents.report.names import letters_note, own_name, owned_statement, statement
from lagdsl.documents.report.notation import Notation, notation
from lagdsl.documents.report.sections.families import rolled
from lagdsl.documents.report.sections.in_symbols import in_symbols
from lagdsl.documents.report.sections.instants import event_list
from lagdsl.documents.report.sections.own_words import Words
from lagdsl.documents.report.sections.system import machine
from lagdsl.documents.report.unit_text import unit_of
from lagdsl.language.flat.model import Constraint, FlatModel
from lagdsl.language.flat.quantity import Item
from lagdsl.motion.pipeline import Compilation

_MOST = 12
_LONGEST_ROW = 2500
_ALIKE = (
    "Each is inertia, then the forces of strains, elastic and viscous, then the weight; neighbours share elements. "
    "d(a)/d(q) is a partial derivative."
)
_GRAVITY = "gravity[1], [2] and [3] are the components of the gravity in axes of the world."
_SPIN = (
    "spin(e, J) is the torque J α + ω × J ω, in axes of the section, as a force along the quaternion e, "
    "2 e ∘ (0, J α + ω × J ω) with ω = 2 ē ∘ ė."
)
_SHORT_ONES = "the short equations in symbols, "


def outline(recipe: Recipe, *, drawn: bool = False, compilation: Compilation | None = None) -> tuple[Block, ...]:
    """Chapters instead of terms; every list is cut, and says so. `drawn`: with a drawing of the whole. `compilation`:
    that of the model if there is one."""
    familiar, flat, short = recipe.familiar, recipe.flat, recipe.short
    named = () if short is None else (*short.dependent_parameters, *short.definitions)
    constrained = tuple(row for each in flat.constraints for row in each.rows)
    signs = notation(flat, symbols(flat), tuple(symbol for symbol, _ in named), constrained)
    letter = signs.letter
    reasons = "; ".join(recipe.extent.reasons)
    opening: list[Block] = [
        Paragraph(
            text(
                f"This model is larger than what is written out term by term: {reasons}. It is told by chapters: "
                f"kinematics, energies, loads, constraints, {'' if short is None else _SHORT_ONES}and the equations in "
                "numbers where the motion starts. A row of a table with a component before a "
                "colon, or after `of`, is in the words of this component."
            )
        )
    ]
    blocks = machine(flat, signs, compilation) if drawn else []
    blocks += _coordinates(flat, signs)
    words = Words(frozenset(name.partition("[")[0] for name in _names(flat)), {})
    blocks += kinematics(familiar, letter, words)
    blocks += energies(familiar, letter, words)
    blocks += _parts("Masses and bodies", [*flat.masses, *flat.bodies])
    blocks += _parts("Loads", flat.loads)
    blocks += _parts("Constraints", [each for each in flat.constraints if not each.of_law])
    blocks += _parts("Contacts", flat.events.contacts)
    blocks += _parts("Dry friction", flat.events.frictions)
    blocks += event_list(flat)
    blocks += _equations(flat, letter, signs.of(symbols(flat).time))
    rows = _rows(flat, words)
    blocks += [*rows, *words.numbers()]
    blocks += [] if short is None or rows else in_symbols(flat, short, signs)
    blocks += at_the_start(familiar, letter, compilation)
    return (*opening, *letters_note(signs), *blocks)


def _coordinates(flat: FlatModel, signs: Notation) -> list[Block]:
    likes = rolled([(c.name, unit_of(c), c.doc or "") for c in flat.coordinates])
    header = ("coordinate", "in the model", "unit", "meaning")
    rows: list[tuple[Inline, ...]] = []
    for told, unit, doc in likes[:_MOST]:
        name, many, span = told.partition(", k = ")
        sign = signs.of(Symbol(name))
        rows.append(((Math(sign),), own_name(sign, name), text(unit), text(doc), text(f"k = {span}" if many else "")))
    more, spans = len(likes) - len(rows), any(row[-1][0] != Text("") for row in rows)
    table = Table((*header, ""), tuple(rows)) if spans else Table(header, tuple(row[:-1] for row in rows))
    blocks: list[Block] = [Heading("Coordinates"), table]
    return [*blocks, Paragraph(text(f"… and {more} more."))] if more else blocks


def _parts(title: str, items: Sequence[Item]) -> list[Block]:
    """The user's own statements; a statement in a loop is shown once, with how often it stands for an item."""
    if not items:
        return []
    counts: dict[str, int] = {}
    for item in items:
        words = (statement if isinstance(item, Constraint) else owned_statement)(item, type(item).__name__)
        counts[words] = counts.get(words, 0) + 1
    entries: list[Inline] = [
        (Code(words), Text(f" ({number} times)")) if number > 1 else (Code(words),)
        for words, number in list(counts.items())[:_MOST]
    ]
    more = len(counts) - len(entries)
    return [Heading(title), Bullets((*entries, text(f"… and {more} more.")) if more else tuple(entries))]


def _rows(flat: FlatModel, words: Words) -> list[Block]:
    """Equations of coordinates that repeat, as those of the nodes of a mesh: a typical one and those at the ends."""
    found = assembled(flat)
    rows = [(row.coordinate, row.left) for row in found.rows]
    if not rows or len(rolled(rows)) > _MOST:
        return []
    told = [word for word, sign in ((_GRAVITY, "gravity["), (_SPIN, "spin(")) if any(sign in left for _, left in rows)]
    works = [(f"Q of {work.element}", work.text) for work in found.works]
    header = ("coordinate", "force of loads and constraints along it")
    return [
        Heading("Equations of the coordinates"),
        Paragraph(text(" ".join([_ALIKE, *told]))),
        *words.table(header, rows, longest=_LONGEST_ROW),
        *words.table(("force of strains", "along a coordinate q, Q(element, q)"), works, longest=_LONGEST_ROW),
    ]


def _names(flat: FlatModel) -> list[str]:
    return [each.name for each in (*flat.coordinates, *flat.parameters, *flat.named)]


def _equations(flat: FlatModel, letter: Callable[[str], Box], time: Box) -> list[Block]:
    q, p, lagrangian = letter("q"), letter("p"), letter("L")
    qd, qdd = Dotted(q, 1), Dotted(q, 2)
    terms: list[tuple[str, Box]] = [("+", Row((letter("M"), qdd)))]
    if flat.constraints:
        terms.append(("-", Row((Power(letter("J"), Upright("T")), letter("λ")))))
    bias = Subscript(Bracket(Derivative("d", p, time)), Row((qdd, Operator("="), Number("0"))))
    drag, gradient = Derivative("∂", letter("D"), qd), Derivative("∂", lagrangian, q)
    force = Sum((("+", letter("Q")), ("-", drag), ("+", gradient), ("-", bias)))
    left = Sum(tuple(("-" if sign == "-" else "+", box) for sign, box in terms))
    lines = [
        Equation(left, letter("f"), final=True),
        Equation(p, Derivative("∂", lagrangian, qd)),
        Equation(letter("M"), Derivative("∂", p, qd)),
        Equation(letter("f"), force),
    ]
    if flat.constraints:
        lines.append(Equation(Row((letter("J"), qdd)), letter("γ"), final=True))
    return [Heading("Form of the equations"), Equations(tuple(lines))]
