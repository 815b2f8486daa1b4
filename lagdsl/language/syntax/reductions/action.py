"""Functions that make nodes of what the parser has reduced."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from lark import Token

from lagdsl.foundation.source import Span
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.tokens import span_of

Action = Callable[[list[Any], Span], object]
"""Makes a node of the kept children of a rule and their span."""

_ESCAPE = re.compile(r"\\(.)", re.DOTALL)
_ESCAPED = {"n": "\n", "t": "\t", "r": "\r"}


def token_span(token: Token, within: Span) -> Span:
    return span_of(within.file, token)


def unquote(token: Token) -> str:
    """The text between the quotes, escapes resolved as in Modelica."""
    return _ESCAPE.sub(lambda match: _ESCAPED.get(match[1], match[1]), token.value[1:-1])


def maker(kind: type[nodes.Node], *names: str) -> Action:
    """Makes a `kind` of one child for each of the fields `names`; that with a star takes what the others leave.

    A token becomes its text. A field that is a list is empty where its child is absent.
    """
    fields = [name.lstrip("*") for name in names]
    lists = {name for name in fields if kind.__annotations__[name].startswith("tuple")}
    star = next((place for place, name in enumerate(names) if name.startswith("*")), None)

    def make(children: list[Any], span: Span) -> nodes.Node:
        if star is not None:
            after = len(children) - (len(names) - 1 - star)
            rest = tuple(child for child in children[star:after] if child is not None)
            children = [*children[:star], rest, *children[after:]]
        values = {name: _value(child, name in lists) for name, child in zip(fields, children, strict=True)}
        return kind(span=span, **values)

    return make


def _value(child: Any, is_list: bool) -> Any:
    if isinstance(child, Token):
        return unquote(child) if child.type == "STRING" else child.value
    return () if child is None and is_list else child


def listed(children: list[Any], _: Span) -> tuple[Any, ...]:
    """The children of a rule that stands for a list."""
    return tuple(children)
