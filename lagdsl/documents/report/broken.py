"""Equations in lines: long sums are broken between their terms, everything else stays whole."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from lagdsl.documents.report.boxes import EQUALS, Box, Bracket, Marked, Row, Sum, Unit
from lagdsl.documents.report.document import Equation
from lagdsl.documents.report.unicode_math import line

Sign: TypeAlias = Literal["+", "-"]


@dataclass(frozen=True, slots=True)
class Line:
    """One line of an equation: `left = right`, or a `right` alone; a continued one starts with its sign."""

    left: Box | None
    right: Box
    continued: bool = False


def lines(equation: Equation, width: int) -> list[Line]:
    """The equation in lines of about `width` letters, its unit in the last one."""
    found = _lines(equation, width)
    if equation.unit is None:
        return found
    last = found[-1]
    return [*found[:-1], Line(last.left, Row((last.right, Unit(equation.unit))), last.continued)]


def _lines(equation: Equation, width: int) -> list[Line]:
    """A long left-hand side takes lines of its own."""
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
    if isinstance(box, Bracket) and not box.left:
        sign, rest = sign_and_rest(box.inside)
        return sign, Bracket(rest, False, box.right)
    if isinstance(box, Marked):
        sign, rest = sign_and_rest(box.inside)
        return sign, Marked(rest, box.sources)
    return "+", box


def _broken(box: Box, width: int) -> list[Box]:
    """Boxes to be set one under the other; each but the first starts with its sign."""
    if len(line(box)) <= width:
        return [box]
    whole = box if isinstance(box, Sum) else Sum((("+", box),))
    pieces: list[Box] = []
    waiting: list[tuple[Sign, Box]] = []
    for sign, term in whole.terms:
        parts = _opened(term, width) if len(line(term)) > width else [term]
        together = Sum((*waiting, (sign, parts[0])))
        if waiting and (len(parts) > 1 or len(line(together)) > width):
            pieces.append(Sum(tuple(waiting)))
            waiting = []
        waiting.append((sign, parts[0]))
        if len(parts) > 1:
            pieces += [Sum(tuple(waiting)), *parts[1:]]
            waiting = []
    pieces += [Sum(tuple(waiting))] if waiting else []
    return pieces if len(pieces) > 1 else [box]


def _opened(term: Box, width: int) -> list[Box]:
    """A product too long for a line, its longest bracket broken between the terms inside."""
    if isinstance(term, Marked):
        return [Marked(piece, term.sources) for piece in _opened(term.inside, width)]
    items = term.items if isinstance(term, Row) else (term,)
    brackets = [item for item in items if isinstance(item, Bracket) and isinstance(item.inside, Sum)]
    if not brackets:
        return [term]
    longest = max(brackets, key=lambda bracket: len(line(bracket)))
    place = items.index(longest)
    before, after = items[:place], items[place + 1 :]
    room = max(width - len(line(Row(before))) - 2, width // 2)
    inner = _broken(longest.inside, room)
    if len(inner) == 1:
        return [term]
    first, *middle, last = inner
    return [
        Row((*before, Bracket(first, right=False))),
        *(Bracket(piece, left=False, right=False) for piece in middle),
        Row((Bracket(last, left=False), *after)),
    ]
