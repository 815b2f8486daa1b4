"""The acceleration form of a model: what its masses, bodies and energies weigh, velocity by velocity.

A rigid body's inertia and equations of Newton and Euler stand in its own axes, a point's in the world's. Everything
else, any Lagrangian, is differentiated by velocities that are total derivatives of something: for those d/dt(dL/dv) -
dL/ds needs no further terms, however they depend on the coordinates, and d2L/dv2 is local.
"""

from __future__ import annotations

from lagdsl.eliminate.form import AccelerationForm, NotApplicable
from lagdsl.flat.model import FlatModel, RigidBody
from lagdsl.graph.differentiate import adjoints, mask_of
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Group, Op
from lagdsl.graph.substitute import Substitution
from lagdsl.mechanics.carriers import Carrier, is_put, kinetic_energy, place_of, tensor_of
from lagdsl.mechanics.lagrange import Dynamics
from lagdsl.mechanics.lowering import Lowering
from lagdsl.mechanics.own_accelerations import Accelerations, Moving, spread_of
from lagdsl.mechanics.symbols import Directions
from lagdsl.mechanics.vectors import Axes, Vector, cross, scale

_VELOCITY = (Group.QD, Group.RELEASE_RATE)
_HELD = mask_of((Group.P,))
_GIVEN = mask_of((Group.P, Group.TIME))
_HOLONOMIC = mask_of((Group.P, Group.TIME, Group.Q, Group.U, Group.W))


def acceleration_form(lowering: Lowering, flat: FlatModel, found: Dynamics, directions: Directions) -> AccelerationForm:
    """Weights and forces of the whole model; forces that are no inertia stand at the rates."""
    graph = lowering.graph
    builder = _Builder(lowering, flat)
    rest = graph.zero
    for item, carrier in zip((*flat.masses, *flat.bodies), found.energies.carriers, strict=True):
        rest = graph.add(rest, builder.add(item if isinstance(item, RigidBody) else None, carrier))
    signs = {"kinetic": graph.add, "lagrangian": graph.add, "potential": graph.subtract}
    for term in flat.energies:
        if term.kind in signs:
            rest = signs[term.kind](rest, lowering.scalar(term.value))
    builder.add_lagrangian(rest)
    for rate, load, drag in zip(directions.rates, found.terms.load, found.terms.drag, strict=True):
        builder.form.add_force(rate, graph.subtract(load, drag))
    return builder.form


