"""Faults of those who write another language: its words, its decimal comma, its assignments, its brackets."""

from __future__ import annotations

import re

from lark import Token

from lagdsl.foundation.diagnostics import Edit
from lagdsl.foundation.diagnostics.catalog.habits import form_help, package_help, word_help
from lagdsl.foundation.diagnostics.catalog.syntax import unexpected_help
from lagdsl.foundation.source import Span
from lagdsl.language.syntax.expected import expected, found
from lagdsl.language.syntax.faults.statements import statement_before
from lagdsl.language.syntax.session import CLOSING, Session
from lagdsl.language.syntax.tokens import end_of, plain_tokens, start_of
from lagdsl.language.syntax.vocabulary import pattern, vocabulary

_NUMBERS = ("NUMBER", "QUANTITY")
_GROUPED = re.compile(r"\d{1,3}(?:\.\d{3})+")
_PER = re.compile(r"1[ \t]*/[ \t]*([A-Za-z]+[1-9]?)(?![A-Za-z0-9_])")
_FACTORS = re.compile(r"[A-Za-z]+(?:\^-?[1-9]|[1-9])?(?:[ \t]+[A-Za-z]+(?:\^-?[1-9]|[1-9])?)*(?=[ \t]*[;,)}\]\n])")
_LONGEST_UNIT = 40
_POWERS = {("*", "*"): "**", (".", "^"): ".^"}


def decimal_comma(session: Session, token: Token) -> bool:
    """`0,5 m`: two numbers with a comma and no blank between them."""
    text = session.file.text
    comma = start_of(token) if token.value == "," else start_of(token) - 1
    before = re.compile(r"[0-9]+(?:\.[0-9]+)*$").search(text[max(comma - 40, 0) : comma])
    after = pattern("QUANTITY").match(text, comma + 1) or pattern("NUMBER").match(text, comma + 1)
    if text[comma : comma + 1] != "," or before is None or after is None:
        return False
    if token.type not in _NUMBERS and token.value != ",":
        return False
    whole = before[0].replace(".", "") if _GROUPED.fullmatch(before[0]) else before[0]
    span = Span(session.file, comma - len(before[0]), after.end())
    number = f"{whole}.{after[0]}"
    help_text = f"a number has a decimal point: `{number}`"
    edit = Edit(span, number)
    session.sink.report("E0100", span, found=f"`{span.text}`", expected="one number", help=help_text, edit=edit)
    session.panic(token)
    return True


def assignment(session: Session, token: Token) -> bool:
    """`x := 3`: read on as if it were `x = 3`."""
    ahead = next(plain_tokens(session.file.text, end_of(token)), None)
    if token.value != ":" or ahead is None or ahead.value != "=" or start_of(ahead) != end_of(token):
        return False
    if not session.stack.accepts(ahead.type):
        return False
    span = session.span(token).to(session.span(ahead))
    help_text = "write `=`: equations and bindings are no assignments"
    session.sink.report("E0100", span, found="`:=`", expected="`=`", help=help_text, edit=Edit(span, "="))
    session.rewind(end_of(token))
    return True


def foreign_power(session: Session, token: Token) -> bool:
    """`x**2`, `x.^2`."""
    mark = _POWERS.get((session.previous.value, token.value))
    if mark is None or end_of(session.previous) != start_of(token):
        return False
    base = statement_before(session, token)[-2:-1]
    power = next(session.look_ahead(end_of(token)), None)
    help_text = unexpected_help(
        base[0].value if base else "", mark, power.value if power is not None else "", "an operator"
    )
    span = session.span(session.previous).to(session.span(token))
    edit = Edit(span, "^")
    session.sink.report("E0100", span, found=f"`{mark}`", expected="an operator", help=help_text, edit=edit)
    session.panic(token)
    return True


def semicolon_in_brackets(session: Session, token: Token) -> bool:
    """`(x; y)`, `{x; y}`: read on as if a comma stood there."""
    if token.type != "SEMICOLON" or not session.brackets or session.brackets[-1].value == "[":
        return False
    opened = session.brackets[-1]
    line_end = session.file.text.find("\n", end_of(token))
    rest = session.file.text[end_of(token) : line_end if line_end >= 0 else len(session.file.text)]
    inside = rest.partition(CLOSING[opened.value])
    if not inside[1] or opened.value in inside[0] or not inside[0].strip():
        return False
    whole = session.file.text[end_of(opened) : end_of(token) + len(inside[0])].replace(";", ",").strip()
    shown = f": `{{{whole}}}`" if len(whole) <= 40 and whole.isprintable() else ""
    help_text = f"components stand in braces, separated by commas{shown}"
    span = session.span(token)
    session.sink.report("E0100", span, found="`;`", expected="`,`", help=help_text, edit=Edit(span, ","))
    if not session.shift(token.update(type="COMMA", value=",")):
        session.panic(token)
    return True


