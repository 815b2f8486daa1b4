"""Occurrences of names in a text, each with the declaration that it means."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field
from typing import TypeAlias, assert_never

from lagdsl.foundation.record import mutable_record, record
from lagdsl.foundation.source import Span
from lagdsl.interfaces.lsp.names.classes import Classes, ClassNames, declared_by, of_entry, of_item
from lagdsl.interfaces.lsp.names.declarations import LABELLED, Declaration, name_span, parts_of, words_of
from lagdsl.language.semantics.classes.inheritance import items_of
from lagdsl.language.semantics.expressions.calls import is_of_language
from lagdsl.language.semantics.scope.imports import root_of
from lagdsl.language.semantics.scope.naming import name_span as argument_span
from lagdsl.language.semantics.scope.scope import ClassSymbol, Entry, FunctionSymbol, Scope, lookup
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import children

Locals: TypeAlias = "dict[str, Declaration]"


@record()
class Occurrence:
    """A name at its place. `declaration` is None for names of the language and unknown ones; `is_declaration`: it is
    the place itself; `role` tells the former apart: `attribute`, `function`, `type`, `member`, `name`."""

    span: Span
    declaration: Declaration | None
    role: str = "name"
    is_declaration: bool = False


@mutable_record()
class Around:
    """Surroundings of an expression: the class, loop variables and arguments, and the scope of the file."""

    scope: Scope
    names: ClassNames | None = None
    locals: Locals = field(default_factory=dict)

    def with_locals(self, found: Iterable[Declaration]) -> Around:
        return Around(self.scope, self.names, {**self.locals, **{each.name: each for each in found}})


class Finder:
    """Walks over a unit and notes every name."""

    def __init__(self, classes: Classes, scope: Scope) -> None:
        self.classes = classes
        self.scope = scope
        self.found: list[Occurrence] = []

    # ---- items -------------------------------------------------------------------------------------------------------

    def unit(self, unit: nodes.Unit) -> None:
        if unit.within is not None:
            self._dotted(unit.within, Around(self.scope), role="type")
        for item in unit.items:
            self._item(item, Around(self.scope))

    def _item(self, item: nodes.Item, around: Around) -> None:  # noqa: C901, PLR0912 one case for each kind
        match item:
            case nodes.Import():
                self._import(item, around)
            case nodes.Class():
                self._class(item, around)
            case nodes.ShortClass():
                self._note_declared(item, around)
                self._dotted(item.base, around, role="type")
                self._subscripts(item.subscripts, around)
                self._modifiers(item.modifiers, self._class_of(item.base, around), around)
            case nodes.TypeDefinition():
                self._note_declared(item, around)
                if item.base is not None:
                    self._dotted(item.base, around, role="type")
                self._subscripts(item.subscripts, around)
                self._modifiers(item.modifiers, None, around)
            case nodes.Function():
                self._function(item, around)
            case nodes.Component() | nodes.Coordinate():
                self._dotted(item.type_name, around, role="type")
                for declarator in item.declarators:
                    self._declarator(declarator, self._class_of(item.type_name, around), around)
            case nodes.Geometry():
                for declarator in item.declarators:
                    self._declarator(declarator, None, around)
            case nodes.Extends():
                self._dotted(item.base, around, role="type")
                self._modifiers(item.modifiers, self._class_of(item.base, around), around)
            case nodes.Annotation():
                self._modifiers(item.modifiers, None, around)
            case nodes.For():
                inner = self._iterators(item.iterators, around)
                for each in item.body:
                    self._item(each, inner)
            case nodes.If() | nodes.When():
                for branch in item.branches:
                    self._expression(branch.condition, around)
                    for each in branch.body:
                        self._item(each, around)
                for each in (item.otherwise or ()) if isinstance(item, nodes.If) else ():
                    self._item(each, around)
            case nodes.Physics() | nodes.Relation():
                self._statement(item, around)
            case _:
                assert_never(item)

    def _statement(self, item: nodes.Item, around: Around) -> None:
        """Physics and relations: a label, options, expressions."""
        if isinstance(item, LABELLED) and item.label is not None:
            for found in declared_by(item, around.scope):
                self._note(found.span, found, is_declaration=True)
        for child in children(item):
            if isinstance(child, nodes.Named):
                self._note(argument_span(child), None, role="attribute")
                self._expression(child.value, around)
            elif isinstance(child, nodes.Modifier | nodes.RedeclareComponent | nodes.RedeclareClass):
                self._modifiers((child,), None, around)
            else:
                self._expression(child, around)

    def _class(self, item: nodes.Class, around: Around) -> None:
        entry = around.scope.entries.get(item.name)
        known = isinstance(entry, ClassSymbol) and entry.node is item
        symbol = entry if known and isinstance(entry, ClassSymbol) else ClassSymbol(item, around.scope)
        self._note(item.name_span, of_entry(item.name, symbol), is_declaration=True)
        names = self.classes.names(symbol)
        if names is None:
            return
        inside = Around(names.scope, names)
        for each, _ in items_of(item):
            self._item(each, inside)
        ending = words_of(
            Span(item.span.file, max(item.span.end - len(item.name) - 40, item.span.start), item.span.end)
        )
        if item.end_name is not None and ending and ending[-1].text == item.end_name == item.name:
            self._note(ending[-1], of_entry(item.name, symbol))

    def _function(self, item: nodes.Function, around: Around) -> None:
        self._note_declared(item, around)
        arguments = []
        for parameter in item.parameters:
            self._dotted(parameter.type_name, around, role="type")
            found = Declaration(parameter.name, "argument", name_span(parameter), parameter, None, around.scope)
            self._note(found.span, found, is_declaration=True)
            arguments.append(found)
        inner = around.with_locals(arguments)
        for parameter in item.parameters:
            self._subscripts(parameter.subscripts, inner)
            if parameter.default is not None:
                self._expression(parameter.default, inner)
        if item.result is not None:
            self._dotted(item.result, around, role="type")
        self._subscripts(item.result_subscripts, inner)
        self._expression(item.value, inner)

    def _note_declared(self, item: nodes.ShortClass | nodes.TypeDefinition | nodes.Function, around: Around) -> None:
        found = of_item(item, around.scope)
        self._note(found.span, found, is_declaration=True)

    def _declarator(self, declarator: nodes.Declarator, names: ClassNames | None, around: Around) -> None:
        found = self._named(declarator.name, around, declarator.name_span)
        self._note(declarator.name_span, found, is_declaration=True)
        self._subscripts(declarator.subscripts, around)
        self._modifiers(declarator.modifiers, names, around)
        for expression in (declarator.value, declarator.condition):
            if expression is not None:
                self._expression(expression, around)

    def _import(self, item: nodes.Import, around: Around) -> None:
        entry: Entry | None = None
        spans = parts_of(item.name)
        for position, span in enumerate(spans):
            entry = self._part(entry, span, around) if position else root_of(around.scope).find(span.text, span)
            self._note(span, of_entry(span.text, entry), role="type")
        for name in item.names:
            place = next((w for w in words_of(item.span, item.name.span.end) if w.text == name), None)
            inner = entry.inner.find(name, place) if isinstance(entry, ClassSymbol) and entry.inner else None
            if place is not None:
                self._note(place, of_entry(name, inner), role="type")

    # ---- names -------------------------------------------------------------------------------------------------------

    def _note(
        self, span: Span, declaration: Declaration | None, *, role: str = "name", is_declaration: bool = False
    ) -> None:
        self.found.append(Occurrence(span, declaration, role, is_declaration))

    def _part(self, entry: Entry | None, span: Span, around: Around) -> Entry | None:
        if isinstance(entry, ClassSymbol) and entry.inner is not None:
            return entry.inner.find(span.text, span)
        return None

    def _dotted(self, name: nodes.Name, around: Around, *, role: str) -> None:
        entry: Entry | None = None
        for position, span in enumerate(parts_of(name)):
            entry = self._part(entry, span, around) if position else lookup(around.scope, span.text, span)
            self._note(span, of_entry(span.text, entry), role=role)

    def _class_of(self, name: nodes.Name, around: Around) -> ClassNames | None:
        entry = lookup(around.scope, name.parts[0], name.span)
        for part in name.parts[1:]:
            entry = entry.inner.find(part, name.span) if isinstance(entry, ClassSymbol) and entry.inner else None
        return self.classes.names(entry) if isinstance(entry, ClassSymbol) and entry.inner is None else None

    def _named(self, name: str, around: Around, span: Span) -> Declaration | None:
        """The meaning of a plain name: loop variables and arguments, members, then what lies around."""
        found = around.locals.get(name)
        if found is None and around.names is not None:
            found = around.names.members.get(name)
        return found or of_entry(name, lookup(around.scope, name, span))

    def _iterators(self, iterators: tuple[nodes.Iterator, ...], around: Around) -> Around:
        found = []
        for each in iterators:
            self._expression(each.range, around)
            declaration = Declaration(each.name, "loop variable", name_span(each), each, None, around.scope)
            self._note(declaration.span, declaration, is_declaration=True)
            found.append(declaration)
        return around.with_locals(found)

    # ---- modifiers ---------------------------------------------------------------------------------------------------

    def _modifiers(self, modifiers: tuple[nodes.AnyModifier, ...], names: ClassNames | None, around: Around) -> None:
        """Modifiers of something that holds `names`; None: they are attributes."""
        for modifier in modifiers:
            match modifier:
                case nodes.Modifier():
                    inner = names
                    for span in parts_of(modifier.name):
                        found = inner.members.get(span.text) if inner is not None else None
                        self._note(span, found, role="attribute" if found is None else "name")
                        inner = self.classes.members_of_type(found) if found is not None else None
                    self._subscripts(modifier.subscripts, around)
                    self._modifiers(modifier.modifiers, inner, around)
                    if modifier.value is not None:
                        self._expression(modifier.value, around)
                case nodes.RedeclareComponent() | nodes.RedeclareClass():
                    self._dotted(modifier.type_name, around, role="type")
                    found = names.members.get(modifier.name) if names is not None else None
                    if found is not None:
                        self._note(_redeclared_name(modifier), found)
                    self._modifiers(modifier.modifiers, self._class_of(modifier.type_name, around), around)

    # ---- expressions -------------------------------------------------------------------------------------------------

    def _subscripts(self, subscripts: tuple[nodes.Subscript, ...], around: Around) -> None:
        for each in subscripts:
            self._expression(each, around)

    def _expression(self, node: nodes.Node, around: Around) -> None:
        if isinstance(node, nodes.Reference | nodes.Member | nodes.Index):
            self._designated(node, around)
        elif isinstance(node, nodes.Call):
            self._call(node, around)
        elif isinstance(node, nodes.Reduction | nodes.Comprehension):
            if isinstance(node, nodes.Reduction):
                self._function_name(node.function, around)
            self._expression(node.body, self._iterators(node.iterators, around))
        else:
            for child in children(node):
                self._expression(child, around)

    def _designated(self, node: nodes.Node, around: Around) -> Declaration | Entry | None:
        """Notes the names of `a.b[i].c`; what the last of them is."""
        if isinstance(node, nodes.Reference):
            found = self._named(node.name, around, node.span)
            self._note(node.span, found)
            return found.symbol if found is not None and found.symbol is not None else found
        if isinstance(node, nodes.Member):
            return self._member(node, around)
        if isinstance(node, nodes.Index):
            self._subscripts(node.subscripts, around)
            return self._designated(node.target, around)
        self._expression(node, around)
        return None

    def _member(self, node: nodes.Member, around: Around) -> Declaration | Entry | None:
        target = self._designated(node.target, around)
        member: Declaration | None = None
        if isinstance(target, ClassSymbol) and target.inner is not None:
            member = of_entry(node.name, target.inner.find(node.name, node.name_span))
        elif isinstance(target, Declaration):
            names = self.classes.members_of_type(target)
            member = names.members.get(node.name) if names is not None else None
        self._note(node.name_span, member, role="member" if member is None else "name")
        return member.symbol if member is not None and member.symbol is not None else member

    def _function_name(self, node: nodes.Node, around: Around) -> Declaration | None:
        """A quantity may have the name of a function of the language: `sticks = sticks(grip)`."""
        before = len(self.found)
        found = self._designated(node, around)
        declared = isinstance(found.node if isinstance(found, Declaration) else found, nodes.Function | FunctionSymbol)
        if isinstance(node, nodes.Reference) and (found is None or (is_of_language(node.name) and not declared)):
            self.found[before:] = [Occurrence(node.span, None, "function")]
            return None
        return found if isinstance(found, Declaration) else None

    def _call(self, node: nodes.Call, around: Around) -> None:
        found = self._function_name(node.function, around)
        parameters = found.node.parameters if found is not None and isinstance(found.node, nodes.Function) else ()
        for argument in node.arguments:
            if isinstance(argument, nodes.Named):
                own = next((each for each in parameters if each.name == argument.name), None)
                meant = Declaration(own.name, "argument", name_span(own), own) if own is not None else None
                self._note(argument_span(argument), meant, role="attribute" if meant is None else "name")
                self._expression(argument.value, around)
            else:
                self._expression(argument, around)


def _redeclared_name(node: nodes.RedeclareComponent | nodes.RedeclareClass) -> Span:
    """The name in `redeclare Type name` and in `redeclare model Name = Type`."""
    if isinstance(node, nodes.RedeclareComponent):
        return words_of(node.span, node.type_name.span.end)[0]
    return words_of(node.span)[2]


def occurrences(unit: nodes.Unit, scope: Scope, classes: Classes) -> tuple[Occurrence, ...]:
    """All names of a text in its order; `scope` is that of the file."""
    finder = Finder(classes, scope)
    finder.unit(unit)
    return tuple(sorted(finder.found, key=lambda each: (each.span.start, each.span.end)))
