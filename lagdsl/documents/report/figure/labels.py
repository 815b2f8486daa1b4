"""Labels of a figure: formulas as letters of two heights in one line, ∂r₁/∂θ with its indices below the line, and their
places: near what they name, on no line, on no other label, inside of the picture.

Each label has candidates around its anchor; the cheapest one is taken, label by label, and all are looked at again
among the places of the others. After J. Christensen, J. Marks and S. Shieber, "An empirical study of algorithms for
point-feature label placement", ACM Transactions on Graphics 14 (1995) 203-232: the greedy descent there.

Rectangles are rows (n, 4): the middle, then half the width and half the height.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from lagdsl.documents.report import boxes
from lagdsl.documents.report.marks import Arrow, Ball, Caption, Mark, Stroke
from lagdsl.documents.report.unicode_math import line
from lagdsl.foundation.numerics.rank import Floats

_LETTER, _LOW_LETTER = 7.2, 5.4
_HALF_HEIGHT = 8.0
_EDGE = 2.0
_OVER_LABEL, _OVER_LINE, _OVER_BALL = 40.0, 3.0, 12.0
# From the wanted direction to both sides of it.
_TURNS = np.array([0, -1, 1, -2, 2, -3, 3, -4, 4, -5, 5, -6])
_DISTANCES = np.array([0.0, 6.0, 14.0, 24.0])
_ROUNDS = 3


def labelled(marks: Sequence[Mark], across: float, upward: float) -> tuple[Mark, ...]:
    """The marks with the places of their labels; the picture reaches from (0, 0) to (across, upward)."""
    result, room = list(marks), np.array([across, upward])
    lines = [pair for mark in marks if isinstance(mark, Stroke | Arrow) for pair in pairwise(mark.points)]
    balls = [(*m.center, m.radius + 1.0, m.radius + 1.0) for m in marks if isinstance(m, Ball)]
    candidates = {k: _candidates(m, room) for k, m in enumerate(marks) if isinstance(m, Arrow | Caption) and m.label}
    costs = {
        k: near + _OVER_LINE * _inside(own, np.array(lines).reshape(-1, 2, 2)) + _OVER_BALL * _shared(own, balls)
        for k, (own, near) in candidates.items()
    }
    places: dict[int, Floats] = {}
    for k, (own, _) in _ROUNDS * list(candidates.items()):
        others = [rectangle for j, rectangle in places.items() if j != k]
        places[k] = own[np.argmin(costs[k] + _OVER_LABEL * _shared(own, others))]
    for k, (x, y, _, _) in places.items():
        mark = result[k]
        assert isinstance(mark, Arrow | Caption)
        result[k] = replace(mark, at=(round(float(x), 1), round(float(y), 1)))
    return tuple(result)


def _shared(own: Floats, others: Sequence[Sequence[float] | Floats]) -> Floats:
    """Area (n,) that rectangles have in common with others."""
    a, b = own[:, None], np.array(others).reshape(1, -1, 4)
    both = a[..., 2:] + b[..., 2:] - np.abs(a[..., :2] - b[..., :2])
    return np.asarray(np.prod(np.maximum(both, 0.0), axis=2).sum(axis=1))


def _inside(own: Floats, lines: Floats) -> Floats:
    """Length (n,) of lines (m, 2, 2) within rectangles (Liang and Barsky, ACM TOG 3 (1984) 1)."""
    begin, way = lines[:, 0], lines[:, 1] - lines[:, 0]
    off, half = own[:, None, :2] - begin, own[:, None, 2:]
    slope = np.where(way == 0.0, 1e-12, way)
    ends = np.stack([(off - half) / slope, (off + half) / slope])
    first, last = ends.min(axis=0).max(axis=2), ends.max(axis=0).min(axis=2)
    parts = np.maximum(np.minimum(last, 1.0) - np.maximum(first, 0.0), 0.0)
    return np.asarray(parts @ np.linalg.norm(way, axis=1))


def _candidates(mark: Arrow | Caption, room: Floats) -> tuple[Floats, Floats]:
    """Rectangles around the anchors of a mark with the costs (n,) of their distances, the nearest first."""
    assert mark.label is not None
    half = np.array([width(mark.label) / 2.0 + 2.0, _HALF_HEIGHT])
    found, costs = [], []
    for anchor, way, dearer in _anchors(mark):
        turned = way * np.exp(2.0j * np.pi / len(_TURNS) * _TURNS)
        ways = np.stack([turned.real, turned.imag], axis=1)
        # The rectangle touches its anchor where the direction meets its edge.
        reach = (half / np.maximum(np.abs(ways), 1e-12)).min(axis=1)[:, None] + 3.0 + _DISTANCES
        own = anchor + reach[..., None] * ways[:, None]
        held = np.clip(own, half + _EDGE, room - half - _EDGE)
        away = np.linalg.norm(held - own, axis=2)
        costs.append(dearer + 0.6 * _DISTANCES + 2.5 * np.abs(_TURNS)[:, None] + 3.0 * away)
        found.append(np.concatenate([held, np.broadcast_to(half, held.shape)], axis=2))
    near = np.ravel(costs)
    order = np.argsort(near, kind="stable")
    return np.reshape(found, (-1, 4))[order], near[order]


def _anchors(mark: Arrow | Caption) -> Iterator[tuple[Floats, complex, float]]:
    """Places to stand at, the direction away from each, and how much dearer it is than the first."""
    if isinstance(mark, Caption):
        yield np.array(mark.point), np.exp(0.25j * np.pi), 0.0
        return
    points = np.array(mark.points)
    if mark.role != "coordinate":
        yield points[-1], _unit(points[-1] - points[0]), 0.0
        return
    for part, dearer in ((0.5, 0.0), (0.3, 4.0), (0.7, 4.0), (0.95, 8.0)):
        k = min(int(part * (len(points) - 1)), len(points) - 2)
        way = points[k + 1] - points[k]
        middle = points[k] if len(points) > 2 else points[0] + part * way
        yield middle, -1j * _unit(way), dearer
        yield middle, 1j * _unit(way), dearer + 2.0


def _unit(way: Floats) -> complex:
    """The direction of a vector (2,), x as the real part; to the right where it is zero."""
    return complex(np.exp(1j * np.arctan2(way[1], way[0])))


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
