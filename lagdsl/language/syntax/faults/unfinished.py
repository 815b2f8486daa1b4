"""Statements that end with their line before they are complete, above one that is complete: a text is being typed."""

from __future__ import annotations

from lark import Token

from lagdsl.foundation.diagnostics.catalog.habits import form_help
from lagdsl.language.syntax.expected import expected
from lagdsl.language.syntax.faults.blocks import begins_section
from lagdsl.language.syntax.faults.brackets import report_unclosed
from lagdsl.language.syntax.faults.statements import missing_separator, noun, statement_before
from lagdsl.language.syntax.session import CLOSING, Session
from lagdsl.language.syntax.stack import statement_words
from lagdsl.language.syntax.tokens import start_of


def unfinished_statement(session: Session, token: Token) -> bool:
    """`parameter Mass` above `parameter Length l = 1 m;`, where the parser goes on to `Length`: said behind `Mass`."""
    height = session.stack.boundary()
    first, *rest = [*statement_before(session, token), token]
    following = next((each for each in rest if height and _begins_anew(session, height, first, each)), None)
    if following is None:
        return False
    if following is not token and not _read_until(session, height, first, following):
        return False
    if session.stack.accepts("THEN") or session.stack.accepts("LOOP"):
        return missing_separator(session, following)
    _report(session, first, following)
    while session.brackets and session.insert(CLOSING[session.brackets[-1].value]):
        pass
    if not session.stack.accepts("SEMICOLON") or not session.insert(";"):
        session.brackets = [bracket for bracket in session.brackets if start_of(bracket) < start_of(first)]
        session.stack.cut(height)
    session.rewind(start_of(following))
    return True


def _begins_anew(session: Session, height: int, first: Token, token: Token) -> bool:
    """True if `token` begins a line that does not continue the statement of `first`."""
    if not session.starts_line(token):
        return False
    if _column(session, token) > _column(session, first) and token.value not in statement_words():
        return False
    ends = token.value == "end" or begins_section(session, token)
    return ends or session.stack.begins_anew(height, start_of(token))


def _column(session: Session, token: Token) -> int:
    return start_of(token) - session.file.text.rfind("\n", 0, start_of(token))


def _read_until(session: Session, height: int, first: Token, following: Token) -> bool:
    """Read the statement again, no further than `following`. False for one that is not read as it stands."""
    session.brackets = [bracket for bracket in session.brackets if start_of(bracket) < start_of(first)]
    session.stack.cut(height)
    session.rewind(start_of(first))
    while start_of(token := session.take()) < start_of(following):
        if not session.shift(token):
            return False
    session.stack.settle()
    return True


def _report(session: Session, first: Token, following: Token) -> None:
    if session.brackets:
        report_unclosed(session, session.brackets[-1], following)
    elif session.stack.accepts("SEMICOLON"):
        session.sink.report("E0101", session.after_previous(), what=noun(session, following))
    else:
        help_text = form_help(first.value)
        session.sink.report("E0139", session.after_previous(), expected=expected(session.stack), help=help_text)
