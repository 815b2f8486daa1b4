"""From components and their connections to frames, coordinates and closures."""

from __future__ import annotations

from lagdsl.semantics.assembly import graph, kinematics
from lagdsl.semantics.assembly.assembly import Assembly
from lagdsl.semantics.assembly.chains import Chains
from lagdsl.semantics.assembly.closures import Closures
from lagdsl.semantics.assembly.costs import order_of
from lagdsl.semantics.assembly.islands import report_islands
from lagdsl.semantics.assembly.loops import Loops
from lagdsl.semantics.assembly.mentions import Mentions
from lagdsl.semantics.assembly.net import WORLD, Net
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
        kinematics.link(ctx, net, placed)
    chains = Chains(ctx, net)
    for placed in contents.connects:
        assert isinstance(placed.node, nodes.Connect)
        chains.connect(placed.scope, placed.node)
    equations: dict[Instance, list[Placed]] = {}
    for placed in contents.closure:
        equations.setdefault(placed.instance, []).append(placed)
    solvable = _solvable(net, equations)
    tree = _tree(net, order_of(net, ctx, solvable))
    routes = Routes(ctx, net, tree)
    loops = Loops(net, tree)
    closures = Closures(ctx, net, routes, loops.cuts(equations, solvable), loops.ties())
    assembly = Assembly(ctx, net, routes, closures, contents.instances)
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
