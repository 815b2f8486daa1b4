"""Connectors with `flow`: Kirchhoff's law at every node, its multiplier as the potential.

A flow is the rate of a coordinate (the current of a charge), counted into the component. The sum of the flows of a node
is zero: a constraint on rates, whose force on each charge is the multiplier times what the charge adds to the sum. So
the multiplier is the potential of the node: a resistor from p to n obeys R dq/dt = v_p - v_n. See Wells, *Lagrangian
Dynamics*, chapter 15.
"""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.numerics.disjoint_sets import DisjointSets
from lagdsl.foundation.source import Span
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.model import Constraint
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.assembly.merges import Merges
from lagdsl.language.semantics.assembly.net import Net
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Indices, Instance, Symbol
from lagdsl.language.semantics.scope.values import Order, Poison, Scalar, Value, balanced_sum


class Networks:
    """Nodes of connectors; `instances` are all components in order. Without flows a connector carries signals, of which
    each is given by one component."""

    def __init__(self, ctx: Context, net: Net, merges: Merges, instances: Sequence[Instance]) -> None:
        self._ctx, self._net, self._merges = ctx, net, merges
        self._sets: DisjointSets[Instance] = DisjointSets()
        self._connectors = [instance for instance in instances if instance.kind == "connector" and instance.present]
        self._members: dict[str, Instance] = {}
        self._joined: dict[Instance, Span] = {}
        self._node_of: dict[Instance, list[Instance]] = {}
        for instance in self._connectors:
            self._sets.enter(instance)
            self._members[instance.scope.prefix] = instance
            for _, symbol in quantities_of(instance):
                symbol.made.used = True

    def unite(self, one: Instance, two: Instance, span: Span) -> bool | None:
        """Join two connectors, member by member; None after a diagnostic, False if they were one."""
        if _shape(one) != _shape(two):
            labels = [Label(each.span, f"a `{each.definition.node.name}`") for each in (one, two)]
            self._ctx.sink.report("E0714", span, *labels, first=one.name, second=two.name)
            return None
        for instance in (one, two):
            self._joined.setdefault(instance, span)
        joined = self._sets.join(one, two)
        for name, entry in one.scope.entries.items():
            other = two.scope.entries[name]
            if isinstance(entry, Instance) and isinstance(other, Instance):
                self.unite(entry, other, span)
            elif isinstance(entry, Symbol) and isinstance(other, Symbol):
                if entry.kind == "frame":
                    self._net.join(self._net.port(entry, ()), self._net.port(other, ()), span)
                elif entry.kind == "coordinate":
                    self._merges.unite(entry, None, other, None, span)
        return joined

    def settle(self) -> None:
        """All connections are known."""
        self._node_of = {instance: node for node in self._sets.all() for instance in node}

    # ---- nodes -------------------------------------------------------------------------------------------------------

    def finish(self) -> None:
        """Add Kirchhoff's law of every node, in the order of the text."""
        for node in self._sets.all():
            for name, symbol in quantities_of(node[0]):
                if symbol.flow:
                    self._law(node, name)
                elif not any(each.flow for _, each in quantities_of(node[0])):
                    self._check_signal(node, name)

    def _check_signal(self, node: list[Instance], name: str) -> None:
        """E0319 where two of the connected components say what a signal is."""
        givers = [giver for each in node if (giver := self._bound(each, name)) is not None]
        if len(givers) > 1:
            given = [
                Label(b.span, f"`{each.name}` is given here") for each in givers for b in each.given.bindings.values()
            ]
            span = self._joined.get(node[0], node[0].span)
            self._ctx.sink.report("E0319", span, *given[:2], name=givers[0].name)

    def _law(self, node: list[Instance], name: str) -> None:
        flows = [flow for instance in node if (flow := self._bound(instance, name)) is not None]
        terms: list[Scalar] = []
        for flow in flows:
            value = self._ctx.resolver.element(self._ctx, flow, (), flow.span)
            if isinstance(value, Poison) or not isinstance(value, Scalar):
                return
            terms.append(value)
        first = node[0]
        span = self._joined.get(first, first.span)
        if not terms:
            self._unbound(node, name)
            return
        if max(term.order for term in terms) != Order.RATE:
            given = [Label(binding.span, "a flow") for flow in flows[:3] for binding in flow.given.bindings.values()]
            self._ctx.sink.report("E0715", span, *given, name=first.name)
            return
        if len(node) == 1:
            labels = [Label(place, f"`{first.name}`") for place in first.scope.spans[:1]]
            self._ctx.sink.report("W0716", first.span, *labels, name=first.name)
        row = self.row_of(first, name)
        self._ctx.product.constraints.append(
            Constraint(
                spans=(span, *first.scope.spans),
                name=row,
                rows=(row,),
                residuals=(balanced_sum([term.expression for term in terms]),),
                dimension=terms[0].dimension or DIMENSIONLESS,
                level="velocity",
                node=True,
            )
        )

    def row_of(self, first: Instance, name: str) -> str:
        """The name of the law of a node."""
        flows = [each for each, symbol in quantities_of(first) if symbol.flow]
        return f"node({first.name})" if len(flows) == 1 else f"node({first.name}.{name})"

    def _bound(self, instance: Instance, name: str) -> Symbol | None:
        symbol = instance.scope.entries.get(name)
        return symbol if isinstance(symbol, Symbol) and symbol.given.bindings else None

    def _unbound(self, node: list[Instance], name: str) -> None:
        """A node where no flow is given: nothing can be said of it."""
        symbol = node[0].scope.entries[name]
        assert isinstance(symbol, Symbol)
        self._ctx.sink.report("E0717", node[0].span, Label(symbol.span, "the flow"), name=symbol.name)

    # ---- values ------------------------------------------------------------------------------------------------------

    def is_member(self, symbol: Symbol) -> bool:
        """True if the quantity belongs to a connector and gets its value from the node."""
        return symbol.kind == "algebraic" and not symbol.given.bindings and symbol.scope.prefix in self._members

    def value(self, symbol: Symbol, indices: Indices) -> Value | None:
        """A potential: the multiplier of the node. A flow without a binding: what flows to the inside."""
        instance = self._members.get(symbol.scope.prefix)
        if instance is None or symbol.info is None or indices:
            return None
        node = self._node_of[instance]
        dimension = symbol.info.dimension or DIMENSIONLESS
        if symbol.flow:
            around = symbol.scope.prefix[: symbol.scope.prefix[:-1].rfind(".") + 1]
            inside = [each for each in node if each.scope.prefix.startswith(around) and each is not instance]
            return self._total(inside, symbol.short)
        flows = [name for name, each in quantities_of(instance) if each.flow]
        if not flows:
            return self._signal(node, symbol)
        if len(flows) != 1:
            return None
        row = self.row_of(node[0], flows[0])
        return Scalar(flat.Multiplier(row), dimension, Variability.CONTINUOUS, Order.SOLUTION)

    def _signal(self, node: list[Instance], symbol: Symbol) -> Value | None:
        """Of a connector without flows: what the one of the node that is given says, be it a number or a truth."""
        givers = (self._bound(each, symbol.short) for each in node)
        giver = next((each for each in givers if each is not None), None)
        return None if giver is None else self._ctx.resolver.element(self._ctx, giver, (), giver.span)

    def _total(self, inside: list[Instance], name: str) -> Value | None:
        flows = [flow for each in inside if (flow := self._bound(each, name)) is not None]
        values = [self._ctx.resolver.element(self._ctx, flow, (), flow.span) for flow in flows]
        scalars = [value for value in values if isinstance(value, Scalar)]
        if not scalars or len(scalars) < len(values):
            return None
        order = max(value.order for value in scalars)
        total = balanced_sum([value.expression for value in scalars])
        return Scalar(total, scalars[0].dimension, Variability.CONTINUOUS, order)


def quantities_of(instance: Instance) -> list[tuple[str, Symbol]]:
    """The algebraic members of a connector."""
    return [
        (name, entry)
        for name, entry in instance.scope.entries.items()
        if isinstance(entry, Symbol) and entry.kind == "algebraic"
    ]


def _shape(instance: Instance) -> list[tuple[str, str, object]]:
    """Fields that two connectors must share."""
    return [
        (name, entry.kind, entry.info.dimension if entry.info is not None else None)
        if isinstance(entry, Symbol)
        else (name, "component", None)
        for name, entry in sorted(instance.scope.entries.items())
        if isinstance(entry, Symbol | Instance)
    ]
