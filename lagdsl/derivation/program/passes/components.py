"""Coordinates and states that move together: the connected components of the coupling by the equations."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program

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
    found = _Components(program)
    nq, nz = len(layout.coordinates), len(layout.states)
    coordinates, states = range(nq), range(nq, nq + nz)
    multipliers = range(found.first[Group.LAMBDA], found.first[Group.LAMBDA] + len(layout.constraints))
    discretes = range(found.first[Group.W], found.first[Group.W] + len(layout.discretes))
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
        found.tie(elements, places)
    names: dict[int, int] = {}
    return tuple(names.setdefault(found.leader_of(place), len(names)) for place in range(nq + nz))


class _Components:
    """Disjoint sets of coordinates, states, multipliers and discretes; each node knows one of those it depends on."""

    def __init__(self, program: Program) -> None:
        layout, self._program = program.layout, program
        nq, nz, nw = len(layout.coordinates), len(layout.states), len(layout.discretes)
        self.first = {Group.Q: 0, Group.QD: 0, Group.QDD: 0, Group.Z: nq, Group.W: nq + nz, Group.LAMBDA: nq + nz + nw}
        self._idle = frozenset(i for i, kind in enumerate(layout.kinds) if kind not in _COUPLING)
        self._leader = list(range(nq + nz + nw + len(layout.constraints)))
        self._member = [-1] * len(program.graph)  # -1: depends on none
        self._mask = sum(1 << group for group in self.first)

    def leader_of(self, place: int) -> int:
        leader = self._leader
        while leader[place] != place:
            leader[place] = place = leader[leader[place]]
        return place

    def look(self, roots: Iterable[int]) -> None:
        """Symbols on which `roots` and all nodes below them depend."""
        graph, member, mask = self._program.graph, self._member, self._mask
        operands, groups = graph.operands, graph.groups
        for node in graph.live(roots):
            if not groups[node] & mask:
                continue
            found = -1 if operands[node] else self._symbol(node)
            for operand in operands[node]:
                other = member[operand]
                if other >= 0 and other != found:
                    if found >= 0:
                        self._join(found, other)
                    found = other
            member[node] = found

    def tie(self, elements: Sequence[int], places: Sequence[int]) -> None:
        """Element by element what it depends on, and its place."""
        for element, place in zip(elements, places, strict=False):
            if self._member[element] >= 0:
                self._join(place, self._member[element])

    def _symbol(self, node: int) -> int:
        group, index = self._program.graph.group(node), self._program.graph.b[node]
        return -1 if group is Group.W and index in self._idle else self.first[group] + index

    def _join(self, one: int, other: int) -> None:
        one, other = self.leader_of(one), self.leader_of(other)
        if one != other:
            self._leader[max(one, other)] = min(one, other)
