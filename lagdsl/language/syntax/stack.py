"""Rules that the parser has begun and not yet completed: reads the stack of Lark's interactive parser, and cuts it."""

from __future__ import annotations

from functools import cache
from typing import Any

from lark import Token
from lark.exceptions import UnexpectedInput, UnexpectedToken
from lark.grammar import Rule
from lark.parsers.lalr_analysis import Shift

from lagdsl.language.syntax.builder import Builder, keeps_value
from lagdsl.language.syntax.language import all_states, language
from lagdsl.language.syntax.tokens import END_OF_TEXT, as_text
from lagdsl.language.syntax.vocabulary import vocabulary

STATEMENTS = ("_item", "_element", "_section_item", "when_equation")  # where the parser may begin anew after an error

_ENDS = ("SEMICOLON", "THEN", "LOOP", "EQUATION_SECTION", "VISIBILITY")  # of statements, and of what stands before some


class Stack:
    """The stack of `parser`. A height counts its states; the start state is the first and has no value."""

    def __init__(self, parser: Any, builder: Builder) -> None:
        self.parser = parser  # Lark's InteractiveParser, which has no types
        self._conf: Any = parser.parser_state.parse_conf
        self._builder = builder
        self.states: list[int] = parser.parser_state.state_stack
        self.values: list[Any] = parser.parser_state.value_stack  # tokens and parts; one less than states

    # ---- what may follow ---------------------------------------------------------------------------------------------

    def accepts(self, terminal: str) -> bool:
        """True if a token of that terminal would be shifted; nothing changes."""
        if terminal not in self.parser.choices():
            return False
        try:
            self._trial(len(self.states)).feed_token(Token(terminal, ""))
        except UnexpectedToken:
            return False
        return True

    def accepted(self) -> set[str]:
        """All terminals of which a token would be shifted."""
        accepted: set[str] = self.parser.accepts()
        return accepted

    def goes_on(self, height: int, first: Token, word: str, until: int) -> bool:
        """True if the text is read on beyond the token at `until` if the stack is cut and `first` is `word`."""
        trial = self._trial(height)
        terminal = next((t for t in vocabulary().words[word] if t in trial.choices()), None)
        if terminal is None:
            return False
        position = first.start_pos
        trial.lexer_thread.state.line_ctr.char_pos = first.end_pos
        try:
            trial.feed_token(Token(terminal, word))
            for token in trial.lexer_thread.lex(trial.parser_state):
                if position == until:
                    break
                trial.feed_token(as_text(token))
                position = token.start_pos
        except UnexpectedInput:
            pass
        return position == until

    def begins_anew(self, height: int, position: int) -> bool:
        """True if the text from `position` on is a statement, or the head of a block, if the stack is cut."""
        trial = self._trial(height)
        trial.lexer_thread.state.line_ctr.char_pos = position
        try:
            for token in trial.lexer_thread.lex(trial.parser_state):
                trial.feed_token(as_text(token))
                if token.type in _ENDS:
                    return True
        except UnexpectedInput:
            pass
        return False

    def _trial(self, height: int) -> Any:
        """A copy of the parser with the stack cut at `height`, which makes no nodes."""
        trial = self.parser.copy(deepcopy_values=False)
        del trial.parser_state.state_stack[height:]
        del trial.parser_state.value_stack[height - 1 :]
        return trial

    # ---- the unfinished statement ------------------------------------------------------------------------------------

    def boundary(self) -> int:
        """Height at which the innermost unfinished statement began, 0 if there is none."""
        kinds = boundaries()
        for height in range(len(self.states), 0, -1):
            if self.states[height - 1] in kinds:
                return height
        return 0

    def at_boundary(self) -> bool:
        """True if a statement may begin here."""
        return self.states[-1] in boundaries()

    def kind(self) -> str | None:
        """Kind of the unfinished statement: one of STATEMENTS."""
        height = self.boundary()
        return boundaries()[self.states[height - 1]] if height else None

    def is_complete(self) -> bool:
        """True if the whole text is one tree already."""
        return bool(self.states[-1] == self._conf.end_state)

    def above(self, height: int) -> list[Any]:
        """Tokens and parts above that height."""
        return self.values[height - 1 :]

    # ---- moves -------------------------------------------------------------------------------------------------------

    def feed(self, token: Token) -> bool:
        """Shift `token` after the reductions that it asks for. False if it does not fit; the reductions stay made.

        The same as Lark's `feed_token`, in a third of the time: an operand passes a dozen levels of precedence, of
        which each is a reduction of one symbol that keeps its value. Their end is looked up.
        """
        rows, states, values, terminal = self._conf.states, self.states, self.values, token.type
        while True:
            if len(states) > 1:
                states[-1] = _above_levels(states[-2], states[-1], terminal)
            action = rows[states[-1]].get(terminal)
            if action is None:
                return self.is_complete() and terminal == END_OF_TEXT
            kind, target = action
            if kind is Shift:
                states.append(target)
                values.append(token)
                return True
            self._reduce(target)

    def settle(self) -> None:
        """Make the reductions that any next token would ask for: finish what is complete before an error is judged."""
        while True:
            actions = set(self.parser.choices().values())
            if len(actions) != 1:
                return
            kind, rule = actions.pop()
            if kind is Shift:
                return
            self._reduce(rule)

    def _reduce(self, rule: Rule) -> None:
        height = len(self.states) - len(rule.expansion)
        value = self._builder.callback(rule)(self.values[height - 1 :])
        del self.states[height:]
        del self.values[height - 1 :]
        self.states.append(self._conf.states[self.states[-1]][rule.origin.name][1])
        self.values.append(value)

    def cut(self, height: int) -> None:
        """Forget everything above `height`."""
        del self.states[height:]
        del self.values[height - 1 :]


@cache
def _above_levels(below: int, state: int, terminal: str) -> int:
    """The state in which the parser meets `terminal` after reductions of one symbol that keep its value; `state` was
    reached from `below`."""
    rows = language().table.states
    while True:
        kind, rule = rows[state].get(terminal, (Shift, None))
        if kind is Shift or not keeps_value(rule):
            return state
        state = rows[below][rule.origin.name][1]


@cache
def boundaries() -> dict[int, str]:
    """States of the automaton in which a statement may begin, with the kind of the statement."""
    table = all_states()
    kinds = {state: next((kind for kind in STATEMENTS if kind in row), None) for state, row in table.items()}
    return {state: kind for state, kind in kinds.items() if kind is not None}


@cache
def statement_words() -> frozenset[str]:
    """Words that begin a statement or end a list of statements."""
    table = all_states()
    begins = {terminal for state in boundaries() for terminal in table[state]}
    return frozenset(
        word
        for word, terminals in vocabulary().words.items()
        if word not in ("true", "false", "not", "if") and any(terminal in begins for terminal in terminals)
    )
