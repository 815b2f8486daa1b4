"""Switches of a program: places in its expressions at which functions change their branch, and the side of each.

`abs`, `max`, comparisons that are no events, whole numbers of `floor` and `mod`; and the entries of w that are truths
of relations. All are found on the graph, whatever wrote them there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.evaluate import evaluate, evaluate_with_size
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.mechanics.equations import form_equations
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.events import BRANCH
from lagdsl.language.flat.quantity import Spans
from lagdsl.motion.analysis.point import Flow, System

Signs = NDArray[np.int8]

# A distance is clearly not zero if it is so many roundings of its terms.
_CLEAR = 64.0 * float(np.finfo(np.float64).eps)
_ONE_SIDED = (Op.ABS, Op.SIGN, Op.ATAN2)
_TWO_SIDED = (Op.MIN, Op.MAX, Op.LESS, Op.LESS_EQUAL)
_WHOLE = (Op.FLOOR, Op.CEIL, Op.MOD)


@dataclass(frozen=True, slots=True)
class Switch:
    """Its distance is `left` less `right`, `left` alone without it. A `whole` one turns where their quotient is a whole
    number. `entry` is the place in w of a relation."""

    left: int
    right: int | None = None
    whole: bool = False
    entry: int | None = None


def switches(program: Program, functions: Sequence[str]) -> list[Switch]:
    """Switches that values of `functions` depend on; none of parameters and time alone."""
    graph = program.graph
    roots = [node for name in functions for block in program.function(name).results for node in block.nodes]
    live = graph.live(roots)
    found: dict[Switch, None] = {}
    for node in live:
        op, moving = graph.op[node], graph.depends(node, Group.Q, Group.QD, Group.Z, Group.U, Group.QDD, Group.LAMBDA)
        if not moving:
            continue
        if op in _ONE_SIDED:
            found[Switch(graph.a[node])] = None
        elif op in _TWO_SIDED:
            found[Switch(graph.a[node], graph.b[node])] = None
        elif op in _WHOLE:
            found[Switch(graph.a[node], graph.b[node] if op is Op.MOD else None, whole=True)] = None
    return [*found, *_relations(program, set(live))]


def _relations(program: Program, live: set[int]) -> list[Switch]:
    """Switches of the relations that are read. That of a taut rope, which its own row keeps at zero, has no side."""
    if not program.has("indicator"):
        return []
    graph, layout = program.graph, program.layout
    nodes = program.function("indicator").results[0].elements
    entries = [place for place, kind in enumerate(layout.kinds) if kind == "relation"]
    read = {graph.b[node] for node in live if graph.op[node] is Op.SYMBOL and graph.group(node) is Group.W}
    return [Switch(node, entry=entry) for node, entry in zip(nodes, entries, strict=True) if entry in read]


def signs(system: System, found: Sequence[Switch], flows: Sequence[Flow]) -> Signs:
    """1 or -1 for the side of each switch, shape (flows, switches), 0 where it is not clear; whole numbers are counted
    from the one next to the first flow."""
    symbols = _symbols(flows)
    nodes = list(dict.fromkeys(node for each in found for node in (each.left, each.right) if node is not None))
    sized = dict(zip(nodes, evaluate_with_size(system.program.graph, nodes, symbols), strict=True))
    columns = []
    with np.errstate(all="ignore"):
        for each in found:
            value, size = sized[each.left]
            if each.right is not None:
                other, its_size = sized[each.right]
                value, size = (value / other, size / np.abs(other)) if each.whole else (value - other, size + its_size)
            value = np.broadcast_to(value, (len(flows),))
            if each.whole:
                value = value - np.rint(value[0])
            columns.append(np.where(np.abs(value) > _CLEAR * size, np.sign(value), 0.0))
    return np.stack(columns, axis=1).astype(np.int8)


def _symbols(flows: Sequence[Flow]) -> dict[Group, Floats]:
    """Values of the symbols, a row for each flow."""
    points = [each.point for each in flows]
    return {
        Group.TIME: np.array([point.t for point in points]),
        Group.Q: np.array([point.q for point in points]),
        Group.QD: np.array([point.qd for point in points]),
        Group.Z: np.array([point.z for point in points]),
        Group.U: np.array([point.u for point in points]),
        Group.W: np.array([point.w for point in points]),
        Group.P: np.array([point.p for point in points]),
        Group.QDD: np.array([each.qdd for each in flows]),
        Group.LAMBDA: np.array([each.lam for each in flows]),
    }


def places(
    system: System, found: Sequence[Switch], sides: tuple[Flow, Flow], turned: NDArray[np.bool_]
) -> dict[str, Spans]:
    """Texts of what is different on both sides, with their places: relations that `turned`, functions with a corner
    between the two."""
    flat = system.flat
    spans = {each.name: each.spans for each in flat.events.relations}
    names = [slot.name for slot in system.engine.layout.discretes]
    turning = [names[each.entry] for each, turns in zip(found, turned, strict=True) if turns and each.entry is not None]
    told = {name.removeprefix(BRANCH): spans[name] for name in turning}
    if len(turning) == int(np.count_nonzero(turned)):
        return told
    lowering = form_equations(flat).lowering
    corners = (*flat.events.corners, *flat.events.others)
    nodes = [lowering.scalar(each.distance) for each in corners]
    one, other = (np.array(evaluate(lowering.graph, nodes, _symbols([side]))) for side in sides)
    return told | {
        " ".join(each.spans[0].text.split()): each.spans
        for each, turns in zip(corners, np.ravel(one * other < 0.0), strict=True)
        if turns
    }
