"""Parts that derivatives of L and D would have more if rates of states were not held.

States are functions of time, as prescribed motions are: a mass on a carriage with the state p moves by dr/dq at a
virtual displacement, whatever der(p) is computed from. So dL/dq and dD/dqd are taken at fixed der(p), while the graph
has its equation in its place.
"""

from __future__ import annotations

from lagdsl.algebra.graph.differentiate import adjoints
from lagdsl.algebra.graph.operation import Group
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.mechanics.lagrange.lagrangian import energies
from lagdsl.derivation.mechanics.lowering.acceleration import as_coordinate, needs_accelerations
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import Directions
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel, State

_MOVING = (Group.Q, Group.QD, Group.RELEASE, Group.RELEASE_RATE, Group.W)


@record()
class ThroughStates:
    """Parts of dL/dq and dD/dqd, one entry per direction."""

    push: list[int]
    drag: list[int]


def through_states(lowering: Lowering, flat: FlatModel, directions: Directions) -> ThroughStates:
    """Sums of dL/d(der z) d(der z)/dq and dD/d(der z) d(der z)/dqd over the states z whose rates energies have.

    E0308 where momenta depend on a rate that depends on qd: its own rate of change needs accelerations. E0311 where
    the Lagrangian depends on a rate that jumps at a place: the law of steps in place would take it for a force there.
    """
    graph = lowering.graph
    rates = _asked(lowering, flat)
    none = [graph.zero] * len(directions.positions)
    if not rates:
        return ThroughStates(none, none)
    found = energies(lowering.with_held_states(flat), flat)
    together = Substitution(graph, {symbol: rate for symbol, (_, rate) in rates.items()})
    by_rate = adjoints(graph, {found.lagrangian: graph.one}, (Group.DIRECTION_Z,))
    lost = adjoints(graph, {found.dissipation: graph.one}, (Group.DIRECTION_Z,))
    for symbol, (state, rate) in rates.items():
        if symbol not in by_rate:
            continue
        if graph.depends(rate, Group.QD, Group.RELEASE_RATE):
            what = f"what `der({state.name})` carries"
            raise needs_accelerations(state.spans, what, help=as_coordinate(state.name))
        _refuse_jumps(lowering, flat, state, rate)
    sums: list[dict[int, int]] = []
    for group, weights in ((directions.position_group, by_rate), (directions.rate_group, lost)):
        seeds: dict[int, int] = {}
        for symbol, weight in weights.items():
            _, rate = rates[symbol]
            seeds[rate] = graph.add(seeds.get(rate, graph.zero), together.of(weight))
        sums.append(adjoints(graph, seeds, (group,)))
    return ThroughStates(
        [sums[0].get(position, graph.zero) for position in directions.positions],
        [sums[1].get(rate, graph.zero) for rate in directions.rates],
    )


def _refuse_jumps(lowering: Lowering, flat: FlatModel, state: State, rate: int) -> None:
    """E0311 where the rate of a state reads a relation between positions."""
    graph = lowering.graph
    present = set(graph.live([rate])) if graph.depends(rate, Group.W) else set()
    for relation in flat.events.relations:
        difference = lowering.scalar(relation.difference)
        if lowering.symbols.previous[relation.name] in present and graph.depends(difference, Group.Q):
            sink = Sink()
            what = f"a rate `der({state.name})` that changes with `{relation.name}` and carries a mass"
            hint = as_coordinate(state.name)
            sink.report("E0311", relation.spans[0] if relation.spans else None, what=what, hint=hint)
            raise CompilationFailed(sink.diagnostics)


def _asked(lowering: Lowering, flat: FlatModel) -> dict[int, tuple[State, int]]:
    """By the symbol of the rate: states whose rates were asked for; none where all rates follow from time alone."""
    graph, known = lowering.graph, lowering.rate.known()
    found = {
        graph.symbol(Group.DIRECTION_Z, index): (state, lowering.scalar(state.derivative))
        for index, (state, symbol) in enumerate(zip(flat.states, lowering.symbols.z, strict=True))
        if symbol in known
    }
    return found if any(graph.depends(rate, *_MOVING) for _, rate in found.values()) else {}
