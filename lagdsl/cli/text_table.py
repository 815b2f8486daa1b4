"""Columns of text, the first flush left."""

from __future__ import annotations

from collections.abc import Sequence


def text_table(header: Sequence[str], rows: Sequence[Sequence[str]], indent: str = "  ") -> str:
    """A header and rows of equal length."""
    lines = [header, *rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    return "\n".join(
        (
            indent
            + "  ".join([line[0].ljust(widths[0]), *(c.rjust(w) for c, w in zip(line[1:], widths[1:], strict=True))])
        ).rstrip()
        for line in lines
    )


def number(value: float) -> str:
    """Six digits; no minus before a zero."""
    return f"{value + 0.0:.6g}"
