"""Faults of statements: misspelt keywords, missing `;`, equations and declarations in the wrong section."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.diagnostics import Label
from lagdsl.diagnostics.catalog.syntax import unexpected_help
from lagdsl.diagnostics.suggest import nearest
from lagdsl.source import Span
from lagdsl.syntax import tables
from lagdsl.syntax.automaton import END_OF_TEXT, TERMINAL
from lagdsl.syntax.expected import expected, found
from lagdsl.syntax.lexer import IDENT, NUMBER, QUANTITY, RESERVED, STRING, Token
from lagdsl.syntax.session import CLOSING, SEMICOLON, Session, statement_words

_AFTER_A_NAME = (";", ",", "=", "(", "[", ")", "]", "}", ".")
_PLACES = ("at", "on", "from", "with", ":")
_OPERANDS = (IDENT, NUMBER, QUANTITY, STRING)
_PHYSICS = {
    TERMINAL[name]
    for name in ("ENERGY", "LOAD", "MASS", "BODY", "GRAVITY", "CONSTRAINT", "CONTACT", "INVARIANT", "DRAW", "CONNECT")
}
_SECTIONS = ("_section_item", "when_equation")


def keyword_as_variable(session: Session, token: Token) -> bool:
    """`force.x = 1;` among equations: there the word is the keyword, whatever variables exist."""
    first, *rest = [*_statement(session, token), token]
    if _kind(session) not in _SECTIONS or not rest or rest[0].text not in (".", "["):
        return False
    if first.text not in _variable_like_keywords():
        return False
    texts = [t.text for t in session.look_ahead(first.start)]
    left = "".join(texts[1 : texts.index("=")] if "=" in texts else texts[1:])
    session.sink.report("E0119", session.span(first), word=first.text, rest=left)
    session.panic(token)
    return True


def _variable_like_keywords() -> frozenset[str]:
    """Keywords that may be variables of an equation: the rule `keyword_name` of the grammar."""
    terminals = {TERMINAL[name] for name in ("LOAD", "ENERGY", "GEOMETRY", "PREFIX", "MASS", "BODY")}
    return frozenset(word for word, options in tables.WORDS.items() if not terminals.isdisjoint(options))


def reserved_name(session: Session, token: Token) -> bool:
    """A reserved word where a name stands: read on as if it were one."""
    if token.text not in RESERVED or not session.machine.accepts(IDENT) or session.starts_line(token):
        return False
    ahead = next(session.look_ahead(token.end), None)
    if ahead is not None and ahead.text not in _AFTER_A_NAME and ahead.terminal != STRING and not _is_operator(ahead):
        return False
    session.sink.report("E0115", session.span(token), word=token.text)
    return session.shift(token._replace(terminal=IDENT))


def _is_operator(token: Token) -> bool:
    return token.text in tables.MARKS


def misspelt_keyword(session: Session, token: Token) -> bool:
    """The first word of the statement resembles a keyword: read the statement again with that."""
    statement = _statement(session, token)
    first = statement[0] if statement else token
    position = len(statement)
    height = session.machine.boundary()
    if first.terminal != IDENT or first.text in tables.WORDS or height == 0:
        return False
    if not first.text[0].islower() and token.text not in _PLACES and token.terminal not in (NUMBER, QUANTITY):
        return False
    meant = _meant_keyword(session, first, [*statement[1:], token][:position])
    if meant is None:
        return False
    session.sink.report("E0102", session.span(first), word=first.text, meant=meant)
    session.machine.cut(height)
    terminal = next(t for t in tables.WORDS[meant] if t in session.machine.accepted)
    session.shift(first._replace(terminal=terminal, text=meant))
    session.lexer.rewind(first.end)
    return True


_CLASS_WORDS = frozenset(word for word, options in tables.WORDS.items() if TERMINAL["CLASS_KIND"] in options)


def _meant_keyword(session: Session, first: Token, following: list[Token]) -> str | None:
    """A keyword like the first word with which the statement would go on behind the token that does not fit."""
    height = session.machine.boundary()
    spelled = sorted(word for word in statement_words() if nearest(first.text, (word,)) is not None)
    fitting = [
        word
        for word in spelled
        if session.machine.fitting(height, [first._replace(text=word, terminal=-1), *following]) == len(following) + 1
    ]
    return nearest(first.text, fitting)


def outside_of_classes(session: Session, token: Token) -> bool:
    """A statement at the level of the file; said once."""
    if _kind(session) != "_item":
        return False
    statement = _statement(session, token)
    first = statement[0] if statement else token
    if any(t.text in _CLASS_WORDS or t.text in ("type", "function", "import", "within") for t in statement):
        return False
    if first.terminal not in (IDENT, *_OPERANDS) and first.text not in tables.WORDS:
        return False
    if ("E0117", 0) not in session.told:
        session.told.add(("E0117", 0))
        session.sink.report("E0117", session.span(first))
    session.panic(token)
    return True


def array_size_after_type(session: Session, token: Token) -> bool:
    """`Real[3] x;`."""
    statement = _statement(session, token)
    if token.text != "[" or not statement or _kind(session) not in ("_element", "_section_item"):
        return False
    ahead = list(session.look_ahead(token.start))
    closing = next((i for i, t in enumerate(ahead) if t.text == "]"), len(ahead))
    if closing + 1 >= len(ahead) or ahead[closing + 1].terminal != IDENT:
        return False
    size = Span(session.file, token.start, ahead[closing].end)
    name = ahead[closing + 1].text
    session.sink.report("E0122", size, type_name=statement[-1].text, name=name, size=size.text)
    session.lexer.rewind(ahead[closing].end)
    return True


def bare_equation(session: Session, token: Token) -> bool:
    """An equation among declarations; said once for a class."""
    if _kind(session) != "_element":
        return False
    start = session.statement_start(token)
    sides = _sides(session.look_ahead(start))
    if sides is None or (sides and token.start > sides[0].start):
        return False
    first = next(session.look_ahead(start))
    if first.text in statement_words():
        return False
    block = session.open_block()
    place = ("E0103", -1 if block is None else block.start)
    if place not in session.told:
        session.told.add(place)
        last = list(session.look_ahead(start))[-1]
        span = Span(session.file, start, last.end)
        session.sink.report("E0103", span, line=session.file.line_number(start))
    session.panic(token)
    return True


def _sides(statement: Iterable[Token]) -> list[Token] | None:
    """The `=` of a statement that is an equation by its shape, none for a call; None if it is neither."""
    depth, before, count = 0, None, 0
    for token in statement:
        count += 1
        if before is not None and _ends_operand(before) and _begins_operand(token):
            return None
        depth += (token.text in CLOSING) - (token.text in CLOSING.values())
        if token.text == "=" and depth == 0:
            return [token] if count > 1 else None
        before = token
    calls = before is not None and before.text == ")" and count > 2
    return [] if calls else None


def _ends_operand(token: Token) -> bool:
    return token.terminal in _OPERANDS or token.text in CLOSING.values()


def _begins_operand(token: Token) -> bool:
    return token.terminal in _OPERANDS or token.text == "{"


def declaration_among_equations(session: Session, token: Token) -> bool:
    """`Real x = 1;` after the word `equation`; read on behind it."""
    statement = _statement(session, token)
    if _kind(session) not in _SECTIONS or token.terminal != IDENT or not statement or session.starts_line(token):
        return False
    names = statement[::2]
    dots = statement[1::2]
    if any(t.terminal != IDENT for t in names) or any(t.text != "." for t in dots) or len(names) != len(dots) + 1:
        return False
    session.sink.report("E0118", session.span(token), section="equation")
    session.panic(token)
    return True


def missing_separator(session: Session, token: Token) -> bool:
    """`;`, `then` or `loop` is missing before a new line or before `end`."""
    before_new = session.starts_line(token) or token.text == "end" or token.terminal == END_OF_TEXT
    if not before_new:
        return False
    if session.machine.accepts(SEMICOLON):
        session.sink.report("E0101", session.after_previous(), what=_noun(session, token))
        session.insert(";")
        session.lexer.rewind(token.start)
        return True
    for word in ("then", "loop"):
        if session.machine.accepts(tables.WORDS[word][0]):
            session.sink.report("E0123", session.after_previous(), word=word)
            session.insert(word)
            session.lexer.rewind(token.start)
            return True
    return False


def _noun(session: Session, token: Token) -> str:
    """What the unfinished statement is."""
    if any(isinstance(value, Token) and value.terminal == TERMINAL["END"] for value in session.machine.values[-2:]):
        return "`end`"
    first = next(session.look_ahead(session.statement_start(token)), token)
    if not _PHYSICS.isdisjoint(tables.WORDS.get(first.text, ())):
        return "statement"
    return "equation" if _kind(session) in _SECTIONS else "declaration"


def second_relation(session: Session, token: Token) -> bool:
    """`a < b < c`."""
    if token.terminal != TERMINAL["REL"]:
        return False
    first = next((t for t in reversed(_statement(session, token)) if t.terminal == TERMINAL["REL"]), None)
    if first is None:
        return False
    session.sink.report("E0125", session.span(token), Label(session.span(first), "first relation"))
    session.panic(token)
    return True


def unexpected(session: Session, token: Token) -> bool:
    """Anything else."""
    words = expected(session.machine)
    help_text = unexpected_help(session.previous.text, token.text, words)
    session.sink.report("E0100", session.span(token), found=found(token), expected=words, help=help_text)
    session.panic(token)
    return True


def _kind(session: Session) -> str | None:
    """What kind of statement the error stands in."""
    height = session.machine.boundary()
    return session.machine.kind(height) if height else None


def _statement(session: Session, token: Token) -> list[Token]:
    """The tokens of the statement before `token`."""
    before = []
    for ahead in session.look_ahead(session.statement_start(token)):
        if ahead.start >= token.start:
            break
        before.append(ahead)
    return before
