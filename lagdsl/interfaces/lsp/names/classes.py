"""The names of a class as its text and other texts see them, inherited ones included."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field
from typing import assert_never

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import mutable_record
from lagdsl.interfaces.lsp.names.declarations import LABELLED, Declaration, kind_of, name_span
from lagdsl.language.semantics.classes.inheritance import items_of
from lagdsl.language.semantics.scope.imports import declare_imports
from lagdsl.language.semantics.scope.scope import (
    ClassSymbol,
    Entry,
    FunctionSymbol,
    Scope,
    Symbol,
    SymbolKind,
    TypeSymbol,
    lookup_path,
)
from lagdsl.language.syntax import nodes

_DEEPEST = 40  # bases and short classes behind one another


@mutable_record()
class ClassNames:
    """`members` by name, those of bases first; `scope` is that of the text of the class."""

    symbol: ClassSymbol
    scope: Scope
    members: dict[str, Declaration] = field(default_factory=dict)
    bases: list[ClassNames] = field(default_factory=list)


class Classes:
    """The classes that were asked for, by their nodes."""

    def __init__(self) -> None:
        self._known: dict[int, ClassNames] = {}

    def names(self, symbol: ClassSymbol) -> ClassNames | None:
        """The names of a class; those of the class behind a short one. None where that is not known."""
        for _ in range(_DEEPEST):
            if isinstance(symbol.node, nodes.Class):
                return self._names(symbol, symbol.node)
            base = lookup_path(symbol.scope, symbol.node.base.parts)
            if not isinstance(base, ClassSymbol):
                return None
            symbol = base
        return None

    def _names(self, symbol: ClassSymbol, node: nodes.Class) -> ClassNames:
        known = self._known.get(id(node))
        if known is None:
            scope = symbol.inner or Scope("class", f"`{node.name}`", symbol.scope, text=node.span)
            known = self._known[id(node)] = ClassNames(symbol, scope)
            if symbol.inner is None:
                self._fill(known, node)
            for declaration in _declarations(items_of(node), scope):
                known.members[declaration.name] = declaration
        return known

    def _fill(self, names: ClassNames, node: nodes.Class) -> None:
        """Enters what lookup finds from the text of the class: classes, types, functions, constants, imports."""
        items = [item for item, _ in items_of(node)]
        declare_imports(Sink(), names.scope, items)
        for item in items:
            _enter(names.scope, item)
        for item in items:
            if isinstance(item, nodes.Extends):
                base = lookup_path(names.scope, item.base.parts, item.base.span)
                found = self.names(base) if isinstance(base, ClassSymbol) else None
                if found is not None and found is not names:
                    names.bases.append(found)
                    names.members.update(found.members)
                    for name, entry in found.scope.entries.items():
                        names.scope.entries.setdefault(name, entry)

    def members_of_type(self, declaration: Declaration) -> ClassNames | None:
        """The names behind the dot after a component."""
        node = declaration.node
        if not isinstance(node, nodes.Component | nodes.RedeclareComponent) or declaration.scope is None:
            return None
        entry = lookup_path(declaration.scope, node.type_name.parts)
        return self.names(entry) if isinstance(entry, ClassSymbol) and entry.inner is None else None


def _enter(scope: Scope, item: nodes.Item) -> None:
    match item:
        case nodes.Class() | nodes.ShortClass():
            scope.entries[item.name] = ClassSymbol(item, scope)
        case nodes.TypeDefinition():
            scope.entries[item.name] = TypeSymbol(item, scope)
        case nodes.Function():
            scope.entries[item.name] = FunctionSymbol(item, scope)
        case nodes.Component(prefixes=prefixes) if not {"constant", "structural"}.isdisjoint(prefixes):
            for each in item.declarators:
                kind: SymbolKind = "constant" if "constant" in prefixes else "structural"
                scope.entries[each.name] = Symbol(each.name, kind, each.name_span, scope, kind, each)
        case nodes.Component() | nodes.Coordinate() | nodes.Geometry() | nodes.Import() | nodes.Extends():
            pass
        case nodes.Physics() | nodes.Relation() | nodes.Block() | nodes.Annotation():
            pass
        case _:
            assert_never(item)


def _declarations(items: Iterable[tuple[nodes.Item, str]], scope: Scope) -> Iterator[Declaration]:
    for item, section in items:
        for declaration in declared_by(item, scope):
            yield declaration if section != "protected" else _protected(declaration)


def _protected(found: Declaration) -> Declaration:
    return Declaration(
        found.name, found.kind, found.span, found.node, found.declarator, found.scope, found.symbol, protected=True
    )


def declared_by(item: nodes.Item, scope: Scope) -> Iterator[Declaration]:  # noqa: C901, PLR0912 one case for each kind
    """The names that an item of a class declares, labels and what stands in loops and branches included."""
    match item:
        case nodes.Component() | nodes.Coordinate() | nodes.Geometry():
            for each in item.declarators:
                yield Declaration(each.name, kind_of(item), each.name_span, item, each, scope)
        case nodes.Class() | nodes.ShortClass() | nodes.TypeDefinition() | nodes.Function():
            yield of_item(item, scope)
        case nodes.Physics():
            if isinstance(item, LABELLED) and item.label is not None:
                yield Declaration(item.label, word_of(item), name_span(item), item, scope=scope)
        case nodes.For():
            for inner in item.body:
                yield from declared_by(inner, scope)
        case nodes.If():
            for branch in item.branches:
                for inner in branch.body:
                    yield from declared_by(inner, scope)
            for inner in item.otherwise or ():
                yield from declared_by(inner, scope)
        case nodes.Import() | nodes.Extends() | nodes.Relation() | nodes.Annotation() | nodes.When():
            pass
        case _:
            assert_never(item)


def word_of(item: nodes.Physics) -> str:
    """`potential`, `force`, `contact` ...: the first word of a statement."""
    return getattr(item, "keyword", None) or {"RigidBody": "body"}.get(type(item).__name__, type(item).__name__.lower())


def of_item(item: nodes.Class | nodes.ShortClass | nodes.TypeDefinition | nodes.Function, scope: Scope) -> Declaration:
    """A class, a type or a function as a declaration."""
    match item:
        case nodes.Class() | nodes.ShortClass():
            return Declaration(item.name, item.kind, name_span(item), item, None, scope, ClassSymbol(item, scope))
        case nodes.TypeDefinition():
            return Declaration(item.name, "type", name_span(item), item, None, scope)
        case nodes.Function():
            return Declaration(item.name, "function", name_span(item), item, None, scope)
        case _:
            assert_never(item)


def of_entry(name: str, entry: Entry | None) -> Declaration | None:
    """The entry that a lookup found, as a declaration; None for values and for what was reported."""
    if isinstance(entry, ClassSymbol):
        found = of_item(entry.node, entry.scope)
        return Declaration(found.name, found.kind, found.span, found.node, None, entry.scope, entry)
    if isinstance(entry, TypeSymbol | FunctionSymbol):
        return of_item(entry.node, entry.scope)
    if isinstance(entry, Symbol) and entry.declarator is not None:
        return Declaration(name, entry.word, entry.span, entry.declarator, entry.declarator, entry.scope)
    return None
