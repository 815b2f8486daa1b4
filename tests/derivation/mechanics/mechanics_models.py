"""Flat models for the tests of the mechanics, written in a short notation that Python's own parser reads."""

from __future__ import annotations

import ast
from typing import Any

import numpy as np
from derived_programs import derive

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import SIGNATURES
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import (
    Assertion,
    Constraint,
    Coordinate,
    Definition,
    EnergyTerm,
    Experiment,
    FlatModel,
    Frame,
    FrameStep,
    FrameTorque,
    GeneralizedForce,
    InitialEquation,
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

SPANS = (Span(SourceFile("model.lag", "model M end;"), 0, 5),)
_OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "^"}
_RELATIONS = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "<>"}
_AXES = {"x": 0, "y": 1, "z": 2}


def expression(text: str | float | FlatExpression) -> FlatExpression:
    """`F.x` is an axis, `F.origin` an origin, `a @ b` a scalar product, `{...}` is `v(x, y, z)`, `p(P)` a point."""
    if not isinstance(text, str):
        return flat.Number(float(text)) if isinstance(text, int | float) else text
    return _convert(ast.parse(text.replace("^", "**"), mode="eval").body)


def _convert(node: ast.expr) -> FlatExpression:
    match node:
        case ast.Constant(value):
            return flat.Number(float(value))
        case ast.Name(name):
            return flat.Variable(name)
        case ast.Attribute(ast.Name(frame), "origin"):
            return flat.FrameOrigin(frame)
        case ast.Attribute(ast.Name(frame), axis):
            return flat.FrameAxis(frame, _AXES[axis])
        case ast.Call(ast.Name(name), arguments):
            return _call(name, arguments) or _request(name, arguments)
        case _:
            return _operator(node)


def _operator(node: ast.expr) -> FlatExpression:
    match node:
        case ast.UnaryOp(ast.USub(), operand):
            return flat.Unary("-", _convert(operand))
        case ast.UnaryOp(ast.Not(), operand):
            return flat.Unary("not", _convert(operand))
        case ast.BinOp(left, ast.MatMult(), right):
            return flat.Dot(_convert(left), _convert(right))
        case ast.BinOp(left, operator, right):
            return flat.Binary(_OPERATORS[type(operator)], _convert(left), _convert(right))
        case ast.BoolOp(operator, values):
            name = "and" if isinstance(operator, ast.And) else "or"
            result = _convert(values[0])
            for value in values[1:]:
                result = flat.Binary(name, result, _convert(value))
            return result
        case ast.Compare(left, [operator], [right]):
            return flat.Binary(_RELATIONS[type(operator)], _convert(left), _convert(right))
        case ast.IfExp(test, body, orelse):
            return flat.Conditional(_convert(test), _convert(body), _convert(orelse))
    raise AssertionError(ast.dump(node))


def _call(name: str, arguments: list[ast.expr]) -> FlatExpression | None:
    first = arguments[0].id if arguments and isinstance(arguments[0], ast.Name) else ""
    match name:
        case "der":
            return flat.Derivative(_convert(arguments[0]))
        case "v":
            return flat.Vector(*map(_convert, arguments))
        case "p":
            return flat.PointReference(first)
        case "component":
            return flat.Component(_convert(arguments[0]), int(_convert(arguments[1]).value))  # type: ignore[union-attr]
        case "norm":
            return flat.Norm(_convert(arguments[0]), "norm")
        case "cross":
            return flat.Cross(*map(_convert, arguments))
        case "omega":
            return flat.AngularVelocity(first)
        case "velocity":
            return flat.MaterialVelocity(_convert(arguments[0]), arguments[1].id)  # type: ignore[attr-defined]
    if name in flat.FUNCTIONS:
        return flat.Function(name, tuple(map(_convert, arguments)))
    return None


def _request(name: str, arguments: list[ast.expr]) -> FlatExpression:
    """A quantity of the mechanics."""
    first = arguments[0].id if arguments and isinstance(arguments[0], ast.Name) else ""
    match name:
        case "multiplier":
            return flat.Multiplier(first)
        case "reaction_force" | "reaction_torque":
            return flat.FrameReaction(first, name.removeprefix("reaction_"))  # type: ignore[arg-type]
        case "along":
            return flat.ReactionAlong(first, _convert(arguments[1]))
        case "energy":
            return flat.SystemEnergy(first or "total")  # type: ignore[arg-type]
        case "momentum":
            return flat.GeneralizedMomentum(first)
        case "linear_momentum":
            return flat.LinearMomentum()
        case "angular_momentum":
            return flat.AngularMomentum(None if first == "everything" else first, _convert(arguments[1]))
    raise AssertionError(name)


def _quantity(name: str) -> dict[str, Any]:
    return {"spans": SPANS, "name": name, "dimension": DIMENSIONLESS}


def coordinate(name: str, start: Any = 0.0, rate_start: Any = 0.0) -> Coordinate:
    return Coordinate(
        **_quantity(name),
        start=expression(start),
        start_explicit=True,
        fixed=False,
        rate_start=expression(rate_start),
        rate_start_explicit=True,
        rate_fixed=False,
    )


def definition(name: str, value: Any) -> Definition:
    return Definition(**_quantity(name), value=expression(value), variability=Variability.CONTINUOUS)


def state(name: str, derivative: Any, start: Any = 0.0) -> State:
    return State(
        **_quantity(name),
        start=expression(start),
        start_explicit=True,
        fixed=True,
        derivative=expression(derivative),
    )


def point(name: str, position: Any) -> Point:
    return Point(spans=SPANS, name=name, position=expression(position))


def frame(name: str, parent: str, *steps: FrameStep) -> Frame:
    return Frame(spans=SPANS, name=name, parent=parent, steps=steps)


