"""Discrete variables in a linearization: they keep their values, so that a loop that is closed by samples is open."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.analysis.point import System
from lagdsl.analysis.sparsity.accelerations import bits_of
from lagdsl.analysis.sparsity.influence import Influences
from lagdsl.diagnostics import Sink
from lagdsl.flat.event_flow import branches
from lagdsl.flat.events import Impact, Reset
from lagdsl.flat.model import FlatModel
from lagdsl.graph.operation import Group

_MOST_TOLD = 4
_SAMPLED = "the sampled loop is open here, its entries are zero; `--every` with the period of its clock closes it"
SAMPLED_KINDS = ("variable", "condition", "relation")
_OTHER = "entries of what acts through them are zero; start the model in the mode that you mean"


def report_held(flat: FlatModel, sink: Sink) -> None:
    """N0876 where the model has variables that change at events only: sampled controllers, modes."""
    discretes, clocks = flat.events.discretes, flat.events.clocks
    if not discretes:
        return
    names = [f"`{item.name}`" for item in discretes[:_MOST_TOLD]]
    more = f" and {len(discretes) - len(names)} more" if len(discretes) > len(names) else ""
    by = f", which `{clocks[0].name}` sets" if len(clocks) == 1 else ", set by clocks" if clocks else ""
    sink.report(
        "N0876",
        discretes[0].spans[0] if discretes[0].spans else None,
        held=f"{', '.join(names)}{more}{by}",
        advice=_SAMPLED if clocks else _OTHER,
    )


def sampled(system: System) -> tuple[str, ...]:
    """Names of what ticks of clocks set and the motion depends on: the signals of sampled controllers. Discrete
    variables, relations that read them, states that are reset at ticks, and impacts there."""
    program, layout = system.program, system.program.layout
    if not system.flat.events.clocks:
        return ()
    graph = program.graph
    symbols = [graph.symbol(Group.W, place) for place in range(len(layout.kinds))]
    after, acts, _, blows = (block.elements for block in program.function("event").results[:4])
    indicators = program.function("indicator").results[0].elements
    motion = [
        node for name in ("residual", "state_derivative") for block in program.function(name).results
        for node in block.elements
    ]  # fmt: skip
    bits = {node: 1 << k for k, node in enumerate(symbols)}
    found = Influences(graph, [*after, *acts, *blows, *indicators, *motion], bits)
    relations = [place for place, kind in enumerate(layout.kinds) if kind == "relation"]
    read = {place: found[node][0] for place, node in enumerate(after)}
    read |= {place: found[node][0] for place, node in zip(relations, indicators, strict=True)}
    ticking = reached_by_ticks(layout.kinds, read)
    acting = bits_of(found.of_all(motion)[0] & ticking)
    actions = [action for branch in branches(system.flat) for action in branch.actions]
    resets = [action.name for action in actions if isinstance(action, Reset)]
    impacts = [" ".join(action.spans[0].text.split()) for action in actions if isinstance(action, Impact)]
    done = [*zip(resets, acts, strict=True), *zip(impacts, blows, strict=True)]
    names = [name for name, node in done if found[node][0] & ticking]
    return tuple(dict.fromkeys([*(layout.discretes[place].name for place in acting), *names]))


def reached_by_ticks(kinds: Sequence[str], read: dict[int, int]) -> int:
    """Bits of the entries that change at ticks, from the bits that each `read`s."""
    clocks = sum(1 << place for place, kind in enumerate(kinds) if kind == "clock")
    reached, before = clocks, 0
    while reached != before:
        before = reached
        for place, bits in read.items():
            if kinds[place] in SAMPLED_KINDS and bits & reached:
                reached |= 1 << place
    return reached & ~clocks
