"""From the items of a class to symbols and a list of items to elaborate: loops and structural `if` expanded."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeAlias, get_args

from lagdsl.diagnostics import Label
from lagdsl.semantics import arrays, equations
from lagdsl.semantics.conditions import condition_of
from lagdsl.semantics.contents import Contents, Placed
from lagdsl.semantics.context import Context
from lagdsl.semantics.declarations import declared, enter, type_text
from lagdsl.semantics.imports import check_imports, declare_imports
from lagdsl.semantics.modification import modify
from lagdsl.semantics.naming import element_name
from lagdsl.semantics.scope import (
    Binding,
    ClassSymbol,
    FunctionSymbol,
    Instance,
    LabelInstance,
    Scope,
    Symbol,
    SymbolKind,
    TypeSymbol,
    lookup,
)
from lagdsl.semantics.values import Scalar
from lagdsl.source import Span
from lagdsl.syntax import nodes

Labelled: TypeAlias = nodes.Energy | nodes.Load | nodes.Constraint | nodes.RigidBody | nodes.Invariant
_LABEL_KINDS: dict[type, SymbolKind] = {
    nodes.Energy: "energy",
    nodes.Load: "load",
    nodes.Constraint: "constraint",
    nodes.RigidBody: "body",
    nodes.Invariant: "invariant",
}


class Declarer:
    """Collects one class."""

    def __init__(self, ctx: Context, instance: Instance) -> None:
        self.ctx = ctx
        self.instance = instance
        self.scope = instance.scope
        self.contents = Contents()

    def collect(self, node: nodes.Class, modifiers: list[tuple[nodes.Modifier, Scope]]) -> Contents:
        """All of the class: names first, then modifiers from outside, then loops and conditions in order."""
        listed = [(node.items, "items"), *((section.items, section.keyword) for section in node.sections)]
        for items, _ in listed:
            declare_imports(self.ctx.sink, self.scope, items)
        check_imports(self.scope)
        for items, _ in listed:
            for item in items:
                self.declare(item, self.scope)
        modify(self.ctx, self.scope, modifiers)
        for section in node.sections:
            if section.keyword in ("kinematics", "closure"):
                hint = "joints come with components"
                span = Span(section.span.file, section.span.start, section.span.start + len(section.keyword))
                self.ctx.sink.report("E0311", span, what=f"a `{section.keyword}` section", hint=hint)
        for items, keyword in listed:
            if keyword not in ("kinematics", "closure"):
                self._expand(items, self.scope, keyword)
        return self.contents

    # ---- names -------------------------------------------------------------------------------------------------------

    def declare(self, item: nodes.Item, scope: Scope) -> None:
        """Enter the names that an item declares outside of loops."""
        match item:
            case nodes.Function():
                function = FunctionSymbol(item, scope)
                if enter(self.ctx, scope, item.name, function, item.span):
                    self.contents.functions.append(function)
            case nodes.TypeDefinition():
                enter(self.ctx, scope, item.name, TypeSymbol(item, scope), item.span)
            case nodes.Class():
                enter(self.ctx, scope, item.name, ClassSymbol(item, scope), item.name_span)
            case nodes.ShortClass():
                enter(self.ctx, scope, item.name, ClassSymbol(item, scope), item.span)
            case nodes.Component() | nodes.Coordinate() | nodes.Geometry():
                self.contents.symbols += declared(self.ctx, scope, item)
            case _:
                pass

    # ---- loops and conditions ----------------------------------------------------------------------------------------

    def _expand(self, items: Iterable[nodes.Item], scope: Scope, section: str) -> None:
        for item in items:
            self._item(item, scope, section)

    def _item(self, item: nodes.Item, scope: Scope, section: str) -> None:
        match item:
            case nodes.For():
                self._for(item, scope, section)
            case nodes.If():
                self._if(item, scope, section)
            case nodes.Equation() | nodes.CallEquation() if section == "initial equation":
                self.contents.initial.append(Placed(item, scope, self.instance))
            case nodes.Equation():
                equations.attach(self.ctx, scope, item)
            case nodes.Geometry() | nodes.Component() if scope.kind == "local":
                self._elements(item, scope)
            case nodes.Coordinate() if scope.kind == "local":
                span = item.declarators[0].name_span
                self.ctx.sink.report("E0340", span, name=item.declarators[0].name)
            case nodes.Annotation():
                self.contents.annotations.append(item)
            case nodes.Energy() | nodes.Load() | nodes.Constraint() | nodes.RigidBody() | nodes.Invariant():
                self._labelled(item, scope)
            case nodes.Gravity() | nodes.PointMass() | nodes.Draw() | nodes.CallEquation():
                self.contents.items.append(Placed(item, scope, self.instance))
            case nodes.Extends() | nodes.Contact() | nodes.Connect() | nodes.When():
                what, hint = _LATER[type(item)]
                self.ctx.sink.report("E0311", _head(item), what=what, hint=hint)
            case nodes.Class() | nodes.Import() if scope is self.scope:
                pass
            case _:
                assert isinstance(item, get_args(_DECLARED)), item

    def _for(self, item: nodes.For, scope: Scope, section: str) -> None:
        for iterator in item.iterators:
            if iterator.name in ("time", "world"):
                self.ctx.sink.report("E0207", iterator.span, name=iterator.name)
                return
        for turn in arrays.turns(self.ctx, scope, item.iterators) or ():
            self._expand(item.body, turn, section)

    def _if(self, item: nodes.If, scope: Scope, section: str) -> None:
        """Only the branch taken is read."""
        for branch in item.branches:
            condition = condition_of(self.ctx, scope, branch.condition)
            if isinstance(condition, Scalar):
                self.ctx.sink.report("E0330", branch.condition.span, what="an `if` around items")
                return
            if condition is None:
                return
            if condition:
                self._branch(branch.body, scope, section)
                return
        if item.otherwise is not None:
            self._branch(item.otherwise, scope, section)

    def _branch(self, items: tuple[nodes.Item, ...], scope: Scope, section: str) -> None:
        if scope.kind == "class":
            for item in items:
                self.declare(item, scope)
        self._expand(items, scope, section)

    def _elements(self, item: nodes.Geometry | nodes.Component, scope: Scope) -> None:
        """`point P[i] = ...;` in a loop: one element of an array declared outside."""
        for declarator in item.declarators:
            entry = lookup(scope, declarator.name)
            if not isinstance(entry, Symbol) or not declarator.subscripts or declarator.value is None:
                self.ctx.sink.report("E0340", declarator.name_span, name=declarator.name)
                continue
            word = (
                item.keyword
                if isinstance(item, nodes.Geometry)
                else " ".join((*item.prefixes, type_text(item.type_name)))
            )
            if entry.title != word and entry.kind != "unknown":
                label = Label(entry.span, f"declared as {entry.title}")
                self.ctx.sink.report(
                    "E0204", declarator.name_span, label, name=declarator.name, first=entry.title, second=word
                )
                continue
            self.bind_element(entry, declarator.subscripts, Binding(declarator.value, scope, declarator.name_span))

    def bind_element(self, symbol: Symbol, subscripts: tuple[nodes.Subscript, ...], binding: Binding) -> None:
        indices = equations.element_indices(self.ctx, binding.scope, symbol, subscripts, binding.span)
        if indices is not None:
            equations.bind(self.ctx, symbol, indices, binding)

    def _labelled(self, item: Labelled, scope: Scope) -> None:
        """A label is a name of the class; inside loops it is an array over their indices."""
        if item.label is None:
            self.contents.items.append(Placed(item, scope, self.instance))
            return
        kind = _LABEL_KINDS[type(item)]
        owner = scope.owner
        entry = owner.entries.get(item.label)
        if isinstance(item, nodes.Invariant) and isinstance(entry, Symbol) and entry.kind == "output":
            self.contents.items.append(Placed(item, scope, self.instance))
            return
        symbol = entry if isinstance(entry, Symbol) and entry.kind == kind else None
        if symbol is None or scope.path in symbol.labels or not scope.path:
            title = f"{_keyword(item)} {item.label}" if kind != "energy" else f"{_keyword(item)} energy"
            symbol = Symbol(owner.qualify(item.label), kind, label_span(item), owner, title)
            if not enter(self.ctx, owner, item.label, symbol, symbol.span):
                return
            self.ctx.names.add(symbol.name)
        name = element_name(symbol.name, scope.path)
        symbol.labels[scope.path] = LabelInstance(item, scope, name)
        self.contents.items.append(Placed(item, scope, self.instance, symbol))


_DECLARED: TypeAlias = (
    nodes.Function
    | nodes.TypeDefinition
    | nodes.Class
    | nodes.ShortClass
    | nodes.Component
    | nodes.Coordinate
    | nodes.Geometry
)
_LATER: dict[type, tuple[str, str]] = {
    nodes.Extends: ("`extends`", "inheritance comes with components; write the mechanism in one class for now"),
    nodes.Contact: ("`contact`", "contacts come with events"),
    nodes.Connect: ("`connect`", "components and `connect` come with a later release"),
    nodes.When: ("`when`", "events come with a later release"),
}


def _head(item: nodes.Item) -> Span:
    """The keyword at the start of an item."""
    first = item.span.text.split("(")[0].split()
    return Span(item.span.file, item.span.start, item.span.start + len(first[0])) if first else item.span


def label_span(item: Labelled) -> Span:
    """The label in the text of the item: the first word after the keyword."""
    assert item.label is not None
    offset = item.span.text.find(item.label, len(_keyword(item)))
    start = item.span.start + max(offset, 0)
    return Span(item.span.file, start, start + len(item.label)) if offset >= 0 else item.span


def _keyword(item: Labelled) -> str:
    match item:
        case nodes.Energy() | nodes.Load():
            return item.keyword
        case nodes.Constraint():
            return "constraint"
        case nodes.RigidBody():
            return "body"
        case nodes.Invariant():
            return "invariant"
