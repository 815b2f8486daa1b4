"""Nodes of declarators, modifiers and declarations."""

from __future__ import annotations

from typing import Any, NamedTuple

from lark import Token

from lagdsl.foundation.source import Span
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.reductions.action import Action, listed, maker, token_span


class _Prefix(NamedTuple):
    text: str


_DECLARATOR = maker(nodes.Declarator, "name", "name_span", "subscripts", "modifiers", "value", "condition", "doc")
_MODIFIER = maker(nodes.Modifier, "prefixes", "name", "subscripts", "modifiers", "value")


def _declarator(c: list[Any], span: Span) -> object:
    return _DECLARATOR([c[0], token_span(c[0], span), *c[1:]], span)


def _modifier(c: list[Any], span: Span) -> object:
    prefixes = tuple(child.value for child in c if isinstance(child, Token))
    return _MODIFIER([prefixes, *c[len(prefixes) :]], span)


def prefixed(action: Action) -> Action:
    """The action, with the prefixes that lead a declaration as one child, a list of texts."""

    def act(children: list[Any], span: Span) -> object:
        prefixes = tuple(child.text for child in children if isinstance(child, _Prefix))
        return action([prefixes, *children[len(prefixes) :]], span)

    return act


DECLARATIONS: dict[str, Action] = {
    "prefix": lambda c, span: _Prefix(c[0].value),
    "declarator": _declarator,
    "modification": listed,
    "modifier": _modifier,
    "redeclare_component": maker(nodes.RedeclareComponent, "type_name", "name", "subscripts", "modifiers"),
    "redeclare_class": maker(nodes.RedeclareClass, "kind", "name", "type_name", "modifiers"),
    "component_clause": prefixed(maker(nodes.Component, "prefixes", "type_name", "*declarators")),
    "coordinate_clause": maker(nodes.Coordinate, "type_name", "*declarators"),
    "geometry": maker(nodes.Geometry, "keyword", "*declarators"),
    "extends_clause": maker(nodes.Extends, "base", "modifiers"),
    "annotation": maker(nodes.Annotation, "modifiers"),
}
