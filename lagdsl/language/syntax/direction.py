"""Characters that are not seen: that change the direction of the text around them, seem to end its lines, command a
terminal, or hide a text of their own.

In a comment or a string they let a text look other than it is read (N. Boucher and R. Anderson, Trojan Source:
Invisible Vulnerabilities, USENIX Security 2023). Controls and the default ignorable code points of Unicode
(DerivedCoreProperties.txt) hide something; outside comments and strings the lexer refuses them.
"""

from __future__ import annotations

import re
import unicodedata

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile, Span

_CONTROLS = re.compile("[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069\u2028\u2029]")
# Joiners and variants of forms: letters of many scripts and pictures are written with them.
_JOINS = "\u200c\u200d\ufe00-\ufe0f"
_HIDDEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u00ad\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u200b\u2060-\u2065\u206a-\u206f\u3164"
    f"\ufeff\uffa0\ufff0-\ufffb\U0001bca0-\U0001bca3\U0001d173-\U0001d17a\U000e0000-\U000e0fff]|(?<![^\x00-\x7f])[{_JOINS}]"
)
_OPENS = {"\u202a": "\u202c", "\u202b": "\u202c", "\u202d": "\u202c", "\u202e": "\u202c"}
_OPENS |= {"\u2066": "\u2069", "\u2067": "\u2069", "\u2068": "\u2069"}
_CLOSES = frozenset(_OPENS.values())
# Comments first, so that quotes in them begin nothing.
_PARTS = re.compile(r'//[^\n]*|/\*.*?(?:\*/|\Z)|"(?:[^"\\\n]|\\.)*"', re.DOTALL)


def turned_text(file: SourceFile, sink: Sink) -> bool:
    """Reports E0137, once for each line, unless the characters stand in a string that is written from right to left and
    are closed there. True if it reported any."""
    turning, hidden = bool(_CONTROLS.search(file.text)), bool(_HIDDEN.search(file.text))
    if not (turning or hidden):
        return False
    parts = list(_PARTS.finditer(file.text))
    allowed = [part.span() for part in parts if part[0].startswith('"') and _needs(part[0])]
    found = [each.start() for each in _CONTROLS.finditer(file.text)]
    found = [place for place in found if not any(start <= place < end for start, end in allowed)]
    found += [each.start() for part in parts for each in _HIDDEN.finditer(file.text, *part.span())]
    told: dict[int, list[int]] = {}
    for place in sorted(found):
        told.setdefault(file.text.count("\n", 0, place), []).append(place)
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
