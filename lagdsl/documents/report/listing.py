"""The equations as data: JSON of every term with the statements that it comes from."""

from __future__ import annotations

import json
import math

from sympy import Expr

from lagdsl.derivation.textbook.provenance import Source, Term, sources
from lagdsl.derivation.textbook.recipe import Derivation, Recipe
from lagdsl.derivation.textbook.small_motions.study import Equilibrium, Study, study
from lagdsl.documents.report.boxes import Sum
from lagdsl.documents.report.derivation import typesetter
from lagdsl.documents.report.dimensions import Units
from lagdsl.documents.report.latex_math import tex
from lagdsl.documents.report.typeset import Typesetter
from lagdsl.documents.report.unicode_math import line
from lagdsl.foundation.version import __version__
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.quantity import Spans


def listing(recipe: Recipe) -> str:
    """An object with `coordinates`, `sources` and `terms`, whose `sources` are indices, `units` by names, then
    `accelerations` and `equilibria`; all but the first two are empty for a large model. `intermediate` has the
    symbols of long texts, where there are some."""
    flat, derivation = recipe.flat, recipe.derivation
    typeset = None if derivation is None else typesetter(flat, derivation)
    terms = [] if derivation is None or typeset is None else [_term(typeset, each) for each in derivation.terms]
    found = study(flat, derivation) if derivation is not None and flat.coordinates else None
    content = {
        "lagdsl": __version__,
        "model": flat.name,
        "coordinates": [coordinate.name for coordinate in flat.coordinates],
        "written_out": derivation is not None,
        "sources": [_source(each) for each in sources(flat)],
        "terms": terms,
        "units": {} if derivation is None else _units(flat, derivation),
        **({} if found is None or typeset is None else _study(typeset, found)),
    }
    if typeset is not None and typeset.intermediates.made:
        content["intermediate"] = _intermediate(typeset)
    return json.dumps(content, ensure_ascii=False, indent=1) + "\n"


def _intermediate(typeset: Typesetter) -> list[dict[str, str]]:
    """Symbols that long texts are written with, in their order."""
    found = typeset.intermediates.made
    return [{"symbol": line(typeset.notation.of(symbol)), **_written(typeset, value)} for symbol, value in found]


def _source(source: Source) -> dict[str, object]:
    return {"kind": source.kind, "name": source.name, "statements": _statements(source.spans)}


def _statements(spans: Spans) -> list[dict[str, object]]:
    """Innermost first: in a component, then where the component is declared."""
    return [
        {"file": span.file.name, "first": list(span.first), "last": list(span.last), "text": span.text}
        for span in spans
    ]


def _units(flat: FlatModel, derivation: Derivation) -> dict[str, str]:
    return {s.name: unit for s, unit in Units(flat, derivation.symbols).of_symbols(derivation).items()}


def _study(typeset: Typesetter, found: Study) -> dict[str, object]:
    """Values by the names of the model; `omega_squared` are the squares of the natural frequencies."""
    return {
        "accelerations": [{"symbol": s.name, **_written(typeset, value)} for s, value in found.accelerations.values],
        "equilibria": [_equilibrium(typeset, each) for each in found.equilibria],
        "no_equilibria_because": found.not_all_because,
    }


def _equilibrium(typeset: Typesetter, found: Equilibrium) -> dict[str, object]:
    linear = found.linear
    result: dict[str, object] = {
        "at": [{"symbol": q.name, **_written(typeset, value)} for q, value in found.at],
        "arbitrary": [q.name for q in found.arbitrary],
        "conditions": [{"kind": each.kind, **_written(typeset, each.value)} for each in found.conditions],
        "exists": found.exists,
        **({"closed": list(found.closed)} if found.closed else {}),
    }
    if linear is None:
        return result
    matrices = {"mass": linear.mass, "damping": linear.damping, "stiffness": linear.stiffness}
    result |= {name: [[line(typeset(entry)) for entry in row] for row in matrix] for name, matrix in matrices.items()}
    result["omega_squared"] = [
        {
            "coordinates": [q.name for q in each.coordinates],
            **_written(typeset, each.square),
            "value": each.number if math.isfinite(each.number) else None,
        }
        for each in linear.frequencies
    ]
    return result


def _written(typeset: Typesetter, value: Expr) -> dict[str, str]:
    box = typeset(value)
    return {"text": line(box), "latex": tex(box)}


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
