"""Declarations of a model, gathered: energies, loads with their points, constraint residuals."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TypeAlias, assert_never

from sympy import Add, Expr, ImmutableDenseMatrix, Integer, Rational, Symbol

from lagdsl.derivation.textbook import geometry
from lagdsl.derivation.textbook.convert import Converter, Mechanical, NotDerivedYetError, plain_number
from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.geometry import Vector
from lagdsl.derivation.textbook.kinematics import RELEASE, RELEASE_RATE
from lagdsl.derivation.textbook.symbols import Symbols, occurring, replaced, symbols
from lagdsl.language.flat.expression import Component, FlatExpression, ForceBalance, RequiredForce
from lagdsl.language.flat.model import (
    FlatModel,
    FrameTorque,
    GeneralizedForce,
    Load,
    PointForce,
    PointMass,
    RateForce,
    RigidBody,
)
from lagdsl.language.flat.traversal import operands

HALF = Rational(1, 2)


@dataclass(frozen=True, slots=True, kw_only=True)
class Inertial:
    """A point mass, or a body seen from its mass centre. `spin` and `tensor` are in the body's own axes."""

    mass: Expr
    position: Vector
    velocity: Vector
    frame: str | None = None
    spin: Vector = geometry.ZERO
    tensor: geometry.Rotation | None = None

    @property
    def kinetic_energy(self) -> Expr:
        translation = HALF * self.mass * geometry.dot(self.velocity, self.velocity)
        if self.tensor is None:
            return translation
        return translation + HALF * geometry.dot(self.spin, geometry.apply(self.tensor, self.spin))


@dataclass(frozen=True, slots=True, kw_only=True)
class AppliedForce:
    """`force` at the place `position`; with `frame` the material point of that frame is displaced."""

    force: Vector
    position: Vector
    frame: str | None


@dataclass(frozen=True, slots=True, kw_only=True)
class AppliedTorque:
    torque: Vector
    frame: str


@dataclass(frozen=True, slots=True, kw_only=True)
class AppliedGeneralizedForce:
    """`value` on the scalar `target`."""

    value: Expr
    target: Expr


@dataclass(frozen=True, slots=True, kw_only=True)
class AppliedRateForce:
    """`value` on the scalar `rate`, which is linear in the rates."""

    value: Expr
    rate: Expr


Applied: TypeAlias = AppliedForce | AppliedTorque | AppliedGeneralizedForce | AppliedRateForce


@dataclass(frozen=True, slots=True, kw_only=True)
class Contributions:
    """Everything that the equations are made of. `extra` are the `lagrangian` terms; `actions` holds, for every load of
    the model, what acts (a load `from` something acts twice)."""

    converter: Converter
    inertials: tuple[Inertial, ...]
    kinetic: Expr
    potential: Expr
    extra: Expr
    dissipation: Expr
    actions: tuple[tuple[Applied, ...], ...]
    residuals: tuple[Expr, ...]
    required: RequiredForces

    @property
    def lagrangian(self) -> Expr:
        return self.kinetic - self.potential + self.extra


def contributions(flat: FlatModel, converter: Converter, loads: Converter | None = None) -> Contributions:
    """Gather; the values of loads (not their places) are converted by `loads` where it is given. From here on both
    convert forces that motions require."""
    required = RequiredForces(flat, converter)
    for each in (converter, loads or converter):
        each.mechanical = each.mechanical or required
    inertial_elements: tuple[PointMass | RigidBody, ...] = (*flat.masses, *flat.bodies)
    inertials = tuple(_inertial(item, converter) for item in inertial_elements)
    declared = {
        kind: [converter.scalar(term.value) for term in flat.energies if term.kind == kind]
        for kind in ("kinetic", "potential", "lagrangian", "dissipation")
    }
    gravity = geometry.ZERO if flat.gravity is None else converter.vector(flat.gravity)
    weights = [-item.mass * geometry.dot(gravity, item.position) for item in inertials]
    parts = Contributions(
        converter=converter,
        inertials=inertials,
        kinetic=Add(*(item.kinetic_energy for item in inertials), *declared["kinetic"]),
        potential=Add(*weights, *declared["potential"]),
        extra=Add(*declared["lagrangian"]),
        dissipation=Add(*declared["dissipation"]),
        actions=tuple(tuple(_applied(load, converter, loads or converter)) for load in flat.loads),
        residuals=(),
        required=required,
    )
    rows = (residual for constraint in flat.constraints for residual in constraint.residuals)
    return replace(parts, residuals=tuple(_residual(row, flat, converter, parts) for row in rows))


def _residual(row: FlatExpression, flat: FlatModel, converter: Converter, parts: Contributions) -> Expr:
    if not isinstance(row, ForceBalance):
        return converter.scalar(row)
    if converter.release is not None or converter.style.held:
        return Integer(0)  # its multiplier is zero, and held rates are for energies
    return force_balance(flat, parts, row)


