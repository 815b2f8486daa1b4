"""One run of the parser over a text: where it is, and the moves by which it recovers from an error."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from lagdsl.diagnostics import Sink
from lagdsl.source import SourceFile, Span
from lagdsl.syntax import limits, tables
from lagdsl.syntax.automaton import END_OF_TEXT, TERMINAL, row
from lagdsl.syntax.lexer import IDENT, Lexer, Token
from lagdsl.syntax.machine import Machine, TooDeep
from lagdsl.syntax.reductions import actions

CLOSING = {"(": ")", "[": "]", "{": "}"}
BLOCKS = ("for", "if", "when")
CLASS_KIND = TERMINAL["CLASS_KIND"]
SEMICOLON = TERMINAL["SEMICOLON"]
LONGEST_LOOK = 400  # tokens; a look ahead tells what a statement was meant to be, no more
_BRANCHES = ("elseif", "elsewhen")
_HEADERS = {"for": "for i in i loop", "if": "if true then", "when": "when true then"}


class Session:
    """The lexer, the machine and what both must know of each other to report and repair."""

    def __init__(self, file: SourceFile, sink: Sink, start: str) -> None:
        self.file = file
        self.sink = sink
        self.lexer = Lexer(file, sink)
        self.machine = Machine(file, start, actions(sink))
        self.previous = Token(END_OF_TEXT, "", 0, 0)
        self.brackets: list[Token] = []
        self.failures: dict[int, int] = {}  # by place: how often the parser could not go on there
        self.told: set[tuple[str, int]] = set()  # (code, place) of what is said once for many statements
        self.stopped = False

    # ---- reading --------------------------------------------------------------------------------------------------

    def take(self) -> Token:
        """The next token as the parser's state reads it."""
        return self.lexer.next(self.machine.accepted)

    def shift(self, token: Token) -> bool:
        """Feed `token`; brackets are kept in a list of their own. False if it does not fit."""
        if not self.machine.feed(token):
            return False
        if token.text in CLOSING and token.terminal != IDENT:
            self.brackets.append(token)
            if len(self.brackets) > limits.MAX_BRACKETS:
                raise TooDeep(self.span(token))
        elif token.text in CLOSING.values() and self.brackets:
            self.brackets.pop()
        self.previous = token
        return True

    def span(self, token: Token) -> Span:
        return Span(self.file, token.start, token.end)

    def after_previous(self) -> Span:
        """The empty place behind the last token that was understood."""
        return Span(self.file, self.previous.end, self.previous.end)

    def starts_line(self, token: Token) -> bool:
        """Whether nothing but blanks stands before the token on its line."""
        text, at = self.file.text, token.start - 1
        while at >= 0 and text[at] in " \t":
            at -= 1
        return at < 0 or text[at] == "\n"

    def look_ahead(self, position: int) -> Iterator[Token]:
        """Tokens from `position` to the end of the statement, without the `;`; reports nothing."""
        lexer = Lexer(self.file, Sink())
        lexer.position = position
        for _ in range(LONGEST_LOOK):
            token = lexer.next()
            if token.terminal in (END_OF_TEXT, SEMICOLON):
                return
            yield token

    # ---- the statement at fault ------------------------------------------------------------------------------------

    def statement_start(self, token: Token) -> int:
        """Where the statement that holds the error at `token` begins."""
        height = self.machine.boundary()
        return self.machine.starts[height] if height < len(self.machine.states) else token.start

    def open_block(self) -> Token | None:
        """The word that begins the innermost open class, loop, branch or event."""
        machine = self.machine
        for height in range(len(machine.values) - 1, 0, -1):
            value = machine.values[height]
            if isinstance(value, Token) and (
                value.terminal == CLASS_KIND or (value.text in BLOCKS and machine.states[height - 1] in tables.BOUNDARY)
            ):
                return value
        return None

    def open_classes(self) -> list[str]:
        """Names of the classes that are open, outermost first."""
        values = self.machine.values
        return [
            after.text
            for value, after in pairwise(values)
            if isinstance(value, Token) and value.terminal == CLASS_KIND and isinstance(after, Token)
        ]

    # ---- repairs ---------------------------------------------------------------------------------------------------

    def insert(self, *words: str) -> bool:
        """Shift words or marks that the text lacks; the rest of the text is read again from where it stood."""
        for word in words:
            at = self.previous.end
            terminals = (tables.MARKS[word],) if word in tables.MARKS else (*tables.WORDS.get(word, ()), IDENT)
            terminal = next((t for t in terminals if self.machine.accepts(t)), None)
            if terminal is None or not self.shift(Token(terminal, word, at, at)):
                return False
        return True

    def give_up(self) -> None:
        """No more can be learned from this text."""
        self.stopped = True

    def panic(self, token: Token) -> None:
        """Forget the statement and read on behind its `;`, or before the next `end` or statement keyword."""
        height = self.machine.boundary()
        if height == 0:
            self.give_up()
            return
        opener = self.machine.values[height] if height < len(self.machine.values) else None
        start = self.statement_start(token)
        self.brackets = [bracket for bracket in self.brackets if bracket.start < start]
        branch = any(isinstance(value, Token) and value.text in _BRANCHES for value in self.machine.values[height:])
        self.machine.cut(height)
        block = opener.text if isinstance(opener, Token) and opener.text in BLOCKS else None
        self._skip(token, block is not None or branch)
        if block is not None:
            self.insert(*_HEADERS[block].split())

    def _skip(self, token: Token, in_header: bool) -> None:
        words = statement_words()
        while token.terminal != END_OF_TEXT:
            anchor = token.text == "end" or (token.text in words and self.starts_line(token))
            if anchor and self._fits(token):
                self.lexer.rewind(token.start)
                return
            if token.terminal == SEMICOLON and not self._separates_rows(token):
                if in_header:
                    self.lexer.rewind(token.start + 1)
                return
            if in_header and token.text in ("loop", "then"):
                return
            token = self.lexer.next()
        self.lexer.rewind(token.start)

    def _fits(self, token: Token) -> bool:
        return any(terminal in self.machine.accepted for terminal in tables.WORDS.get(token.text, ()))

    def _separates_rows(self, token: Token) -> bool:
        """A `;` with more text on its line stands in a matrix if a `]` follows there."""
        line_end = self.file.text.find("\n", token.end)
        rest = self.file.text[token.end : line_end if line_end >= 0 else len(self.file.text)]
        return "]" in rest and "[" not in rest.partition("]")[0]


def statement_words() -> frozenset[str]:
    """Words that begin a statement or end a list of statements."""
    begins = {terminal for state in tables.BOUNDARY for terminal in row(state)}
    return frozenset(
        word
        for word, terminals in tables.WORDS.items()
        if word not in ("true", "false", "not", "if") and any(terminal in begins for terminal in terminals)
    )
