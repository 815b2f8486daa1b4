"""Derivatives of the graph for a model that has everything: complex steps, forty digits, virtual displacements."""

from functools import cache

import mpmath
import numpy as np
import pytest
from derived_programs import derive
from mechanics_models import (
    body,
    constraint,
    coordinate,
    definition,
    drive,
    energy,
    force,
    frame,
    mass,
    model,
    point,
    run,
    state,
    torque,
    triple,
)
from mechanics_models import expression as ex

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.language.flat.expression import Variable
from lagdsl.language.flat.model import Move, Place, Rotate, RotateAbout, RotateQuaternion, SetAxes

QUATERNION = ("e0", "e1", "e2", "e3")
N = 7


@cache
def everything() -> Program:
    return derive(
        model(
            parameters={"m": 1.3, "k": 2.0, "l": 0.7, "c": 0.3},
            coordinates=tuple(coordinate(name, 0.3) for name in ("a", "b", "x", *QUATERNION)),
            states=(state("z", "der(a)*x - z + u"),),
            inputs=(("u", None), ("road", None), ("der(road)", "road"), ("der(der(road))", "der(road)")),
            named=(
                frame("A", "world", Rotate(2, Variable("a")), Move(triple(("l", "x", "0.1")))),
                frame("B", "A", RotateAbout(triple((1, "k", -1)), ex("b + 0.3*time")), Place(ex("A.origin + 0.2*A.y"))),
                frame("C", "B", Move(triple((0, 0, "0.5"))), RotateQuaternion(triple(QUATERNION))),  # type: ignore[arg-type]
                frame(
                    "D", "world", SetAxes(ex("C.y"), ex("C.z"), ex("C.x")), Rotate(1, ex("a*b")), Place(ex("C.origin"))
                ),
                point("P", "C.origin + 0.4*C.x - 0.2*C.z + v(0, road, 0)"),
                definition("s", "norm(p(P) - A.origin)"),
                definition("speed", "der(s)"),
            ),
            gravity="v(0.3, -9.81*(1 + 0.1*sin(time)), 0)",
            masses=(mass("m", "p(P)"), mass("2*m", "A.origin")),
            bodies=(
                body("C", "m", ("0.1", 0, "l"), ("0.3", "0.4", "0.5", "0.01", "0.02", "-0.03")),
                body("D", 0, (0, 0, 0), ("0.2", "0.25", "0.3", 0, 0, 0), label="spinner"),
            ),
            energies=(
                energy("potential", "1/2*k*(s - l)^2 + exp(-x)*cos(a)"),
                energy("lagrangian", "x*der(a)*sin(time) + z*der(x)*b + 0.1*der(x)^4"),
                energy("dissipation", "1/2*c*der(x)^2 + 0.1*speed^2"),
            ),
            loads=(
                force("speed*v(1, u, x)", "p(P)"),
                force("v(0.3, -1, 2)", "C.origin + 0.3*C.y", on="C", origin="A.origin", origin_frame="B"),
                torque("der(b)*v(0.1, 0.2, 0.3)", "D", origin="A"),
                drive("tanh(der(x))", "s*a", origin="x^2"),
            ),
            constraints=(
                constraint("unit", "e0^2 + e1^2 + e2^2 + e3^2 - 1"),
                constraint("guide", "component(p(P), 0) - 0.1*sin(time)*x", "s - 2 - road^2"),
                constraint("roll", "component(velocity(p(P), D), 2) - 0.3*x*der(a) - sin(time)", level="velocity"),
            ),
            outputs={
                "Px": "component(p(P), 0)",
                "Py": "component(p(P), 1)",
                "Pz": "component(p(P), 2)",
                "acc": "norm(der(der(p(P))))",
                "lam": "multiplier(unit)*x + z",
                "E": "energy() + momentum(b)",
                "reaction": "component(reaction_force(B), 0) + component(reaction_torque(C), 2)",
                "L": "component(angular_momentum(spinner, A.origin), 1) + component(linear_momentum(), 2)",
                "H": "component(angular_momentum(everything, p(P)), 0)",
                "roadspeed": "der(road) + der(der(road))",
            },
            initial_equations=("der(der(x)) - 1",),
        )
    )


