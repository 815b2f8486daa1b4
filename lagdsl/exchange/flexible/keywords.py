"""Lines of input decks: `*KEYWORD, PARAMETER=VALUE`, then lines of cells between commas; `**` opens a comment."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import field

from lagdsl.exchange.flexible.refusal import Refused, line_span
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile, Span

LONGEST = 12
"""Digits of a number of a node or an element."""


@record(kw_only=True)
class Line:
    """Cells of a data line. A comma at its end opens no cell."""

    file: SourceFile
    number: int
    cells: tuple[str, ...]

    @property
    def span(self) -> Span:
        return line_span(self.file, self.number)

    def positive(self, k: int, what: str) -> int:
        """Cell k as a number from 1 on. Raises Refused, E1201."""
        text = self.cells[k] if k < len(self.cells) else ""
        if not (text.isascii() and text.isdigit() and len(text) <= LONGEST and int(text) > 0):
            raise Refused("E1201", self.span, what=what, text=text, expected="a positive integer")
        return int(text)

    def real(self, k: int, what: str) -> float:
        """Cell k as a finite number. Raises Refused, E1201."""
        text = self.cells[k] if k < len(self.cells) else ""
        value = number_of(text)
        if value is None:
            raise Refused("E1201", self.span, what=what, text=text, expected="a finite number")
        return value


@record(kw_only=True)
class Block:
    """A keyword in capitals with single blanks, its parameters by their names in capitals, and its data lines."""

    keyword: str
    parameters: dict[str, str]
    span: Span
    lines: list[Line] = field(default_factory=list)


def number_of(text: str) -> float | None:
    """A finite number as Fortran and C write it, with `D` or `E` before the exponent; None for anything else."""
    if "_" in text:
        return None
    try:
        value = float(text.replace("D", "E").replace("d", "e"))
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def blocks(file: SourceFile) -> Iterator[Block]:
    """The keywords of a deck, one after the other. Raises Refused where data stand before the first one."""
    block: Block | None = None
    continued = False
    for number, text in enumerate(file.text.split("\n"), 1):
        line = text.strip()
        if not line or line.startswith("**"):
            continue
        if line.startswith("*"):
            if block is not None:
                yield block
            keyword, *rest = line[1:].split(",")
            name = " ".join(keyword.upper().split())
            block = Block(keyword=name, parameters=_parameters(rest), span=line_span(file, number))
            continued = line.endswith(",")
        elif block is None:
            raise Refused("E1201", line_span(file, number), what="the line", text=line[:40], expected="a keyword")
        elif continued:
            block.parameters.update(_parameters(line.split(",")))
            continued = line.endswith(",")
        elif block.keyword == "HEADING":
            continue
        else:
            cells = tuple(cell.strip() for cell in line.split(","))
            block.lines.append(Line(file=file, number=number, cells=cells[:-1] if cells[-1] == "" else cells))
    if block is not None:
        yield block


def _parameters(parts: list[str]) -> dict[str, str]:
    found = {}
    for part in parts:
        name, _, value = part.partition("=")
        if name.strip():
            found[" ".join(name.upper().split())] = value.strip().strip('"')
    return found
