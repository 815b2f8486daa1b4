"""Equations of motion against closed forms from the textbooks."""

import numpy as np
import pytest
from derived_programs import derive
from mechanics_models import (
    accelerations,
    body,
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
    torque,
)

from lagdsl.language.flat.expression import Variable
from lagdsl.language.flat.model import Rotate

G = 9.81


def test_pendulum() -> None:
    program = derive(
        model(
            parameters={"m": 2.0, "l": 0.5},
            coordinates=("theta",),
            gravity="v(0, -9.81, 0)",
            masses=(mass("m", "v(l*sin(theta), -l*cos(theta), 0)"),),
        )
    )
    m, f, _, _ = run(program, "dynamics", q=[0.7], qd=[1.3])
    assert m[0, 0] == pytest.approx(2.0 * 0.25)
    assert f[0] == pytest.approx(-2.0 * G * 0.5 * np.sin(0.7))


def test_pendulum_by_energies_with_damping() -> None:
    program = derive(
        model(
            parameters={"m": 2.0, "l": 0.5, "c": 0.02},
            coordinates=("theta",),
            energies=(
                energy("kinetic", "1/2*m*(l*der(theta))^2"),
                energy("potential", "-m*9.81*l*cos(theta)"),
                energy("dissipation", "1/2*c*der(theta)^2"),
            ),
        )
    )
    _, f, _, _ = run(program, "dynamics", q=[0.7], qd=[1.3])
    assert f[0] == pytest.approx(-2.0 * G * 0.5 * np.sin(0.7) - 0.02 * 1.3)
    load, lost = run(program, "power", q=[0.7], qd=[1.3])
    assert load[0] == 0.0
    assert lost[0] == pytest.approx(0.02 * 1.3**2)


def test_double_pendulum() -> None:
    """Landau and Lifshitz, Mechanics, section 5, problem 1."""
    m1, m2, l1, l2 = 1.2, 0.7, 0.4, 0.9
    program = derive(
        model(
            parameters={"m1": m1, "m2": m2, "l1": l1, "l2": l2},
            coordinates=("a", "b"),
            named=(
                point("A", "l1*v(sin(a), -cos(a), 0)"),
                point("B", "p(A) + l2*v(sin(b), -cos(b), 0)"),
            ),
            gravity="v(0, -9.81, 0)",
            masses=(mass("m1", "p(A)"), mass("m2", "p(B)")),
        )
    )
    a, b, ad, bd = 0.3, -1.1, 0.8, 1.7
    m, f, _, _ = run(program, "dynamics", q=[a, b], qd=[ad, bd])
    coupling = m2 * l1 * l2
    np.testing.assert_allclose(
        m, [[(m1 + m2) * l1**2, coupling * np.cos(a - b)], [coupling * np.cos(a - b), m2 * l2**2]], rtol=1e-13
    )
    np.testing.assert_allclose(
        f,
        [
            -coupling * np.sin(a - b) * bd**2 - (m1 + m2) * G * l1 * np.sin(a),
            coupling * np.sin(a - b) * ad**2 - m2 * G * l2 * np.sin(b),
        ],
        rtol=1e-13,
    )


def test_spherical_pendulum_and_its_momentum() -> None:
    program = derive(
        model(
            parameters={"m": 0.5, "l": 1.5},
            coordinates=("th", "ph"),
            gravity="v(0, 0, -9.81)",
            masses=(mass("m", "l*v(sin(th)*cos(ph), sin(th)*sin(ph), -cos(th))"),),
        )
    )
    th, ph, thd, phd = 0.9, 0.4, -0.3, 2.0
    qdd, _ = accelerations(program, q=[th, ph], qd=[thd, phd])
    assert qdd[0] == pytest.approx(np.sin(th) * np.cos(th) * phd**2 - G / 1.5 * np.sin(th))
    assert qdd[1] == pytest.approx(-2.0 * thd * phd / np.tan(th))
    (momenta,) = run(program, "momenta", q=[th, ph], qd=[thd, phd])
    assert momenta[1] == pytest.approx(0.5 * (1.5 * np.sin(th)) ** 2 * phd)


