"""Makes nodes while Lark parses: the functions that its parser calls at every reduction."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from operator import itemgetter
from typing import Any, NamedTuple

from lark.grammar import Rule

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.language.syntax import limits
from lagdsl.language.syntax.reductions import Action, actions


class TooDeep(Exception):  # noqa: N818 not an error of the program
    """The tree or the stack has reached its limit at `span`, or too many `brackets` are open."""

    def __init__(self, span: Span, *, brackets: bool = False) -> None:
        super().__init__(span)
        self.span = span
        self.brackets = brackets


class Part:
    """The value of a reduction with its characters and the levels of the tree below it; lies on Lark's stack."""

    __slots__ = ("depth", "end_pos", "start_pos", "value")

    def __init__(self, value: Any, start_pos: int, end_pos: int, depth: int) -> None:
        self.value = value
        self.start_pos = start_pos
        self.end_pos = end_pos
        self.depth = depth


class _Child(NamedTuple):
    """A symbol of a rule that is kept: its position, none for an option that is absent; or a list to be spliced in."""

    position: int | None
    spliced: bool


_Callback = Callable[[list[Any]], Any]


class Builder:
    """The callbacks of the rules for one text, made when first needed.

    `end` is the place behind the last token that was shifted.
    """

    def __init__(self, file: SourceFile, sink: Sink) -> None:
        self.file = file
        self.actions = actions(sink)
        self.end = 0
        self._made: dict[int, _Callback] = {}  # by identity: Lark computes the hash of a rule from its symbols

    def callback(self, rule: Rule) -> _Callback:
        """The function that makes the value of a reduction by `rule`, an object of the automaton, from its symbols."""
        made = self._made.get(id(rule))
        if made is None:
            made = self._made[id(rule)] = self._callback(rule, _children(rule))
        return made

    def _callback(self, rule: Rule, children: tuple[_Child, ...]) -> _Callback:
        name = rule.alias or rule.origin.name
        if keeps_value(rule):
            return itemgetter(0)
        if name.startswith("_"):
            return self._list(children)
        return self._node(self.actions[name], children)

    def _list(self, children: tuple[_Child, ...]) -> _Callback:
        def reduce(found: list[Any]) -> Part:
            start, end = self._place(found)
            return Part(_kept(children, found), start, end, _depth(found))

        return reduce

    def _node(self, action: Action, children: tuple[_Child, ...]) -> _Callback:
        file = self.file

        def reduce(found: list[Any]) -> Part:
            start, end = self._place(found)
            depth = _depth(found) + 1
            if depth > limits.MAX_DEPTH:
                raise TooDeep(Span(file, found[-1].start_pos, end))
            return Part(action(_kept(children, found), Span(file, start, end)), start, end, depth)

        return reduce

    def _place(self, found: list[Any]) -> tuple[int, int]:
        return (found[0].start_pos, found[-1].end_pos) if found else (self.end, self.end)


def _depth(found: list[Any]) -> int:
    depth = 0
    for part in found:
        if part.__class__ is Part and part.depth > depth:
            depth = part.depth
    return depth


def _kept(children: tuple[_Child, ...], found: list[Any]) -> list[Any]:
    """The values that are kept. A list that comes first is taken over, so that long lists grow in linear time."""
    kept: list[Any] = []
    for position, spliced in children:
        if position is None:
            kept.append(None)
            continue
        part = found[position]
        value = part.value if part.__class__ is Part else part
        if not spliced:
            kept.append(value)
        elif position == 0:
            kept = value
        else:
            kept += value
    return kept


@cache
def keeps_value(rule: Rule) -> bool:
    """True for a level of precedence: its one symbol becomes another of the same value."""
    if not rule.options.expand1 or rule.alias or len(_children(rule)) != 1:
        return False
    assert len(rule.expansion) == 1, f"the place of {rule} would be lost"
    return True


@cache
def _children(rule: Rule) -> tuple[_Child, ...]:
    """Symbols of a rule that Lark keeps in the tree: no punctuation, `_rule`s spliced in, absent options as none."""
    return tuple(_kept_symbols(rule))


def _kept_symbols(rule: Rule) -> Iterator[_Child]:
    position = 0
    for is_absent in rule.options.empty_indices or (False,) * len(rule.expansion):
        if is_absent:
            yield _Child(None, False)
            continue
        symbol: Any = rule.expansion[position]
        if not symbol.is_term:
            yield _Child(position, symbol.name.startswith("_"))
        elif not symbol.filter_out:
            yield _Child(position, False)
        position += 1
