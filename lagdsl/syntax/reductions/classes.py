"""Nodes of classes, types, functions, imports and the whole unit."""

from __future__ import annotations

from typing import Any, NamedTuple

from lagdsl.diagnostics import Label, Sink
from lagdsl.source import Span
from lagdsl.syntax import nodes
from lagdsl.syntax.reductions.action import Action
from lagdsl.syntax.reductions.declarations import doc, split_prefixes
from lagdsl.syntax.reductions.expressions import token_span


class _Within(NamedTuple):
    name: nodes.Name | None


class _Tail(NamedTuple):
    """Tail of an import, after its name."""

    wildcard: bool
    names: tuple[str, ...]


class _TypeRight(NamedTuple):
    """The right side of a type definition."""

    base: nodes.Name | None
    subscripts: tuple[nodes.Subscript, ...]
    modifiers: tuple[nodes.AnyModifier, ...]
    literals: tuple[str, ...]


def class_actions(sink: Sink) -> dict[str, Action]:
    """Actions of classes; a name after `end` that is not that of the class goes to `sink`."""

    def class_def(c: list[Any], span: Span) -> nodes.Class:
        prefixes, (kind, name, text, body, end_name) = split_prefixes(c)
        if end_name is not None and end_name.value != name.value:
            begins = Label(token_span(name, span), "begins here")
            words = {"kind": kind.value, "name": name.value, "end_name": end_name.value}
            sink.report("E0114", token_span(end_name, span), begins, **words)
        return nodes.Class(
            span=span,
            prefixes=prefixes,
            kind=kind.value,
            name=name.value,
            name_span=token_span(name, span),
            doc=doc(text),
            items=tuple(item for item in body if not isinstance(item, nodes.Section)),
            sections=tuple(item for item in body if isinstance(item, nodes.Section)),
            end_name=None if end_name is None else end_name.value,
        )

    return {**_PLAIN, "class_def": class_def}


def _short_class(c: list[Any], span: Span) -> nodes.ShortClass:
    prefixes, (kind, name, base, subscripts, modifiers, text) = split_prefixes(c)
    return nodes.ShortClass(
        span=span,
        prefixes=prefixes,
        kind=kind.value,
        name=name.value,
        base=base,
        subscripts=subscripts or (),
        modifiers=modifiers or (),
        doc=doc(text),
    )


def _type(c: list[Any], span: Span) -> nodes.TypeDefinition:
    name, right, text = c
    return nodes.TypeDefinition(
        span=span,
        name=name.value,
        base=right.base,
        subscripts=right.subscripts,
        modifiers=right.modifiers,
        literals=right.literals,
        doc=doc(text),
    )


def _function(c: list[Any], span: Span) -> nodes.Function:
    name, *parameters, result, subscripts, value, text = c
    return nodes.Function(
        span=span,
        name=name.value,
        parameters=tuple(parameter for parameter in parameters if parameter is not None),
        result=result,
        result_subscripts=subscripts or (),
        value=value,
        doc=doc(text),
    )


def _parameter(c: list[Any], span: Span) -> nodes.FunctionParameter:
    type_name, name, subscripts, default = c
    return nodes.FunctionParameter(
        span=span, type_name=type_name, name=name.value, subscripts=subscripts or (), default=default
    )


def _import_name(c: list[Any], span: Span) -> nodes.Import:
    name, tail = c
    return nodes.Import(
        span=span, name=name, wildcard=tail is not None and tail.wildcard, names=() if tail is None else tail.names
    )


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


_PLAIN: dict[str, Action] = {
    "start": _unit,
    "within": lambda c, span: _Within(c[0]),
    "import_clause": _import,
    "import_alias": lambda c, span: nodes.Import(span=span, name=c[1], alias=c[0].value),
    "import_name": _import_name,
    "import_all": lambda c, span: _Tail(True, ()),
    "import_list": lambda c, span: _Tail(False, tuple(token.value for token in c)),
    "short_class": _short_class,
    "class_body": lambda c, span: tuple(c),
    "visibility": lambda c, span: nodes.Section(span=span, keyword=c[0].value, items=tuple(c[1:])),
    "equation_section": lambda c, span: nodes.Section(span=span, keyword=c[0].value, items=tuple(c[1:])),
    "initial_section": lambda c, span: nodes.Section(span=span, keyword="initial equation", items=tuple(c)),
    "type_def": _type,
    "type_rhs": lambda c, span: _TypeRight(c[0], c[1] or (), c[2] or (), ()),
    "enumeration": lambda c, span: _TypeRight(None, (), (), tuple(token.value for token in c)),
    "function_def": _function,
    "param": _parameter,
}
