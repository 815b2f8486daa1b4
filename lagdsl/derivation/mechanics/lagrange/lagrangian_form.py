"""The acceleration form of any Lagrangian, by the velocities that it is written in.

Velocities that are total derivatives of something follow Lagrange's equations, d/dt(dL/dv) - dL/ds, however they depend
on the coordinates. Angular velocities and velocities of origins along a frame's own axes are no total derivatives; with
p = dL/dv and l = dL/domega their equations are those of Hamel and Poincare (Hamel, *Theoretische Mechanik*, 1949):

    dp/dt + omega x p = F,   dl/dt + omega x l + v x p = N
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from lagdsl.algebra.eliminate.form import AccelerationForm
from lagdsl.algebra.graph.differentiate import adjoints, mask_of
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.mechanics.kinematics.vectors import Vector, add, cross, negate
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.foundation.record import record

VELOCITY = (Group.QD, Group.RELEASE_RATE)
_HOLONOMIC = mask_of((Group.P, Group.TIME, Group.Q, Group.U, Group.W))


@record()
class Component:
    """A component of a twist: `node` times `sign`; `node` -1 where it does not depend on the rates."""

    node: int
    sign: int


class Apart:
    """A Lagrangian with symbols for the velocities it is written in, so that simplification and differentiation do not
    reach through them. Rates are their own symbols."""

    def __init__(self, lowering: Lowering) -> None:
        graph = self.graph = lowering.graph
        frames = lowering.own.used
        self.twists = {frame: lowering.poses(frame).own_twist(frame) for frame in frames}
        derivatives = _bare(graph, _total_derivatives(lowering))
        turning = _bare(graph, (x for omega, _ in self.twists.values() for x in omega))
        moving = _bare(graph, (x for _, velocity in self.twists.values() for x in velocity))
        self.carried = {node for node in (*turning, *moving) if node not in derivatives}
        """Terms that are no total derivatives."""
        nodes = list(dict.fromkeys((*derivatives, *turning, *moving)))
        self._symbols = {node: graph.symbol(Group.RELEASE_RATE, index) for index, node in enumerate(nodes)}
        self._nodes = {symbol: node for node, symbol in self._symbols.items()}
        self._apart, self._together = Substitution(graph, self._symbols), Substitution(graph, self._nodes)

    def of(self, node: int) -> int:
        return self._apart.of(node)

    def together(self, node: int) -> int:
        return self._together.of(node)

    def velocity(self, symbol: int) -> int:
        return self._nodes.get(symbol, symbol)

    def component(self, node: int) -> Component:
        """A component of a twist by its symbol."""
        graph = self.graph
        negative = graph.op[node] is Op.NEGATE
        bare = graph.a[node] if negative else node
        if not graph.depends(bare, Group.QD):
            return Component(-1, 1)
        return Component(self._symbols.get(bare, bare), -1 if negative else 1)


def add_lagrangian(
    form: AccelerationForm, lowering: Lowering, apart: Apart, lagrangian: int, gradients: dict[int, dict[int, int]]
) -> None:
    """`lagrangian` has the symbols of `apart`; its gradient is kept among `gradients`.

    Momenta by velocity, their rates of change at qdd = 0, dL/dq without.
    """
    graph = form.graph
    momenta: dict[int, int] = {}
    if lagrangian not in gradients:
        gradients[lagrangian] = adjoints(graph, {lagrangian: graph.one}, (Group.Q, *VELOCITY))
    for symbol, part in gradients[lagrangian].items():
        value = apart.together(part)
        if graph.group(symbol) is Group.Q:
            form.add_force(graph.symbol(Group.QD, graph.b[symbol]), value)
            continue
        velocity = apart.velocity(symbol)
        if velocity in apart.carried:
            momenta[velocity] = value
        form.add_force(velocity, graph.negate(lowering.bias_rate.of(value)))
        for other, weight in adjoints(graph, {part: graph.one}, VELOCITY).items():
            if other == symbol:
                form.add_square(velocity, apart.together(weight))
            elif other < symbol:
                form.add_product(velocity, apart.velocity(other), apart.together(weight))
    for omega, velocity_of_origin in apart.twists.values():
        _add_turning(form, omega, velocity_of_origin, momenta)


def _add_turning(form: AccelerationForm, omega: Vector, velocity: Vector, momenta: dict[int, int]) -> None:
    """-omega x p and -omega x l - v x p. A velocity that several frames share has its momentum in the first only."""
    graph = form.graph
    spin, push = _taken(graph, omega, momenta), _taken(graph, velocity, momenta)
    force = negate(graph, cross(graph, omega, push))
    torque = negate(graph, add(graph, cross(graph, omega, spin), cross(graph, velocity, push)))
    for component, value in zip((*velocity, *omega), (*force, *torque), strict=True):
        form.add_force(component, value)


def _taken(graph: Graph, components: Sequence[int], momenta: dict[int, int]) -> Vector:
    def taken(node: int) -> int:
        if graph.op[node] is Op.NEGATE:
            return graph.negate(momenta.pop(graph.a[node], graph.zero))
        return momenta.pop(node, graph.zero)

    x, y, z = (taken(node) for node in components)
    return (x, y, z)


def _bare(graph: Graph, velocities: Iterable[int]) -> dict[int, None]:
    """Without their signs, those that depend on the rates and are more than one of them."""
    bare = (graph.a[node] if graph.op[node] is Op.NEGATE else node for node in velocities)
    moving = (node for node in bare if graph.depends(node, Group.QD) and graph.op[node] is not Op.SYMBOL)
    return dict.fromkeys(moving)


def _total_derivatives(lowering: Lowering) -> list[int]:
    graph = lowering.graph
    return [rate for node, rate in lowering.rate.known().items() if not graph.groups[node] & ~_HOLONOMIC]
