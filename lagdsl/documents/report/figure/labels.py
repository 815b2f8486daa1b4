"""Places for the labels of a figure: near what they name, on no line, on no other label, inside of the picture.

Each label has candidates around its anchor; the cheapest one is taken, label by label, and all are looked at again
among the places of the others. After J. Christensen, J. Marks and S. Shieber, "An empirical study of algorithms for
point-feature label placement", ACM Transactions on Graphics 14 (1995) 203-232: the greedy descent there.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from lagdsl.documents.report.boxes import Box
from lagdsl.documents.report.figure.lettering import width
from lagdsl.documents.report.marks import Arrow, Ball, Caption, Place, Stroke

_HALF_HEIGHT = 8.0
_EDGE = 2.0
_OVER_LABEL, _OVER_LINE, _OVER_BALL = 40.0, 3.0, 12.0
_DIRECTIONS = 12
_DISTANCES = (0.0, 6.0, 14.0, 24.0)
_ROUNDS = 3


@dataclass(frozen=True)
class _Rectangle:
    x: float
    y: float
    wide: float  # half
    high: float  # half

    def shares(self, other: _Rectangle) -> float:
        """Area that both have."""
        across = self.wide + other.wide - abs(self.x - other.x)
        upward = self.high + other.high - abs(self.y - other.y)
        return across * upward if across > 0 and upward > 0 else 0.0

    def length_inside(self, a: Place, b: Place) -> float:
        """Of a line from a to b (Liang and Barsky, ACM TOG 3 (1984) 1)."""
        dx, dy = b[0] - a[0], b[1] - a[1]
        first, last = 0.0, 1.0
        for way, room in (
            (-dx, a[0] - self.x + self.wide),
            (dx, self.x + self.wide - a[0]),
            (-dy, a[1] - self.y + self.high),
            (dy, self.y + self.high - a[1]),
        ):
            if way == 0.0:
                if room < 0.0:
                    return 0.0
            elif way < 0.0:
                first = max(first, room / way)
            else:
                last = min(last, room / way)
        return max(last - first, 0.0) * math.hypot(dx, dy)


class _Candidate:
    """A place of a label. `near` is the cost of its distance; lines and balls stand still and are looked at once."""

    def __init__(self, near: float, rectangle: _Rectangle) -> None:
        self.near = near
        self.rectangle = rectangle
        self._fixed: float | None = None

    def cost(self, others: Iterable[_Rectangle], scene: _Scene) -> float:
        if self._fixed is None:
            self._fixed = self.near + scene.cost(self.rectangle)
        return self._fixed + _OVER_LABEL * sum(self.rectangle.shares(other) for other in others)


@dataclass(frozen=True)
class _Scene:
    """Lines and balls, on which no label should stand."""

    lines: Sequence[tuple[Place, Place]]
    balls: Sequence[_Rectangle]

    def cost(self, own: _Rectangle) -> float:
        crossed = sum(own.length_inside(a, b) for a, b in self.lines)
        return _OVER_LINE * crossed + _OVER_BALL * sum(own.shares(ball) for ball in self.balls)


def labelled(
    marks: Sequence[Stroke | Ball | Arrow | Caption], across: float, upward: float
) -> tuple[Stroke | Ball | Arrow | Caption, ...]:
    """The marks with the places of their labels; the picture reaches from (0, 0) to (across, upward)."""
    result = list(marks)
    lines = [pair for mark in marks if isinstance(mark, Stroke | Arrow) for pair in pairwise(mark.points)]
    balls = [_Rectangle(*m.center, m.radius + 1.0, m.radius + 1.0) for m in marks if isinstance(m, Ball)]
    scene = _Scene(lines, balls)
    candidates = {
        k: sorted(_candidates(mark, mark.label, across, upward), key=lambda each: each.near)
        for k, mark in enumerate(marks)
        if isinstance(mark, Arrow | Caption) and mark.label is not None
    }
    places: dict[int, _Rectangle] = {}
    for _ in range(_ROUNDS):
        for k, own in candidates.items():
            others = [rectangle for j, rectangle in places.items() if j != k]
            places[k] = _cheapest(own, others, scene)
    for k, rectangle in places.items():
        mark = result[k]
        assert isinstance(mark, Arrow | Caption)
        result[k] = replace(mark, at=(round(rectangle.x, 1), round(rectangle.y, 1)))
    return tuple(result)


def _cheapest(candidates: Sequence[_Candidate], others: Sequence[_Rectangle], scene: _Scene) -> _Rectangle:
    """`candidates` come with the nearest first: one that costs more by its distance than another does in all, and those
    behind it, need no look."""
    found, least = candidates[0].rectangle, math.inf
    for each in candidates:
        if each.near >= least:
            break
        cost = each.cost(others, scene)
        if cost < least:
            found, least = each.rectangle, cost
    return found


def _candidates(mark: Arrow | Caption, label: Box, across: float, upward: float) -> Iterator[_Candidate]:
    """Around the anchors of a mark."""
    wide = width(label) / 2.0 + 2.0
    for anchor, (way_x, way_y), dearer in _anchors(mark):
        for turn in range(_DIRECTIONS):
            # From the wanted direction to both sides of it.
            angle = math.pi / _DIRECTIONS * 2 * ((turn + 1) // 2) * (-1) ** turn
            x = way_x * math.cos(angle) - way_y * math.sin(angle)
            y = way_x * math.sin(angle) + way_y * math.cos(angle)
            for distance in _DISTANCES:
                # The rectangle touches its anchor where the direction meets its edge.
                reach = min(wide / abs(x) if x else math.inf, _HALF_HEIGHT / abs(y) if y else math.inf) + 3.0 + distance
                own = _Rectangle(anchor[0] + reach * x, anchor[1] + reach * y, wide, _HALF_HEIGHT)
                held = replace(
                    own,
                    x=min(max(own.x, wide + _EDGE), across - wide - _EDGE),
                    y=min(max(own.y, _HALF_HEIGHT + _EDGE), upward - _HALF_HEIGHT - _EDGE),
                )
                away = math.hypot(held.x - own.x, held.y - own.y)
                yield _Candidate(dearer + 0.6 * distance + 2.5 * ((turn + 1) // 2) + 3.0 * away, held)


def _anchors(mark: Arrow | Caption) -> Iterator[tuple[Place, tuple[float, float], float]]:
    """Places to stand at, the direction away from each, and how much dearer it is than the first."""
    if isinstance(mark, Caption):
        yield mark.point, (math.sqrt(0.5), math.sqrt(0.5)), 0.0
        return
    points = mark.points
    if mark.role != "coordinate":
        yield points[-1], _unit(points[0], points[-1]), 0.0
        return
    for part, dearer in ((0.5, 0.0), (0.3, 4.0), (0.7, 4.0), (0.95, 8.0)):
        k = min(max(int(part * (len(points) - 1)), 0), len(points) - 2)
        x, y = _unit(points[k], points[k + 1])
        middle = points[k] if len(points) > 2 else _between(points[0], points[1], part)
        yield middle, (y, -x), dearer
        yield middle, (-y, x), dearer + 2.0


def _unit(a: Place, b: Place) -> tuple[float, float]:
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = math.hypot(dx, dy)
    return (dx / length, dy / length) if length > 0 else (1.0, 0.0)


def _between(a: Place, b: Place, part: float) -> Place:
    return (a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]))
