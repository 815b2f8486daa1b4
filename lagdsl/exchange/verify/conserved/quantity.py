"""A conserved quantity that was found, and what it stands on."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.exchange.verify.conserved.candidates import Candidate
from lagdsl.exchange.verify.conserved.coefficient import Coefficient
from lagdsl.foundation.record import record
from lagdsl.foundation.units.naming import unit_text


@record()
class Term:
    coefficient: Coefficient
    candidate: Candidate


@record(kw_only=True)
class ConservedQuantity:
    """`expression` in the language, `unit` in SI; `because` says why it is constant, `statements` are the parts of the
    text that carry it, `also` other expressions that differ from it by a factor and a constant at most.

    `for_all_parameters` is False where it is constant for the values of the parameters only that the model gives.
    `remainder` is the largest rate at random states, as a part of the terms that cancel in it.
    """

    expression: str
    unit: str
    because: str
    statements: tuple[str, ...]
    also: tuple[str, ...]
    for_all_parameters: bool
    remainder: float
    terms: tuple[Term, ...]


def expression_of(terms: Sequence[Term]) -> str:
    return "".join(term.coefficient.times(term.candidate.text, first=index == 0) for index, term in enumerate(terms))


def unit_of(terms: Sequence[Term]) -> str:
    first = terms[0]
    return unit_text(first.coefficient.unit * first.candidate.dimension)


def statements_of(terms: Sequence[Term]) -> tuple[str, ...]:
    """`file:line: text of the line` of the statements behind the terms, in their order."""
    found: dict[str, None] = {}
    for term in terms:
        for spans in term.candidate.spans:
            for span in spans[-1:]:
                line = span.file.text.splitlines()[span.first.line - 1].strip()
                found[f"{span.file.name}:{span.first.line}: {line}"] = None
    return tuple(found)


def because(terms: Sequence[Term]) -> str:
    """The reason in words: time, translation, rotation, an ignorable coordinate, or a symmetry."""
    families = {term.candidate.family for term in terms}
    only = terms[0].candidate
    if "energy" in families:
        if len(terms) > 1:
            return "a motion in time and along the coordinates together leaves the machine as it is"
        if only.text == "energy()":
            return "time does not matter, and nothing has power"
        return "the Lagrangian does not depend on time, and nothing else has power"
    if families == {"linear"}:
        return "no force from outside acts along it: translation leaves the machine as it is"
    if families == {"angular"}:
        return "no torque from outside acts about it: rotation leaves the machine as it is"
    if len(terms) == 1 and families == {"momentum"}:
        return f"{only.moved} is ignorable: nothing depends on it and no force acts along it"
    if families <= {"momentum", "product"}:
        return "symmetry: " + ", ".join(_moves(terms))
    if families == {"coordinate"}:
        return "integral of a constraint on rates"
    if families <= {"momentum", "product", "coordinate"}:
        return "the forces along these coordinates are rates of the rest"
    return "the forces of both balance"


def _moves(terms: Sequence[Term]) -> list[str]:
    """`x -> x + eps*y`: the infinitesimal transformation of each coordinate."""
    found: dict[str, str] = {}
    for term in terms:
        candidate = term.candidate
        step = term.coefficient.times("eps" if candidate.by is None else f"eps*{candidate.by}", first=False)
        found[candidate.moved] = found.get(candidate.moved, candidate.moved) + step
    return [f"{name} -> {step}" for name, step in found.items()]
