"""Flat models by hand that between them hold every kind of item and expression."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from lagdsl.derivation.textbook.recipe import Recipe, recipe
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.model import (
    Assertion,
    FlatModel,
    InitialEquation,
    Move,
    Place,
    Rotate,
    RotateAbout,
    RotateQuaternion,
    SetAxes,
)
from lagdsl.language.flat.quantity import Variability
from textbook.build import (
    X,
    at,
    axis,
    body,
    call,
    constraint,
    coordinate,
    cos,
    cross,
    definition,
    der,
    dot,
    energy,
    external,
    force,
    frame,
    generalized,
    gravity_along_minus,
    invariant,
    less,
    mass,
    model,
    output,
    parameter,
    point,
    sin,
    state,
    torque,
    v,
    vec,
    when,
)


@cache
def recipe_of(make: Callable[[], FlatModel]) -> Recipe:
    """Made once for all tests of a run that read it."""
    return recipe(make())


def parameters(*names: str) -> list:
    return [parameter(name, 1.0 + 0.25 * index) for index, name in enumerate(names)]


def pendulum() -> FlatModel:
    theta = v("theta")
    return model(
        "Pendulum",
        doc="Point mass on a massless rod",
        parameters=[parameter("m", 1.0), parameter("l", 0.5)],
        coordinates=[coordinate("theta", 1.0)],
        gravity=gravity_along_minus(1),
        masses=[mass(v("m"), vec(v("l") * sin(theta), -(v("l") * cos(theta))))],
        invariants=[invariant("E", fx.SystemEnergy("total"))],
    )


def cart_pendulum() -> FlatModel:
    return model(
        "CartPendulum",
        parameters=parameters("M", "m", "l", "c", "k"),
        coordinates=[coordinate("x"), coordinate("theta")],
        inputs=[external("u")],
        gravity=gravity_along_minus(1),
        named=[point("P", vec(v("x") + v("l") * sin(v("theta")), -(v("l") * cos(v("theta")))))],
        masses=[mass(v("M"), vec(v("x"), 0)), mass(v("m"), at("P"))],
        energies=[energy("potential", v("k") * v("x") ** 2 / 2), energy("dissipation", v("c") * der(v("x")) ** 2 / 2)],
        loads=[generalized(v("u"), v("x"))],
        outputs=[output("ax", der(der(v("x")))), output("p", fx.GeneralizedMomentum("theta"))],
    )


def hoop() -> FlatModel:
    theta = v("theta")
    return model(
        "BeadOnHoop",
        parameters=parameters("m", "R", "Omega"),
        coordinates=[coordinate("theta")],
        gravity=gravity_along_minus(1),
        named=[
            frame("hoop", "world", Rotate(1, (v("Omega") * v("time")).e)),
            point("P", v("R") * (sin(theta) * axis("hoop", 0) - cos(theta) * axis("hoop", 1))),
        ],
        masses=[mass(v("m"), at("P"))],
        outputs=[
            output("N_out", fx.ReactionAlong("P", axis("hoop", 2).e)),
            output("N_rad", fx.ReactionAlong("P", (-(at("P") / X(fx.Norm(at("P").e, "P")))).e)),
        ],
        invariants=[invariant("jacobi", fx.SystemEnergy("jacobi"))],
    )


def spherical_pendulum() -> FlatModel:
    theta, phi = v("theta"), v("phi")
    return model(
        "SphericalPendulum",
        parameters=parameters("m", "l"),
        coordinates=[coordinate("theta", 0.7), coordinate("phi")],
        gravity=gravity_along_minus(2),
        masses=[
            mass(v("m"), vec(v("l") * sin(theta) * cos(phi), v("l") * sin(theta) * sin(phi), -(v("l") * cos(theta))))
        ],
    )


def atwood() -> FlatModel:
    return model(
        "Atwood",
        parameters=parameters("m1", "m2"),
        coordinates=[coordinate("y1"), coordinate("y2")],
        gravity=gravity_along_minus(1),
        masses=[mass(v("m1"), vec(0, v("y1"))), mass(v("m2"), vec(1, v("y2")))],
        constraints=[constraint("rope", v("y1") + v("y2"))],
        outputs=[output("tension", fx.Multiplier("rope"))],
    )


def rolling_coin() -> FlatModel:
    slip = der(at("C")) + cross(X(fx.AngularVelocity("coin")), -(v("R") * axis("disc", 2)))
    m, r = v("m"), v("R")
    return model(
        "RollingCoin",
        parameters=parameters("m", "R"),
        coordinates=[coordinate(name) for name in ("x", "y", "psi", "lean", "spin")],
        gravity=gravity_along_minus(2),
        named=[
            frame("disc", "world", Rotate(2, v("psi").e), Rotate(0, v("lean").e)),
            point("C", vec(v("x"), v("y"), 0) + v("R") * axis("disc", 2)),
            frame("coin", "disc", Place(at("C").e), Rotate(1, v("spin").e)),
        ],
        bodies=[body("coin", m, (0, 0, 0), (m * r**2 / 4, m * r**2 / 2, m * r**2 / 4, 0, 0, 0), label="penny")],
        constraints=[constraint("rolling", *[X(fx.Component(slip.e, i)) for i in range(3)], level="velocity")],
        outputs=[output("grip", fx.Multiplier("rolling[1]"))],
    )


def heavy_top() -> FlatModel:
    tensor = (v("A"), v("A"), v("C"), 0, 0, 0)
    return model(
        "HeavyTop",
        parameters=parameters("m", "l", "A", "C"),
        coordinates=[coordinate("psi"), coordinate("theta", 0.5), coordinate("phi")],
        gravity=gravity_along_minus(2),
        named=[frame("top", "world", Rotate(2, v("psi").e), Rotate(0, v("theta").e), Rotate(2, v("phi").e))],
        bodies=[body("top", v("m"), (0, 0, v("l")), tensor, label="gyro")],
        outputs=[output(f"F{i}", fx.Component(fx.FrameReaction("top", "force"), i)) for i in range(3)]
        + [output(f"M{i}", fx.Component(fx.FrameReaction("top", "torque"), i)) for i in range(3)],
        invariants=[
            invariant("E", fx.SystemEnergy("total")),
            invariant("p_psi", fx.GeneralizedMomentum("psi")),
            invariant("Lz", fx.Component(fx.AngularMomentum("gyro", vec(0, 0, 0).e), 2)),
        ],
    )


def quaternion_body() -> FlatModel:
    e = [v(f"e[{i}]") for i in range(1, 5)]
    return model(
        "FreeBody",
        parameters=parameters("m", "A", "B", "C"),
        coordinates=[coordinate("x"), coordinate("e[1]", 1.0), *(coordinate(f"e[{i}]") for i in (2, 3, 4))],
        gravity=gravity_along_minus(2),
        named=[frame("F", "world", Move((v("x").e, fx.ZERO, fx.ZERO)), RotateQuaternion(tuple(x.e for x in e)))],
        bodies=[body("F", v("m"), (0.1, 0, 0), (v("A"), v("B"), v("C"), 0.1, 0, 0))],
        constraints=[constraint("unit", e[0] ** 2 + e[1] ** 2 + e[2] ** 2 + e[3] ** 2 - 1)],
        loads=[torque(vec(0.3, 0, 0), "F")],
        outputs=[
            output("p", fx.Component(fx.LinearMomentum(), 0)),
            output("L", fx.Component(fx.AngularMomentum(None, vec(0, 0, 1).e), 1)),
        ],
    )


def workshop() -> FlatModel:
    """One model with every load, frame step, function and relation that the others lack."""
    a, b, x = v("a"), v("b"), v("x")
    odd = call("abs", sin(a)) + call("max", x, 0.1) + call("min", x, 2) + call("mod", x + 5, 3) + call("atan2", x, 2)
    smooth = call("tanh", x) + call("exp", -x) + call("sqrt", x**2 + 1) + call("log", x + 3) + (x + 3) ** 1.3
    angular = call("asin", x / 9) + call("acos", x / 9) + call("atan", x) + call("tan", x / 4)
    steps = call("sign", x) + call("floor", x) + call("ceil", x) + call("cosh", x) + call("sinh", x)
    both = X(fx.Binary("and", less(x, 1).e, X(fx.Unary("not", less(a, x).e)).e))
    either = X(fx.Binary("or", X(fx.Binary("<=", x.e, a.e)).e, X(fx.Binary("==", x.e, a.e)).e))
    unequal = X(fx.Binary("<>", x.e, a.e)) + X(fx.Binary(">", x.e, a.e)) + X(fx.Binary(">=", x.e, a.e))
    switched = when(both, vec(x, 1, 2), vec(0, a, x))
    return model(
        "Workshop",
        parameters=[*parameters("m", "k"), parameter("N", 2.0, structural=True)],
        coordinates=[coordinate("a"), coordinate("b", 0.4, 0.3), coordinate("x", 0.5)],
        states=[state("z", -v("z") + x * v("y"))],
        inputs=[external("w", smooth=2), external("der(w)", "w"), external("der(der(w))", "der(w)"), external("u")],
        gravity=gravity_along_minus(1),
        named=[
            definition("half", v("m") / v("N"), Variability.PARAMETER),
            definition("y", x * v("z") + v("half")),
            definition("later", X(fx.GeneralizedMomentum("a")) + 1),
            frame("A", "world", RotateAbout((fx.ONE, fx.Number(2.0), fx.ZERO), a.e), Move((x.e, fx.ONE, fx.ZERO))),
            frame("B", "A", Rotate(0, b.e), Move((fx.ZERO, v("w").e, fx.ZERO))),
            frame(
                "C",
                "B",
                SetAxes(axis("B", 1).e, axis("B", 2).e, axis("B", 0).e),
                Place(vec(x, v("w"), a).e),
            ),
            point("P", X(fx.FrameOrigin("B")) + 2 * axis("B", 1)),
        ],
        masses=[mass(v("half"), at("P")), mass(v("k"), vec(x, 0, 0))],
        bodies=[body("C", v("m"), (0.1, 0.2, 0), (1, 2, 2.5, 0.1, 0.2, 0.3), label=None)],
        energies=[
            energy("potential", smooth + angular + v("z") * x),
            energy("kinetic", (2 + cos(x)) * der(b) ** 2),
            energy("lagrangian", x * der(a) + call("sqrt", 1 + der(x) ** 2)),
            energy("dissipation", v("k") * der(call("sqrt", dot(at("P"), at("P")))) ** 2 / 2),
        ],
        loads=[
            force(switched, at("P"), "B", origin=vec(x, 0, 0)),
            force(-vec(odd, steps, unequal + either), X(fx.FrameOrigin("C")), origin=at("P"), origin_frame="A"),
            torque(vec(1, x, v("u")), "C", "A"),
            generalized(v("u") * v("time"), a + b * x, origin=x),
        ],
        constraints=[
            constraint("cam", x - sin(a) * b - v("w")),
            constraint("roll", dot(X(fx.MaterialVelocity(at("P").e, "C")), axis("A", 0)), level="velocity"),
        ],
        outputs=[
            output("acc", der(der(dot(at("P"), axis("world", 1))))),
            output("react", fx.ReactionAlong("P", vec(0, 1, 0).e)),
            output("T", fx.SystemEnergy("kinetic")),
            output("V", fx.SystemEnergy("potential")),
            output("L", dot(X(fx.AngularMomentum(None, at("P").e)), X(fx.LinearMomentum()))),
            output("dy", der(v("y"))),
            output("late", v("later")),
        ],
        invariants=[invariant("I", -(X(fx.SystemEnergy("total")) - x))],
        assertions=[Assertion(condition=less(x, 3).e, message="x is large", spans=())],
        initial_equations=[InitialEquation(residual=der(der(a)).e, dimension=DIMENSIONLESS, spans=())],
    )


ALL = (
    pendulum,
    cart_pendulum,
    hoop,
    spherical_pendulum,
    atwood,
    rolling_coin,
    heavy_top,
    quaternion_body,
    workshop,
)
