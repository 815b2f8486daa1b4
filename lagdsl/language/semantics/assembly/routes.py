"""Sources of the places of ports: identified with another frame, forward or backward along kinematics."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import Frame, FrameStep
from lagdsl.language.flat.traversal import postorder, step_expressions
from lagdsl.language.semantics.assembly.closed_form.inverse import inverse, names_frame
from lagdsl.language.semantics.assembly.graph import Step, Tree
from lagdsl.language.semantics.assembly.net import WORLD, Link, Net, Port
from lagdsl.language.semantics.operators.geometry import WORLD as WORLD_FRAME
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.values import POISON, FrameValue, Value, highest, latest


@record()
class Arrival:
    """The port of a set that got its place first, and how."""

    port: int
    step: Step


class Routes:
    """Gives frames without a binding their values, on demand."""

    def __init__(self, ctx: Context, net: Net, tree: Tree) -> None:
        self._ctx, self._net = ctx, net
        self.arrivals: dict[int, Arrival] = {}
        for step in tree.steps:
            self.arrivals[step.node] = Arrival(self._port_of(step), step)

    def _port_of(self, step: Step) -> int:
        if step.edge is not None:
            link = self._net.links[step.edge]
            return link.base if step.backward else link.child
        assert step.given is not None
        return self._net.placed[step.given].port if step.given < len(self._net.placed) else WORLD

    def is_backward(self, link: Link) -> bool:
        """True if the base of the link follows from its child."""
        arrival = self.arrivals.get(self._net.root(link.base))
        return arrival is not None and arrival.step.edge == link.number

    def reached(self, number: int) -> bool:
        return self._net.root(number) in self.arrivals

    def value(self, number: int) -> Value:
        """The frame behind a port that is reached."""
        port = self._net.ports[number]
        if number == WORLD:
            return WORLD_FRAME
        if port.symbol is not None:
            return self._ctx.resolver.element(self._ctx, port.symbol, port.indices, port.symbol.span)
        assert port.binding is not None
        return self._ctx.elaborate(self._ctx, port.binding.scope, port.binding.node, False)

    def make(self, number: int) -> Value:
        """The value of a declared port without a binding that is reached."""
        port = self._net.ports[number]
        assert port.symbol is not None
        arrival = self.arrivals[self._net.root(number)]
        if arrival.port != number:
            return self._named(port, self.value(arrival.port), self._net.spans.get(number, port.symbol.span))
        assert arrival.step.edge is not None
        link = self._net.links[arrival.step.edge]
        if not arrival.step.backward:
            binding = link.binding
            return self._named(port, self._ctx.elaborate(self._ctx, binding.scope, binding.node, False), binding.span)
        return self._named(port, self._backward(link, port), link.binding.span)

    def _named(self, port: Port, value: Value, span: Span) -> Value:
        if not isinstance(value, FrameValue):
            return POISON
        symbol = port.symbol
        assert symbol is not None
        doc = symbol.declarator.doc if symbol.declarator is not None else None
        spans = (span, *symbol.scope.spans)
        frame = Frame(spans=spans, name=port.name, parent=value.name, steps=value.steps, doc=doc)
        self._ctx.product.named.append(frame)
        return FrameValue(port.name, (), value.variability, value.order)

    def _backward(self, link: Link, base: Port) -> Value:
        """The base of a link as a frame that follows from its child."""
        start = self.value(link.child)
        steps = self._steps_from(link, base)
        if steps is None or not isinstance(start, FrameValue):
            return POISON
        undone = inverse(steps.steps)
        if undone is None or self._depends_on(steps.steps, base.name):
            self._ctx.sink.report("E0706", link.binding.node.span, Label(link.instance.span, "entered in reverse"))
            return POISON
        both = (start, steps)
        return FrameValue(start.name, (*start.steps, *undone), latest(*both), highest(*both))

    def _steps_from(self, link: Link, base: Port) -> FrameValue | None:
        """The steps of a link, its base taken as known while they are read."""
        symbol = base.symbol
        assert symbol is not None
        mark = len(self._ctx.product.named)
        # steps that mention the base are refused, so only what they themselves depend on counts
        symbol.made.cells[base.indices] = FrameValue(base.name, (), WORLD_FRAME.variability, WORLD_FRAME.order)
        binding = link.binding
        try:
            value = self._ctx.elaborate(self._ctx, binding.scope, binding.node, False)
        finally:
            del symbol.made.cells[base.indices]
        if any(_item_mentions(item, base.name) for item in self._ctx.product.named[mark:]):
            self._ctx.sink.report("E0706", binding.node.span, Label(link.instance.span, "entered in reverse"))
            return None
        return value if isinstance(value, FrameValue) else None

    def _depends_on(self, steps: tuple[FrameStep, ...], name: str) -> bool:
        return any(
            names_frame(node, name) for step in steps for part in step_expressions(step) for node in postorder(part)
        )


def _item_mentions(item: flat_model.Named, name: str) -> bool:
    if isinstance(item, Frame) and item.parent == name:
        return True
    return any(names_frame(node, name) for part in _parts(item) for node in postorder(part))


def _parts(item: flat_model.Named) -> tuple[FlatExpression, ...]:
    match item:
        case flat_model.Definition():
            return (item.value,)
        case flat_model.Point():
            return (item.position,)
        case Frame():
            return tuple(part for step in item.steps for part in step_expressions(step))
