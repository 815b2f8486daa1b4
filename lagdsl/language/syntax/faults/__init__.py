"""Recognises what went wrong where the parser can not go on, reports it and repairs it.

A recogniser looks at the session and the token that does not fit. It returns False if this is not its kind of fault;
otherwise it has reported the fault and left the session in a state from which reading goes on.
"""

from __future__ import annotations

from collections.abc import Callable

from lark import Token

from lagdsl.language.syntax.faults.blocks import (
    end_of_block,
    end_of_text,
    ends_outer_class,
    missing_class_name,
    section_in_block,
)
from lagdsl.language.syntax.faults.brackets import unclosed_bracket, wrong_bracket
from lagdsl.language.syntax.faults.habits import (
    assignment,
    decimal_comma,
    equality_for_equation,
    foreign_power,
    foreign_word,
    semicolon_in_brackets,
    unexpected,
)
from lagdsl.language.syntax.faults.literals import open_string, unit_after_number
from lagdsl.language.syntax.faults.notations import foreign_comment, foreign_function, foreign_number
from lagdsl.language.syntax.faults.statements import (
    array_size_after_type,
    bare_equation,
    declaration_among_equations,
    keyword_as_variable,
    missing_separator,
    misspelt_keyword,
    outside_of_classes,
    reserved_name,
    second_relation,
)
from lagdsl.language.syntax.faults.unfinished import unfinished_statement
from lagdsl.language.syntax.session import Session
from lagdsl.language.syntax.tokens import END_OF_TEXT, end_of, start_of

RECOGNISERS: tuple[Callable[[Session, Token], bool], ...] = (
    open_string,
    decimal_comma,
    foreign_number,
    foreign_comment,
    foreign_function,
    unit_after_number,
    semicolon_in_brackets,
    wrong_bracket,
    unfinished_statement,
    unclosed_bracket,
    end_of_text,
    end_of_block,
    section_in_block,
    keyword_as_variable,
    reserved_name,
    missing_class_name,
    assignment,
    foreign_word,
    misspelt_keyword,
    outside_of_classes,
    array_size_after_type,
    bare_equation,
    declaration_among_equations,
    missing_separator,
    second_relation,
    foreign_power,
    equality_for_equation,
    unexpected,
)


def recover(session: Session, token: Token) -> None:
    """Report what is wrong at `token` and leave the session where reading can go on."""
    session.stack.settle()
    start = start_of(token)
    session.reported.failures[start] = session.reported.failures.get(start, 0) + 1
    if session.reported.failures[start] > 1:
        _give_way(session, token)
        return
    if session.statement_start(token) <= session.reported.last < start:  # what follows from a fault that is told
        if session.starts_line(token) and session.insert(";"):
            session.rewind(start)
        else:
            session.panic(token)
        return
    any(recognise(session, token) for recognise in RECOGNISERS)


def _give_way(session: Session, token: Token) -> None:
    """A repair did not help: say no more about this statement, and at the third failure leave the token out."""
    if token.type == END_OF_TEXT:
        session.give_up()
    elif session.reported.failures[start_of(token)] == 2:
        session.panic(token)
    else:
        session.rewind(end_of(token))


__all__ = ["ends_outer_class", "recover"]
