"""Texts that fit at a place, in plain words."""

from __future__ import annotations

from lark import Token

from lagdsl.language.syntax.stack import Stack
from lagdsl.language.syntax.tokens import END_OF_TEXT
from lagdsl.language.syntax.vocabulary import vocabulary

_MOST = 4  # a longer list no longer helps
_FIRST = (";", ",", "=", ")", "]", "}")

_EXPRESSION = {"IDENT", "NUMBER", "QUANTITY", "STRING", "TRUE", "FALSE", "NOT", "IF", "PLUS", "MINUS"} | {
    "LPAR",
    "LBRACE",
    "LSQB",
}
_OPERATORS = {"PLUS", "MINUS", "STAR", "SLASH", "CIRCUMFLEX", "REL", "AND", "OR", "DOT", "LPAR", "LSQB"}
_ELEMENTWISE = (".*", "./")


def expected(stack: Stack) -> str:
    """`` `;` or an operator ``, `an expression`, `a name`: what the parser would take next."""
    accepted = stack.accepted()
    if "CLASS_KIND" in accepted and not stack.at_boundary():
        return "a type"
    if "CLASS_KIND" in accepted or "COORDINATE" in accepted:
        return "a declaration, a statement or `end`" if "END" in accepted else "a model, package, function or type"
    words: list[str] = []
    if "NUMBER" in accepted:
        words.append("an expression")
        accepted -= _EXPRESSION
    if "IDENT" in accepted:
        words.append("a name")
    if "STAR" in accepted and "PLUS" in accepted:
        words.append("an operator")
        accepted -= _OPERATORS | {vocabulary().marks[mark] for mark in _ELEMENTWISE}
    if "STRING" in accepted:
        words.append("a description in quotes")
    accepted -= {"IDENT", "STRING"}
    words = [*_spellings(accepted), *words]
    return _listed(words[:_MOST])


def found(token: Token) -> str:
    """The token as a message names it."""
    if token.type == END_OF_TEXT:
        return "the end of the file"
    if token.type == "STRING":
        return "this text in quotes"
    return f"`{token.value}`"


def _spellings(terminals: set[str]) -> list[str]:
    """Marks and words in backticks, `;` first; the end of the text is never what is missing."""
    marks = [mark for mark, terminal in vocabulary().marks.items() if terminal in terminals]
    words = [word for word, options in vocabulary().words.items() if not terminals.isdisjoint(options)]
    marks.sort(key=lambda mark: (_FIRST.index(mark) if mark in _FIRST else len(_FIRST), mark))
    return [f"`{text}`" for text in marks + words]


def _listed(words: list[str]) -> str:
    if len(words) <= 1:
        return "".join(words) or "the end of the text"
    return f"{', '.join(words[:-1])} or {words[-1]}"
