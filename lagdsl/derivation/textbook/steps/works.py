"""The virtual work of the strains of an element, written once for all elements and coordinates."""

from __future__ import annotations

import re
from collections.abc import Sequence

from lagdsl.derivation.textbook.steps.products import Term, text_of
from lagdsl.foundation.record import record

_PARTIAL = re.compile(r"d\(((?:[^().]+\.)+)[^().]+\)/d\(")
_COORDINATE = "q"


@record(kw_only=True)
class Work:
    """The force `text` along the coordinate `q`, in the names of the component `element`."""

    element: str
    text: str


def with_works(rows: Sequence[tuple[str, list[Term]]]) -> tuple[tuple[Work, ...], list[list[Term]]]:
    """The sums along coordinates; `Q(element, coordinate)` stands for the terms with derivatives of the
    strains of an element where they are the same for all, but for derivatives that are zero."""
    found = [(name, _by_element(terms)) for name, terms in rows]
    general = [_general(terms, element, name) for name, parts in found for element, terms in parts.items() if element]
    whole = max(general, key=len, default=[])
    if not whole or not all(set(each) <= set(whole) for each in general):
        return (), [terms for _, terms in rows]
    works = {element: Work(element=element, text=text_of(whole)) for _, parts in found for element in parts}
    works.pop("", None)
    calls = [[Term(1.0, (f"Q({element}, {name})",)) for element in parts if element] for name, parts in found]
    return tuple(works.values()), [[*parts.get("", []), *call] for (_, parts), call in zip(found, calls, strict=True)]


def _by_element(terms: list[Term]) -> dict[str, list[Term]]:
    parts: dict[str, list[Term]] = {}
    for term in terms:
        owners = {match[1] for factor in term.above for match in _PARTIAL.finditer(factor)}
        parts.setdefault(owners.pop().removesuffix(".") if len(owners) == 1 else "", []).append(term)
    return parts


def _general(terms: list[Term], element: str, coordinate: str) -> list[Term]:
    """In the names of the element, along any coordinate."""

    def own(factor: str) -> str:
        return factor.replace(f"/d({coordinate})", f"/d({_COORDINATE})").replace(f"{element}.", "")

    return [Term(term.number, tuple(map(own, term.above)), tuple(map(own, term.below))) for term in terms]