def test_bead_on_spinning_hoop() -> None:
    """R theta'' + g sin - R Omega^2 sin cos = 0, whatever the time; the Jacobi integral is T2 - T0 + V."""
    m, r, rate = 0.1, 0.3, 8.0
    program = derive(
        model(
            parameters={"m": m, "R": r, "Omega": rate},
            coordinates=("theta",),
            named=(
                frame("hoop", "world", Rotate(1, Variable("angle"))),
                definition("angle", "Omega*time"),
                point("P", "R*(sin(theta)*hoop.x - cos(theta)*hoop.y)"),
            ),
            gravity="v(0, -9.81, 0)",
            masses=(mass("m", "p(P)"),),
        )
    )
    theta, thetad = 0.6, 1.1
    qdd, _ = accelerations(program, t=0.37, q=[theta], qd=[thetad])
    assert qdd[0] == pytest.approx(rate**2 * np.sin(theta) * np.cos(theta) - G / r * np.sin(theta))
    total, kinetic, potential, jacobi = run(program, "energies", t=0.37, q=[theta], qd=[thetad])
    t2, t0 = m * r**2 * thetad**2 / 2, m * (r * rate * np.sin(theta)) ** 2 / 2
    assert kinetic == pytest.approx(t2 + t0)
    assert total == pytest.approx(kinetic + potential)
    assert jacobi == pytest.approx(t2 - t0 + potential)