def force_balance(flat: FlatModel, parts: Contributions, balance: ForceBalance) -> Expr:
    """f of M qdd - J' lam = f along a direction without inertia. Tied coordinates D have the multipliers that
    f_D + J_D' lam = 0 gives."""
    converter, table = parts.converter, parts.converter.symbols
    held = held_rates(flat, table, parts)
    index = {coordinate.name: number for number, coordinate in enumerate(flat.coordinates)}

    def force(name: str) -> Expr:
        q, qd = table.q[index[name]], table.qd[index[name]]
        momentum = converter.rate(partial(parts.lagrangian, qd), bias=True)
        lost = held.partial(held.parts.dissipation, qd)
        return generalized_force(parts, q, qd) + held.partial(held.parts.lagrangian, q) - lost - momentum

    def slope(row: str, name: str) -> Expr:
        constraint = next(each for each in flat.constraints if row in each.rows)
        residual = converter.scalar(constraint.residuals[constraint.rows.index(row)])
        by = table.q if constraint.level == "position" else table.qd
        return partial(residual, by[index[name]])

    found = Add(*(plain_number(weight) * force(name) for name, weight in balance.weights))
    tied, rows = [name for name, _ in balance.ties], [row for _, row in balance.ties]
    if tied:
        matrix = ImmutableDenseMatrix([[slope(row, name) for row in rows] for name in tied])
        multipliers = matrix.LUsolve(ImmutableDenseMatrix([-force(name) for name in tied]))
        leading = [(plain_number(weight), name) for name, weight in balance.weights]
        pull = [Add(*(weight * slope(row, name) for weight, name in leading)) for row in rows]
        found += Add(*(lam * each for lam, each in zip(multipliers, pull, strict=True)))
    return replaced(found, dict.fromkeys(table.qd, Integer(0))) if balance.still else found


@dataclass(frozen=True, slots=True, kw_only=True)
class HeldRates:
    """`parts` of a model with symbols for those rates of states that depend on the motion, and what these are.

    States are functions of time, as prescribed motions are: their equations stand in the place of their rates only
    after the energies have been differentiated by coordinates and rates.
    """

    parts: Contributions
    rates: Mapping[Symbol, Expr]

    def partial(self, expression: Expr, symbol: Symbol) -> Expr:
        """Of an expression made of `parts`."""
        return replaced(partial(expression, symbol), self.rates)


def held_rates(flat: FlatModel, table: Symbols, parts: Contributions) -> HeldRates:
    """For the same contributions; these themselves where no rate of a state depends on the motion."""
    given = parts.converter
    moving = {*table.q, *table.qd, RELEASE, RELEASE_RATE}
    held: dict[Symbol, Symbol] = {}
    for state, symbol in zip(flat.states, table.z, strict=True):
        if symbol in given.rates and moving & occurring(given.rates[symbol]):
            held[symbol] = Symbol(f"der({state.name})")
    if not held:
        return HeldRates(parts=parts, rates={})
    style = replace(given.style, held=held)
    converter = Converter(model=flat, symbols=table, release=given.release, style=style)
    rates = {rate: given.rates[symbol] for symbol, rate in held.items()}
    return HeldRates(parts=contributions(flat, converter), rates=rates)


class RequiredForces:
    """Forces that motions require of the loads: the left sides of Lagrange's equations, with the parts of the motion in
    place of the symbols, as the converter that asks has them."""

    def __init__(self, flat: FlatModel, converter: Converter) -> None:
        self._flat, self._symbols = flat, converter.symbols
        self._style = replace(converter.style, opaque={})
        self._mechanisms: dict[tuple[str, ...], tuple[Symbols, Contributions, HeldRates]] = {}

    def __call__(self, force: Mechanical | Component, asking: Converter) -> Expr:
        """d/dt(dL/dqd) - dL/dq + dD/dqd, of `bias` without D and accelerations. Raises NotDerivedYetError for other
        quantities."""
        if not isinstance(force, RequiredForce):
            raise NotDerivedYetError(type(force).__name__)
        motion = force.motion
        table, parts, held = self._mechanism(tuple(name for name, _ in motion.parameters))
        places = [[each.name for each in self._flat.coordinates].index(name) for name in motion.coordinates]
        q, qd = table.q[places[force.place]], table.qd[places[force.place]]
        bias = motion.function == "bias"
        left = parts.converter.rate(partial(parts.lagrangian, qd), bias=bias) - held.partial(held.parts.lagrangian, q)
        left += 0 if bias else held.partial(held.parts.dissipation, qd)
        own = [group[place] for group in (table.q, table.qd) for place in places]
        own += [table.qdd[place] for place in places] if motion.accelerations else []
        own += [Symbol(name) for name, _ in motion.parameters]
        left = self._style.tidy(left)
        return replaced(left, dict(zip(own, map(asking.scalar, operands(motion)), strict=True)))

    def _mechanism(self, names: tuple[str, ...]) -> tuple[Symbols, Contributions, HeldRates]:
        """Without loads and constraints; parameters of these `names` are symbols, even if they were fixed."""
        if names not in self._mechanisms:
            parameters = tuple(
                replace(p, structural=p.structural and p.name not in names) for p in self._flat.parameters
            )
            model = replace(self._flat, parameters=parameters, loads=(), constraints=())
            table = replace(self._symbols, p=symbols(model).p)
            parts = contributions(model, Converter(model=model, symbols=table, style=self._style))
            self._mechanisms[names] = table, parts, held_rates(model, table, parts)
        return self._mechanisms[names]