def foreign_word(session: Session, token: Token) -> bool:
    """`spring 3 N/m`, `const Real k`, `while ...`: the word that begins the statement is one of another language."""
    statement = statement_before(session, token)
    first = statement[0] if statement else token
    known = first.value in vocabulary().words and first.value != "from"
    if first.type not in ("IDENT", "FROM") or known or session.stack.kind() in (None, "_item"):
        return False
    name = next((each.value for each in reversed([*statement, token]) if each.type == "IDENT"), "x")
    help_text = word_help(first.value, name)
    if help_text is None:
        return False
    session.sink.report("E0102", session.span(first), word=first.value, help=help_text)
    if first.value == "while":  # its `end while` would close the class
        session.give_up()
    elif first.value == "encapsulated":  # the class behind it is read as it stands
        session.stack.cut(session.stack.boundary())
        session.rewind(end_of(first))
    else:
        session.panic(token)
    return True


def equality_for_equation(session: Session, token: Token) -> bool:
    """`constraint a == b;`."""
    if token.type != "SEMICOLON" or not session.stack.accepts("EQUAL"):
        return False
    statement = statement_before(session, token)
    relation = next((each for each in statement if each.type == "REL"), None)
    if relation is None:
        return False
    span = session.span(relation)
    if relation.value == "==":
        help_text, edit = "an equation is written with one `=`", Edit(span, "=")
    else:
        help_text, edit = "an inequality is a contact: `contact a >= b with restitution = 0;`", None
    session.sink.report("E0100", span, found=found(relation), expected="`=`", help=help_text, edit=edit)
    session.panic(token)
    return True


def unexpected(session: Session, token: Token) -> bool:
    """Anything else."""
    words = expected(session.stack)
    ahead = next(session.look_ahead(end_of(token)), None)
    help_text = (
        _unit_help(session, token)
        or _import(session, token)
        or _ports(session, token)
        or unexpected_help(session.previous.value, token.value, ahead.value if ahead is not None else "", words)
        or _form(session, token)
    )
    session.sink.report("E0100", session.span(token), found=found(token), expected=words, help=help_text)
    session.panic(token)
    return True


def _unit_help(session: Session, token: Token) -> str | None:
    """`5 N m`, `100 1/min`: a unit after a quantity, or after a number."""
    from lagdsl.foundation.units.parse import UnknownUnit, parse_unit

    before, text = session.previous, session.file.text
    behind = pattern("QUANTITY").match(f"1 {text[start_of(token) : start_of(token) + _LONGEST_UNIT]}")
    if behind is not None and before.value == "}":
        return f"each component has its unit: `{{1 {behind[0][2:]}, ...}}`"
    if behind is not None and before.value in (")", "pi"):
        return f"for a product write `*`; a unit stands behind a number: `*(1 {behind[0][2:]})`"
    if before.type == "NUMBER" and (per := _PER.match(text, start_of(token))):
        joined = f"{before.value} /{per[1]}"
    elif before.type == "QUANTITY" and (rest := _FACTORS.match(text, start_of(token))):
        joined = f"{before.value}.{'.'.join(rest[0].split())}"
    else:
        return None
    try:
        parse_unit(joined.lstrip("0123456789.eE+- "))
    except UnknownUnit:
        return None
    return f"units are joined by `.`: `{joined}`" if before.type == "QUANTITY" else f"a unit is written `{joined}`"


def _form(session: Session, token: Token) -> str | None:
    """Help for a statement whose keyword is right and whose parts are not."""
    statement = [*statement_before(session, token), token]
    first = statement[0]
    left = session.file.text[end_of(first) : start_of(token)].strip()
    short = len(left) <= 60 and left.isprintable()
    if first.value == "constraint" and token.type == "SEMICOLON" and short:
        return f"an equation has two sides: `constraint {left} = 0;`"
    if first.value in ("coordinate", "state") and session.previous.value == "(" and token.type in _NUMBERS:
        return f"a start has its name: `{left.rpartition('(')[0].split()[-1]}(start = {token.value})`"
    if first.value == "mass" and token.value == ",":
        return "components of a point stand in braces: `{x, y}`"
    if first.value in ("force", "torque") and token.type == "SEMICOLON":
        return _load(session, first, statement)
    is_known = first.value in vocabulary().words or first.value == "assert"
    return form_help(first.value) if is_known else None


def _ports(session: Session, token: Token) -> str | None:
    """`connect(a.frame_a b.frame_b);`."""
    statement = statement_before(session, token)
    connects = bool(statement) and statement[0].value == "connect" and token.type == "IDENT"
    return "ports are separated by commas: `connect(a, b);`" if connects else None


def _import(session: Session, token: Token) -> str | None:
    """`import numpy as np`."""
    statement = statement_before(session, token)
    if token.value != "as" or not statement or statement[0].value != "import":
        return None
    package = "".join(each.value for each in statement[1:])
    ahead = next(session.look_ahead(end_of(token)), None)
    return package_help(package.partition(".")[0]) or (
        f"write `import {ahead.value} = {package};`" if ahead is not None else None
    )


def _load(session: Session, first: Token, statement: list[Token]) -> str | None:
    """`torque -0.1*der(theta);`: on what it acts."""
    rates = [
        after.value
        for word, bracket, after in zip(statement, statement[1:], statement[2:], strict=False)
        if word.value == "der" and bracket.value == "(" and after.type == "IDENT"
    ]
    text = session.file.text[start_of(first) : end_of(session.previous)]
    if len(set(rates)) != 1 or len(text) > 60 or not text.isprintable():
        return form_help(first.value)
    return f"a load acts on a coordinate: `{text} on {rates[0]};`"
