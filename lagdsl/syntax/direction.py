"""Characters that change the direction of the text around them, or seem to end its lines, without being seen.

In a comment or a string they let a text look other than it is read (N. Boucher and R. Anderson, Trojan Source:
Invisible Vulnerabilities, USENIX Security 2023).
"""

from __future__ import annotations

import re
import unicodedata

from lagdsl.diagnostics import Sink
from lagdsl.source import SourceFile, Span

_CONTROLS = re.compile("[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069\u2028\u2029]")
_OPENS = {"\u202a": "\u202c", "\u202b": "\u202c", "\u202d": "\u202c", "\u202e": "\u202c"}
_OPENS |= {"\u2066": "\u2069", "\u2067": "\u2069", "\u2068": "\u2069"}
_CLOSES = frozenset(_OPENS.values())
# Comments first, so that quotes in them begin nothing.
_PARTS = re.compile(r'//[^\n]*|/\*.*?(?:\*/|\Z)|"(?:[^"\\\n]|\\.)*"', re.DOTALL)


def turned_text(file: SourceFile, sink: Sink) -> bool:
    """Reports E0137, once for each line, unless the characters stand in a string that is written from right to left and
    are closed there. True if it reported any."""
    if not _CONTROLS.search(file.text):
        return False
    allowed = [part.span() for part in _PARTS.finditer(file.text) if part[0].startswith('"') and _needs(part[0])]
    told: dict[int, list[int]] = {}
    for found in _CONTROLS.finditer(file.text):
        if not any(start <= found.start() < end for start, end in allowed):
            line = file.text.count("\n", 0, found.start())
            told.setdefault(line, []).append(found.start())
    for places in told.values():
        codes = ", ".join(dict.fromkeys(f"U+{ord(file.text[place]):04X}" for place in places))
        sink.report("E0137", Span(file, places[0], places[0] + 1), codes=codes)
    return bool(told)


def _needs(text: str) -> bool:
    """True if a string has letters from right to left, and closes in it what it opens."""
    waiting: list[str] = []
    for character in text:
        if character in _OPENS:
            waiting.append(_OPENS[character])
        elif character in _CLOSES and (not waiting or waiting.pop() != character):
            return False
    return not waiting and any(map(_is_letter_to_the_left, text))


def _is_letter_to_the_left(character: str) -> bool:
    return character.isalpha() and unicodedata.bidirectional(character) in ("R", "AL")
