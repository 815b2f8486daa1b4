"""A report before it has a format: headings, paragraphs, formulas, tables, lists."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from lagdsl.documents.report.boxes import Box, Operator, Row
from lagdsl.documents.report.marks import Figure


@dataclass(frozen=True, slots=True)
class Text:
    """Plain words; every format escapes them."""

    text: str


@dataclass(frozen=True, slots=True)
class Code:
    """A piece of the model's own text."""

    text: str


@dataclass(frozen=True, slots=True)
class Strong:
    text: str


@dataclass(frozen=True, slots=True)
class Math:
    box: Box


Inline: TypeAlias = tuple[Text | Code | Strong | Math, ...]


@dataclass(frozen=True, slots=True)
class Heading:
    """`step` is the number of a step of the recipe, for sections that are one; `units` if it is about them alone."""

    title: str
    step: str | None = None
    units: bool = False


@dataclass(frozen=True, slots=True)
class Paragraph:
    content: Inline


@dataclass(frozen=True, slots=True)
class Equation:
    """`left = right` and, where units are asked for, theirs; formats break a long sum on the right."""

    left: Box
    right: Box
    final: bool = False
    unit: str | None = None


@dataclass(frozen=True, slots=True)
class Equations:
    lines: tuple[Equation, ...]


@dataclass(frozen=True, slots=True)
class Table:
    header: tuple[str, ...]
    rows: tuple[tuple[Inline, ...], ...]


@dataclass(frozen=True, slots=True)
class Bullets:
    items: tuple[Inline, ...]


@dataclass(frozen=True, slots=True)
class Drawing:
    """A figure with its legend; formats of text alone leave it out."""

    figure: Figure
    legend: Inline


Block: TypeAlias = Heading | Paragraph | Equations | Table | Bullets | Drawing


@dataclass(frozen=True, slots=True)
class Document:
    title: str
    subtitle: str | None
    blocks: tuple[Block, ...]


def filled(blocks: Sequence[Block]) -> tuple[Block, ...]:
    """Without equations that have no lines, and without headings that nothing follows."""
    kept = [block for block in blocks if not isinstance(block, Equations) or block.lines]
    following = [*kept[1:], Heading("")]
    return tuple(
        block
        for block, after in zip(kept, following, strict=True)
        if not (isinstance(block, Heading) and isinstance(after, Heading))
    )


def text(words: str) -> Inline:
    return (Text(words),)


def with_code(words: str) -> Inline:
    """Words of this report, not of a model, in which backticks mark code."""
    pieces = words.split("`")
    return tuple(Code(piece) if number % 2 else Text(piece) for number, piece in enumerate(pieces) if piece)


def with_formulas(words: str, formulas: Sequence[tuple[Box, Box]]) -> Inline:
    """Words, and equations in their line."""
    pieces: list[Text | Code | Strong | Math] = [Text(f"{words} ")]
    for number, (left, right) in enumerate(formulas):
        pieces += [Text(", ")] if number else []
        pieces.append(Math(Row((left, Operator("="), right))))
    return (*pieces, Text("."))


def inline(
    content: Inline,
    math: Callable[[Box], str],
    words: Callable[[str], str],
    strong: Callable[[str], str],
    code: Callable[[str], str],
) -> str:
    """The pieces of a text in the marks of a format."""
    pieces = []
    for piece in content:
        match piece:
            case Math(box):
                pieces.append(math(box))
            case Text(text):
                pieces.append(words(text))
            case Strong(text):
                pieces.append(strong(text))
            case Code(text):
                pieces.append(code(text))
    return "".join(pieces)
