"""Cuts the text into tokens. Whether a word is a keyword is asked of the parser's state: elsewhere it is a name."""

from __future__ import annotations

import re
from collections.abc import Container
from dataclasses import dataclass
from typing import NamedTuple

from lagdsl.diagnostics import Sink
from lagdsl.diagnostics.catalog.syntax import character_help
from lagdsl.source import SourceFile, Span
from lagdsl.syntax import limits, tables
from lagdsl.syntax.automaton import END_OF_TEXT, TERMINAL

IDENT = TERMINAL["IDENT"]
NUMBER = TERMINAL["NUMBER"]
QUANTITY = TERMINAL["QUANTITY"]
STRING = TERMINAL["STRING"]
RESERVED = frozenset(tables.RESERVED)

_LITERALS = {"quantity": QUANTITY, "number": NUMBER, "string": STRING}
_SCANNER = re.compile(
    "|".join(
        (
            r"(?P<blank>[ \t\r\n]+)",
            r"(?P<word>[A-Za-z_][A-Za-z0-9_]*)",
            f"(?P<quantity>{tables.PATTERNS['QUANTITY']})",
            f"(?P<number>{tables.PATTERNS['NUMBER']})",
            f"(?P<string>{tables.PATTERNS['STRING']})",
            f"(?P<comment>{tables.PATTERNS['COMMENT']})",
            r"(?P<open_comment>/\*)",
            r'(?P<open_string>"[^\n]*)',
            f"(?P<mark>{'|'.join(map(re.escape, tables.MARKS))})",
            r"(?P<unknown>[\s\S])",
        )
    )
)
_SECOND_SLASH = re.compile(rf"[ \t]*(/)[ \t]*(?:{'|'.join(tables.UNITS)})(?:[1-9]|\^-?[1-9])?(?![A-Za-z0-9_^])")


class Token(NamedTuple):
    """A terminal of the grammar with its characters `start` to `end`."""

    terminal: int
    text: str
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Comment:
    """`text` with its marks; kept for the formatter."""

    text: str
    start: int
    end: int


class Lexer:
    """Tokens of a file, one at a time. Reports what is no token and goes on behind it."""

    def __init__(self, file: SourceFile, sink: Sink) -> None:
        self.file = file
        self.sink = sink
        self.position = 0
        self.comments: list[Comment] = []
        self.fault_at = -1  # where the last thing was that is no token

    def next(self, accepted: Container[int] = ()) -> Token:
        """The next token; a word is a keyword if its terminal is among the `accepted` ones or the word is reserved."""
        text = self.file.text
        while self.position < len(text):
            match = _SCANNER.match(text, self.position)
            assert match is not None
            kind, start, end = match.lastgroup, match.start(), match.end()
            self.position = end
            match kind:
                case "word":
                    return self._word(match[0], start, end, accepted)
                case "mark":
                    return self._mark(match[0], start, accepted)
                case "quantity" | "number" | "string":
                    return self._literal(kind, match[0], start, end)
                case "comment":
                    self.comments.append(Comment(match[0], start, end))
                case "blank":
                    pass
                case "open_comment":
                    self.sink.report("E0107", self.span(start, end))
                    self.position = len(text)
                case "open_string":
                    self.fault_at = start
                    self.sink.report("E0126", self.span(start, start + 1))
                    return Token(STRING, match[0].replace("\\", "") + '"', start, end)
                case _:
                    self._unknown(start)
        return Token(END_OF_TEXT, "", len(text), len(text))

    def rewind(self, position: int) -> None:
        """Go on from an earlier place."""
        self.position = position
        while self.comments and self.comments[-1].start >= position:
            self.comments.pop()

    def span(self, start: int, end: int) -> Span:
        return Span(self.file, start, end)

    def _word(self, text: str, start: int, end: int, accepted: Container[int]) -> Token:
        if end - start > limits.MAX_NAME:
            self.sink.report("E0124", self.span(start, end), what="name", limit=limits.MAX_NAME)
        terminals = tables.WORDS.get(text, ())
        for terminal in terminals:
            if terminal in accepted:
                return Token(terminal, text, start, end)
        return Token(terminals[0] if text in RESERVED else IDENT, text, start, end)

    def _mark(self, text: str, start: int, accepted: Container[int]) -> Token:
        """A mark; two characters are one mark only if the parser takes them so (`import A.*`)."""
        if len(text) == 2 and tables.MARKS[text] not in accepted and tables.MARKS.get(text[0]) in accepted:
            text = text[0]
            self.position = start + 1
        return Token(tables.MARKS[text], text, start, self.position)

    def _literal(self, kind: str, text: str, start: int, end: int) -> Token:
        if kind == "string":
            if end - start > limits.MAX_STRING:
                self.sink.report("E0124", self.span(start, end), what="text", limit=limits.MAX_STRING)
            return Token(STRING, text, start, end)
        self._check_number(start, end)
        second = _SECOND_SLASH.match(self.file.text, end) if kind == "quantity" and "/" in text else None
        if second is not None:
            self.sink.report("E0104", self.span(*second.span(1)), unit=unit_of(text))
            self.position = second.end()
        return Token(_LITERALS[kind], text, start, end)

    def _check_number(self, start: int, end: int) -> None:
        """A literal that is no finite number, that is not zero and would become it, or of absurd length is refused."""
        match = _NUMBER.match(self.file.text, start, end)
        assert match is not None
        if len(match[0]) > limits.MAX_NUMBER:
            self.sink.report("E0124", self.span(*match.span()), what="number", limit=limits.MAX_NUMBER)
        elif float(match[0]) == float("inf"):
            self.sink.report("E0116", self.span(*match.span()), extreme="large")
        elif float(match[0]) == 0.0 and match[0].strip("0.")[:1] not in ("", "e", "E"):
            self.sink.report("E0116", self.span(*match.span()), extreme="small")

    def _unknown(self, start: int) -> None:
        """A character that begins no token; a word in letters of another alphabet is reported as a whole."""
        text = self.file.text
        match = _STRANGE.match(text, start)
        assert match is not None
        end = self.position = match.end()
        if text[start] == "#":  # a comment as other languages write it: one fault, whatever it says
            line_end = text.find("\n", end)
            self.position = line_end if line_end >= 0 else len(text)
        self.fault_at = start
        spelled = "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in text[start : min(end, start + 20)])
        self.sink.report("E0108", self.span(start, end), character=spelled, help=character_help(text[start:end]))
        if len(self.sink.diagnostics) >= limits.MAX_ERRORS:
            self.position = len(text)


_NUMBER = re.compile(tables.PATTERNS["NUMBER"])
_STRANGE = re.compile(r"&&|\|\||[^\W\x00-\x7f]\w*|[\s\S]")


def unit_of(quantity: str) -> str:
    """`m/s2` of `9.81 m/s2`."""
    return _NUMBER.sub("", quantity, count=1).lstrip(" \t")
