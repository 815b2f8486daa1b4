"""Faults of brackets: closed without being opened, closed by another kind, never closed."""

from __future__ import annotations

from lagdsl.diagnostics import Label
from lagdsl.syntax.automaton import END_OF_TEXT
from lagdsl.syntax.lexer import Token
from lagdsl.syntax.session import CLOSING, SEMICOLON, Session, statement_words


def wrong_bracket(session: Session, token: Token) -> bool:
    """A closing bracket that no open one waits for."""
    if token.text not in CLOSING.values():
        return False
    if not session.brackets:
        session.sink.report("E0110", session.span(token), mark=token.text)
        return True  # read on without it
    opened = session.brackets[-1]
    closing = CLOSING[opened.text]
    if closing == token.text:
        return False
    waiting = [CLOSING[bracket.text] for bracket in session.brackets]
    if token.text in waiting:
        _report_unclosed(session, opened, token)
        if session.insert(closing):
            session.lexer.rewind(token.start)
            return True
    else:
        label = Label(session.span(opened), "opened here")
        session.sink.report("E0112", session.span(token), label, mark=opened.text, found=token.text, closing=closing)
        if session.insert(closing):
            return True
    session.panic(token)
    return True


def unclosed_bracket(session: Session, token: Token) -> bool:
    """The statement ends, or another one begins, while a bracket is open."""
    if not session.brackets:
        return False
    opened = session.brackets[-1]
    ends = token.terminal in (SEMICOLON, END_OF_TEXT) or token.text == "end"
    begins = session.starts_line(token) and (token.text in statement_words() or not _closes_ahead(session, token))
    rows = opened.text == "[" and _matrix_went_over_lines(session, opened, token)
    if not ends and not begins and not rows:
        return False
    _report_unclosed(session, opened, token)
    if rows:
        session.panic(token)
        return True
    while session.brackets and session.insert(CLOSING[session.brackets[-1].text]):
        pass
    if session.brackets:
        session.panic(token)
    else:
        session.lexer.rewind(token.start)
    return True


def _report_unclosed(session: Session, opened: Token, token: Token) -> None:
    closing = CLOSING[opened.text]
    label = Label(
        session.span(token) if token.text else session.after_previous(), f"`{closing}` is expected before this"
    )
    session.sink.report("E0111", session.span(opened), label, mark=opened.text, closing=closing)


def _closes_ahead(session: Session, token: Token) -> bool:
    """Whether the rest of the statement closes one bracket more than it opens."""
    depth = 0
    for ahead in session.look_ahead(token.start):
        depth += (ahead.text in CLOSING) - (ahead.text in CLOSING.values())
        if depth < 0:
            return True
    return False


def _matrix_went_over_lines(session: Session, opened: Token, token: Token) -> bool:
    """A `;` at a line's end was taken for the end of a matrix row."""
    text = session.file.text
    end_of_statement = text.find(";\n", opened.end, token.start)
    return end_of_statement >= 0
