"""The equations as data: JSON of every term with the statements that it comes from."""

from __future__ import annotations

import json

from sympy import Expr

from lagdsl.flat.quantity import Spans
from lagdsl.report.boxes import Sum
from lagdsl.report.derivation import typesetter
from lagdsl.report.latex_math import tex
from lagdsl.report.typeset import Typesetter
from lagdsl.report.unicode_math import line
from lagdsl.textbook.provenance import Source, Term, sources
from lagdsl.textbook.recipe import Recipe
from lagdsl.version import __version__


def listing(recipe: Recipe) -> str:
    """An object with `coordinates`, `sources` and `terms`, whose `sources` are indices; no terms of a large model."""
    flat, derivation = recipe.flat, recipe.derivation
    terms = [] if derivation is None else [_term(typesetter(flat, derivation), each) for each in derivation.terms]
    found = {
        "lagdsl": __version__,
        "model": flat.name,
        "coordinates": [coordinate.name for coordinate in flat.coordinates],
        "written_out": derivation is not None,
        "sources": [_source(each) for each in sources(flat)],
        "terms": terms,
    }
    return json.dumps(found, ensure_ascii=False, indent=1) + "\n"


def _source(source: Source) -> dict[str, object]:
    return {"kind": source.kind, "name": source.name, "statements": _statements(source.spans)}


def _statements(spans: Spans) -> list[dict[str, object]]:
    """Innermost first: in a component, then where the component is declared."""
    return [
        {"file": span.file.name, "first": list(span.first), "last": list(span.last), "text": span.text}
        for span in spans
    ]


def _term(typeset: Typesetter, term: Term) -> dict[str, object]:
    return {
        "equation": term.equation,
        "side": term.side,
        "text": line(_signed(typeset, term.value)),
        "latex": tex(_signed(typeset, term.value)),
        "sources": list(term.sources),
    }


def _signed(typeset: Typesetter, value: Expr) -> Sum:
    box = typeset(value)
    return box if isinstance(box, Sum) and len(box.terms) == 1 else Sum((("+", box),))
