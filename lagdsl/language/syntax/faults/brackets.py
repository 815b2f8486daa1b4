"""Faults of brackets: closed without being opened, closed by another kind, never closed."""

from __future__ import annotations

from lark import Token

from lagdsl.foundation.diagnostics import Edit, Label
from lagdsl.language.syntax.session import CLOSING, Session
from lagdsl.language.syntax.stack import statement_words
from lagdsl.language.syntax.tokens import END_OF_TEXT, end_of, start_of


def wrong_bracket(session: Session, token: Token) -> bool:
    """A closing bracket that no open one waits for."""
    if token.value not in CLOSING.values():
        return False
    if not session.brackets:
        session.sink.report("E0110", session.span(token), mark=token.value)
        return True  # read on without it
    opened = session.brackets[-1]
    closing = CLOSING[opened.value]
    if closing == token.value:
        return False
    waiting = [CLOSING[bracket.value] for bracket in session.brackets]
    if token.value in waiting:
        report_unclosed(session, opened, token)
        if session.insert(closing):
            session.rewind(start_of(token))
            return True
    else:
        label = Label(session.span(opened), "opened here")
        session.sink.report("E0112", session.span(token), label, mark=opened.value, found=token.value, closing=closing)
        if session.insert(closing):
            return True
    session.panic(token)
    return True


def unclosed_bracket(session: Session, token: Token) -> bool:
    """The statement ends, or another one begins, while a bracket is open."""
    if not session.brackets:
        return False
    opened = session.brackets[-1]
    ends = token.type in ("SEMICOLON", END_OF_TEXT) or token.value == "end"
    begins = session.starts_line(token) and (token.value in statement_words() or not _closes_ahead(session, token))
    rows = opened.value == "[" and _matrix_went_over_lines(session, opened, token)
    if not ends and not begins and not rows:
        return False
    report_unclosed(session, opened, token)
    if rows:
        session.panic(token)
        return True
    while session.brackets and session.insert(CLOSING[session.brackets[-1].value]):
        pass
    if session.brackets:
        session.panic(token)
    else:
        session.rewind(start_of(token))
    return True


def report_unclosed(session: Session, opened: Token, token: Token) -> None:
    """`token` stands where the bracket must be closed already."""
    closing = CLOSING[opened.value]
    label = Label(
        session.span(token) if token.value else session.after_previous(), f"`{closing}` is expected before this"
    )
    edit = Edit(session.after_previous(), closing)
    session.sink.report("E0111", session.span(opened), label, edit=edit, mark=opened.value, closing=closing)


def _closes_ahead(session: Session, token: Token) -> bool:
    """True if the rest of the statement closes one bracket more than it opens."""
    depth = 0
    for ahead in session.look_ahead(start_of(token)):
        depth += (ahead.value in CLOSING) - (ahead.value in CLOSING.values())
        if depth < 0:
            return True
    return False


def _matrix_went_over_lines(session: Session, opened: Token, token: Token) -> bool:
    """A `;` at a line's end was taken for the end of a matrix row."""
    text = session.file.text
    end_of_statement = text.find(";\n", end_of(opened), start_of(token))
    return end_of_statement >= 0
