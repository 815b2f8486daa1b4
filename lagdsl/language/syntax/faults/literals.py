"""Faults of literals: a unit that is none, text in quotes that is not closed."""

from __future__ import annotations

import re

from lark import Token

from lagdsl.foundation.diagnostics import Edit
from lagdsl.foundation.source import Span
from lagdsl.language.syntax.expected import expected, found
from lagdsl.language.syntax.session import Session
from lagdsl.language.syntax.tokens import end_of, goes_over_a_line_end, start_of
from lagdsl.language.syntax.unknown_unit import report_unknown_unit

_BRANCHES = ("elif", "elsif", "elsef")
_UNIT_LIKE = re.compile(r"[A-Za-z_][A-Za-z0-9_]*(?:[./^][A-Za-z0-9_^-]+)*")


def unit_after_number(session: Session, token: Token) -> bool:
    """A word on the line of a number before it: `5 Nm`. Read on as if it were a unit; `2 f(x)` is a product."""
    before, text = session.previous, session.file.text
    if before.type != "NUMBER" or token.type != "IDENT" or text[end_of(before) : start_of(token)].strip(" \t"):
        return False
    if token.value in _BRANCHES and session.stack.accepts("ELSEIF"):
        span = session.span(token)
        words, edit = expected(session.stack), Edit(span, "elseif")
        session.sink.report("E0100", span, found=found(token), expected=words, help="write `elseif`", edit=edit)
        return session.shift(token.update(type="ELSEIF", value="elseif"))
    match = _UNIT_LIKE.match(text, start_of(token))
    assert match is not None
    if match[0][0] == "_" or match[0] == "e":  # what follows is still the number
        session.reported.last = start_of(token)
    called = text[match.end() : match.end() + 1] == "("
    report_unknown_unit(session.sink, Span(session.file, *match.span()), before.value, match[0], called=called)
    if called and session.insert("*"):
        session.rewind(start_of(token))
    else:
        session.rewind(match.end())
    return True


def open_string(session: Session, token: Token) -> bool:
    """Text in quotes that went over a line end and closed where the next one was to begin."""
    before = session.previous
    if not goes_over_a_line_end(before) or start_of(token) < end_of(before):
        return False
    opened = session.opened_string(before)
    session.sink.report("E0126", Span(session.file, opened, opened + 1))
    session.stack.cut(session.stack.boundary())
    kept = session.stack.values[-1].end_pos if session.stack.values else 0
    session.brackets = [bracket for bracket in session.brackets if start_of(bracket) < kept]
    session.rewind(session.file.text.index("\n", opened))
    return True
