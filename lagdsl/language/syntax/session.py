"""One run of Lark's interactive parser over a text: where it is, and the moves by which it recovers from an error."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from itertools import islice, pairwise, takewhile

from lark import Token
from lark.exceptions import UnexpectedCharacters, UnexpectedToken

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.catalog.characters import character_help
from lagdsl.foundation.record import mutable_record
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.language.syntax import limits
from lagdsl.language.syntax.builder import Builder, Part, TooDeep
from lagdsl.language.syntax.language import language, plain_lexer
from lagdsl.language.syntax.stack import Stack, boundaries, statement_words
from lagdsl.language.syntax.tokens import (
    END_OF_TEXT,
    as_name,
    as_text,
    check_length,
    check_number,
    end_of,
    goes_over_a_line_end,
    plain_tokens,
    second_division,
    span_of,
    start_of,
    strange_text,
    token_at,
    unit_of,
)
from lagdsl.language.syntax.vocabulary import vocabulary

CLOSING = {"(": ")", "[": "]", "{": "}"}
BLOCKS = ("for", "if", "when")
LONGEST_LOOK = 400  # tokens; a look ahead tells what a statement was meant to be, no more
_LONGEST_OPERAND = 80  # characters
_OPENING_TERMINALS = ("LPAR", "LSQB", "LBRACE")
_CLOSING_TERMINALS = ("RPAR", "RSQB", "RBRACE")
_BRANCHES = ("elseif", "elsewhen")
_HEADERS = {"for": "for i in i loop", "if": "if true then", "when": "when true then"}


@mutable_record()
class Reported:
    """`last` is the place of the last thing that is no token; `failures` by place how often the parser could not go on
    there; `told` (code, place) of what is said once for many statements."""

    last: int = -1
    failures: dict[int, int] = field(default_factory=dict)
    told: set[tuple[str, int]] = field(default_factory=set)


class Session:
    """Lark's parser with its lexer, and what is known of the text besides to report and repair."""

    def __init__(self, file: SourceFile, sink: Sink, start: str) -> None:
        self.file = file
        self.sink = sink
        self.builder = Builder(file, sink)
        self.stack = Stack(language().parser(file.text, start), self.builder)
        self.tree: object | None = None
        self.finished = False
        self.previous = token_at(END_OF_TEXT, "", 0, 0)
        self.brackets: list[Token] = []
        self.reported = Reported()
        self._tokens = self._contextual_tokens()

    # ---- reading --------------------------------------------------------------------------------------------------

    def take(self) -> Token:
        """The next token as the parser's state reads it."""
        while True:
            try:
                token = next(self._tokens, None)
            except UnexpectedToken as fault:  # a token in another state of the parser
                token = as_name(fault.token)
                self._tokens = self._contextual_tokens()
            except UnexpectedCharacters as fault:
                self._report_character(fault)
                continue
            if token is None:
                return self._end_of_text()
            checked = self._checked(token)
            if checked is not None:
                return checked

    def skip(self) -> Token:
        """The next token as it is without a parser; what is no token is reported."""
        while True:
            try:
                token = next(plain_lexer().lex(self.stack.parser.lexer_thread.state, None), None)
            except UnexpectedCharacters as fault:
                self._report_character(fault)
                continue
            if token is None:
                return self._end_of_text()
            checked = self._checked(as_name(token))
            if checked is not None:
                return checked

    def shift(self, token: Token) -> bool:
        """Feed `token` to the parser; brackets are kept in a list of their own. False if it does not fit."""
        if not self.stack.feed(token):
            return False
        if token.type == END_OF_TEXT:
            return self._finish(self.stack.values[-1])
        if len(self.stack.values) > limits.MAX_STACK:
            raise TooDeep(self.span(token))
        if token.type in _OPENING_TERMINALS:
            self.brackets.append(token)
            if len(self.brackets) > limits.MAX_BRACKETS:
                raise TooDeep(self.span(token), brackets=True)
        elif token.type in _CLOSING_TERMINALS and self.brackets:
            self.brackets.pop()
        self.previous = token
        self.builder.end = end_of(token)
        return True

    def _finish(self, whole: Part) -> bool:
        self.finished = True
        self.tree = whole.value
        return True

    def rewind(self, position: int) -> None:
        """Go on from another place of the text."""
        self.stack.parser.lexer_thread.state.line_ctr.char_pos = position
        self._tokens = self._contextual_tokens()

    def look_ahead(self, position: int) -> Iterator[Token]:
        """Tokens from `position` to the end of the statement, without the `;`; reports nothing."""
        ahead = islice(plain_tokens(self.file.text, position), LONGEST_LOOK)
        return takewhile(lambda token: token.type != "SEMICOLON", ahead)

    def _contextual_tokens(self) -> Iterator[Token]:
        tokens: Iterator[Token] = self.stack.parser.lexer_thread.lex(self.stack.parser.parser_state)
        return tokens

    def _end_of_text(self) -> Token:
        end = len(self.file.text)
        return token_at(END_OF_TEXT, "", end, end)

    def _checked(self, token: Token) -> Token | None:
        """The token after its faults are reported; none if it was nothing but a fault."""
        match token.type:
            case "IDENT":
                check_length(token, self.sink, self.file, "name", limits.MAX_NAME)
            case "STRING":
                check_length(token, self.sink, self.file, "text", limits.MAX_STRING)
            case "NUMBER":
                check_number(token, self.sink, self.file)
            case "QUANTITY":
                check_number(token, self.sink, self.file)
                self._check_division(token)
            case "UNCLOSED_COMMENT":
                self.sink.report("E0107", Span(self.file, start_of(token), start_of(token) + 2))
                return None
            case "UNCLOSED_STRING":
                self.reported.last = self.opened_string(token)
                self.sink.report("E0126", Span(self.file, self.reported.last, self.reported.last + 1))
                return as_text(token)
            case _:
                pass
        return token

    def _check_division(self, token: Token) -> None:
        second = second_division(self.file.text, token)
        if second is not None:
            slash, end = second
            self.sink.report("E0104", Span(self.file, slash, slash + 1), unit=unit_of(token.value))
            self.rewind(end)

    def _report_character(self, fault: UnexpectedCharacters) -> None:
        """A character or a word that is no token."""
        strange, go_on = strange_text(self.file.text, fault)
        start = self.reported.last = int(fault.pos_in_stream or 0)
        spelled = "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in strange[:20])
        before = self.file.text[max(self.file.text.rfind("\n", 0, start) + 1, start - _LONGEST_OPERAND) : start]
        span = Span(self.file, start, start + len(strange))
        self.sink.report("E0108", span, character=spelled, help=character_help(strange, before))
        self.rewind(go_on if len(self.sink.diagnostics) < limits.MAX_ERRORS else len(self.file.text))

    # ---- places -----------------------------------------------------------------------------------------------------

    def span(self, token: Token) -> Span:
        return span_of(self.file, token)

    def after_previous(self) -> Span:
        """The empty place behind the last token that was understood."""
        return Span(self.file, end_of(self.previous), end_of(self.previous))

    def starts_line(self, token: Token) -> bool:
        """True if nothing but blanks stands before the token on its line."""
        text, at = self.file.text, start_of(token) - 1
        while at >= 0 and text[at] in " \t":
            at -= 1
        return at < 0 or text[at] == "\n"

    # ---- the statement at fault ------------------------------------------------------------------------------------

    def statement_start(self, token: Token) -> int:
        """Start of the statement that contains the error at `token`."""
        unfinished = self.stack.above(self.stack.boundary() or 1)
        return int(unfinished[0].start_pos) if unfinished else start_of(token)

    def opened_string(self, last: Token) -> int:
        """Start of the text in quotes that is not closed, if `last` is the one at which this shows. Marks in those that
        follow it, as in `"+"`, join them to one expression: the first one of the statement over a line end is open."""
        read = plain_tokens(self.file.text, self.statement_start(last))
        return start_of(next(filter(goes_over_a_line_end, read), last))

    def open_block(self) -> Token | None:
        """The word that begins the innermost open class, loop, branch or event."""
        below = zip(self.stack.states, self.stack.values, strict=False)
        for state, value in reversed(list(below)):
            if isinstance(value, Token) and (
                value.type == "CLASS_KIND" or (value.value in BLOCKS and state in boundaries())
            ):
                return value
        return None

    def outermost_block(self) -> Token | None:
        """The word that begins the outermost open loop or branch of the innermost open class."""
        found: Token | None = None
        for state, value in zip(self.stack.states, self.stack.values, strict=False):
            if isinstance(value, Token) and value.type == "CLASS_KIND":
                found = None
            elif isinstance(value, Token) and value.value in BLOCKS and state in boundaries():
                found = found or value
        return found

    def open_classes(self) -> list[str]:
        """Names of the classes that are open, outermost first."""
        return [
            after.value
            for value, after in pairwise(self.stack.values)
            if isinstance(value, Token) and value.type == "CLASS_KIND" and isinstance(after, Token)
        ]

    # ---- repairs ---------------------------------------------------------------------------------------------------

    def insert(self, *words: str) -> bool:
        """Shift words or marks that the text lacks; the rest of the text is read again from where it stood."""
        known, marks, _ = vocabulary()
        for word in words:
            at = end_of(self.previous)
            terminals = (marks[word],) if word in marks else (*known.get(word, ()), "IDENT")
            terminal = next((t for t in terminals if self.stack.accepts(t)), None)
            if terminal is None or not self.shift(token_at(terminal, word, at, at)):
                return False
        return True

    def give_up(self) -> None:
        """No more can be learned from this text."""
        self.finished = True

    def close_all(self) -> None:
        """Forget the statement that is unfinished and end all that is open, so that there is a tree of the rest."""
        end = len(self.file.text)
        self.previous = token_at(END_OF_TEXT, "", end, end)
        while True:
            self.stack.settle()
            self.stack.cut(self.stack.boundary())
            block = self.open_block()
            if block is None:
                self.shift(self._end_of_text())
                return
            if not self.insert("end", *(() if block.type == "CLASS_KIND" else (block.value,)), ";"):
                return

    def panic(self, token: Token) -> None:
        """Forget the statement and read on behind its `;`, or before the next `end` or statement keyword."""
        height = self.stack.boundary()
        if height == 0:
            self.give_up()
            return
        unfinished = self.stack.above(height)
        opener = unfinished[0] if unfinished else None
        start = self.statement_start(token)
        self.brackets = [bracket for bracket in self.brackets if start_of(bracket) < start]
        branch = any(isinstance(value, Token) and value.value in _BRANCHES for value in unfinished)
        self.stack.cut(height)
        block = opener.value if isinstance(opener, Token) and opener.value in BLOCKS else None
        self._skip_statement(token, block is not None or branch)
        if block is not None:
            self.insert(*_HEADERS[block].split())

    def _skip_statement(self, token: Token, in_header: bool) -> None:
        words = statement_words()
        while token.type != END_OF_TEXT:
            anchor = token.value == "end" or (token.value in words and self.starts_line(token))
            if anchor and self._fits(token):
                break
            if token.type == "SEMICOLON" and not self._separates_rows(token):
                self.rewind(start_of(token) + 1)
                return
            if in_header and token.value in ("loop", "then"):
                self.rewind(end_of(token))
                return
            token = self.skip()
        self.rewind(start_of(token))

    def _fits(self, token: Token) -> bool:
        return any(terminal in self.stack.parser.choices() for terminal in vocabulary().words.get(token.value, ()))

    def _separates_rows(self, token: Token) -> bool:
        """A `;` with more text on its line stands in a matrix if a `]` follows there."""
        line_end = self.file.text.find("\n", end_of(token))
        rest = self.file.text[end_of(token) : line_end if line_end >= 0 else len(self.file.text)]
        return "]" in rest and "[" not in rest.partition("]")[0]
