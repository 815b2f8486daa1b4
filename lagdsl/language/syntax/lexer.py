"""Lark's contextual lexer that compiles one regular expression instead of one for each set of accepted terminals.

To compile those of the states that a short text meets takes longer than to parse it.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from copy import copy
from typing import TypeAlias

from lark import Token
from lark.common import LexerConf
from lark.lexer import AbstractBasicLexer, BasicLexer, ContextualLexer, LexerState, UnlessCallback
from lark.utils import TextSlice

Found: TypeAlias = "tuple[str, str] | None"
"""The text of a token and the name of its terminal."""
States: TypeAlias = Mapping[int, Mapping[str, object]]
"""For every state of the automaton the symbols that it takes."""
_BLANKS = " \t\r\n"
"""The grammar ignores them between tokens, as it does comments."""


class StateLexer(BasicLexer):
    """Finds what Lark's BasicLexer of the same terminals finds; asks `whole`, the lexer of all terminals, first.

    Both try their terminals in the same order. So the first terminal of `whole` that matches is the answer if it is
    among ours; else the regular expression of ours alone decides.
    """

    def __init__(self, conf: LexerConf, whole: WholeLexer) -> None:
        super().__init__(conf)
        self._whole = whole
        self._accepted = frozenset(terminal.name for terminal in self.terminals)
        self.callback = {name: self._keyword for name in whole.keywords if name in self._accepted}

    def next_token(self, lex_state: LexerState, parser_state: object = None) -> Token:
        """The next token that is not ignored, with its place; nobody asks for its line. Raises as Lark's does."""
        slice_, places = lex_state.text, lex_state.line_ctr
        text, start = slice_.text, places.char_pos
        while start < slice_.end:
            if text[start] in _BLANKS:
                start += 1
                continue
            found = self.match(slice_, start)
            if found is None:
                break
            value, kind = found
            end = start + len(value)
            if kind not in self.ignore_types:
                places.char_pos = end
                token = Token(kind, value, start, None, None, None, None, end)
                change = self.callback.get(kind)
                lex_state.last_token = token if change is None else change(token)
                return lex_state.last_token
            start = end
        places.char_pos = start
        return super().next_token(lex_state, parser_state)

    def match(self, text: TextSlice[str], pos: int) -> Found:
        found: Found = self._whole.scanner.match(text, pos)
        if found is None or found[1] in self._accepted:
            return found
        alone: Found = self.scanner.match(text, pos)
        return alone

    def _keyword(self, token: Token) -> Token:
        """The token; a word that is accepted here as a keyword is one."""
        kind = self._whole.keywords[token.type].get(token.value)
        if kind in self._accepted:
            token.type = kind
        return token


class WholeLexer(BasicLexer):
    """The lexer of all terminals. `keywords` are words that another terminal matches, by its name and their text."""

    def __init__(self, conf: LexerConf) -> None:
        super().__init__(conf)
        assert self.scanner
        self.keywords = {
            name: {terminal.pattern.value: terminal.name for terminal in unless.scanner.terminals}
            for name, unless in self.callback.items()
            if isinstance(unless, UnlessCallback)
        }


class _ByState(dict[int, AbstractBasicLexer]):
    """Lexers made when a parser first comes to their state; states that accept the same share one."""

    def __init__(self, whole: WholeLexer, conf: LexerConf, states: States, always: Collection[str]) -> None:
        super().__init__()
        self._whole = whole
        self._conf, self._states, self._always = conf, states, {*conf.ignore, *always}
        self._made: dict[frozenset[str], StateLexer] = {}

    def __missing__(self, state: int) -> StateLexer:
        accepted = self._conf.terminals_by_name.keys() & (self._states[state].keys() | self._always)
        lexer = self._made.get(frozenset(accepted))
        if lexer is None:
            conf = copy(self._conf)
            conf.terminals = [terminal for terminal in self._conf.terminals if terminal.name in accepted]
            lexer = self._made[frozenset(accepted)] = StateLexer(conf, self._whole)
        self[state] = lexer
        return lexer


class StateLexers(ContextualLexer):
    """Lark's contextual lexer, with the lexers of its states made when they are needed."""

    def __init__(self, conf: LexerConf, states: States, always: Collection[str]) -> None:
        self.root_lexer = whole = WholeLexer(conf)
        self.lexers = _ByState(whole, conf, states, always)
