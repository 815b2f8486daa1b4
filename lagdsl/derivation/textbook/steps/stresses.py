"""Stresses with names: `S(strain)` stands for an elastic and viscous stress that several terms have."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import reduce
from operator import and_

from lagdsl.derivation.textbook.steps.products import Term, text_of
from lagdsl.foundation.record import record

_VISCOUS = re.compile(r"\((?P<strain>[\w.]+(?:\[[\d,]+\])?) \+ (?:.+\*)?der\((?P=strain)\)\)")


@record(kw_only=True)
class Stress:
    """`S(strain)` is `text`."""

    strain: str
    text: str


def with_stresses(rows: Sequence[list[Term]]) -> tuple[tuple[Stress, ...], list[list[Term]]]:
    """The sums with names for their stresses, each with the factors that all of its terms have; none where no stress
    stands in two terms."""
    terms: dict[str, list[Term]] = {}
    for row in rows:
        for term in row:
            for factor in _stresses(term):
                terms.setdefault(factor, []).append(term)
    if all(len(of) < 2 for of in terms.values()):
        return (), list(rows)
    common = {factor: _common(of) for factor, of in terms.items()}
    stresses = tuple(Stress(strain=_strain(factor), text=text_of([each])) for factor, each in common.items())
    return stresses, [[_named(term, common) for term in row] for row in rows]


def _stresses(term: Term) -> Iterator[str]:
    return (factor for factor in term.above if _VISCOUS.fullmatch(factor))


def _strain(factor: str) -> str:
    found = _VISCOUS.fullmatch(factor)
    return "" if found is None else found["strain"]


def _common(terms: Sequence[Term]) -> Term:
    lines = ([term.above for term in terms], [term.below for term in terms])
    above, below = (reduce(and_, map(Counter, line)) for line in lines)
    return Term(1.0, tuple(above.elements()), tuple(below.elements()))


def _named(term: Term, common: dict[str, Term]) -> Term:
    for factor in _stresses(term):
        of = common[factor]
        above, below = Counter(term.above) - Counter(of.above), Counter(term.below) - Counter(of.below)
        return replace(term, above=(f"S({_strain(factor)})", *above.elements()), below=tuple(below.elements()))
    return term
