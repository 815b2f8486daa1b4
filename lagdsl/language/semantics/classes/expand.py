"""From the items of a class and of its components to lists of items: loops and structural `if` expanded."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import assert_never

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.classes import alternatives, equations
from lagdsl.language.semantics.classes.declare import Declarer, component_class, symbols_of
from lagdsl.language.semantics.classes.inheritance import Part
from lagdsl.language.semantics.classes.modification import Given
from lagdsl.language.semantics.operators.conditions import condition_of, structural_condition
from lagdsl.language.semantics.operators.nested_loops import unrolled
from lagdsl.language.semantics.scope.contents import Contents, Placed
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import (
    Binding,
    FunctionSymbol,
    Instance,
    LabelInstance,
    Labelled,
    Scope,
    Symbol,
    SymbolKind,
    lookup,
)
from lagdsl.language.semantics.scope.values import Scalar
from lagdsl.language.semantics.types.declarations import enter, type_text
from lagdsl.language.syntax import nodes

_LABEL_KINDS: dict[type, SymbolKind] = {
    nodes.Energy: "energy",
    nodes.Load: "load",
    nodes.Constraint: "constraint",
    nodes.Contact: "contact",
    nodes.Friction: "friction",
    nodes.RigidBody: "body",
    nodes.Invariant: "invariant",
}


def collect(ctx: Context, root: Instance, given: list[Given]) -> Contents:
    """All of a model: the names of all instances first, then items in order."""
    contents = Contents()
    declarer = Declarer(ctx, contents, root, given, ())
    Expander(ctx, contents, declarer).expand(declarer.body.parts)
    contents.symbols += symbols_of(root)
    return contents


class Expander:
    """Collects the items of one instance."""

    def __init__(self, ctx: Context, contents: Contents, declarer: Declarer) -> None:
        self.ctx = ctx
        self.contents = contents
        self.declarer = declarer
        self.instance = declarer.instance
        self.loops: list[nodes.For] = []

    def expand(self, parts: list[Part]) -> None:
        """All items of the instance, then what is left of its modifiers."""
        with self.ctx.current.inside(self.instance.scope):
            for part in parts:
                self._item(part)
            self.declarer.finish()

    def _item(self, part: Part) -> None:  # noqa: C901, PLR0912 one case for each item
        item, scope = part.item, part.scope
        match item:
            case nodes.For():
                self._for(item, part)
            case nodes.If():
                self._if(item, part)
            case nodes.Component() if self.declarer.declares(item) or component_class(item, scope) is not None:
                self._components(item, scope)
            case nodes.Geometry() | nodes.Component() if scope.kind == "local":
                self._elements(item, scope)
            case nodes.Coordinate() if scope.kind == "local":
                for declarator in item.declarators:
                    self._declared_in_loop(item, declarator, scope)
            case nodes.Annotation():
                if self.instance.around is None:
                    self.contents.annotations.append(Placed(item, scope, self.instance))
            case nodes.Equation() | nodes.CallEquation() | nodes.Connect():
                self._equation(item, part)
            case (
                nodes.Energy()
                | nodes.Load()
                | nodes.Constraint()
                | nodes.Contact()
                | nodes.Friction()
                | nodes.RigidBody()
                | nodes.Invariant()
            ):
                self._labelled(item, scope)
            case nodes.Gravity() | nodes.PointMass() | nodes.Measure() | nodes.Draw() | nodes.When():
                self.contents.items.append(Placed(item, scope, self.instance))
            case nodes.Extends():
                self.ctx.sink.report("E0232", _head(item))
            case nodes.Function():
                entry = scope.entries.get(item.name)
                if isinstance(entry, FunctionSymbol) and all(entry.node is not f.node for f in self.contents.functions):
                    self.contents.functions.append(entry)
            case nodes.Component() | nodes.Coordinate() | nodes.Geometry():
                self._conditional(item, part)
            case nodes.Import() | nodes.Definition() | nodes.Declaration():
                pass  # its names are entered
            case _:
                assert_never(item)

    def _equation(self, item: nodes.Equation | nodes.CallEquation | nodes.Connect, part: Part) -> None:
        placed = Placed(item, part.scope, self.instance)
        if isinstance(item, nodes.Connect):
            self.contents.connects.append(placed)
        elif part.section == "initial equation":
            self.contents.initial.append(placed)
        elif isinstance(item, nodes.CallEquation):
            self.contents.items.append(placed)
        elif part.section == "kinematics":
            self.contents.kinematics.append(placed)
        elif part.section == "closure":
            self.contents.closure.append(placed)
        else:
            equations.attach(self.ctx, part.scope, item)

    # ---- loops and conditions ----------------------------------------------------------------------------------------

    def _inside(self, items: Iterable[nodes.Item], scope: Scope, part: Part) -> Iterator[Part]:
        for item in items:
            yield Part(item, scope, part.section, part.protected)

    def _for(self, item: nodes.For, part: Part) -> None:
        for iterator in item.iterators:
            if iterator.name in ("time", "world"):
                self.ctx.sink.report("E0207", iterator.span, name=iterator.name)
                return
        self.loops.append(item)
        for turn in unrolled(self.ctx, part.scope, item):
            for inner in self._inside(item.body, turn, part):
                self._item(inner)
        self.loops.pop()

    def _if(self, item: nodes.If, part: Part) -> None:
        """Only the branch taken is read, unless that is decided while the motion runs."""
        if part.section in alternatives.SECTIONS and alternatives.is_open(part.scope, item):
            for equation in alternatives.merged(self.ctx, part.scope, item):
                self._equation(equation, part)
            return
        taken = item.otherwise or ()
        for branch in item.branches:
            condition = condition_of(self.ctx, part.scope, branch.condition)
            if isinstance(condition, Scalar):
                self.ctx.sink.report("E0330", branch.condition.span, what="an `if` around items")
                return
            if condition is None:
                return
            if condition:
                taken = branch.body
                break
        for body in (*(branch.body for branch in item.branches), item.otherwise or ()):
            if body is not taken:
                self._leave_out(body, part.scope)
        self._branch(taken, part)

    def _leave_out(self, items: tuple[nodes.Item, ...], scope: Scope) -> None:
        """Names of a branch that is not taken: what uses them is told so."""
        for item in items:
            if isinstance(item, Labelled) and item.label is not None:
                self.ctx.reports.absent[scope.owner.qualify(item.label)] = label_span(item)
            elif isinstance(item, nodes.Component | nodes.Coordinate | nodes.Geometry):
                for declarator in item.declarators:
                    self.ctx.reports.absent[scope.owner.qualify(declarator.name)] = declarator.name_span

    def _conditional(self, item: nodes.Component | nodes.Coordinate | nodes.Geometry, part: Part) -> None:
        """`parameter Mass m = 1 kg if c;` is the same declaration in an `if`."""
        for declarator in item.declarators:
            condition = structural_condition(self.ctx, part.scope, declarator.condition, f"`{declarator.name}`")
            if declarator.condition is not None and condition:
                alone = replace(declarator, condition=None)
                self._branch((replace(item, declarators=(alone,)),), part)
            elif condition is False:
                self.ctx.reports.absent[part.scope.qualify(declarator.name)] = declarator.name_span
                self.declarer.changes.take(declarator.name)  # a modifier of what is not there says nothing

    def _branch(self, items: tuple[nodes.Item, ...], part: Part) -> None:
        parts = list(self._inside(items, part.scope, part))
        if part.scope.kind == "class":
            self.declarer.enter_classes(parts)
            self.declarer.declare(parts)
        for inner in parts:
            self._item(inner)

    def _components(self, item: nodes.Component, scope: Scope) -> None:
        """The items of components stand where the components are declared."""
        for declarator in item.declarators:
            if scope.kind == "local":
                self._declared_in_loop(item, declarator, scope)
            for child in self.declarer.children.pop(declarator.name, ()):
                Expander(self.ctx, self.contents, child).expand(child.body.parts)

    def _elements(self, item: nodes.Geometry | nodes.Component, scope: Scope) -> None:
        """`point P[i] = ...;` in a loop: one element of an array declared outside."""
        for declarator in item.declarators:
            entry = lookup(scope, declarator.name)
            if entry is None and declarator.subscripts and self.ctx.reports.incomplete:
                continue
            if not isinstance(entry, Symbol) or not declarator.subscripts or declarator.value is None:
                self._declared_in_loop(item, declarator, scope)
                continue
            if not structural_condition(self.ctx, scope, declarator.condition, f"`{declarator.name}`"):
                continue
            word = _word(item)
            if entry.title != word and entry.kind != "unknown":
                label = Label(entry.span, f"declared as {entry.title}")
                span = declarator.name_span
                self.ctx.sink.report("E0204", span, label, name=declarator.name, first=entry.title, second=word)
                continue
            binding = Binding(declarator.value, scope, declarator.name_span)
            subscripts = declarator.subscripts
            indices = equations.element_indices(self.ctx, scope, entry, subscripts, declarator.name_span)
            if indices is not None:
                equations.bind(self.ctx, entry, indices, binding)

    def _declared_in_loop(
        self, item: nodes.Geometry | nodes.Component | nodes.Coordinate, declarator: nodes.Declarator, scope: Scope
    ) -> None:
        """E0340, with the declaration of an array in its place; the name counts as declared."""
        name, word = declarator.name, _word(item)
        iterators = list({each.name: each for loop in self.loops for each in loop.iterators}.values())
        indices, sizes = ", ".join(each.name for each in iterators), ", ".join(map(_size, iterators))
        array, element = f"{word} {name}[{sizes}]", f"`{name}[{indices}]`"
        prefixes = item.prefixes if isinstance(item, nodes.Component) else ()
        is_component = isinstance(item, nodes.Component) and component_class(item, scope) is not None
        if declarator.value is not None and not isinstance(item, nodes.Coordinate) and set(prefixes) <= {"output"}:
            element = f"`{word} {name}[{indices}] = {declarator.value.span.text};`"
        elif declarator.value is not None and not is_component:
            turns = ", ".join(each.span.text for each in reversed(iterators))
            array += f" = {{{declarator.value.span.text} for {turns}}}"
        way = f"declare an array before the loop, `{array};`, and write {element} in the loop"
        self.ctx.sink.report("E0340", declarator.name_span, name=name, help=way)
        unknown = Symbol(scope.owner.qualify(name), "unknown", declarator.name_span, scope.owner, name)
        scope.owner.entries.setdefault(name, unknown)

    # ---- labels ------------------------------------------------------------------------------------------------------

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
        if symbol is None or scope.path in symbol.made.labels or not scope.path:
            title = f"{_keyword(item)} {item.label}" if kind != "energy" else f"{_keyword(item)} energy"
            symbol = Symbol(owner.qualify(item.label), kind, label_span(item), owner, title)
            if not enter(self.ctx, owner, item.label, symbol, symbol.span):
                return
            self.ctx.product.names.add(symbol.name)
        name = element_name(symbol.name, scope.path)
        symbol.made.labels[scope.path] = LabelInstance(item, scope, name)
        self.contents.items.append(Placed(item, scope, self.instance, symbol))


def _word(item: nodes.Geometry | nodes.Component | nodes.Coordinate) -> str:
    """Kind of the names of the declaration."""
    match item:
        case nodes.Geometry():
            return item.keyword
        case nodes.Coordinate():
            return f"coordinate {type_text(item.type_name)}"
        case nodes.Component():
            return " ".join((*item.prefixes, type_text(item.type_name)))


def _size(iterator: nodes.Iterator) -> str:
    """`3` for `i in 1:3`, else `n`."""
    text = iterator.range.span.text
    return text.removeprefix("1:") if text.startswith("1:") and ":" not in text[2:] else "n"


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
        case nodes.Contact():
            return "contact"
        case nodes.Friction():
            return "friction"
        case nodes.RigidBody():
            return "body"
        case nodes.Invariant():
            return "invariant"
