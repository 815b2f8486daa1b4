"""Kinematics sections: `frame_b = frame_a.rotz(q);` becomes a link between two ports."""

from __future__ import annotations

from lagdsl.language.semantics.assembly.net import WORLD, Net
from lagdsl.language.semantics.assembly.paths import Element, World, base_of, target_of
from lagdsl.language.semantics.scope.contents import Placed
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Binding, Scope
from lagdsl.language.semantics.scope.values import Poison
from lagdsl.language.syntax import nodes


def link(ctx: Context, net: Net, placed: Placed) -> None:
    """Add the equation to the net, or report that it gives no frame its place."""
    item = placed.node
    assert isinstance(item, nodes.Equation)
    for side, other in ((item.left, item.right), (item.right, item.left)):
        child = port_of(ctx, net, placed.scope, side)
        base = base_of(ctx, placed.scope, other)
        found = port_of(ctx, net, placed.scope, base) if base is not None else None
        if child not in (None, WORLD) and found is not None:
            assert child is not None
            net.link(found, child, Binding(other, placed.scope, item.span), placed.instance)
            return
    others = [side for side in (item.left, item.right) if port_of(ctx, net, placed.scope, side) is None]
    readable = [side for side in others if not net.dependencies.of(placed.scope, side)[0]]
    values = [ctx.elaborate(ctx, placed.scope, side, False) for side in readable]
    if not any(isinstance(value, Poison) for value in values):
        ctx.sink.report("E0700", item.span)


def port_of(ctx: Context, net: Net, scope: Scope, node: nodes.Expression) -> int | None:
    """The port that a plain name stands for."""
    target = target_of(ctx, scope, node)
    if isinstance(target, World):
        return WORLD
    if isinstance(target, Element) and target.symbol.kind == "frame" and target.indices is not None:
        return net.port(target.symbol, target.indices)
    return None
