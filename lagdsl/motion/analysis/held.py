"""Discrete variables in a linearization: they keep their values, so that a loop that is closed by samples is open."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.event_flow import branches
from lagdsl.language.flat.events import Impact, Reset
from lagdsl.motion.analysis.point import System
from lagdsl.motion.analysis.sparsity.accelerations import bits_of
from lagdsl.motion.analysis.sparsity.influence import Influences

_MOST_TOLD = 4
_SAMPLED = "the sampled loop is open here, its entries are zero; `--every` with the period of its clock closes it"
SAMPLED_KINDS = ("variable", "condition", "relation")
_OTHER = "entries of what acts through them are zero; start the model in the mode that you mean"


# Functions through which discretes act on the motion: forces, rows of rates, momenta, states.
MOTION = ("residual", "velocity_constraint", "momenta", "state_derivative")


def report_held(system: System, sink: Sink, *, of_loop: bool = False) -> None:
    """N0876 where the model has variables that change at events only: sampled controllers, modes. `of_loop`: the loop
    that ticks close is linearized, and what they set is not held."""
    events = system.flat.events
    ticking = _ticked(system) if of_loop else frozenset()
    discretes = [item for item in events.discretes if item.name not in ticking]
    clocks = () if of_loop else events.clocks
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
    acts, _, blows = (block.elements for block in program.function("event").results[1:4])
    motion = nodes_of(program, MOTION)
    found, read = entries_read(program, [*acts, *blows, *motion])
    ticking = reached_by_ticks(layout.kinds, read)
    acting = bits_of(found.of_all(motion)[0] & ticking)
    actions = [action for branch in branches(system.flat) for action in branch.actions]
    resets = [action.name for action in actions if isinstance(action, Reset)]
    impacts = [" ".join(action.spans[0].text.split()) for action in actions if isinstance(action, Impact)]
    done = [*zip(resets, acts, strict=True), *zip(impacts, blows, strict=True)]
    names = [name for name, node in done if found[node][0] & ticking]
    return tuple(dict.fromkeys([*(layout.discretes[place].name for place in acting), *names]))


def _ticked(system: System) -> frozenset[str]:
    """Names of the entries that change at ticks."""
    layout = system.program.layout
    if not system.flat.events.clocks:
        return frozenset()
    ticking = reached_by_ticks(layout.kinds, entries_read(system.program, [])[1])
    return frozenset(layout.discretes[place].name for place in bits_of(ticking))


def nodes_of(program: Program, names: Sequence[str]) -> list[int]:
    """All results of these functions."""
    return [node for name in names for block in program.function(name).results for node in block.nodes]


def entries_read(program: Program, others: Sequence[int]) -> tuple[Influences, dict[int, int]]:
    """Influences of the entries of w, as bits, on the clauses and on `others`; and the bits that new values of entries
    and relations read, by their places."""
    graph, layout = program.graph, program.layout
    after = program.function("event").results[0].elements
    indicators = program.function("indicator").results[0].elements
    bits = {graph.symbol(Group.W, place): 1 << place for place in range(len(layout.kinds))}
    found = Influences(graph, [*after, *indicators, *others], bits)
    relations = [place for place, kind in enumerate(layout.kinds) if kind == "relation"]
    read = {place: found[node][0] for place, node in enumerate(after) if layout.kinds[place] in SAMPLED_KINDS}
    return found, read | {place: found[node][0] for place, node in zip(relations, indicators, strict=True)}


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
