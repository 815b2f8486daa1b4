"""The literal derivation against equations printed in textbooks."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy
from sympy import Matrix, cos, sin, symbols

from lagdsl.algebra.graph.evaluate import evaluate_with_size
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.textbook.derive import derive
from lagdsl.derivation.textbook.equations import EquationsOfMotion
from lagdsl.derivation.textbook.to_graph import ToGraph
from lagdsl.language.flat.model import FlatModel
from textbook import models
from textbook.build import coordinate, der, energy, model, v

G = 9.80665


def same(left: Any, right: Any) -> bool:
    """Equal at ten random points, to rounding errors of the terms."""
    difference = sympy.sympify(left - right)
    unknowns = sorted(difference.free_symbols, key=str)
    graph = Graph()
    nodes = dict(zip(unknowns, graph.symbols(Group.P, len(unknowns)), strict=True))
    root = ToGraph(graph, nodes).node(difference)
    points = np.random.default_rng(3).uniform(0.3, 2.0, size=(10, len(unknowns)))
    [(value, size)] = evaluate_with_size(graph, [root], {Group.P: points})
    return bool(np.all(np.abs(value) <= 1e-13 * size))


def acceleration(equations: EquationsOfMotion) -> Matrix:
    return equations.mass_matrix.LUsolve(equations.forcing)


def test_pendulum() -> None:
    """l theta'' + g sin(theta) = 0 (Goldstein, Classical Mechanics, 3rd ed., section 1.6)."""
    equations = derive(models.pendulum())
    m, l, theta, rate = symbols("m l theta der(theta)")
    assert same(equations.mass_matrix[0], m * l**2)
    assert same(equations.forcing[0], -m * G * l * sin(theta))
    assert same(equations.energies.total, m * l**2 * rate**2 / 2 - m * G * l * cos(theta))
    assert same(equations.energies.jacobi, equations.energies.total)
    assert same(equations.momenta[0], m * l**2 * rate)
    assert equations.invariants[0].value == equations.energies.total
    assert equations.q == (theta,)
    assert equations.qd == (rate,)
    assert equations.start[theta] == 1
    assert equations.parameters == {m: 1.0, l: 0.5}


def test_cart_pendulum() -> None:
    """(M + m) x'' + m l (theta'' cos - theta'^2 sin) + c x' + k x = u and x'' cos + l theta'' + g sin = 0
    (Meirovitch, Methods of Analytical Dynamics, chapter 2)."""
    equations = derive(models.cart_pendulum())
    M, m, l, c, k, u, x, theta, xd, w = symbols("M m l c k u x theta der(x) der(theta)")
    expected = Matrix([[M + m, m * l * cos(theta)], [m * l * cos(theta), m * l**2]])
    right = Matrix([u - c * xd - k * x + m * l * w**2 * sin(theta), -m * G * l * sin(theta)])
    assert all(same(a, b) for a, b in zip(equations.mass_matrix, expected, strict=True))
    assert all(same(a, b) for a, b in zip(equations.forcing, right, strict=True))
    assert same(equations.generalized_force[0], u)
    assert same(equations.dissipative_force[0], -c * xd)
    assert equations.outputs["ax"] == sympy.Symbol("der(der(x))")


def test_bead_on_spinning_hoop() -> None:
    """R theta'' + g sin - R Omega^2 sin cos = 0; normal force 2 m R Omega theta' cos (Vandiver, MIT 2.003SC)."""
    equations = derive(models.hoop())
    m, R, Omega, theta, rate = symbols("m R Omega theta der(theta)", positive=True)
    positive = {sympy.Symbol(s.name): s for s in (m, R, Omega, theta, rate)}

    def read(expression: sympy.Expr) -> sympy.Expr:
        return expression.xreplace(positive)

    assert same(read(equations.mass_matrix[0]), m * R**2)
    assert same(read(equations.forcing[0]), m * R**2 * Omega**2 * sin(theta) * cos(theta) - m * G * R * sin(theta))
    assert same(read(equations.outputs["N_out"]), -2 * m * R * Omega * rate * cos(theta))
    radial = m * R * (rate**2 + Omega**2 * sin(theta) ** 2) + m * G * cos(theta)
    assert same(read(equations.outputs["N_rad"]), radial)
    jacobi = m * R**2 * (rate**2 - Omega**2 * sin(theta) ** 2) / 2 - m * G * R * cos(theta)
    assert same(read(equations.energies.jacobi), jacobi)


def test_spherical_pendulum() -> None:
    """theta'' = phi'^2 sin cos - g/l sin, (phi' sin^2)' = 0 (Landau and Lifshitz, Mechanics, section 14, problem 1)."""
    equations = derive(models.spherical_pendulum())
    m, l, theta, rate, spin = symbols("m l theta der(theta) der(phi)")
    theta_dd, phi_dd = acceleration(equations)
    assert same(equations.momenta[1], m * l**2 * sin(theta) ** 2 * spin)
    assert same(theta_dd, spin**2 * sin(theta) * cos(theta) - G / l * sin(theta))
    assert same(phi_dd, -2 * rate * spin * cos(theta) / sin(theta))


def test_atwood_tension_is_the_multiplier() -> None:
    """y1'' = (m2 - m1) g/(m1 + m2), tension 2 m1 m2 g/(m1 + m2), which pulls both masses up: lambda > 0."""
    equations = derive(models.atwood())
    m1, m2, lam = symbols("m1 m2 multiplier(rope)")
    system = Matrix(
        [[equations.mass_matrix, -equations.constraint_jacobian.T], [equations.constraint_jacobian, Matrix([0])]]
    )
    solution = system.LUsolve(Matrix([*equations.forcing, *equations.gamma]))
    assert same(solution[0], (m2 - m1) * G / (m1 + m2))
    assert same(solution[2], 2 * m1 * m2 * G / (m1 + m2))
    assert equations.outputs["tension"] == lam


def test_rolling_disc() -> None:
    """x' = R spin' cos(psi) and y' = R spin' sin(psi); the third component is empty (Neimark and Fufaev, chapter 1)."""
    equations = derive(models.rolling_coin())
    R, psi, xd, yd, spin = symbols("R psi der(x) der(y) der(spin)")
    residual = equations.velocity_constraint
    assert same(residual[0], xd - R * spin * cos(psi))
    assert same(residual[1], yd - R * spin * sin(psi))
    assert same(residual[2], 0)
    assert list(equations.constraint) == [0, 0, 0]


def test_heavy_top() -> None:
    """T = (A + m l^2)(psi'^2 sin^2 + theta'^2)/2 + C(phi' + psi' cos)^2/2 (Goldstein, section 5.7)."""
    equations = derive(models.heavy_top())
    m, l, A, C, theta = symbols("m l A C theta")
    precession, nutation, spin = symbols("der(psi) der(theta) der(phi)")
    kinetic = (A + m * l**2) * (precession**2 * sin(theta) ** 2 + nutation**2) / 2
    kinetic += C * (spin + precession * cos(theta)) ** 2 / 2
    assert same(equations.kinetic_energy, kinetic)
    assert same(equations.potential_energy, m * G * l * cos(theta))


def charge_model() -> FlatModel:
    """L q'' + k theta' = 0 and J theta'' - k q' = 0 from the term k theta q'."""
    q, theta = v("q"), v("theta")
    return model(
        "Motor",
        parameters=models.parameters("L", "J", "k"),
        coordinates=[coordinate("q"), coordinate("theta")],
        energies=[
            energy("kinetic", v("L") * der(v("q")) ** 2 / 2 + v("J") * der(v("theta")) ** 2 / 2),
            energy("lagrangian", v("k") * theta * der(v("q")) + 0 * q),
        ],
    )


def test_velocity_linear_terms_add_no_energy() -> None:
    """Torque and back-emf with matching signs, energy T + V only."""
    equations = derive(charge_model())
    L, J, k, i, w = symbols("L J k der(q) der(theta)")
    assert same(equations.forcing[0], -k * w)
    assert same(equations.forcing[1], k * i)
    assert same(equations.energies.total, L * i**2 / 2 + J * w**2 / 2)
