"""Nodes of classes, types, functions, imports and the whole unit."""

from __future__ import annotations

from typing import Any, NamedTuple

from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.source import Span
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.reductions.action import Action, listed, maker, token_span, unquote
from lagdsl.language.syntax.reductions.declarations import prefixed


class _Within(NamedTuple):
    name: nodes.Name | None


_CLASS = maker(nodes.Class, "prefixes", "kind", "name", "name_span", "doc", "items", "sections", "end_name")
_TYPE = maker(nodes.TypeDefinition, "name", "base", "subscripts", "modifiers", "literals", "literal_docs", "doc")


def class_actions(sink: Sink) -> dict[str, Action]:
    """Actions of classes; a name after `end` that is not that of the class goes to `sink`."""

    def class_def(c: list[Any], span: Span) -> object:
        *head, name, text, body, end_name = c
        if end_name is not None and end_name.value != name.value:
            begins = Label(token_span(name, span), "begins here")
            words = {"kind": head[-1].value, "name": name.value, "end_name": end_name.value}
            sink.report("E0114", token_span(end_name, span), begins, **words)
        items = tuple(item for item in body if not isinstance(item, nodes.Section))
        sections = tuple(item for item in body if isinstance(item, nodes.Section))
        return _CLASS([*head, name, token_span(name, span), text, items, sections, end_name], span)

    return {**_PLAIN, "class_def": prefixed(class_def)}


def _import_name(c: list[Any], span: Span) -> nodes.Import:
    """The tail is absent, `*` or a list of names."""
    name, tail = c
    return nodes.Import(span=span, name=name, wildcard=tail == "*", names=tail if isinstance(tail, tuple) else ())


def _import(c: list[Any], span: Span) -> nodes.Import:
    """The clause has the span of the whole statement."""
    clause = c[0]
    return nodes.Import(span=span, name=clause.name, alias=clause.alias, wildcard=clause.wildcard, names=clause.names)


def _unit(c: list[Any], span: Span) -> nodes.Unit:
    within = c[0] if c and isinstance(c[0], _Within) else None
    items = tuple(c if within is None else c[1:])
    return nodes.Unit(
        span=span, within=None if within is None else within.name, has_within=within is not None, items=items
    )


_section = maker(nodes.Section, "keyword", "*items")

_PLAIN: dict[str, Action] = {
    "start": _unit,
    "within": lambda c, span: _Within(c[0]),
    "import_clause": _import,
    "import_alias": maker(nodes.Import, "alias", "name"),
    "import_name": _import_name,
    "import_all": lambda c, span: "*",
    "import_list": lambda c, span: tuple(token.value for token in c),
    "short_class": prefixed(
        maker(nodes.ShortClass, "prefixes", "kind", "name", "base", "subscripts", "modifiers", "doc")
    ),
    "class_body": listed,
    "visibility": _section,
    "equation_section": _section,
    "initial_section": lambda c, span: nodes.Section(span=span, keyword="initial equation", items=tuple(c)),
    "type_def": lambda c, span: _TYPE([c[0], *c[1], c[2]], span),
    "type_rhs": lambda c, span: (*c, None, None),
    "literal": lambda c, span: (c[0].value, None if c[1] is None else unquote(c[1])),
    "enumeration": lambda c, span: (None, None, None, *zip(*c, strict=True)),
    "function_def": maker(nodes.Function, "name", "*parameters", "result", "result_subscripts", "value", "doc"),
    "param": maker(nodes.FunctionParameter, "type_name", "name", "subscripts", "default"),
}
