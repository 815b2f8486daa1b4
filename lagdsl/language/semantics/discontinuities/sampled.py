"""Discontinuities that clauses evaluate at their instants. Nothing is located there: a clause takes them as they stand.
A sampled loop that is linearized has to name them."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.language.flat import model as fm
from lagdsl.language.flat.event_flow import parts
from lagdsl.language.flat.events import Assign, Reset, SampledCorner
from lagdsl.language.flat.reached import reached
from lagdsl.language.semantics.scope.product import Met


def sampled_corners(flat: fm.FlatModel, met: Sequence[Met]) -> tuple[SampledCorner, ...]:
    """The discontinuities among `met` that actions of clauses reach, with the variables and states that these set."""
    known = {id(each.expression) for each in met}
    found: dict[int, list[str]] = {}
    for when in flat.events.whens:
        for branch in when.branches:
            for action in branch.actions:
                if isinstance(action, Assign | Reset):
                    name = action.variable if isinstance(action, Assign) else action.name
                    for each in reached(flat, parts(action)):
                        if id(each) in known:
                            found.setdefault(id(each), []).append(name)
    told = [
        SampledCorner(
            spans=each.spans,
            name=" ".join(each.spans[0].text.split()),
            variables=tuple(dict.fromkeys(found[id(each.expression)])),
        )
        for each in met
        if id(each.expression) in found
    ]
    return tuple({each.spans: each for each in told}.values())
