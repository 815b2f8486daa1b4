"""Weights of typed bodies: potentials that are linear in the heights of points which bodies carry.

A body whose potential is -m g.r for its own mass and mass centre hangs in a frame that accelerates with -g, as declared
bodies do under `gravity` (Luh, Walker, Paul 1980): its weight costs nothing then.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from lagdsl.algebra.graph.differentiate import mask_of
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.identity import identical
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.mechanics.kinematics.vectors import Vector
from lagdsl.derivation.mechanics.lagrange.body_recognition import RecognizedBody
from lagdsl.derivation.mechanics.lagrange.terms import Term
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.foundation.record import record

_HELD = mask_of((Group.P,))


@record()
class _Height:
    """World component `axis` of a point at `place` in the axes of `frame`, times `sign`."""

    frame: str
    place: Vector
    axis: int
    sign: int


@record()
class _Weight:
    """A force along a world axis at a place of a frame, and the term that it comes from."""

    axis: int
    force: int
    place: Vector
    term: Term


class Heights:
    """Symbols for the world components of the points that frames carry."""

    def __init__(self, lowering: Lowering) -> None:
        graph = self._graph = lowering.graph
        found: dict[int, _Height] = {}
        for position, (frame, place) in lowering.own.places.items():
            for axis, node in enumerate(position):
                negative = graph.op[node] is Op.NEGATE
                bare = graph.a[node] if negative else node
                if graph.depends(bare, Group.Q) and graph.op[bare] is not Op.SYMBOL:
                    found.setdefault(bare, _Height(frame, place, axis, -1 if negative else 1))
        symbols = {node: graph.symbol(Group.RELEASE, index) for index, node in enumerate(found)}
        self._by_symbol = {symbols[node]: height for node, height in found.items()}
        self._apart = Substitution(graph, symbols)
        self._together = Substitution(graph, {symbol: node for node, symbol in symbols.items()})

    def apart(self, node: int) -> int:
        return self._apart.of(node)

    def together(self, node: int) -> int:
        return self._together.of(node)

    def hang(
        self, bodies: Sequence[RecognizedBody], terms: Sequence[Term]
    ) -> tuple[list[tuple[RecognizedBody, Vector]], list[Term]]:
        """The bodies, each with the gravity under which it has its typed weight; and the terms that are left."""
        graph = self._graph
        weights, rest = self._weights(terms)
        none = (graph.zero, graph.zero, graph.zero)
        found = {body.frame: _under_own(graph, body, weights.get(body.frame, [])) for body in bodies}
        known = list(dict.fromkeys(hung[1] for hung in found.values() if hung is not None))
        hanging = []
        for body in bodies:
            hung = found[body.frame] or _under_known(graph, body, weights.get(body.frame, []), known)
            if hung is not None:
                del weights[body.frame]
            hanging.append(hung or (body, none))
        return hanging, rest + [weight.term for left in weights.values() for weight in left]

    def _weights(self, terms: Sequence[Term]) -> tuple[dict[str, list[_Weight]], list[Term]]:
        """Weights by frame, and all other terms."""
        by_frame: dict[str, list[_Weight]] = {}
        rest: list[Term] = []
        for term in terms:
            height = self._by_symbol.get(term.node)
            if height is None or any(self._graph.groups[x] & ~_HELD for x in height.place):
                rest.append(term)
                continue
            force = term.weight if height.sign > 0 else self._graph.negate(term.weight)
            by_frame.setdefault(height.frame, []).append(_Weight(height.axis, force, height.place, term))
        return by_frame, rest


def _under_own(graph: Graph, body: RecognizedBody, weights: Sequence[_Weight]) -> tuple[RecognizedBody, Vector] | None:
    """The gravity that gives a body of known mass its weights, where they are those of its mass and moment."""
    if not weights or body.open_mass:
        return None
    gravity = []
    for axis in range(3):
        force, moment = _sums(graph, [(weight.force, weight.place) for weight in weights if weight.axis == axis])
        g = quotient(graph, force, body.mass)
        if g is None or not identical(graph, force, graph.multiply(g, body.mass)):
            return None
        for k in range(3):
            if not body.open_moment[k] and not identical(graph, moment[k], graph.multiply(g, body.moment[k])):
                return None
        gravity.append(g)
    return body, (gravity[0], gravity[1], gravity[2])


def _under_known(
    graph: Graph, body: RecognizedBody, weights: Sequence[_Weight], known: Sequence[Vector]
) -> tuple[RecognizedBody, Vector] | None:
    """A body about a fixed origin with the mass that its weights have under the gravity of another body, or any."""
    axes = dict.fromkeys(weight.axis for weight in weights)
    if not body.open_mass or len(axes) != 1:
        return None
    (axis,) = axes
    x, y, z = (weights[0].force if k == axis else graph.zero for k in range(3))
    for gravity in (*known, (x, y, z)):
        if any((component != graph.zero) != (k == axis) for k, component in enumerate(gravity)):
            continue
        masses = [quotient(graph, weight.force, gravity[axis]) for weight in weights]
        parts = [(mass, weight.place) for mass, weight in zip(masses, weights, strict=True) if mass is not None]
        if len(parts) == len(weights):
            mass, moment = _sums(graph, parts)
            return replace(body, mass=mass, moment=moment), gravity
    return None


def _sums(graph: Graph, parts: Sequence[tuple[int, Vector]]) -> tuple[int, Vector]:
    """Total of weights, and of weights times places."""
    total = graph.sum(weight for weight, _ in parts)
    x, y, z = (graph.sum(graph.multiply(weight, place[k]) for weight, place in parts) for k in range(3))
    return total, (x, y, z)


def quotient(graph: Graph, product: int, factor: int) -> int | None:
    """`product` without `factor`, where it is one by its form: nothing is divided by that might be zero."""
    if product == graph.zero:
        return product
    if product == factor:
        return graph.one
    a, b = graph.a[product], graph.b[product]
    if graph.is_constant(factor) and graph.is_constant(product):
        return None if factor == graph.zero else graph.divide(product, factor)
    op = graph.op[product]
    if op is Op.MULTIPLY:
        left, right = quotient(graph, a, factor), quotient(graph, b, factor)
        if left is not None:
            return graph.multiply(left, b)
        return None if right is None else graph.multiply(a, right)
    left = quotient(graph, a, factor) if op in (Op.NEGATE, Op.DIVIDE) else None
    if left is None:
        return None
    return graph.negate(left) if op is Op.NEGATE else graph.divide(left, b)
