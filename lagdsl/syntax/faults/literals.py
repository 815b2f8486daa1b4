"""Faults of literals: a unit that is none, text in quotes that is not closed."""

from __future__ import annotations

import re

from lagdsl.source import Span
from lagdsl.syntax.lexer import IDENT, NUMBER, STRING, Token
from lagdsl.syntax.session import Session
from lagdsl.syntax.unknown_unit import report_unknown_unit

_UNIT_LIKE = re.compile(r"[A-Za-z_][A-Za-z0-9_]*(?:[./^][A-Za-z0-9_^-]+)*")


def unit_after_number(session: Session, token: Token) -> bool:
    """A word on the line of a number before it: `5 Nm`. Read on as if it were a unit; `2 f(x)` is a product."""
    before, text = session.previous, session.file.text
    if before.terminal != NUMBER or token.terminal != IDENT or text[before.end : token.start].strip(" \t"):
        return False
    match = _UNIT_LIKE.match(text, token.start)
    assert match is not None
    called = text[match.end() : match.end() + 1] == "("
    report_unknown_unit(session.sink, Span(session.file, *match.span()), before.text, match[0], called=called)
    if called and session.insert("*"):
        session.lexer.rewind(token.start)
    else:
        session.lexer.rewind(match.end())
    return True


def open_string(session: Session, token: Token) -> bool:
    """Text in quotes that went over a line end and closed where the next one was to begin."""
    before = session.previous
    if before.terminal != STRING or "\n" not in before.text or token.start < before.end:
        return False
    session.sink.report("E0126", Span(session.file, before.start, before.start + 1))
    line_end = session.file.text.index("\n", before.start)
    height = session.machine.boundary()
    session.machine.cut(height)
    session.brackets = [bracket for bracket in session.brackets if bracket.start < session.machine.ends[-1]]
    session.lexer.rewind(line_end)
    return True
