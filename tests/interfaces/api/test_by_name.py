"""Terms of the equations, regressor, frames and points by name."""

from __future__ import annotations

import inspect
import pickle
import pydoc
import re
from functools import cache

import numpy as np
import pytest

import lagdsl

TWO_LINKS = """model Arm "Two links that turn about z, driven at both joints"
  parameter Length l1 = 0.7 m, r1 = 0.3 m, r2 = 0.25 m;
  parameter Mass m1 = 2 kg, m2 = 1.5 kg;
  parameter Inertia I1 = 0.11 kg.m2, I2 = 0.05 kg.m2;
  coordinate Angle a, b;
  frame upper = world.rotz(a);
  frame lower = upper.move({l1, 0, 0}).rotz(b);
  point tool = lower.point({2*r2, 0, 0});
  body first(m = m1, com = {r1, 0, 0}, I = {0, 0, I1}) on upper;
  body second(m = m2, com = {r2, 0, 0}, I = {0, 0, I2}) on lower;
  gravity = -g_n*world.y;
end Arm;
"""
TURNTABLE = """model Bead "On a rod that a motor turns, with its support moved"
  parameter AngularVelocity w = 3 rad/s;
  coordinate Length s;
  frame rod = world.move({0.1 m*sin(2 rad/s*time), 0, 0}).rotz(w*time);
  point bead = rod.point({s, 0, 0});
  mass 2 kg at bead;
end Bead;
"""
ARM = "models/robot_arm.lag"


@cache
def model(source: str, engine: str = "tape") -> lagdsl.Model:
    return lagdsl.compile(source, engine=engine)


def states(count: int, rows: int = 6) -> tuple[np.ndarray, ...]:
    random = np.random.default_rng(5)
    return tuple(random.normal(size=(3, rows, count)))


def times(matrix: np.ndarray, vector: np.ndarray) -> np.ndarray:
    return (matrix @ vector[..., None])[..., 0]


def test_two_links_as_in_the_book() -> None:
    """Murray, Li and Sastry, *A Mathematical Introduction to Robotic Manipulation* (1994), section 4.2.3."""
    arm = model(TWO_LINKS)
    q, qd, _ = states(2)
    alpha = 0.11 + 0.05 + 2 * 0.3**2 + 1.5 * (0.7**2 + 0.25**2)
    beta, delta = 1.5 * 0.7 * 0.25, 0.05 + 1.5 * 0.25**2
    s = np.sin(q[:, 1])
    coriolis = np.empty((6, 2, 2))
    coriolis[:, 0, 0], coriolis[:, 0, 1] = -beta * s * qd[:, 1], -beta * s * (qd[:, 0] + qd[:, 1])
    coriolis[:, 1, 0], coriolis[:, 1, 1] = beta * s * qd[:, 0], 0.0
    np.testing.assert_allclose(arm.coriolis_matrix(0.0, q, qd), coriolis, atol=1e-14)
    mass = arm.mass_matrix(0.0, q)
    np.testing.assert_allclose(mass[:, 0, 0], alpha + 2 * beta * np.cos(q[:, 1]), rtol=1e-14)
    np.testing.assert_allclose(mass[:, 1, 1], delta, rtol=1e-14)
    second = 1.5 * 9.80665 * 0.25 * np.cos(q[:, 0] + q[:, 1])
    first = (2 * 0.3 + 1.5 * 0.7) * 9.80665 * np.cos(q[:, 0]) + second
    np.testing.assert_allclose(arm.gravity_forces(0.0, q), np.stack([first, second], -1), rtol=1e-13)


def test_of_two_links_six_combinations_can_be_told_apart() -> None:
    """Of 20 inertial parameters: those that the pendulum equations of both links contain."""
    arm = model(TWO_LINKS)
    base = arm.base_parameters
    assert base.names == (
        "first.hx + 0.7*second.m",
        "first.hy",
        "first.Izz + 0.49*second.m",
        "second.hx",
        "second.hy",
        "second.Izz",
    )