@pytest.fixture
def point_of_state() -> dict[str, np.ndarray]:
    random = np.random.default_rng(3)
    return {
        "t": np.float64(0.4),
        "q": random.uniform(0.2, 1.0, N),
        "qd": random.uniform(-1.0, 1.0, N),
        "z": random.uniform(-1.0, 1.0, 1),
        "u": random.uniform(-1.0, 1.0, 4),
    }


@pytest.fixture
def solved(point_of_state: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    random = np.random.default_rng(4)
    return point_of_state | {"qdd": random.uniform(-1, 1, N), "lam": random.uniform(-1, 1, 4)}


def test_mass_matrix_is_symmetric_and_the_derivative_of_the_inverse_dynamics(point_of_state) -> None:
    program = everything()
    m, f, _, _ = run(program, "dynamics", **point_of_state)
    assert np.array_equal(m, m.T)
    qdd = np.linspace(-1, 1, N)
    (tau,) = run(program, "inverse_dynamics", qdd=qdd, **point_of_state)
    np.testing.assert_allclose(tau, m @ qdd - f, atol=1e-12)
    for column in range(N):
        (stepped,) = run(program, "inverse_dynamics", qdd=qdd + 1e-30j * np.eye(N)[column], **point_of_state)
        np.testing.assert_allclose(stepped.imag / 1e-30, m[:, column], atol=1e-12)


def test_mass_matrix_of_quadratic_kinetic_energy_is_positive(point_of_state) -> None:
    """On the tangent space of the unit quaternions: along e itself nothing moves."""
    (m,) = run(everything(), "mass_matrix", **point_of_state)
    eigenvalues = np.linalg.eigvalsh(m)
    assert eigenvalues[0] == pytest.approx(0.0, abs=1e-12)
    assert eigenvalues[1] > 1e-3


def test_residual_is_the_equations(solved) -> None:
    program = everything()
    state_ = {name: value for name, value in solved.items() if name not in ("qdd", "lam")}
    m, f, j, gamma = run(program, "dynamics", **state_)
    r, s = run(program, "residual", **solved)
    np.testing.assert_allclose(r, m @ solved["qdd"] - f - j.T @ solved["lam"], atol=1e-12)
    np.testing.assert_allclose(s, j @ solved["qdd"] - gamma, atol=1e-12)


def test_jacobian_rows_and_velocity_residual(point_of_state) -> None:
    program = everything()
    phi, j = run(program, "position_constraint", **point_of_state)
    residual, same = run(program, "velocity_constraint", **point_of_state)
    assert np.array_equal(j, same)
    assert phi[3] == 0.0
    for column in range(N):
        step = 1e-30j * np.eye(N)[column]
        moved = run(program, "position_constraint", **{**point_of_state, "q": point_of_state["q"] + step})[0]
        driven = run(program, "velocity_constraint", **{**point_of_state, "qd": point_of_state["qd"] + step})[0]
        np.testing.assert_allclose(moved.imag[:3] / 1e-30, j[:3, column], atol=1e-12)
        np.testing.assert_allclose(driven.imag / 1e-30, j[:, column], atol=1e-12)
    drift = run(program, "velocity_constraint", **{**point_of_state, "qd": np.zeros(N)})[0]
    np.testing.assert_allclose(residual, j @ point_of_state["qd"] + drift, atol=1e-12)


@pytest.mark.parametrize("function", ["residual", "output", "state_derivative"])
def test_tangents_equal_complex_steps(function: str, solved) -> None:
    program = everything()
    random = np.random.default_rng(5)
    groups = ["q", "qd", "z", "u", "p"] + ([] if function == "residual" else ["qdd", "lam"])
    base = {**solved, "p": np.array(program.layout.defaults)}
    directions = {name: random.uniform(-1, 1, len(base[name])) for name in groups}
    stepped = {name: value + 1e-30j * directions[name] if name in groups else value for name, value in base.items()}
    tangent = run(program, f"{function}_tangent", **base, **{f"d{name}": value for name, value in directions.items()})
    for value, derivative in zip(run(program, function, **stepped), tangent, strict=True):
        assert np.max(np.abs(derivative)) > 1e-3
        np.testing.assert_allclose(value.imag / 1e-30, derivative, rtol=1e-11, atol=1e-11)


# ---- along a motion, at 40 digits ------------------------------------------------------------------------------------


def motion(t):
    """Smooth functions of time for everything, with their first two derivatives."""
    q = [mpmath.mpf(3 + k) / 10 + mpmath.sin(t * (k + 1)) / 5 for k in range(N)]
    qd = [mpmath.cos(t * (k + 1)) * (k + 1) / 5 for k in range(N)]
    qdd = [-mpmath.sin(t * (k + 1)) * (k + 1) ** 2 / 5 for k in range(N)]
    road, roadd, roaddd = mpmath.sin(3 * t), 3 * mpmath.cos(3 * t), -9 * mpmath.sin(3 * t)
    return q, qd, qdd, [mpmath.mpf(1) / 3, road, roadd, roaddd]


def symbols(t, z):
    q, qd, qdd, u = motion(t)
    return {
        Group.TIME: t,
        Group.Q: q,
        Group.QD: qd,
        Group.QDD: qdd,
        Group.U: u,
        Group.Z: [z],
        Group.P: [mpmath.mpf(value) for value in everything().layout.defaults],
        Group.LAMBDA: [mpmath.mpf(0)] * 4,
    }


T0 = mpmath.mpf("0.4")
Z0 = mpmath.mpf("0.7")


def values(function: str, block: int, t, z=Z0):
    program = everything()
    return evaluate(program.graph, program.function(function).results[block].elements, symbols(t, z))


def state_along(t):
    """z(t) to second order around T0: z' follows its equation there."""
    (rate,) = values("state_derivative", 0, T0)
    return Z0 + rate * (t - T0)


@pytest.fixture
def digits():
    with mpmath.workdps(40):
        yield


def close(a, b) -> bool:
    return all(abs(x - y) < mpmath.mpf(10) ** -15 * (1 + abs(x)) for x, y in zip(a, b, strict=True))


@pytest.mark.usefixtures("digits")
def test_velocity_residual_and_gamma_are_time_derivatives() -> None:
    velocity = values("velocity_constraint", 0, T0)
    for row in range(3):
        assert close([mpmath.diff(lambda t, row=row: values("position_constraint", 0, t)[row], T0)], [velocity[row]])
    derivative = [mpmath.diff(lambda t, row=row: values("velocity_constraint", 0, t)[row], T0) for row in range(4)]
    assert close(derivative, values("residual", 1, T0))


@pytest.mark.usefixtures("digits")
def test_inverse_dynamics_is_lagranges_equation() -> None:
    """d/dt dL/dqd by differences of the momenta along a motion, dL/dq by differences of L; loads as power."""
    tau = values("inverse_dynamics", 0, T0)
    inertial = [
        mpmath.diff(lambda t, j=j: values("momenta", 0, t, state_along(t))[j], T0) - lagrangian_slope(j)
        for j in range(N)
    ]
    _, qd, _, _ = motion(T0)
    load, lost = values("power", 0, T0), values("power", 1, T0)
    applied = [(load[j] - lost[j]) / qd[j] for j in range(N)]
    assert close(tau, [x - y for x, y in zip(inertial, applied, strict=True)])


def lagrangian_slope(j: int):
    """dL/dq_j, with L = qd.p - jacobi integral."""
    program = everything()

    def lagrangian(step):
        at = symbols(T0, Z0)
        at[Group.Q] = [x + (step if k == j else 0) for k, x in enumerate(at[Group.Q])]
        momenta = evaluate(program.graph, program.function("momenta").results[0].elements, at)
        (jacobi,) = evaluate(program.graph, program.function("energies").results[3].elements, at)
        return sum(x * y for x, y in zip(momenta, at[Group.QD], strict=True)) - jacobi

    return mpmath.diff(lagrangian, 0)


@pytest.mark.usefixtures("digits")
def test_momenta_are_the_slopes_of_the_kinetic_energy_and_extra_terms() -> None:
    """Without the quartic and linear terms T is quadratic: T = qd.M qd/2, and energy() leaves linear terms out."""
    program = everything()
    at = symbols(T0, Z0)
    total, kinetic, potential, _ = (
        evaluate(program.graph, block.elements, at)[0] for block in program.function("energies").results
    )
    quartic = at[Group.QD][2] ** 4 / 10
    assert close([total], [kinetic + potential + 3 * quartic])


@pytest.mark.usefixtures("digits")
def test_acceleration_output_is_the_second_derivative_of_the_position() -> None:
    second = [mpmath.diff(lambda t, k=k: values("output", 0, t)[k], T0, 2) for k in range(3)]
    assert close([mpmath.sqrt(sum(x * x for x in second))], [values("output", 0, T0)[3]])


# ---- loads -----------------------------------------------------------------------------------------------------------


def test_point_force_by_virtual_displacement() -> None:
    """Q = F.dr/dq with dr/dq of the position by complex steps; two more points that move with a frame."""
    shared = {
        "coordinates": ("a", "b", "x"),
        "named": (
            frame("A", "world", Rotate(2, Variable("a")), Move(triple(("x", 0, 0)))),
            frame("B", "A", Rotate(0, Variable("b")), Move(triple((0, "0.4", 0)))),
            point("P", "B.origin + 0.3*B.z + v(0, x^2, 0)"),
            point("M", "B.origin + 0.7*B.y - 0.2*B.z"),
        ),
        "masses": (mass(1.0, "p(P)"),),
        "outputs": {f"{p}{k}": f"component(p({p}), {k})" for p in "PM" for k in range(3)},
    }
    f, g = np.array([1.0, -2.0, 0.5]), np.array([0.3, 0.9, -1.1])
    loads = (
        force("v(1, -2, 0.5)", "p(P)"),
        force("v(0.3, 0.9, -1.1)", "B.origin + 0.7*B.y - 0.2*B.z + v(0, 0, 0)", on="B", origin="v(x, 0, 0)"),
    )
    loaded, free = derive(model(**shared, loads=loads)), derive(model(**shared))
    q = np.array([0.4, 0.9, 0.6])
    generalized = run(loaded, "dynamics", q=q)[1] - run(free, "dynamics", q=q)[1]
    for j in range(3):
        displaced = run(free, "output", q=q + 1e-30j * np.eye(3)[j])[0].imag / 1e-30
        expected = f @ displaced[:3] + g @ displaced[3:] - g[0] * (j == 2)
        assert generalized[j] == pytest.approx(expected, abs=1e-13)


def test_material_point_differs_from_the_point_that_slides() -> None:
    """A force at the contact of a rolling disc: with `on` the disc is turned, without only carried."""
    shared = {
        "coordinates": ("x", "phi"),
        "named": (frame("wheel", "world", Place(ex("v(x, 1, 0)")), Rotate(2, Variable("phi"))),),
        "bodies": (body("wheel", 1.0, inertia=(0, 0, 0.5, 0, 0, 0)),),
    }
    carried = derive(model(**shared, loads=(force("v(3, 0, 0)", "v(x, 0, 0)"),)))
    turned = derive(model(**shared, loads=(force("v(3, 0, 0)", "v(x, 0, 0)", on="wheel"),)))
    np.testing.assert_allclose(run(carried, "dynamics")[1], [3.0, 0.0])
    np.testing.assert_allclose(run(turned, "dynamics")[1], [3.0, 3.0])
