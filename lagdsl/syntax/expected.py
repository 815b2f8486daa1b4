"""What may stand at a place, in plain words."""

from __future__ import annotations

from lagdsl.syntax import tables
from lagdsl.syntax.automaton import END_OF_TEXT, TERMINAL
from lagdsl.syntax.lexer import Token
from lagdsl.syntax.machine import Machine

_MOST = 4  # a longer list no longer helps
_FIRST = (";", ",", "=", ")", "]", "}")

_EXPRESSION = (
    "IDENT",
    "NUMBER",
    "QUANTITY",
    "STRING",
    "TRUE",
    "FALSE",
    "NOT",
    "IF",
    "PLUS",
    "MINUS",
    "LPAR",
    "LBRACE",
    "LSQB",
)
_OPERATORS = ("PLUS", "MINUS", "STAR", "SLASH", "CIRCUMFLEX", "REL", "AND", "OR", "DOT", "LPAR", "LSQB", ".*", "./")


def expected(machine: Machine) -> str:
    """`` `;` or an operator ``, `an expression`, `a name`: what the machine would take next."""
    accepted = {t for t in machine.accepted if t < len(TERMINAL) and machine.accepts(t)}
    if TERMINAL["CLASS_KIND"] in accepted and len(machine.states) != machine.boundary():
        return "a type"
    if TERMINAL["CLASS_KIND"] in accepted or TERMINAL["COORDINATE"] in accepted:
        return (
            "a declaration, a statement or `end`"
            if TERMINAL["END"] in accepted
            else "a model, package, function or type"
        )
    words: list[str] = []
    if TERMINAL["NUMBER"] in accepted:
        words.append("an expression")
        accepted -= _numbers(_EXPRESSION)
    if TERMINAL["IDENT"] in accepted:
        words.append("a name")
    if TERMINAL["STAR"] in accepted and TERMINAL["PLUS"] in accepted:
        words.append("an operator")
        accepted -= _numbers(_OPERATORS)
    if TERMINAL["STRING"] in accepted:
        words.append("a description in quotes")
    accepted -= _numbers(("IDENT", "STRING"))
    words = [*_spellings(accepted), *words]
    return _listed(words[:_MOST])


def found(token: Token) -> str:
    """The token as a message names it."""
    if token.terminal == END_OF_TEXT:
        return "the end of the file"
    if token.terminal == TERMINAL["STRING"]:
        return "this text in quotes"
    return f"`{token.text}`"


def _numbers(names: tuple[str, ...]) -> set[int]:
    return {TERMINAL[name] if name in TERMINAL else tables.MARKS[name] for name in names}


def _spellings(terminals: set[int]) -> list[str]:
    """Marks and words in backticks, `;` first; the end of the text is never what is missing."""
    marks = [mark for mark, terminal in tables.MARKS.items() if terminal in terminals]
    words = [word for word, options in tables.WORDS.items() if not terminals.isdisjoint(options)]
    marks.sort(key=lambda mark: (_FIRST.index(mark) if mark in _FIRST else len(_FIRST), mark))
    return [f"`{text}`" for text in marks + words]


def _listed(words: list[str]) -> str:
    if len(words) <= 1:
        return "".join(words) or "the end of the text"
    return f"{', '.join(words[:-1])} or {words[-1]}"
