"""The words and marks of the grammar, for messages and for recovery from errors."""

from __future__ import annotations

import re
from functools import cache
from typing import NamedTuple

from lark.lexer import Pattern

from lagdsl.language.syntax.language import language


class Vocabulary(NamedTuple):
    """Spellings with the terminals that they may be."""

    words: dict[str, tuple[str, ...]]  # besides names, in alphabetical order
    marks: dict[str, str]  # longest first
    reserved: frozenset[str]  # words that are never names


@cache
def vocabulary() -> Vocabulary:
    """Read from the patterns of the grammar's terminals."""
    words: dict[str, tuple[str, ...]] = {}
    marks: dict[str, str] = {}
    for terminal in sorted(language().terminals.values(), key=lambda t: t.name):
        for text in _spellings(terminal.pattern):
            if text[0].isalpha():
                words[text] = (*words.get(text, ()), terminal.name)
            else:
                marks[text] = terminal.name
    return Vocabulary(
        words=dict(sorted(words.items())),
        marks=dict(sorted(marks.items(), key=lambda item: (-len(item[0]), item[0]))),
        reserved=_reserved(),
    )


@cache
def soft_terminals() -> frozenset[str]:
    """Terminals of words that are names where the parser takes no such word."""
    words, _, reserved = vocabulary()
    return frozenset(terminal for word, terminals in words.items() if word not in reserved for terminal in terminals)


@cache
def pattern(terminal: str) -> re.Pattern[str]:
    """The regular expression of a terminal."""
    return re.compile(language().terminals[terminal].pattern.to_regexp())


def _spellings(pattern: Pattern) -> list[str]:
    """The texts of a terminal that is one text or one of several; none for a terminal that is more than that."""
    if pattern.type == "str":
        return [pattern.value]
    inside = re.fullmatch(r"\(\?:([^()\\\[]*)\)(?:\(\?!\[[^()]*\]\))?", pattern.to_regexp())
    return [] if inside is None else inside[1].split("|")


def _reserved() -> frozenset[str]:
    """The words that stand in the pattern of IDENT, as what no name is."""
    found = re.match(r"\(\?!\(\?:([a-z|]+)\)", pattern("IDENT").pattern)
    assert found is not None
    return frozenset(found[1].split("|"))
