"""Coordinates and states that move together: the connected components of the coupling by the equations."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.program.ties import Ties

# Entries of w that belong to time alone, or to the whole model, couple nothing.
_COUPLING = frozenset(
    {"variable", "contact", "impacts", "sticks", "direction", "relation", "delay", "condition", "load"}
)


def with_components(program: Program) -> Program:
    """The same with `components` in its layout."""
    return replace(program, layout=replace(program.layout, components=components(program)))


def components(program: Program) -> tuple[int, ...]:
    """The number of the component of every coordinate and state (nq + nz,), in the order of their first members.

    Two belong together where a row of the equations of motion, of the constraints, of the states' rates, of the initial
    equations or of the events depends on both, by itself or through multipliers and discretes. The graph is undirected:
    what drives is with what it drives. Outputs, invariants and energies couple nothing, nor does time. Each node of
    these functions is seen once.
    """
    layout = program.layout
    nq, nz, nw = len(layout.coordinates), len(layout.states), len(layout.discretes)
    total = nq + nz + nw + len(layout.constraints)
    coordinates, states = range(nq), range(nq, nq + nz)
    discretes, multipliers = range(nq + nz, nq + nz + nw), range(nq + nz + nw, total)
    first = {Group.Q: 0, Group.QD: 0, Group.QDD: 0, Group.Z: nq, Group.W: nq + nz, Group.LAMBDA: nq + nz + nw}
    found = Ties(program.graph, total, first, _item_of(program, first))
    relations, contacts, frictions, delays, loads = (
        [place for place, kind in zip(discretes, layout.kinds, strict=False) if kind == wanted]
        for wanted in ("relation", "contact", "sticks", "delay", "load")
    )
    counts = layout.instants.friction_slips
    slips = [place for place, count in zip(frictions, counts, strict=True) for _ in range(count)]
    resets = [place % nq if place < 2 * nq else place - nq for place in layout.instants.reset_places]
    ties: list[tuple[str, int, Sequence[int]]] = [
        ("residual", 0, coordinates),
        ("residual", 1, multipliers),
        ("position_constraint", 0, multipliers),
        ("state_derivative", 0, states),
        ("initial_equation", 0, ()),
        ("indicator", 0, relations),
        ("contact", 0, contacts),
        ("contact", 1, contacts),
        ("friction", 0, slips),
        ("friction", 2, frictions),
        ("friction", 3, frictions),
        ("delayed", 0, delays),
        ("load", 0, loads),
        ("event", 0, discretes),
        ("event", 1, resets),
        ("event", 2, resets),
        ("event", 3, ()),
    ]
    blocks = [(program.function(name).results[i].elements, places) for name, i, places in ties if program.has(name)]
    found.look(node for elements, _ in blocks for node in elements)
    for elements, places in blocks:
        for element, place in zip(elements, places, strict=False):
            found.tie(place, element)
    names: dict[int, int] = {}
    return tuple(names.setdefault(found.leader_of(place), len(names)) for place in range(nq + nz))


def _item_of(program: Program, first: Mapping[Group, int]) -> Callable[[int], int]:
    """The item of a symbol, from the first one of its group on; -1 of what couples nothing."""
    graph = program.graph
    idle = frozenset(i for i, kind in enumerate(program.layout.kinds) if kind not in _COUPLING)

    def found(node: int) -> int:
        group, index = graph.group(node), graph.b[node]
        return -1 if group is Group.W and index in idle else first[group] + index

    return found
