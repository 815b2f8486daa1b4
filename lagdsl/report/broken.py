"""Equations in lines: long sums are broken between their terms, everything else stays whole."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from lagdsl.report.boxes import EQUALS, Box, Bracket, Fraction, Number, Row, Sum
from lagdsl.report.document import Equation
from lagdsl.report.unicode_math import line

Sign: TypeAlias = Literal["+", "-"]


@dataclass(frozen=True, slots=True)
class Line:
    """One line of an equation: `left = right`, or a `right` alone; a continued one starts with its sign."""

    left: Box | None
    right: Box
    continued: bool = False


def lines(equation: Equation, width: int) -> list[Line]:
    """The equation in lines of about `width` letters; a long left-hand side takes lines of its own."""
    right = _broken(equation.right, width)
    if len(line(equation.left)) <= width // 2:
        return [Line(equation.left, right[0]), *(Line(None, other, True) for other in right[1:])]
    first, *others = [*_broken(equation.left, width)]
    result = [Line(None, first), *(Line(None, other, True) for other in others)]
    last = result[-1]
    whole = Row((last.right, EQUALS, equation.right))
    if len(line(whole)) <= width:
        return [*result[:-1], Line(None, whole, last.continued)]
    return [*result, Line(None, Row((EQUALS, right[0]))), *(Line(None, other, True) for other in right[1:])]


def sign_and_rest(box: Box) -> tuple[Sign, Box]:
    """The sign a continued line starts with, and the line without it."""
    if isinstance(box, Sum) and box.terms:
        (sign, first), *others = box.terms
        return sign, Sum((("+", first), *others))
    if isinstance(box, Row) and box.items:
        sign, rest = sign_and_rest(box.items[0])
        return sign, Row((rest, *box.items[1:]))
    return "+", box


def _broken(box: Box, width: int) -> list[Box]:
    """Boxes to be set one under the other; each but the first starts with its sign."""
    if len(line(box)) <= width:
        return [box]
    whole = box if isinstance(box, Sum) else Sum((("+", box),))
    terms = [part for sign, term in whole.terms for part in _distributed(sign, term, width)]
    if len(terms) == 1:
        return [box]
    pieces: list[Sum] = []
    room = 0
    for term in terms:
        length = len(line(term[1])) + 3
        if not pieces or length > room:
            pieces.append(Sum((term,)))
            room = width - length
        else:
            pieces[-1] = Sum((*pieces[-1].terms, term))
            room -= length
    return list(pieces)


def _distributed(sign: Sign, term: Box, width: int) -> list[tuple[Sign, Box]]:
    """A product too long for a line, multiplied into its bracket; with numbers in the bracket it stays as it is."""
    if not isinstance(term, Row) or len(line(term)) <= width:
        return [(sign, term)]
    brackets = [item for item in term.items if isinstance(item, Bracket) and isinstance(item.inside, Sum)]
    if not brackets:
        return [(sign, term)]
    longest = max(brackets, key=lambda bracket: len(line(bracket)))
    assert isinstance(longest.inside, Sum)
    inner = [(s, part.items if isinstance(part, Row) else (part,)) for s, part in longest.inside.terms]
    if any(isinstance(items[0], Number | Fraction) for _, items in inner):
        return [(sign, term)]
    place = term.items.index(longest)
    before, after = term.items[:place], term.items[place + 1 :]
    return [("+" if s == sign else "-", Row((*before, *items, *after))) for s, items in inner]
