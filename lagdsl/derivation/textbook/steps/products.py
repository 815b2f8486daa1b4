"""Sums of products as texts: like terms are one, equal factors cancel, terms that differ by an index are a sum."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import field, replace
from fractions import Fraction
from functools import reduce
from operator import and_

from lagdsl.foundation.record import record
from lagdsl.language.flat.expression_text import number_text

_NOTHING = 1e-12  # of a sum of numbers that cancel each other
_LARGEST_DENOMINATOR = 1000
_NAME = re.compile(r"[A-Za-z_][\w.]*(?:\[[\d,]+\])?(?:\.\w+(?:\[[\d,]+\])?)*")
_INDEX = re.compile(r"(?<=[\[,])\d+(?=(?:,\w+)*\])")
_LETTERS = ("i", "c")
_PARTIAL = "d("


@record()
class Term:
    """A product: number, factors above and below the line, as texts."""

    number: float
    above: tuple[str, ...] = field(default=())
    below: tuple[str, ...] = field(default=())


def partial_of(name: str, coordinate: str) -> Term:
    """A derivative that is not written out."""
    return Term(1.0, (f"{_PARTIAL}{name})/d({coordinate})",))


def product(left: Iterable[Term], right: list[Term]) -> list[Term]:
    return [
        _cancelled(Term(a.number * b.number, (*a.above, *b.above), (*a.below, *b.below))) for a in left for b in right
    ]


def quotient(left: list[Term], right: list[Term]) -> list[Term]:
    return [_over(above, below) for above in left for below in right]


def _over(above: Term, below: Term) -> Term:
    return _cancelled(Term(above.number / below.number, (*above.above, *below.below), (*above.below, *below.above)))


def _cancelled(term: Term) -> Term:
    """Without the factors that stand above and below."""
    above, below = list(term.above), []
    for factor in term.below:
        if factor in above:
            above.remove(factor)
        else:
            below.append(factor)
    return replace(term, above=tuple(above), below=tuple(below))


def shared(sums: list[list[Term]]) -> tuple[Term, list[list[Term]]]:
    """The factors that all terms of all sums have, and the sums without them."""
    together = [_together(each) for each in sums]
    terms = [term for each in together for term in each]
    if not terms:
        return Term(1.0), sums
    sizes = {abs(each.number) for each in terms}
    above = reduce(and_, (Counter(each.above) for each in terms))
    below = reduce(and_, (Counter(each.below) for each in terms))
    common = Term(sizes.pop() if len(sizes) == 1 else 1.0, tuple(above.elements()), tuple(below.elements()))
    return common, [quotient(each, [common]) for each in together]


def bracketed(terms: list[Term]) -> list[Term]:
    """A sum as one factor, without what all its terms have."""
    sums = _together(terms)
    if len(sums) < 2:
        return sums
    sizes, below = {abs(each.number) for each in sums}, {each.below for each in sums}
    number, line = sizes.pop() if len(sizes) == 1 else 1.0, below.pop() if len(below) == 1 else ()
    inner = [Term(each.number / number, each.above, () if line else each.below) for each in sums]
    return [Term(number, (f"({text_of(inner)})",), line)]


def viscous(elastic: list[Term], damping: list[Term]) -> list[Term]:
    """Their sum. A term of damping with the rate of a strain that a term of elasticity has, and one more factor tau,
    stands in its bracket: E*(strain + tau*der(strain))."""
    found, rest = list(elastic), []
    for term in damping:
        for place, other in enumerate(found):
            joined = _joined(other, term)
            if joined is not None:
                found[place] = joined
                break
        else:
            rest.append(term)
    return [*found, *rest]


def _joined(elastic: Term, damping: Term) -> Term | None:
    if abs(elastic.number - damping.number) > _NOTHING * abs(elastic.number):
        return None
    if Counter(elastic.below) != Counter(damping.below):
        return None
    for place, strain in enumerate(elastic.above):
        rate, others = f"der({strain})", [*elastic.above[:place], *elastic.above[place + 1 :]]
        known = Counter([*others, rate])
        if rate in damping.above and known <= Counter(damping.above):
            more = [*(Counter(damping.above) - known).elements()]
            stress = f"({strain} + {'*'.join([*more, rate])})"
            return replace(elastic, above=(*elastic.above[:place], stress, *elastic.above[place + 1 :]))
    return None


def _together(terms: list[Term]) -> list[Term]:
    """Like terms as one, without those that cancel each other."""
    sums: dict[tuple[tuple[str, ...], tuple[str, ...]], list[Term]] = {}
    for term in terms:
        sums.setdefault((tuple(sorted(term.above)), tuple(sorted(term.below))), []).append(term)
    found = [(likes, sum(each.number for each in likes)) for likes in sums.values()]
    return [
        replace(likes[0], number=number)
        for likes, number in found
        if abs(number) > _NOTHING * max(abs(each.number) for each in likes)
    ]


def text_of(terms: list[Term]) -> str:
    """As it is printed: constants that terms have in common stand before their bracket."""
    return _sum_of(map(_factored, _alike(_folded(_folded(_together(terms)))))) or "0"


def _sum_of(signed: Iterable[tuple[bool, str]]) -> str:
    text = ""
    for negative, shown in signed:
        text += f" {'-' if negative else '+'} {shown}" if text else f"{'-' * negative}{shown}"
    return text


def _alike(terms: list[Term]) -> list[list[Term]]:
    """Terms with the same constants, two or more, each group in the place of its first."""
    groups: dict[tuple[object, ...], list[Term]] = {}
    for place, term in enumerate(terms):
        names = frozenset(_constants(term))
        key = (names, *sorted(term.below)) if len(names) > 1 else (place,)
        groups.setdefault(key, []).append(term)
    return list(groups.values())


def _factored(terms: list[Term]) -> tuple[bool, str]:
    """True if the sum stands after a minus, and the sum."""
    negative = terms[0].number < 0
    if len(terms) == 1:
        return negative, _shown(replace(terms[0], number=abs(terms[0].number)))
    common = reduce(and_, (Counter(_constants(term)) for term in terms))
    rest = [replace(each, above=tuple((Counter(each.above) - common).elements()), below=()) for each in terms]
    inner = _sum_of(((t.number < 0) != negative, _shown(replace(t, number=abs(t.number)))) for t in rest)
    return negative, _fraction([*_powers(tuple(common.elements())), f"({inner})"], _powers(terms[0].below))


def _constants(term: Term) -> list[str]:
    return [factor for factor in term.above if _NAME.fullmatch(factor) and not factor.startswith("gravity[")]


def _shown(term: Term) -> str:
    exact = Fraction(term.number).limit_denominator(_LARGEST_DENOMINATOR)
    simple = abs(float(exact) - term.number) <= _NOTHING * abs(term.number)
    above = [str(exact.numerator)] if simple and exact.numerator != 1 else [] if simple else [number_text(term.number)]
    below = [str(exact.denominator)] if simple and exact.denominator != 1 else []
    return _fraction([*above, *_powers(term.above)], [*below, *_powers(term.below)])


def _fraction(above: list[str], below: list[str]) -> str:
    line = "*".join(above) or "1"
    return line if not below else f"{line}/{below[0]}" if len(below) == 1 else f"{line}/({'*'.join(below)})"


def _powers(factors: tuple[str, ...]) -> list[str]:
    return [f"{factor}^{times}" if times > 1 else factor for factor, times in Counter(factors).items()]


def _folded(terms: list[Term]) -> list[Term]:
    """Partial derivatives that differ by one index, 1, 2, 3 and so on, as a sum over it, in the place of the first."""
    found: list[Term] = []
    rest = list(terms)
    while rest:
        likes, places = [rest.pop(0)], None
        following = 0 if _has_partial(likes[0]) else len(rest)
        while following < len(rest):
            differing = _next_index(likes[0], rest[following], len(likes) + 1)
            if differing is None or places not in (None, differing):
                following += 1
            else:
                likes.append(rest.pop(following))
                places, following = differing, 0
        found.append(likes[0] if places is None else _sum(likes, places))
    return found


def _next_index(first: Term, other: Term, number: int) -> tuple[int, ...] | None:
    """The places of the index which is 1 in one term and `number` in the other; None if they differ otherwise."""
    texts = [_shown(replace(term, number=1.0)) for term in (first, other)]
    if _INDEX.sub("", texts[0]) != _INDEX.sub("", texts[1]):
        return None
    pairs = list(zip(*(_INDEX.findall(text) for text in texts), strict=True))
    differing = tuple(place for place, (a, b) in enumerate(pairs) if a != b)
    return differing if differing and all(pairs[place] == ("1", str(number)) for place in differing) else None


def _has_partial(term: Term) -> bool:
    return any(call == _PARTIAL for factor in term.above for call in re.findall(r"\w+\(", factor))


def _sum(terms: list[Term], places: tuple[int, ...]) -> Term:
    text = _shown(replace(terms[0], number=1.0))
    letter = _LETTERS[f" for {_LETTERS[0]} in " in text]
    found = list(_INDEX.finditer(text))
    for place in reversed(places):
        text = text[: found[place].start()] + letter + text[found[place].end() :]
    numbers = [term.number for term in terms]
    alike = max(numbers) - min(numbers) <= _NOTHING * abs(numbers[0])
    weights = "" if alike else f"{{{', '.join(map(number_text, numbers))}}}[{letter}]*"
    return Term(numbers[0] if alike else 1.0, (f"sum({weights}{text} for {letter} in 1:{len(terms)})",))
