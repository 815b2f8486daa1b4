"""The acceleration form of a model: what its masses, bodies and energies weigh, velocity by velocity.

A rigid body's inertia and equations of Newton and Euler stand in its own axes, a point's in the world's. Everything
else, any Lagrangian, is differentiated by the velocities that it is written in (`lagrangian_form`).
"""

from __future__ import annotations

from functools import partial

from lagdsl.algebra.eliminate.form import AccelerationForm, NotApplicable
from lagdsl.algebra.graph.differentiate import mask_of
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.identity import identical
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.kinematics.body_frame_accelerations import Accelerations, FrameAcceleration, spread_of
from lagdsl.derivation.mechanics.kinematics.vectors import Axes, Vector, cross, scale
from lagdsl.derivation.mechanics.lagrange.body_recognition import recognized_bodies
from lagdsl.derivation.mechanics.lagrange.gravity_recognition import Heights
from lagdsl.derivation.mechanics.lagrange.inertial_elements import (
    InertialElement,
    is_in_world,
    kinetic_energy,
    place_of,
    tensor_of,
)
from lagdsl.derivation.mechanics.lagrange.lagrange import Dynamics
from lagdsl.derivation.mechanics.lagrange.lagrangian_form import Apart, add_lagrangian
from lagdsl.derivation.mechanics.lagrange.terms import terms_of
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import Directions
from lagdsl.language.flat.model import FlatModel, RigidBody

_HELD = mask_of((Group.P,))
_GIVEN = mask_of((Group.P, Group.TIME))
_HOLONOMIC = mask_of((Group.P, Group.TIME, Group.Q, Group.U, Group.W))


def acceleration_form(lowering: Lowering, flat: FlatModel, found: Dynamics, directions: Directions) -> AccelerationForm:
    """Weights and forces of the whole model; forces that are no inertia stand at the rates."""
    graph = lowering.graph
    builder = _Builder(lowering, flat)
    rest = graph.zero
    for item, carrier in zip((*flat.masses, *flat.bodies), found.energies.inertial_elements, strict=True):
        rest = graph.add(rest, builder.add(item if isinstance(item, RigidBody) else None, carrier))
    signs = {"kinetic": graph.add, "lagrangian": graph.add, "potential": graph.subtract}
    for term in flat.energies:
        if term.kind in signs:
            rest = signs[term.kind](rest, lowering.scalar(term.value))
    apart = Apart(lowering)
    add_lagrangian(builder.form, lowering, apart, builder.add_typed_bodies(apart, apart.of(rest)), found.gradients)
    terms = found.terms
    for rate, load, drag, more in zip(directions.rates, terms.load, terms.drag, terms.by_states, strict=True):
        builder.form.add_force(rate, graph.subtract(graph.subtract(load, drag), more))
    return builder.form


