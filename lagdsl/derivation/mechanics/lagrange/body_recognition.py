"""Rigid bodies that were typed as energies: found again in what the energies say, not in how they are written.

The terms of T in one frame's twist are a quadratic form with 21 entries. If these are those of a rigid body (one mass,
its moment, any inertia), its equations are Newton's and Euler's, which need no velocity of the origin.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.algebra.graph.differentiate import adjoints, mask_of
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.identity import identical
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.mechanics.kinematics.vectors import Axes, Vector
from lagdsl.derivation.mechanics.lagrange.lagrangian_form import VELOCITY, Apart, Component
from lagdsl.derivation.mechanics.lagrange.terms import Term
from lagdsl.foundation.record import record

_HELD = mask_of((Group.P,))
_IN_TWIST = mask_of((*VELOCITY, Group.P))
# A term of more nodes is no product of a few components.
_LARGEST_TERM = 100


@record(kw_only=True)
class RecognizedBody:
    """Mass, mass times place of its centre, and inertia about the origin, in the axes of `frame`.

    Of what a plane motion or one about a fixed origin leaves open, `open_mass` and `open_moment` tell.
    """

    frame: str
    mass: int
    moment: Vector
    tensor: Axes
    open_mass: bool
    open_moment: tuple[bool, bool, bool]


def recognized_bodies(apart: Apart, lagrangian: Sequence[Term]) -> tuple[list[RecognizedBody], list[Term]]:
    """The bodies in the terms of a Lagrangian with the symbols of `apart`, and the terms that are left."""
    found, bodies = _by_frame(apart, lagrangian), []
    rest = found.pop("")
    for frame, terms in found.items():
        body = _body(apart, frame, terms)
        if body is None:
            rest += terms
        else:
            bodies.append(body)
    return bodies, rest


def _by_frame(apart: Apart, lagrangian: Sequence[Term]) -> dict[str, list[Term]]:
    """Terms by the frame whose twist they are written in; "" where it is none or more than one."""
    graph = apart.graph
    frames: dict[int, dict[str, None]] = {}
    for frame, (omega, velocity) in apart.twists.items():
        for node in (*omega, *velocity):
            frames.setdefault(apart.component(node).node, {})[frame] = None
    found: dict[str, list[Term]] = {"": []}
    shared: list[tuple[Term, list[str]]] = []
    for term in lagrangian:
        symbols = None if graph.groups[term.node] & ~_IN_TWIST else _symbols(graph, term.node)
        if not symbols:
            found[""].append(term)
            continue
        possible = [frame for frame in apart.twists if all(frame in frames.get(x, ()) for x in symbols)]
        if len(possible) == 1:
            found.setdefault(possible[0], []).append(term)
        else:
            shared.append((term, possible))
    for term, possible in shared:
        known = [frame for frame in possible if frame in found]
        found.setdefault((known or possible or [""])[0], []).append(term)
    return found


def _symbols(graph: Graph, root: int) -> list[int] | None:
    """Velocities in a small expression; None where it is large."""
    stack, seen = [root], {root: None}
    while stack and len(seen) < _LARGEST_TERM:
        for argument in graph.arguments(stack.pop()):
            if argument not in seen:
                seen[argument] = None
                stack.append(argument)
    if stack:
        return None
    return [node for node in seen if graph.op[node] is Op.SYMBOL and graph.group(node) in VELOCITY]


def _body(apart: Apart, frame: str, terms: list[Term]) -> RecognizedBody | None:
    graph = apart.graph
    weights = _weights(graph, terms)
    if weights is None:
        return None
    omega, velocity = apart.twists[frame]
    form = _Form(graph, weights, [apart.component(node) for node in (*omega, *velocity)])
    mass, moment = form.mass(), form.moment()
    if mass is None or moment is None:
        return None
    x, y, z = ((form.at(i, 0), form.at(i, 1), form.at(i, 2)) for i in range(3))
    still = [node == graph.zero for node in (*omega, *velocity)]
    return RecognizedBody(
        frame=frame,
        mass=mass,
        moment=moment,
        tensor=(x, y, z),
        open_mass=all(still[3:]),
        open_moment=(_is_open(still, 0), _is_open(still, 1), _is_open(still, 2)),
    )


def _is_open(still: Sequence[bool], j: int) -> bool:
    """True if component j of the moment multiplies nothing that moves."""
    i, k = (j + 1) % 3, (j + 2) % 3
    return (still[i] or still[k + 3]) and (still[k] or still[i + 3])


def _weights(graph: Graph, terms: list[Term]) -> dict[int, dict[int, int]] | None:
    """Second derivatives by velocity; None unless the terms are a quadratic form with constant ones."""
    seeds: dict[int, int] = {}
    for term in terms:
        seeds[term.node] = graph.add(seeds.get(term.node, graph.zero), term.weight)
    momenta = adjoints(graph, seeds, VELOCITY)
    rest = Substitution(graph, dict.fromkeys(momenta, graph.zero))
    weights = {}
    for symbol, momentum in momenta.items():
        weights[symbol] = adjoints(graph, {momentum: graph.one}, VELOCITY)
        if rest.of(momentum) != graph.zero or any(graph.groups[x] & ~_HELD for x in weights[symbol].values()):
            return None
    return weights


class _Form:
    """The quadratic form by component of the twist: 0 to 2 of omega, 3 to 5 of the velocity."""

    def __init__(self, graph: Graph, weights: Mapping[int, Mapping[int, int]], twist: list[Component]) -> None:
        self._graph, self._weights, self._twist = graph, weights, twist
        self._there = [self._is_first(k) for k in range(6)]

    def _is_first(self, k: int) -> bool:
        """True if component k moves, and is not another one, too."""
        node = self._twist[k].node
        return node >= 0 and all(other.node != node for other in self._twist[:k])

    def at(self, i: int, j: int) -> int:
        if not (self._there[i] and self._there[j]):
            return self._graph.zero
        weight = self._weights.get(self._twist[i].node, {}).get(self._twist[j].node, self._graph.zero)
        return self._graph.negate(weight) if self._twist[i].sign != self._twist[j].sign else weight

    def mass(self) -> int | None:
        """The one weight of all components of the velocity."""
        moving = [k for k in (3, 4, 5) if self._there[k]]
        if any(self.at(i, j) != self._graph.zero for i in moving for j in moving if i != j):
            return None
        return self._common([self.at(k, k) for k in moving])

    def moment(self) -> Vector | None:
        """mc of v . omega x mc: each component at two places with opposite signs, where they are there."""
        if any(self.at(k, k + 3) != self._graph.zero for k in range(3)):
            return None
        found = []
        for j in range(3):
            i, k = (j + 1) % 3, (j + 2) % 3
            entries = [self.at(k, i + 3)] if self._there[k] and self._there[i + 3] else []
            if self._there[i] and self._there[k + 3]:
                entries.append(self._graph.negate(self.at(i, k + 3)))
            value = self._common(entries)
            if value is None:
                return None
            found.append(value)
        return (found[0], found[1], found[2])

    def _common(self, values: list[int]) -> int | None:
        if not values:
            return self._graph.zero
        return values[0] if all(identical(self._graph, values[0], value) for value in values[1:]) else None
