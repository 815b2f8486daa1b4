"""From components and their connections to frames, coordinates and closures."""

from __future__ import annotations

from lagdsl.semantics.assembly import graph, kinematics
from lagdsl.semantics.assembly.assembly import Assembly, Parts
from lagdsl.semantics.assembly.chains import Chains
from lagdsl.semantics.assembly.closures import Closures
from lagdsl.semantics.assembly.connections import Connections
from lagdsl.semantics.assembly.costs import order_of
from lagdsl.semantics.assembly.islands import report_islands
from lagdsl.semantics.assembly.loops import Loops
from lagdsl.semantics.assembly.mentions import Mentions
from lagdsl.semantics.assembly.merges import Merges
from lagdsl.semantics.assembly.net import WORLD, Net
from lagdsl.semantics.assembly.networks import Networks
from lagdsl.semantics.assembly.routes import Routes
from lagdsl.semantics.contents import Contents, Placed
from lagdsl.semantics.context import Context
from lagdsl.semantics.scope import Instance
from lagdsl.syntax import nodes


def assemble(ctx: Context, root: Instance, contents: Contents) -> Assembly:
    """Give every frame without a binding its place.

    Called when all names, modifiers and items are known and nothing is elaborated yet; what the assembly finds out about
    single frames and coordinates it does when they are asked for.
    """
    net = Net(ctx, Mentions(ctx))
    for placed in contents.kinematics:
        with ctx.inside(placed.scope):
            kinematics.link(ctx, net, placed)
    merges = Merges(ctx, contents.symbols)
    networks = Networks(ctx, net, merges, contents.instances)
    connections = Connections(ctx, Chains(ctx, net), merges, networks)
    for placed in contents.connects:
        assert isinstance(placed.node, nodes.Connect)
        with ctx.inside(placed.scope):
            connections.connect(placed.scope, placed.node)
    merges.settle()
    networks.settle()
    net.shared.update(merges.merged)
    equations: dict[Instance, list[Placed]] = {}
    for placed in contents.closure:
        equations.setdefault(placed.instance, []).append(placed)
    solvable = _solvable(net, equations)
    tree = _tree(net, order_of(net, ctx, solvable))
    routes = Routes(ctx, net, tree)
    loops = Loops(net, tree)
    closures = Closures(ctx, net, routes, loops.cuts(equations, solvable), loops.ties())
    assembly = Assembly(ctx, Parts(net, routes, closures, merges, networks), contents.instances)
    ctx.assembly = assembly
    report_islands(ctx, net, routes, contents.instances)
    return assembly


def _solvable(net: Net, equations: dict[Instance, list[Placed]]) -> list[bool]:
    """Whether the coordinates of each link may follow from its frames: only it needs them, and it has a closure."""
    users: dict[object, int] = {}
    for link in net.links:
        for symbol in link.own:
            users[symbol] = users.get(symbol, 0) + 1
    return [
        bool(link.own)
        and not link.foreign
        and not link.needs
        and link.instance in equations
        and len(net.joints_of[link.instance]) == 1
        and all(users[symbol] == 1 and symbol not in net.shared for symbol in link.own)
        for link in net.links
    ]


def _tree(net: Net, costs: list[tuple[int, int]]) -> graph.Tree:
    """The frames of the net in the order in which they follow from the world."""
    edges = [
        graph.Edge(net.root(link.base), net.root(link.child), cost, tuple(net.root(need) for need in link.needs))
        for link, cost in zip(net.links, costs, strict=True)
    ]
    world = graph.Given(net.root(WORLD))
    givens = [graph.Given(net.root(loose.port), tuple(net.root(need) for need in loose.needs)) for loose in net.placed]
    return graph.span(len(net.ports), edges, [*givens, world])
