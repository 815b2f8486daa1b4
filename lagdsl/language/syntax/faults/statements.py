"""Faults of statements: misspelt keywords, missing `;`, equations and declarations in the wrong section."""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import pairwise

from lark import Token

from lagdsl.foundation.diagnostics import Edit, Label
from lagdsl.foundation.diagnostics.catalog.habits import (
    OF_MOTION,
    call_help,
    constraint_help,
    energy_help,
    function_help,
    value_help,
)
from lagdsl.foundation.diagnostics.suggest import nearest
from lagdsl.foundation.source import Span
from lagdsl.language.syntax.session import CLOSING, Session
from lagdsl.language.syntax.stack import statement_words
from lagdsl.language.syntax.tokens import END_OF_TEXT, end_of, start_of
from lagdsl.language.syntax.vocabulary import vocabulary

_AFTER_A_NAME = (";", ",", "=", "(", "[", ")", "]", "}", ".")
_PLACES = ("at", "on", "from", "with", ":")
_OPERANDS = ("IDENT", "NUMBER", "QUANTITY", "STRING")
_PHYSICS = {"ENERGY", "LOAD", "MASS", "BODY", "GRAVITY", "CONSTRAINT", "CONTACT", "INVARIANT", "DRAW", "CONNECT"}
_VARIABLE_LIKE = {"LOAD", "ENERGY", "GEOMETRY", "PREFIX", "MASS", "BODY"}  # the rule `keyword_name` of the grammar
_OUTSIDE = ("type", "function", "import", "within")
_SECTIONS = ("_section_item", "when_equation")


def keyword_as_variable(session: Session, token: Token) -> bool:
    """`force.x = 1;` among equations: there the word is the keyword, whatever variables exist."""
    first, *rest = [*statement_before(session, token), token]
    if session.stack.kind() not in _SECTIONS or not rest or rest[0].value not in (".", "["):
        return False
    if _VARIABLE_LIKE.isdisjoint(vocabulary().words.get(first.value, ())):
        return False
    texts = [t.value for t in session.look_ahead(start_of(first))]
    left = "".join(texts[1 : texts.index("=")] if "=" in texts else texts[1:])
    session.sink.report("E0119", session.span(first), word=first.value, rest=left)
    session.panic(token)
    return True


def reserved_name(session: Session, token: Token) -> bool:
    """A reserved word where a name stands: read on as if it were one."""
    if token.value not in vocabulary().reserved or not session.stack.accepts("IDENT") or session.starts_line(token):
        return False
    ahead = next(session.look_ahead(end_of(token)), None)
    if ahead is not None and ahead.value not in _AFTER_A_NAME and ahead.type != "STRING" and not _is_operator(ahead):
        return False
    session.sink.report("E0115", session.span(token), word=token.value)
    return session.shift(token.update(type="IDENT"))


def _is_operator(token: Token) -> bool:
    return token.value in vocabulary().marks


def misspelt_keyword(session: Session, token: Token) -> bool:
    """The first word of the statement resembles a keyword: read the statement again with that."""
    statement = statement_before(session, token)
    first = statement[0] if statement else token
    height = session.stack.boundary()
    words = vocabulary().words
    if first.type != "IDENT" or first.value in words or height == 0:
        return False
    if not first.value[0].islower() and token.value not in _PLACES and token.type not in ("NUMBER", "QUANTITY"):
        return False
    spelled = sorted(word for word in statement_words() if nearest(first.value, (word,)) is not None)
    fitting = [word for word in spelled if session.stack.goes_on(height, first, word, start_of(token))]
    meant = nearest(first.value, fitting)
    if meant is None:
        return False
    session.sink.report("E0102", session.span(first), word=first.value, meant=meant)
    session.stack.cut(height)
    terminal = next(t for t in words[meant] if t in session.stack.parser.choices())
    session.shift(first.update(type=terminal, value=meant))
    session.rewind(end_of(first))
    return True


def outside_of_classes(session: Session, token: Token) -> bool:
    """A statement at the level of the file; said once."""
    if session.stack.kind() != "_item":
        return False
    statement = statement_before(session, token)
    first = statement[0] if statement else token
    words = vocabulary().words
    if any("CLASS_KIND" in words.get(t.value, ()) or t.value in _OUTSIDE for t in statement):
        return False
    if first.type not in _OPERANDS and first.value not in words:
        return False
    if ("E0117", 0) not in session.reported.told:
        session.reported.told.add(("E0117", 0))
        session.sink.report("E0117", session.span(first))
    session.panic(token)
    return True


def array_size_after_type(session: Session, token: Token) -> bool:
    """`Real[3] x;`."""
    statement = statement_before(session, token)
    if token.value != "[" or not statement or session.stack.kind() not in ("_element", "_section_item"):
        return False
    ahead = list(session.look_ahead(start_of(token)))
    closing = next((i for i, t in enumerate(ahead) if t.value == "]"), len(ahead))
    if closing + 1 >= len(ahead) or ahead[closing + 1].type != "IDENT":
        return False
    size = Span(session.file, start_of(token), end_of(ahead[closing]))
    name = ahead[closing + 1].value
    whole = Span(session.file, size.start, end_of(ahead[closing + 1]))
    edit = Edit(whole, f" {name}{size.text}")
    session.sink.report("E0122", size, edit=edit, type_name=statement[-1].value, name=name, size=size.text)
    session.rewind(end_of(ahead[closing]))
    return True


