"""Reports for a terminal: Unicode, at most about a hundred columns where formulas allow."""

from __future__ import annotations

import textwrap
import unicodedata
from typing import assert_never

from lagdsl.documents.report.broken import lines, sign_and_rest
from lagdsl.documents.report.document import (
    Block,
    Bullets,
    Document,
    Drawing,
    Equation,
    Equations,
    Heading,
    Inline,
    Paragraph,
    Table,
    inline,
)
from lagdsl.documents.report.unicode_math import line

_WIDTH = 96


def plain(document: Document) -> str:
    title = f"Derivation of the equations of motion: {_safe(document.title)}"
    parts = [title, "=" * _columns(title)]
    if document.subtitle:
        parts += [_safe(document.subtitle)]
    text = "\n".join([*parts, *(_block(block) for block in document.blocks)]).rstrip() + "\n"
    return unicodedata.normalize("NFC", text)


def _block(block: Block) -> str:
    match block:
        case Heading(title, step):
            heading = title if step is None else f"{step}. {title}"
            return f"\n{heading}\n{'-' * _columns(heading)}"
        case Paragraph(content):
            return _filled(_inline(content))
        case Equations(equations):
            return "\n".join(_equation(equation) for equation in equations)
        case Table(header, rows):
            return _table(header, rows)
        case Bullets(items):
            return "\n".join(_filled(_inline(item), "  • ", " " * 4) for item in items)
        case Drawing():
            return ""
        case _:
            assert_never(block)


def _equation(equation: Equation) -> str:
    result = []
    for part in lines(equation, _WIDTH - 16):
        if part.continued:
            sign, rest = sign_and_rest(part.right)
            result.append(f"            {'−' if sign == '-' else '+'} {line(rest).strip()}")
        else:
            words = line(part.right).strip()
            result.append(f"    {words}" if part.left is None else f"    {line(part.left)} = {words}")
    return "\n".join(result)


def _inline(content: Inline) -> str:
    return inline(content, line, _safe, _safe, _safe)


def _table(header: tuple[str, ...], rows: tuple[tuple[Inline, ...], ...]) -> str:
    cells = [list(header), *([_inline(cell) for cell in row] for row in rows)]
    keep = [i for i in range(len(header)) if any(row[i] for row in cells[1:])]
    widths = {i: max(_columns(row[i]) for row in cells) for i in keep}
    top, *below = ([_padded(row[i], widths[i]) for i in keep] for row in cells)
    narrow = _columns("  ".join(top).rstrip()) + 4 <= _WIDTH
    return "\n".join(map(_row, [top if narrow else [header[i] for i in keep], *below]))


def _row(cells: list[str]) -> str:
    """A row that is wider than a page goes on below, with a whole cell where it has room."""
    lines = ["   "]
    for number, cell in enumerate(cells):
        gap = " " if number == 0 else "  "
        if _columns(f"{lines[-1]}{gap}{cell.rstrip()}") <= _WIDTH:
            lines[-1] += f"{gap}{cell}"
        else:
            lines += _filled(cell.rstrip(), " " * 8, " " * 8).split("\n")
    return "\n".join(line.rstrip() for line in lines)


def _filled(words: str, first: str = "", following: str = "") -> str:
    return textwrap.fill(
        words,
        _WIDTH,
        initial_indent=first,
        subsequent_indent=following,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _padded(text: str, width: int) -> str:
    return text + " " * (width - _columns(text))


def _columns(text: str) -> int:
    """Width on a terminal: marks over letters take no room."""
    return sum(not unicodedata.combining(c) for c in text)


def _safe(text: str) -> str:
    """Words without control characters, which a terminal would obey."""
    return "".join(c if c.isprintable() else " " for c in text)
