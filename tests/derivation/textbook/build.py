"""Flat models by hand: operators on flat expressions, and a model with everything empty that is not given."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.model import (
    Constraint,
    Coordinate,
    Definition,
    EnergyTerm,
    Experiment,
    FlatModel,
    Frame,
    FrameTorque,
    GeneralizedForce,
    Input,
    Invariant,
    Output,
    Parameter,
    Point,
    PointForce,
    PointMass,
    RigidBody,
    State,
)
from lagdsl.language.flat.quantity import Variability


@dataclass(frozen=True)
class X:
    """A scalar flat expression with Python's operators."""

    e: fx.FlatExpression

    def _binary(self, operator: Any, other: Any, swap: bool = False) -> X:
        pair = (flat(other), self.e) if swap else (self.e, flat(other))
        return X(fx.Binary(operator, *pair))

    def __add__(self, other: Any) -> X:
        return self._binary("+", other)

    def __radd__(self, other: Any) -> X:
        return self._binary("+", other, True)

    def __sub__(self, other: Any) -> X:
        return self._binary("-", other)

    def __rsub__(self, other: Any) -> X:
        return self._binary("-", other, True)

    def __mul__(self, other: Any) -> X:
        return self._binary("*", other)

    def __rmul__(self, other: Any) -> X:
        return self._binary("*", other, True)

    def __truediv__(self, other: Any) -> X:
        return self._binary("/", other)

    def __rtruediv__(self, other: Any) -> X:
        return self._binary("/", other, True)

    def __pow__(self, other: Any) -> X:
        return self._binary("^", other)

    def __neg__(self) -> X:
        return X(fx.Unary("-", self.e))


def flat(value: Any) -> fx.FlatExpression:
    if isinstance(value, X):
        return value.e
    return fx.Number(float(value)) if isinstance(value, int | float) else value


def v(name: str) -> X:
    return X(fx.Variable(name))


def der(value: Any) -> X:
    return X(fx.Derivative(flat(value)))


def call(name: str, *arguments: Any) -> X:
    return X(fx.Function(name, tuple(flat(argument) for argument in arguments)))


def sin(x: Any) -> X:
    return call("sin", x)


def cos(x: Any) -> X:
    return call("cos", x)


def vec(x: Any, y: Any, z: Any = 0) -> X:
    return X(fx.Vector(flat(x), flat(y), flat(z)))


def at(point: str) -> X:
    return X(fx.PointReference(point))


def axis(frame: str, index: int) -> X:
    return X(fx.FrameAxis(frame, index))


def dot(a: Any, b: Any) -> X:
    return X(fx.Dot(flat(a), flat(b)))


def cross(a: Any, b: Any) -> X:
    return X(fx.Cross(flat(a), flat(b)))


def coordinate(name: str, start: float = 0.1, rate: float = 0.0) -> Coordinate:
    return Coordinate(
        name=name,
        dimension=DIMENSIONLESS,
        start=fx.Number(start),
        start_explicit=True,
        fixed=False,
        rate_start=fx.Number(rate),
        rate_start_explicit=False,
        rate_fixed=False,
        spans=(),
    )


def parameter(name: str, value: float, **options: Any) -> Parameter:
    return Parameter(name=name, dimension=DIMENSIONLESS, value=value, spans=(), **options)


def point(name: str, position: Any) -> Point:
    return Point(name=name, position=flat(position), spans=())


def frame(name: str, parent: str, *steps: Any) -> Frame:
    return Frame(name=name, parent=parent, steps=steps, spans=())


def mass(m: Any, position: Any) -> PointMass:
    return PointMass(mass=flat(m), position=flat(position), spans=())


def body(frame: str, m: Any, com: Any, inertia: Any, label: str | None = "b") -> RigidBody:
    return RigidBody(
        label=label,
        frame=frame,
        mass=flat(m),
        com=tuple(flat(x) for x in com),
        inertia=tuple(flat(x) for x in inertia),
        spans=(),
    )


def energy(kind: Any, value: Any) -> EnergyTerm:
    return EnergyTerm(kind=kind, label=None, value=flat(value), spans=())


def output(name: str, value: Any) -> Output:
    return Output(name=name, dimension=DIMENSIONLESS, value=flat(value), spans=())


def constraint(name: str, *residuals: Any, level: Any = "position") -> Constraint:
    rows = (name,) if len(residuals) == 1 else tuple(f"{name}[{i + 1}]" for i in range(len(residuals)))
    return Constraint(
        name=name,
        rows=rows,
        residuals=tuple(flat(r) for r in residuals),
        dimension=DIMENSIONLESS,
        level=level,
        spans=(),
    )


def model(name: str, **parts: Any) -> FlatModel:
    lists = (
        "parameters coordinates states inputs named energies masses bodies loads constraints outputs invariants "
        "assertions initial_equations drawings"
    )
    empty: dict[str, Any] = dict.fromkeys(lists.split(" "), ())
    given = {key: tuple(value) if isinstance(value, list) else value for key, value in parts.items()}
    gravity = given.pop("gravity", None)
    return FlatModel(
        name=name,
        doc=given.pop("doc", None),
        gravity=None if gravity is None else flat(gravity),
        experiment=Experiment(),
        **{**empty, **given},
    )


def gravity_along_minus(index: int) -> X:
    components = [fx.Number(0.0)] * 3
    components[index] = fx.Number(-9.80665)
    return vec(*components)


def generalized(value: Any, target: Any, origin: Any = None, label: str | None = None) -> GeneralizedForce:
    return GeneralizedForce(
        label=label,
        keyword="force",
        value=flat(value),
        target=flat(target),
        origin=None if origin is None else flat(origin),
        spans=(),
    )


def force(
    vector: Any, point: Any, frame: str | None = None, origin: Any = None, origin_frame: str | None = None
) -> PointForce:
    return PointForce(
        label=None,
        force=flat(vector),
        point=flat(point),
        frame=frame,
        origin=None if origin is None else flat(origin),
        origin_frame=origin_frame,
        spans=(),
    )


def torque(vector: Any, frame: str, origin: str | None = None) -> FrameTorque:
    return FrameTorque(label=None, torque=flat(vector), frame=frame, origin=origin, spans=())


def definition(name: str, value: Any, variability: Variability = Variability.CONTINUOUS) -> Definition:
    return Definition(name=name, dimension=DIMENSIONLESS, value=flat(value), variability=variability, spans=())


def state(name: str, derivative: Any, start: float = 0.2) -> State:
    return State(
        name=name,
        dimension=DIMENSIONLESS,
        start=fx.Number(start),
        start_explicit=True,
        fixed=True,
        derivative=flat(derivative),
        spans=(),
    )


def external(name: str, derivative_of: str | None = None, smooth: int = 0) -> Input:
    return Input(
        name=name,
        dimension=DIMENSIONLESS,
        default=fx.Number(0.0),
        smooth=smooth,
        derivative_of=derivative_of,
        spans=(),
    )


def invariant(name: str, value: Any) -> Invariant:
    return Invariant(name=name, value=flat(value), dimension=DIMENSIONLESS, tolerance=None, spans=())


def when(condition: Any, value: Any, otherwise: Any) -> X:
    return X(fx.Conditional(flat(condition), flat(value), flat(otherwise)))


def less(a: Any, b: Any) -> X:
    return X(fx.Binary("<", flat(a), flat(b)))
