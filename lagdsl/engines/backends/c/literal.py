"""Numbers and strings as C literals."""

from __future__ import annotations

import math

# A C11 compiler need not accept more than 4095 characters.
_LONGEST_STRING = 4000


def number(value: float) -> str:
    """A double literal that reads back as the same number."""
    if math.isnan(value):
        return "(double)NAN"
    text = repr(value) if math.isfinite(value) else ("(double)INFINITY" if value > 0 else "-(double)INFINITY")
    return f"({text})" if text.startswith("-") else text


def string(text: str) -> str:
    """A string literal of the UTF-8 bytes of `text`; everything unusual as octal escapes. Cut where C's limit is."""
    plain = text.encode("utf-8", errors="replace")[:_LONGEST_STRING]
    return '"' + "".join(_character(byte) for byte in plain) + '"'


def _character(byte: int) -> str:
    character = chr(byte)
    if byte < 128 and (character.isalnum() or character in " _.,:;()[]{}<>=+-*/^'!"):
        return character
    return f"\\{byte:03o}"
