"""A figure as SVG that stands inside a page or alone; every text is escaped."""

from __future__ import annotations

import math
from html import escape

from lagdsl.documents.report.boxes import Box
from lagdsl.documents.report.figure.labels import pieces
from lagdsl.documents.report.marks import Ball, Caption, Figure, Mark, Place, Stroke, color

_STROKES = {
    "rod": 'stroke-width="3" stroke-linecap="round"',
    "thin": 'stroke-width="1.4"',
    "outline": 'stroke-width="2" opacity="0.6"',
    "ground": 'stroke-width="1" opacity="0.5"',
    "reference": 'stroke-width="0.8" stroke-dasharray="4 3" opacity="0.7"',
}
_WIDTHS = {"coordinate": 1.2, "motion": 1.8, "load": 2.2, "weight": 1.6}
_HEAD = 7.0
_DROP = 3.0


def svg(figure: Figure, *, alone: bool = False) -> str:
    """One element, in the color of the text around it, which says what is drawn; `alone` in a file of its own."""
    space = 'xmlns="http://www.w3.org/2000/svg" ' if alone else ""
    marks = "".join(_mark(figure, mark) for mark in figure.marks)
    words = escape(figure.words, quote=True)
    return (
        f'<svg {space}viewBox="0 0 {figure.width:g} {figure.height:g}" '
        f'width="{figure.width:g}" height="{figure.height:g}" role="img" aria-label="{words}" fill="none" '
        f'stroke="currentColor" font-family="serif" font-size="13" font-style="italic">{marks}</svg>'
    )


def _mark(figure: Figure, mark: Mark) -> str:
    if isinstance(mark, Caption):
        return _label(figure, mark.label, mark.at, "currentColor")
    if isinstance(mark, Stroke):
        return f'<polyline points="{_points(figure, mark.points)}" {_STROKES[mark.style]}/>'
    if isinstance(mark, Ball):
        x, y = mark.center
        filled = 'fill="none" stroke-width="2"' if mark.hollow else 'fill="currentColor"'
        return f'<circle cx="{x:g}" cy="{figure.height - y:g}" r="{mark.radius:g}" {filled}/>'
    ink = f'stroke="#{color(mark)}"'
    body = f'<polyline points="{_points(figure, mark.points)}" {ink} stroke-width="{_WIDTHS[mark.role]}"/>'
    head = f'<polygon points="{_points(figure, head_of(mark.points, _HEAD))}" {ink} fill="#{color(mark)}"/>'
    return body + head + ("" if mark.label is None else _label(figure, mark.label, mark.at, f"#{color(mark)}"))


def _label(figure: Figure, label: Box, at: Place, ink: str) -> str:
    """An index stands below the line; what follows it goes back up."""
    spans, down = "", False
    for text, low in pieces(label):
        shift = f' dy="{_DROP if low else -_DROP:g}"' if low != down else ""
        small = ' font-size="10"' if low else ""
        spans += f"<tspan{shift}{small}>{escape(text)}</tspan>"
        down = low
    x, y = at
    return (
        f'<text x="{x:g}" y="{figure.height - y + 4:g}" text-anchor="middle" fill="{ink}" stroke="none">{spans}</text>'
    )


def _points(figure: Figure, points: tuple[Place, ...]) -> str:
    return " ".join(f"{x:g},{figure.height - y:g}" for x, y in points)


def head_of(points: tuple[Place, ...], size: float) -> tuple[Place, ...]:
    """The triangle at the end of a line."""
    (x0, y0), (x, y) = points[-2], points[-1]
    length = math.hypot(x - x0, y - y0) or 1.0
    dx, dy = (x - x0) / length * size, (y - y0) / length * size
    corners = ((x, y), (x - dx + 0.4 * dy, y - dy - 0.4 * dx), (x - dx - 0.4 * dy, y - dy + 0.4 * dx))
    return tuple((round(a, 1), round(b, 1)) for a, b in corners)
