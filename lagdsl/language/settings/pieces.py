"""Numbers with and without units, as they stand in lists and ranges."""

from __future__ import annotations

import re

# Exponents of three digits: with more, the exact fractions of ranges would fill the memory.
NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,3}(?!\d))?"
QUANTITY = re.compile(rf"\s*({NUMBER})\s*(.*?)\s*")


def pieces_of(text: str, unit: str = "") -> list[str]:
    """The values of a list; a unit at its end counts for all that have none."""
    pieces = text.split(",")
    last = QUANTITY.fullmatch(pieces[-1])
    common = unit or (last[2] if last else "")
    found = [QUANTITY.fullmatch(piece) for piece in pieces]
    return [
        f"{each[1]} {each[2] or common}".strip() if each else piece.strip()
        for piece, each in zip(pieces, found, strict=True)
    ]