class _Builder:
    def __init__(self, lowering: Lowering, flat: FlatModel) -> None:
        graph = lowering.graph
        self.form = AccelerationForm(graph)
        self._lowering, self._graph = lowering, graph
        zero = (graph.zero, graph.zero, graph.zero)
        self._gravity = lowering.vector(flat.gravity) if flat.gravity is not None else zero
        self._poses = lowering.poses("world")
        rates = (lowering.rate, lowering.bias_rate)
        self._accelerations = Accelerations(graph, self._poses, *rates, self._gravity)
        self._under: dict[Vector, Accelerations] = {self._gravity: self._accelerations}

    def add(self, body: RigidBody | None, carrier: InertialElement) -> int:
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
            self._add_mass(carrier)
            return graph.zero
        com, tensor = place_of(self._lowering, body), tensor_of(self._lowering, body)
        if any(graph.groups[x] & ~_HELD for row in (com, *tensor) for x in row):
            return self._lagrangian(carrier)
        self._add_body(body.frame, carrier, com, tensor)
        return graph.zero

    def _lagrangian(self, carrier: InertialElement) -> int:
        graph = self._graph
        height = graph.multiply(carrier.mass, graph.dot(self._gravity, carrier.position))
        return graph.add(kinetic_energy(graph, carrier), height)

    def _add_mass(self, carrier: InertialElement) -> None:
        """In the axes of the frame that carries it, where one does: at a fixed place like a body, else by itself."""
        graph, mass = self._graph, carrier.mass
        own = self._lowering.own.places.get(carrier.position)
        if own is None or not self._poses.is_carried(own[0]):
            self._add_point(mass, carrier.position)
            return
        frame, place = own
        moving = self._accelerations.of(frame)
        if all(not graph.groups[x] & ~_HELD for x in place):
            zero = (graph.zero, graph.zero, graph.zero)
            tensor = about_origin(graph, mass, place, (zero, zero, zero))
            self._add_rigid(frame, moving, mass, scale(graph, mass, place), tensor)
            return
        for velocity, acceleration in zip(carrier.velocity, self._accelerations.shifted(moving, place), strict=True):
            self.form.add_square(velocity, mass)
            self.form.add_force(velocity, graph.negate(graph.multiply(mass, acceleration)))

    def _add_point(self, mass: int, position: Vector) -> None:
        """m (a - g) in world axes."""
        graph, form = self._graph, self.form
        for component, weight in zip(position, self._gravity, strict=True):
            velocity = self._lowering.rate.of(component)
            bias = graph.subtract(weight, self._lowering.bias_rate.of(velocity))
            form.add_square(velocity, mass)
            form.add_force(velocity, graph.multiply(mass, bias))

    def _add_body(self, frame: str, carrier: InertialElement, com: Vector, tensor: Axes) -> None:
        graph = self._graph
        if self._poses.is_released(frame):
            raise NotApplicable
        moving = self._accelerations.of(frame)
        mass = carrier.mass
        if is_in_world(self._lowering, frame, carrier.position):
            self._add_point(mass, carrier.position)
            mass = graph.zero
        self._add_rigid(frame, moving, mass, scale(graph, mass, com), about_origin(graph, mass, com, tensor))

    def add_typed_bodies(self, apart: Apart, lagrangian: int) -> int:
        """Bodies typed as energies, with their weights; what is no body is given back."""
        graph = self._graph
        if not apart.twists or lagrangian == graph.zero:
            return lagrangian
        heights = Heights(self._lowering)
        bodies, rest = recognized_bodies(apart, terms_of(graph, heights.apart(lagrangian)))
        if not bodies:
            return lagrangian
        hanging, rest = heights.hang(bodies, rest)
        for body, gravity in hanging:
            moving = self._accelerations_under(gravity).of(body.frame)
            self._add_rigid(body.frame, moving, body.mass, body.moment, body.tensor)
        return heights.together(graph.sum(graph.multiply(term.weight, term.node) for term in rest))

    def _accelerations_under(self, wanted: Vector) -> Accelerations:
        """By a gravity that depends on parameters only."""
        graph = self._graph
        for known, accelerations in self._under.items():
            held = all(not graph.groups[x] & ~_HELD for x in known)
            if known == wanted or (held and all(map(partial(identical, graph), known, wanted))):
                return accelerations
        lowering = self._lowering
        made = Accelerations(graph, self._poses, lowering.rate, lowering.bias_rate, wanted)
        self._under[wanted] = made
        return made

    def _add_rigid(self, frame: str, moving: FrameAcceleration, mass: int, moment: Vector, tensor: Axes) -> None:
        """`moment` and `tensor` about the origin of the frame."""
        omega, velocity = self._poses.own_twist(frame)
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
        self, omega: Vector, velocity: Vector, moving: FrameAcceleration, mass: int, moment: Vector, tensor: Axes
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


def about_origin(graph: Graph, mass: int, com: Vector, tensor: Axes) -> Axes:
    """Steiner: I + m (c.c 1 - c c')."""
    square = graph.dot(com, com)

    def entry(i: int, j: int) -> int:
        moved = graph.subtract(square if i == j else graph.zero, graph.multiply(com[i], com[j]))
        return graph.add(tensor[i][j], graph.multiply(mass, moved))

    x, y, z = ((entry(i, 0), entry(i, 1), entry(i, 2)) for i in range(3))
    return (x, y, z)
