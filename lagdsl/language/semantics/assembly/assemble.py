"""From components and their connections to frames, coordinates and closures."""

from __future__ import annotations

from lagdsl.language.semantics.assembly import graph, kinematics
from lagdsl.language.semantics.assembly.assembly import Assembly, Parts
from lagdsl.language.semantics.assembly.chains import Chains
from lagdsl.language.semantics.assembly.closures import Closures
from lagdsl.language.semantics.assembly.connections import Connections
from lagdsl.language.semantics.assembly.costs import Preference, is_fixed, is_started, preferences
from lagdsl.language.semantics.assembly.dependencies import Dependencies
from lagdsl.language.semantics.assembly.islands import report_islands
from lagdsl.language.semantics.assembly.loops import Loops
from lagdsl.language.semantics.assembly.merges import Merges
from lagdsl.language.semantics.assembly.net import WORLD, Net
from lagdsl.language.semantics.assembly.networks import Networks
from lagdsl.language.semantics.assembly.routes import Routes
from lagdsl.language.semantics.assembly.uses import Uses
from lagdsl.language.semantics.scope.contents import Contents, Placed
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Instance
from lagdsl.language.syntax import nodes


def assemble(ctx: Context, root: Instance, contents: Contents) -> Assembly:
    """Give every frame without a binding its place.

    Called when all names, modifiers and items are known and nothing is elaborated yet. Single frames and coordinates
    are made when they are asked for.
    """
    net = Net(ctx, Dependencies(ctx))
    for placed in contents.kinematics:
        with ctx.current.inside(placed.scope):
            kinematics.link(ctx, net, placed)
    merges = Merges(ctx, contents.symbols)
    networks = Networks(ctx, net, merges, contents.instances)
    connections = Connections(ctx, Chains(ctx, net), merges, networks)
    for placed in contents.connects:
        assert isinstance(placed.node, nodes.Connect)
        with ctx.current.inside(placed.scope):
            connections.connect(placed.scope, placed.node)
    whole = not ctx.sink.has_errors  # else what hangs loose may be held by what was not understood
    merges.settle()
    networks.settle()
    net.shared.update(merges.merged)
    equations: dict[Instance, list[Placed]] = {}
    for placed in contents.closure:
        equations.setdefault(placed.instance, []).append(placed)
    uses = Uses(ctx)
    if net.links:  # else no coordinate follows from frames
        uses.search(contents)
    solvable = [
        able and uses.required.isdisjoint(link.own)
        for able, link in zip(_solvable(net, equations), net.links, strict=True)
    ]
    wanted = preferences(
        ctx, net, [able and uses.values.isdisjoint(link.own) for able, link in zip(solvable, net.links, strict=True)]
    )
    tree = _tree(net, wanted)
    routes = Routes(ctx, net, tree)
    loops = Loops(net, tree)
    computed = [
        able
        and wish != Preference.ALWAYS
        and not any(
            is_fixed(ctx, symbol)
            or (wish != Preference.NEVER and is_started(ctx, symbol))
            or symbol.name in ctx.conventions.unknowns
            for symbol in link.own
        )
        for able, wish, link in zip(solvable, wanted, net.links, strict=True)
    ]
    closures = Closures(ctx, net, routes, loops.cuts(equations, computed), loops.ties(), uses.values)
    assembly = Assembly(ctx, Parts(net, routes, closures, merges, networks, whole), contents.instances)
    ctx.assembly = assembly
    report_islands(ctx, net, routes, contents.instances if whole else ())
    return assembly


def _solvable(net: Net, equations: dict[Instance, list[Placed]]) -> list[bool]:
    """True if the coordinates of each link may follow from its frames: only it needs them, and it has a closure."""
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


def _tree(net: Net, wanted: list[Preference]) -> graph.Tree:
    """The frames of the net in the order in which they follow from the world; equal wishes in the order of the text."""
    edges = [
        graph.Edge(
            net.root(link.base),
            net.root(link.child),
            (int(wish), link.number),
            tuple(net.root(need) for need in link.needs),
        )
        for link, wish in zip(net.links, wanted, strict=True)
    ]
    world = graph.Given(net.root(WORLD))
    givens = [graph.Given(net.root(loose.port), tuple(net.root(need) for need in loose.needs)) for loose in net.placed]
    return graph.span(len(net.ports), edges, [*givens, world])