class _Builder:
    def __init__(self, lowering: Lowering, flat: FlatModel) -> None:
        graph = lowering.graph
        self.form = AccelerationForm(graph)
        self._lowering, self._graph = lowering, graph
        zero = (graph.zero, graph.zero, graph.zero)
        self._gravity = lowering.vector(flat.gravity) if flat.gravity is not None else zero
        self._poses = lowering.poses("world")
        self._accelerations = Accelerations(graph, self._poses, lowering.rate, lowering.coasting_rate, self._gravity)

    def add(self, body: RigidBody | None, carrier: Carrier) -> int:
        """One mass or body; what could not be added is given back as a Lagrangian."""
        graph = self._graph
        constant = all(not graph.groups[x] & ~_GIVEN for x in self._gravity)
        moved = list(carrier.position)
        if body is not None:
            moved += [x for axis in self._poses[body.frame].axes for x in axis]
        holonomic = all(not graph.groups[x] & ~_HOLONOMIC for x in moved)
        if not constant or graph.groups[carrier.mass] & ~_HELD or not holonomic:
            return self._lagrangian(carrier)
        if body is None:
            self._add_point(carrier.mass, carrier.position)
            return graph.zero
        com, tensor = place_of(self._lowering, body), tensor_of(self._lowering, body)
        if any(graph.groups[x] & ~_HELD for row in (com, *tensor) for x in row):
            return self._lagrangian(carrier)
        self._add_body(body.frame, carrier, com, tensor)
        return graph.zero

    def _lagrangian(self, carrier: Carrier) -> int:
        graph = self._graph
        height = graph.multiply(carrier.mass, graph.dot(self._gravity, carrier.position))
        return graph.add(kinetic_energy(graph, carrier), height)

    def _add_point(self, mass: int, position: Vector) -> None:
        """m (a - g) in world axes."""
        graph, form = self._graph, self.form
        for component, weight in zip(position, self._gravity, strict=True):
            velocity = self._lowering.rate.of(component)
            bias = graph.subtract(weight, self._lowering.coasting_rate.of(velocity))
            form.add_square(velocity, mass)
            form.add_force(velocity, graph.multiply(mass, bias))

    def _add_body(self, frame: str, carrier: Carrier, com: Vector, tensor: Axes) -> None:
        graph = self._graph
        pose = self._poses[frame]
        if self._poses.is_released(frame):
            raise NotApplicable
        moving = self._accelerations.of(frame)
        omega, velocity = self._poses.own_twist(frame)
        mass = carrier.mass
        if carrier.position == pose.origin and is_put(pose):
            self._add_point(mass, carrier.position)
            mass = graph.zero
        moment = scale(graph, mass, com)
        tensor = _about_origin(graph, mass, com, tensor)
        self._add_inertia(omega, velocity, mass, moment, tensor)
        self._add_newton_euler(omega, velocity, moving, mass, moment, tensor)

    def _add_inertia(self, omega: Vector, velocity: Vector, mass: int, moment: Vector, tensor: Axes) -> None:
        """1/2 m v.v + v . omega x mc + 1/2 omega . I omega."""
        graph, form = self._graph, self.form
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            form.add_square(velocity[i], mass)
            form.add_square(omega[i], tensor[i][i])
            form.add_product(omega[i], omega[j], tensor[i][j])
            form.add_product(omega[i], velocity[k], moment[j])
            form.add_product(omega[i], velocity[j], graph.negate(moment[k]))

    def _add_newton_euler(
        self, omega: Vector, velocity: Vector, moving: Moving, mass: int, moment: Vector, tensor: Axes
    ) -> None:
        """F = m a + U mc and N = vee(U J - (U J)') + mc x a, with J = tr(I)/2 - I, the second moments of mass."""
        graph, form = self._graph, self.form
        spread = spread_of(graph, moving)
        half = graph.constant(0.5)
        trace = graph.multiply(half, graph.add(graph.add(tensor[0][0], tensor[1][1]), tensor[2][2]))
        second = [[graph.subtract(trace if i == j else graph.zero, tensor[i][j]) for j in range(3)] for i in range(3)]
        carried = cross(graph, moment, moving.origin)
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            push = graph.add(graph.multiply(mass, moving.origin[i]), graph.dot(spread[i], moment))
            turn = graph.subtract(graph.dot(spread[k], second[j]), graph.dot(spread[j], second[k]))
            form.add_force(velocity[i], graph.negate(push))
            form.add_force(omega[i], graph.negate(graph.add(turn, carried[i])))

    def add_lagrangian(self, lagrangian: int) -> None:
        """Momenta by velocities that are total derivatives, their rates of change at qdd = 0, and dL/dq without them.

        Symbols stand for the velocities meanwhile, so that simplification does not reach through them.
        """
        graph, form, lowering = self._graph, self.form, self._lowering
        velocities = {graph.symbol(Group.RELEASE_RATE, k): v for k, v in enumerate(self._total_derivatives())}
        apart = Substitution(graph, {velocity: symbol for symbol, velocity in velocities.items()})
        together = Substitution(graph, velocities)
        parts = adjoints(graph, {apart.of(lagrangian): graph.one}, (Group.Q, *_VELOCITY))
        for symbol, part in parts.items():
            value = together.of(part)
            if graph.group(symbol) is Group.Q:
                form.add_force(graph.symbol(Group.QD, graph.b[symbol]), value)
                continue
            velocity = velocities.get(symbol, symbol)
            form.add_force(velocity, graph.negate(lowering.coasting_rate.of(value)))
            for other, weight in adjoints(graph, {part: graph.one}, _VELOCITY).items():
                if other == symbol:
                    form.add_square(velocity, together.of(weight))
                elif other < symbol:
                    form.add_product(velocity, velocities.get(other, other), together.of(weight))

    def _total_derivatives(self) -> list[int]:
        graph = self._graph
        known = self._lowering.rate.known()
        rates = (rate for node, rate in known.items() if not graph.groups[node] & ~_HOLONOMIC)
        bare = (graph.a[rate] if graph.op[rate] is Op.NEGATE else rate for rate in rates)
        moving = (rate for rate in bare if graph.depends(rate, Group.QD) and graph.op[rate] is not Op.SYMBOL)
        return list(dict.fromkeys(moving))


def _about_origin(graph: Graph, mass: int, com: Vector, tensor: Axes) -> Axes:
    """Steiner: I + m (c.c 1 - c c')."""
    square = graph.dot(com, com)

    def entry(i: int, j: int) -> int:
        moved = graph.subtract(square if i == j else graph.zero, graph.multiply(com[i], com[j]))
        return graph.add(tensor[i][j], graph.multiply(mass, moved))

    x, y, z = ((entry(i, 0), entry(i, 1), entry(i, 2)) for i in range(3))
    return (x, y, z)