@pytest.mark.parametrize("source", [TWO_LINKS, ARM, "models/gyroscope_in_gimbals.lag"])
def test_mass_matrix_changes_as_its_coriolis_matrix_says(source: str) -> None:
    """dM/dt = C + C', which is dM/dt - 2 C being skew; dM/dt by central differences of order six."""
    subject = model(source)
    q, qd, _ = states(len(subject.coordinates))
    h = 1e-2
    weights = {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
    change = sum(
        weight * (subject.mass_matrix(0.0, q + k * h * qd) - subject.mass_matrix(0.0, q - k * h * qd)) / h
        for k, weight in weights.items()
    )
    coriolis = subject.coriolis_matrix(0.0, q, qd)
    np.testing.assert_allclose(coriolis + np.swapaxes(coriolis, -1, -2), change, atol=2e-8 * np.abs(change).max())


@pytest.mark.parametrize("source", [TWO_LINKS, "models/gyroscope_in_gimbals.lag", "models/double_pendulum.lag"])
def test_terms_add_up_to_inverse_dynamics(source: str) -> None:
    subject = model(source)
    q, qd, qdd = states(len(subject.coordinates))
    bias = subject.bias_forces(0.0, q, qd)
    np.testing.assert_allclose(
        times(subject.coriolis_matrix(0.0, q, qd), qd) + subject.gravity_forces(0.0, q), bias, atol=1e-12
    )
    tau = times(subject.mass_matrix(0.0, q), qdd) + bias
    np.testing.assert_allclose(subject.inverse_dynamics(0.0, q, qd, qdd), tau, atol=1e-11)


def test_loads_and_damping_are_no_bias() -> None:
    subject = model("""model Damped
      input Force F;
      coordinate Length x;
      mass 2 kg at {x, 0};
      force (-3 N.s/m*der(x) + F)*world.x at {x, 0};
      potential 1/2*(5 N/m)*x^2;
    end Damped;
    """)
    assert subject.bias_forces(0.0, [0.2], [7.0], u=[4.0]) == pytest.approx([1.0])
    assert subject.inverse_dynamics(0.0, [0.2], [7.0], [0.0], u=[4.0]) == pytest.approx([1.0 + 21.0 - 4.0])


def test_moving_frames_add_to_the_bias() -> None:
    """Bead on a turning rod whose support moves: s'' - w^2 s + the support's acceleration along the rod."""
    subject = model(TURNTABLE)
    t, s = 0.4, 0.8
    support = -0.4 * np.sin(2 * t)
    expected = 2 * (support * np.cos(3 * t) - 9 * s)
    assert subject.bias_forces(t, [s], [5.0]) == pytest.approx([expected], rel=1e-13)
    assert subject.coriolis_matrix(t, [s], [5.0]) == pytest.approx(0.0)


@pytest.mark.parametrize("source", [TWO_LINKS, "models/double_pendulum.lag", "models/free_rigid_body.lag"])
def test_regressor_times_parameters_is_inverse_dynamics(source: str) -> None:
    subject = model(source)
    q, qd, qdd = states(len(subject.coordinates))
    pi = subject.inertial_parameters()
    assert pi.shape == (len(subject.inertial_parameter_names),)
    product = times(subject.regressor(0.0, q, qd, qdd), np.broadcast_to(pi, (6, len(pi))))
    np.testing.assert_allclose(product, subject.inverse_dynamics(0.0, q, qd, qdd), atol=1e-12)
    base = subject.base_parameters
    chosen = subject.regressor(0.0, q, qd, qdd)[..., list(base.columns)]
    np.testing.assert_allclose(chosen @ (base.combination @ pi), product, atol=1e-10)


def test_springs_loads_and_rotors_are_beside_the_regressor() -> None:
    """Joint by joint k (q - rest) + c tanh(qd/creep) + J qdd - u, whatever the bodies do."""
    beside = """
      input Torque u;
      potential 1/2*(3 N.m)*(a - 20 deg)^2;
      torque -(0.4 N.m)*tanh(der(b)/(0.1 rad/s)) on b;
      kinetic 1/2*(0.05 kg.m2)*der(b)^2;
      torque u on b;
    """
    subject = model(TWO_LINKS.replace("end Arm;", beside + "end Arm;"))
    q, qd, qdd = states(2)
    pi = subject.inertial_parameters()
    assert subject.inertial_parameter_names == model(TWO_LINKS).inertial_parameter_names
    rest = subject.inverse_dynamics(0.0, q, qd, qdd, u=np.full((len(q), 1), 1.5))
    rest = rest - times(subject.regressor(0.0, q, qd, qdd), np.broadcast_to(pi, (len(q), len(pi))))
    expected = [3 * (q[:, 0] - np.radians(20)), 0.4 * np.tanh(10 * qd[:, 1]) + 0.05 * qdd[:, 1] - 1.5]
    np.testing.assert_allclose(rest, np.transpose(expected), atol=1e-12)


def test_puma_has_36_base_parameters() -> None:
    """Gautier and Khalil, *IEEE Trans. Robotics and Automation* 6(3), 1990: a PUMA 560 has 36, drives apart."""
    assert len(model(ARM).base_parameters.columns) == 36


@pytest.mark.parametrize(("source", "name"), [(TWO_LINKS, "lower"), (ARM, "axis[6].frame_b"), (TURNTABLE, "rod")])
def test_frames_move_as_their_poses_change(source: str, name: str) -> None:
    subject = model(source)
    q, qd, _ = (rows[0] for rows in states(len(subject.coordinates)))
    frame, t, h = subject.frame(name), 0.3, 1e-3

    def pose(step: float) -> tuple[np.ndarray, np.ndarray]:
        return frame.position(t + step, q + step * qd), frame.rotation(t + step, q + step * qd)

    around = {k: pose(k * h) for k in (-3, -2, -1, 0, 1, 2, 3)}
    weights = {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
    rates = [sum(w * (around[k][i] - around[-k][i]) / h for k, w in weights.items()) for i in (0, 1)]
    turning = rates[1] @ around[0][1].T
    omega = np.array([turning[2, 1], turning[0, 2], turning[1, 0]])
    velocity = frame.velocity(t, q, qd)
    np.testing.assert_allclose(velocity, np.concatenate([rates[0], omega]), atol=1e-9)
    at_rest = frame.velocity(t, q, np.zeros_like(qd))
    np.testing.assert_allclose(velocity - at_rest, frame.jacobian(t, q) @ qd, atol=1e-13)
    later, before = (frame.velocity(t + s, q + s * qd, qd) for s in (h, -h))
    np.testing.assert_allclose(frame.bias_acceleration(t, q, qd), (later - before) / (2 * h), atol=1e-4)


def test_points_by_name() -> None:
    arm = model(TWO_LINKS)
    q, qd, _ = states(2)
    tool = arm.point("tool")
    a, b = q[:, 0], q.sum(axis=-1)
    expected = np.stack([0.7 * np.cos(a) + 0.5 * np.cos(b), 0.7 * np.sin(a) + 0.5 * np.sin(b), 0 * a], -1)
    np.testing.assert_allclose(tool.position(0.0, q), expected, atol=1e-14)
    assert tool.jacobian(0.0, q).shape == (6, 3, 2)
    np.testing.assert_allclose(tool.velocity(0.0, q, qd), times(tool.jacobian(0.0, q), qd), atol=1e-14)
    assert (arm.frames, arm.points) == (["upper", "lower"], ["tool"])


@pytest.mark.parametrize("engine", ["c", "numpy"])
def test_every_engine_gives_the_same(engine: str) -> None:
    reference, other = model(TWO_LINKS), model(TWO_LINKS, engine)
    q, qd, qdd = states(2)
    for name, arguments in {"coriolis_matrix": (q, qd), "bias_forces": (q, qd), "regressor": (q, qd, qdd)}.items():
        np.testing.assert_allclose(
            getattr(other, name)(0.0, *arguments), getattr(reference, name)(0.0, *arguments), rtol=1e-13, atol=1e-14
        )
    np.testing.assert_allclose(
        other.frame("lower").jacobian(0.0, q), reference.frame("lower").jacobian(0.0, q), atol=1e-14
    )


def test_names_that_are_not_there() -> None:
    with pytest.raises(lagdsl.UnknownName, match="did you mean `lower`"):
        model(TWO_LINKS).frame("lover")
    with pytest.raises(lagdsl.UnknownName, match="there are tool"):
        model(TWO_LINKS).point("nowhere at all")


def test_the_time_cannot_be_left_out() -> None:
    q, qd, _ = (rows[0] for rows in states(2))
    with pytest.raises(ValueError, match="the time is the first argument"):
        model(TWO_LINKS).forward_dynamics(q, qd, qd)
    with pytest.raises(ValueError, match="the arguments are t, q, qd"):
        model(TWO_LINKS).forward_dynamics(0.0, q[:1], qd)


def test_no_coriolis_matrix_where_the_mass_depends_on_the_rates() -> None:
    with pytest.raises(lagdsl.CompilationFailed, match="E0856"):
        model("models/relativistic_particle.lag").coriolis_matrix(0.0, [0.0, 0.0], [1.0, 0.0])


def test_a_model_travels_to_another_process() -> None:
    original = model(TWO_LINKS)
    copy = pickle.loads(pickle.dumps(original))
    q, qd, _ = states(2)
    assert np.array_equal(copy.forward_dynamics(0.0, q, qd), original.forward_dynamics(0.0, q, qd))
    assert (copy.name, copy.coordinates) == (original.name, original.coordinates)


def test_frames_and_motions_travel_to_another_process() -> None:
    """A motion keeps its rows; what draws it with more of them stays behind."""
    original, (q, qd, _) = model(TWO_LINKS), states(2)
    for part in (original.frame("lower"), original.point("tool")):
        assert np.array_equal(pickle.loads(pickle.dumps(part)).jacobian(0.0, q, qd), part.jacobian(0.0, q, qd))
    motion = original.simulate(stop=0.1, interval=0.05)
    copy = pickle.loads(pickle.dumps(motion))
    assert len(copy) == len(copy.drawn()) == 3 and motion.finer is not None
    assert all(np.array_equal(copy[name], motion[name]) for name in motion.names)


def test_a_failure_travels_with_its_motion() -> None:
    """x'' = x^3 is at infinity after 1.9 s."""
    subject = model("""model Away
      coordinate Length x(start = 1 m, fixed = true);
      mass 1 kg at {x, 0};
      force 1 N/m3*x^3 on x;
    end Away;
    """)
    with pytest.raises(lagdsl.SimulationFailed) as caught:
        subject.simulate(stop=10)
    copy = pickle.loads(pickle.dumps(caught.value))
    assert (str(copy), copy.time) == (str(caught.value), caught.value.time)
    assert repr(copy.state) == repr(caught.value.state)
    assert np.array_equal(copy.trajectory["x"], caught.value.trajectory["x"])


def test_completion_offers_what_users_call() -> None:
    assert [name for name in dir(lagdsl) if not name.startswith("_")] == sorted(lagdsl.__all__)


def test_help_shows_signatures_as_they_are_written() -> None:
    """Types are words, not the unions of private classes that they stand for."""
    subject = model(TWO_LINKS)
    for owner in (subject, subject.point("tool"), subject.frame("lower"), lagdsl.Trajectory, lagdsl):
        called = [getattr(owner, name) for name in dir(owner) if not name.startswith("_")]
        shown = [str(inspect.signature(each)) for each in called if inspect.isroutine(each)]
        assert shown
        assert [text for text in shown if "._" in text or "typing." in text] == []
    help_text = re.sub(r"[\s']", "", pydoc.plaintext.document(subject.mass_matrix))  # Python 3.14 breaks long lines
    assert help_text.startswith("mass_matrix(t:ArrayLike|None=None,q:Entries|None=None")
