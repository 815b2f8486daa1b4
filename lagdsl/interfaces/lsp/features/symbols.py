"""Symbols of a document and of the workspace."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from lsprotocol import types as lsp

from lagdsl.interfaces.lsp.names.classes import declared_by
from lagdsl.interfaces.lsp.names.declarations import Declaration
from lagdsl.interfaces.lsp.positions import location_of, range_of
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.semantics.classes.inheritance import items_of
from lagdsl.language.syntax import nodes

_KINDS = {
    "package": lsp.SymbolKind.Package,
    "function": lsp.SymbolKind.Function,
    "type": lsp.SymbolKind.TypeParameter,
    "connector": lsp.SymbolKind.Interface,
    "record": lsp.SymbolKind.Struct,
    "constant": lsp.SymbolKind.Constant,
    "parameter": lsp.SymbolKind.Property,
    "structural parameter": lsp.SymbolKind.Property,
    "coordinate": lsp.SymbolKind.Field,
    "state": lsp.SymbolKind.Field,
    "input": lsp.SymbolKind.Event,
    "output": lsp.SymbolKind.Event,
}
_CLASSES = ("model", "block", "joint")


def document_symbols(snapshot: Snapshot) -> list[lsp.DocumentSymbol]:
    """Classes with what they declare."""
    if snapshot.unit is None or snapshot.scope is None:
        return []
    return list(_symbols(snapshot.unit.items, snapshot))


def _symbols(items: Iterable[nodes.Item], snapshot: Snapshot) -> Iterator[lsp.DocumentSymbol]:
    assert snapshot.scope is not None
    for item in items:
        for found in declared_by(item, snapshot.scope):
            own = [each for each, _ in items_of(item)] if isinstance(item, nodes.Class) else []
            whole = found.declarator.span if found.declarator is not None else item.span
            if not (whole.start <= found.span.start and found.span.end <= whole.end):
                whole = found.span
            yield lsp.DocumentSymbol(
                name=found.name,
                kind=symbol_kind(found),
                range=range_of(whole),
                selection_range=range_of(found.span),
                detail=found.kind,
                children=list(_symbols(own, snapshot)) or None,
            )


def symbol_kind(found: Declaration) -> lsp.SymbolKind:
    if found.kind in _CLASSES:
        return lsp.SymbolKind.Class
    return _KINDS.get(found.kind, lsp.SymbolKind.Variable)


def workspace_symbols(snapshots: Iterable[Snapshot], query: str) -> list[lsp.WorkspaceSymbol]:
    """Classes, types and functions, and members of classes, whose names hold the letters of `query` in their order."""
    found = []
    for snapshot in snapshots:
        for each in snapshot.declarations():
            if each.kind not in ("loop variable", "argument") and _matches(each.name, query):
                found.append(lsp.WorkspaceSymbol(location_of(each.span), each.name, symbol_kind(each)))
    return found


def _matches(name: str, query: str) -> bool:
    letters = iter(name.casefold())
    return all(letter in letters for letter in query.casefold())
