"""Reactions against forces computed by hand with Newton's laws."""

from dataclasses import replace

import numpy as np
import pytest
from derived_programs import derive
from mechanics_models import (
    accelerations,
    body,
    constraint,
    coordinate,
    definition,
    drive,
    energy,
    expression,
    frame,
    mass,
    model,
    output,
    point,
    run,
    torque,
    triple,
)

from lagdsl.language.flat.expression import Variable
from lagdsl.language.flat.model import Move, Rotate

G = 9.81


def rod(**parts):
    """Uniform rod hinged at the origin, angle from the x axis."""
    return model(
        parameters={"m": 3.0, "l": 0.8},
        coordinates=("a",),
        named=(frame("rod", "world", Rotate(2, Variable("a"))),),
        gravity="v(0, -9.81, 0)",
        bodies=(body("rod", "m", ("l/2", 0, 0), (0, 0, "m*l^2/12", 0, 0, 0)),),
        **parts,
    )


HINGE = {
    "Fx": "component(reaction_force(rod), 0)",
    "Fy": "component(reaction_force(rod), 1)",
    "Fz": "component(reaction_force(rod), 2)",
    "Mx": "component(reaction_torque(rod), 0)",
    "My": "component(reaction_torque(rod), 1)",
    "Mz": "component(reaction_torque(rod), 2)",
}


def test_hinge_carries_the_weight_upward_at_rest() -> None:
    y = output(rod(outputs=HINGE), q=[-np.pi / 2])
    np.testing.assert_allclose(y, [0, 3.0 * G, 0, 0, 0, 0], atol=1e-13)


def test_hinge_of_a_moving_rod_obeys_newton() -> None:
    """Force = m a_C - m g; the hinge transmits no torque about its own axis, and in the plane none across it."""
    a, ad = 0.4, 2.5
    flat = rod(outputs=HINGE)
    qdd, _ = accelerations(derive(flat), q=[a], qd=[ad])
    centre = 0.4 * (qdd[0] * np.array([-np.sin(a), np.cos(a)]) - ad**2 * np.array([np.cos(a), np.sin(a)]))
    y = output(flat, q=[a], qd=[ad])
    np.testing.assert_allclose(y, [*(3.0 * (centre + np.array([0, G]))), 0, 0, 0, 0], atol=1e-12)


def test_motor_torque_on_the_coordinate_is_transmitted_by_nothing_else() -> None:
    """`torque tau on a` does no work in the release of the hinge: the reaction torque about z is tau."""
    y = output(rod(outputs=HINGE, loads=(drive(5.0, "a"),)), q=[0.4], qd=[0.0])
    assert y[5] == pytest.approx(5.0)


def test_external_torque_on_the_rod_does_not_pass_the_hinge() -> None:
    y = output(rod(outputs=HINGE, loads=(torque("v(0, 0, 5)", "rod"),)), q=[0.4], qd=[0.0])
    assert y[5] == pytest.approx(0.0, abs=1e-13)


def test_clamped_arm_carries_gyroscopic_torque() -> None:
    """Spinning disc on a shaft turned about the vertical: the bearing gives omega x L and carries the weight."""
    spin, turning, m, arm, axial = 30.0, 2.0, 1.5, 0.6, 0.02
    flat = model(
        parameters={"m": m, "b": arm, "J": axial},
        coordinates=("psi", "phi"),
        named=(
            frame("post", "world", Rotate(2, Variable("psi"))),
            frame("disc", "post", Move(triple(("b", 0, 0))), Rotate(0, Variable("phi"))),
        ),
        gravity="v(0, 0, -9.81)",
        bodies=(body("disc", "m", (0, 0, 0), ("J", "J/2", "J/2", 0, 0, 0)),),
        outputs={
            **{f"F{k}": f"component(reaction_force(disc), {k})" for k in range(3)},
            **{f"M{k}": f"component(reaction_torque(disc), {k})" for k in range(3)},
            **{f"T{k}": f"component(reaction_torque(post), {k})" for k in range(3)},
        },
    )
    y = output(flat, q=[0.0, 0.3], qd=[turning, spin])
    np.testing.assert_allclose(y[:3], [-m * turning**2 * arm, 0, m * G], atol=1e-12)
    gyroscopic = np.array([0, turning * axial * spin, 0])
    np.testing.assert_allclose(y[3:6], gyroscopic, atol=1e-12)
    np.testing.assert_allclose(y[6:], gyroscopic + np.cross([arm, 0, 0], y[:3]), atol=1e-12)


