"""Flat models by hand: a few short names for expressions, and a model with everything empty that is not given."""

from __future__ import annotations

from typing import Any

from lagdsl.foundation.source import SourceFile, Span
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm

FILE = SourceFile("hand.lag", "".join(f"item {i}\n" for i in range(1, 40)))


def at_line(line: int) -> tuple[Span, ...]:
    start = FILE.line_starts[line - 1]
    return (Span(FILE, start, start + 4),)


def num(value: float) -> fx.FlatExpression:
    return fx.Number(float(value))


def var(name: str) -> fx.FlatExpression:
    return fx.Variable(name)


def der(operand: fx.FlatExpression) -> fx.FlatExpression:
    return fx.Derivative(operand)


def op(operator: Any, left: fx.FlatExpression, right: fx.FlatExpression) -> fx.FlatExpression:
    return fx.Binary(operator, left, right)


def times(*factors: fx.FlatExpression) -> fx.FlatExpression:
    product, *rest = factors
    for factor in rest:
        product = op("*", product, factor)
    return product


def plus(*terms: fx.FlatExpression) -> fx.FlatExpression:
    total, *rest = terms
    for term in rest:
        total = op("+", total, term)
    return total


def square(operand: fx.FlatExpression) -> fx.FlatExpression:
    return op("^", operand, num(2))


def call(name: str, *arguments: fx.FlatExpression) -> fx.FlatExpression:
    return fx.Function(name, arguments)


def sin(x: fx.FlatExpression) -> fx.FlatExpression:
    return call("sin", x)


def cos(x: fx.FlatExpression) -> fx.FlatExpression:
    return call("cos", x)


def vec(x: fx.FlatExpression, y: fx.FlatExpression, z: fx.FlatExpression = fx.ZERO) -> fx.FlatExpression:
    return fx.Vector(x, y, z)


def parameter(name: str, value: float = 1.0, **more: Any) -> fm.Parameter:
    return fm.Parameter(name=name, value=value, dimension=DIMENSIONLESS, spans=at_line(1), **more)


def coordinate(name: str, line: int = 2, start: float = 0.3, **more: Any) -> fm.Coordinate:
    given: dict[str, Any] = {
        "dimension": DIMENSIONLESS,
        "start": num(start),
        "start_explicit": True,
        "fixed": False,
        "rate_start": fx.ZERO,
        "rate_start_explicit": False,
        "rate_fixed": False,
    }
    return fm.Coordinate(name=name, spans=at_line(line), **{**given, **more})


def definition(name: str, value: fx.FlatExpression) -> fm.Definition:
    return fm.Definition(
        name=name, value=value, dimension=DIMENSIONLESS, variability=fm.Variability.CONTINUOUS, spans=at_line(3)
    )


def point(name: str, position: fx.FlatExpression) -> fm.Point:
    return fm.Point(name=name, position=position, spans=at_line(4))


def frame(name: str, parent: str, *steps: fm.FrameStep) -> fm.Frame:
    return fm.Frame(name=name, parent=parent, steps=steps, spans=at_line(4))


def energy(kind: Any, value: fx.FlatExpression, line: int = 5, label: str | None = None) -> fm.EnergyTerm:
    return fm.EnergyTerm(kind=kind, label=label, value=value, spans=at_line(line))


def mass(value: fx.FlatExpression, position: fx.FlatExpression, line: int = 6) -> fm.PointMass:
    return fm.PointMass(mass=value, position=position, spans=at_line(line))


def body(on: str, m: fx.FlatExpression, inertia: tuple[fx.FlatExpression, ...], **more: Any) -> fm.RigidBody:
    six: Any = inertia + (fx.ZERO,) * (6 - len(inertia))
    given: dict[str, Any] = {"label": "plate", "com": (fx.ZERO,) * 3, "spans": at_line(7)}
    return fm.RigidBody(frame=on, mass=m, inertia=six, **{**given, **more})


def invariant(name: str, value: fx.FlatExpression, tolerance: float | None = None) -> fm.Invariant:
    return fm.Invariant(name=name, value=value, dimension=ENERGY, tolerance=tolerance, spans=at_line(9))


def model(**parts: Any) -> fm.FlatModel:
    lists = (
        "parameters coordinates states inputs named energies masses bodies loads constraints outputs invariants "
        "assertions initial_equations drawings"
    )
    empty: dict[str, Any] = dict.fromkeys(lists.split(), ())
    given: dict[str, Any] = {
        "name": "Hand",
        "doc": None,
        "gravity": None,
        "gravity_span": at_line(8)[0],
        "experiment": fm.Experiment(),
    }
    return fm.FlatModel(**{**empty, **given, **parts})
