"""Result of the assembly, as queries for the rest of the floor."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.language.flat.model import Alias, Coordinate, Joint, Output
from lagdsl.language.semantics.assembly.chains import ports_of
from lagdsl.language.semantics.assembly.closures import Closures
from lagdsl.language.semantics.assembly.islands import report
from lagdsl.language.semantics.assembly.merges import Merges
from lagdsl.language.semantics.assembly.net import Link, Net
from lagdsl.language.semantics.assembly.networks import Networks
from lagdsl.language.semantics.assembly.routes import Routes
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Indices, Instance, Symbol
from lagdsl.language.semantics.scope.values import POISON, Poison, Reaction, Value
from lagdsl.language.semantics.variables.resolver import every


@record()
class Parts:
    """The findings of one assembly; it is `whole` if every text of it was understood."""

    net: Net
    routes: Routes
    closures: Closures
    merges: Merges
    networks: Networks
    whole: bool


class Assembly:
    """Answers for frames without a binding, coordinates of joints, and reactions."""

    def __init__(self, ctx: Context, parts: Parts, instances: Sequence[Instance]) -> None:
        self._ctx = ctx
        self._net, self._routes, self._closures = parts.net, parts.routes, parts.closures
        self._merges, self._networks = parts.merges, parts.networks
        self._instances = {instance.scope.prefix: instance for instance in instances}
        self._cuts = {cut.link.number: cut for cut in parts.closures.cuts}
        self._whole = parts.whole
        self._reported: set[str] = set()

    def is_open(self, symbol: Symbol, indices: Indices) -> bool:
        """True if this is a port of a component that nothing gives a place, or a quantity of a connector that its node
        determines: no fault as long as nothing needs it."""
        if self._networks.is_member(symbol):
            return True
        if symbol.kind != "frame" or symbol.scope.prefix not in self._instances:
            return False
        number = self._net.find(symbol, indices)
        bound = indices in symbol.given.bindings or indices in symbol.made.cells
        return not bound and (number is None or not self._routes.reached(number))

    def frame(self, symbol: Symbol, indices: Indices) -> Value | None:
        """The place of a frame without a binding; None for one of the model itself that nothing gives a place."""
        number = self._net.find(symbol, indices)
        if number is not None and self._routes.reached(number):
            return self._routes.make(number)
        instance = self._instances.get(symbol.scope.prefix)
        if instance is None:
            return None
        if self._whole and instance.name not in self._reported:
            self._reported.add(instance.name)
            report(self._ctx, [instance])
        return POISON

    def quantity(self, symbol: Symbol, indices: Indices) -> Value | None:
        """A quantity of a connector without a binding; None if nothing determines it."""
        return self._networks.value(symbol, indices)

    def coordinates(self, found: Sequence[Coordinate]) -> tuple[Coordinate, ...]:
        """Coordinates of the model, merged ones once."""
        return tuple(self._merges.listed(found))

    def aliases(self, found: Sequence[Coordinate]) -> tuple[Alias, ...]:
        """Other names of merged coordinates."""
        return tuple(self._merges.aliases(found))

    def is_computed(self, symbol: Symbol) -> bool:
        """True if the coordinate follows from others: its joint closes a loop."""
        return self._closures.is_computed(symbol)

    def outputs(self) -> list[Output]:
        """Computed coordinates of cut joints."""
        return [output for cut in self._closures.cuts for output in cut.outputs]

    def close(self) -> None:
        """Add the constraints that close loops, and those of the nodes of networks."""
        self._closures.finish()
        if self._whole:
            self._networks.finish()

    def joints(self) -> tuple[Joint, ...]:
        """The links with coordinates, in the order of the text."""
        links = [link for link in self._net.links if link.own and self._known(link)]
        # those of a beam have the coordinates of all nodes: names are made once
        names = {own: self._names(own) for own in {link.own: None for link in links}}
        return tuple(self._joint(link, names[link.own]) for link in links)

    def _known(self, link: Link) -> bool:
        return self._routes.reached(link.base) and self._routes.reached(link.child)

    def _names(self, symbols: Sequence[Symbol]) -> tuple[str, ...]:
        """Of all elements, as in the results."""
        return tuple(
            self._merges.name_of(element_name(symbol.name, indices))
            for symbol in symbols
            for indices in every(self._ctx.resolver.shape(self._ctx, symbol) or ())
        )

    def _joint(self, link: Link, names: tuple[str, ...]) -> Joint:
        return Joint(
            spans=(link.instance.span, *link.instance.scope.spans),
            name=link.instance.name,
            kind=link.instance.definition.node.name,
            frame_a=self._net.ports[link.base].name,
            frame_b=self._net.ports[link.child].name,
            coordinates=names,
            cut=link.number in self._cuts,
        )

    # ---- reactions ---------------------------------------------------------------------------------------------------

    def reaction(self, instance: Instance, span: Span) -> Reaction | Poison:
        """The wrench exerted by the side of frame_a on the side of frame_b, at the origin of frame_b (section 6.2)."""
        links = self._net.joints_of.get(instance, [])
        ports = ports_of(instance)
        if not self._whole:
            return POISON
        if not links and len(ports) == 1:
            return self._of_port(instance, next(iter(ports.values())))
        if len(links) != 1 or not self._known(links[0]):
            names = ", ".join(f"`{instance.name}.{name}`" for name in ports)
            self._ctx.sink.report("E0710", span, Label(instance.span, "declared here"), name=instance.name, ports=names)
            return POISON
        link = links[0]
        base, child = self._routes.value(link.base), self._routes.value(link.child)
        if isinstance(base, Poison) or isinstance(child, Poison):
            return POISON
        cut = self._cuts.get(link.number)
        if cut is not None:
            self._closures.open(cut)
            return Reaction(cut.hidden, opposite=True)
        if self._routes.is_backward(link):
            return Reaction(self._net.ports[link.base].name, opposite=True, about=self._net.ports[link.child].name)
        return Reaction(self._net.ports[link.child].name)

    def _of_port(self, instance: Instance, symbol: Symbol) -> Reaction | Poison:
        value = self._ctx.resolver.element(self._ctx, symbol, (), instance.span)
        return POISON if isinstance(value, Poison) else Reaction(element_name(symbol.name, ()))
