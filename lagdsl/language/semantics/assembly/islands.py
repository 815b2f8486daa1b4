"""Components that no way leads to from the world."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.numerics.disjoint_sets import DisjointSets
from lagdsl.language.semantics.assembly.net import Net, Port
from lagdsl.language.semantics.assembly.routes import Routes
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Instance
from lagdsl.language.semantics.scope.values import POISON


def report_islands(ctx: Context, net: Net, routes: Routes, instances: Sequence[Instance]) -> None:
    """E0702 for each group of components with kinematics that hangs together and is not reached.

    Only `instances` are spoken of. A group that is bound to a frame of another one follows from that.
    """
    names = {instance.scope.prefix: instance for instance in instances}
    groups = _groups(net, routes)
    unbound = [ports for ports in groups if not any(_is_bound(net.ports[number]) for number in ports)]
    for ports in unbound or groups:
        found: dict[Instance, None] = {}
        for number in ports:
            symbol = net.ports[number].symbol
            if symbol is not None and symbol.scope.prefix in names:
                found[names[symbol.scope.prefix]] = None
        if found:
            report(ctx, list(found))
    for ports in groups:
        for number in ports:
            port = net.ports[number]
            if port.symbol is not None and not _is_bound(port):
                port.symbol.made.cells[port.indices] = POISON


def _is_bound(port: Port) -> bool:
    return port.symbol is not None and port.indices in port.symbol.given.bindings


def report(ctx: Context, found: list[Instance]) -> None:
    """E0702, the first component named, the others as labels."""
    first = found[0]
    labels = [Label(instance.span, "hangs on it, too") for instance in found[1:4]]
    ctx.sink.report("E0702", first.span, *labels, name=first.name, kind=first.definition.node.name)


def _groups(net: Net, routes: Routes) -> list[list[int]]:
    """Ports of links that are not reached, by what hangs together."""
    islands = DisjointSets(range(len(net.ports)))
    loose = [link for link in net.links if not routes.reached(link.base) or not routes.reached(link.child)]
    for link in loose:
        islands.join(net.root(link.base), net.root(link.child))
    wanted = {islands.first(net.root(link.base)) for link in loose}
    groups: dict[int, list[int]] = {}
    for number in range(len(net.ports)):
        group = islands.first(net.root(number))
        if group in wanted and not routes.reached(number):
            groups.setdefault(group, []).append(number)
    return list(groups.values())
