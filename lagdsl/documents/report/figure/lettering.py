"""Formulas as letters of two heights in one line, for figures: ∂r₁/∂θ with its indices below the line."""

from __future__ import annotations

import unicodedata

from lagdsl.documents.report import boxes
from lagdsl.documents.report.unicode_math import line

_LETTER, _LOW_LETTER = 7.2, 5.4


def pieces(box: boxes.Box, *, low: bool = False) -> list[tuple[str, bool]]:
    """Texts, and whether each stands below the line."""
    match box:
        case boxes.Subscript(base, index):
            return [*pieces(base, low=low), (line(index).replace(" , ", ","), True)]
        case boxes.Derivative(letter, of, by):
            above = [] if of is None else pieces(of, low=low)
            return [(letter, low), *above, (f"/{letter}", low), *pieces(by, low=low)]
        case boxes.Joined(items):
            return [piece for item in items for piece in pieces(item, low=low)]
        case boxes.Row(items):
            apart = [[("\u2009", low), *pieces(item, low=low)] for item in items]
            return [piece for item in apart for piece in item][1:]
        case (boxes.Name() | boxes.Upright() | boxes.Number() | boxes.Operator() | boxes.Sum() | boxes.Fraction()
              | boxes.Power() | boxes.Root() | boxes.Dotted() | boxes.Call() | boxes.Bracket() | boxes.Marked()
              | boxes.Cases() | boxes.Column() | boxes.Matrix() | boxes.Unit()):  # fmt: skip
            return [(line(box), low)]


def width(box: boxes.Box) -> float:
    """In points of the figure, about."""
    return sum(_letters(text) * (_LOW_LETTER if low else _LETTER) for text, low in pieces(box))


def _letters(text: str) -> float:
    """Dots over a letter take no room, thin blanks little."""
    return sum(0.3 if each == "\u2009" else 1.0 for each in text if not unicodedata.combining(each))
