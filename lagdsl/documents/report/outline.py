"""The report of a model too large to be written out: its declared parts and the form of its equations."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Sequence

from sympy import Symbol

from lagdsl.derivation.textbook.recipe import Recipe
from lagdsl.derivation.textbook.steps.assembled import Assembled, assembled
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
    with_formulas,
)
from lagdsl.documents.report.names import letters_note, own_name, owned_statement, statement
from lagdsl.documents.report.notation import Notation, notation
from lagdsl.documents.report.sections.beginnings import with_beginnings
from lagdsl.documents.report.sections.families import rolled, with_likes
from lagdsl.documents.report.sections.in_symbols import in_symbols
from lagdsl.documents.report.sections.instants import event_list
from lagdsl.documents.report.sections.own_words import SPANS, Words
from lagdsl.documents.report.sections.system import machine
from lagdsl.documents.report.unit_text import unit_of
from lagdsl.language.flat.expression import ZERO, FlatExpression, Variable
from lagdsl.language.flat.model import Constraint, FlatModel
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.traversal import rewritten
from lagdsl.motion.pipeline import Compilation

_MOST = 12
_PAGE = 60 * 100  # characters
_WHOLE = "The force of loads and constraints along each: inertia, forces of strains, weight"
_BY_ELEMENTS = (
    "The force of loads and constraints along a coordinate is the sum of the shares of its elements: inertia, forces "
    "of strains, weight. A name with an index that the model does not have is zero"
)
_UNITS = " The length 1 of each quaternion is a row of J."
_NOTES = {
    "gravity": "gravity[i] is in axes of the world",
    "S": "S(strain) is the stress of a strain, elastic and viscous",
    "Q": "Q(element, q) is the virtual work of the strains of an element along q, in its words",
    "spin": "spin(e, J) is the torque J α + ω × J ω in axes of the section as a force along the quaternion e, "
    "2 e ∘ (0, J α + ω × J ω) with ω = 2 ē ∘ ė",
    "d": "d(a)/d(q) is a partial derivative",
}


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
                f"This model is larger than what is written out term by term: {reasons}. What follows a component and "
                "a colon, or `of` a component, is in the words of this component."
            )
        )
    ]
    blocks = machine(flat, signs, compilation) if drawn else []
    blocks += _coordinates(flat, signs)
    words = Words(frozenset(name.partition("[")[0] for name in _names(flat)), {})
    blocks += kinematics(familiar, letter, words)
    blocks += energies(familiar, letter, words)
    blocks += _parts("Loads", flat.loads)
    blocks += _parts("Constraints", [each for each in flat.constraints if not each.of_law and not each.normalisation])
    blocks += _parts("Contacts", flat.events.contacts)
    blocks += _parts("Dry friction", flat.events.frictions)
    blocks += event_list(flat)
    rows = _rows(_without(flat, frozenset(familiar.zeros)), words)
    blocks += [Heading("Equations of the coordinates" if rows else "Form of the equations")]
    blocks += [*_form(flat, letter, signs.of(symbols(flat).time)), *rows, *words.numbers()]
    blocks += [] if short is None or rows else in_symbols(flat, short, signs)
    blocks += at_the_start(familiar, letter, compilation)
    return (*opening, *letters_note(signs), *blocks)


def _coordinates(flat: FlatModel, signs: Notation) -> list[Block]:
    likes = rolled([(c.name, unit_of(c), c.doc or "") for c in flat.coordinates])
    rows: list[tuple[Inline, ...]] = []
    for told, unit, doc in likes[:_MOST]:
        name, many, span = told.partition(", k = ")
        sign = signs.of(Symbol(name))
        rows.append(
            ((Math(sign),), ((Code(name), Text(many + span)) if many else own_name(sign, name)), text(unit), text(doc))
        )
    more = len(likes) - len(rows)
    blocks: list[Block] = [
        Heading("Coordinates"),
        Table(("coordinate", "in the model", "unit", "meaning"), tuple(rows)),
    ]
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


def _without(flat: FlatModel, zeros: frozenset[str]) -> FlatModel:
    """With 0 for parameters that are zero, as the other chapters have it."""

    def of(node: object, _: object) -> FlatExpression | None:
        return ZERO if isinstance(node, Variable) and node.name in zeros else None

    return rewritten(flat, of)


def _rows(flat: FlatModel, words: Words) -> list[Block]:
    """Equations of coordinates that repeat, as those of the nodes of a mesh: whole or by elements, what is shorter."""
    forms = [(found, _rolled(found)) for found in assembled(flat)]
    if not forms:
        return []
    length, found, rows = min(((_length(rows), found, rows) for found, rows in forms), key=lambda form: form[0])
    if length > _PAGE:
        return []
    told = " ".join([*(row.left for row in found.rows), *(work.text for work in found.works)])
    called = set(re.findall(r"(?<!\w)(\w+)(?=\(|\[\d\])", told))
    notes = [note for name, note in _NOTES.items() if name in called]
    opening = _BY_ELEMENTS if any(row.element is not None for row in found.rows) else _WHOLE
    stresses = [(f"S({each.strain})", each.text) for each in found.stresses]
    works = [(f"Q({work.element}, q)", work.text) for work in found.works]
    return [Paragraph(text(f"{opening}. {'; '.join(notes)}.")), *_shares(rows, words), *words.runs([*stresses, *works])]


def _length(rows: Sequence[tuple[str, ...]]) -> int:
    return sum(len(cell) for row in rows for cell in row)


def _shares(rows: Sequence[tuple[str, ...]], words: Words) -> list[Block]:
    """The rows of each component and element together."""
    shares: dict[str, list[tuple[str, str]]] = {}
    for name, element, left in map(words.told, rows):
        owner, colon, own = name.partition(": ")
        coordinate, *spans = SPANS.split(own if colon else name)
        common = [each for each in spans if element and each.startswith("k = ")]
        told = [f"share of element {element.strip('[]')}"] if element else []
        opening = ", ".join([*told, *common, *([f"in the words of {owner}"] if colon else [])])
        of = ", ".join([coordinate, *(each for each in spans if each not in common)])
        shares.setdefault(opening, []).append((of, left))
    blocks: list[Block] = []
    for opening, items in shares.items():
        blocks += [Paragraph(text(f"{opening[0].upper()}{opening[1:]}:"))] if opening else []
        blocks.append(Bullets(tuple((Code(f"{of}: {left}"),) for of, left in with_likes(items))))
    return blocks


def _rolled(found: Assembled) -> list[tuple[str, ...]]:
    """Coordinate, element and force. Rows with like indices are one, those of the first element of a coordinate before
    those of its second."""
    shares: dict[int, list[tuple[str, ...]]] = {}
    counts: Counter[str] = Counter()
    for row in found.rows:
        element = "" if row.element is None else f"[{row.element}]"
        shares.setdefault(counts[row.coordinate], []).append((row.coordinate, element, row.left))
        counts[row.coordinate] += 1
    return [row for share in shares.values() for row in rolled(with_beginnings(share))]


def _names(flat: FlatModel) -> list[str]:
    return [each.name for each in (*flat.coordinates, *flat.parameters, *flat.named)]


def _form(flat: FlatModel, letter: Callable[[str], Box], time: Box) -> list[Block]:
    q, p, lagrangian = letter("q"), letter("p"), letter("L")
    qd, qdd = Dotted(q, 1), Dotted(q, 2)
    terms: list[tuple[str, Box]] = [("+", Row((letter("M"), qdd)))]
    if flat.constraints:
        terms.append(("-", Row((Power(letter("J"), Upright("T")), letter("λ")))))
    bias = Subscript(Bracket(Derivative("d", p, time)), Row((qdd, Operator("="), Number("0"))))
    drag, gradient = Derivative("∂", letter("D"), qd), Derivative("∂", lagrangian, q)
    force = Sum((("+", letter("Q")), ("-", drag), ("+", gradient), ("-", bias)))
    left = Sum(tuple(("-" if sign == "-" else "+", box) for sign, box in terms))
    momentum, mass = Derivative("∂", lagrangian, qd), Derivative("∂", p, qd)
    with_these: list[tuple[Box, Box]] = [(p, momentum), (letter("M"), mass), (letter("f"), force)]
    if flat.constraints:
        with_these.append((Row((letter("J"), qdd)), letter("γ")))
    units = text(_UNITS) if any(each.normalisation for each in flat.constraints) else ()
    return [
        Equations((Equation(left, letter("f"), final=True),)),
        Paragraph((*with_formulas("with", with_these), *units)),
    ]
