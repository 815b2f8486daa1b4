"""Terms of the equations of imported robots: dM/dt - 2 C is skew, C qd and gravity are the bias, the regressor times
the inertial parameters are the efforts that the bodies need."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from choice import spread

import lagdsl
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.passes.written_out import written_out
from lagdsl.exchange.robots.plan import Plan, coordinate_of
from robots.imported import ARM, FILES
from robots.peers import plan_of

STEP = 1e-30
STATES = 20
ROBOTS = [
    ("arm.urdf", False),
    ("floater.urdf", False),
    ("floater.urdf", True),
    ("kinds.urdf", False),
    ("slide.urdf", False),
]


def change_of_mass_matrix(model: lagdsl.Model, q: np.ndarray, qd: np.ndarray) -> np.ndarray:
    """dM/dt by a complex step, which has no truncation: the derivative of M is no part of the program."""
    program = written_out(model._compilation.program)
    (block,) = program.function("mass_matrix").results
    zeros = {group: np.zeros((len(q), program.layout.size(group))) for group in (Group.QD, Group.Z, Group.U, Group.W)}
    p = np.tile(np.array(program.layout.defaults, dtype=float), (len(q), 1))
    given = {Group.TIME: np.zeros(len(q)), Group.P: p, Group.Q: q + 1j * STEP * qd, **zeros}
    entries = [np.broadcast_to(np.imag(x), len(q)) for x in evaluate(program.graph, block.elements, given)]
    return np.stack(entries, axis=-1).reshape(len(q), *block.shape) / STEP


def beside_bodies(plan: Plan, coordinates: Sequence[str]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Rotors, springs and their rests, by coordinate: these efforts have no inertial parameters."""
    found = np.zeros((3, len(coordinates)))
    for joint in plan.robot.joints:
        if joint.kind in ("revolute", "prismatic"):
            own = joint.passive
            found[:, coordinates.index(coordinate_of(plan, joint))] = own.armature, own.stiffness, own.rest
    return found[0], found[1], found[2]


def errors_of_terms(model: lagdsl.Model, plan: Plan) -> dict[str, float]:
    """The three identities at random states, of the size of their terms; columns of friction, `damping(q)`, apart."""
    q, qd, qdd = np.random.default_rng(3).normal(size=(3, STATES, len(model.coordinates)))
    coriolis, gravity = np.asarray(model.coriolis_matrix(0.0, q, qd)), np.asarray(model.gravity_forces(0.0, q))
    bias, mass = np.asarray(model.bias_forces(0.0, q, qd)), np.asarray(model.mass_matrix(0.0, q))
    skew = change_of_mass_matrix(model, q, qd) - 2 * coriolis
    terms = np.abs(coriolis) @ np.abs(qd)[..., None]
    rotors, springs, rests = beside_bodies(plan, model.coordinates)
    efforts = (mass @ qdd[..., None])[..., 0] + bias - rotors * qdd - springs * (q - rests)
    bodies = [k for k, name in enumerate(model.inertial_parameter_names) if not name.endswith(")")]
    product = (
        np.asarray(model.regressor(0.0, q, qd, qdd))[..., bodies] @ np.asarray(model.inertial_parameters())[bodies]
    )
    return {
        "skew": float(np.abs(skew + np.swapaxes(skew, -1, -2)).max() / max(np.abs(coriolis).max(), np.abs(mass).max())),
        "bias": float(np.abs((coriolis @ qd[..., None])[..., 0] + gravity - bias).max() / max(terms.max(), 1e-300)),
        "regressor": float(np.abs(product - efforts).max() / np.abs(efforts).max()),
    }


@pytest.mark.parametrize(("name", "floating"), spread(ROBOTS, 3))
def test_terms_of_imported_robots(name: str, floating: bool) -> None:
    text = lagdsl.import_robot(FILES / name, lenient=name != ARM.name, floating=floating)
    plan = plan_of(FILES / name, lenient=True, floating=floating)
    worst = errors_of_terms(lagdsl.compile(text, engine="tape"), plan)
    assert max(worst.values()) < 1e-12, worst


def test_terms_beside_rotors_and_springs() -> None:
    pytest.importorskip("mujoco")
    from robots.mujoco_peer import plan_of_mjcf

    path = FILES / "mobile.xml"
    text = lagdsl.import_robot(path, lenient=True, actuators="none")
    plan = plan_of_mjcf(path, lenient=True)
    model = lagdsl.compile(text, engine="tape")
    rotors, springs, _ = beside_bodies(plan, model.coordinates)
    assert np.any(rotors) and np.any(springs)
    worst = errors_of_terms(model, plan)
    assert max(worst.values()) < 1e-12, worst
