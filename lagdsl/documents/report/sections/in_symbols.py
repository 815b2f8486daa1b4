"""The equations of a large model that are short, one by one, with the quantities that stand in them."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Expr, Symbol

from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY
from lagdsl.derivation.textbook.steps.short_equations import LONGEST, ShortEquations
from lagdsl.documents.report.boxes import Number
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
from lagdsl.documents.report.intermediate import Intermediates
from lagdsl.documents.report.names import listed, own_name
from lagdsl.documents.report.notation import Notation
from lagdsl.documents.report.sections.left_side import value
from lagdsl.documents.report.typeset import Typesetter
from lagdsl.language.flat.model import FlatModel

_ROWS = "The constraints; a positive multiplier pushes towards a larger left-hand side:"
_DEFINED = "with"
_MOST = 20
_LONG = f": more than {LONGEST} terms and factors."


def in_symbols(flat: FlatModel, found: ShortEquations, signs: Notation) -> list[Block]:
    """Equations of coordinates and constraints, then what stands in them."""
    typeset = Typesetter(
        notation=signs,
        symbols=found.symbols,
        constants=found.constants,
        intermediates=Intermediates(signs.intermediate, frozenset(found.symbols.qdd)),
    )
    shown = found.equations[:_MOST]
    lines = tuple(Equation(typeset(each.left), typeset(each.right), final=True) for each in shown)
    blocks: list[Block] = [Heading("Equations in symbols"), Equations(lines)]
    blocks += _more(len(found.equations) - len(shown))
    if found.long:
        names = listed([signs.of(q) for q in found.long])
        blocks.append(Paragraph((Text("Not written out are the equations of "), *names, Text(_LONG))))
    if found.rows:
        rows = tuple(Equation(typeset(row), Number("0"), final=True) for _, row in found.rows[:_MOST])
        blocks += [Paragraph(text(_ROWS)), Equations(rows), *_more(len(found.rows) - len(rows))]
    named = (*found.dependent_parameters, *found.definitions)
    defined = [Equation(signs.of(symbol), typeset(meaning)) for symbol, meaning in named]
    defined += [Equation(signs.of(symbol), typeset(meaning)) for symbol, meaning in typeset.intermediates.made]
    if defined:
        blocks += [Paragraph(text(_DEFINED)), Equations(tuple(defined))]
    return [*blocks, *_parameters(flat, found, signs)]


def _more(count: int) -> list[Block]:
    return [Paragraph(text(f"… and {count} more."))] if count > 0 else []


def _parameters(flat: FlatModel, found: ShortEquations, signs: Notation) -> list[Block]:
    sides: Sequence[Expr] = [side for each in found.equations for side in (each.left, each.right)]
    values = [each for _, each in (*found.rows, *found.definitions, *found.dependent_parameters)]
    present: set[Symbol] = {symbol for each in (*sides, *values) for symbol in each.free_symbols}
    items = [item for item in flat.parameters if not item.structural]
    rows: list[tuple[Inline, ...]] = [
        (
            (Math(signs.of(symbol)),),
            own_name(signs.of(symbol), item.name),
            text(value(item)),
        )
        for symbol, item in zip(found.symbols.p, items, strict=True)
        if symbol in present
    ]
    if STANDARD_GRAVITY in present and STANDARD_GRAVITY not in found.symbols.p:
        rows.append(((Math(signs.of(STANDARD_GRAVITY)),), (), text("9.80665 m/s²")))
    return [Table(("symbol", "in the model", "value"), tuple(rows))] if rows else []
