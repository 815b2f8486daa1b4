"""`connect` of frames: a list is a chain through components with two ports (docs/reference/assembly.md)."""

from __future__ import annotations

from typing import assert_never

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.assembly.net import WORLD, Net
from lagdsl.language.semantics.assembly.paths import Absent, Element, World, base_of, target_of
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Binding, Entry, Instance, InstanceArray, Scope, Symbol
from lagdsl.language.semantics.scope.values import Poison
from lagdsl.language.syntax import nodes


class Chains:
    """Joins ports in a net, one `connect` after the other."""

    def __init__(self, ctx: Context, net: Net) -> None:
        self._ctx, self._net = ctx, net
        self._taken: dict[int, Span] = {}

    def connect(self, scope: Scope, node: nodes.Connect) -> None:
        """One `connect` whose items are frames and components."""
        left: int | None = None
        joined = any(isinstance(target_of(self._ctx, scope, item), Absent) for item in node.items)
        taken: list[tuple[int, Span]] = []
        for position, item in enumerate(node.items):
            place = "first" if position == 0 else "last" if position == len(node.items) - 1 else "middle"
            if isinstance(target_of(self._ctx, scope, item), Absent):
                left = None
                continue
            ports = self._ports(scope, item, place, taken)
            if ports is None:
                return
            entrance, exit_ = ports
            if left is not None:
                joined |= self._net.join(left, entrance, node.span)
            left = exit_
        for port, span in taken:
            self._taken.setdefault(port, span)
        if not joined:
            self._ctx.sink.report("W0709", node.span)

    def _ports(
        self, scope: Scope, item: nodes.Expression, place: str, taken: list[tuple[int, Span]]
    ) -> tuple[int, int] | None:
        """The ports at which the chain enters and leaves an item; None after a diagnostic."""
        target = target_of(self._ctx, scope, item)
        match target:
            case World():
                return WORLD, WORLD
            case Instance():
                return self._through(target, item, place, taken)
            case Element(symbol=symbol, indices=indices) if symbol.kind == "frame" and indices is not None:
                port = self._net.port(symbol, indices)
                if symbol.scope.prefix != scope.prefix:  # the class's own ports are joined from inside here
                    taken.append((port, item.span))
                return port, port
            case None if base_of(self._ctx, scope, item) is not None:
                port = self._net.written(Binding(item, scope, item.span))
                return port, port
            case Element() | InstanceArray() | Absent() | None:
                refuse(self._ctx, scope, item)
                return None
            case _:
                assert_never(target)

    def _through(
        self, instance: Instance, item: nodes.Expression, place: str, taken: list[tuple[int, Span]]
    ) -> tuple[int, int] | None:
        ports = ports_of(instance)
        name = item.span.text
        if not ports:
            label = Label(instance.span, "declared here")
            pins = [f"`{name}.{each}`" for each, entry in instance.scope.entries.items() if _is_connector(entry)]
            hint = f"name the connector: {' or '.join(pins)}" if pins else None
            self._ctx.sink.report("E0719", item.span, label, what=f"`{name}`", why="it has no frames", help=hint)
            return None
        if len(ports) == 1 and place != "middle":
            port = self._net.port(next(iter(ports.values())), ())
            return port, port
        if len(ports) == 1:
            self._ctx.sink.report("E0703", item.span, name=name, port=next(iter(ports)))
            return None
        wanted = {"first": ("frame_b",), "last": ("frame_a",), "middle": ("frame_a", "frame_b")}[place]
        found: list[int] = []
        for port_name in wanted:
            symbol = ports.get(port_name)
            if symbol is None or self._ctx.resolver.shape(self._ctx, symbol):
                listed = ", ".join(f"`{name}.{each}`" for each in ports)
                self._ctx.sink.report("E0704", item.span, name=name, port=port_name, ports=listed)
                return None
            number = self._net.port(symbol, ())
            if number in self._taken:
                label = Label(self._taken[number], "joined here")
                listed = " or ".join(f"`{name}.{each}`" for each in ports)
                self._ctx.sink.report("E0705", item.span, label, name=name, port=port_name, ports=listed)
                return None
            taken.append((number, item.span))
            found.append(number)
        return found[0], found[-1]


def ports_of(instance: Instance) -> dict[str, Symbol]:
    """The public frames of a component."""
    return {
        name: entry
        for name, entry in instance.scope.entries.items()
        if isinstance(entry, Symbol) and entry.kind == "frame" and name not in instance.protected
    }


def _is_connector(entry: Entry) -> bool:
    return isinstance(entry, Instance) and entry.kind == "connector"


def refuse(
    ctx: Context, scope: Scope, item: nodes.Expression, wanted: str = "neither a frame nor a component with frames"
) -> None:
    """Reports an item that cannot be connected: the fault in the text itself, or E0719."""
    target = target_of(ctx, scope, item)
    known = isinstance(target, Element) and target.symbol.kind == "frame"
    if known or not isinstance(ctx.elaborate(ctx, scope, item, False), Poison):
        ctx.sink.report("E0719", item.span, what=f"`{item.span.text}`", why=f"this is {wanted}")
