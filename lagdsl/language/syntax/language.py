"""The language as Lark runs it: LALR(1) with the contextual lexer, from grammar/lagdsl.lark.

Lark takes most of a second to compute the automaton of the grammar. `grammar.jsonl` beside this file holds it
(`automaton.py`); `python -m lagdsl.language.syntax.generate` writes that file.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import lark
from lark import Lark, Token
from lark.common import LexerConf
from lark.lark import PostLex
from lark.lexer import BasicLexer, LexerThread, TerminalDef
from lark.parsers.lalr_analysis import IntParseTable
from lark.parsers.lalr_interactive_parser import InteractiveParser
from lark.parsers.lalr_parser_state import ParseConf, ParserState

from lagdsl.foundation.resources import grammar_file
from lagdsl.language.syntax.automaton import Row, States, stored_automaton
from lagdsl.language.syntax.lexer import StateLexers

STARTS = ("start", "expr")
STORED = Path(__file__).with_name("grammar.jsonl")


class _InEveryState(PostLex):
    """Terminals that the contextual lexer looks for whether the parser accepts them or not.

    Without IDENT `atP` would be the keyword `at` and the name `P` where only the keyword is accepted, and without
    ELSEWHEN `elsewhen` would be `else when`.
    """

    always_accept = ("IDENT", "ELSEIF", "ELSEWHEN", "STRING", "UNCLOSED_STRING", "UNCLOSED_COMMENT")

    def process(self, stream: Iterator[Token]) -> Iterator[Token]:
        return stream


class Language:
    """An automaton with a lexer for its states. `table.states` may hold only the states that were asked for."""

    def __init__(self, table: IntParseTable, terminals: Collection[TerminalDef], ignored: Collection[str]) -> None:
        self.table = table
        self.terminals = {terminal.name: terminal for terminal in terminals}
        conf = LexerConf(list(terminals), re, ignored, skip_validation=True)
        self.lexers = StateLexers(conf, table.states, _InEveryState.always_accept)

    def parser(self, text: str, start: str) -> InteractiveParser:
        """A parser at the beginning of `text`. It has no callbacks and makes no trees."""
        thread = LexerThread.from_text(self.lexers, text)
        conf: Any = ParseConf(self.table, {}, start)
        return InteractiveParser(None, ParserState(conf, thread), thread)


@cache
def language() -> Language:
    """From what is stored, else, if another version of Lark stored it, from the grammar itself."""
    found = stored_automaton(STORED.read_text(encoding="utf-8"), lark_version())
    if found is None:
        made: Any = compiled(grammar_file().read_text(encoding="utf-8"))
        return Language(made.parser.parser._parse_table, made.terminals, made.ignore_tokens)
    return Language(*found)


def all_states() -> Mapping[int, Row]:
    """Action of every state of the automaton at each symbol."""
    states = language().table.states
    return states.complete() if isinstance(states, States) else states


def compiled(grammar: str) -> Lark:
    """Lark's own parser of the text of a grammar."""
    return Lark(
        grammar,
        parser="lalr",
        lexer="contextual",
        maybe_placeholders=True,
        start=list(STARTS),
        postlex=_InEveryState(),
    )


def lark_version() -> str:
    """Major and minor version of Lark: within them the serialised form is the same."""
    return ".".join(lark.__version__.split(".")[:2])


def plain_lexer() -> BasicLexer:
    """The lexer that asks no parser: every word that may be a keyword is one."""
    lexer = language().lexers.root_lexer
    assert isinstance(lexer, BasicLexer)
    return lexer