def test_rigid_body_in_euler_angles_obeys_eulers_equations() -> None:
    """I omega' + omega x I omega = moment, in own axes; products of inertia included."""
    inertia = np.array([[0.3, 0.02, -0.01], [0.02, 0.5, 0.04], [-0.01, 0.04, 0.6]])
    entries = [inertia[i] for i in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    moment = np.array([0.4, -0.7, 0.2])
    flat = model(
        coordinates=("a", "b", "c"),
        named=(
            frame("B", "world", Rotate(2, Variable("a")), Rotate(0, Variable("b")), Rotate(2, Variable("c"))),
            definition("wx", "omega(B) @ B.x"),
            definition("wy", "omega(B) @ B.y"),
            definition("wz", "omega(B) @ B.z"),
        ),
        bodies=(body("B", inertia=entries),),
        loads=(torque("0.4*B.x - 0.7*B.y + 0.2*B.z", "B"),),
        outputs={"wx": "wx", "wy": "wy", "wz": "wz", "ax": "der(wx)", "ay": "der(wy)", "az": "der(wz)"},
    )
    program = derive(flat)
    state = {"q": [0.3, 0.8, -0.5], "qd": [1.0, -2.0, 0.7]}
    qdd, _ = accelerations(program, **state)
    (y,) = run(program, "output", qdd=qdd, **state)
    omega, alpha = y[:3], y[3:]
    np.testing.assert_allclose(inertia @ alpha + np.cross(omega, inertia @ omega), moment, atol=1e-13)


def test_charged_particle_in_a_magnetic_field() -> None:
    """L = m v^2/2 + e B (x y' - y x')/2: a circle with the cyclotron frequency; the term is no energy."""
    program = derive(
        model(
            parameters={"m": 2.0, "eB": 3.0},
            coordinates=("x", "y"),
            energies=(
                energy("kinetic", "m/2*(der(x)^2 + der(y)^2)"),
                energy("lagrangian", "eB/2*(x*der(y) - y*der(x))"),
            ),
        )
    )
    state = {"q": [0.4, -0.2], "qd": [1.5, 0.7]}
    qdd, _ = accelerations(program, **state)
    np.testing.assert_allclose(qdd, [1.5 * 0.7, -1.5 * 1.5], rtol=1e-14)
    total, kinetic, _, jacobi = run(program, "energies", **state)
    assert total == pytest.approx(kinetic)
    assert jacobi == pytest.approx(kinetic)


def test_relativistic_particle_has_a_mass_matrix_that_depends_on_the_rates() -> None:
    """L = -m c^2 sqrt(1 - v^2/c^2): M = gamma m (1 + gamma^2 v v'/c^2), energy gamma m c^2."""
    m, c = 1.5, 3.0
    program = derive(
        model(
            parameters={"m": m, "c": c},
            coordinates=("x", "y"),
            energies=(energy("lagrangian", "-m*c^2*sqrt(1 - (der(x)^2 + der(y)^2)/c^2) + 2*x"),),
        )
    )
    v = np.array([1.1, -0.6])
    gamma = 1 / np.sqrt(1 - v @ v / c**2)
    mm, f, _, _ = run(program, "dynamics", q=[0.2, 0.3], qd=v)
    np.testing.assert_allclose(mm, gamma * m * (np.eye(2) + gamma**2 * np.outer(v, v) / c**2), rtol=1e-13)
    np.testing.assert_allclose(f, [2.0, 0.0], atol=1e-14)
    total = run(program, "energies", q=[0.2, 0.3], qd=v)[0]
    assert total == pytest.approx(gamma * m * c**2 - 2 * 0.2)


def test_kepler() -> None:
    program = derive(
        model(
            parameters={"m": 1.0, "mu": 4.0},
            coordinates=(coordinate("r", 1.0), "phi"),
            energies=(
                energy("kinetic", "m/2*(der(r)^2 + (r*der(phi))^2)"),
                energy("potential", "-mu*m/r"),
            ),
        )
    )
    qdd, _ = accelerations(program, q=[1.3, 0.2], qd=[0.4, 0.9])
    np.testing.assert_allclose(qdd, [1.3 * 0.81 - 4.0 / 1.69, -2 * 0.4 * 0.9 / 1.3], rtol=1e-14)


def test_motor_coupling_gives_torque_and_back_emf() -> None:
    program = derive(
        model(
            parameters={"R": 1.2, "L": 8e-4, "k": 0.05, "J": 0.02},
            coordinates=("q", "theta"),
            inputs=(("u", None),),
            energies=(
                energy("kinetic", "1/2*L*der(q)^2 + 1/2*J*der(theta)^2"),
                energy("dissipation", "1/2*R*der(q)^2"),
                energy("lagrangian", "k*theta*der(q)"),
            ),
            loads=(drive("u", "q"),),
        )
    )
    qdd, _ = accelerations(program, q=[0.0, 0.3], qd=[2.0, 5.0], u=[12.0])
    np.testing.assert_allclose(qdd, [(12.0 - 1.2 * 2.0 - 0.05 * 5.0) / 8e-4, 0.05 * 2.0 / 0.02], rtol=1e-12)


def test_rod_as_body_and_as_point_masses() -> None:
    """A body with its centre off the frame equals the same mass spread by hand: m l^2/3 about the hinge."""
    program = derive(
        model(
            parameters={"m": 3.0, "l": 0.8},
            coordinates=("a",),
            named=(frame("rod", "world", Rotate(2, Variable("a"))),),
            gravity="v(0, -9.81, 0)",
            bodies=(body("rod", "m", ("l/2", 0, 0), (0, "m*l^2/12", "m*l^2/12", 0, 0, 0)),),
        )
    )
    m, f, _, _ = run(program, "dynamics", q=[0.4], qd=[1.0])
    assert m[0, 0] == pytest.approx(3.0 * 0.64 / 3)
    assert f[0] == pytest.approx(-3.0 * G * 0.4 * np.cos(0.4))


def test_time_dependent_mass_term_and_gravity() -> None:
    """d/dt of (1 + t) x'/... : M = 1 + t, f = -x' - (1 + t) is Lagrange with explicit time."""
    program = derive(
        model(coordinates=("x",), energies=(energy("lagrangian", "1/2*(1 + time)*der(x)^2 - (1 + time)*x"),))
    )
    m, f, _, _ = run(program, "dynamics", t=0.5, q=[2.0], qd=[3.0])
    assert m[0, 0] == pytest.approx(1.5)
    assert f[0] == pytest.approx(-3.0 - 1.5)


def test_state_in_the_lagrangian_moves_with_its_own_equation() -> None:
    """M = z with z' = -z + u: f = -z' x'."""
    from mechanics_models import state

    program = derive(
        model(
            coordinates=("x",),
            states=(state("z", "u - z", 2.0),),
            inputs=(("u", None),),
            energies=(energy("kinetic", "1/2*z*der(x)^2"),),
        )
    )
    m, f, _, _ = run(program, "dynamics", qd=[3.0], z=[2.0], u=[5.0])
    assert m[0, 0] == pytest.approx(2.0)
    assert f[0] == pytest.approx(-(5.0 - 2.0) * 3.0)
    (zd,) = run(program, "state_derivative", z=[2.0], u=[5.0])
    assert zd[0] == pytest.approx(3.0)


def test_force_with_reaction_does_no_work_on_a_common_motion() -> None:
    """A spring force between two masses: equal and opposite."""
    program = derive(
        model(
            coordinates=("x", "y"),
            masses=(mass(1.0, "v(x, 0, 0)"), mass(2.0, "v(y, 0, 0)")),
            loads=(force("v(7, 3, 0)", "v(x, 0, 0)", origin="v(y, 0, 0)"),),
        )
    )
    _, f, _, _ = run(program, "dynamics", q=[0.1, 0.2])
    np.testing.assert_allclose(f, [7.0, -7.0])


def test_number_of_a_start_may_depend_on_parameters() -> None:
    program = derive(
        model(
            parameters={"l": 0.5},
            coordinates=(coordinate("x", "2*l", "-l"),),
            masses=(mass(1.0, "v(x, 0, 0)"),),
            inputs=(("u", None),),
        )
    )
    q, qd, z, u = run(program, "start")
    assert (q[0], qd[0], len(z), u[0]) == (1.0, -0.5, 0, 0.0)
