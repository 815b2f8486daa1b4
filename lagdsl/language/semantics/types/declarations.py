"""Names enter scopes: quantities, points and frames become symbols."""

from __future__ import annotations

from typing import assert_never

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.scope import prelude
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import (
    LABELS,
    Binding,
    ClassSymbol,
    Entry,
    FunctionSymbol,
    Instance,
    InstanceArray,
    Scope,
    Symbol,
    SymbolKind,
    TypeSymbol,
    bindings_of,
)
from lagdsl.language.semantics.scope.values import POISON, AnyValue
from lagdsl.language.semantics.types import prefixes
from lagdsl.language.semantics.types.types import resolve_type, with_unit
from lagdsl.language.syntax import nodes


def enter(ctx: Context, scope: Scope, name: str, entry: Entry, span: Span) -> bool:
    """Put a name into a scope; E0204 where it is taken, E0207 where it may not be hidden."""
    if name in ("time", "world"):
        ctx.sink.report("E0207", span, name=name)
        scope.entries.setdefault(name, POISON)
        return False
    other = scope.entries.get(name)
    if other is not None:
        if not _same(other, entry):
            _report_twice(ctx, name, other, entry, span)
        return False
    if span.file is ctx.conventions.home and (name in prelude.CONSTANTS or name in prelude.TYPES):
        what = "constant" if name in prelude.CONSTANTS else "type"
        ctx.sink.report("N0205", span, name=name, what=what)
    scope.entries[name] = entry
    return True


def _same(one: Entry, two: Entry) -> bool:
    """True if two classes that meet by `extends` declare the name in the same words."""
    if isinstance(one, Symbol) and isinstance(two, Symbol):
        return one.scope is not two.scope and one.title == two.title and one.declarator == two.declarator
    defined = FunctionSymbol | TypeSymbol | ClassSymbol
    if isinstance(one, defined) and isinstance(two, defined):
        return one.scope is not two.scope and one.node == two.node
    return False


def _report_twice(ctx: Context, name: str, other: Entry, entry: Entry, span: Span) -> None:
    first, second, place = _title(other), _title(entry), _place(other)
    if place is not None and place.file is span.file and place.start > span.start:
        first, second, place, span = second, first, span, place
    around = f" of {other.scope.title}" if isinstance(other, Symbol) and _inherited(other, entry) else ""
    labels = (Label(place, f"first as {first}{around}"),) if place is not None else ()
    way = "delete one of the two, or rename it" if first == second else None
    ctx.sink.report("E0204", span, *labels, name=name, first=first, second=second, help=way)
    label = isinstance(entry, Symbol) and entry.kind in LABELS
    if isinstance(other, Symbol) and other.kind not in LABELS and not label and first != second:
        other.kind = "unknown"  # which of the two a text means nobody knows


def _inherited(one: Symbol, two: Entry) -> bool:
    return isinstance(two, Symbol) and one.scope.owner is not two.scope.owner


def _title(entry: Entry) -> str:
    match entry:
        case Symbol():
            return entry.title
        case FunctionSymbol():
            return "function"
        case TypeSymbol():
            return "type"
        case ClassSymbol():
            return getattr(entry.node, "kind", "class")
        case Instance():
            return f"component of {entry.scope.title}"
        case InstanceArray():
            return "array of components"
        case AnyValue():
            return "name"
        case _:
            assert_never(entry)


def _place(entry: Entry) -> Span | None:
    match entry:
        case Symbol() | Instance() | InstanceArray():
            return entry.span
        case ClassSymbol(node=nodes.Class() as node):
            return node.name_span
        case FunctionSymbol() | TypeSymbol() | ClassSymbol():
            return entry.node.span
        case AnyValue():
            return None
        case _:
            assert_never(entry)


def declared(ctx: Context, scope: Scope, item: nodes.Component | nodes.Coordinate | nodes.Geometry) -> list[Symbol]:
    """The symbols of one declaration, entered into `scope`; what cannot be is reported and left out."""
    found = [_declarator(ctx, scope, item, declarator) for declarator in item.declarators]
    return [symbol for symbol in found if symbol is not None]


def _declarator(
    ctx: Context,
    scope: Scope,
    item: nodes.Component | nodes.Coordinate | nodes.Geometry,
    declarator: nodes.Declarator,
) -> Symbol | None:
    match item:
        case nodes.Component():
            return _component(ctx, scope, item, declarator)
        case nodes.Coordinate():
            title = f"coordinate {type_text(item.type_name)}"
            return _quantity(ctx, scope, "coordinate", title, item.type_name, declarator)
        case nodes.Geometry():
            return _symbol(ctx, scope, "point" if item.keyword == "point" else "frame", item.keyword, declarator)


def _component(ctx: Context, scope: Scope, item: nodes.Component, declarator: nodes.Declarator) -> Symbol | None:
    kind = prefixes.kind_of_component(ctx, item)
    words = " ".join((*item.prefixes, type_text(item.type_name)))
    if kind is None:
        symbol = _symbol(ctx, scope, "unknown", words, declarator)
    else:
        symbol = _quantity(ctx, scope, kind, words, item.type_name, declarator)
    if symbol is not None:
        symbol.given.final = "final" in item.prefixes
        symbol.prefixes = item.prefixes
    return symbol


def _quantity(
    ctx: Context, scope: Scope, kind: SymbolKind, title: str, type_name: nodes.Name, declarator: nodes.Declarator
) -> Symbol | None:
    symbol = _symbol(ctx, scope, kind, title, declarator)
    if symbol is None:
        return None
    symbol.info = resolve_type(ctx, type_name, scope)
    if symbol.info is not None:
        symbol.info = with_unit(ctx, symbol.info, declarator.modifiers)
    if symbol.info is None or not prefixes.type_fits(ctx, kind, symbol.info, type_name.span):
        symbol.kind = "unknown"
    return symbol


def _symbol(ctx: Context, scope: Scope, kind: SymbolKind, title: str, declarator: nodes.Declarator) -> Symbol | None:
    symbol = Symbol(scope.qualify(declarator.name), kind, declarator.name_span, scope, title, declarator)
    if not enter(ctx, scope, declarator.name, symbol, declarator.name_span):
        return None
    ctx.product.names.add(symbol.name)
    if declarator.value is not None:
        binding = Binding(declarator.value, scope, declarator.name_span)
        symbol.given.bindings |= bindings_of(kind, binding, array=bool(declarator.subscripts))
    return symbol


def type_text(name: nodes.Name) -> str:
    return ".".join(name.parts)
