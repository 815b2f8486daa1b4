"""Tokens as they are without a parser, comments, and what a token may not be: too long, a number that is not finite."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any, cast

from lark import Token
from lark.exceptions import UnexpectedCharacters
from lark.lexer import LexerState, LineCounter
from lark.utils import TextSlice

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.language.syntax import limits
from lagdsl.language.syntax.language import plain_lexer
from lagdsl.language.syntax.vocabulary import pattern, soft_terminals, vocabulary

END_OF_TEXT = "$END"

_STRANGE = re.compile(
    r"[“„«”][^“”„«»\n]*[”“»]|‘[^‘’\n]*’|\\[A-Za-z]+(?:\{[^{}\n]*\}|\\[A-Za-z]+)*|&&|\|\||\|[^|\n;]+\||[!~]=|(?<![\w)\]'])'[^'\n]*'|['′’´]+|%[A-Za-z]\w*|°(?:[CF]|/[a-z]+)|[^\W\x00-\x7f]\w*|[\s\S]"
)


@record()
class Comment:
    """`text` with its marks; kept for the formatter."""

    text: str
    start: int
    end: int


def token_at(terminal: str, text: str, start: int, end: int) -> Token:
    """A token of characters `start` to `end`; lines and columns are computed from them where they are shown."""
    return Token(terminal, text, start, None, None, None, None, end)


def start_of(token: Token) -> int:
    assert token.start_pos is not None
    return token.start_pos


def end_of(token: Token) -> int:
    assert token.end_pos is not None
    return token.end_pos


def span_of(file: SourceFile, token: Token) -> Span:
    return Span(file, start_of(token), end_of(token))


def as_name(token: Token) -> Token:
    """The token; a word that is a keyword only where the parser takes it as one is a name."""
    return (
        token.update(type="IDENT")
        if token.type in soft_terminals() and token.value not in vocabulary().reserved
        else token
    )


def as_text(token: Token) -> Token:
    """The token; a text in quotes that is not closed ends with its line."""
    if token.type != "UNCLOSED_STRING":
        return token
    return token.update(type="STRING", value=token.value.replace("\\", "") + '"')


def lexer_state(text: str, position: int) -> LexerState:
    """Reading `text` from `position` on, without counting its lines."""
    places: Any = cast(Any, LineCounter)("\n")
    places.char_pos = position
    return LexerState(TextSlice(text, 0, len(text)), places)


def plain_tokens(text: str, position: int = 0) -> Iterator[Token]:
    """The tokens of `text` from `position` on without regard to a parser; leaves out what is no token."""
    lexer, state = plain_lexer(), lexer_state(text, position)
    while True:
        try:
            for token in lexer.lex(state, None):
                if token.type != "UNCLOSED_COMMENT":
                    yield as_text(as_name(token))
        except UnexpectedCharacters as fault:
            state.line_ctr.char_pos = strange_text(text, fault)[1]
        else:
            return


def goes_over_a_line_end(token: Token) -> bool:
    """True of text in quotes that is most likely not closed on its line."""
    return token.type == "STRING" and "\n" in token.value


def comments(text: str) -> list[Comment]:
    """All comments. They stand between the tokens, and nothing else does but blanks."""
    found: list[Comment] = []
    end = 0
    for token in (*plain_tokens(text), token_at(END_OF_TEXT, "", len(text), len(text))):
        if "/" in text[end : start_of(token)]:
            matches = pattern("COMMENT").finditer(text, end, start_of(token))
            found += [Comment(match[0], *match.span()) for match in matches]
        end = end_of(token)
    return found


def strange_text(text: str, fault: UnexpectedCharacters) -> tuple[str, int]:
    """Text that begins no token, and the position behind it.

    A character, a mark of other languages, or a whole word in letters of another alphabet; `#`, and `%` where a
    statement may begin, begin what other languages take for a comment.
    """
    assert fault.pos_in_stream is not None
    position = fault.pos_in_stream
    match = _STRANGE.match(text, position)
    assert match is not None
    first = text[text.rfind("\n", 0, position) + 1 : position].strip()[-1:] in ("", ";")
    mark = match[0][0] if match[0][0] == "%" and first else match[0]
    line_end = text.find("\n", match.end()) if mark == "#" or (mark == "%" and first) else match.end()
    return mark, line_end if line_end >= 0 else len(text)


# ---- what a token may not be ---------------------------------------------------------------------------------------


def check_length(token: Token, sink: Sink, file: SourceFile, what: str, limit: int) -> None:
    """A name or a text in quotes of absurd length is refused."""
    if end_of(token) - start_of(token) > limit:
        sink.report("E0124", span_of(file, token), what=what, limit=limit)


def check_number(token: Token, sink: Sink, file: SourceFile) -> None:
    """A literal that is no finite number, that is not zero and would become it, or of absurd length is refused."""
    match = pattern("NUMBER").match(token.value)
    assert match is not None
    span = Span(file, start_of(token), start_of(token) + match.end())
    if len(match[0]) > limits.MAX_NUMBER:
        sink.report("E0124", span, what="number", limit=limits.MAX_NUMBER)
    elif float(match[0]) == float("inf"):
        sink.report("E0116", span, extreme="large")
    elif float(match[0]) == 0.0 and match[0].strip("0.")[:1] not in ("", "e", "E"):
        sink.report("E0116", span, extreme="small")


def second_division(text: str, token: Token) -> tuple[int, int] | None:
    """Place of a second `/` with a unit behind it and the end of that unit, after a quantity whose unit has one."""
    if "/" not in token.value or not (match := _second_slash().match(text, end_of(token))):
        return None
    return match.start(1), match.end()


@cache
def _second_slash() -> re.Pattern[str]:
    from lagdsl.foundation.units.vocabulary import UNITS

    return re.compile(rf"[ \t]*(/)[ \t]*(?:{'|'.join(UNITS)})(?:[1-9]|\^-?[1-9])?(?![A-Za-z0-9_^])")


def unit_of(quantity: str) -> str:
    """`m/s2` of `9.81 m/s2`."""
    return pattern("NUMBER").sub("", quantity, count=1).lstrip(" \t")
