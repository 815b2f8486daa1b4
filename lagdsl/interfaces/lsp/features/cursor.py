"""Surroundings of the cursor in a text that is being typed: the statement, open brackets, the path before a dot."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Literal, TypeAlias

from lagdsl.foundation.record import record
from lagdsl.language.syntax.tokens import end_of, plain_tokens, start_of

if TYPE_CHECKING:
    from lark import Token

Want: TypeAlias = Literal["statement", "type", "member", "unit", "modifier", "expression", "package", "nothing"]

_NUMBER = re.compile(r"(?<![\w.])[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?[ \t]+(?:[A-Za-z0-9^]+[./])*[A-Za-z]*$")
_PATH = re.compile(r"((?:[A-Za-z_]\w*(?:\[[^\[\]\n]*\])?\s*\.\s*)+)([A-Za-z_]\w*)?$")
_LISTED = re.compile(r"([A-Za-z_][\w.]*)\.\{[\w\s,]*$")
_OPENING, _CLOSING = ("(", "[", "{"), (")", "]", "}")
_PREFIXES: tuple[str, ...] = (
    "parameter",
    "constant",
    "input",
    "output",
    "state",
    "discrete",
    "structural",
    "coordinate",
    "final",
)
_PREFIXES += ("flow", "replaceable", "extends")


@record()
class Bracket:
    """An open bracket with the name before it, if there is one, and the commas behind it."""

    mark: str
    before: tuple[str, ...]
    commas: int
    has_value: bool  # a `=` stands after the last comma


@record()
class Cursor:
    """`path` are the names before the dot, `brackets` those that are open, outermost first, `statement` the texts of
    the tokens of the statement so far."""

    want: Want
    path: tuple[str, ...]
    brackets: tuple[Bracket, ...]
    statement: tuple[str, ...]
    word: str
    called: str = ""
    """The function whose value stands before the dot: `reaction` of `reaction(A).`."""


def cursor_at(text: str, offset: int) -> Cursor:
    """The surroundings of `offset`."""
    before = text[:offset]
    tokens = list(plain_tokens(before))
    if tokens and tokens[-1].type == "STRING" and end_of(tokens[-1]) >= offset and not _closed(tokens[-1], before):
        return Cursor("nothing", (), (), (), "")
    if _in_comment(before, end_of(tokens[-1]) if tokens else 0):
        return Cursor("nothing", (), (), (), "")
    start = max((k + 1 for k, token in enumerate(tokens) if _ends_statement(tokens, k)), default=0)
    own = tokens[start:]
    match = re.search(r"[A-Za-z_]\w*$", before)
    word = match[0] if match is not None else ""
    texts = tuple(str(token.value) for token in own)
    brackets = tuple(_brackets(own))
    path = _PATH.search(before)
    names = tuple(re.findall(r"([A-Za-z_]\w*)(?:\[[^\]]*\])?\s*\.", path[1])) if path is not None else ()
    listed = _LISTED.search(before)
    if listed is not None and texts[:1] == ("import",):
        return Cursor("package", tuple(listed[1].split(".")), brackets, texts, word)
    called = _called(own[:-1] if word and own and own[-1].value == word else own)
    want: Want = "member" if called else _want(before, texts, brackets, word, names)
    return Cursor(want, names, brackets, texts, word, called)


def _called(tokens: list[Token]) -> str:
    """The name before the brackets that the dot at the end stands behind."""
    if [token.value for token in tokens[-2:]] != [")", "."]:
        return ""
    depth = 0
    for k in range(len(tokens) - 2, -1, -1):
        depth += (tokens[k].value in _CLOSING) - (tokens[k].value in _OPENING)
        if depth == 0:
            names = _names_before(tokens, k)
            return names[-1] if names else ""
    return ""


def _closed(token: Token, before: str) -> bool:
    return before.endswith('"') and end_of(token) - start_of(token) > 1


def _in_comment(text: str, end: int) -> bool:
    rest = text[end:]
    line = rest[rest.rfind("\n") + 1 :]
    return "//" in line or rest.rfind("/*") > rest.rfind("*/")


def _ends_statement(tokens: list[Token], k: int) -> bool:
    value = tokens[k].value
    if value == ";" or value in ("equation", "public", "protected", "kinematics", "closure", "then", "loop", "else"):
        return True
    heads = ("model", "package", "joint", "connector", "record", "block")
    head = k >= 1 and tokens[k - 1].value in heads
    doc = k >= 2 and tokens[k].type == "STRING" and tokens[k - 2].value in heads
    return doc or (head and not (k + 1 < len(tokens) and tokens[k + 1].type == "STRING"))


def _brackets(tokens: list[Token]) -> list[Bracket]:
    open_: list[Bracket] = []
    for k, token in enumerate(tokens):
        if token.value in _OPENING:
            open_.append(Bracket(str(token.value), _names_before(tokens, k), 0, False))
        elif token.value in _CLOSING and open_:
            open_.pop()
        elif open_ and token.value in (",", "="):
            last = open_[-1]
            is_comma = token.value == ","
            open_[-1] = Bracket(last.mark, last.before, last.commas + is_comma, not is_comma)
    return open_


def _names_before(tokens: list[Token], k: int) -> tuple[str, ...]:
    """`a`, `b` of `a.b(`; of a declaration all its plain tokens before the bracket."""
    names: list[str] = []
    k -= 1
    while k >= 0 and tokens[k].type == "IDENT":
        names.insert(0, str(tokens[k].value))
        if k >= 1 and tokens[k - 1].value == ".":
            k -= 2
        else:
            break
    return tuple(names)


def _want(before: str, texts: tuple[str, ...], brackets: tuple[Bracket, ...], word: str, path: tuple[str, ...]) -> Want:
    rest = texts[:-1] if word and texts and texts[-1] == word else texts
    first = rest[0] if rest else ""
    if _NUMBER.search(before):
        return "unit"
    if path:
        return "package" if first in ("import", "within") else "member"
    if first in ("import", "within"):
        return "package"
    if not rest:
        return "statement"
    inside = bool(brackets) and brackets[-1].mark == "("
    declares = first[:1].isupper() or first in _PREFIXES or first in ("annotation", "body")
    if inside and declares and not brackets[-1].has_value and "=" not in _outside(rest):
        return "modifier"
    if first in _PREFIXES and rest[-1] in _PREFIXES and not brackets:
        return "type"
    return "expression"


def _outside(texts: tuple[str, ...]) -> tuple[str, ...]:
    """The tokens outside of all brackets, of the last declarator."""
    found: list[str] = []
    depth = 0
    for text in texts:
        depth += (text in _OPENING) - (text in _CLOSING)
        if depth == 0 and text not in _CLOSING:
            found = [] if text == "," else [*found, text]
    return tuple(found)
