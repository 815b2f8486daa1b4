"""Fills lines: a statement is a run of texts and of places where its line may break."""

from __future__ import annotations

from dataclasses import dataclass

WIDTH = 110
CONTINUATION = 4


@dataclass(frozen=True, slots=True)
class Break:
    """A blank, or a line end where the text up to the next place of the same or an outer level does not fit."""

    level: int


Piece = str | Break


def fill(pieces: list[Piece], indent: int) -> list[str]:
    """The lines of a statement that begins in column `indent`; further lines are indented more."""
    needed = _needed_widths(pieces)
    lines, line = [], " " * indent
    for piece, width in zip(pieces, needed, strict=True):
        if isinstance(piece, str):
            line += piece
        elif len(line) + 1 + width <= WIDTH:
            line += " "
        else:
            lines.append(line)
            line = " " * (indent + CONTINUATION)
    return [*lines, line]


def flat(pieces: list[Piece]) -> str:
    """The statement on one line."""
    return "".join(piece if isinstance(piece, str) else " " for piece in pieces)


def _needed_widths(pieces: list[Piece]) -> list[int]:
    """For every break the width of what follows up to the next break of its level or of an outer one."""
    widths = [0] * len(pieces)
    waiting: list[tuple[int, int, int]] = []  # (position, level, width before) of breaks whose end is not yet met
    width = 0
    for position, piece in enumerate(pieces):
        if isinstance(piece, str):
            width += len(piece)
            continue
        while waiting and waiting[-1][1] >= piece.level:
            start, _, before = waiting.pop()
            widths[start] = width - before
        waiting.append((position, piece.level, width + 1))
        width += 1
    for start, _, before in waiting:
        widths[start] = width - before
    return widths