def energy(kind: Any, value: Any) -> EnergyTerm:
    return EnergyTerm(spans=SPANS, kind=kind, label=None, value=expression(value))


def mass(m: Any, position: Any) -> PointMass:
    return PointMass(spans=SPANS, mass=expression(m), position=expression(position))


def triple(values: Any) -> Any:
    return tuple(expression(value) for value in values)


def body(on: str, m: Any = 0.0, com: Any = (0, 0, 0), inertia: Any = (0,) * 6, label: str | None = None) -> RigidBody:
    return RigidBody(spans=SPANS, label=label, frame=on, mass=expression(m), com=triple(com), inertia=triple(inertia))


def force(
    value: Any, at: Any, on: str | None = None, origin: Any = None, origin_frame: str | None = None
) -> PointForce:
    return PointForce(
        spans=SPANS,
        label=None,
        force=expression(value),
        point=expression(at),
        frame=on,
        origin=None if origin is None else expression(origin),
        origin_frame=origin_frame,
    )


def torque(value: Any, on: str, origin: str | None = None) -> FrameTorque:
    return FrameTorque(spans=SPANS, label=None, torque=expression(value), frame=on, origin=origin)


def drive(value: Any, target: Any, origin: Any = None) -> GeneralizedForce:
    return GeneralizedForce(
        spans=SPANS,
        label=None,
        keyword="force",
        value=expression(value),
        target=expression(target),
        origin=None if origin is None else expression(origin),
    )


def constraint(name: str, *residuals: Any, level: Any = "position") -> Constraint:
    rows = (name,) if len(residuals) == 1 else tuple(f"{name}[{k + 1}]" for k in range(len(residuals)))
    return Constraint(
        spans=SPANS, name=name, rows=rows, residuals=triple(residuals), dimension=DIMENSIONLESS, level=level
    )


_LISTS = (
    "parameters",
    "coordinates",
    "states",
    "inputs",
    "named",
    "energies",
    "masses",
    "bodies",
    "loads",
    "constraints",
    "outputs",
    "invariants",
    "assertions",
    "initial_equations",
    "drawings",
)


def model(**parts: Any) -> FlatModel:
    """Parts of a FlatModel; parameters, outputs and invariants may be given as dictionaries name to value."""
    given = {
        **dict.fromkeys(_LISTS, ()),
        "name": "M",
        "doc": None,
        "gravity": None,
        "experiment": Experiment(),
        **parts,
    }
    if isinstance(given["parameters"], dict):
        given["parameters"] = tuple(Parameter(**_quantity(n), value=v) for n, v in given["parameters"].items())
    if isinstance(given["outputs"], dict):
        given["outputs"] = tuple(Output(**_quantity(n), value=expression(e)) for n, e in given["outputs"].items())
    if isinstance(given["invariants"], dict):
        given["invariants"] = tuple(
            Invariant(spans=SPANS, name=n, value=expression(e), dimension=DIMENSIONLESS, tolerance=None)
            for n, e in given["invariants"].items()
        )
    given["coordinates"] = tuple(coordinate(c) if isinstance(c, str) else c for c in given["coordinates"])
    given["inputs"] = tuple(
        Input(**_quantity(name), default=flat.ZERO, derivative_of=derivative_of)
        for name, derivative_of in given["inputs"]
    )
    given["assertions"] = tuple(
        Assertion(spans=SPANS, condition=expression(e), message="broken") for e in given["assertions"]
    )
    given["initial_equations"] = tuple(
        InitialEquation(spans=SPANS, residual=expression(e), dimension=DIMENSIONLESS)
        for e in given["initial_equations"]
    )
    if given["gravity"] is not None:
        given["gravity"] = expression(given["gravity"])
    return FlatModel(**given)


_SHORT = {
    "t": Group.TIME,
    "q": Group.Q,
    "qd": Group.QD,
    "z": Group.Z,
    "u": Group.U,
    "qdd": Group.QDD,
    "lam": Group.LAMBDA,
    "dq": Group.DIRECTION_Q,
    "dqd": Group.DIRECTION_QD,
    "dz": Group.DIRECTION_Z,
    "du": Group.DIRECTION_U,
    "dp": Group.DIRECTION_P,
    "dqdd": Group.DIRECTION_QDD,
    "dlam": Group.DIRECTION_LAMBDA,
}


def run(program: Program, function: str, **arguments: Any) -> tuple[np.ndarray, ...]:
    """Result blocks of a function by the evaluator; what is not given is zero, `p` the default."""
    layout = program.layout
    symbols: dict[Group, Any] = {group: np.zeros(layout.size(group)) for group in SIGNATURES[function]}
    symbols[Group.TIME] = arguments.pop("t", 0.0)
    symbols[Group.P] = np.array(arguments.pop("p", layout.defaults))
    symbols |= {_SHORT[name]: np.asarray(value) for name, value in arguments.items()}
    results = []
    for block in program.function(function).results:
        values = evaluate(program.graph, block.elements, symbols)
        results.append(np.array(values).reshape(block.shape))
    return tuple(results)


def accelerations(program: Program, **state_: Any) -> tuple[np.ndarray, np.ndarray]:
    """qdd and lambda of a regular system."""
    m, f, j, gamma = run(program, "dynamics", **state_)
    n, c = len(f), len(gamma)
    system = np.block([[m, -j.T], [j, np.zeros((c, c))]])
    solution = np.linalg.solve(system, np.concatenate([f, gamma]))
    return solution[:n], solution[n:]


def output(flat_model: FlatModel, *, program: Program | None = None, **state_: Any) -> np.ndarray:
    """Outputs at the solved accelerations."""
    program = program or derive(flat_model)
    qdd, lam = accelerations(program, **state_)
    return run(program, "output", qdd=qdd, lam=lam, **state_)[0]