def _inertial(item: PointMass | RigidBody, converter: Converter) -> Inertial:
    mass = converter.scalar(item.mass)
    if isinstance(item, PointMass):
        position = converter.vector(item.position)
        return Inertial(mass=mass, position=position, velocity=geometry.each(converter.rate, position))
    pose = converter.kinematics.poses[item.frame]
    com = tuple(converter.scalar(component) for component in item.com)
    xx, yy, zz, xy, xz, yz = (converter.scalar(element) for element in item.inertia)
    position = geometry.add(pose.origin, geometry.apply(pose.rotation, com))
    return Inertial(
        mass=mass,
        position=position,
        velocity=geometry.each(converter.rate, position),
        frame=item.frame,
        spin=converter.kinematics.body_angular_velocity(item.frame),
        tensor=((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)),
    )


def _applied(load: Load, places: Converter, values: Converter) -> list[Applied]:
    match load:
        case PointForce(force=force, point=point, frame=frame, origin=origin, origin_frame=origin_frame):
            vector = values.vector(force)
            actions: list[Applied] = [AppliedForce(force=vector, position=places.vector(point), frame=frame)]
            if origin is not None:
                back = geometry.scale(Integer(-1), vector)
                actions.append(AppliedForce(force=back, position=places.vector(origin), frame=origin_frame))
            return actions
        case FrameTorque(torque=torque, frame=body, origin=other):
            vector = values.vector(torque)
            actions = [AppliedTorque(torque=vector, frame=body)]
            if other is not None:
                actions.append(AppliedTorque(torque=geometry.scale(Integer(-1), vector), frame=other))
            return actions
        case GeneralizedForce(value=value, target=target, origin=opposite):
            scalar = values.scalar(value)
            actions = [AppliedGeneralizedForce(value=scalar, target=places.scalar(target))]
            if opposite is not None:
                actions.append(AppliedGeneralizedForce(value=-scalar, target=places.scalar(opposite)))
            return actions
        case RateForce(value=value, rate=rate):
            return [AppliedRateForce(value=values.scalar(value), rate=places.scalar(rate))]
        case _:
            assert_never(load)


def admissible_variation(action: Applied, converter: Converter, q: Symbol, qd: Symbol) -> Vector | Expr:
    """dr/dq of the place of a force, domega/dqd of a torque, d(target)/dq of a generalized force,
    d(rate)/dqd of one on a rate."""
    match action:
        case AppliedForce(position=position, frame=None):
            return geometry.each(lambda x: partial(x, q), position)
        case AppliedForce(position=position, frame=frame):
            assert frame is not None
            origin = converter.kinematics.poses[frame].origin
            turning = geometry.each(lambda x: partial(x, qd), converter.kinematics.angular_velocity(frame))
            arm = geometry.subtract(position, origin)
            return geometry.add(geometry.each(lambda x: partial(x, q), origin), geometry.cross(turning, arm))
        case AppliedTorque(frame=frame):
            return geometry.each(lambda x: partial(x, qd), converter.kinematics.angular_velocity(frame))
        case AppliedGeneralizedForce(target=target):
            return partial(target, q)
        case AppliedRateForce(rate=rate):
            return partial(rate, qd)
        case _:
            assert_never(action)


def work(action: Applied, variation: Vector | Expr) -> Expr:
    """F . dr/dq of one action."""
    match action:
        case AppliedForce(force=vector) | AppliedTorque(torque=vector):
            assert isinstance(variation, tuple)
            return geometry.dot(vector, variation)
        case AppliedGeneralizedForce(value=value) | AppliedRateForce(value=value):
            return value * variation
        case _:
            assert_never(action)


def generalized_force(parts: Contributions, q: Symbol, qd: Symbol) -> Expr:
    """Q of one coordinate: the sum of F . dr/dq over all declared loads."""
    return Add(
        *(
            work(action, admissible_variation(action, parts.converter, q, qd))
            for actions in parts.actions
            for action in actions
        )
    )