def bare_equation(session: Session, token: Token) -> bool:
    """An equation among declarations; said once for a class."""
    if session.stack.kind() != "_element":
        return False
    start = session.statement_start(token)
    sides = _sides(session.look_ahead(start))
    if sides is None or (sides and start_of(token) > start_of(sides[0])):
        return False
    first = next(session.look_ahead(start))
    if first.value in statement_words():
        return False
    block = session.open_block()
    place = ("E0103", -1 if block is None else start_of(block))
    if place not in session.reported.told:
        session.reported.told.add(place)
        tokens = list(session.look_ahead(start))
        span = Span(session.file, start, end_of(tokens[-1]))
        way = energy_help(first.value) if tokens[1].value in ("=", ":") else None
        if tokens[1].value == "(" and len(tokens) > 2:
            way = call_help(first.value, tokens[2].value)
        called = next((t.value for t, mark in pairwise(tokens) if t.type == "IDENT" and mark.value == "("), None)
        if way is None and called is not None:
            way = function_help(called, ())
        if way is None and sides:
            way = _of_declared(session, tokens, span.text)
        outer = session.outermost_block()
        above = start if outer is None else start_of(outer)
        session.sink.report("E0103", span, help=way, line=session.file.line_number(above))
    session.panic(token)
    return True


_OPERATORS = frozenset("+-*/^")
_DECLARED = r"\b{keyword}\s+[\w.]+(?:\s*\[[^\]]*\])?\s+(?:[^;]*,\s*)?{name}\s*[\[(,;\"=]"


def _of_declared(session: Session, equation: list[Token], text: str) -> str | None:
    """Help for an equation that would define nothing among equations, as far as the text around tells."""
    words, text = [token.value for token in equation], text.partition("\n")[0]
    left, right = words[: words.index("=")], words[words.index("=") + 1 :]
    alone = equation[-1].type != "IDENT"  # on the right, where there is one word
    rate = left[:2] == ["der", "("]
    if left[:4] == ["der", "(", "der", "("]:
        return OF_MOTION
    name = left[2] if rate and len(left) > 2 else left[0]
    if len(left) == 1 or left[1] == "[" or rate:
        if _is_declared(session, "coordinate", name):
            return constraint_help(text)
        if not rate and any(_is_declared(session, word, name) for word in ("parameter", "constant")):
            return value_help(name)
    elif not _OPERATORS.isdisjoint(left) and (
        right[1:] or alone or any(_is_declared(session, "coordinate", each) for each in right)
    ):
        return constraint_help(text)
    return None


def _is_declared(session: Session, keyword: str, name: str) -> bool:
    pattern = _DECLARED.format(keyword=keyword, name=re.escape(name))
    return re.search(pattern, session.file.text) is not None


def _sides(statement: Iterable[Token]) -> list[Token] | None:
    """The `=` of a statement that is an equation by its shape, none for a call; None if it is neither."""
    depth, before, count = 0, None, 0
    for token in statement:
        count += 1
        if before is not None and _ends_operand(before) and _begins_operand(token):
            return None
        depth += (token.value in CLOSING) - (token.value in CLOSING.values())
        if token.value == "=" and depth == 0:
            return [token] if count > 1 else None
        before = token
    calls = before is not None and before.value == ")" and count > 2
    return [] if calls else None


def _ends_operand(token: Token) -> bool:
    return token.type in _OPERANDS or token.value in CLOSING.values()


def _begins_operand(token: Token) -> bool:
    return token.type in _OPERANDS or token.value == "{"


def declaration_among_equations(session: Session, token: Token) -> bool:
    """`Real x = 1;` after the word `equation`; read on behind it."""
    statement = statement_before(session, token)
    if session.stack.kind() not in _SECTIONS or token.type != "IDENT" or not statement or session.starts_line(token):
        return False
    names = statement[::2]
    dots = statement[1::2]
    if any(t.type != "IDENT" for t in names) or any(t.value != "." for t in dots) or len(names) != len(dots) + 1:
        return False
    session.sink.report("E0118", session.span(token), section="equation")
    session.panic(token)
    return True


def missing_separator(session: Session, token: Token) -> bool:
    """`;`, `then` or `loop` is missing before a new line or before `end`."""
    before_new = session.starts_line(token) or token.value == "end" or token.type == END_OF_TEXT
    if not before_new:
        return False
    if session.stack.accepts("SEMICOLON"):
        session.sink.report("E0101", session.after_previous(), what=noun(session, token))
        session.insert(";")
        session.rewind(start_of(token))
        return True
    for word in ("then", "loop"):
        if session.stack.accepts(word.upper()):
            session.sink.report("E0123", session.after_previous(), word=word)
            session.insert(word)
            session.rewind(start_of(token))
            return True
    return False


def noun(session: Session, token: Token) -> str:
    """Kind of the unfinished statement."""
    if any(isinstance(value, Token) and value.type == "END" for value in session.stack.values[-2:]):
        return "`end`"
    first = next(session.look_ahead(session.statement_start(token)), token)
    if not _PHYSICS.isdisjoint(vocabulary().words.get(first.value, ())):
        return "statement"
    return "equation" if session.stack.kind() in _SECTIONS else "declaration"


def second_relation(session: Session, token: Token) -> bool:
    """`a < b < c`."""
    if token.type != "REL":
        return False
    first = next((t for t in reversed(statement_before(session, token)) if t.type == "REL"), None)
    if first is None:
        return False
    session.sink.report("E0125", session.span(token), Label(session.span(first), "first relation"))
    session.panic(token)
    return True


def statement_before(session: Session, token: Token) -> list[Token]:
    """The tokens of the statement before `token`."""
    before = []
    for ahead in session.look_ahead(session.statement_start(token)):
        if start_of(ahead) >= start_of(token):
            break
        before.append(ahead)
    return before
