"""Failures of simulations: with time, name, cause, and the rows so far."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from simulate.hand import FourBar, Hand, Pendulum, constraint, coordinate, flat_model, four_bar, length, span

import lagdsl
from lagdsl.language.flat.expression import Binary, Derivative, Norm, Number, PointReference, Variable, Vector
from lagdsl.language.flat.model import EnergyTerm, Point
from lagdsl.language.flat.quantity import Experiment
from lagdsl.motion.simulate.failure import SimulationFailed
from lagdsl.motion.simulate.simulate import simulate


def failure(engine: Hand, **more: Any) -> SimulationFailed:
    with pytest.raises(SimulationFailed) as caught:
        simulate(engine, engine.flat, **more)
    return caught.value


class PrunedDependencies(Hand):
    """The inertia of y is x, which falls to zero at t = 0.5 s."""

    def mass(self, q):  # type: ignore[no-untyped-def]
        return np.diag([1.0, max(q[0], 0.0)])


def test_singular_mass_matrix_names_the_coordinate() -> None:
    engine = PrunedDependencies(flat_model([length("x", 0.5, -1.0), length("y", 1.0, 0.0, line=2)]))
    failed = failure(engine)
    assert failed.diagnostic.code == "E0806" and failed.name == "y"
    assert failed.diagnostic.labels[0].span == engine.flat.coordinates[1].spans[0]
    assert failed.time == pytest.approx(0.5, abs=1e-3)
    assert failed.state["x"] == pytest.approx(0.0, abs=1e-3) and failed.state["der(x)"] == pytest.approx(-1.0)
    assert len(failed.trajectory) == 10 and failed.trajectory.time[-1] == pytest.approx(0.45)
    assert "the mass matrix is singular" in str(failed) and "E0806" in str(failed)


@pytest.mark.parametrize("solver", ["radau"])
def test_singular_mass_matrix_with_an_implicit_method(solver: str) -> None:
    engine = PrunedDependencies(flat_model([length("x", 0.5, -1.0), length("y", 1.0)]))
    assert failure(engine, solver=solver).diagnostic.code in ("E0806", "E0809")


def test_singular_at_the_start_keeps_no_row() -> None:
    failed = failure(PrunedDependencies(flat_model([length("x"), length("y")])))
    assert failed.diagnostic.code == "E0806" and failed.time == 0.0 and len(failed.trajectory) == 0


class Root(Hand):
    """x'' = -sqrt(x): leaves its domain when x turns negative."""

    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return np.array([-np.sqrt(q[0])])


def test_value_that_is_not_a_number_names_the_acceleration() -> None:
    failed = failure(Root(flat_model([length("x", 0.1, -1.0)])))
    assert failed.diagnostic.code == "E0808" and failed.name == "der(der(x))"
    assert "`der(der(x))` is not a number" in str(failed)
    assert 0.09 < failed.time < 0.12


def test_state_that_is_not_a_number() -> None:
    class Log(Hand):
        def zdot(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
            return np.array([-1.0, np.log(z[0])])

    engine = Log(flat_model(states=["a", "b"]))
    engine.start_z = (0.5, 0.0)
    failed = failure(engine)
    assert failed.name == "der(b)" and failed.time == pytest.approx(0.5, abs=1e-6)


def with_norm(expression: Any) -> Any:
    """A model that holds a norm in its potential."""
    point = Point(name="P", position=Vector(Variable("x"), Number(0.0), Number(0.0)), spans=span(1))
    term = EnergyTerm(kind="potential", label="V", value=expression, spans=span(6))
    return replace(flat_model([length("x", 0.1, -1.0)]), named=(point,), energies=(term,))


def test_norm_at_zero_names_the_element() -> None:
    class Attracted(Hand):
        """x'' = x/|x| is nan at 0; the motion starts there."""

        def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
            return np.divide(q, np.abs(q))

    flat = with_norm(Norm(PointReference("P"), "norm(P)"))
    failed = failure(Attracted(flat), start={"x": 0.0})
    assert failed.diagnostic.code == "E0813" and failed.name == "norm(P)"
    assert failed.diagnostic.labels[0].span == flat.energies[0].spans[0]
    # At another place the norm is not to blame.
    root = Root(with_norm(Norm(Vector(Number(1.0), Number(0.0), Number(0.0)), "norm(e)")))
    assert failure(root).diagnostic.code == "E0808"


def test_norm_of_an_acceleration_is_passed_over() -> None:
    acceleration = Derivative(Derivative(PointReference("P")))
    energy = Binary("+", Norm(acceleration, "norm(a)"), Number(1.0))
    assert failure(Root(with_norm(energy))).diagnostic.code == "E0808"


def test_runaway_motion_ends_with_the_coordinate() -> None:
    """x'' = 6 x^2 reaches infinity at t = 1: x = 1/(1 - t)^2."""

    class Runaway(Hand):
        def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
            return 6.0 * q**2

    failed = failure(Runaway(flat_model([length("x", 1.0, 2.0), length("y")])), stop=2.0)
    assert failed.diagnostic.code in ("E0809", "E0808") and "x" in str(failed.name)
    assert failed.time == pytest.approx(1.0, abs=1e-4)


def test_too_many_steps() -> None:
    failed = failure(Pendulum(flat_model([coordinate("a", 1.0)])), stop=1000.0, max_steps=20)
    assert failed.diagnostic.code == "E0812" and "its limit of 20 steps" in str(failed)
    assert len(failed.trajectory) > 0


COILS = (
    "coordinate Real a, b; kinetic 0.5e-3*(der(a)^2 + der(b)^2) + (1 - 1e-10)*1e-3*der(a)*der(b); "
    "dissipation 1/2*der(a)^2 + der(b)^2; force 10*cos(314*time) on a;"
)


@pytest.mark.parametrize(
    ("items", "told"),
    [
        (COILS, True),
        ("coordinate Real a(start = 1); kinetic 1/2*der(a)^2; potential -a^4;", False),
        ("state Real z(start = 1); equation der(z) = z^2;", False),
    ],
)
def test_inertias_that_nearly_cancel_are_told(items: str, told: bool) -> None:
    """Two coils; and what leaves all bounds in finite time."""
    with pytest.raises(SimulationFailed) as failed:
        text = f'model M annotation(units = "none"); {items} end M;'
        lagdsl.compile(text).simulate(stop=0.1 if told else 2.0, solver="radau")
    (diagnostic,) = failed.value.diagnostics
    assert diagnostic.code == "E0809"
    assert (
        any("`a`, `b` cancel in a common motion, but for a part of 1e-10" in note for note in diagnostic.notes) == told
    )


class Walled(FourBar):
    """A four-bar that is pulled open beyond what its links allow: the ground link grows."""

    def phi(self, t, q):  # type: ignore[no-untyped-def]
        phi = super().phi(t, q)
        return phi - np.array([t, 0.0])

    def rate(self, t, q):  # type: ignore[no-untyped-def]
        return np.array([-1.0, 0.0])


@pytest.mark.no_cover
def test_mechanism_pulled_apart() -> None:
    flat = four_bar().flat
    free = replace(flat, coordinates=tuple(replace(c, fixed=False) for c in flat.coordinates))
    failed = failure(Walled(free), stop=5.0, tolerance=1e-4)
    assert failed.diagnostic.code in ("E0811", "E0809")
    assert failed.time < 1.2001  # 0.4 + 1 + 0.8 - 1


def test_constraint_that_breaks_off_is_lost() -> None:
    class Broken(Hand):
        """x = y up to t = 0.5, then nothing holds."""

        def phi(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([q[0] - q[1] + (1.0 if t > 0.5 else 0.0) * (1.0 + q[0] ** 2)]) * (
                1.0 if t <= 0.5 else np.nan
            )

        def rows(self, t, q):  # type: ignore[no-untyped-def]
            return np.array([[1.0, -1.0]]) + 0.0 * np.real(t)

    engine = Broken(flat_model([length("x", 0.5, 1.0), length("y", 0.5, 1.0)], [constraint("tie")]))
    failed = failure(engine)
    assert failed.diagnostic.code == "E0811" and failed.name == "tie"
    assert failed.time == pytest.approx(0.5, abs=1e-6)
    assert len(failed.trajectory) == 10


# ---- what must stay true ---------------------------------------------------------------------------------------------


class Damped(Pendulum):
    def force(self, t, q, qd, z, u):  # type: ignore[no-untyped-def]
        return super().force(t, q, qd, z, u) - 0.01 * qd

    def monitor(self, t, q, qd, z):  # type: ignore[no-untyped-def]
        values, sizes, assertions = super().monitor(t, q, qd, z)
        return values, sizes, assertions * (1.0 if q[0] > -0.5 else 0.0)


def test_violated_invariant_tells_drift_limit_and_power() -> None:
    engine = Damped(flat_model([coordinate("a", 1.0)], invariants=["E"]))
    failed = failure(engine, tolerance=1e-8)
    assert failed.diagnostic.code == "E0807" and failed.name == "E"
    assert "invariant `E` is violated at t = " in str(failed) and " J exceeds " in str(failed)
    assert "W by the loads along `a`" in failed.diagnostic.notes[0]
    (record,) = failed.trajectory.invariants
    assert record.drift > record.limit > 0.0
    assert failed.trajectory.time[-1] == failed.time


def test_invariant_that_drifts_without_power() -> None:
    class Creeping(Hand):
        def monitor(self, t, q, qd, z):  # type: ignore[no-untyped-def]
            return np.array([t]), np.array([1.0]), np.zeros(0)

    failed = failure(Creeping(flat_model([coordinate("a")], invariants=["E"])))
    assert failed.diagnostic.notes == ("no declared load or dissipation has power now",)


def test_invariants_that_hold_are_recorded() -> None:
    engine = Pendulum(flat_model([coordinate("a", 1.0)], invariants=["E"]))
    motion = simulate(engine, engine.flat, tolerance=1e-9)
    (record,) = motion.invariants
    assert record.name == "E" and 0.0 < record.drift < 1e-8
    assert record.limit == pytest.approx(1e-6 * abs(record.start)) and record.start == pytest.approx(motion.energy[0])


def test_tolerance_of_an_invariant_is_its_own() -> None:
    engine = Damped(flat_model([coordinate("a", 1.0)], invariants=["E"], invariant_tolerance=1.0))
    assert simulate(engine, engine.flat, stop=0.2).invariants[0].drift > 0.0


def test_failed_assertion_stops_with_its_message() -> None:
    engine = Damped(flat_model([coordinate("a", 1.0)], assertions=["the arm hits the table"]))
    failed = failure(engine)
    assert failed.diagnostic.code == "E0810" and "the arm hits the table" in str(failed)
    assert failed.state["a"] <= -0.5


def test_rows_inside_a_step_are_held_to_assertions_too() -> None:
    engine = Damped(flat_model([coordinate("a", 1.0)], assertions=["the arm hits the table"]))
    angles = failure(engine, interval=1e-3).trajectory["a"]
    assert angles[-1] <= -0.5 and np.all(angles[:-1] > -0.5)


def test_assertion_false_at_the_start() -> None:
    engine = Damped(flat_model([coordinate("a", -1.0)], assertions=["no"]))
    assert failure(engine).time == 0.0


def test_experiment_of_the_model_is_the_default() -> None:
    experiment = Experiment(start_time=1.0, stop_time=3.0, interval=0.5, tolerance=1e-6)
    engine = Pendulum(flat_model([coordinate("a", 1.0)], experiment=experiment))
    assert simulate(engine, engine.flat).time.tolist() == [1.0, 1.5, 2.0, 2.5, 3.0]
