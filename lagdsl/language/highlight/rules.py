"""Rules that tell the kinds of tokens without a parser; words, numbers and units are those of the grammar.

A soft keyword is a keyword where a statement begins; inside of a statement it is a name. So a rule is a pattern, or a
region from one pattern to another with rules of its own, as TextMate has them. The patterns are those that Python and
Oniguruma read alike, and none looks beyond its line.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum
from functools import cache
from typing import TypeAlias

from lagdsl.foundation.record import record
from lagdsl.language.syntax.stack import statement_words
from lagdsl.language.syntax.vocabulary import pattern, vocabulary


class Kind(StrEnum):
    """Kind of a token; a TYPE is a name that is declared as a class."""

    COMMENT = "comment"
    STRING = "string"
    NUMBER = "number"
    UNIT = "unit"
    KEYWORD = "keyword"
    LITERAL = "literal"
    OPERATOR = "operator"
    MARK = "mark"
    TYPE = "type"
    NAME = "name"


@record()
class Match:
    """Texts of one pattern; `kinds` are those of its groups, or of the whole where it has no groups."""

    pattern: str
    kinds: tuple[Kind, ...]


@record()
class Region:
    """Texts from `begin` to `end`, with the rules of the context `inside` between them."""

    begin: str
    begin_kinds: tuple[Kind, ...]
    end: str
    end_kind: Kind
    inside: str
    whole: Kind | None = None  # kind of all that no rule inside takes


@record()
class Include:
    """The rules of another context."""

    context: str


Rule: TypeAlias = Match | Region | Include

ROOT = "statements"
_WORD_END = r"(?![A-Za-z0-9_])"
_WORD_BEGIN = r"(?<![A-Za-z0-9_])"
_NAME = r"[A-Za-z_][A-Za-z0-9_]*"
# A word such as `at` joins two operands: no operator stands before it, and an operand behind it.
_AFTER_OPERAND = r"(?<![-+*/^=(,{<>:.\[])(?<![-+*/^=(,{<>:.\[] )"
_BEFORE_OPERAND = rf"(?=[ \t]*$|[ \t]+(?!if{_WORD_END})[-A-Za-z0-9_{{(\[])"
_LITERALS = ("true", "false")


@cache
def contexts() -> dict[str, tuple[Rule, ...]]:
    """Rules by the name of their context, the earlier before the later; the text begins in ROOT."""
    known, marks, reserved = vocabulary()
    leading = set(statement_words()) - reserved
    kinds = {word for word, terminals in known.items() if "CLASS_KIND" in terminals}
    prefixes = {word for word, terminals in known.items() if "PREFIX" in terminals}
    modifiers = {word for word, terminals in known.items() if {"MODIFIER_PREFIX", "REDECLARE"} & set(terminals)}
    sections = {word for word, terminals in known.items() if {"EQUATION_SECTION", "VISIBILITY"} & set(terminals)}
    infix = set(known) - reserved - leading - modifiers - {"enumeration"}
    alone = (sections - reserved) | prefixes | {"initial"}
    statements = leading - kinds - alone
    named = Match(rf"{_word(kinds | {'function', 'type'})}(\s+)({_NAME})", (Kind.KEYWORD, Kind.MARK, Kind.TYPE))
    header = (reserved & {"if", "when", "for", "elseif", "elsewhen"}, reserved & {"then", "loop"})
    return {
        "texts": _texts(),
        "atoms": (
            Include("texts"),
            Match(f"({pattern('NUMBER').pattern})({_unit()})", (Kind.NUMBER, Kind.UNIT)),
            Match(pattern("NUMBER").pattern, (Kind.NUMBER,)),
            Match(_word(_LITERALS), (Kind.LITERAL,)),
            Match(_word(reserved - set(_LITERALS)), (Kind.KEYWORD,)),
            Region(r"[(\[{]", (Kind.MARK,), r"[)\]}]", Kind.MARK, "brackets"),
        ),
        "operands": (
            Include("atoms"),
            Match(_NAME, (Kind.NAME,)),
            Match("|".join(_escaped(mark) for mark in marks if mark not in "()[]{},;"), (Kind.OPERATOR,)),
            Match(r"[,;]", (Kind.MARK,)),
        ),
        "brackets": (
            Match(rf"{_word(['redeclare'])}(\s+){_word(kinds)}", (Kind.KEYWORD, Kind.MARK, Kind.KEYWORD)),
            Match(rf"{_word(modifiers)}(?=[ \t]+[A-Za-z_]|[ \t]*$)", (Kind.KEYWORD,)),
            Include("operands"),
        ),
        "statement": (
            Match(rf"{_WORD_BEGIN}enumeration(?=\s*\()", (Kind.KEYWORD,)),
            Match(_AFTER_OPERAND + _word(infix) + _BEFORE_OPERAND, (Kind.KEYWORD,)),
            Include("operands"),
        ),
        "equation": (Include("operands"),),
        ROOT: (
            Match(r"^%%lag[^\n]*", (Kind.COMMENT,)),  # the first line of a cell of a notebook
            Include("texts"),
            Region(_word(header[0]), (Kind.KEYWORD,), _word(header[1]), Kind.KEYWORD, "equation"),
            Region(_word(["end"]), (Kind.KEYWORD,), ";", Kind.MARK, "equation"),
            named,
            Region(rf"{_word(prefixes)}(?=\s*=)", (Kind.KEYWORD,), ";", Kind.MARK, "equation"),
            Match(_word(alone | kinds), (Kind.KEYWORD,)),
            Region(_word(statements - {"function", "type"}), (Kind.KEYWORD,), ";", Kind.MARK, "statement"),
            Region(r"=(?=\s*enumeration\s*\()", (Kind.OPERATOR,), ";", Kind.MARK, "statement"),
            Include("atoms"),
            Region(_NAME, (Kind.NAME,), ";", Kind.MARK, "equation"),
            Include("operands"),
        ),
    }


def _texts() -> tuple[Rule, ...]:
    """Comments and texts in quotes."""
    return (
        Match(r"//[^\n]*", (Kind.COMMENT,)),
        Region(r"/\*", (Kind.COMMENT,), r"\*/", Kind.COMMENT, "comment", Kind.COMMENT),
        Region('"', (Kind.STRING,), '"', Kind.STRING, "string", Kind.STRING),
    )


def inner() -> dict[str, tuple[Rule, ...]]:
    """Contexts of comments and texts in quotes."""
    return {"comment": (), "string": (Match(r"\\(?:.|$)", (Kind.STRING,)),)}


def _unit() -> str:
    """The unit of a quantity, with the blank before it."""
    whole, number = pattern("QUANTITY").pattern, pattern("NUMBER").pattern
    assert whole.startswith(number)
    return whole.removeprefix(number)


def _word(words: Iterable[str]) -> str:
    """A pattern of words that are not parts of longer ones, as one group."""
    return rf"{_WORD_BEGIN}({'|'.join(sorted(words, key=lambda word: (-len(word), word)))}){_WORD_END}"


def _escaped(mark: str) -> str:
    return "".join(f"\\{character}" for character in mark)
