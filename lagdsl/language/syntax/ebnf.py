"""The rules of the grammar as they are written, for grammars of other tools."""

from __future__ import annotations

from functools import cache
from typing import Any, TypeAlias, assert_never

from lark import Token, Tree
from lark.load_grammar import load_grammar

from lagdsl.foundation.record import record
from lagdsl.foundation.resources import grammar_file


@record()
class Text:
    """A word or a mark."""

    text: str


@record()
class Symbol:
    """A rule or a terminal, by its name."""

    name: str


@record()
class Sequence:
    parts: tuple[Expansion, ...]


@record()
class Choice:
    options: tuple[Expansion, ...]


@record()
class Repeat:
    """Any number of times, zero included."""

    part: Expansion


@record()
class Aliased:
    """An expansion whose node has a name of its own."""

    name: str
    part: Expansion


Expansion: TypeAlias = Text | Symbol | Sequence | Choice | Repeat | Aliased
EMPTY = Sequence(())


@record()
class Rule:
    """`is_level`: the rule has no node where it has one child only."""

    name: str
    expansion: Expansion
    is_level: bool


@cache
def rules() -> tuple[Rule, ...]:
    """All rules in the order of the grammar."""
    read: Any = load_grammar  # Lark has no types there
    grammar = read(grammar_file().read_text(encoding="utf-8"), "lagdsl.lark", [], False)[0]
    return tuple(Rule(str(name), _expansion(tree), options.expand1) for name, _, tree, options in grammar.rule_defs)


def _expansion(tree: Any) -> Expansion:
    """The form of a tree of Lark's reader of grammars."""
    assert isinstance(tree, Tree)
    children: list[Any] = list(tree.children)
    match str(tree.data):
        case "expansions":
            options = tuple(_expansion(each) for each in children)
            return options[0] if len(options) == 1 else Choice(options)
        case "expansion":
            parts = tuple(_expansion(each) for each in children)
            return parts[0] if len(parts) == 1 else Sequence(parts)
        case "maybe":
            return Choice((_expansion(children[0]), EMPTY))
        case "expr":
            part, operator = _expansion(children[0]), str(children[1])
            forms: dict[str, Expansion] = {
                "?": Choice((part, EMPTY)),
                "*": Repeat(part),
                "+": Sequence((part, Repeat(part))),
            }
            return forms[operator]
        case "alias":
            part = _expansion(children[0])
            return part if children[1] is None else Aliased(str(children[1].name), part)
        case "value":
            return _value(children[0])
        case _:
            raise AssertionError(tree.data)


def _value(child: Any) -> Expansion:
    if isinstance(child, Tree):
        assert child.data == "literal", child
        text = child.children[0]
        assert isinstance(text, Token)
        return Text(text[1:-1])
    return Symbol(str(child.name))


def may_be_empty(expansion: Expansion, empty: frozenset[str]) -> bool:
    """True if no token may stand there; `empty` are the names of rules of which that is true."""
    match expansion:
        case Text():
            return False
        case Symbol():
            return expansion.name in empty
        case Sequence():
            return all(may_be_empty(part, empty) for part in expansion.parts)
        case Choice():
            return any(may_be_empty(option, empty) for option in expansion.options)
        case Repeat():
            return True
        case Aliased():
            return may_be_empty(expansion.part, empty)
        case _:
            assert_never(expansion)


@cache
def empty_rules() -> frozenset[str]:
    """Names of the rules that hold where no token stands."""
    found: frozenset[str] = frozenset()
    while True:
        more = frozenset(rule.name for rule in rules() if may_be_empty(rule.expansion, found))
        if more == found:
            return found
        found = more
