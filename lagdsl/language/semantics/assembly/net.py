"""The frames of a model as a net: ports, which of them are one, and what leads from one to the other."""

from __future__ import annotations

from dataclasses import field

from lagdsl.foundation.numerics.disjoint_sets import DisjointSets
from lagdsl.foundation.record import mutable_record
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.assembly.dependencies import Dependencies
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Binding, Indices, Instance, Symbol

WORLD = 0


@mutable_record()
class Port:
    """A frame: the world (no symbol, no binding), a declared one, or one written in a `connect` (a binding only)."""

    number: int
    symbol: Symbol | None = None
    indices: Indices = ()
    binding: Binding | None = None

    @property
    def name(self) -> str:
        if self.symbol is not None:
            return element_name(self.symbol.name, self.indices)
        return self.binding.node.span.text if self.binding is not None else "world"


@mutable_record()
class Link:
    """`child = f(base, coordinates)`, from the kinematics of a component. `needs`: other ports that f mentions.

    `own` are the coordinates of the component that f depends on, `foreign` tells of others.
    """

    number: int
    base: int
    child: int
    binding: Binding
    instance: Instance
    needs: tuple[int, ...]
    own: tuple[Symbol, ...]
    foreign: bool


@mutable_record()
class Loose:
    """A port with a place of its own: known when `needs` are."""

    port: int
    needs: tuple[int, ...]


@mutable_record()
class Net:
    """Ports by number (0 is the world), joined into sets by `connect`.

    `spans` tell which `connect` joined a port first; `shared` coordinates place frames elsewhere than in their joint.
    """

    ctx: Context
    dependencies: Dependencies
    ports: list[Port] = field(default_factory=lambda: [Port(WORLD)])
    links: list[Link] = field(default_factory=list)
    placed: list[Loose] = field(default_factory=list)
    joints_of: dict[Instance, list[Link]] = field(default_factory=dict)
    spans: dict[int, Span] = field(default_factory=dict)
    shared: set[Symbol] = field(default_factory=set)
    _numbers: dict[tuple[Symbol, Indices], int] = field(default_factory=dict)
    _sets: DisjointSets[int] = field(default_factory=lambda: DisjointSets([WORLD]))

    def port(self, symbol: Symbol, indices: Indices) -> int:
        """The number of a declared frame; one with a binding is placed by it."""
        known = self._numbers.get((symbol, indices))
        if known is not None:
            return known
        symbol.made.used = True
        number = self._new(Port(len(self.ports), symbol, indices))
        self._numbers[symbol, indices] = number
        binding = symbol.given.bindings.get(indices)
        if binding is not None:
            self._place(number, binding)
        return number

    def written(self, binding: Binding) -> int:
        """A port for a frame written in a `connect`."""
        number = self._new(Port(len(self.ports), binding=binding))
        self._place(number, binding)
        return number

    def find(self, symbol: Symbol, indices: Indices) -> int | None:
        return self._numbers.get((symbol, indices))

    def root(self, port: int) -> int:
        """The representative of the set that the port belongs to: its earliest."""
        return self._sets.first(port)

    def join(self, first: int, second: int, span: Span) -> bool:
        """Make two ports one; False if they were."""
        for port in (first, second):
            self.spans.setdefault(port, span)
        return self._sets.join(first, second)

    def needed(self, binding: Binding, but: tuple[int, ...] = ()) -> tuple[int, ...]:
        """The ports that the text of a binding mentions, `but` left out."""
        frames, _ = self.dependencies.of_binding(binding)
        return tuple(number for key in frames if (number := self.port(*key)) not in but)

    def link(self, base: int, child: int, binding: Binding, instance: Instance) -> None:
        """Add what leads from one port to the other."""
        needs = self.needed(binding, (base, child))
        _, found = self.dependencies.of_binding(binding)
        own = tuple(symbol for symbol in found if symbol.scope.prefix == instance.scope.prefix)
        self.shared.update(symbol for symbol in found if symbol not in own)
        link = Link(len(self.links), base, child, binding, instance, needs, own, len(own) < len(found))
        self.links.append(link)
        self.joints_of.setdefault(instance, []).append(link)

    def _new(self, port: Port) -> int:
        self.ports.append(port)
        self._sets.enter(port.number)
        return port.number

    def _place(self, number: int, binding: Binding) -> None:
        self.shared.update(self.dependencies.of_binding(binding)[1])
        self.placed.append(Loose(number, self.needed(binding)))