def test_chain_of_frames_carries_everything_behind() -> None:
    """Static two-link arm: the shoulder holds both weights and their moment."""
    flat = model(
        coordinates=("a", "b"),
        named=(
            frame("upper", "world", Rotate(2, Variable("a"))),
            frame("lower", "upper", Move(triple((1.0, 0, 0))), Rotate(2, Variable("b"))),
            point("tip", "lower.origin + 0.5*lower.x"),
        ),
        gravity="v(0, -9.81, 0)",
        masses=(mass(2.0, "lower.origin"), mass(1.0, "p(tip)")),
        loads=(drive(2.0 * G + 1.0 * G * 1.5, "a"), drive(1.0 * G * 0.5, "b")),
        outputs={"Fy": "component(reaction_force(upper), 1)", "Ty": "component(reaction_force(lower), 1)"},
    )
    y = output(flat, q=[0.0, 0.0])
    # The elbow, released, carries the mass placed at its origin as well.
    np.testing.assert_allclose(y, [3.0 * G, 3.0 * G], atol=1e-12)


def test_bead_on_hoop_presses_sideways_and_inward() -> None:
    """Across the hoop's plane 2 m R Omega theta' cos(theta); inward it holds the weight and bends the path."""
    m, r, rate = 0.1, 0.3, 8.0
    flat = model(
        parameters={"m": m, "R": r, "Omega": rate},
        coordinates=("theta",),
        named=(
            definition("turned", "Omega*time"),
            frame("hoop", "world", Rotate(1, Variable("turned"))),
            point("P", "R*(sin(theta)*hoop.x - cos(theta)*hoop.y)"),
        ),
        gravity="v(0, -9.81, 0)",
        masses=(mass("m", "p(P)"),),
        outputs={"out": "along(P, hoop.z)", "inward": "along(P, -p(P)/R)"},
    )
    th, thd = 0.6, 1.1
    y = output(flat, t=0.3, q=[th], qd=[thd])
    assert abs(y[0]) == pytest.approx(2 * m * r * rate * thd * np.cos(th))
    inward = m * (r * thd**2 + G * np.cos(th) + r * rate**2 * np.sin(th) ** 2)
    assert y[1] == pytest.approx(inward)


def test_reaction_next_to_a_constraint_counts_the_multiplier() -> None:
    """Mass held at height 0 by a constraint, standing on a frame that carries it: the constraint takes the weight."""
    flat = model(
        coordinates=("x", "y"),
        named=(point("P", "v(x, y, 0)"),),
        gravity="v(0, -9.81, 0)",
        masses=(mass(2.0, "p(P)"),),
        constraints=(constraint("floor", "component(p(P), 1)"),),
        outputs={"N": "multiplier(floor)", "rest": "along(P, v(0, 1, 0))"},
    )
    y = output(flat, q=[0.0, 0.0])
    assert y[0] == pytest.approx(2.0 * G)
    assert y[1] == pytest.approx(0.0, abs=1e-13)


def test_velocity_constraint_in_a_release() -> None:
    """A knife edge holds its point sideways; the sideways reaction of the released point is left to it entirely."""
    flat = model(
        coordinates=("x", "y", coordinate("a", 0.5)),
        named=(point("P", "v(x, y, 0)"),),
        masses=(mass(2.0, "p(P)"),),
        energies=(energy("kinetic", "0.1*der(a)^2"),),
        constraints=(constraint("edge", "der(p(P)) @ v(-sin(a), cos(a), 0)", level="velocity"),),
        outputs={"side": "along(P, v(-sin(a), cos(a), 0))", "edge": "multiplier(edge)"},
    )
    y = output(flat, q=[0, 0, 0.5], qd=[np.cos(0.5), np.sin(0.5), 2.0])
    assert y[0] == pytest.approx(0.0, abs=1e-13)
    assert y[1] == pytest.approx(2.0 * 1.0 * 2.0)


def test_reaction_in_a_monitor_and_a_definition() -> None:
    flat = rod(outputs={"Fy": "held"}, assertions=("component(reaction_force(rod), 1) < 1000",))
    flat = replace(flat, named=(*flat.named, definition("held", "component(reaction_force(rod), 1)")))
    program = derive(flat)
    assert output(flat, program=program, q=[-np.pi / 2])[0] == pytest.approx(3.0 * G)
    assert run(program, "monitor", q=[0.0], qdd=[0.0])[2][0] == 1.0


def test_one_reaction_asked_for_twice_is_formed_once() -> None:
    """The same expression in two outputs, and a model that shares it through a name."""
    push = expression("along(P, v(0, 1, 0))")
    flat = model(
        coordinates=("x",),
        named=(point("P", "v(x, 0, 0)"), definition("held", push)),
        gravity="v(0, -9.81, 0)",
        masses=(mass(2.0, "p(P)"),),
        outputs={"one": push, "two": "2*held"},
    )
    np.testing.assert_allclose(output(flat), [2.0 * G, 4.0 * G])
