"""The derivation report: the recipe of a model as a document, set in one of four formats."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, TypeAlias

from sympy import Expr, Symbol

from lagdsl.derivation.textbook.familiar import Familiar
from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY, needed
from lagdsl.derivation.textbook.recipe import Derivation, Recipe
from lagdsl.derivation.textbook.small_motions.study import study
from lagdsl.derivation.textbook.symbols import replaced
from lagdsl.derivation.textbook.tidy import size
from lagdsl.documents.report.dimensions import Units
from lagdsl.documents.report.document import Block, Document, filled
from lagdsl.documents.report.html import html
from lagdsl.documents.report.intermediate import Intermediates
from lagdsl.documents.report.latex import latex
from lagdsl.documents.report.markdown import markdown
from lagdsl.documents.report.names import letters_note
from lagdsl.documents.report.notation import notation
from lagdsl.documents.report.outline import outline
from lagdsl.documents.report.page import Page
from lagdsl.documents.report.plain import plain
from lagdsl.documents.report.sections.by_parts import derivatives
from lagdsl.documents.report.sections.forces import loads
from lagdsl.documents.report.sections.instants import contacts, delays, events, feedbacks, frictions
from lagdsl.documents.report.sections.intermediate import with_intermediates
from lagdsl.documents.report.sections.left_side import (
    coordinates,
    energies,
    parameters,
    positions,
    symbols_and_units,
    velocities,
)
from lagdsl.documents.report.sections.results import abbreviations, conserved, constraints, equations, outputs, states
from lagdsl.documents.report.sections.small_motions import accelerations, small_motions
from lagdsl.documents.report.sections.system import system
from lagdsl.documents.report.typeset import Typesetter
from lagdsl.foundation.units.dimension import MASS
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation

Format: TypeAlias = Literal["text", "markdown", "latex", "html"]

FORMATS: dict[str, Callable[[Document], str]] = {"text": plain, "markdown": markdown, "latex": latex, "html": html}

_LONG_DEFINITION = 20
"""Nodes of a definition that stays a symbol in expressions that are printed."""

_SECTIONS: tuple[Callable[[Page], list[Block]], ...] = (
    parameters,
    symbols_and_units,
    coordinates,
    positions,
    velocities,
    energies,
    derivatives,
    loads,
    equations,
    constraints,
    accelerations,
    small_motions,
    contacts,
    frictions,
    feedbacks,
    delays,
    states,
    events,
    outputs,
    abbreviations,
    conserved,
)


def render(recipe: Recipe, to: Format, *, units: bool = False) -> str:
    """The report as text of the format, ending with a newline; with the units of symbols and equations if asked for."""
    return FORMATS[to](document(recipe, units=units, drawn=to != "text"))


def document(
    recipe: Recipe, *, units: bool = False, drawn: bool = False, compilation: Compilation | None = None
) -> Document:
    """`drawn`: with the drawing of the system. `compilation` is that of the model if there is one: what the document
    says of the start of the motion is computed with it, and without with a compilation of its own."""
    flat, derivation = recipe.flat, recipe.derivation
    if derivation is None:
        blocks = outline(recipe, drawn=drawn, compilation=compilation)
    else:
        page = _page(recipe.familiar, derivation, units)
        first, *others = [with_intermediates(page, section) for section in _SECTIONS]
        picture = system(page, compilation) if drawn else []
        note = letters_note(page.notation)  # all letters are known when all is set
        blocks = filled([*picture, *first, *note, *(block for section in others for block in section)])
    return Document(title=flat.name, subtitle=flat.doc, blocks=blocks)


def typesetter(flat: FlatModel, derivation: Derivation) -> Typesetter:
    """The notation that sets the expressions of a derivation."""
    written = _written_out(derivation)
    used = needed(derivation.definitions, (*written.values(), *(symbol for symbol, _ in derivation.abbreviations)))
    named = tuple(symbol for symbol, _ in (*derivation.dependent_parameters, *used))
    rows = tuple(row.name for row in derivation.constraints if row.restricts)
    independent = [parameter for parameter in flat.parameters if not parameter.structural]
    masses = [s for s, p in zip(derivation.symbols.p, independent, strict=True) if p.dimension == MASS]
    signs = notation(flat, derivation.symbols, named, rows)
    return Typesetter(
        notation=signs,
        symbols=derivation.symbols,
        constants=derivation.constants,
        intermediates=Intermediates(signs.intermediate, frozenset(derivation.symbols.qdd), written),
        first=(*masses, STANDARD_GRAVITY),
    )


def _written_out(derivation: Derivation) -> dict[Expr, Symbol]:
    """Definitions of the model by their values in coordinates, where those are long."""
    values: dict[Symbol, Expr] = {}
    for symbol, value in derivation.definitions:
        values[symbol] = replaced(value, values)
    return {value: symbol for symbol, value in values.items() if size(value) >= _LONG_DEFINITION}


def _page(familiar: Familiar, derivation: Derivation, units: bool) -> Page:
    typeset = typesetter(familiar.flat, derivation)
    found = study(familiar.flat, derivation) if familiar.flat.coordinates else None
    return Page(
        familiar=familiar,
        derivation=derivation,
        notation=typeset.notation,
        typeset=typeset,
        study=found,
        units=Units(familiar.flat, derivation.symbols) if units else None,
    )
