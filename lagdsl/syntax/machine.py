"""The parser's stack: shifts tokens, reduces by rules, and lets the builder make nodes of what is reduced."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from lagdsl.source import SourceFile, Span
from lagdsl.syntax import limits, tables
from lagdsl.syntax.automaton import END_OF_TEXT, Rule, row, rule
from lagdsl.syntax.lexer import Token

Action = Callable[[list[Any], Span], object]
"""Makes a node of the kept children of a rule and their span."""


class TooDeep(Exception):  # noqa: N818 not an error of the program
    """The tree or the stack has reached its limit at `span`."""

    def __init__(self, span: Span) -> None:
        super().__init__(span)
        self.span = span


class Machine:
    """Stacks of states, values, their places and depths; entry 0 is the start state and holds no value."""

    def __init__(self, file: SourceFile, start: str, actions: dict[str, Action]) -> None:
        self.file = file
        self.stop = tables.STOP[start]
        self.actions = actions
        self.states = [tables.START[start]]
        self.values: list[object] = [None]
        self.starts = [0]
        self.ends = [0]
        self.depths = [0]
        self.finished = False

    @property
    def accepted(self) -> dict[int, int]:
        """Symbols the present state has an action for."""
        return row(self.states[-1])

    def feed(self, token: Token) -> bool:
        """Shift `token` after the reductions it asks for; False if it does not fit here."""
        while True:
            if token.terminal == END_OF_TEXT and self.states[-1] == self.stop:
                self.finished = True
                return True
            action = row(self.states[-1]).get(token.terminal)
            if action is None:
                return False
            if action >= 0:
                if len(self.states) > limits.MAX_STACK:
                    raise TooDeep(Span(self.file, token.start, token.end))
                self._push(action, token, token.start, token.end, 0)
                return True
            reduced = rule(~action)
            if reduced.renames:
                self.states[-1] = row(self.states[-2])[reduced.result]
            else:
                self._reduce(reduced)

    def settle(self) -> None:
        """Make the reductions that any next token would ask for: finish what is complete before an error is judged."""
        while len(self.states) > 1:
            actions = set(row(self.states[-1]).values())
            if len(actions) != 1 or (action := actions.pop()) >= 0:
                return
            self._reduce(rule(~action))

    def accepts(self, terminal: int) -> bool:
        """Whether a token of that terminal would be shifted; nothing changes."""
        tail: list[int] = []  # states above the first `height` ones of the stack
        height = len(self.states)
        while True:
            state = tail[-1] if tail else self.states[height - 1]
            action = row(state).get(terminal)
            if action is None:
                return False
            if action >= 0:
                return True
            reduced = rule(~action)
            kept = max(len(tail) - reduced.length, 0)
            height -= reduced.length - (len(tail) - kept)
            del tail[kept:]
            state = tail[-1] if tail else self.states[height - 1]
            tail.append(row(state)[reduced.result])

    def fitting(self, height: int, tokens: list[Token]) -> int:
        """How many of `tokens` would be shifted one after the other on the stack cut at `height`; nothing changes."""
        states = self.states[:height]
        for count, token in enumerate(tokens):
            options = (*tables.WORDS.get(token.text, ()), token.terminal)
            while (action := next((row(states[-1])[t] for t in options if t in row(states[-1])), None)) is not None:
                if action >= 0:
                    states.append(action)
                    break
                reduced = rule(~action)
                del states[len(states) - reduced.length :]
                states.append(row(states[-1])[reduced.result])
            else:
                return count
        return len(tokens)

    def boundary(self) -> int:
        """Height of the stack at which the innermost unfinished statement began, 0 if there is none."""
        for height in range(len(self.states), 0, -1):
            if self.states[height - 1] in tables.BOUNDARY:
                return height
        return 0

    def kind(self, height: int) -> str:
        """What may begin at a boundary: `_item`, `_element`, `_section_item` or `when_equation`."""
        return tables.BOUNDARY[self.states[height - 1]]

    def cut(self, height: int) -> None:
        """Forget everything above `height`."""
        for stack in (self.states, self.values, self.starts, self.ends, self.depths):
            del stack[height:]

    def _push(self, state: int, value: object, start: int, end: int, depth: int) -> None:
        self.states.append(state)
        self.values.append(value)
        self.starts.append(start)
        self.ends.append(end)
        self.depths.append(depth)

    def _reduce(self, reduced: Rule) -> None:
        height = len(self.states) - reduced.length
        values = self.values[height:]
        start, end = (self.starts[height], self.ends[-1]) if values else (self.ends[-1], self.ends[-1])
        depth = max(self.depths[height:], default=0)
        if reduced.may_pass and len(reduced.children) == 1:
            value = values[reduced.children[0][0]] if reduced.children[0] is not None else None
        else:
            children = _children(reduced, values)
            if reduced.is_list:
                value = children
            else:
                depth += 1
                span = Span(self.file, start, end)
                if depth > limits.MAX_DEPTH:
                    raise TooDeep(Span(self.file, self.starts[-1], end))
                value = self.actions[reduced.name](children, span)
        self.cut(height)
        self._push(row(self.states[-1])[reduced.result], value, start, end, depth)


def _children(reduced: Rule, values: list[object]) -> list[object]:
    """The kept values. A list that comes first is taken over, so that long lists grow in linear time."""
    kept: list[object] = []
    for position, child in enumerate(reduced.children):
        if child is None:
            kept.append(None)
            continue
        value = values[child[0]]
        if not child[1]:
            kept.append(value)
        elif position == 0:
            assert isinstance(value, list)
            kept = value
        else:
            assert isinstance(value, list)
            kept += value
    return kept
