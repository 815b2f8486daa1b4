"""A figure as a TikZ picture."""

from __future__ import annotations

from lagdsl.documents.report.latex_math import tex
from lagdsl.documents.report.marks import COLORS, LOAD, WEIGHT, Ball, Caption, Figure, Mark, Place, Stroke, color

_STROKES = {
    "rod": "line width=2.2pt, line cap=round",
    "thin": "line width=1pt",
    "outline": "line width=1.4pt, black!60",
    "ground": "line width=0.8pt, black!50",
    "reference": "line width=0.5pt, dashed, black!60",
}
_WIDTHS = {"coordinate": 0.8, "motion": 1.2, "load": 1.5, "weight": 1.1}
DEFINITIONS = "\n".join(
    rf"\definecolor{{figure{value}}}{{HTML}}{{{value.upper()}}}" for value in (*COLORS, LOAD, WEIGHT)
)


def tikz(figure: Figure) -> str:
    marks = "\n".join(_mark(mark) for mark in figure.marks)
    clip = f"\\clip (0,0) rectangle ({figure.width:g},{figure.height:g});"
    inside = f"\\begin{{tikzpicture}}[x=1pt,y=1pt]\n{clip}\n{marks}\n\\end{{tikzpicture}}"
    return f"\\begin{{center}}\n{inside}\n\\end{{center}}"


def _mark(mark: Mark) -> str:
    if isinstance(mark, Caption):
        x, y = mark.at
        return f"\\node[inner sep=0pt] at ({x:g},{y:g}) {{${tex(mark.label)}$}};"
    if isinstance(mark, Stroke):
        return rf"\draw[{_STROKES[mark.style]}] {_way(mark.points)};"
    if isinstance(mark, Ball):
        x, y = mark.center
        style = r"\draw[line width=1.4pt, fill=white]" if mark.hollow else r"\fill"
        return f"{style} ({x:g},{y:g}) circle ({mark.radius:g});"
    ink = f"figure{color(mark)}"
    body = rf"\draw[-latex, {ink}, line width={_WIDTHS[mark.role]}pt] {_way(mark.points)};"
    if mark.label is None:
        return body
    x, y = mark.at
    return f"{body}\n\\node[{ink}, inner sep=0pt] at ({x:g},{y:g}) {{${tex(mark.label)}$}};"


def _way(points: tuple[Place, ...]) -> str:
    return " -- ".join(f"({x:g},{y:g})" for x, y in points)
