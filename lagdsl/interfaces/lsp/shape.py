"""Statements of a text as pieces, so that the findings of one version hold for another with the same statements.

While a statement is being typed, all others stay as they are, some lines further down: their findings are
known.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import replace

from lagdsl.foundation.diagnostics import Diagnostic, Edit, Label
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.language.syntax import nodes


@record()
class Piece:
    """A statement, or the head of a class with what else of it is no statement; `place` is where its text begins."""

    place: int
    text: str
    node: object


@record()
class Shape:
    """The pieces of the tree of `file`, in the order of the text."""

    file: SourceFile
    pieces: tuple[Piece, ...]

    def has_statements_of(self, other: Shape) -> bool:
        """True if the trees of both are equal but for their places."""
        return len(self.pieces) == len(other.pieces) and all(
            one.text == two.text and one.node == two.node for one, two in zip(self.pieces, other.pieces, strict=True)
        )


def shape_of(unit: nodes.Unit) -> Shape:
    """The pieces of a tree."""
    pieces: list[Piece] = []
    for item in unit.items:
        _add(item, pieces)
    within = None if unit.within is None else Piece(unit.within.span.start, unit.within.span.text, unit.within)
    return Shape(unit.span.file, (*([] if within is None else [within]), *pieces))


def _add(item: nodes.Item, pieces: list[Piece]) -> None:
    if not isinstance(item, nodes.Class):
        pieces.append(Piece(item.span.start, item.span.text, item))
        return
    head = Span(item.span.file, item.span.start, item.name_span.end)
    rest = item.prefixes, item.kind, item.doc, item.end_name
    pieces.append(Piece(head.start, head.text, rest))
    for each in item.items:
        _add(each, pieces)
    for section in item.sections:
        pieces.append(Piece(section.span.start, "", section.keyword))
        for each in section.items:
            _add(each, pieces)


def moved(found: tuple[Diagnostic, ...], old: Shape, new: Shape) -> tuple[Diagnostic, ...] | None:
    """Diagnostics of `old` at the places of `new`, which has the same statements; None if one is in no statement."""
    try:
        return tuple(_moved(each, old, new) for each in found)
    except LookupError:
        return None


def _moved(found: Diagnostic, old: Shape, new: Shape) -> Diagnostic:
    labels = tuple(Label(_place(each.span, old, new), each.text) for each in found.labels)
    edit = None if found.edit is None else Edit(_place(found.edit.span, old, new), found.edit.text)
    return replace(found, labels=labels, edit=edit)


def _place(span: Span, old: Shape, new: Shape) -> Span:
    if span.file is not old.file:
        return span
    return Span(new.file, _offset(span.start, old, new), _offset(span.end, old, new))


def _offset(offset: int, old: Shape, new: Shape) -> int:
    """Raises LookupError for an offset that lies in no piece."""
    number = bisect_right(old.pieces, offset, key=lambda piece: piece.place) - 1
    if number < 0 or offset > old.pieces[number].place + len(old.pieces[number].text):
        raise LookupError(offset)
    return offset - old.pieces[number].place + new.pieces[number].place
