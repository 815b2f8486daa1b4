"""The names of a class and of all its components: instances nest, modifiers are applied from outside in."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import product as cartesian

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.classes.annotations import annotations_of, without_units
from lagdsl.language.semantics.classes.array_modifiers import Said, Splits
from lagdsl.language.semantics.classes.inheritance import Body, Part, body_of, enter_class, names_in, steps_to
from lagdsl.language.semantics.classes.modification import (
    Changes,
    Given,
    check_duplicates,
    modify,
    report_no_such,
    report_unknown,
    target,
)
from lagdsl.language.semantics.classes.redeclaration import replaced, stands_in
from lagdsl.language.semantics.classes.sized_classes import extents_of, sized
from lagdsl.language.semantics.operators.conditions import condition_of
from lagdsl.language.semantics.scope.contents import Contents
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.limits import another_component, another_turn
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import ClassSymbol, Instance, InstanceArray, Scope, Symbol, lookup_path
from lagdsl.language.semantics.scope.values import POISON, Scalar
from lagdsl.language.semantics.types import prefixes
from lagdsl.language.semantics.types.declarations import declared, enter
from lagdsl.language.syntax import nodes

DECLARATIONS = (nodes.Component, nodes.Coordinate, nodes.Geometry)


class Declarer:
    """One instance of a class: its body, and those of its components by name."""

    def __init__(
        self, ctx: Context, contents: Contents, instance: Instance, given: list[Given], line: tuple[nodes.Class, ...]
    ) -> None:
        """`given` are the modifiers from outside, innermost first; `line` the classes of the instances around."""
        node = instance.definition.node
        assert isinstance(node, nodes.Class)
        self.ctx = ctx
        self.contents = contents
        self.instance = instance
        self.scope = instance.scope
        self.changes = Changes()
        with ctx.current.inside(self.scope):
            self.body: Body = body_of(ctx, node, self.scope, given)
        self.changes.add(self.body.given)
        self._know_classes(self.body.parts)
        self.line = (*line, node)
        self._check_units()
        self.children: dict[str, list[Declarer]] = {}
        self.texts: dict[str, tuple[nodes.Component, nodes.Declarator]] = {}
        self._components: set[int] = set()
        with ctx.current.inside(self.scope):
            self.declare(self.body.parts)

    def _check_units(self) -> None:
        """E0239 for a class without units in a model with them."""
        for node in self.body.line if self.ctx.conventions.units else ():
            if node is not self.body.line[0] or self.instance.around is not None:
                annotations = annotations_of(node)
                if without_units(self.ctx, annotations):
                    span = self.instance.span
                    self.ctx.sink.report("E0239", span, Label(annotations[0].span, "said here"), name=node.name)

    def enter_classes(self, parts: list[Part]) -> None:
        """The classes in a branch of a structural `if`."""
        for part in parts:
            enter_class(self.ctx, part, self.body.given)
        self._know_classes(parts)

    def _know_classes(self, parts: list[Part]) -> None:
        """Classes are redeclared where they are entered."""
        for part in parts:
            if isinstance(part.item, nodes.Class | nodes.ShortClass):
                self.changes.take(part.item.name)

    def declare(self, parts: list[Part]) -> None:
        """Enter the names: quantities first, then components, whose sizes and conditions may need these."""
        components: list[tuple[Part, nodes.Declarator, ClassSymbol]] = []
        members = self.instance.members
        before = len(members)
        order: dict[int, int] = {}
        for part in parts:
            item = part.item
            if not isinstance(item, DECLARATIONS):
                continue
            order.update({id(declarator.name_span): len(order) + k for k, declarator in enumerate(item.declarators)})
            symbol = component_class(item, part.scope)
            if symbol is None:
                self._quantities(part, item)
            else:
                assert isinstance(item, nodes.Component)
                prefixes.check_component(self.ctx, item)
                self._components.add(id(item))
                components += [(part, declarator, symbol) for declarator in item.declarators]
        for part, declarator, symbol in components:
            self._component(part, declarator, symbol)
        members[before:] = sorted(members[before:], key=lambda member: order[id(member.span)])

    def _quantities(self, part: Part, item: nodes.Component | nodes.Coordinate | nodes.Geometry) -> None:
        """The items without a condition; the others are declared where it is known, as in a structural `if`."""
        if any(each.condition is not None for each in item.declarators):
            item = replace(item, declarators=tuple(each for each in item.declarators if each.condition is None))
        for symbol in declared(self.ctx, part.scope, item):
            modify(self.ctx, symbol, self._taken(part, symbol.short, symbol.span))
            self._keep(part, symbol.short, symbol)

    def _taken(self, part: Part, name: str, span: Span) -> list[Given]:
        """The modifiers of a name; E0229 for those from outside where it is protected."""
        given = self.changes.take(name)
        if not part.protected:
            return given
        for modifier, scope in given:
            if scope.owner.instance is not self.instance:
                place = Label(span, "declared here")
                self.ctx.sink.report("E0229", modifier.span, place, name=name, what=part.scope.title)
        return [(modifier, scope) for modifier, scope in given if scope.owner.instance is self.instance]

    def _keep(self, part: Part, name: str, member: Symbol | Instance | InstanceArray) -> None:
        self.instance.members.append(member)
        if part.protected:
            self.instance.protected.add(name)

    # ---- components --------------------------------------------------------------------------------------------------

    def _component(self, part: Part, declarator: nodes.Declarator, symbol: ClassSymbol) -> None:
        ctx, scope, name = self.ctx, part.scope, declarator.name
        if self._is_inherited_twice(part, declarator):
            return
        check_duplicates(ctx, declarator.modifiers)
        given: list[Said] = [((), modifier, scope) for modifier in declarator.modifiers]
        symbol = replaced(ctx, part, declarator, symbol, self._taken(part, name, declarator.name_span), given)
        found = steps_to(ctx, symbol)
        known = found is not None and self._may_stand(declarator, found[0])
        known = known and stands_in(ctx, symbol, declarator, self.body.parts)
        condition = condition_of(ctx, scope, declarator.condition) if known else None
        own = extents_of(ctx, name, declarator.subscripts, scope) if condition is not None else None
        inner = sized(ctx, name, found[1]) if found is not None and own is not None else None
        if found is None or condition is None or own is None or inner is None:
            scope.entries.setdefault(name, POISON)
            return
        definition, shape = found[0], (*own, *inner.shape)
        qualified = scope.qualify(name)
        splits = Splits(ctx, name, shape, given)
        if not shape:
            if not another_component(ctx, declarator.name_span):
                return
            made = self._instance(declarator, scope, qualified, definition, condition)
            if enter(ctx, scope, name, made, declarator.name_span):
                self._keep(part, name, made)
                self._fill(declarator, made, [*inner.at(()), *splits.at(())])
            return
        array = InstanceArray(qualified, declarator.name_span, shape)
        if not enter(ctx, scope, name, array, declarator.name_span):
            return
        self._keep(part, name, array)
        for indices in cartesian(*(range(1, extent + 1) for extent in shape)):
            if not another_turn(ctx, declarator.name_span) or not another_component(ctx, declarator.name_span):
                return
            made = self._instance(declarator, scope, element_name(qualified, indices), definition, condition)
            array.elements[indices] = made
            self._fill(declarator, made, [*inner.at(indices), *splits.at(indices)])

    def _is_inherited_twice(self, part: Part, declarator: nodes.Declarator) -> bool:
        """True if two classes that meet by `extends` declare the component in the same words."""
        item = part.item
        assert isinstance(item, nodes.Component)
        other, text = self.texts.setdefault(declarator.name, (item, declarator))
        words = (other.prefixes, other.type_name, text) == (item.prefixes, item.type_name, declarator)
        return words and text is not declarator and text.name_span != declarator.name_span

    def _may_stand(self, declarator: nodes.Declarator, symbol: ClassSymbol) -> bool:
        """E0225 for a component that contains itself, E0231 for a partial class, E0227 for a value."""
        node = symbol.node
        if any(node is around for around in self.line):
            names = [around.name for around in self.line]
            path = " holds ".join(f"`{name}`" for name in [*names[names.index(node.name) :], node.name])
            self.ctx.sink.report("E0225", declarator.name_span, name=declarator.name, path=path)
            return False
        if "partial" in node.prefixes:
            assert isinstance(node, nodes.Class)
            label = Label(node.name_span, "declared as partial")
            self.ctx.sink.report("E0231", declarator.name_span, label, name=node.name, what="a component")
            return False
        if declarator.value is not None:
            self.ctx.sink.report("E0227", declarator.value.span, name=declarator.name)
        return True

    def _instance(
        self, declarator: nodes.Declarator, scope: Scope, name: str, symbol: ClassSymbol, condition: Scalar | bool
    ) -> Instance:
        made = instance_of(symbol, name, declarator.name_span, scope)
        made.present = condition is not False
        made.conditions = self.instance.conditions
        if isinstance(condition, Scalar) and declarator.condition is not None:
            made.conditions += ((condition, declarator.condition.span),)
        return made

    def _fill(self, declarator: nodes.Declarator, made: Instance, given: list[Given]) -> None:
        self.ctx.product.names.add(made.name)
        if not made.present:
            self._check_absent(made, given)
            return
        self.contents.instances.append(made)
        child = Declarer(self.ctx, self.contents, made, given, self.line)
        self.children.setdefault(declarator.name, []).append(child)

    def _check_absent(self, made: Instance, given: list[Given]) -> None:
        """E0223 for modifiers of a component that is not there: nothing else is read of it."""
        node = made.definition.node
        assert isinstance(node, nodes.Class)
        body = body_of(self.ctx, node, made.scope, given)
        known = list(names_in(part.item for part in body.parts))
        for modifier, _ in given:
            if target(modifier) not in known:
                report_no_such(self.ctx, modifier, target(modifier), node, known)

    def declares(self, item: nodes.Component) -> bool:
        """True if the item declares components; its names may hide that of the class by now."""
        return id(item) in self._components

    def finish(self) -> None:
        """E0223 for the modifiers that nothing took."""
        report_unknown(self.ctx, self.changes, self.instance)


def instance_of(symbol: ClassSymbol, name: str, span: Span, around: Scope | None) -> Instance:
    """An instance of a class without its contents; `around` is the scope it is declared in."""
    node = symbol.node
    prefix, spans = (f"{name}.", (span, *around.spans)) if around is not None else ("", ())
    scope = Scope("class", f"`{node.name}`", symbol.scope, prefix, spans, text=node.span)
    made = Instance(name, span, symbol, scope, around=around)
    scope.instance = made
    return made


def component_class(item: nodes.Item, scope: Scope) -> ClassSymbol | None:
    """The class of a component; None for quantities, points and frames."""
    if not isinstance(item, nodes.Component):
        return None
    entry = lookup_path(scope, item.type_name.parts, item.type_name.span)
    return entry if isinstance(entry, ClassSymbol) and entry.inner is None else None


def symbols_of(instance: Instance) -> Iterator[Symbol]:
    """The quantities of an instance and of its components, depth first in the order of the text."""
    for member in instance.members:
        if isinstance(member, Symbol):
            yield member
        elif isinstance(member, Instance):
            yield from symbols_of(member)
        else:
            for element in member.elements.values():
                yield from symbols_of(element)
