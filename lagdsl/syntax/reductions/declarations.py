"""Nodes of declarators, modifiers and declarations."""

from __future__ import annotations

from typing import Any, NamedTuple

from lark import Token

from lagdsl.source import Span
from lagdsl.syntax import nodes
from lagdsl.syntax.reductions.action import Action
from lagdsl.syntax.reductions.expressions import token_span, unquote


class _Prefix(NamedTuple):
    text: str


def doc(token: Token | None) -> str | None:
    """Text of an optional description."""
    return None if token is None else unquote(token)


def label(token: Token | None) -> str | None:
    """Text of an optional name."""
    return None if token is None else token.value


def _declarator(c: list[Any], span: Span) -> nodes.Declarator:
    name, subscripts, modifiers, value, condition, text = c
    return nodes.Declarator(
        span=span,
        name=name.value,
        name_span=token_span(name, span),
        subscripts=subscripts or (),
        modifiers=modifiers or (),
        value=value,
        condition=condition,
        doc=doc(text),
    )


def _modifier(c: list[Any], span: Span) -> nodes.Modifier:
    prefixes = [child.value for child in c if isinstance(child, Token)]
    name, subscripts, modifiers, value = c[len(prefixes) :]
    return nodes.Modifier(
        span=span,
        prefixes=tuple(prefixes),
        name=name,
        subscripts=subscripts or (),
        modifiers=modifiers or (),
        value=value,
    )


def _redeclare_component(c: list[Any], span: Span) -> nodes.RedeclareComponent:
    type_name, name, subscripts, modifiers = c
    return nodes.RedeclareComponent(
        span=span, type_name=type_name, name=name.value, subscripts=subscripts or (), modifiers=modifiers or ()
    )


def _redeclare_class(c: list[Any], span: Span) -> nodes.RedeclareClass:
    kind, name, type_name, modifiers = c
    return nodes.RedeclareClass(
        span=span, kind=kind.value, name=name.value, type_name=type_name, modifiers=modifiers or ()
    )


def _component(c: list[Any], span: Span) -> nodes.Component:
    prefixes, (type_name, *declarators) = split_prefixes(c)
    return nodes.Component(span=span, prefixes=prefixes, type_name=type_name, declarators=tuple(declarators))


def split_prefixes(children: list[Any]) -> tuple[tuple[str, ...], list[Any]]:
    """The prefixes that lead a declaration, as texts, and the rest."""
    count = next(i for i, child in enumerate(children) if not isinstance(child, _Prefix))
    return tuple(child.text for child in children[:count]), children[count:]


DECLARATIONS: dict[str, Action] = {
    "prefix": lambda c, span: _Prefix(c[0].value),
    "declarator": _declarator,
    "modification": lambda c, span: tuple(c),
    "modifier": _modifier,
    "redeclare_component": _redeclare_component,
    "redeclare_class": _redeclare_class,
    "component_clause": _component,
    "coordinate_clause": lambda c, span: nodes.Coordinate(span=span, type_name=c[0], declarators=tuple(c[1:])),
    "geometry": lambda c, span: nodes.Geometry(span=span, keyword=c[0].value, declarators=tuple(c[1:])),
    "extends_clause": lambda c, span: nodes.Extends(span=span, base=c[0], modifiers=c[1] or ()),
    "annotation": lambda c, span: nodes.Annotation(span=span, modifiers=c[0]),
}
